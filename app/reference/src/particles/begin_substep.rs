//! How a substep begins: its time, and the slots that it visits. (Shader: `particles/begin_substep.compute`.)

/// What is known of a substep; see `StepState` of the shaders' layout.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepState {
    /// Slots that the substep visits.
    pub slot_count: u32,
    /// Particles, as the last sort counted them, and what was activated since.
    pub active_count: u32,
    /// Length of the substep, s.
    pub dt_s: f64,
    /// Simulated when it ends, s.
    pub time_s: f64,
}

/// The state of the substep after `last`, to take `dt_s`.
pub fn begin_substep(last: &StepState, dt_s: f64) -> StepState {
    StepState { slot_count: last.active_count, dt_s, time_s: last.time_s + dt_s, ..*last }
}

/// The groups of a dispatch with one thread for each of `slot_count`, in rows of `groups_per_row`: a
/// `VkDispatchIndirectCommand`.
pub fn slot_groups(slot_count: u32, group_size: u32, groups_per_row: u32) -> [u32; 3] {
    let groups = slot_count.div_ceil(group_size);
    [groups.min(groups_per_row), groups.div_ceil(groups_per_row), 1]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_activated_is_visited_from_the_next_substep_on() {
        let last = StepState { slot_count: 5, active_count: 9, dt_s: 0.5, time_s: 2.0 };
        let next = begin_substep(&last, 0.25);
        assert_eq!(next, StepState { slot_count: 9, active_count: 9, dt_s: 0.25, time_s: 2.25 });
    }

    #[test]
    fn rows_hold_all_groups() {
        assert_eq!(slot_groups(0, 64, 8), [0, 0, 1]);
        assert_eq!(slot_groups(65, 64, 8), [2, 1, 1]);
        assert_eq!(slot_groups(64 * 17, 64, 8), [8, 3, 1]);
    }
}
