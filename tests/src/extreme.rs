//! What every extreme case must keep, whatever it does to the fluid: states are finite, no particle
//! is lost or doubled, all are inside the domain, and in the end the fluid is at rest again.

use crate::{compare::vector, gpu, gpu_of_long_run};
use brooklet_fluid::particles::ParticleSet;
use brooklet_fluid::{Scene, Session, Stats};
use brooklet_gpu::Gpu;
use brooklet_kernels::{Position, QUARANTINED, Velocity};
use glam::DVec3;

/// The id in a tag.
pub fn id(tag: u32) -> usize {
    (tag & 0xff_ffff) as usize
}

/// Particles in the order of their ids.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Relative to the domain's lowest corner, as the GPU has them.
    pub positions: Vec<[f32; 3]>,
    /// In the same order.
    pub velocities: Vec<[f32; 3]>,
    /// Whether each is out of the simulation.
    pub quarantined: Vec<bool>,
}

impl State {
    /// Sorts what the GPU gave by id.
    ///
    /// # Errors
    /// If a particle is lost, or there twice.
    pub fn new(positions: &[Position], velocities: &[Velocity], count: usize) -> Result<Self, String> {
        if positions.len() != count || velocities.len() != count {
            return Err(format!("{} positions and {} velocities, not {count}", positions.len(), velocities.len()));
        }
        let mut state = Self {
            positions: vec![[0.0; 3]; count],
            velocities: vec![[0.0; 3]; count],
            quarantined: vec![false; count],
        };
        let mut seen = vec![false; count];
        for (position, velocity) in positions.iter().zip(velocities) {
            let id = id(position.tag);
            if seen.get(id) != Some(&false) {
                return Err(format!("id {id} of {count} is there twice, or is none"));
            }
            seen[id] = true;
            state.positions[id] = position.position_m;
            state.velocities[id] = velocity.velocity_m_s;
            state.quarantined[id] = position.tag & QUARANTINED != 0;
        }
        Ok(state)
    }

    /// Whether all is finite, and inside a box of `size_m` where there is one.
    ///
    /// # Errors
    /// Names the first particle that is not.
    pub fn check(&self, size_m: Option<[f64; 3]>) -> Result<(), String> {
        for (id, (position, velocity)) in self.positions.iter().zip(&self.velocities).enumerate() {
            if !position.iter().chain(velocity).all(|x| x.is_finite()) {
                return Err(format!("particle {id} is not finite: at {position:?} with {velocity:?}"));
            }
            let inside =
                |size_m: [f64; 3]| (0..3).all(|axis| (0.0..=size_m[axis]).contains(&f64::from(position[axis])));
            if size_m.is_some_and(|size_m| !inside(size_m)) {
                return Err(format!("particle {id} is outside: at {position:?}"));
            }
        }
        Ok(())
    }

    /// Positions in f64.
    pub fn at_m(&self) -> Vec<DVec3> {
        self.positions.iter().map(|&p| vector(p)).collect()
    }

    /// Velocities in f64.
    pub fn velocities_m_s(&self) -> Vec<DVec3> {
        self.velocities.iter().map(|&v| vector(v)).collect()
    }

    /// Fastest particle, m/s.
    pub fn max_speed_m_s(&self) -> f64 {
        self.velocities_m_s().iter().map(|v| v.length()).fold(0.0, f64::max)
    }

    /// Distance of each particle to its nearest fellow, m.
    pub fn nearest_m(&self) -> Vec<f64> {
        let at_m = self.at_m();
        (0..at_m.len())
            .map(|i| {
                let others = at_m.iter().enumerate().filter(|(j, _)| *j != i);
                others.map(|(_, at)| (*at - at_m[i]).length()).fold(f64::INFINITY, f64::min)
            })
            .collect()
    }
}

/// A scene on the GPU that is looked at all the time.
pub struct Case {
    session: Session,
    count: usize,
    walled_size_m: Option<[f64; 3]>,
}

fn scene_of(text: &str, settings: &[&str]) -> Scene {
    let settings: Vec<String> = settings.iter().map(|&s| s.into()).collect();
    Scene::from_toml(text, "extreme.toml", &settings).unwrap_or_else(|error| panic!("{error}"))
}

