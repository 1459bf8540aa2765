//! `forces/apply_fields` against its twin.

use crate::bench::Bench;
use crate::cases::{fluid, out_of_part, sizes};
use crate::compare::{ROUNDING, Worst, vector};
use crate::device::Device;
use crate::numbers::rng;
use crate::wrong::{OrRaise as _, Wrong, ensure, ensure_eq};
use brooklet_fluid::particles::is_simulated;
use brooklet_fluid::visit_slots;
use brooklet_kernels::{ApplyFields, ForceField, ForceFieldCount, Kernel as _, StepState, Velocity};
use brooklet_reference::forces::apply_fields::{self as twin, fields_at};

const TIME_S: f32 = 1.25;
const DT_S: f32 = 0.01;

fn fields() -> Vec<ForceField> {
    let always = ForceField { end_s: f32::MAX, ..ForceField::default() };
    vec![
        ForceField { acceleration_m_s2: [1.0, -3.0, 0.5], ..always },
        ForceField { swirl_per_s2: [0.0, 40.0, 3.0], centre_m: [0.1, 0.0, 0.2], frequency_hz: 0.7, ..always },
        ForceField { acceleration_m_s2: [500.0, 0.0, 0.0], begin_s: 2.0, ..always },
        ForceField { acceleration_m_s2: [0.0, 500.0, 0.0], end_s: 1.0, ..always },
    ]
}

fn twin_of(field: &ForceField) -> twin::ForceField {
    twin::ForceField {
        acceleration_m_s2: vector(field.acceleration_m_s2),
        swirl_per_s2: vector(field.swirl_per_s2),
        centre_m: vector(field.centre_m),
        frequency_hz: field.frequency_hz.into(),
        begin_s: field.begin_s.into(),
        end_s: field.end_s.into(),
    }
}

/// A velocity is a sum of products; Vulkan promises a cosine to 2^-11 of 1 within one turn.
const TOLERANCE: f64 = 16.0 * ROUNDING;
const COSINE: f64 = 1.0 / 2048.0;

fn check(device: &Device, worst: &mut Worst, size: usize, expected_of: &[ForceField]) -> Result<(), Wrong> {
    let mut case = fluid(&mut rng(121), size);
    for (i, position) in case.positions.iter_mut().enumerate() {
        position.tag |= out_of_part(i);
    }
    let given = fields();
    let mut bench = Bench::new(device);
    let positions = bench.input("positions", &case.positions);
    let field_buffer = bench.input("fields", &given);
    let mut velocities = bench.input("velocities", &case.velocities);
    let count = ForceFieldCount { fields: given.len() as u32, ..ForceFieldCount::default() };
    let count = bench.uniform("field_count", count);
    let state = StepState { time_s: TIME_S, dt_s: DT_S, ..visit_slots(size as u32) };
    let state = bench.uniform("step_state", state);
    bench.dispatch(
        &ApplyFields {
            positions: positions.read(),
            fields: field_buffer.read(),
            velocities: velocities.write(),
            step_state: state.uniform(),
            field_count: count.uniform(),
        },
        size,
    );
    let got: Vec<Velocity> = bench.run().read(&velocities, size);
    let expected_of: Vec<twin::ForceField> = expected_of.iter().map(twin_of).collect();
    for (i, got) in got.iter().enumerate() {
        let before = vector(case.velocities[i].velocity_m_s);
        if !is_simulated(case.positions[i].tag) {
            ensure_eq!(got.velocity_m_s, case.velocities[i].velocity_m_s);
            continue;
        }
        let time_s = f64::from(TIME_S) - 0.5 * f64::from(DT_S);
        let taken = fields_at(&expected_of, vector(case.positions[i].position_m), time_s) * f64::from(DT_S);
        // 50 m/s^2 at most that swing.
        let scale = before.length() + taken.length() + 50.0 * f64::from(DT_S) * COSINE / TOLERANCE;
        worst.check3(got.velocity_m_s, before + taken, scale)?;
    }
    Ok(())
}

pub(crate) fn apply_fields_matches_its_twin(device: &Device) {
    let mut worst = device.worst(ApplyFields::STAGE, TOLERANCE);
    for size in sizes(device, ApplyFields::GROUP_SIZE[0] as usize) {
        check(device, &mut worst, size, &fields()).or_raise();
    }
    worst.report(device);
    for wrong in 0..fields().len() {
        let mut others = fields();
        match wrong {
            0 => others[0].acceleration_m_s2[1] = -3.2,
            1 => others[1].frequency_hz = 0.8,
            2 => others[2].begin_s = 1.0,
            _ => others[3].end_s = 3.0,
        }
        let passes = check(device, &mut Worst::new(ApplyFields::STAGE, TOLERANCE), 70, &others).is_ok();
        ensure!(!passes, "wrong field {wrong} passes");
    }
}
