//! The ears for Vulkan's validation layers, given something to hear.

use brooklet_gpu::{Engine, Plan, Resources};
use brooklet_kernels::{BindingError, Bound, Kernel, Module, ReduceGroups, Spirv};
use brooklet_tests::{gpu, validation};
use std::{
    env,
    process::{Command, Output},
};

/// A prefix sum that says it needs 64-bit integers, which no device is opened with. Drivers do
/// not care; the layers do.
struct Undeclared<'a>(ReduceGroups<'a>);

impl Kernel for Undeclared<'_> {
    const STAGE: &'static str = "undeclared";
    const GROUP_SIZE: [u32; 3] = ReduceGroups::GROUP_SIZE;

    fn module(&self) -> &'static Module {
        const HEADER_BYTES: usize = 20;
        const OP_CAPABILITY_INT64: [u32; 2] = [2 << 16 | 17, 11];
        let module = self.0.module();
        let words = module.spirv.bytes();
        let (header, rest) = words.split_at(HEADER_BYTES);
        let spirv = [header, bytemuck::cast_slice(&OP_CAPABILITY_INT64), rest].concat().leak();
        Box::leak(Box::new(Module { name: "Undeclared", spirv: Spirv::Plain(spirv), ..*module }))
    }

    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        self.0.bindings()
    }
}

/// Builds a kernel, with the mistake or without.
fn build(mistaken: bool) {
    let mut resources = Resources::new();
    let values = resources.persistent::<u32>("values", 4);
    let mut sums = resources.persistent::<u32>("group_sums", 1);
    let mut recording = resources.recording("sum");
    let kernel = ReduceGroups { values: values.read(), group_sums: sums.write() };
    if mistaken {
        recording.dispatch(&Undeclared(kernel), 1);
    } else {
        recording.dispatch(&kernel, 1);
    }
    let sum_id = recording.id();
    let plan = Plan::sweep(resources, vec![recording], &[]).unwrap();
    Engine::new(&gpu(), plan).unwrap().run(&[sum_id], &[]).unwrap();
}

/// This test in a process of its own, which builds a kernel with validation on.
fn child(mistake: &str) -> Output {
    let this = env::current_exe().expect("the test's own file");
    let mut command = Command::new(this);
    command.args(["--exact", "validation::what_the_layers_say_ends_the_run", "--nocapture"]);
    command.env("BROOKLET_VALIDATION", "1").env("BROOKLET_MISTAKE", mistake);
    command.output().expect("the test starts itself")
}

#[test]
fn what_the_layers_say_ends_the_run() {
    if let Ok(mistake) = env::var("BROOKLET_MISTAKE") {
        return build(mistake == "1");
    }
    let right = child("0");
    let said = String::from_utf8_lossy(&right.stderr);
    if said.contains(validation::NOT_INSTALLED) {
        assert!(!validation::is_asked_for(), "BROOKLET_VALIDATION=1, and the layers are not installed");
        println!("skipped: Vulkan's validation layers are not installed here (tools/setup --tests)");
        return;
    }
    assert!(right.status.success(), "{said}");
    let wrong = child("1");
    let said = String::from_utf8_lossy(&wrong.stderr);
    assert!(!wrong.status.success(), "the mistake went unheard: {said}");
    assert!(said.contains(validation::ENDED) && said.contains("VUID-"), "{said}");
}
