//! How many bytes a pass moves: the model, in one place.
//!
//! Compulsory bytes are those that no cache can save: each storage buffer that a dispatch binds,
//! once. Of the neighbour list only the slots in use count. A buffer that is read and written
//! counts once too, because a binding does not say whether the old content matters.
//!
//! Gathered bytes come on top: one element of each buffer in [`GATHERS`] for each neighbour in the
//! list. Sorted particles have most of them in a cache, so they load the caches, not the memory.
//! `list_neighbours` also looks at particles that it does not list; those are its own cost, not
//! part of the bound.
//!
//! What they bound: [`crate::bounds`].

use brooklet_gpu::{Command, Plan, RecordingId, ResourceId, Shape};
use brooklet_kernels::BindingKind;
use serde::Serialize;

/// The buffers that a stage reads at its neighbours, by the bindings' names; of those, the ones
/// that the variant binds.
const GATHERS: &[(&str, &[&str])] = &[
    ("list_neighbours", &["quantized_positions"]),
    ("constrain_density", &["quantized_positions"]),
    ("correct_positions", &["position_lambdas", "packed_position_lambdas"]),
    ("curl", &["quantized_positions", "velocities"]),
    ("confine_vorticity", &["quantized_positions", "vorticities"]),
    ("xsph", &["quantized_positions", "velocities"]),
    ("compute_density", &["quantized_positions"]),
    ("accelerate", &["quantized_positions", "velocity_pressures", "velocity_pressure_normals"]),
    ("factor_pressure", &["quantized_positions"]),
    ("correct_pressure", &["quantized_positions", "velocities"]),
    ("apply_pressure", &["quantized_positions", "pressure_changes"]),
    ("measure_particles", &["positions"]),
    ("anisotropy", &["positions"]),
    ("density_ratios", &["positions"]),
    ("crest_normals", &["positions"]),
    ("count_spawned", &["positions", "velocities", "crest_normals"]),
];

/// Name of the binding that is the neighbour list.
const LIST: &str = "neighbours";
/// Bytes of a neighbour in the list.
const LISTED_BYTES: u64 = 2;

/// Bytes that a stage moves in one run of its recording.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Traffic {
    /// Every buffer once a dispatch.
    pub compulsory_bytes: u64,
    /// What is read of the neighbours, on top.
    pub gathered_bytes: u64,
}

/// All dispatches of `stage` in `recording` together, where all particles have `neighbours`
/// neighbours together.
pub fn of(plan: &Plan, recording: RecordingId, stage: &str, neighbours: u64) -> Traffic {
    let gathers = GATHERS.iter().find(|(name, _)| *name == stage).map_or(&[][..], |(_, gathers)| gathers);
    let mut traffic = Traffic::default();
    for command in plan.commands(recording) {
        let Command::Dispatch(dispatch) = command else { continue };
        if dispatch.stage != stage {
            continue;
        }
        // Variants without the list gather nothing.
        let is_listed = dispatch.bindings.iter().any(|bound| bound.info.name == LIST);
        for bound in &dispatch.bindings {
            let (BindingKind::Storage { .. }, Some(id)) = (bound.info.kind, bound.resource) else { continue };
            let bytes = plan.resources().bytes(id);
            traffic.compulsory_bytes += match bound.info.name {
                LIST => neighbours * LISTED_BYTES,
                _ => bytes,
            };
            let shape = plan.resources().get(id).map(|entry| entry.shape);
            if let Some(Shape::Buffer { stride_bytes, .. }) = shape
                && gathers.contains(&bound.info.name)
                && is_listed
            {
                traffic.gathered_bytes += neighbours * u64::from(stride_bytes);
            }
        }
    }
    traffic
}

/// Bytes that `stage` moves in one run of `recording` at least, draws included: every buffer and texture that it
/// binds and every target, once for each time it runs. Of a texture less may be read, where little is covered.
pub fn drawn_bytes(plan: &Plan, recording: RecordingId, stage: &str) -> u64 {
    let bytes_of =
        |ids: &mut dyn Iterator<Item = ResourceId>| -> u64 { ids.map(|id| plan.resources().bytes(id)).sum() };
    let commands = plan.commands(recording).iter().map(|command| match command {
        Command::Dispatch(dispatch) if dispatch.stage == stage => {
            bytes_of(&mut dispatch.bindings.iter().filter_map(|bound| bound.resource))
        }
        Command::Draw(draw) if draw.stage == stage => {
            let bound = draw.bindings.iter().filter_map(|bound| bound.resource);
            let color = draw.targets.color.iter().map(|(id, _)| *id);
            bytes_of(&mut bound.chain(color).chain(draw.targets.depth.map(|(id, _)| id)))
        }
        _ => 0,
    });
    commands.sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::workload::{LOADS, plan};
    use brooklet_kernels::{Counters, modules};
    use std::collections::BTreeSet;

    #[test]
    fn bytes_of_known_passes() {
        let scene = LOADS[2].scene(16, &[]).unwrap();
        let planned = plan(&scene).unwrap();
        let n = u64::from(planned.slot_count());
        let step = planned.recorded.step.id();
        let measure = planned.recorded.measure.as_ref().unwrap().recording.id();
        let kept = planned.plan.buffers();
        let bytes = |labels: &[&str]| -> u64 {
            labels.iter().map(|label| kept.iter().find(|buffer| buffer.label == *label).unwrap().bytes).sum()
        };
        // 4 iterations; what is bound once each, of the list what is in use, and 8 bytes of each neighbour's place; the
        // first also sums up for the coarse grid.
        let constrain = of(&planned.plan, step, "constrain_density", 27 * n);
        let once = bytes(&["quantized_positions", "sorted_positions", "list_heads", "position_lambdas"]);
        assert_eq!(constrain.compulsory_bytes, 4 * (once + 2 * 27 * n) + bytes(&["coarse_cells_0"]));
        assert_eq!(constrain.gathered_bytes, 4 * 27 * n * 8);
        // Nothing is gathered where nothing is listed.
        let update = of(&planned.plan, step, "update_velocity", 27 * n);
        assert_eq!(update, Traffic { compulsory_bytes: n * 56 + size_of::<Counters>() as u64, gathered_bytes: 0 });
        assert!(of(&planned.plan, measure, "measure_particles", 27 * n).gathered_bytes > 0);
        assert_eq!(of(&planned.plan, measure, "constrain_density", 27 * n), Traffic::default());
    }

    #[test]
    fn every_pass_that_reads_the_list_is_in_the_model() {
        let stage = |name: &str| {
            let kernel = name.split('+').next().unwrap();
            let words =
                kernel.chars().map(|c| if c.is_uppercase() { format!("_{}", c.to_lowercase()) } else { c.to_string() });
            words.collect::<String>().trim_start_matches('_').to_string()
        };
        let mut seen = BTreeSet::new();
        for module in modules() {
            let has = |name: &str| module.bindings.iter().any(|binding| binding.name == name);
            let known = GATHERS.iter().find(|(name, _)| *name == stage(module.name));
            if !has(LIST) {
                continue;
            }
            let (name, gathers) = known.unwrap_or_else(|| panic!("{} reads the list", module.name));
            assert!(gathers.iter().any(|gathered| has(gathered)), "{} binds none of {gathers:?}", module.name);
            seen.insert(*name);
        }
        assert_eq!(seen.len(), GATHERS.len(), "only {seen:?} exist");
    }
}
