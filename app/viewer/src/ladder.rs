//! The quality ladder: what is given up, rung by rung, for a frame in time; by hand or by itself.

use brooklet_fluid::Scene;
use brooklet_fluid::scene::Precision;
use brooklet_render::FrameOptions;

/// What is given up on a rung; each includes all above it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rung {
    /// What is new on it.
    pub name: &'static str,
    /// Particles over those of the scene, about: the spacing grows by its cube root.
    particles: f64,
    /// Whether what is only seen through the water, or as its shadow, is half as fine.
    coarse_fields: bool,
    /// Drawn pixels a side of a picture's pixel.
    supersample: u32,
    /// Picture pixels over the window's, a side.
    scale: f64,
    /// Whether pairs of particles are rounded more.
    lower_precision: bool,
    /// Whether a step has half as many substeps; of one, half the iterations.
    fewer_substeps: bool,
}

const BEST: Rung = Rung {
    name: "everything",
    particles: 1.0,
    coarse_fields: false,
    supersample: 2,
    scale: 1.0,
    lower_precision: false,
    fewer_substeps: false,
};
const HALF: Rung = Rung { name: "half the particles", particles: 0.5, ..BEST };
const QUARTER: Rung = Rung { name: "a quarter of the particles", particles: 0.25, ..BEST };
const COARSE: Rung = Rung { name: "coarser light and thickness", coarse_fields: true, ..QUARTER };
const PLAIN: Rung = Rung { name: "no supersampling", supersample: 1, ..COARSE };
const SMALL: Rung = Rung { name: "picture at 3/4", scale: 0.75, ..PLAIN };
const SMALLER: Rung = Rung { name: "picture at 1/2", scale: 0.5, ..PLAIN };
const ROUGH: Rung = Rung { name: "lower precision", lower_precision: true, ..SMALLER };
const FEWER: Rung = Rung { name: "fewer substeps", fewer_substeps: true, ..ROUGH };

/// From all there is to the least.
pub const RUNGS: [Rung; 9] = [BEST, HALF, QUARTER, COARSE, PLAIN, SMALL, SMALLER, ROUGH, FEWER];

impl Rung {
    /// The scene as it is simulated on this rung.
    pub fn scene(&self, scene: &Scene) -> Scene {
        let mut scene = scene.clone();
        if self.particles < 1.0 {
            scene.spacing_m *= self.particles.powf(-1.0 / f64::from(scene.domain.dimensions));
        }
        if self.lower_precision && scene.solver.precision == Precision::Full {
            scene.solver.precision = Precision::Relaxed;
        }
        if self.fewer_substeps {
            let solver = &mut scene.solver;
            let halved = if solver.substeps > 1 { &mut solver.substeps } else { &mut solver.pbf.iterations };
            *halved = halved.div_ceil(2);
        }
        scene
    }

    /// What is drawn on this rung.
    pub fn options(&self, mut options: FrameOptions) -> FrameOptions {
        options.supersample = options.supersample.min(self.supersample);
        if self.coarse_fields {
            options.shadow_texels /= 2;
            if let Some(water) = options.surface.water_mut() {
                water.thickness_divisor = (2 * water.thickness_divisor).min(8);
                water.photons /= 2;
            }
        }
        options
    }

    /// Size of the picture for a window's, pixels.
    pub fn picture_px(&self, window_px: [u32; 2]) -> [u32; 2] {
        window_px.map(|side| ((f64::from(side) * self.scale).round() as u32).max(1))
    }
}

/// Which way to go on the ladder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Move {
    /// To the next rung down: less work.
    Down,
    /// Up: more.
    Up,
}

/// Holds a frame's time near a budget, without swinging between two rungs.
#[derive(Clone, Debug)]
pub struct Governor {
    /// What a frame may take, ms.
    pub budget_ms: f64,
    times_ms: Vec<f64>,
    /// Frames to look away after a change: the first ones build caches.
    ignored: u32,
    /// Good frames it takes to go up, doubled by each step up that did not hold.
    patience: u32,
    good_frames: u32,
    frames_since_up: Option<u32>,
}

/// Frames a median is taken of.
const WINDOW: usize = 24;
const SETTLING: u32 = 6;
/// Room that must be left before more is asked for: a rung may cost half as much again.
const ROOM: f64 = 0.6;
/// A frame a tenth over its budget is not yet too slow.
const TOLERANCE: f64 = 1.1;
const PATIENCE: u32 = 90;
const MOST_PATIENCE: u32 = 60 * 60;
/// A step up that came back within so many frames did not hold.
const HELD: u32 = 600;

impl Governor {
    /// For a budget.
    pub fn new(budget_ms: f64) -> Self {
        Self {
            budget_ms,
            times_ms: Vec::with_capacity(WINDOW),
            ignored: SETTLING,
            patience: PATIENCE,
            good_frames: 0,
            frames_since_up: None,
        }
    }