impl Case {
    /// Starts the scene in `text` with `settings` (`path=value`) on top.
    ///
    /// # Panics
    /// If the scene or the device does not allow it.
    pub fn new(text: &str, settings: &[&str]) -> Self {
        Self::of(&scene_of(text, settings))
    }

    /// Starts a scene.
    ///
    /// # Panics
    /// If the device does not allow it.
    pub fn of(scene: &Scene) -> Self {
        Self::on(&gpu_of_long_run(scene), scene)
    }

    /// Starts a scene whose few steps take long, all of them under the validation layers.
    ///
    /// # Panics
    /// If the scene or the device does not allow it.
    pub fn of_few_steps(text: &str, settings: &[&str]) -> Self {
        Self::on(&gpu(), &scene_of(text, settings))
    }

    fn on(gpu: &Gpu, scene: &Scene) -> Self {
        let mut session = Session::new(gpu, scene).unwrap_or_else(|error| panic!("{error}"));
        let positions = session.read_particles().unwrap_or_else(|error| panic!("{error}")).positions;
        let walled_size_m = scene.domain.walls.then(|| scene.domain.size_m());
        Self { session, count: positions.len(), walled_size_m }
    }

    /// Number of particles.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The scene.
    pub fn scene(&self) -> &Scene {
        self.session.scene()
    }

    /// Changes each particle, given its id.
    ///
    /// # Panics
    /// If the device fails.
    pub fn place(&mut self, mut change: impl FnMut(usize, &mut [f32; 3], &mut [f32; 3])) {
        let ParticleSet { mut positions, mut velocities } =
            self.session.read_particles().unwrap_or_else(|error| panic!("{error}"));
        for (position, velocity) in positions.iter_mut().zip(&mut velocities) {
            change(id(position.tag), &mut position.position_m, &mut velocity.velocity_m_s);
        }
        self.session.write_particles(&ParticleSet { positions, velocities });
    }

    /// The particles, unchecked.
    ///
    /// # Panics
    /// If the device fails, or particles are lost.
    pub fn state(&mut self) -> State {
        let ParticleSet { positions, velocities } =
            self.session.read_particles().unwrap_or_else(|error| panic!("{error}"));
        State::new(&positions, &velocities, self.count).unwrap_or_else(|error| panic!("{error}"))
    }

    /// Runs `steps`, checks the state along the way and returns the measurement after the last:
    /// its counters are those of all these steps. No speed may pass the scene's limit.
    ///
    /// # Panics
    /// If a check fails.
    pub fn run(&mut self, steps: u32) -> Stats {
        self.run_unmeasured(steps);
        self.measure()
    }

    /// As [`Case::run`], without the measurement.
    ///
    /// # Panics
    /// If a check fails.
    pub fn run_unmeasured(&mut self, steps: u32) {
        let every = (steps / 8).max(1);
        // A clamped speed is rounded three times, and viscosity's mean again.
        let limit_m_s = self.scene().max_speed_m_s() * (1.0 + 1.0e-6);
        for step in 1..=steps {
            self.session.step().unwrap_or_else(|error| panic!("step {step}: {error}"));
            if step % every == 0 || step == steps {
                let state = self.state();
                state.check(self.walled_size_m).unwrap_or_else(|error| panic!("step {step}: {error}"));
                let speed_m_s = state.max_speed_m_s();
                assert!(speed_m_s <= limit_m_s, "step {step}: {speed_m_s} m/s is over the limit, {limit_m_s}");
            }
        }
    }

    /// Measures the present state.
    ///
    /// # Panics
    /// If the scene does not measure, or the device fails.
    pub fn measure(&mut self) -> Stats {
        self.session.measure().unwrap_or_else(|error| panic!("{error}"));
        self.session.finish().unwrap_or_else(|error| panic!("{error}"));
        self.session.stats().unwrap_or_else(|| panic!("the scene measures nothing"))
    }

