//! Runs single kernels on the GPU: inputs in, one recording, outputs back.
//!
//! `BROOKLET_SMALL=1` leaves out the sizes that take minutes on a driver that interprets its shaders.

use crate::gpu;
use brooklet_gpu::{Engine, Plan, Recording, ResourceId, Resources};
use brooklet_kernels::{Buffer, Kernel};
use bytemuck::Pod;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

/// Whether sizes are to be kept small.
pub fn small() -> bool {
    std::env::var_os("BROOKLET_SMALL").is_some_and(|value| value != "0" && !value.is_empty())
}

/// A runner of few cases (a CPU driver takes tens of milliseconds for each), the same every time.
pub fn few_cases() -> TestRunner {
    let cases = if small() { 4 } else { 12 };
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    TestRunner::new_with_rng(config, TestRng::from_seed(RngAlgorithm::ChaCha, &[7; 32]))
}

/// A recording in the making, with its inputs.
pub struct Bench {
    resources: Resources,
    recording: Recording,
    wanted: Vec<ResourceId>,
}

impl Default for Bench {
    fn default() -> Self {
        Self::new()
    }
}

impl Bench {
    /// Nothing yet.
    pub fn new() -> Self {
        let mut resources = Resources::new();
        let recording = resources.recording("bench");
        Self { resources, recording, wanted: Vec::new() }
    }

    /// A buffer that holds `data`. None is shorter than one element: a binding of no bytes does
    /// not exist.
    pub fn input<T: Pod>(&mut self, label: &str, data: &[T]) -> Buffer<T> {
        let mut buffer = self.output(label, data.len());
        self.recording.upload(&mut buffer, data);
        buffer
    }

    /// A buffer of `len` zeros.
    pub fn output<T>(&mut self, label: &str, len: usize) -> Buffer<T> {
        let mut buffer = self.resources.persistent(label, len.max(1) as u32);
        // Without a command that touches it the plan would leave it out: no items, no dispatch.
        self.recording.clear(&mut buffer);
        buffer
    }

    /// A uniform buffer.
    pub fn uniform<T: Pod>(&mut self, label: &str, value: T) -> Buffer<T> {
        self.input(label, &[value])
    }

    /// Runs `kernel` with a thread an item.
    pub fn dispatch<K: Kernel>(&mut self, kernel: &K, items: usize) {
        self.recording.dispatch(kernel, items as u32);
    }

    /// The parts, for what declares and records itself.
    pub fn parts(&mut self) -> (&mut Resources, &mut Recording) {
        (&mut self.resources, &mut self.recording)
    }

    /// Keeps a buffer that the recording makes and nobody else reads.
    pub fn want<T>(&mut self, buffer: &Buffer<T>) {
        self.wanted.push(buffer.id);
    }

    /// Runs everything, once.
    ///
    /// # Panics
    /// If the recording or the device fails.
    pub fn run(self) -> Done {
        let recording = self.recording.id();
        let plan = Plan::sweep(self.resources, vec![self.recording], &self.wanted)
            .unwrap_or_else(|error| panic!("plan: {error}"));
        let mut engine = Engine::new(&gpu(), plan).unwrap_or_else(|error| panic!("engine: {error}"));
        engine.run(&[recording], &[]).unwrap_or_else(|error| panic!("run: {error}"));
        Done { engine }
    }
}

/// A recording that ran.
pub struct Done {
    engine: Engine,
}

impl Done {
    /// The first `len` elements of a buffer.
    ///
    /// # Panics
    /// If the device fails, or the buffer is shorter.
    pub fn read<T: Pod>(&mut self, buffer: &Buffer<T>, len: usize) -> Vec<T> {
        let mut values = self.engine.read(buffer).unwrap_or_else(|error| panic!("read: {error}"));
        assert!(values.len() >= len, "{} elements, not {len}", values.len());
        values.truncate(len);
        values
    }
}
