//! Scenes: defaults, shipped ones, and what their values come to.

use std::ops::Add as _;

use super::fields::{FIELDS, kind_of};
use super::fill;
use super::*;
use crate::particles::sample_lattice;

pub(super) const SMALL: &str = "spacing_m = 0.1\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [1, 1, 1]\n[[fluid]]\nblock = { min_m = [0, 0, 0], max_m = [0.3, 0.2, 0.1] }\n";

pub(super) fn load(text: &str, settings: &[&str]) -> Result<Scene, String> {
    let settings: Vec<String> = settings.iter().map(|&s| s.into()).collect();
    Scene::from_toml(text, "small.toml", &settings).map_err(|error| error.to_string())
}

#[test]
fn integers_and_defaults() {
    let scene = load(SMALL, &[]).unwrap();
    assert_eq!(scene.name, "small");
    assert_eq!(scene.solver, Solver::default());
    assert_eq!(scene.fluids[0].rest_density_kg_m3, 1000.0);
    assert_eq!(sample_lattice(&scene).positions.len(), 6);
}

#[test]
fn every_shipped_scene_loads_and_says_what_it_is() {
    for (name, summary) in shipped_scenes() {
        let scene = Scene::load(name, &[]).unwrap();
        assert_eq!(scene.summary, summary);
        assert!(!summary.is_empty(), "{name} has no summary");
        let particles = sample_lattice(&scene);
        assert!(!particles.positions.is_empty(), "{name} has no particles");
        assert_eq!(fill::count(&scene), particles.positions.len() as u64);
        assert_eq!(Scene::from_toml(&scene.to_toml(), name, &[]).unwrap(), scene, "{name} does not survive TOML");
    }
}

/// A published table of a phone's frame rates is of these: 1,000 and 5,000 particles, PBF of 2 iterations, marching cubes.
#[test]
fn the_phones_scenes_are_those_that_are_published() {
    for (name, particles) in [("phone-1k", 1000), ("phone-5k", 5000)] {
        let scene = Scene::load(name, &[]).unwrap();
        assert_eq!(scene.particle_count(), particles, "{name}");
        assert_eq!((scene.solver.pbf.iterations, scene.solver.substeps), (2, 1), "{name}");
        let [x_m, y_m, z_m] = scene.domain.size_m();
        let of_cells_m = [80.0, 40.0, 40.0].map(|cells| cells * x_m / 80.0);
        assert_eq!(scene.surface.mesh.dense_cells, 80, "{name}");
        assert!(
            [x_m, y_m, z_m].iter().zip(of_cells_m).all(|(size_m, wanted_m)| (size_m - wanted_m).abs() < 1e-12),
            "{name}"
        );
    }
}

#[test]
fn settings_replace_values() {
    let scene =
        load(SMALL, &["solver.pbf.iterations=8", "domain.max_m.1 = 2", "fluid.0.velocity_m_s=[1,0,0]"]).unwrap();
    assert_eq!(scene.solver.pbf.iterations, 8);
    assert_eq!(scene.domain.max_m, [1.0, 2.0, 1.0]);
    assert_eq!(scene.fluids[0].velocity_m_s, [1.0, 0.0, 0.0]);
}

