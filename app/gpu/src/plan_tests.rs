//! The sweep, with kernels that only exist as data.

use super::*;
use crate::draw::{DrawState, Load, Targets};
use crate::plan_left_out::LeftOutKind;
use brooklet_kernels::{
    Access, BindingError, BindingInfo, Buf, BufMut, Buffer, Draw, Format, Kernel, StageKind, Tier, Uniform,
};

const fn storage(name: &'static str, slot: u32, access: Access) -> BindingInfo {
    BindingInfo { name, slot, kind: BindingKind::Storage { access, stride_bytes: 4 } }
}

const fn module(name: &'static str, stage: StageKind, bindings: &'static [BindingInfo]) -> Module {
    Module {
        name,
        entry: "main",
        stage,
        spirv: brooklet_kernels::Spirv::Plain(&[]),
        bindings,
        group_size: [64, 1, 1],
        shared_bytes: 0,
        tier: Tier::Floor,
        source: "",
        hash: "",
    }
}

const READ: BindingInfo = storage("source", 0, Access::Read);
const WRITE: BindingInfo = storage("target", 1, Access::ReadWrite);

fn bound(info: BindingInfo, id: ResourceId) -> Bound {
    Bound { info, resource: Some(id) }
}

/// A kernel that reads one buffer and changes another.
macro_rules! map_kernel {
    ($kernel:ident, $stage:literal) => {
        struct $kernel<'a> {
            source: Buf<'a, u32>,
            target: BufMut<'a, u32>,
        }
        impl Kernel for $kernel<'_> {
            const STAGE: &'static str = $stage;
            const GROUP_SIZE: [u32; 3] = [64, 1, 1];
            fn module(&self) -> &'static Module {
                static MODULE: Module = module($stage, StageKind::Compute, &[READ, WRITE]);
                &MODULE
            }
            fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
                Ok(vec![bound(READ, self.source.id), bound(WRITE, self.target.id)])
            }
        }
    };
}

map_kernel!(Density, "density");
map_kernel!(Correct, "correct");
map_kernel!(Curl, "curl");

/// A kernel whose variant needs a buffer and a uniform block.
struct Walls<'a> {
    walls: Option<Buf<'a, u32>>,
    params: Uniform<'a, u32>,
}

impl Kernel for Walls<'_> {
    const STAGE: &'static str = "walls";
    const GROUP_SIZE: [u32; 3] = [4, 4, 1];
    fn module(&self) -> &'static Module {
        static MODULE: Module = module("Walls+ON", StageKind::Compute, &[]);
        &MODULE
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        let walls = self.walls.ok_or(BindingError { module: "Walls+ON", field: "walls" })?;
        Ok(vec![
            bound(storage("walls", 0, Access::ReadWrite), walls.id),
            bound(BindingInfo { name: "params", slot: 1, kind: BindingKind::Uniform { bytes: 16 } }, self.params.id),
        ])
    }
}

struct DrawDots<'a> {
    dots: Buf<'a, u32>,
}

impl Draw for DrawDots<'_> {
    const STAGE: &'static str = "draw_dots";
    fn vertex(&self) -> &'static Module {
        static MODULE: Module = module("DotsVertex", StageKind::Vertex, &[READ]);
        &MODULE
    }
    fn fragment(&self) -> Option<&'static Module> {
        None
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        Ok(vec![bound(READ, self.dots.id)])
    }
}

/// A step: clear counts, density from positions to counts, correct positions by counts, and a
/// curl that nobody else reads.
struct Step {
    resources: Resources,
    positions: Buffer<u32>,
    counts: Buffer<u32>,
    curl: Buffer<u32>,
    recording: Recording,
}

fn step() -> Step {
    let mut resources = Resources::new();
    let mut positions = resources.persistent("positions", 1000);
    let mut counts = resources.buffer("counts", 10);
    let mut curl = resources.buffer("curl", 1000);
    let mut recording = resources.recording("step");
    recording.clear(&mut counts);
    recording.dispatch(&Density { source: positions.read(), target: counts.write() }, 1000);
    recording.clear(&mut curl);
    recording.dispatch(&Curl { source: positions.read(), target: curl.write() }, 1000);
    recording.dispatch(&Correct { source: counts.read(), target: positions.write() }, 1000);
    Step { resources, positions, counts, curl, recording }
}