    /// Takes a frame's time, ms; says whether another rung is called for.
    pub fn take(&mut self, frame_ms: f64) -> Option<Move> {
        if !frame_ms.is_finite() {
            return None;
        }
        if let Some(frames) = &mut self.frames_since_up {
            *frames = frames.saturating_add(1);
        }
        if self.ignored > 0 {
            self.ignored -= 1;
            return None;
        }
        if self.times_ms.len() == WINDOW {
            self.times_ms.remove(0);
        }
        self.times_ms.push(frame_ms);
        if self.times_ms.len() < WINDOW {
            return None;
        }
        let mut sorted = self.times_ms.clone();
        sorted.sort_unstable_by(f64::total_cmp);
        let median_ms = sorted[WINDOW / 2];
        if median_ms > TOLERANCE * self.budget_ms {
            if self.frames_since_up.take().is_some_and(|frames| frames < HELD) {
                self.patience = (2 * self.patience).min(MOST_PATIENCE);
            }
            return Some(self.restart(Move::Down));
        }
        self.good_frames = if median_ms < ROOM * self.budget_ms { self.good_frames + 1 } else { 0 };
        if self.good_frames < self.patience {
            return None;
        }
        self.frames_since_up = Some(0);
        Some(self.restart(Move::Up))
    }

    /// Looks away for some frames: something else changed.
    pub fn settle(&mut self) {
        self.restart(Move::Down);
    }

    fn restart(&mut self, moved: Move) -> Move {
        self.times_ms.clear();
        self.good_frames = 0;
        self.ignored = SETTLING;
        moved
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use brooklet_gpu::Tier;

    fn scene() -> Scene {
        Scene::load("dam-break", &["spacing_m=0.05".into()]).unwrap()
    }

    #[test]
    fn each_rung_asks_for_less() {
        let scene = scene();
        let options = FrameOptions::for_scene(&scene, Tier::Desktop);
        let work = |rung: &Rung| {
            let run = rung.scene(&scene);
            let mut drawn = rung.options(options);
            let particles = run.particle_count() as f64;
            let rounds = f64::from(run.solver.substeps * run.solver.pbf.iterations);
            let cost = if run.solver.precision == Precision::Full { 1.0 } else { 0.8 };
            let side = rung.picture_px([1000, 1000])[0] * drawn.supersample;
            let texels = drawn.surface.water_mut().map_or(0.0, |water| f64::from(water.photons));
            particles * rounds * cost + f64::from(side).powi(2) + texels
        };
        for pair in RUNGS.windows(2) {
            assert!(work(&pair[1]) < work(&pair[0]), "{} after {}", pair[1].name, pair[0].name);
        }
        let half = RUNGS[1].scene(&scene).particle_count() as f64;
        let all = scene.particle_count() as f64;
        assert!((0.4..0.6).contains(&(half / all)), "{}", half / all);
        assert_eq!(RUNGS[0].scene(&scene), scene);
        assert_eq!(RUNGS[0].options(options), options);
    }

    /// Frames of a device on which a rung costs `cost_ms`; returns the rungs at the end of each frame.
    fn drive(
        governor: &mut Governor,
        frames: usize,
        mut rung: usize,
        cost_ms: impl Fn(usize, usize) -> f64,
    ) -> Vec<usize> {
        (0..frames)
            .map(|frame| {
                match governor.take(cost_ms(frame, rung)) {
                    Some(Move::Down) => rung = (rung + 1).min(RUNGS.len() - 1),
                    Some(Move::Up) => rung = rung.saturating_sub(1),
                    None => {}
                }
                rung
            })
            .collect()
    }

    #[test]
    fn a_slow_device_ends_within_its_budget_and_stays() {
        let cost_ms = |_, rung: usize| 40.0 * 0.8f64.powi(rung as i32);
        let rungs = drive(&mut Governor::new(16.0), 4000, 0, cost_ms);
        let last = *rungs.last().unwrap();
        assert!(cost_ms(0, last) <= 16.0 * TOLERANCE, "rung {last}");
        assert!(rungs[400..].iter().all(|rung| *rung == last), "it swings");
    }

    #[test]
    fn a_rung_that_does_not_hold_is_tried_ever_more_rarely() {
        // One rung is far below the budget, the next far above: the worst case for a ladder.
        let cost_ms = |_, rung: usize| if rung == 0 { 30.0 } else { 5.0 };
        let rungs = drive(&mut Governor::new(16.0), 20_000, 0, cost_ms);
        let changes = rungs.windows(2).filter(|pair| pair[0] != pair[1]).count();
        assert!(changes < 24, "{changes} changes in 20,000 frames");
        assert!(changes > 4, "it never tries again");
        let eager = {
            let mut governor = Governor::new(16.0);
            let mut rung = 0;
            let mut changes = 0;
            for _ in 0..20_000 {
                // Without the memory of what did not hold.
                governor.patience = PATIENCE;
                if let Some(moved) = governor.take(cost_ms(0, rung)) {
                    rung = usize::from(moved == Move::Down);
                    changes += 1;
                }
            }
            changes
        };
        assert!(eager > 4 * changes, "{eager} without, {changes} with");
    }

    #[test]
    fn a_device_that_is_free_again_goes_up() {
        let cost_ms = |frame: usize, rung: usize| if frame < 2000 { 40.0 } else { 4.0 } * 0.8f64.powi(rung as i32);
        let rungs = drive(&mut Governor::new(16.0), 6000, 0, cost_ms);
        assert!(rungs[1999] > 2 && *rungs.last().unwrap() == 0, "{} then {}", rungs[1999], rungs.last().unwrap());
    }

    #[test]
    fn single_slow_frames_change_nothing() {
        let cost_ms = |frame: usize, _| if frame.is_multiple_of(10) { 200.0 } else { 12.0 };
        let rungs = drive(&mut Governor::new(16.0), 2000, 3, cost_ms);
        assert!(rungs.iter().all(|rung| *rung == 3));
        assert_eq!(Governor::new(16.0).take(f64::NAN), None);
    }
}