/// A setting that puts `value` into a field; the scene has what lies above it.
fn setting(field: &str, value: &str) -> Vec<String> {
    let mut settings = Vec::new();
    if field.starts_with("camera") {
        settings.push("camera.eye_m=[3, 1, 4]".to_string());
        settings.push("camera.target_m=[0, 0, 0]".to_string());
    }
    if field.starts_with("forces.field.*") {
        settings.push("forces.field=[{ end_s = 2 }]".into());
    }
    if field.starts_with("solid.*") {
        let round = ["capsule", "cylinder"].into_iter().find(|shape| field.starts_with(&format!("solid.*.{shape}.")));
        let tables = [
            ("mesh", "file = \"a.obj\""),
            ("hull", ""),
            ("wheel", "radius_m = 0.2, width_m = 0.1"),
            ("terrain", "size_m = [1, 0.2, 1]"),
            ("hinge", "axis = [0, 0, 1]"),
        ];
        let own = tables.into_iter().find(|(table, _)| field.starts_with(&format!("solid.*.{table}.")));
        settings.push(match (round, own) {
            (Some(shape), _) => format!("solid=[{{ {shape} = {{ radius_m = 0.2, length_m = 0.5 }} }}]"),
            (_, Some((table, own))) => format!("solid=[{{ {table} = {{ {own} }} }}]"),
            (None, None) => "solid=[{ keyframe = [{ time_s = 0 }] }]".into(),
        });
    }
    if field.starts_with("emitter.*") || field.starts_with("drain.*") {
        let bodies =
            "block = { min_m = [0, 0, 0], max_m = [1, 1, 1] }, sphere = { centre_m = [0, 0, 0], radius_m = 0.2 }";
        settings.push(format!("emitter=[{{ {bodies}, keyframe = [{{ time_s = 0 }}] }}]"));
        settings.push(format!("drain=[{{ {bodies} }}]"));
    }
    if field.starts_with("fluid.*.sphere") {
        settings.push("fluid.0={ sphere = { centre_m = [0.5, 0.5, 0.5], radius_m = 0.2 } }".into());
    }
    if field.starts_with("fluid.*.cylinder") {
        let cylinder = "cylinder = { centre_m = [0.5, 0.5, 0.5], radius_m = 0.2, length_m = 0.3 }";
        settings.push(format!("fluid.0={{ {cylinder} }}"));
    }
    settings.push(format!("{}={value}", field.replace('*', "0")));
    settings
}

#[test]
fn each_field_refuses_what_it_does_not_take_by_name_and_value() {
    for Field { path: field, kind, methods, .. } in FIELDS {
        let wrong: Vec<(String, String)> = match kind {
            Kind::Number(limits) | Kind::Whole(limits) => {
                let beyond = [limits.least - 1.0, 2.0 * limits.most + 1.0];
                let numbers = beyond.into_iter().map(|n| if *kind == Kind::Whole(*limits) { n.round() } else { n });
                let numbers = numbers.map(|n| n.to_string());
                ["nan", "inf", "-inf", "\"many\"", "true", "[1]", "9e18", "1e308"]
                    .into_iter()
                    .map(String::from)
                    .chain(numbers)
                    .map(|value| (value, limits.to_string()))
                    .collect()
            }
            Kind::Vector(limits) => {
                ["[nan, 0, 0]", "[0, inf, 0]", "[0, 0, -1e30]", "[0, 0]", "[0, 0, 0, 0]", "1", "[\"a\", 0, 0]"]
                    .into_iter()
                    .map(|value| (value.into(), limits.to_string()))
                    .collect()
            }
            Kind::Vectors(limits) => ["[[0, nan, 0]]", "[[0, 0]]", "[0, 0, 0]", "1", "[[0, 1e30, 0]]", "[\"a\"]"]
                .map(|value| (value.into(), limits.to_string()))
                .into(),
            Kind::Choice(names) => ["\"other\"", "7", "true"].map(|value| (value.into(), names[0].into())).into(),
            Kind::Switch => ["0", "\"yes\"", "[true]"].map(|value| (value.into(), "true or false".into())).into(),
            Kind::Switches => ["true", "[true, false]", "[true, false, 1]", "[\"x\", false, false]", "7"]
                .map(|value| (value.into(), "three of true or false".into()))
                .into(),
            Kind::Text => ["7", "[\"a\"]", "true"].map(|value| (value.into(), "text".into())).into(),
            Kind::Table => ["7", "true"].map(|value| (value.into(), "table".into())).into(),
            Kind::Tables => ["7", "true"].map(|value| (value.into(), "[[name]]".into())).into(),
        };
        for (value, allowed) in wrong {
            let mut settings = setting(field, &value);
            settings.extend(methods.first().map(|method| format!("solver.method={method}")));
            let error = Scene::from_toml(SMALL, "small.toml", &settings).unwrap_err().to_string();
            let name = field.replace('*', "0");
            // The number may be written otherwise, as 1e30 is.
            let start: String = value.chars().take(1).collect();
            for part in ["scene small.toml", &format!("{name} = "), &start, &allowed] {
                assert!(error.contains(part), "{field}={value}: {error:?} does not say {part:?}");
            }
        }
    }
}

