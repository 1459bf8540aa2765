//! Runs single kernels on the GPU: inputs in, one recording, outputs back.

use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, ensure};
use brooklet_fluid::grid::Scan;
use brooklet_gpu::{Engine, Plan, Recording, ResourceId, Resources};
use brooklet_kernels::{Buffer, Kernel};
use bytemuck::Pod;
use rand_chacha::ChaCha8Rng;

/// Generators of a few random inputs (a CPU driver takes tens of milliseconds for each), the same every time.
pub(crate) fn few_cases(device: &Device) -> impl Iterator<Item = ChaCha8Rng> {
    (0..if device.small() { 4 } else { 12 }).map(|seed| rng(700 + seed))
}

/// A recording in the making, with its inputs.
pub struct Bench<'d> {
    device: &'d Device,
    resources: Resources,
    recording: Recording,
    wanted: Vec<ResourceId>,
}

impl<'d> Bench<'d> {
    /// Nothing yet.
    pub fn new(device: &'d Device) -> Self {
        let mut resources = Resources::new();
        let recording = resources.recording("bench");
        Self { device, resources, recording, wanted: Vec::new() }
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

    /// Records what comes once, first, as well: the bench has one recording, and that is put before the rest.
    pub fn record_with_init<T>(
        &mut self,
        record: impl FnOnce(&mut Resources, &mut Recording, &mut Recording) -> T,
    ) -> T {
        let mut init = self.resources.recording("unused");
        let recorded = record(&mut self.resources, &mut init, &mut self.recording);
        let rest = std::mem::replace(&mut self.recording, init);
        self.recording.append(&rest);
        recorded
    }

    /// Keeps a buffer that the recording makes and nobody else reads.
    pub fn want<T>(&mut self, buffer: &Buffer<T>) {
        self.wanted.push(buffer.id);
    }

    /// Runs everything, once. Ends the case if the recording or the device fails.
    pub fn run(self) -> Done {
        let recording = self.recording.id();
        let plan = Plan::sweep(self.resources, vec![self.recording], &self.wanted).or_raise();
        let mut engine = self.device.engine(plan);
        engine.run(&[recording], &[]).or_raise();
        Done { engine }
    }
}

/// A recording that ran.
pub struct Done {
    engine: Engine,
}

impl Done {
    /// The first `len` elements of a buffer. Ends the case if the device fails, or the buffer is shorter.
    pub fn read<T: Pod>(&mut self, buffer: &Buffer<T>, len: usize) -> Vec<T> {
        let mut values = self.engine.read(buffer).or_raise();
        ensure!(values.len() >= len, "{} elements, not {len}", values.len());
        values.truncate(len);
        values
    }
}

/// All levels of a prefix sum, as the fluid records them.
pub(crate) fn run_scan(device: &Device, values: &[u32]) -> Vec<u32> {
    let mut bench = Bench::new(device);
    let input = bench.input("values", values);
    let mut scanned = bench.output("scanned", values.len());
    let (resources, recording) = bench.parts();
    if !values.is_empty() {
        Scan::declare(resources, "test", values.len() as u32).record(recording, &input, &mut scanned);
    }
    bench.run().read(&scanned, values.len())
}