fn names(plan: &Plan, recording: &str) -> Vec<String> {
    let id = plan.recordings().find(|id| id.label() == recording).expect("the plan has it");
    let commands = plan.commands(id).iter();
    commands.map(|c| describe(plan.resources(), c)).collect()
}

#[test]
fn what_feeds_state_stays_and_the_rest_is_named() {
    let step = step();
    let plan = Plan::sweep(step.resources, vec![step.recording], &[]).expect("a plan");
    assert_eq!(names(&plan, "step"), ["clear counts", "density", "correct"]);
    assert!(plan.uses(step.positions.id) && plan.uses(step.counts.id));
    assert!(!plan.uses(step.curl.id));
    assert_eq!(plan.bytes(), 4 * 1010);
    let left_out: Vec<_> = plan
        .left_out()
        .iter()
        .map(|entry| (entry.kind, entry.name.as_str(), entry.bytes, entry.reason.as_str()))
        .collect();
    assert_eq!(
        left_out,
        [
            (LeftOutKind::Stage, "curl", 0, "nothing wanted reads curl"),
            (LeftOutKind::Command, "clear curl", 0, "nothing wanted reads curl"),
            (LeftOutKind::Buffer, "curl", 4000, "only left out: clear curl, curl"),
        ]
    );
    // A check that expects something else must fail.
    assert_ne!(names(&plan, "step"), ["clear counts", "density", "curl", "correct"]);
}

#[test]
fn wanting_it_brings_it_back() {
    let step = step();
    let plan = Plan::sweep(step.resources, vec![step.recording], &[step.curl.id]).expect("a plan");
    assert_eq!(names(&plan, "step"), ["clear counts", "density", "clear curl", "curl", "correct"]);
    assert!(plan.left_out().is_empty());
    let passes: Vec<_> = plan.passes().iter().map(|p| (p.stage, p.count)).collect();
    assert_eq!(passes, [("density", 1), ("curl", 1), ("correct", 1)]);
}

#[test]
fn a_full_overwrite_ends_the_want_and_a_partial_one_does_not() {
    let run = |data: &[u32]| {
        let mut resources = Resources::new();
        let source = resources.persistent("source", 4);
        let mut target = resources.buffer("target", 4);
        let mut recording = resources.recording("run");
        recording.dispatch(&Density { source: source.read(), target: target.write() }, 4);
        recording.upload(&mut target, data);
        let plan = Plan::sweep(resources, vec![recording], &[target.id]).expect("a plan");
        names(&plan, "run")
    };
    assert_eq!(run(&[1, 2, 3, 4]), ["upload target"]);
    assert_eq!(run(&[1, 2]), ["density", "upload target"]);
}

#[test]
fn a_copy_moves_the_want_to_its_source() {
    let mut resources = Resources::new();
    let state = resources.persistent("state", 4);
    let mut first = resources.buffer("first", 4);
    let mut second = resources.buffer("second", 4);
    let mut recording = resources.recording("run");
    recording.dispatch(&Density { source: state.read(), target: first.write() }, 4);
    recording.clear(&mut second);
    recording.copy(&first, &mut second);
    let plan = Plan::sweep(resources, vec![recording], &[second.id]).expect("a plan");
    assert_eq!(names(&plan, "run"), ["density", "copy first to second"]);
}

#[test]
fn an_empty_recording_still_has_its_name() {
    let mut resources = Resources::new();
    let mut unwanted = resources.buffer::<u32>("unwanted", 4);
    let unused = resources.texture("unused", Format::Rgba8Unorm, [2, 2]);
    let mut recording = resources.recording("measure");
    recording.clear(&mut unwanted);
    let plan = Plan::sweep(resources, vec![recording], &[]).expect("a plan");
    assert_eq!(plan.recordings().map(RecordingId::label).collect::<Vec<_>>(), ["measure"]);
    assert!(names(&plan, "measure").is_empty());
    assert!(!plan.uses(unused.id));
    let last = plan.left_out().last().expect("the texture");
    assert_eq!(last.kind, LeftOutKind::Texture);
    assert_eq!((last.bytes, last.reason.as_str()), (16, "nothing recorded uses it"));
}