#[test]
fn limits_are_within_what_is_allowed() {
    for Field { path: field, kind, .. } in FIELDS {
        let (Kind::Number(limits) | Kind::Whole(limits)) = kind else { continue };
        for value in [limits.least, limits.most] {
            if let Err(error) = Scene::from_toml(SMALL, "small.toml", &setting(field, &value.to_string())) {
                // Refused for what it is together with the rest, if at all.
                assert!(!error.to_string().contains(&limits.to_string()), "{field}={value}: {error}");
            }
        }
    }
}

#[test]
fn room_for_neighbours_follows_the_support_and_the_dimensions() {
    let slots = |settings: &[&str]| load(SMALL, settings).unwrap().neighbour_slots();
    assert_eq!(slots(&[]), 48);
    assert_eq!(slots(&["solver.support_ratio=3"]), 164);
    assert_eq!(slots(&["solver.support_ratio=1.5"]), 24);
    assert_eq!(slots(&["domain.dimensions=2", "fluid.0.block.max_m.2=1", "solver.support_ratio=3"]), 44);
    assert_eq!(slots(&["solver.support_ratio=3", "solver.neighbour_slots=50"]), 50);
}

/// A field that is added to a scene has to be added to the table as well.
#[test]
fn the_table_has_every_field() {
    let camera = "[camera]\neye_m = [3, 1, 4]\ntarget_m = [0, 0, 0]\n";
    let sphere = "[[fluid]]\nsphere = { centre_m = [0.5, 0.5, 0.5], radius_m = 0.2 }\n";
    let cylinder = "[[fluid]]\ncylinder = { centre_m = [0.5, 0.5, 0.5], radius_m = 0.2, length_m = 0.3 }\n";
    let scene = load(
        &format!("{SMALL}{sphere}{cylinder}{camera}"),
        &[
            "capacity=5000",
            "forces.field=[{ end_s = 2 }]",
            "solid=[{ box = { size_m = [1, 1, 1] }, thickness_m = 0.1, open = \"x_min\", color = [1, 0, 0], measure_force = true }, { sphere = { radius_m = 0.2 }, centre_m = [0.75, 0.75, 0.75], density_kg_m3 = 500 }, \
             { capsule = { radius_m = 0.2, length_m = 0.5 } }, { cylinder = { radius_m = 0.2, length_m = 0.5 }, \
             keyframe = [{ time_s = 0 }, { time_s = 1 }], repeat = true }]",
            "emitter=[{ radius_m = 0.2, centre_m = [0.5, 0.5, 0.5], speed_m_s = 1, end_s = 2, lifetime_s = 1 }, \
             { width_m = 0.3, height_m = 0.2, speed_m_s = 1, keyframe = [{ centre_m = [0.5, 0.5, 0.5] }, \
             { time_s = 9, centre_m = [0.5, 0.6, 0.5] }], repeat = true }, \
             { block = { min_m = [0, 0.9, 0], max_m = [0.2, 1, 0.2] } }, { sphere = { centre_m = [0.5, 0.2, 0.5], radius_m = 0.2 } }]",
            "drain=[{ block = { min_m = [0, 0, 0], max_m = [0.1, 0.1, 0.1] }, most_m3_s = 0.1 }, \
             { sphere = { centre_m = [0.5, 0.5, 0.5], radius_m = 0.2 } }]",
            "solver.max_speed_m_s=5",
            "solver.neighbour_slots=64",
            "solver.pbf.coarse_correction=true",
            "solver.pbf.relaxation=0.4",
            "surface.iterations=3",
            "surface.absorption_per_m=[3, 1, 0.5]",
            "surface.caustics=true",
            "surface.self_shadow=true",
            "surface.auto.px_per_particle=1",
            "diffuse={ trapped_air_min_m_s = 0.1, trapped_air_max_m_s = 1, energy_min_j_kg = 0.1, energy_max_j_kg = 1 }",
            "domain.faces={ x_min = {}, x_max = {}, y_min = {}, y_max = {}, z_min = {}, z_max = {} }",
        ],
    )
    .unwrap();
    let stiff = Scene {
        solver: Solver {
            sph: SphSettings { stiffness_m2_s2: Some(100.0), ..SphSettings::default() },
            dfsph: DfsphSettings { coarse_correction: Some(true), ..DfsphSettings::default() },
            ..scene.solver.clone()
        },
        // Which a scene with walls does not have.
        drains: [&scene.drains[..], &[DrainSettings { domain_exit: true, ..DrainSettings::default() }]].concat(),
        ..scene
    };
    // Of files that are not there.
    let mut stiff = stiff;
    // Which water does not have.
    stiff.surface.metal_reflectance = Some([0.8; 3]);
    // Of which no model has all.
    stiff.domain.wall =
        Wall { model: WallModel::Penalty, stiffness_per_s2: Some(1.0e4), damping_per_s: Some(100.0), restitution: 0.5 };
    let file = || "there.obj".to_owned();
    stiff.solids.extend([
        SolidSettings {
            mesh: Some(MeshShape { file: file(), scale_m: 1.0, cell_m: Some(0.1) }),
            ..SolidSettings::default()
        },
        SolidSettings {
            hull: Some(HullShape { points_m: vec![[0.0; 3]], file: Some(file()), scale_m: 1.0, cell_m: Some(0.1) }),
            ..SolidSettings::default()
        },
        SolidSettings {
            wheel: Some(WheelShape {
                radius_m: 0.2,
                width_m: 0.1,
                paddles: 8,
                hub_radius_m: Some(0.1),
                paddle_m: Some(0.02),
                cell_m: Some(0.1),
            }),
            hinge: Some(HingeSettings { axis: [0.0, 0.0, 1.0], at_m: Some([0.0; 3]) }),
            ..SolidSettings::default()
        },
        SolidSettings {
            terrain: Some(TerrainShape {
                size_m: [1.0; 3],
                file: Some(file()),
                relief: Relief::Hills,
                seed: 1,
                feature_m: Some(1.0),
                channel_m: Some(1.0),
                fall_m: 1.0,
                cell_m: Some(0.1),
            }),
            ..SolidSettings::default()
        },
    ]);
    let mut seen = std::collections::BTreeSet::new();
    fn visit(path: &str, value: &toml::Value, seen: &mut std::collections::BTreeSet<String>) {
        let kind = kind_of(path).unwrap_or_else(|| panic!("`{path}` is not in FIELDS (scene/fields.rs): add it"));
        seen.insert(
            path.split('.').map(|key| if key.parse::<u8>().is_ok() { "*" } else { key }).collect::<Vec<_>>().join("."),
        );
        match (kind, value) {
            (Kind::Table, toml::Value::Table(table)) => {
                table.iter().for_each(|(key, value)| visit(&format!("{path}.{key}"), value, seen));
            }
            (Kind::Tables, toml::Value::Array(items)) => {
                items.iter().enumerate().for_each(|(index, item)| visit(&format!("{path}.{index}"), item, seen));
            }
            _ => {}
        }
    }
    let toml::Value::Table(table) = toml::Value::try_from(&stiff).unwrap() else { panic!("a scene is a table") };
    table.iter().for_each(|(key, value)| visit(key, value, &mut seen));
    let known: std::collections::BTreeSet<String> = FIELDS.iter().map(|field| field.path.to_string()).collect();
    assert_eq!(seen, known);
}

