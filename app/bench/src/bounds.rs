//! What bounds a pass: the least time that each of the device's rates leaves it, and which of them is nearest.

use brooklet_gpu::{Command, Plan, RecordingId};
use serde::Serialize;

use crate::{rates::Rates, traffic::Traffic};

/// Arithmetic a pass does for each listed neighbour and dispatch, in instructions of a multiplication's cost: counted in
/// the kernels' loops (a position unpacked 9, its offset 9, the distance 4, then the kernel and its sums). A list
/// looks at 2.7 candidates for each neighbour that it finds (measured in fluid at rest, cells of h/2).
const INSTRUCTIONS_A_NEIGHBOUR: &[(&str, f64)] = &[
    ("list_neighbours", 2.7 * 40.0),
    ("constrain_density", 46.0),
    ("correct_positions", 44.0),
    ("curl", 40.0),
    ("confine_vorticity", 36.0),
    ("xsph", 36.0),
    ("measure_particles", 30.0),
];
/// An element of the gather rate.
const ELEMENT_BYTES: f64 = 8.0;

/// What a device is limited by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Limit {
    /// Bytes to and from memory.
    Memory,
    /// Elements read from caches.
    Gathers,
    /// Instructions.
    Arithmetic,
    /// Beginning a dispatch behind another.
    Launches,
}

impl Limit {
    /// In a word.
    pub fn word(self) -> &'static str {
        match self {
            Self::Memory => "memory",
            Self::Gathers => "gathers",
            Self::Arithmetic => "arithmetic",
            Self::Launches => "launches",
        }
    }
}

/// The least time of a pass by each rate, ms.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Bounds {
    /// A copy of its compulsory bytes.
    pub memory_ms: f64,
    /// Its gathers.
    pub gathers_ms: f64,
    /// Its arithmetic, as multiplications with an addition.
    pub arithmetic_ms: f64,
    /// Its dispatches, were they empty.
    pub launches_ms: f64,
}

impl Bounds {
    /// Of `stage` in one run of `recording`, where all particles have `neighbours` neighbours together.
    pub fn of(
        plan: &Plan,
        recording: RecordingId,
        stage: &str,
        traffic: Traffic,
        neighbours: u64,
        rates: &Rates,
    ) -> Self {
        let of_stage = |command: &&Command| matches!(command, Command::Dispatch(dispatch) if dispatch.stage == stage);
        let dispatches = plan.commands(recording).iter().filter(of_stage).count() as f64;
        let instructions = INSTRUCTIONS_A_NEIGHBOUR.iter().find(|(name, _)| *name == stage).map_or(0.0, |(_, n)| *n);
        Self {
            memory_ms: 1e3 * traffic.compulsory_bytes as f64 / rates.copy_bytes_per_s,
            gathers_ms: 1e3 * traffic.gathered_bytes as f64 / ELEMENT_BYTES / rates.gathers_per_s,
            arithmetic_ms: 1e3 * dispatches * neighbours as f64 * instructions / rates.multiply_adds_per_s,
            launches_ms: 1e3 * dispatches * rates.launch_s,
        }
    }

    /// The rate that leaves the pass the most time, and that time in ms.
    pub fn nearest(&self) -> (Limit, f64) {
        let all = [
            (Limit::Memory, self.memory_ms),
            (Limit::Gathers, self.gathers_ms),
            (Limit::Arithmetic, self.arithmetic_ms),
            (Limit::Launches, self.launches_ms),
        ];
        all.into_iter().fold((Limit::Memory, 0.0), |nearest, bound| if bound.1 > nearest.1 { bound } else { nearest })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::workload::{LOADS, plan};

    #[test]
    fn each_rate_can_be_the_nearest() {
        let scene = LOADS[2].scene(16, &[]).unwrap();
        let planned = plan(&scene).unwrap();
        let step = planned.recorded.step.id();
        let slow = 1.0;
        let rates = Rates { copy_bytes_per_s: 1e12, gathers_per_s: 1e12, multiply_adds_per_s: 1e13, launch_s: 1e-12 };
        let of = |rates: Rates| {
            let traffic = Traffic { compulsory_bytes: 8000, gathered_bytes: 16_000 };
            Bounds::of(&planned.plan, step, "constrain_density", traffic, 1000, &rates)
        };
        let bounds =
            of(Rates { copy_bytes_per_s: 8e3, gathers_per_s: 2e3, multiply_adds_per_s: 184e3, launch_s: 0.25 });
        // 8,000 bytes, 2,000 elements, 4 dispatches of 46,000 instructions: a second each.
        let expected = Bounds { memory_ms: 1e3, gathers_ms: 1e3, arithmetic_ms: 1e3, launches_ms: 1e3 };
        assert_eq!(bounds, expected);
        for (rates, limit) in [
            (Rates { copy_bytes_per_s: slow, ..rates }, Limit::Memory),
            (Rates { gathers_per_s: slow, ..rates }, Limit::Gathers),
            (Rates { multiply_adds_per_s: slow, ..rates }, Limit::Arithmetic),
            (Rates { launch_s: slow, ..rates }, Limit::Launches),
        ] {
            assert_eq!(of(rates).nearest().0, limit);
        }
    }
}
