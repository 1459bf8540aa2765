//! What solids and bodies add to a step: the same pool without any, with a hundred solids and ground of 100,000 triangles, and
//! with 16 bodies, in turns.

use brooklet_fluid::{FrameRequest, Scene, Session};
use brooklet_gpu::{Gpu, Timings, quantile, stages, tier_name};
use serde::Serialize;

use crate::{BenchError, Observer, scene_options, stepping::Stepping, workload};

/// Stages that are there with solids.
const OF_SOLIDS: [&str; 7] = [
    "move_solids",
    "mark_solids",
    "collide_solids",
    "sample_solids",
    "confine_displacements",
    "add_solid_density",
    "add_solid_acceleration",
];
/// Stages that are there with bodies.
const OF_BODIES: [&str; 3] = ["find_contacts", "step_bodies", "gather_reactions"];
/// Cells of the ground along a side: 100,352 triangles on top.
const GROUND_CELLS: u32 = 224;
/// Steps of a turn.
const STEPS: u64 = 4;

/// What is timed.
#[derive(Clone, Debug)]
pub struct Options {
    /// About how many particles.
    pub particles: u32,
    /// Turns of each scene.
    pub rounds: u32,
    /// Settings of every scene.
    pub settings: Vec<String>,
}

/// What each scene took.
#[derive(Clone, Debug, Serialize)]
pub struct BodiesCost {
    /// What it ran on.
    pub device: String,
    /// What the device was used as.
    pub tier: &'static str,
    /// Turns of each scene, of 4 steps.
    pub rounds: u32,
    /// The first has neither solids nor bodies.
    pub rows: Vec<Row>,
}

/// A scene.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// What is in the pool.
    pub what: &'static str,
    /// Solids, bodies among them.
    pub solids: usize,
    /// Bodies.
    pub bodies: usize,
    /// Triangles of its solids.
    pub triangles: usize,
    /// Particles: those in solids are left out.
    pub particles: u32,
    /// A step, ms: the median of all.
    pub step_ms: f64,
    /// Time a particle over that of the first row in the same round: the median.
    pub ratio: f64,
    /// Share of the step that stages of solids take.
    pub solids_share: f64,
    /// The same of bodies.
    pub bodies_share: f64,
}

/// Runs the three in turns.
///
/// # Errors
/// Every [`BenchError`].
pub fn run(gpu: &Gpu, options: &Options, observer: &dyn Observer) -> Result<BodiesCost, BenchError> {
    let scenes = Pool::of(options.particles).scenes(&options.settings)?;
    let mut runs = scenes.iter().map(|(what, scene)| Run::begin(gpu, what, scene)).collect::<Result<Vec<_>, _>>()?;
    observer.begin(u64::from(options.rounds + 1));
    // A first round builds pipelines, and is not counted.
    for round in 0..=options.rounds {
        for run in &mut runs {
            run.turn(round > 0, observer)?;
        }
        observer.advance();
    }
    let info = gpu.info();
    let rows = runs.iter().zip(&scenes).map(|(run, (_, scene))| run.row(scene, &runs[0])).collect();
    Ok(BodiesCost { device: info.name.clone(), tier: tier_name(gpu.tier()), rounds: options.rounds, rows })
}

/// A scene under way.
struct Run {
    what: &'static str,
    session: Session,
    stages: Vec<(&'static str, u32)>,
    /// Of each round.
    rounds: Vec<Timings>,
}

impl Run {
    fn begin(gpu: &Gpu, what: &'static str, scene: &Scene) -> Result<Self, BenchError> {
        let planned = scene_options::plan(gpu, scene)?;
        let stages = stages(planned.plan().passes());
        let mut session = brooklet_render::start(gpu, planned.session).map_err(BenchError::input)?;
        session.finish().map_err(BenchError::stopped)?;
        Ok(Self { what, session, stages, rounds: Vec::new() })
    }

    fn turn(&mut self, counts: bool, observer: &dyn Observer) -> Result<(), BenchError> {
        let request = FrameRequest { steps: 1, ..FrameRequest::default() };
        let mut timings = Timings::new(0);
        Stepping { session: &mut self.session, request, observer }.run(STEPS, &mut timings, || ())?;
        self.rounds.extend(counts.then_some(timings));
        Ok(())
    }

    /// A step of each round, ms.
    fn steps_ms(&self) -> impl Iterator<Item = f64> {
        self.rounds.iter().map(|timings| timings.step_ms().map_or(f64::NAN, |step| step.median))
    }

    /// All that stages took, ms.
    fn total_ms(&self, of: impl Fn(&str) -> bool) -> f64 {
        let passes = self.rounds.iter().flat_map(|timings| timings.passes(&self.stages).0);
        passes.filter(|(stage, _)| of(stage)).filter_map(|(_, times)| times.total_ms).sum()
    }

