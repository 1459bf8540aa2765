//! Who shares memory with whom, with kernels that only exist as data.

use super::*;
use crate::plan::Plan;
use brooklet_kernels::{Buffer, Kernel, ReduceGroups};

fn need(id: u32, bytes: u64, spans: &[Span]) -> Need {
    Need { id: ResourceId(id), bytes, spans: spans.to_vec() }
}

fn shared(needs: Vec<Need>) -> Vec<(u32, u32)> {
    share(needs).into_iter().map(|(id, owner)| (id.0, owner.0)).collect()
}

#[test]
fn needs_that_overlap_or_touch_have_their_own_memory() {
    assert_eq!(shared(vec![need(0, 8, &[(0, 3)]), need(1, 8, &[(2, 5)])]), []);
    // One command touches both.
    assert_eq!(shared(vec![need(0, 8, &[(0, 3)]), need(1, 8, &[(3, 5)])]), []);
    assert_eq!(shared(vec![need(0, 8, &[(0, 3)]), need(1, 8, &[(4, 5)])]), [(1, 0)]);
    // Between two needs of another, and not beyond.
    assert_eq!(shared(vec![need(0, 8, &[(0, 3), (7, 9)]), need(1, 8, &[(4, 6)])]), [(1, 0)]);
    assert_eq!(shared(vec![need(0, 8, &[(0, 3), (7, 9)]), need(1, 8, &[(4, 7)])]), []);
}

#[test]
fn the_smallest_memory_that_is_free_is_taken() {
    let needs = vec![need(0, 100, &[(0, 1)]), need(1, 50, &[(0, 1)]), need(2, 20, &[(2, 3)]), need(3, 10, &[(2, 3)])];
    assert_eq!(shared(needs), [(2, 1), (3, 0)]);
    // Whoever has it already is not displaced.
    let needs = vec![need(0, 100, &[(0, 1)]), need(1, 50, &[(2, 3)]), need(2, 20, &[(3, 4)]), need(3, 10, &[(5, 6)])];
    assert_eq!(shared(needs), [(1, 0), (3, 2)]);
}

/// Four buffers of a chain, each summed to the next: `first` is state.
struct Chain {
    resources: Resources,
    first: Buffer<u32>,
    others: [Buffer<u32>; 3],
    last: Buffer<u32>,
}

fn chain() -> Chain {
    let mut resources = Resources::new();
    let first = resources.persistent("first", 64);
    let others = [(); 3].map(|()| resources.buffer("other", 64));
    let last = resources.persistent("last", 64);
    Chain { resources, first, others, last }
}

fn sum(recording: &mut crate::Recording, from: &Buffer<u32>, to: &mut Buffer<u32>) {
    let kernel = ReduceGroups { values: from.read(), group_sums: to.write() };
    assert_eq!(<ReduceGroups as Kernel>::STAGE, "reduce_groups");
    recording.dispatch(&kernel, 64);
}

fn owners(plan: &Plan) -> Vec<(u32, u32)> {
    plan.sharing.owners.iter().map(|(id, owner)| (id.0, owner.0)).collect()
}

#[test]
fn transients_of_a_chain_take_turns_and_state_keeps_its_memory() {
    let Chain { mut resources, first, others: [mut a, mut b, mut c], mut last } = chain();
    let mut recording = resources.recording("run");
    sum(&mut recording, &first, &mut a);
    sum(&mut recording, &a, &mut b);
    sum(&mut recording, &b, &mut c);
    sum(&mut recording, &c, &mut last);
    let plan = Plan::sweep(resources, vec![recording], &[]).unwrap();
    assert_eq!(owners(&plan), [(c.id.0, a.id.0)]);
    assert_eq!((plan.bytes(), plan.clone().without_sharing().bytes()), (4 * 256, 5 * 256));
    assert_eq!(plan.first_clobbered(), None);
    // The second reckoning is fed wrong ones.
    let wrong = |id: &Buffer<u32>, owner: &Buffer<u32>| {
        let mut plan = plan.clone();
        plan.sharing.owners.insert(id.id, owner.id);
        plan.first_clobbered()
    };
    assert!(wrong(&b, &a).is_some_and(|found| found.contains("reduce_groups")));
    assert!(wrong(&a, &first).is_some() && wrong(&last, &first).is_some() && wrong(&b, &last).is_some());
}

