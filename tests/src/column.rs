//! A column of water at rest between walls, on the GPU, beside the column law: of iterations without a coarse correction,
//! whose law it is.

use crate::cases::walls_of;
use crate::extreme::{Case, State};
use brooklet_fluid::Scene;
use brooklet_fluid::scene::Acceleration;
use brooklet_fluid::solver::pbf::IterationWeights;
use brooklet_reference::column::Column;
use brooklet_reference::grid::list_neighbours::list_neighbours;
use brooklet_reference::measure::density::density_ratio;
use brooklet_reference::params::Smoothing;
use brooklet_reference::shared::lattice;
use brooklet_reference::shared::wendland::kernel;
use glam::DVec3;

/// What to run. Spacing 0.02 m, gravity 9.81 m/s^2, the program's defaults otherwise.
#[derive(Clone, Copy, Debug)]
pub struct Setup {
    /// Layers of the lattice; at least 10.
    pub layers: u32,
    /// Particles along a side of a layer; the walls stand around them. At least 4.
    pub width: u32,
    /// Iterations a substep.
    pub iterations: u32,
    /// Substeps a step.
    pub substeps: u32,
    /// Length of a step, s.
    pub dt_s: f64,
    /// Whether and how iterations are accelerated.
    pub acceleration: Acceleration,
}

/// What is left of the compression.
#[derive(Clone, Debug)]
pub struct Settled {
    /// Mean compression of each layer's particles that touch no side wall, by their position at the
    /// start, bottom first; averaged over the observed time.
    pub layers: Vec<f64>,
    /// Compression of the bottom as the four layers above the lowest give it. The lowest leans on
    /// the floor, which adds density but no neighbour whose gradient counts: it shows less.
    pub bottom: f64,
    /// How far `bottom` swings around its average.
    pub unrest: f64,
    /// What the law gives.
    pub law: f64,
    /// Height that the middle of the column has lost, over its height.
    pub sunk: f64,
}

const SPACING_M: f64 = 0.02;

impl Setup {
    /// The column as the law sees it.
    pub fn column(&self) -> Column {
        let scene = self.scene();
        Column {
            dimensions: 3,
            layers: self.layers,
            spacing_m: scene.spacing_m,
            support_ratio: scene.solver.support_ratio,
            gravity_m_s2: -scene.gravity_m_s2[1],
            dt_s: scene.substep_s(),
            relaxation: IterationWeights::of(&scene).response / f64::from(self.iterations),
            iterations: self.iterations,
            cfm: scene.solver.pbf.cfm,
        }
    }

    /// As it is, with the step for which the law gives `compression` at the bottom.
    pub fn at(self, compression: f64) -> Self {
        Self { dt_s: f64::from(self.substeps) * self.column().dt_s_for(compression), ..self }
    }

    fn scene(&self) -> Scene {
        let [width_m, height_m] = [self.width, self.layers].map(|n| f64::from(n) * SPACING_M);
        let text = format!(
            "spacing_m = {SPACING_M}\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [{width_m}, {}, {width_m}]\n\
             [[fluid]]\nblock = {{ min_m = [0, 0, 0], max_m = [{width_m}, {height_m}, {width_m}] }}\n\
             [solver]\ndt_s = {}\nsubsteps = {}\n[solver.pbf]\niterations = {}\nacceleration = \"{}\"\n\
             coarse_correction = false\n[outputs]\nmeasure_every_steps = 0\n",
            height_m + 4.0 * SPACING_M,
            self.dt_s,
            self.substeps,
            self.iterations,
            self.acceleration.name()
        );
        Scene::from_toml(&text, "column.toml", &[]).unwrap_or_else(|error| panic!("{error}"))
    }