#[test]
fn what_a_message_suggests_is_enough() {
    let (setting, fluid) = ("domain.max_m=[1e5,6,6]", "fluid.0.block.max_m=[6,6,6]");
    assert!(load(SMALL, &[setting, fluid]).is_err());
    load(SMALL, &[setting, fluid, "spacing_m=1.53"]).unwrap();
    load(SMALL, &["fluid.0.block.max_m=[1,1,1]", "spacing_m=0.00395"]).unwrap();
}

#[test]
fn overlapping_fluids_share_no_place() {
    let text = format!("{SMALL}[[fluid]]\nblock = {{ min_m = [0, 0, 0], max_m = [0.4, 0.2, 0.1] }}\n");
    let scene = load(&text, &[]).unwrap();
    let particles = sample_lattice(&scene);
    assert_eq!(particles.positions.len(), 8);
    assert_eq!(fill::count(&scene), 8);
    let second = particles.positions.iter().filter(|p| p.tag >> 24 == 1).count();
    assert_eq!(second, 2);
}

#[test]
fn a_domain_far_larger_than_its_fluid_has_a_small_grid() {
    let scene = load(SMALL, &["domain.max_m=[1e3,1e3,1e3]"]).unwrap();
    let count = fill::count(&scene) as u32;
    assert_eq!(crate::grid::cells(&scene), [10_000; 3]);
    let cells = crate::grid::wrapped(crate::grid::cells(&scene), count).unwrap();
    assert!(cells.iter().all(|n| n.is_power_of_two() && *n >= 8), "{cells:?}");
    assert_eq!(cells.iter().product::<u32>(), 1 << 16);
    // One that its fluid fills has a cell for each of its own, whatever their number.
    assert_eq!(crate::grid::wrapped([300, 200, 100], 6_000_000), None);
    assert_eq!(crate::grid::wrapped([1, 1, 1], 0), None);
    // However long and thin.
    assert_eq!(crate::grid::wrapped([1 << 17, 3, 1], 100).unwrap(), [16_384, 4, 1]);
}

