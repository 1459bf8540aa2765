//! What a measurement says, by name and unit: for captures, tables and plots.

use std::borrow::Cow;

use crate::measure::Stats;
use crate::scene::{Scene, measured_solids};
use crate::session::SessionReport;

/// One value of a measurement.
#[derive(Clone, Copy, Debug)]
pub struct StatField {
    /// Its name.
    pub name: &'static str,
    /// Its unit; `1`: none.
    pub unit: &'static str,
    /// What it is.
    pub description: &'static str,
    /// Where it is in a measurement.
    pub value: fn(&Stats) -> f64,
    /// Whether it tells of densities, which particles that do not interact have none of.
    pub of_density: bool,
}

const fn field(
    name: &'static str,
    unit: &'static str,
    description: &'static str,
    value: fn(&Stats) -> f64,
) -> StatField {
    StatField { name, unit, description, value, of_density: false }
}

const fn density(
    name: &'static str,
    unit: &'static str,
    description: &'static str,
    value: fn(&Stats) -> f64,
) -> StatField {
    StatField { name, unit, description, value, of_density: true }
}

/// Every value of a measurement.
pub const STAT_FIELDS: &[StatField] = &[
    density("density_error_mean", "1", "Mean of |rho/rho0 - 1|", |s| s.density_error.mean),
    density("density_error_p99", "1", "99th percentile of |rho/rho0 - 1|", |s| s.density_error.p99),
    density("density_error_max", "1", "Largest |rho/rho0 - 1|", |s| s.density_error.max),
    density("compression_mean", "1", "Mean of max(rho/rho0 - 1, 0)", |s| s.compression.mean),
    density("compression_p99", "1", "99th percentile of max(rho/rho0 - 1, 0)", |s| s.compression.p99),
    density("compression_max", "1", "Largest rho/rho0 - 1", |s| s.compression.max),
    field("max_speed_m_s", "m/s", "Largest speed", |s| s.max_speed_m_s),
    field("kinetic_j", "J", "Kinetic energy", |s| s.kinetic_j),
    field("potential_j", "J", "Energy against gravity, from the domain's lowest corner", |s| s.potential_j),
    field("energy_j", "J", "Kinetic and potential energy", |s| s.kinetic_j + s.potential_j),
    field("centre_of_mass_x_m", "m", "Centre of mass along x", |s| s.centre_of_mass_m[0]),
    field("centre_of_mass_y_m", "m", "Centre of mass along y, up", |s| s.centre_of_mass_m[1]),
    field("centre_of_mass_z_m", "m", "Centre of mass along z", |s| s.centre_of_mass_m[2]),
    field("momentum_x_kg_m_s", "kg m/s", "Momentum along x", |s| s.momentum_kg_m_s[0]),
    field("momentum_y_kg_m_s", "kg m/s", "Momentum along y", |s| s.momentum_kg_m_s[1]),
    field("momentum_z_kg_m_s", "kg m/s", "Momentum along z", |s| s.momentum_kg_m_s[2]),
    field("front_m", "m", "Largest x of the fluid", |s| s.front_m),
    field("particles", "1", "Particles measured", |s| f64::from(s.particles)),
    field("quarantined", "1", "Particles whose state was not finite", |s| f64::from(s.quarantined)),
    field("escaped", "1", "Particles outside an open domain", |s| f64::from(s.escaped)),
    field("neighbour_overflow", "1", "Neighbours without a slot since the last measurement", |s| {
        f64::from(s.counters.neighbour_overflow)
    }),
    field("speed_clamps", "1", "Speeds clamped since the last measurement", |s| f64::from(s.counters.speed_clamps)),
    field("correction_clamps", "1", "Corrections clamped since the last measurement", |s| {
        f64::from(s.counters.correction_clamps)
    }),
    field("displacement_clamps", "1", "Displacements of a substep held below h since the last measurement", |s| {
        f64::from(s.counters.displacement_clamps)
    }),
    field("crowded", "1", "Searches among too many candidates to look at all since the last measurement", |s| {
        f64::from(s.counters.crowded)
    }),
    field("long_substeps", "1", "Substeps longer than an explicit solver's limit since the last measurement", |s| {
        f64::from(s.counters.long_substeps)
    }),
    field("density_iterations", "1", "Iterations of density solves since the last measurement", |s| {
        f64::from(s.counters.density_iterations)
    }),
    field("divergence_iterations", "1", "Iterations of divergence solves since the last measurement", |s| {
        f64::from(s.counters.divergence_iterations)
    }),
    field("unsolved", "1", "Pressure solves that ended above their tolerance since the last measurement", |s| {
        f64::from(s.counters.unsolved)
    }),
    field("emitted", "1", "Particles that emitters emitted since the last measurement", |s| {
        f64::from(s.counters.emitted)
    }),
    field("drained", "1", "Particles that drains took or whose lifetime ended since the last measurement", |s| {
        f64::from(s.counters.drained)
    }),
    field("capacity_overflow", "1", "Particles for which no slot was free since the last measurement", |s| {
        f64::from(s.counters.capacity_overflow)
    }),
    field("diffuse_spawned", "1", "Diffuse particles that were spawned since the last measurement", |s| {
        f64::from(s.counters.diffuse_spawned)
    }),
    field(
        "diffuse_ended",
        "1",
        "Diffuse particles whose lifetime ended or that left since the last measurement",
        |s| f64::from(s.counters.diffuse_ended),
    ),
    field("diffuse_overwritten", "1", "Diffuse particles that younger ones took the slot of, likewise", |s| {
        f64::from(s.counters.diffuse_overwritten)
    }),
    field("diffuse_dropped", "1", "Diffuse particles for which a step had no slot left, likewise", |s| {
        f64::from(s.counters.diffuse_dropped)
    }),
];

