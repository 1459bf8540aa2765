//! Memory that buffers share, on a real driver.

use crate::support::{Increment, gpu};
use brooklet_gpu::{Engine, GpuError, Plan, Resources};

/// What two buffers come to that are counted up in turns, the first before and after the second; whether they share
/// memory, if `change` lets them.
fn counted(forgets: bool, change: fn(Plan) -> Plan) -> ([u32; 2], bool) {
    let mut resources = Resources::new();
    let mut first = resources.buffer::<u32>("first", 100);
    let mut second = resources.buffer::<u32>("second", 100);
    let mut outputs = ["first_output", "second_output"].map(|label| resources.persistent::<u32>(label, 100));
    let mut early = resources.persistent::<u32>("early_output", 100);
    let mut run = resources.recording("run");
    run.clear(&mut first);
    run.dispatch(&Increment { values: first.write() }, 100);
    // Else what comes before it is forgotten feeds nothing, and is left out.
    run.copy(&first, &mut early);
    if forgets {
        run.forget(&first);
    }
    run.clear(&mut second);
    (0..4).for_each(|_| run.dispatch(&Increment { values: second.write() }, 100));
    run.copy(&second, &mut outputs[1]);
    run.dispatch(&Increment { values: first.write() }, 100);
    run.copy(&first, &mut outputs[0]);
    let id = run.id();
    let plan = change(Plan::sweep(resources, vec![run], &[]).expect("a plan"));
    let shares = plan.buffers().iter().any(|buffer| buffer.memory != buffer.id);
    let mut engine = Engine::new(&gpu(), plan).expect("an engine");
    let mut ends = [[0; 2]; 2];
    for end in &mut ends {
        engine.run(&[id], &[]).expect("it runs");
        *end = [0, 1].map(|of| engine.read(&outputs[of]).expect("state is read")[99]);
    }
    assert_eq!(ends[0], ends[1], "a second run");
    assert_eq!(engine.wgpu_buffer(first.id).is_none(), shares);
    assert_eq!(matches!(engine.read(&first), Err(GpuError::NotReadable { .. })), shares);
    (ends[0], shares)
}

/// A recording that forgets what it still needs is found out by shared memory, and by garbage where nothing is shared.
#[test]
fn a_buffer_that_is_forgotten_too_early_shows() {
    let apart = Plan::without_sharing;
    assert_eq!(counted(false, |plan| plan), ([2, 4], false), "needed all the time");
    assert_eq!(counted(false, Plan::with_garbage), ([2, 4], false));
    assert_eq!(counted(true, apart), ([2, 4], false));
    assert_eq!(counted(true, |plan| plan), ([5, 4], true), "the second's content is counted on");
    assert_ne!(counted(true, Plan::with_garbage).0[0], 2);
}

#[test]
fn buffers_in_turns_have_one_memory_and_right_numbers() {
    let mut resources = Resources::new();
    let mut turns =
        ["long", "short"].map(|label| resources.buffer::<u32>(label, if label == "long" { 1000 } else { 70 }));
    let mut outputs = ["long_output", "short_output"]
        .map(|label| resources.persistent::<u32>(label, if label == "long_output" { 1000 } else { 70 }));
    let mut run = resources.recording("run");
    for (buffer, output) in turns.iter_mut().zip(&mut outputs) {
        run.clear(buffer);
        // More threads than the short one has elements: it is bound at its own length, not its memory's.
        (0..3).for_each(|_| run.dispatch(&Increment { values: buffer.write() }, 1000));
        run.copy(buffer, output);
    }
    let id = run.id();
    let plan = Plan::sweep(resources, vec![run], &[]).expect("a plan");
    assert_eq!(plan.bytes(), 4 * (1000 + 1000 + 70));
    let (shared, apart) = (Engine::new(&gpu(), plan.clone()), Engine::new(&gpu(), plan.without_sharing()));
    let (mut shared, apart) = (shared.expect("an engine"), apart.expect("an engine"));
    assert!(shared.allocated_bytes() < apart.allocated_bytes());
    assert_eq!(apart.allocation_count() - shared.allocation_count(), 1);
    shared.run(&[id], &[]).expect("it runs");
    assert_eq!(shared.read(&outputs[0]).expect("long"), [3; 1000]);
    assert_eq!(shared.read(&outputs[1]).expect("short"), [3; 70]);
}