#[test]
fn what_is_forgotten_frees_its_memory_until_it_is_written_again() {
    let run = |forgets: bool, is_wanted: bool| {
        let Chain { mut resources, mut first, others: [mut a, mut b, mut c], .. } = chain();
        let mut recording = resources.recording("run");
        sum(&mut recording, &first, &mut a);
        if forgets {
            recording.forget(&first);
        }
        sum(&mut recording, &a, &mut b);
        sum(&mut recording, &b, &mut c);
        sum(&mut recording, &c, &mut first);
        let wanted = if is_wanted { vec![first.id] } else { vec![] };
        let plan = Plan::sweep(resources, vec![recording], &wanted).unwrap();
        assert_eq!(plan.first_clobbered(), None);
        owners(&plan)
    };
    // `b` fits between; `c`, which is read where `first` is written, does not.
    assert_eq!(run(true, false), [(2, 0), (3, 1)]);
    assert_eq!(run(false, false), [(3, 1)]);
    assert_eq!(run(true, true), [(3, 1)], "a wanted output is read whenever a host likes");
}

#[test]
fn state_that_is_forgotten_and_not_written_keeps_its_memory() {
    let Chain { mut resources, first, others: [mut a, mut b, _], mut last } = chain();
    let mut recording = resources.recording("run");
    sum(&mut recording, &first, &mut a);
    recording.forget(&first);
    sum(&mut recording, &a, &mut b);
    sum(&mut recording, &b, &mut last);
    let plan = Plan::sweep(resources, vec![recording], &[]).unwrap();
    assert_eq!(owners(&plan), []);
}

#[test]
fn wanted_outputs_and_what_lasts_over_two_uses_share_nothing() {
    let run = |forgets: bool, wants: bool| {
        let Chain { mut resources, first, others: [mut a, mut b, mut c], mut last } = chain();
        let mut recording = resources.recording("run");
        sum(&mut recording, &first, &mut a);
        sum(&mut recording, &a, &mut last);
        if forgets {
            recording.forget_transients();
        }
        sum(&mut recording, &first, &mut b);
        sum(&mut recording, &b, &mut c);
        sum(&mut recording, &c, &mut last);
        // Once more: what it adds to may be what it wrote above.
        sum(&mut recording, &first, &mut a);
        sum(&mut recording, &a, &mut last);
        let wanted = if wants { vec![a.id, b.id, c.id] } else { vec![] };
        let plan = Plan::sweep(resources, vec![recording], &wanted).unwrap();
        assert_eq!(plan.first_clobbered(), None);
        owners(&plan)
    };
    assert_eq!(run(false, false), []);
    assert_eq!(run(true, false), [(2, 1)]);
    assert_eq!(run(true, true), []);
}

#[test]
fn a_read_behind_what_forgets_is_refused() {
    for all in [false, true] {
        let Chain { mut resources, first, others: [mut a, ..], mut last } = chain();
        let mut recording = resources.recording("run");
        sum(&mut recording, &first, &mut a);
        match all {
            true => recording.forget_transients(),
            false => recording.forget(&a),
        }
        sum(&mut recording, &a, &mut last);
        let error = Plan::sweep(resources, vec![recording], &[]).unwrap_err();
        assert!(matches!(error, crate::PlanError::ReadBeforeWrite { .. }), "{error}");
    }
}

#[test]
fn recordings_share_transients_and_draw_no_line_between_state() {
    let Chain { mut resources, first, others: [mut a, mut b, _], mut last } = chain();
    let mut one = resources.recording("one");
    sum(&mut one, &first, &mut a);
    sum(&mut one, &a, &mut last);
    let mut other = resources.recording("other");
    sum(&mut other, &first, &mut b);
    sum(&mut other, &b, &mut last);
    let ids = [one.id(), other.id()];
    let plan = Plan::sweep(resources, vec![one, other], &[]).unwrap();
    assert_eq!(owners(&plan), [(b.id.0, a.id.0)]);
    assert_eq!(plan.bytes_of(&ids), 3 * 256);
    assert_eq!(plan.bytes_of(&ids[1..]), 3 * 256, "what it needs alone");
}
