//! What a scene's values may be: each within its limits, and all of them together.

mod bodies;
mod diffuse;
mod emitters;
mod faces;
mod forms;
mod solids;
mod sph;
mod surface;

use std::fmt::Display;

use toml::Value;

use super::explain::written;
use super::field::{Kind, Short};
use super::fields::kind_of;
use super::fill::{self, MAX_FLUIDS, MAX_PARTICLES};
use super::paths::as_number;
use super::{Acceleration, Fluid, Method, PointColor, Scene, SceneError};
use crate::solver::pbf::{IterationWeights, MAX_CELLS, MOST_WARM_START, are_few_cells, finest_cells, narrow_axis};

/// Spacings a side of the domain may have: f32 positions then still tell 1/256 of a spacing apart.
const MAX_SPACINGS_A_SIDE: f64 = 65_536.0;
/// Least support over spacing with which surface tension holds a drop together.
const LEAST_TENSION_RATIO: f64 = 3.0;
/// Substeps a step may have.
const MAX_SUBSTEPS: f64 = 1000.0;
/// Solver iterations a step may have. Each is two dispatches of the step's recording, which is
/// kept whole.
const MAX_ITERATIONS_A_STEP: u32 = 10_000;

struct Checker<'a> {
    source_name: &'a str,
}

impl Checker<'_> {
    fn require(&self, ok: bool, field: &str, value: impl Display, allowed: impl Display) -> Result<(), SceneError> {
        if ok {
            return Ok(());
        }
        Err(SceneError::NotAllowed {
            source_name: self.source_name.into(),
            place: String::new(),
            field: field.into(),
            value: value.to_string(),
            allowed: allowed.to_string(),
        })
    }

    /// Every number of `value` within the limits of its field.
    fn limits(&self, field: &str, value: &Value) -> Result<(), SceneError> {
        match (kind_of(field), value) {
            (Some(kind @ (Kind::Number(limits) | Kind::Whole(limits))), number) => {
                self.require(as_number(number).is_some_and(|n| limits.hold(n)), field, written(number), kind)
            }
            (Some(kind @ Kind::Vector(limits)), Value::Array(items)) => {
                let ok = items.iter().all(|item| as_number(item).is_some_and(|n| limits.hold(n)));
                self.require(ok, field, written(value), kind)
            }
            (Some(Kind::Vectors(limits)), Value::Array(points)) => {
                let outside = points.iter().position(|point| {
                    let numbers = point.as_array().into_iter().flatten();
                    !numbers.map(as_number).all(|n| n.is_some_and(|n| limits.hold(n)))
                });
                let kind = Kind::Vector(limits);
                outside.map_or(Ok(()), |at| {
                    self.require(false, field, written(&points[at]), format_args!("point {at} {kind}"))
                })
            }
            (_, Value::Table(table)) => table.iter().try_for_each(|(key, value)| match field {
                "" => self.limits(key, value),
                _ => self.limits(&format!("{field}.{key}"), value),
            }),
            (_, Value::Array(items)) => {
                items.iter().enumerate().try_for_each(|(index, item)| self.limits(&format!("{field}.{index}"), item))
            }
            _ => Ok(()),
        }
    }

    fn ordered(&self, field: &str, min: [f64; 3], max: [f64; 3]) -> Result<(), SceneError> {
        let ok = (0..3).all(|axis| max[axis] > min[axis]);
        let allowed = format_args!("must be above min_m = {} along each axis", numbers(min));
        self.require(ok, &format!("{field}.max_m"), numbers(max), allowed)
    }
}

/// `[0, 0.5, 1]`
fn numbers(values: [f64; 3]) -> String {
    let [x, y, z] = values.map(Short);
    format!("[{x}, {y}, {z}]")
}

/// `value` without the last digits, which are a subtraction's.
fn tidied(value: f64) -> f64 {
    format!("{value:.9e}").parse().unwrap_or(value)
}

