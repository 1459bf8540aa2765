//! The order in which a recording is encoded: as recorded, but with uploads, clears and copies
//! moved up before dispatches that do not touch what they touch. Each of them would end the
//! compute pass, and each pass is a command buffer of its own in wgpu.

use crate::recording::Command;
use brooklet_kernels::ResourceId;
use std::collections::BTreeSet;

pub(crate) fn encoding_order(commands: &[Command]) -> Vec<&Command> {
    let mut order: Vec<&Command> = Vec::with_capacity(commands.len());
    // The run of dispatches at the end of `order`: where it starts, and what it touches.
    let mut run_start = 0;
    let mut touched: BTreeSet<ResourceId> = BTreeSet::new();
    for command in commands {
        let ids = command.touches().into_iter().map(|(id, _)| id);
        match command {
            Command::Dispatch(_) => {
                touched.extend(ids);
                order.push(command);
            }
            // What is written after it is not moved before it.
            Command::Forget { of: Some(of) } => {
                touched.insert(*of);
                order.push(command);
            }
            Command::Draw(_) | Command::Forget { of: None } => {
                order.push(command);
                run_start = order.len();
                touched.clear();
            }
            Command::Upload { .. } | Command::Clear { .. } | Command::Copy { .. } => {
                if ids.clone().any(|id| touched.contains(&id)) {
                    order.push(command);
                    run_start = order.len();
                    touched.clear();
                } else {
                    order.insert(run_start, command);
                    run_start += 1;
                }
            }
        }
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recording::{Dispatch, Groups};
    use brooklet_kernels::{Access, BindingInfo, BindingKind, Bound, Module, StageKind, Tier};

    fn dispatch(ids: &[u32]) -> Command {
        static MODULE: Module = Module {
            name: "Test",
            entry: "Test",
            stage: StageKind::Compute,
            spirv: brooklet_kernels::Spirv::Plain(&[]),
            bindings: &[],
            group_size: [64, 1, 1],
            shared_bytes: 0,
            tier: Tier::Floor,
            source: "",
            hash: "",
        };
        let kind = BindingKind::Storage { access: Access::Read, stride_bytes: 4 };
        Command::Dispatch(Dispatch {
            stage: "test",
            module: &MODULE,
            bindings: ids
                .iter()
                .map(|id| Bound { info: BindingInfo { name: "x", slot: 0, kind }, resource: Some(ResourceId(*id)) })
                .collect(),
            groups: Groups::Fixed([1, 1, 1]),
        })
    }

    fn clear(id: u32) -> Command {
        Command::Clear { to: ResourceId(id) }
    }

    /// Index in `commands` of each command of the order.
    fn places(commands: &[Command]) -> Vec<usize> {
        encoding_order(commands)
            .into_iter()
            .filter_map(|moved| commands.iter().position(|command| std::ptr::eq(command, moved)))
            .collect()
    }

    #[test]
    fn a_clear_goes_before_dispatches_that_do_not_touch_it() {
        let commands = [dispatch(&[0]), clear(1), dispatch(&[0, 1]), clear(2), clear(3), dispatch(&[3])];
        assert_eq!(places(&commands), [1, 3, 4, 0, 2, 5]);
    }

    #[test]
    fn a_clear_stays_after_a_dispatch_that_touches_it() {
        let commands = [dispatch(&[0, 1]), clear(1), dispatch(&[1]), clear(0), dispatch(&[0])];
        // The second clear may join the first, between the dispatches.
        assert_eq!(places(&commands), [0, 1, 3, 2, 4]);
    }

    #[test]
    fn nothing_moves_before_what_it_was_recorded_after_is_forgotten() {
        let forget = |of: Option<u32>| Command::Forget { of: of.map(ResourceId) };
        let one = [dispatch(&[0]), forget(Some(1)), dispatch(&[0]), clear(1), clear(2)];
        assert_eq!(places(&one), [0, 1, 2, 3, 4]);
        let other = [dispatch(&[0]), forget(Some(2)), dispatch(&[0]), clear(1)];
        assert_eq!(places(&other), [3, 0, 1, 2]);
        let all = [dispatch(&[0]), forget(None), dispatch(&[0]), clear(1)];
        assert_eq!(places(&all), [0, 1, 3, 2]);
    }

    #[test]
    fn transfers_keep_their_order_among_themselves() {
        let copy = Command::Copy { from: ResourceId(1), to: ResourceId(2), bytes: 4 };
        let commands = [dispatch(&[0]), clear(1), copy, clear(1), dispatch(&[2])];
        assert_eq!(places(&commands), [1, 2, 3, 0, 4]);
    }
}
