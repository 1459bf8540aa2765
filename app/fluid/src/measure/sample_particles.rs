//! A few of the particles, for whoever wants points but not all of them. (Shader:
//! `measure/sample_particles.compute`.)

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{Buffer, SampleParams, SampleParticles};

use crate::step::Recorded;

/// Every `stride`-th particle.
pub struct Sample {
    /// Picks them; to be run after a frame's steps.
    pub recording: Recording,
    /// Position relative to the domain's lowest corner, m, and speed, m/s, of the particle whose id is
    /// the index times `stride`; no numbers of one that is quarantined.
    pub samples: Buffer<[f32; 4]>,
    /// From one sampled id to the next.
    pub stride: u32,
}

/// Records a sample beside a scene's other recordings: of all particles every second, third or so by
/// id, as many as make `most_points` or fewer (at least one is taken), so that a point stays the same
/// particle from frame to frame. Only a plan that wants `samples` has it.
pub fn record_sample(resources: &mut Resources, recorded: &Recorded, most_points: u32) -> Sample {
    let capacity = recorded.slots.capacity;
    let stride = capacity.div_ceil(most_points.max(1)).max(1);
    let mut samples = resources.buffer("samples", capacity.div_ceil(stride));
    let mut params = resources.buffer("sample_params", 1);
    let mut recording = resources.recording("sample");
    recording.upload(&mut params, &[SampleParams { stride, capacity, ..SampleParams::default() }]);
    // Without particles nothing else writes it.
    recording.clear(&mut samples);
    recording.dispatch(
        &SampleParticles {
            positions: recorded.positions.read(),
            velocities: recorded.velocities.read(),
            samples: samples.write(),
            sample_params: params.uniform(),
        },
        capacity,
    );
    Sample { recording, samples, stride }
}