/// `value`, rounded up to three figures: what an error suggests must be enough.
fn rounded_up(value: f64) -> Short {
    let unit = 10f64.powf(value.log10().floor() - 2.0);
    // Through text: 0.13 is to be 0.13, not 0.13000000000000001.
    let up = format!("{:.2e}", ((value / unit).ceil() * unit));
    Short(up.parse().unwrap_or(value))
}

impl Scene {
    pub(super) fn check(&self, source_name: &str) -> Result<(), SceneError> {
        let check = Checker { source_name };
        let values = Value::try_from(self).map_err(|error| SceneError::Malformed {
            source_name: source_name.into(),
            place: String::new(),
            reason: error.to_string(),
        })?;
        check.limits("", &values)?;
        self.check_domain(&check)?;
        self.check_axes(&check)?;
        self.check_faces(&check)?;
        self.check_wall(&check)?;
        self.check_solids(&check)?;
        match self.solver.method {
            Method::Pbf => {
                self.check_iterations(&check, self.solver.pbf.iterations, "solver.pbf.iterations")?;
                self.check_relaxation(&check)?;
                self.check_coarse_correction(&check)?;
                self.check_warm_start(&check)?;
            }
            Method::Sph => self.check_sph(&check)?,
            Method::Dfsph => {
                let settings = &self.solver.dfsph;
                for (most, field) in [
                    (settings.max_divergence_iterations, "solver.dfsph.max_divergence_iterations"),
                    (settings.max_density_iterations, "solver.dfsph.max_density_iterations"),
                ] {
                    self.check_iterations(&check, most, field)?;
                }
                if settings.coarse_correction == Some(true) {
                    self.check_coarse_grid(&check, "solver.dfsph.coarse_correction")?;
                }
            }
            Method::None => check.require(
                self.surface.color_by != PointColor::Density,
                "surface.color_by",
                "\"density\"",
                "not with solver.method = \"none\": particles that do not interact have no density",
            )?,
        }
        let most_fluids = MAX_FLUIDS as usize;
        check.require(
            self.fluids.len() <= most_fluids,
            "fluid",
            format_args!("{} fluids", self.fluids.len()),
            format_args!("at most {most_fluids}: a particle's tag has 7 bits for its fluid"),
        )?;
        for (index, fluid) in self.fluids.iter().enumerate() {
            self.check_fluid(&check, &format!("fluid.{index}"), fluid)?;
        }
        self.check_emitters(&check)?;
        self.check_drains(&check)?;
        self.check_diffuse(&check)?;
        self.check_surface(&check)?;
        self.check_count(&check)?;
        if let Some(camera) = &self.camera {
            let squared_m2: f64 = (0..3).map(|axis| (camera.eye_m[axis] - camera.target_m[axis]).powi(2)).sum();
            check.require(
                squared_m2 > 1.0e-12,
                "camera.eye_m",
                numbers(camera.eye_m),
                format_args!("must be away from target_m = {}", numbers(camera.target_m)),
            )?;
        }
        Ok(())
    }

    /// Not more iterations a step than a recording holds; `field` says how many a substep has.
    fn check_iterations(&self, check: &Checker, iterations: u32, field: &str) -> Result<(), SceneError> {
        let substeps = self.solver.substeps;
        check.require(
            substeps.saturating_mul(iterations) <= MAX_ITERATIONS_A_STEP,
            field,
            iterations,
            format_args!(
                "with solver.substeps = {substeps} that is {} iterations a step; at most {MAX_ITERATIONS_A_STEP}: \
                 a smaller solver.dt_s does the same as more substeps",
                substeps.saturating_mul(iterations)
            ),
        )
    }