    /// Runs `seconds` more; then the fluid must be at rest: slower than falling a spacing makes it,
    /// hardly compressed, and nothing had to be cut short in the last quarter.
    ///
    /// # Panics
    /// If it is not.
    pub fn recovers(&mut self, seconds: f64) -> Stats {
        let steps = (seconds / self.scene().solver.dt_s).ceil() as u32;
        self.run(steps - steps / 4);
        let stats = self.run(steps / 4);
        at_rest(&stats, self.scene().spacing_m).unwrap_or_else(|error| panic!("after {seconds} s: {error}"));
        stats
    }
}

/// Whether `stats` are those of a fluid at rest that lost nothing since the measurement before.
///
/// # Errors
/// Says what is wrong.
pub fn at_rest(stats: &Stats, spacing_m: f64) -> Result<(), String> {
    let limit_m_s = (2.0 * 9.81 * spacing_m).sqrt();
    let counters = stats.counters;
    let cut = [
        counters.neighbour_overflow,
        counters.crowded,
        counters.speed_clamps,
        counters.correction_clamps,
        counters.displacement_clamps,
    ];
    if stats.max_speed_m_s > limit_m_s {
        return Err(format!("moves at {} m/s, {limit_m_s} is allowed", stats.max_speed_m_s));
    }
    if stats.compression.p99 > 0.1 {
        return Err(format!("compressed by {:?}, a p99 of 0.1 is allowed", stats.compression));
    }
    match cut {
        [0, 0, 0, 0, 0] => Ok(()),
        _ => Err(format!(
            "neighbours without a slot, crowded searches, clamped speeds, corrections and displacements: {cut:?}"
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn two() -> (Vec<Position>, Vec<Velocity>) {
        let position = |x: f32, tag| Position { position_m: [x, 0.1, 0.1], tag };
        // Cell order is not id order.
        (vec![position(0.2, 1), position(0.1, 0)], vec![Velocity::default(); 2])
    }

    #[test]
    fn a_state_that_is_sound_passes() {
        let (positions, velocities) = two();
        let state = State::new(&positions, &velocities, 2).unwrap();
        assert_eq!(state.positions[0][0], 0.1);
        assert!((state.nearest_m()[1] - 0.1).abs() < 1e-8);
        state.check(Some([0.3; 3])).unwrap();
    }

    #[test]
    fn lost_and_doubled_particles_are_seen() {
        let (mut positions, velocities) = two();
        assert!(State::new(&positions[..1], &velocities, 2).is_err());
        assert!(State::new(&positions, &velocities, 3).is_err());
        positions[0].tag = 0;
        assert!(State::new(&positions, &velocities, 2).is_err());
        positions[0].tag = 2;
        assert!(State::new(&positions, &velocities, 2).is_err());
    }

    #[test]
    fn what_is_not_finite_or_outside_is_seen() {
        let (positions, velocities) = two();
        let sound = State::new(&positions, &velocities, 2).unwrap();
        for bad in [f32::NAN, f32::INFINITY] {
            let (mut position, mut velocity) = (sound.clone(), sound.clone());
            position.positions[1][2] = bad;
            velocity.velocities[0][1] = bad;
            assert!(position.check(None).is_err() && velocity.check(None).is_err());
        }
        assert!(sound.check(Some([0.15, 0.3, 0.3])).is_err());
        let mut below = sound.clone();
        below.positions[0][1] = -1.0e-6;
        assert!(below.check(Some([0.3; 3])).is_err());
        below.check(None).unwrap();
    }

    #[test]
    fn a_fluid_that_is_not_at_rest_is_seen() {
        let calm = Stats::default();
        at_rest(&calm, 0.02).unwrap();
        let fast = Stats { max_speed_m_s: 0.7, ..calm };
        let mut dense = calm;
        dense.compression.p99 = 0.11;
        let mut cut = [calm; 3];
        cut[0].counters.neighbour_overflow = 1;
        cut[1].counters.speed_clamps = 1;
        cut[2].counters.correction_clamps = 1;
        for stats in [fast, dense].iter().chain(&cut) {
            assert!(at_rest(stats, 0.02).is_err(), "{stats:?}");
        }
    }
}
