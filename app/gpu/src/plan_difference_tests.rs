//! Plans that differ in one thing each.

use crate::{DrawState, Load, Plan, RecordingId, Resources, Targets};
use brooklet_kernels::{DrawSky, Format, Module, ReduceGroups};

/// What a plan of a few commands is made of.
#[derive(Clone)]
struct Parts {
    uploaded: Vec<u32>,
    uploaded_in_step: u32,
    persistent: bool,
    values_label: &'static str,
    items: u32,
    sums: u32,
    reads_other: bool,
    copies_back: bool,
    reduces_twice: bool,
    label: &'static str,
    third: bool,
    vertices: u32,
    state: DrawState,
    load: Load<[f64; 4]>,
    size_px: [u32; 2],
    format: Format,
    wants_sums: bool,
}

const PARTS: fn() -> Parts = || Parts {
    uploaded: vec![1, 2, 3, 4],
    uploaded_in_step: 7,
    persistent: true,
    values_label: "values",
    items: 1000,
    sums: 4,
    reads_other: false,
    copies_back: false,
    reduces_twice: false,
    label: "step",
    third: false,
    vertices: 3,
    state: DrawState::default(),
    load: Load::Clear([0.0; 4]),
    size_px: [4, 4],
    format: Format::Rgba8Unorm,
    wants_sums: true,
};

fn plan(parts: &Parts) -> Plan {
    let mut resources = Resources::new();
    let mut values = match parts.persistent {
        true => resources.persistent::<u32>(parts.values_label, 4),
        false => resources.buffer::<u32>(parts.values_label, 4),
    };
    let mut other = resources.persistent::<u32>("other", 4);
    let mut sums = resources.persistent::<u32>("group_sums", parts.sums);
    let view = resources.persistent("view", 1);
    let light = resources.persistent("light", 1);
    let picture = resources.texture("picture", parts.format, parts.size_px);
    let mut init = resources.recording("init");
    init.upload(&mut values, &parts.uploaded);
    let mut step = resources.recording(parts.label);
    step.upload(&mut other, &[parts.uploaded_in_step]);
    if !parts.persistent {
        step.clear(&mut values);
    }
    step.clear(&mut sums);
    let read = if parts.reads_other { &other } else { &values };
    for _ in 0..=u32::from(parts.reduces_twice) {
        step.dispatch(&ReduceGroups { values: read.read(), group_sums: sums.write() }, parts.items);
    }
    match parts.copies_back {
        true => step.copy(&values, &mut other),
        false => step.copy(&other, &mut values),
    }
    let targets = Targets { color: vec![(&picture, parts.load)], depth: None };
    let draw = DrawSky { view: view.uniform(), light: light.uniform() };
    // What is kept must have been drawn before.
    step.draw(&draw, &Targets { color: vec![(&picture, Load::Clear([1.0; 4]))], depth: None }, parts.state, 3, 1);
    step.draw(&draw, &targets, parts.state, parts.vertices, 1);
    let mut recordings = vec![init, step];
    if parts.third {
        recordings.push(resources.recording("third"));
    }
    let wanted = if parts.wants_sums { vec![picture.id, sums.id] } else { vec![picture.id] };
    Plan::sweep(resources, recordings, &wanted).expect("a plan")
}

fn init(plan: &Plan) -> RecordingId {
    plan.recordings().next().expect("a recording")
}

#[test]
fn other_numbers_are_found_with_where_they_go() {
    let base = plan(&PARTS());
    assert_eq!(base.changed_uploads(&plan(&PARTS())), Some(Vec::new()));
    let other = plan(&Parts { uploaded: vec![1, 2, 5, 4], ..PARTS() });
    assert!(base.differs_only_in_uploads(&other));
    let changed = base.changed_uploads(&other).expect("only uploads differ");
    let [upload] = changed.as_slice() else { panic!("{changed:?}") };
    assert_eq!(upload.recording, init(&base));
    assert_eq!(base.resources().label(upload.to), "values");
    assert_eq!(bytemuck::pod_collect_to_vec::<u8, u32>(&upload.data), [1, 2, 5, 4]);
    let mut taken = base.clone();
    taken.take_uploads(&other);
    assert_eq!(taken.changed_uploads(&other), Some(Vec::new()), "and once taken they are the same");
    let in_step = base.changed_uploads(&plan(&Parts { uploaded_in_step: 8, ..PARTS() })).expect("only uploads differ");
    assert_ne!(in_step[0].recording, init(&base));
}

#[test]
fn whatever_else_differs_is_found() {
    let base = plan(&PARTS());
    let blended = DrawState { blend: crate::Blend::Alpha, ..DrawState::default() };
    let others = [
        ("another upload length", Parts { uploaded: vec![1, 2, 3], ..PARTS() }),
        ("another group count", Parts { items: 10_000, ..PARTS() }),
        ("another buffer size", Parts { sums: 5, ..PARTS() }),
        ("a buffer that does not last", Parts { persistent: false, ..PARTS() }),
        ("another buffer's name", Parts { values_label: "numbers", ..PARTS() }),
        ("another binding", Parts { reads_other: true, ..PARTS() }),
        ("another copy", Parts { copies_back: true, ..PARTS() }),
        ("one command more", Parts { reduces_twice: true, ..PARTS() }),
        ("another recording's name", Parts { label: "advance", ..PARTS() }),
        ("one recording more", Parts { third: true, ..PARTS() }),
        ("more vertices", Parts { vertices: 6, ..PARTS() }),
        ("another draw state", Parts { state: blended, ..PARTS() }),
        ("another load of a target", Parts { load: Load::Keep, ..PARTS() }),
        ("another picture size", Parts { size_px: [4, 5], ..PARTS() }),
        ("another format of the same size", Parts { format: Format::R32Float, ..PARTS() }),
        ("another output", Parts { wants_sums: false, ..PARTS() }),
    ];
    for (what, parts) in others {
        let other = plan(&parts);
        assert!(!base.differs_only_in_uploads(&other), "{what}");
        assert!(!other.differs_only_in_uploads(&base), "{what}, the other way round");
        assert!(other.differs_only_in_uploads(&plan(&parts)), "{what} is still the same as itself");
    }
}

#[test]
fn another_module_is_found_and_a_recompiled_one_is_the_same() {
    let base = plan(&PARTS());
    let with = |edit: &'static dyn Fn(&'static Module) -> &'static Module| {
        base.clone().with_modules(|module| Some(edit(module))).expect("it binds the same")
    };
    let renamed = |module: &'static Module| -> &'static Module {
        match module.name {
            "ReduceGroups" => Box::leak(Box::new(Module { name: "ReduceGroups+OTHER", ..*module })),
            _ => module,
        }
    };
    assert!(!base.differs_only_in_uploads(&with(Box::leak(Box::new(renamed)))));
    let redrawn = |module: &'static Module| -> &'static Module {
        match module.stage {
            brooklet_kernels::StageKind::Fragment => Box::leak(Box::new(Module { name: "Other", ..*module })),
            _ => module,
        }
    };
    assert!(!base.differs_only_in_uploads(&with(Box::leak(Box::new(redrawn)))));
    let recompiled = |module: &'static Module| module.with_spirv(&[1, 2, 3, 4], 0, module.tier);
    assert!(base.differs_only_in_uploads(&with(Box::leak(Box::new(recompiled)))));
}