#[test]
fn a_scene_may_have_no_fluid_and_a_domain_of_one_spacing() {
    let empty = &SMALL[..SMALL.find("[[fluid]]").unwrap()];
    assert_eq!(fill::count(&load(empty, &[]).unwrap()), 0);
    let tight = ["domain.max_m=[0.1, 0.1, 0.1]"];
    let scene = load(empty, &tight).unwrap();
    assert_eq!(crate::grid::cells(&scene), [1; 3]);
}

#[test]
fn velocities_spread_within_their_bounds_and_alike_in_every_run() {
    let spread = ["spacing_m=0.02", "fluid.0.velocity_m_s=[1,0,0]", "fluid.0.velocity_spread_m_s=[0.5,2,0]"];
    let scene = load(SMALL, &spread).unwrap();
    let velocities = sample_lattice(&scene).velocities;
    let again = sample_lattice(&scene).velocities;
    assert_eq!(velocities, again);
    for (axis, low, high) in [(0, 0.5, 1.5), (1, -2.0, 2.0), (2, 0.0, 0.0)] {
        let along = || velocities.iter().map(|v| v.velocity_m_s[axis]);
        let (least, most) = along().fold((f32::MAX, f32::MIN), |(a, b), v| (a.min(v), b.max(v)));
        let edge = 0.1 * (high - low);
        assert!((low..=low + edge).contains(&least) && (high - edge..=high).contains(&most), "{axis}: {least} {most}");
    }
    let flat = ["domain.dimensions=2", "fluid.0.velocity_spread_m_s=[0,0,1]"];
    assert!(
        load(SMALL, &flat)
            .unwrap_err()
            .to_string()
            .contains("fluid.0.velocity_spread_m_s = [0, 0, 1]: must be 0 along z")
    );
}

#[test]
fn a_scene_is_written_in_the_order_of_scene_files() {
    let scene = load(SMALL, &["summary=x", "camera.eye_m=[3, 1, 4]", "camera.target_m=[0, 0, 0]"]).unwrap();
    let text = scene.to_toml();
    let parts = ["summary", "spacing_m", "[domain]", "[[fluid]]", "[solver]", "dt_s", "substeps", "[solver.pbf]"];
    let parts = parts.into_iter().chain(["iterations", "[forces]", "xsph", "[surface]", "[camera]", "[outputs]"]);
    let at: Vec<usize> = parts.map(|part| text.find(&format!("\n{part}")).unwrap_or(0)).collect();
    assert!(at.is_sorted() && at.iter().filter(|at| **at == 0).count() == 1, "{at:?} in {text}");
}

