//! What the twins are told: the host-visible settings, in f64.

use glam::{BVec3, DVec3};

/// One substep; see `StepParams` of the shaders' layout.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// Gravity, m/s^2.
    pub gravity_m_s2: DVec3,
    /// Length of the substep, s.
    pub dt_s: f64,
    /// The domain's size; its lowest corner is the origin.
    pub domain_size_m: DVec3,
    /// Along which axes the domain has walls.
    pub walls: BVec3,
    /// The domain's side along periodic axes, 0 along others, m.
    pub period_m: DVec3,
    /// Particles stay at least this far from a wall.
    pub wall_offset_m: f64,
    /// Faster particles are slowed to this.
    pub max_speed_m_s: f64,
}

impl Step {
    /// The position's image inside the domain.
    pub fn wrapped(&self, position_m: DVec3) -> DVec3 {
        let periodic = self.period_m.cmpgt(DVec3::ZERO);
        let inside_m = position_m - self.period_m * (position_m / self.period_m).floor();
        // Just below 0 the sum may round to the period itself.
        let inside_m = DVec3::select(inside_m.cmplt(self.period_m), inside_m, DVec3::ZERO);
        DVec3::select(periodic, inside_m, position_m)
    }

    /// Slows a velocity to the limit; whether it had to be.
    pub fn slowed(&self, velocity_m_s: DVec3) -> (DVec3, bool) {
        let fast = velocity_m_s.length() > self.max_speed_m_s;
        (velocity_m_s.clamp_length_max(self.max_speed_m_s), fast)
    }
}

/// The neighbour grid; see `GridParams`.
#[derive(Clone, Copy, Debug)]
pub struct Grid {
    /// Cells along each axis.
    pub cells: [u32; 3],
    /// Cells of the domain along each axis; those beyond `cells` are wrapped onto them.
    pub domain_cells: [u32; 3],
    /// Edge of a cell, m.
    pub cell_size_m: f64,
    /// Support radius, m.
    pub support_m: f64,
}

impl Grid {
    /// Number of cells; also the index of the cell for what is outside.
    pub fn cell_count(&self) -> u32 {
        self.cells.iter().product()
    }
}

/// The smoothing kernel's scale (see `SmoothingKernelParams`), and the distances that it is a function of.
#[derive(Clone, Copy, Debug)]
pub struct Smoothing {
    /// Support radius, m.
    pub support_m: f64,
    /// 1 / sum of W over the initial lattice.
    pub weight: f64,
    /// The domain's side along periodic axes, 0 along others, m.
    pub period_m: DVec3,
}

impl Smoothing {
    /// In a domain without periodic axes.
    pub fn new(support_m: f64, weight: f64) -> Self {
        Self { support_m, weight, period_m: DVec3::ZERO }
    }

    /// From x_j, or the nearest of its images, to x_i, in h.
    pub fn offset(&self, x_i_m: DVec3, x_j_m: DVec3) -> DVec3 {
        next_image(x_i_m - x_j_m, self.period_m) / self.support_m
    }
}

/// As [`nearest_image`] of two particles of one domain, which are less than one and a half periods apart.
/// Rounding to whole periods is what a run would spend much of its time on.
pub fn next_image(mut offset_m: DVec3, period_m: DVec3) -> DVec3 {
    if period_m != DVec3::ZERO {
        for axis in 0..3 {
            let half_m = 0.5 * period_m[axis];
            if half_m > 0.0 && offset_m[axis].abs() > half_m {
                offset_m[axis] -= period_m[axis].copysign(offset_m[axis]);
            }
        }
    }
    offset_m
}

/// The shortest of what lies between two points and their images.
pub fn nearest_image(offset_m: DVec3, period_m: DVec3) -> DVec3 {
    if period_m == DVec3::ZERO {
        return offset_m;
    }
    let image_m = offset_m - period_m * (offset_m / period_m).round();
    DVec3::select(period_m.cmpgt(DVec3::ZERO), image_m, offset_m)
}

/// Position Based Fluids; see `PbfParams`.
#[derive(Clone, Copy, Debug)]
pub struct Pbf {
    /// Jacobi under-relaxation.
    pub relaxation: f64,
    /// Constraint force mixing.
    pub cfm: f64,
    /// Artificial pressure; zero leaves it out.
    pub s_corr_k: f64,
    /// 1 / W at the distance where the artificial pressure is k.
    pub s_corr_inverse_w: f64,
    /// An iteration moves a particle no further.
    pub max_correction_m: f64,
    /// Two particles closer than this, in h, part even below rest density.
    pub separation: f64,
    /// What is added to their lambdas at one point.
    pub separation_lambda: f64,
    /// Share of the last substep's pressure that the next one begins with.
    pub warm_start: f64,
}

/// What acts on velocities alone; see `ForceParams`. A coefficient of 0 leaves its force out.
#[derive(Clone, Copy, Debug, Default)]
pub struct Forces {
    /// XSPH viscosity.
    pub xsph: f64,
    /// Vorticity confinement, m/s.
    pub vorticity_m_s: f64,
}

/// Particles that do not interact; see `NoneParams`.
#[derive(Clone, Copy, Debug, Default)]
pub struct NonInteracting {
    /// How long a particle lives, s; 0: for ever.
    pub lifetime_s: f64,
    /// Share of it by which the shortest lives less.
    pub lifetime_variation: f64,
    /// Velocity decays as exp(-drag t).
    pub drag_per_s: f64,
    /// Share of the speed across a wall that a bounce gives back.
    pub restitution: f64,
}

impl NonInteracting {
    /// How long the particle of an id lives, s.
    pub fn lifetime_of_s(&self, id: u32) -> f64 {
        let even = f64::from(id.wrapping_mul(2_654_435_769) >> 8) / f64::from(1 << 24);
        self.lifetime_s * (1.0 - self.lifetime_variation * even)
    }
}
