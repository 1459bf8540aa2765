//! Drains, and ends of lifetimes. (Shaders: `emitters/drain_particles.compute`, `emitters/limit_drain.compute`.)

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{
    Buffer, Counters, Drain, DrainParams, DrainParticles, DrainState, MarkDrained, SettleDrain, TakeDrained,
};

use crate::grid::Scan;
use crate::particles::buffers::Particles;
use crate::scene::{Method, Scene, drains};
use crate::slots::Slots;

/// What takes particles out of a scene.
pub struct Drains {
    all: Option<Unlimited>,
    limited: Option<Limited>,
}

/// Those that take all that enters, and ends of lifetimes.
struct Unlimited {
    drains: Buffer<Drain>,
    params: Buffer<DrainParams>,
}

/// Those that take so many particles a second at most.
struct Limited {
    drains: Vec<(Buffer<Drain>, Buffer<DrainState>)>,
    marks: Buffer<u32>,
    ranks: Buffer<u32>,
    scan: Scan,
}

/// What the shader is told of all of them.
pub fn drain_params(scene: &Scene) -> DrainParams {
    DrainParams {
        drains: scene.drains.len() as u32,
        counts_ages: u32::from(scene.solver.method != Method::None),
        ..DrainParams::default()
    }
}

impl Drains {
    /// None of a scene whose particles stay.
    pub(super) fn declare(resources: &mut Resources, scene: &Scene, capacity: u32) -> Option<Self> {
        let limits = scene.drains.iter().filter(|drain| drain.most_m3_s.is_some()).count();
        let takes_all = limits < scene.drains.len();
        let ends = scene.emitters.iter().any(|emitter| emitter.lifetime_s.is_some());
        let count = scene.drains.len() as u32;
        let all = (takes_all || ends).then(|| Unlimited {
            drains: resources.persistent("drains", count.max(1)),
            params: resources.persistent("drain_params", 1),
        });
        let limited = (limits > 0).then(|| Limited {
            drains: (0..limits)
                .map(|n| {
                    let drain = resources.persistent(&format!("limited_drain_{n}"), 1);
                    (drain, resources.persistent(&format!("drain_state_{n}"), 1))
                })
                .collect(),
            marks: resources.buffer("drain_marks", capacity),
            ranks: resources.buffer("drain_ranks", capacity),
            scan: Scan::declare(resources, "drain_ranks", capacity),
        });
        (all.is_some() || limited.is_some()).then_some(Self { all, limited })
    }

    pub(super) fn record_init(&mut self, init: &mut Recording, scene: &Scene) {
        let drains = drains(scene);
        if let Some(all) = &mut self.all {
            match drains.is_empty() {
                true => init.clear(&mut all.drains),
                false => init.upload(&mut all.drains, &drains),
            }
            init.upload(&mut all.params, &[drain_params(scene)]);
        }
        if let Some(limited) = &mut self.limited {
            let with_limit = drains.into_iter().filter(|drain| drain.particles_per_s > 0.0);
            for ((buffer, state), drain) in limited.drains.iter_mut().zip(with_limit) {
                init.upload(buffer, &[drain]);
                init.clear(state);
            }
        }
    }

    pub(super) fn record(
        &mut self,
        recording: &mut Recording,
        slots: &Slots,
        counters: &mut Buffer<Counters>,
        particles: &mut Particles,
    ) {
        if let Some(all) = &self.all {
            slots.dispatch(
                recording,
                &DrainParticles {
                    drains: all.drains.read(),
                    positions: particles.positions.write(),
                    velocities: particles.velocities.write(),
                    counters: counters.write(),
                    step_state: slots.state.uniform(),
                    drain_params: all.params.uniform(),
                },
            );
        }
        if let Some(limited) = &mut self.limited {
            limited.record(recording, slots, counters, particles);
        }
    }
}

impl Limited {
    fn record(
        &mut self,
        recording: &mut Recording,
        slots: &Slots,
        counters: &mut Buffer<Counters>,
        particles: &mut Particles,
    ) {
        for (drain, state) in &mut self.drains {
            let mark = MarkDrained {
                drain_marks: self.marks.write(),
                drained_positions: particles.positions.read(),
                step_state: slots.state.uniform(),
                drain: drain.uniform(),
            };
            recording.dispatch(&mark, slots.capacity);
            self.scan.record(recording, &self.marks, &mut self.ranks);
            slots.dispatch(
                recording,
                &TakeDrained {
                    marked_drains: self.marks.read(),
                    drain_ranks: self.ranks.read(),
                    positions: particles.positions.write(),
                    velocities: particles.velocities.write(),
                    drain_state: state.read(),
                    step_state: slots.state.uniform(),
                },
            );
            recording.dispatch_groups(
                &SettleDrain {
                    marked_drains: self.marks.read(),
                    drain_ranks: self.ranks.read(),
                    settled_drain: state.write(),
                    counters: counters.write(),
                    step_state: slots.state.uniform(),
                    drain: drain.uniform(),
                },
                [1; 3],
            );
        }
    }
}
