//! What the fluid pushes solids with, as measurements tell it: all that it loses of its momentum, and its weight at rest.

use brooklet_fluid::{FrameRequest, Scene, Session, Stats};
use brooklet_tests::{gpu, gpu_of_long_run, small};
use glam::DVec3;

const METHODS: [&str; 4] = ["pbf", "sph", "dfsph", "none"];

/// One measurement: time, what it says, and the forces.
fn measured(session: &mut Session) -> (f64, Stats, Vec<DVec3>) {
    session.measure().unwrap();
    let report = session.finish().unwrap().into_iter().rfind(|report| report.stats.is_some()).unwrap();
    let forces_n = report.forces_n.iter().copied().map(DVec3::from_array).collect();
    (report.simulated_s, report.stats.unwrap(), forces_n)
}

/// A drop hits a ball that stands. Sums are of whole units, and a velocity is rounded to 1e-7 of itself in each substep.
#[test]
fn a_force_is_the_momentum_that_the_fluid_loses() {
    let text = "spacing_m = 0.025\ngravity_m_s2 = [0, 0, 0]\n[domain]\nwalls = false\nmin_m = [0, 0, 0]\nmax_m = [1, 1, 1]\n\
         [[fluid]]\nsphere = { centre_m = [0.3, 0.5, 0.5], radius_m = 0.12 }\nvelocity_m_s = [2, 0.2, 0]\n\
         [[solid]]\nsphere = { radius_m = 0.03 }\ncentre_m = [0.9, 0.9, 0.9]\nmeasure_force = true\n\
         [[solid]]\nsphere = { radius_m = 0.1 }\ncentre_m = [0.55, 0.5, 0.5]\nmeasure_force = true\n\
         [outputs]\nmeasure_every_steps = 1\n";
    for method in METHODS {
        let scene = Scene::from_toml(text, "hit", &[format!("solver.method={method}")]).unwrap();
        let mut session = Session::new(&gpu(), &scene).unwrap();
        let (_, begin, _) = measured(&mut session);
        let begin = DVec3::from_array(begin.momentum_kg_m_s);
        let (mut given, mut before_s, mut lost) = (DVec3::ZERO, 0.0, DVec3::ZERO);
        for _ in 0..if small() { 2 } else { 8 } {
            (0..4).for_each(|_| session.step().unwrap());
            let (time_s, stats, forces_n) = measured(&mut session);
            assert_eq!((forces_n.len(), forces_n[0]), (2, DVec3::ZERO), "nothing touches the first");
            given += forces_n[1] * (time_s - before_s);
            lost = begin - DVec3::from_array(stats.momentum_kg_m_s);
            before_s = time_s;
        }
        println!("{method}: {given} given, {lost} lost of {begin} kg m/s");
        assert!(small() || lost.length() > 0.1 * begin.length(), "{method}: it hits");
        assert!(given.distance(lost) < 1e-4 * begin.length(), "{method}: {given}, not {lost}");
        assert!(
            small() || given.distance(1.01 * lost) > 1e-4 * begin.length(),
            "{method}: a hundredth more is told apart"
        );
    }
}

/// Water on a floor, beside a wall of two halves. All that solids bear of it is its weight, to the hundredth that sloshing leaves
/// in the mean of half a second, and half of that across the wall, where a layer is a tenth of the height. Who stands in the
/// corner, a tenth of the floor's layer, pushes the nearer of the two with all that both are pushed.
#[test]
fn water_at_rest_weighs_on_its_floor_and_leans_on_its_side() {
    let text = "spacing_m = 0.02\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [0.28, 0.4, 0.2]\n\
         [[fluid]]\nblock = { min_m = [0.08, 0.06, 0], max_m = [0.28, 0.26, 0.2] }\n\
         [[solid]]\nbox = { size_m = [0.6, 0.06, 0.4] }\ncentre_m = [0.14, 0.03, 0.1]\nmeasure_force = true\n\
         [[solid]]\nbox = { size_m = [0.08, 0.1, 0.4] }\ncentre_m = [0.04, 0.11, 0.1]\nmeasure_force = true\n\
         [[solid]]\nbox = { size_m = [0.08, 0.24, 0.4] }\ncentre_m = [0.04, 0.28, 0.1]\nmeasure_force = true\n\
         [outputs]\nmeasure_every_steps = 1\n";
    for method in ["pbf", "sph", "dfsph"] {
        let scene = Scene::from_toml(text, "rest", &[format!("solver.method={method}")]).unwrap();
        let weight_n = scene.particle_count() as f64 * scene.particle_mass_kg() * 9.81;
        let mut session = Session::new(&gpu_of_long_run(&scene), &scene).unwrap();
        let half_s = |session: &mut Session| {
            let steps = if small() { 2 } else { (0.5 / scene.solver.dt_s) as u32 };
            session.submit(&FrameRequest { steps, ..FrameRequest::default() }).unwrap();
            measured(session).2
        };
        half_s(&mut session);
        let forces_n = half_s(&mut session);
        if small() {
            continue;
        }
        let [floor, lower, upper] = [forces_n[0], forces_n[1], forces_n[2]];
        println!("{method}: floor {floor}, lower half {lower}, upper half {upper} of {weight_n} N");
        let all = floor + lower + upper;
        assert!((all.y + weight_n).abs() < 0.01 * weight_n, "{method}: {all} N of {weight_n}");
        assert!((all.x + 0.5 * weight_n).abs() < 0.05 * weight_n, "{method}: {all} N of {weight_n}");
        // Of a wall as high as wide the lower half bears 3/8 of the weight, the upper 1/8.
        assert!((floor.y + weight_n).abs() < 0.12 * weight_n, "{method}: {floor} N of {weight_n}");
        assert!((lower.x + 0.375 * weight_n).abs() < 0.08 * weight_n, "{method}: {lower} N of {weight_n}");
        assert!((upper.x + 0.125 * weight_n).abs() < 0.03 * weight_n, "{method}: {upper} N of {weight_n}");
        assert!(all.z.abs() < weight_n / 100.0, "{method}: {all} N");
    }
}