/// What a capture tells of a measurement (`/sim/stats`): name, unit and description of each value, first those that
/// say which step it was and when in the simulation, last the force on each solid whose force is measured.
pub fn captured_fields(scene: &Scene) -> impl Iterator<Item = (Cow<'static, str>, &'static str, &'static str)> {
    let clock = [("step", "1", "Number of the step that was measured"), ("simulated_s", "s", "Simulated time")];
    let has_density = scene.solver.method.interacts();
    let fields = STAT_FIELDS.iter().filter(move |field| has_density || !field.of_density);
    let of_fluid = clock.into_iter().chain(fields.map(|field| (field.name, field.unit, field.description)));
    let forces = measured_solids(scene).flat_map(|solid| {
        let force = move |axis| format!("solid_{solid}_force_{axis}_n");
        ["x", "y", "z"]
            .map(|axis| (force(axis).into(), "N", "Mean force of the fluid on the solid since the last measurement"))
    });
    of_fluid.map(|(name, unit, description)| (name.into(), unit, description)).chain(forces)
}

/// The values of [`captured_fields`], in their order; none of a report that brought no measurement.
pub fn captured_values(report: &SessionReport) -> Option<Vec<f64>> {
    let stats = report.stats.as_ref()?;
    let clock = [report.steps as f64, report.simulated_s];
    let fields = STAT_FIELDS.iter().filter(|field| stats.has_density || !field.of_density);
    let of_fluid = clock.into_iter().chain(fields.map(|field| (field.value)(stats)));
    Some(of_fluid.chain(report.forces_n.iter().flatten().copied()).collect())
}

#[cfg(test)]
mod tests {
    use brooklet_gpu::{FrameReport, TimingStatus};

    use super::*;

    #[test]
    fn fields_and_values_go_together() {
        let mut stats = Stats { has_density: true, front_m: 1.5, ..Stats::default() };
        let scene = Scene::load(
            "dam-break",
            &["solid=[{ sphere = { radius_m = 0.3 } }, { box = { size_m = [1, 1, 1] }, measure_force = true }]".into()],
        )
        .unwrap();
        stats.compression.max = 0.25;
        stats.counters.speed_clamps = 7;
        let report = FrameReport {
            frame: 0,
            wall_ns: 0,
            spans: Vec::new(),
            dropped_spans: 0,
            readbacks: Vec::new(),
            timing: TimingStatus::Off,
            timestamp_period_ns: 1.0,
        };
        let mut told =
            SessionReport { report, steps: 12, simulated_s: 0.05, stats: None, forces_n: vec![[1.0, 2.0, 3.0]] };
        assert!(captured_values(&told).is_none());
        told.stats = Some(stats);
        let values = captured_values(&told).unwrap();
        assert_eq!(captured_fields(&scene).count(), values.len());
        let value = |wanted: &str| values[captured_fields(&scene).position(|(name, ..)| name == wanted).unwrap()];
        assert_eq!(value("step"), 12.0);
        assert_eq!(value("simulated_s"), 0.05);
        assert_eq!(value("compression_max"), 0.25);
        assert_eq!(value("front_m"), 1.5);
        assert_eq!(value("speed_clamps"), 7.0);
        assert_eq!(["solid_1_force_x_n", "solid_1_force_y_n", "solid_1_force_z_n"].map(value), [1.0, 2.0, 3.0]);
    }
}