    /// Starts the column as the law has it, takes its swings away several times, lets it swing
    /// freely once, and averages over that: where it rests does not depend on the way there.
    ///
    /// # Panics
    /// If the device fails, or a particle is lost.
    pub fn settle(&self) -> Settled {
        let scene = self.scene();
        let mut case = Case::of(&scene);
        assert_eq!(case.count() as u32, self.layers * self.width * self.width);
        let heights_m = self.heights_m();
        case.place(|id, position_m, _| position_m[1] = heights_m[self.layer(id)] as f32);
        // A swing takes 4 N d / c with c = d sqrt(kappa omega n) / dt; by the law, so many substeps:
        let column = self.column();
        let substeps =
            4.0 * (f64::from(self.layers) * column.bottom_compression() * SPACING_M / 9.81).sqrt() / column.dt_s;
        let swing = (substeps / f64::from(self.substeps)).ceil().max(8.0) as u32;
        for _ in 0..8 {
            // A quarter: from the turning point to the fastest moment.
            case.run_unmeasured(swing.div_ceil(4));
            case.place(|_, _, velocity_m_s| *velocity_m_s = [0.0; 3]);
        }
        let looks = 8;
        let mut layers = vec![0.0; self.layers as usize];
        let mut bottoms = Vec::new();
        let mut sunk = 0.0;
        for _ in 0..looks {
            case.run_unmeasured(swing.div_ceil(looks));
            let state = case.state();
            let means = self.layers_of(&scene, &state);
            layers.iter_mut().zip(&means).for_each(|(sum, mean)| *sum += mean / f64::from(looks));
            bottoms.push(self.bottom_of(&means));
            let height_m = f64::from(self.layers) * SPACING_M;
            sunk += (0.5 - state.at_m().iter().map(|p| p.y).sum::<f64>() / case.count() as f64 / height_m)
                / f64::from(looks);
        }
        let bottom = self.bottom_of(&layers);
        let unrest = bottoms.iter().map(|b| (b - bottom).abs()).fold(0.0, f64::max);
        Settled { layers, bottom, unrest, law: column.bottom_compression(), sunk }
    }

    /// ParticleSet x fastest, then y.
    fn layer(&self, id: usize) -> usize {
        id / self.width as usize % self.layers as usize
    }

    fn beside_a_wall(&self, id: usize) -> bool {
        let width = self.width as usize;
        [id % width, id / width / self.layers as usize].iter().any(|&index| index == 0 || index == width - 1)
    }

    fn bottom_of(&self, layers: &[f64]) -> f64 {
        // Their middle is three layers above the floor.
        let layers_above = f64::from(self.layers) - 3.0;
        layers[1..5].iter().sum::<f64>() / 4.0 * f64::from(self.layers) / layers_above
    }

    fn layers_of(&self, scene: &Scene, state: &State) -> Vec<f64> {
        let walls = walls_of(&brooklet_fluid::smoothing_kernel_params(scene), DVec3::from_array(scene.domain.size_m()));
        let smoothing = Smoothing::new(scene.support_m(), lattice::weight(3, scene.solver.support_ratio));
        let at_m = state.at_m();
        let lists = list_neighbours(&at_m, |_| false, smoothing.support_m);
        let inner = f64::from((self.width - 2) * (self.width - 2));
        let mut means = vec![0.0; self.layers as usize];
        for id in (0..at_m.len()).filter(|&id| !self.beside_a_wall(id)) {
            let ratio = density_ratio(id, &at_m, &lists[id], &smoothing, Some(&walls));
            means[self.layer(id)] += (ratio - 1.0).max(0.0) / inner;
        }
        means
    }

    /// Heights of the layers of a lattice squeezed along y as the law says.
    fn heights_m(&self) -> Vec<f64> {
        let law = self.column().bottom_compression();
        let mut height_m = 0.5 * SPACING_M;
        (0..self.layers)
            .map(|layer| {
                let here_m = height_m;
                height_m += SPACING_M * squeezed(law * (1.0 - f64::from(layer) / f64::from(self.layers)));
                here_m
            })
            .collect()
    }
}

/// Spacing of layers, over the lattice's, at which its density ratio is 1 + `compression`.
fn squeezed(compression: f64) -> f64 {
    let ratio = |squeeze: f64| {
        let mut sum = 0.0;
        for (x, y, z) in (0..7 * 7 * 7).map(|n| (n % 7 - 3, n / 7 % 7 - 3, n / 49 - 3)) {
            sum += kernel(DVec3::new(f64::from(x), squeeze * f64::from(y), f64::from(z)).length() / 2.0);
        }
        sum * lattice::weight(3, 2.0)
    };
    let (mut low, mut high) = (0.3, 1.0);
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if ratio(middle) > 1.0 + compression { low = middle } else { high = middle }
    }
    high
}
