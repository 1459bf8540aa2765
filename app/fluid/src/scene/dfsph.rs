//! What divergence-free SPH takes.

use serde::{Deserialize, Serialize};

/// Settings of `method = "dfsph"`. A solve without iterations leaves no pass of it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct DfsphSettings {
    /// Mean residual at which a substep's divergence solve ends: of the density ratio, by what velocities would make particles
    /// too dense in the substep, or pressure keeps them too thin.
    pub divergence_tolerance: f64,
    /// The same of the density solve: of what is left of the compression that it takes out.
    pub density_tolerance: f64,
    /// Most iterations of a substep's divergence solve, which is the fluid's pressure. Solves that end here above their
    /// tolerance are counted.
    pub max_divergence_iterations: u32,
    /// Most iterations of its density solve, which takes half of what compression there is out of the positions and leaves
    /// the velocities; 0 leaves it out.
    pub max_density_iterations: u32,
    /// Whether the solves begin with the pressures that the last substep's ended with.
    pub warm_start: bool,
    /// Whether both solves do as many iterations as they may, whatever is left: nothing is measured for them and nothing is
    /// dispatched indirectly, as slow devices like it. Tolerances then mean nothing.
    pub fixed_iterations: bool,
    /// Share of what an iteration added to pressures that the next one adds again, as Chebyshev's semi-iteration does in the
    /// limit: 0 is plain Jacobi.
    pub momentum: f64,
}

impl Default for DfsphSettings {
    fn default() -> Self {
        Self {
            divergence_tolerance: 3.0e-4,
            density_tolerance: 1.0e-3,
            max_divergence_iterations: 30,
            max_density_iterations: 20,
            warm_start: true,
            fixed_iterations: false,
            momentum: 0.4,
        }
    }
}
