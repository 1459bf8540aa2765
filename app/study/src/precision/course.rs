//! A scene as one way runs it: what the program measured of it, and two pictures.

use brooklet_fluid::particles::ParticleSet;
use brooklet_fluid::{FrameRequest, ParticleSource, Scene, SessionRecorder, Stats};
use brooklet_gpu::Gpu;
use brooklet_render::{FrameOptions, ScenePlan, View};

/// Measurements of a run.
const MOMENTS: u64 = 20;
/// The moment of the first picture: before a flow can go its own way.
const EARLY: u64 = 4;

/// When a run is looked at: the steps at whose end it is measured, rising; and drawn.
pub struct Looks {
    measured: Vec<u64>,
    drawn: [u64; 2],
}

impl Looks {
    /// Steps in all.
    pub fn steps(&self) -> u64 {
        self.measured.last().copied().unwrap_or(0)
    }
}

/// When a run of `scene` is looked at.
pub fn looks_of(scene: &Scene) -> Looks {
    let steps = (scene.outputs.seconds / scene.solver.dt_s).round().max(1.0) as u64;
    let moments = MOMENTS.min(steps);
    let at = |moment: u64| steps * moment / moments;
    Looks { measured: (1..=moments).map(at).collect(), drawn: [at(EARLY.min(moments)), steps] }
}

/// What a run gave.
#[derive(Clone, Debug, Default)]
pub struct Course {
    /// Its measurements.
    pub moments: Vec<Stats>,
    /// Its pictures, early and at its end: sRGB, four bytes a pixel.
    pub pictures: Vec<Vec<u8>>,
}

/// Runs `scene` from `particles`; none if it was stopped, and why where the device cannot.
pub fn run(
    gpu: &Gpu,
    scene: &Scene,
    particles: ParticleSet,
    looks: &Looks,
    stop: &dyn Fn() -> bool,
    progress: &dyn Fn(f64),
) -> Result<Option<Course>, String> {
    let recorder = SessionRecorder::new(scene, ParticleSource::Given(particles));
    let seen = (View::of_scene(scene), FrameOptions::for_scene(scene, gpu.tier()));
    let planned = ScenePlan::sweep(scene, recorder, Some(seen)).map_err(|error| error.to_string())?;
    let mut passes = planned.passes.ok_or("nothing is drawn")?;
    let mut session = brooklet_render::start(gpu, planned.session).map_err(|error| error.to_string())?;
    let lost = |error: brooklet_gpu::GpuError| error.to_string();
    let mut course = Course::default();
    for step in 1..=looks.steps() {
        if stop() {
            return Ok(None);
        }
        let measure = looks.measured.binary_search(&step).is_ok();
        let draws = looks.drawn.contains(&step);
        let particles = session.slot_count();
        let draw = draws.then(|| passes.next(session.engine_mut(), particles, false));
        let request = FrameRequest { steps: 1, measure, then: draw.as_slice(), ..FrameRequest::default() };
        session.submit(&request).map_err(lost)?;
        course.moments.extend(session.reports().into_iter().filter_map(|frame| frame.stats));
        if draws {
            let picture = session.engine_mut().read_texture(&passes.color).map_err(lost)?;
            course.pictures.push(picture);
        }
        progress(step as f64 / looks.steps() as f64);
    }
    course.moments.extend(session.finish().map_err(lost)?.into_iter().filter_map(|frame| frame.stats));
    Ok(Some(course))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_is_measured_evenly_and_drawn_early_and_last() {
        let looks = looks_of(&Scene::load("dam-break", &["outputs.seconds=0.5".into()]).unwrap());
        assert_eq!((looks.steps(), looks.measured.len(), looks.drawn), (120, 20, [24, 120]));
        let short = looks_of(&Scene::load("dam-break", &["outputs.seconds=0.0042".into()]).unwrap());
        assert_eq!((short.measured.as_slice(), short.drawn), ([1].as_slice(), [1, 1]));
    }
}