    /// A weight that Jacobi iterations are stable with, where the scene asks for more than those.
    fn check_relaxation(&self, check: &Checker) -> Result<(), SceneError> {
        let pbf = &self.solver.pbf;
        let (Some(relaxation), Acceleration::Chebyshev) = (pbf.relaxation, pbf.acceleration) else { return Ok(()) };
        let limit = self.relaxation_limit();
        let theory = match pbf.iterations {
            n if n % 2 == 0 => "2/lambda_max".to_owned(),
            1 => "4/(3 lambda_max)".to_owned(),
            n => format!("(1 + 3^(-1/{n}))/lambda_max"),
        };
        check.require(
            relaxation < limit,
            "solver.pbf.relaxation",
            Short(relaxation),
            format_args!(
                "must be below {limit:.3} with solver.pbf.acceleration = \"chebyshev\": Jacobi with \
                 solver.pbf.iterations = {} is stable below {theory}, of the kernel's spectrum on the lattice at \
                 solver.support_ratio = {} in {} dimensions",
                pbf.iterations,
                Short(self.solver.support_ratio),
                self.domain.dimensions
            ),
        )
    }

    /// A share that no mode grows with, and iterations that hold it against what they find.
    fn check_warm_start(&self, check: &Checker) -> Result<(), SceneError> {
        let pbf = &self.solver.pbf;
        if pbf.warm_start == 0.0 {
            return Ok(());
        }
        check.require(
            pbf.warm_start <= MOST_WARM_START,
            "solver.pbf.warm_start",
            Short(pbf.warm_start),
            format_args!(
                "at most {MOST_WARM_START}: energy was measured to rise at 0.4, and slow modes grow from 0.5 on"
            ),
        )?;
        check.require(
            IterationWeights::of(self).chebyshev.is_some(),
            "solver.pbf.warm_start",
            Short(pbf.warm_start),
            format_args!(
                "not with solver.pbf.acceleration = \"{}\" and solver.pbf.iterations = {}: it needs iterations with \
                 momentum, two a substep at least, three in two dimensions",
                pbf.acceleration.name(),
                pbf.iterations
            ),
        )
    }

    /// Iterations that take back what a coarse correction overshoots, and cells for it.
    fn check_coarse_correction(&self, check: &Checker) -> Result<(), SceneError> {
        let pbf = &self.solver.pbf;
        if pbf.coarse_correction != Some(true) {
            return Ok(());
        }
        check.require(
            IterationWeights::of(self).chebyshev.is_some(),
            "solver.pbf.coarse_correction",
            "true",
            format_args!(
                "not with solver.pbf.acceleration = \"{}\" and solver.pbf.iterations = {}: it needs iterations with \
                 momentum, two a substep at least, three in two dimensions",
                pbf.acceleration.name(),
                pbf.iterations
            ),
        )?;
        self.check_coarse_grid(check, "solver.pbf.coarse_correction")
    }

    /// Cells that fit the domain, where `field` asks for them.
    fn check_coarse_grid(&self, check: &Checker, field: &str) -> Result<(), SceneError> {
        let cell_m = Short(tidied(2.0 * self.support_m()));
        let narrow = narrow_axis(self);
        check.require(
            narrow.is_none(),
            field,
            "true",
            format_args!(
                "the domain is narrower along {} than a cell of 2 h = {cell_m} m",
                ["x", "y", "z"][narrow.unwrap_or_default()]
            ),
        )?;
        let [x, y, z] = finest_cells(self);
        check.require(
            are_few_cells([x, y, z]),
            field,
            "true",
            format_args!(
                "the domain has {x} x {y} x {z} cells of 2 h = {cell_m} m, and {MAX_CELLS} fit: make it smaller, or \
                 spacing_m more"
            ),
        )
    }

