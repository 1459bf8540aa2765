//! Each message that a bad scene gets.

use super::Scene;
use super::tests::{SMALL, load};

#[test]
fn messages_name_file_field_value_and_what_is_allowed() {
    let message = |text: &str, settings: &[&str]| load(text, settings).unwrap_err();
    let fluids = |count: usize| {
        SMALL.to_string() + &"[[fluid]]\nblock = { min_m = [0, 0, 0], max_m = [0.3, 0.2, 0.1] }\n".repeat(count)
    };
    let long = format!("summary = \"{}\"\n{SMALL}", "x".repeat(2_000_000));
    let cases: &[(String, &[&str])] = &[
        (message(&SMALL.replace("spacing_m", "spacin_m"), &[]), &["small.toml:1:1", "`spacin_m`", "`spacing_m`"]),
        (message(SMALL, &["solver.pbf.iteration=3"]), &["`iteration`", "`iterations`"]),
        (message(&SMALL.replace("0.1\n", "-1\n"), &[]), &["spacing_m = -1", "1e-6 to 1000 m"]),
        (message(&SMALL.replace("0.1\n", "'a'\n"), &[]), &["small.toml:1:13: spacing_m = \"a\"", "a number from"]),
        (message("spacing_m = 1\nspacing_m = 2\n", &[]), &["small.toml:2:1: duplicate key", "spacing_m = 2"]),
        (message("spacing_m = ", &[]), &["small.toml:1:"]),
        (message("", &[]), &["spacing_m is missing", "a number from"]),
        (message("[domain]\nmin_m=[0,0,0]\nmax_m=[1,1,1]", &[]), &["spacing_m is missing"]),
        (message("spacing_m=1\n[domain]\nmin_m=[0,0,0]", &[]), &["domain.max_m is missing", "three numbers"]),
        (message(&long, &[]), &["small.toml", "1048576 bytes"]),
        (
            message(SMALL, &["fluid.0.block.max_m=[2,1,1]"]),
            &["fluid.0.block = [0, 0, 0] to [2, 1, 1]", "inside the domain"],
        ),
        (message(SMALL, &["fluid.0.block.max_m=[0.05,1,1]"]), &["fluid.0.block", "no room", "spacing_m = 0.1"]),
        (message(SMALL, &["fluid.0.block.max_m=[0,1,1]"]), &["fluid.0.block.max_m = [0, 1, 1]", "above min_m"]),
        (message(SMALL, &["fluid.0={}"]), &["fluid.0 = nothing", "`block`, `sphere` and `cylinder`"]),
        (
            message(SMALL, &["fluid.0.sphere={centre_m=[0,0,0], radius_m=1}"]),
            &["fluid.0 = a block and a sphere", "give it one of"],
        ),
        (message(SMALL, &["fluid.3.velocity_m_s=[1,0,0]"]), &["--set fluid.3", "below 1"]),
        (message(&fluids(1), &["fluid.1.rest_density_kg_m3=900"]), &["fluid.1.rest_density_kg_m3 = 900", "1000"]),
        (message(&fluids(128), &[]), &["fluid = 129 fluids", "at most 127"]),
        (message(SMALL, &["solver"]), &["--set solver", "path=value"]),
        (message(SMALL, &[".=1"]), &["--set .=1", "empty"]),
        (message(SMALL, &["a.b.c.d.e.f.g.h.i=1"]), &["--set a.b.c", "9 keys"]),
        (message(SMALL, &["spacing_m.x=1"]), &["--set spacing_m.x=1", "`x` lies below"]),
        (message(SMALL, &["domain.max_m=[0,1,1]"]), &["domain.max_m", "above min_m"]),
        (message(SMALL, &["domain.max_m=[0.01,1,1]"]), &["domain = [0.01, 1, 1] m", "at least spacing_m = 0.1"]),
        (message(SMALL, &["domain.max_m=[1e5,1,1]"]), &["domain", "65536 spacings", "spacing_m 1.53 or more"]),
        (
            message(SMALL, &["solver.substeps=1000", "solver.pbf.iterations=11"]),
            &["solver.pbf.iterations = 11", "at most 10000"],
        ),
        (
            message(SMALL, &["spacing_m=0.0034", "fluid.0.block.max_m=[1,1,1]"]),
            &["spacing_m = 0.0034", "2.541e7 particles", "16777216 fit", "make it 0.00395 or more"],
        ),
        (
            message(SMALL, &["spacing_m=0.004", "fluid.0.block.max_m=[1,1,1]", "solver.neighbour_slots=1024"]),
            &["solver.neighbour_slots = 1024", "15625000 particles can have 274"],
        ),
        (
            message(SMALL, &["domain.faces.y_min.slip=no-slip"]),
            &["domain.faces.y_min.slip = \"no-slip\"", "needs a viscosity", "\"pbf\" does not have"],
        ),
        (
            message(SMALL, &["domain.faces.y_min.friction=0.01"]),
            &["domain.faces.y_min.friction = 0.01", "needs slip = \"friction\""],
        ),
        (
            message(SMALL, &["domain.faces.x_max={ slip = \"friction\", velocity_m_s = [1, 0, 0] }"]),
            &["domain.faces.x_max.velocity_m_s = [1, 0, 0]", "must be 0 along x"],
        ),
        (
            message(SMALL, &["domain.faces.x_max.velocity_m_s=[0, 1, 0]"]),
            &["domain.faces.x_max.velocity_m_s = [0, 1, 0]", "needs slip = \"no-slip\" or \"friction\""],
        ),
        (
            message(SMALL, &["domain.walls=false", "domain.faces.z_min={}"]),
            &["domain.faces.z_min", "no wall stands across z"],
        ),
        (message(SMALL, &["domain.faces.floor.slip=friction"]), &["`floor`", "y_min"]),
        (
            message(SMALL, &["domain.wall.model=springs"]),
            &["domain.wall.model", "springs", "pressure", "distance", "penalty", "deflection"],
        ),
        (
            message(SMALL, &["domain.walls=false", "domain.wall.model=penalty"]),
            &["domain.wall.model = \"penalty\"", "no walls"],
        ),
        (
            message(SMALL, &["solver.method=dfsph", "domain.wall.model=distance"]),
            &["domain.wall.model = \"distance\"", "methods that have it: pbf, sph"],
        ),
        (
            message(SMALL, &["domain.wall.model=penalty", "solid=[{ sphere = { radius_m = 0.2 } }]"]),
            &["domain.wall.model = \"penalty\"", "not with [[solid]]"],
        ),
        (
            message(SMALL, &["domain.wall.damping_per_s=3"]),
            &["domain.wall.damping_per_s = 3", "needs model = \"penalty\"", "model = \"pressure\""],
        ),
        (
            message(SMALL, &["domain.wall={ model = \"penalty\", restitution = 0.5 }"]),
            &["domain.wall.restitution = 0.5", "needs model = \"deflection\""],
        ),
        (message(SMALL, &["domain.wall.stiffness_per_s2=-1"]), &["domain.wall.stiffness_per_s2 = -1", "1/s²"]),
        (
            message(SMALL, &["solver.method=none", "domain.wall.model=penalty"]),
            &["domain.wall.model", "methods that have it: pbf, sph"],
        ),
        (
            message(SMALL, &["solver.method=none", "domain.faces.y_min.slip=friction"]),
            &["domain.faces.y_min.slip", "methods that have it: pbf, sph"],
        ),
        (Scene::load("dam-brake", &[]).unwrap_err().to_string(), &["\"dam-brake\"", "dam-break"]),
    ];
    for (message, parts) in cases {
        for part in *parts {
            assert!(message.contains(part), "{message:?} does not say {part:?}");
        }
        assert!(!message.contains('\n'), "{message:?} has more than one line");
        assert!(message.len() < 400, "{message:?} is long");
    }
}
