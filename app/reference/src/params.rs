//! What the twins are told: the host-visible settings, in f64.

use glam::DVec3;

/// One substep; see `StepParams` of the shaders' layout.
#[derive(Clone, Copy, Debug)]
pub struct Step {
    /// Gravity, m/s^2.
    pub gravity_m_s2: DVec3,
    /// Length of the substep, s.
    pub dt_s: f64,
    /// The domain's size; its lowest corner is the origin.
    pub domain_size_m: DVec3,
    /// Whether the domain has walls.
    pub walls: bool,
    /// Particles stay at least this far from a wall.
    pub wall_offset_m: f64,
    /// Faster particles are slowed to this.
    pub max_speed_m_s: f64,
}

impl Step {
    /// Moves a position inside the walls, if there are any.
    pub fn inside(&self, position_m: DVec3) -> DVec3 {
        if !self.walls {
            return position_m;
        }
        let low = DVec3::splat(self.wall_offset_m);
        position_m.clamp(low, self.domain_size_m - low)
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

/// The smoothing kernel's scale; see `KernelParams`.
#[derive(Clone, Copy, Debug)]
pub struct Smoothing {
    /// Support radius, m.
    pub support_m: f64,
    /// 1 / sum of W over the initial lattice.
    pub weight: f64,
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
    /// XSPH viscosity.
    pub xsph: f64,
    /// Vorticity confinement, m/s.
    pub vorticity: f64,
    /// An iteration moves a particle no further.
    pub max_correction_m: f64,
    /// Two particles closer than this, in h, part even below rest density.
    pub separation: f64,
}