    fn check_domain(&self, check: &Checker) -> Result<(), SceneError> {
        check.ordered("domain", self.domain.min_m, self.domain.max_m)?;
        let (spacing_m, size_m) = (self.spacing_m, self.domain.size_m());
        let sides = numbers(size_m.map(tidied));
        check.require(
            // A hair of tolerance: 1.05 - 1 is less than 0.05.
            size_m.iter().all(|&side_m| side_m >= (1.0 - 1.0e-6) * spacing_m),
            "domain",
            format_args!("{sides} m in size"),
            format_args!("each side must be at least spacing_m = {}", Short(spacing_m)),
        )?;
        let longest_m = size_m.into_iter().fold(0.0, f64::max);
        check.require(
            longest_m <= MAX_SPACINGS_A_SIDE * spacing_m,
            "domain",
            format_args!("{sides} m in size"),
            format_args!(
                "a side of it may have {MAX_SPACINGS_A_SIDE} spacings: make it smaller, or spacing_m {} or more",
                rounded_up(longest_m / MAX_SPACINGS_A_SIDE)
            ),
        )
    }

    /// What is asked of single axes.
    fn check_axes(&self, check: &Checker) -> Result<(), SceneError> {
        let domain = &self.domain;
        let periodic = format!("{:?}", domain.periodic);
        let [gx, gy, gz] = self.gravity_m_s2;
        if domain.is_flat() {
            check.require(!domain.periodic[2], "domain.periodic", &periodic, "two dimensions have no axis z")?;
            let allowed = "must be 0 along z with domain.dimensions = 2";
            check.require(gz == 0.0, "gravity_m_s2", numbers([gx, gy, gz]), allowed)?;
        }
        let unit_m = self.period_unit_m();
        for axis in (0..3).filter(|&axis| domain.periodic[axis]) {
            let side_m = domain.size_m()[axis];
            let below = (side_m / unit_m).floor().max(1.0);
            let tolerance_m = 1.0e-6 * self.spacing_m;
            check.require(
                (side_m - self.period_m()[axis]).abs() <= tolerance_m,
                "domain.periodic",
                &periodic,
                format_args!(
                    "a periodic side must be a whole multiple of 4 h = 4 * spacing_m * solver.support_ratio = {} m: \
                     that along {} is {} m, {} or {} would do",
                    Short(tidied(unit_m)),
                    ["x", "y", "z"][axis],
                    Short(tidied(side_m)),
                    Short(tidied(below * unit_m)),
                    Short(tidied((below + 1.0) * unit_m)),
                ),
            )?;
        }
        Ok(())
    }

    /// No more particles than ids, and no more neighbour slots than u32 counts.
    fn check_count(&self, check: &Checker) -> Result<(), SceneError> {
        let estimate = self.fluids.iter().map(|fluid| fluid.lattice_cells(self)).sum::<f64>();
        let most = f64::from(MAX_PARTICLES);
        // Counting is exact, and takes a while where there are many more than fit.
        let count = if estimate > 2.0 * most { estimate } else { fill::count(self) as f64 };
        check.require(
            count <= most,
            "spacing_m",
            Short(self.spacing_m),
            format_args!(
                "makes {count:.3e} particles, and {MAX_PARTICLES} fit, as many as ids have 24 bits for: \
                 make it {} or more, or the fluid less",
                rounded_up(1.01 * self.spacing_m * (count / most).powf(1.0 / f64::from(self.domain.dimensions)))
            ),
        )?;
        let emitted = self.most_particles();
        check.require(
            self.capacity.is_some() || emitted <= most,
            "emitter",
            format_args!("{emitted:.3e} particles in outputs.seconds = {}", Short(self.outputs.seconds)),
            format_args!("{MAX_PARTICLES} fit: give it a capacity, an end_s or a lifetime_s"),
        )?;
        if let Some(capacity) = self.capacity {
            check.require(
                f64::from(capacity) >= count,
                "capacity",
                capacity,
                format_args!("must be {count} or more, as many particles as the scene begins with"),
            )?;
        }
        let count = count.max(self.slot_capacity().map_or(0.0, f64::from));
        let slots = f64::from(self.neighbour_slots());
        check.require(
            count * slots <= f64::from(u32::MAX),
            "solver.neighbour_slots",
            slots,
            format_args!(
                "{count} particles can have {} at most: a list is numbered with 32 bits",
                (f64::from(u32::MAX) / count).floor()
            ),
        )
    }