#[test]
fn iterations_are_counted_and_kept_together() {
    let mut resources = Resources::new();
    let mut positions = resources.persistent("positions", 100_000_000);
    let mut counts = resources.buffer("counts", 1);
    let mut recording = resources.recording("step");
    for _ in 0..3 {
        recording.dispatch(&Density { source: positions.read(), target: counts.write() }, 100_000_000);
        recording.dispatch(&Correct { source: counts.read(), target: positions.write() }, 0);
    }
    assert_eq!(recording.commands().len(), 3, "no items, no dispatch");
    let Command::Dispatch(dispatch) = &recording.commands()[0] else {
        panic!("a dispatch");
    };
    assert_eq!(dispatch.groups, crate::recording::Groups::Fixed([32_768, 48, 1]), "1562500 groups in rows");
    let plan = Plan::sweep(resources, vec![recording], &[counts.id]).expect("a plan");
    assert_eq!(plan.passes()[0].count, 3);
}

#[test]
fn draws_pull_in_what_they_read_and_clear_ends_the_want() {
    let mut resources = Resources::new();
    let mut dots = resources.buffer("dots", 4);
    let source = resources.persistent("source", 4);
    let picture = resources.texture("picture", Format::Rgba8Unorm, [2, 2]);
    let mut recording = resources.recording("frame");
    let cleared = |picture| Targets { color: vec![(picture, Load::Clear([0.0; 4]))], depth: None };
    let mut lost = resources.buffer("lost", 4);
    recording.clear(&mut lost);
    recording.draw(&DrawDots { dots: lost.read() }, &cleared(&picture), DrawState::default(), 3, 1);
    recording.dispatch(&Density { source: source.read(), target: dots.write() }, 4);
    recording.draw(&DrawDots { dots: dots.read() }, &cleared(&picture), DrawState::default(), 3, 1);
    let plan = Plan::sweep(resources, vec![recording], &[picture.id]).expect("a plan");
    assert_eq!(names(&plan, "frame"), ["density", "draw_dots"]);
    assert!(!plan.uses(lost.id));
}

fn refused(resources: Resources, recordings: Vec<Recording>, wanted: &[ResourceId]) -> String {
    Plan::sweep(resources, recordings, wanted).map(|_| ()).expect_err("it is refused").to_string()
}

#[test]
fn reading_a_transient_before_writing_it_is_refused() {
    let mut resources = Resources::new();
    let table = resources.buffer("table", 4);
    let mut state = resources.persistent("state", 4);
    let mut init = resources.recording("init");
    let mut filled = Buffer::<u32>::new(table.id, 4);
    init.upload(&mut filled, &[1, 2, 3, 4]);
    let mut step = resources.recording("step");
    step.dispatch(&Density { source: table.read(), target: state.write() }, 4);
    let text = refused(resources, vec![init, step], &[]);
    assert!(text.starts_with("recording step: density reads table"), "{text}");
    assert!(text.contains("Resources::state"), "{text}");
}

#[test]
fn mistakes_of_the_recorder_are_refused_by_name() {
    let mut resources = Resources::new();
    let mut four = resources.persistent::<u32>("four", 4);
    let eight = resources.persistent::<u32>("eight", 8);
    let small = resources.persistent::<u32>("small", 1);

    let mut long = resources.recording("long");
    long.upload(&mut four, &[0; 5]);
    assert_eq!(
        refused(resources.clone(), vec![long], &[]),
        "recording long: upload of 5 elements does not fit a buffer of 4"
    );
    let mut copy = resources.recording("copy");
    copy.copy(&eight, &mut four);
    assert!(refused(resources.clone(), vec![copy], &[]).contains("copy of 8 elements"));

    let mut missing = resources.recording("missing");
    missing.dispatch(&Walls { walls: None, params: small.uniform() }, 1);
    assert_eq!(
        refused(resources.clone(), vec![missing], &[]),
        "recording missing: kernel Walls+ON needs walls, which was not given"
    );
    let mut uniform = resources.recording("uniform");
    uniform.dispatch(&Walls { walls: Some(four.read()), params: small.uniform() }, 1);
    let text = refused(resources.clone(), vec![uniform], &[]);
    assert!(text.contains("walls binds small to params: it has 4 bytes, 16 are needed"), "{text}");

    let mut both = resources.recording("both");
    let alias = four.alias();
    both.dispatch(&Density { source: alias.read(), target: four.write() }, 4);
    let text = refused(resources.clone(), vec![both], &[]);
    assert!(text.contains("density both reads and writes four at once"), "{text}");

    let twice = vec![resources.recording("step"), resources.recording("step")];
    assert!(refused(resources.clone(), twice, &[]).contains("two recordings are called step"));
    let text = refused(resources, Vec::new(), &[ResourceId(77)]);
    assert!(text.contains("resource 77") && text.contains("another table"), "{text}");
}