/// One wrong thing each, of a scene with a hollow cylinder that moves along keyframes.
#[test]
fn messages_about_solids_name_the_solid_and_what_is_allowed() {
    let solid = "[[solid]]\ncylinder = { radius_m = 0.3, length_m = 0.6 }\nthickness_m = 0.1\nopen = \"y_max\"\n\
        [[solid.keyframe]]\ntime_s = 0\ncentre_m = [0.6, 0.5, 0.5]\n[[solid.keyframe]]\ntime_s = 1\ncentre_m = [0.6, 0.6, 0.5]\n";
    let text = SMALL.to_string() + solid;
    assert!(load(&text, &[]).is_ok());
    let cases: &[(&[&str], &[&str])] = &[
        (
            &["solid.0.sphere={ radius_m = 1 }"],
            &[
                "solid.0 = 2 shapes",
                "one of `box`, `sphere`, `capsule`, `cylinder`, `mesh`, `hull`, `wheel` and `terrain`",
            ],
        ),
        (&["solid.0.cylinder.radius_m=0"], &["solid.0.cylinder.radius_m = 0", "1e-6 to"]),
        (&["solid.0.cylinder.radius_m=0.15"], &["a radius of 0.05 m", "at least h/2 = 0.1 m"]),
        (&["solid.0.thickness_m=0.3"], &["solid.0.thickness_m = 0.3", "below 0.3"]),
        (&["solid.0.open=x_min"], &["solid.0.open = \"x_min\"", "\"y_min\" or \"y_max\" or \"ends\""]),
        (&["solid.0.keyframe.1.time_s=0"], &["solid.0.keyframe.1.time_s = 0", "after the one before, 0"]),
        (&["solid.0.keyframe.1.time_s=0.001"], &["solid.0.keyframe.1 = ", "m a substep", "at most a spacing, 0.1 m"]),
        (&["solid.0.centre_m=[1, 0, 0]"], &["solid.0.keyframe = 2 keyframes", "not with centre_m"]),
        (&["solid.0.friction=-1"], &["solid.0.friction = -1", "0 to 10"]),
        (&["solid.0.restitution=2"], &["solid.0.restitution = 2", "0 to 1"]),
        (&["domain.periodic=[true, false, false]", "domain.max_m.0=1.6"], &["solid = 1 solids", "domain.periodic"]),
        (&["domain.dimensions=2"], &["solid = 1 solids", "domain.dimensions = 2"]),
    ];
    for (settings, parts) in cases {
        let message = load(&text, settings).unwrap_err();
        assert!(parts.iter().all(|part| message.contains(part)), "{settings:?}: {message}");
    }
    let many = SMALL.to_string() + &"[[solid]]\nsphere = { radius_m = 0.1 }\n".repeat(129);
    assert!(load(&many, &[]).unwrap_err().contains("solid = 129 solids: at most 128"));
    let spinning = SMALL.to_string() + "[[solid]]\nbox = { size_m = [1, 1, 1] }\nspin_deg_s = [0, 1e5, 0]\n";
    assert!(load(&spinning, &[]).unwrap_err().contains("solid.0.spin_deg_s"));
}

/// Particles are where no solid is, and their number is known without making them.
#[test]
fn fluid_is_filled_around_solids_and_into_hollow_ones() {
    let filled = |solid: &str| {
        let scene = load(
            &SMALL.replace("[0.3, 0.2, 0.1]", "[1, 1, 1]").replace("spacing_m = 0.1", "spacing_m = 0.05").add(solid),
            &[],
        );
        let scene = scene.unwrap();
        let particles = sample_lattice(&scene).positions;
        assert_eq!(fill::count(&scene), particles.len() as u64);
        particles.len()
    };
    let all = filled("");
    assert_eq!(all, 8000);
    // A box of ten spacings keeps its particles and half a spacing around them free.
    let solid = filled("[[solid]]\nbox = { size_m = [0.5, 0.5, 0.5] }\ncentre_m = [0.5, 0.5, 0.5]\n");
    assert_eq!(all - solid, 1000);
    // Two spacings of wall: of ten by ten by ten places six by six by six and, where it is open, two layers more.
    let hollow = filled(
        "[[solid]]\nbox = { size_m = [0.5, 0.5, 0.5] }\ncentre_m = [0.5, 0.5, 0.5]\nthickness_m = 0.1\nopen = \"y_max\"\n",
    );
    assert_eq!(hollow - solid, 6 * 6 * 8);
}