    fn check_fluid(&self, check: &Checker, field: &str, fluid: &Fluid) -> Result<(), SceneError> {
        check.require(
            fluid.rest_density_kg_m3 == self.rest_density_kg_m3(),
            &format!("{field}.rest_density_kg_m3"),
            fluid.rest_density_kg_m3,
            format_args!(
                "must be that of fluid.0, {}: fluids of different densities are not there yet",
                self.rest_density_kg_m3()
            ),
        )?;
        let shapes = [
            ("block", fluid.block.is_some()),
            ("sphere", fluid.sphere.is_some()),
            ("cylinder", fluid.cylinder.is_some()),
        ];
        let given: Vec<&str> = shapes.into_iter().filter_map(|(name, is_given)| is_given.then_some(name)).collect();
        let [shape] = given[..] else {
            let value = if given.is_empty() { "nothing".to_owned() } else { format!("a {}", given.join(" and a ")) };
            return check.require(false, field, value, "give it one of `block`, `sphere` and `cylinder`");
        };
        let shape = format!("{field}.{shape}");
        let (min, max) = fluid.bounds_m();
        check.ordered(&shape, min, max)?;
        let allowed = "must be 0 along z with domain.dimensions = 2";
        check.require(
            !self.domain.is_flat() || fluid.velocity_m_s[2] == 0.0,
            &format!("{field}.velocity_m_s"),
            numbers(fluid.velocity_m_s),
            allowed,
        )?;
        check.require(
            !self.domain.is_flat() || fluid.velocity_spread_m_s[2] == 0.0,
            &format!("{field}.velocity_spread_m_s"),
            numbers(fluid.velocity_spread_m_s),
            allowed,
        )?;
        // A hair of tolerance: 0.1 + 0.2 is above 0.3.
        let slack_m = 1.0e-6 * self.spacing_m;
        let domain = &self.domain;
        // A flat domain's depth has no meaning, and a disc in it is a ball of more.
        let inside = (0..domain.dimensions as usize)
            .all(|axis| min[axis] >= domain.min_m[axis] - slack_m && max[axis] <= domain.max_m[axis] + slack_m);
        check.require(
            inside,
            &shape,
            format_args!("{} to {}", numbers(min), numbers(max)),
            format_args!("must lie inside the domain, {} to {}", numbers(domain.min_m), numbers(domain.max_m)),
        )?;
        check.require(
            fill::fits(fluid, self),
            &shape,
            format_args!("{} to {}", numbers(min), numbers(max)),
            match domain.is_flat() {
                false => format!(
                    "has no room for a particle: each side must be at least spacing_m = {}",
                    Short(self.spacing_m)
                ),
                true => format!(
                    "has no room for a particle: along x and y each side must be at least spacing_m = {}, and the \
                     plane z = {} of the two dimensions must cut it",
                    Short(self.spacing_m),
                    Short(tidied(domain.plane_z_m()))
                ),
            },
        )
    }
}

impl Fluid {
    /// About how many points of the scene's lattice it has.
    fn lattice_cells(&self, scene: &Scene) -> f64 {
        use std::f64::consts::PI;
        let dimensions = scene.domain.dimensions;
        let block = self
            .block
            .as_ref()
            .map(|b| (0..dimensions as usize).map(|axis| (b.max_m[axis] - b.min_m[axis]) / scene.spacing_m).product());
        let sphere = self.sphere.as_ref().map(|s| {
            let radius = s.radius_m / scene.spacing_m;
            if scene.domain.is_flat() { PI * radius.powi(2) } else { 4.0 / 3.0 * PI * radius.powi(3) }
        });
        let cylinder = self.cylinder.as_ref().map(|c| {
            let [radius, length] = [c.radius_m, c.length_m].map(|m| m / scene.spacing_m);
            length * if scene.domain.is_flat() { 2.0 * radius } else { PI * radius.powi(2) }
        });
        block.or(sphere).or(cylinder).unwrap_or(0.0)
    }
}