    fn row(&self, scene: &Scene, first: &Self) -> Row {
        let share = |of: &[&str]| self.total_ms(|stage| of.contains(&stage)) / self.total_ms(|_| true);
        let particles = |run: &Self| f64::from(run.session.slot_count());
        let of_particle = |run: &Self, step_ms: f64| step_ms / particles(run);
        let ratios = self
            .steps_ms()
            .zip(first.steps_ms())
            .map(|(own, other)| of_particle(self, own) / of_particle(first, other));
        Row {
            what: self.what,
            solids: scene.solids.len(),
            bodies: scene.solids.iter().filter(|solid| solid.density_kg_m3.is_some()).count(),
            triangles: scene.solids.iter().filter_map(|solid| Some(solid.triangles()?.solid.triangles.len())).sum(),
            particles: self.session.slot_count(),
            step_ms: median(self.steps_ms()),
            ratio: median(ratios),
            solids_share: share(&OF_SOLIDS),
            bodies_share: share(&OF_BODIES),
        }
    }
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    quantile(&values, 0.5).unwrap_or(f64::NAN)
}

/// A pool of water in a box, twice as wide and long as it is deep.
struct Pool {
    /// Particles along its depth.
    layers: u32,
    /// Of its ground, along a side.
    ground_cells: u32,
}

impl Pool {
    fn of(particles: u32) -> Self {
        Self { layers: ((f64::from(particles) / 4.0).cbrt().round() as u32).max(8), ground_cells: GROUND_CELLS }
    }

    fn scenes(&self, settings: &[String]) -> Result<Vec<(&'static str, Scene)>, BenchError> {
        let of = |what: &'static str, solids: String| {
            let text = self.toml(&solids);
            let scene = Scene::from_toml(&text, "bodies", settings).map_err(BenchError::input)?;
            Ok((what, scene))
        };
        vec![
            ("neither", String::new()),
            ("99 solids and ground", self.ground() + &self.solids()),
            ("16 bodies", self.bodies()),
        ]
        .into_iter()
        .map(|(what, solids)| of(what, solids))
        .collect()
    }

    /// Its sides, m.
    fn size_m(&self) -> [f64; 3] {
        let depth_m = f64::from(self.layers) * workload::SPACING_M;
        [2.0 * depth_m, depth_m, 2.0 * depth_m]
    }

    fn toml(&self, solids: &str) -> String {
        let [x_m, y_m, z_m] = self.size_m();
        format!(
            "spacing_m = {:?}\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [{x_m:?}, {:?}, {z_m:?}]\n\
             [[fluid]]\nblock = {{ min_m = [0, 0, 0], max_m = [{x_m:?}, {y_m:?}, {z_m:?}] }}\n\
             [solver]\ndt_s = {:?}\n[outputs]\nimages = 0\nmeasure_every_steps = 0\n{solids}",
            workload::SPACING_M,
            1.6 * y_m,
            workload::calm_dt_s(self.layers),
        )
    }

    /// Balls, boxes, capsules and cylinders in rows under the water.
    fn solids(&self) -> String {
        let [x_m, y_m, z_m] = self.size_m();
        let of = |k: u32| {
            let [column, row] = [k % 10, k / 10].map(|k| (f64::from(k) + 0.5) / 10.0);
            let r = 2.2 * workload::SPACING_M;
            let shape = match k % 4 {
                0 => format!("sphere = {{ radius_m = {r:?} }}"),
                1 => format!("box = {{ size_m = [{:?}, {:?}, {:?}] }}", 2.0 * r, 1.5 * r, 2.0 * r),
                2 => format!("capsule = {{ radius_m = {r:?}, length_m = {:?} }}", 3.0 * r),
                _ => format!("cylinder = {{ radius_m = {r:?}, length_m = {:?} }}", 2.0 * r),
            };
            format!("[[solid]]\n{shape}\ncentre_m = [{:?}, {:?}, {:?}]\n", column * x_m, 0.6 * y_m, row * z_m)
        };
        (0..99).map(of).collect()
    }

    /// Hills under all of it.
    fn ground(&self) -> String {
        let [x_m, y_m, z_m] = self.size_m();
        format!(
            "[[solid]]\nterrain = {{ size_m = [{x_m:?}, {:?}, {z_m:?}], cell_m = {:?} }}\ncentre_m = [{:?}, 0, {:?}]\n",
            0.1 * y_m,
            x_m / f64::from(self.ground_cells),
            0.5 * x_m,
            0.5 * z_m,
        )
    }

    /// Blocks that float.
    fn bodies(&self) -> String {
        let [x_m, y_m, z_m] = self.size_m();
        let of = |k: u32| {
            let [column, row] = [k % 4, k / 4].map(|k| (f64::from(k) + 0.5) / 4.0);
            let side_m = 0.1 * x_m;
            format!(
                "[[solid]]\nbox = {{ size_m = [{side_m:?}, {:?}, {side_m:?}] }}\ncentre_m = [{:?}, {y_m:?}, {:?}]\n\
                 density_kg_m3 = 500\n",
                0.6 * side_m,
                column * x_m,
                row * z_m,
            )
        };
        (0..16).map(of).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scenes_have_what_their_rows_say() {
        // The field of all of the ground takes a minute.
        let pool = Pool { ground_cells: 40, ..Pool::of(20_000) };
        let scenes = pool.scenes(&[]).unwrap();
        let counts: Vec<(usize, usize)> = scenes
            .iter()
            .map(|(_, scene)| {
                let bodies = scene.solids.iter().filter(|solid| solid.density_kg_m3.is_some()).count();
                (scene.solids.len(), bodies)
            })
            .collect();
        assert_eq!(counts, [(0, 0), (100, 0), (16, 16)]);
        let triangles = scenes[1].1.solids[0].triangles().unwrap().solid.triangles.len();
        assert!((3_200..8_000).contains(&triangles), "{triangles}");
        assert!(2 * GROUND_CELLS.pow(2) > 100_000);
        assert!(pool.scenes(&["solver.bogus=1".into()]).is_err());
    }
}
