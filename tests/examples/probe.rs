//! temporary
use brooklet_fluid::{Scene, Session};
use brooklet_fluid::particles::is_simulated;
use brooklet_tests::gpu;
fn main() {
    let mut args = std::env::args().skip(1);
    let scene = args.next().unwrap();
    let steps: u32 = args.next().unwrap().parse().unwrap();
    let every: u32 = args.next().unwrap().parse().unwrap();
    let settings: Vec<String> = args.collect();
    let scene = Scene::load(&scene, &settings).unwrap();
    println!("substeps {} limit {:.2e} steady {:.2e} k {:.1} nu {:.2e} n {}", scene.substeps(), scene.sound_limit_s(), scene.steady_limit_s(), scene.stiffness_m2_s2(), scene.sph_viscosity_m2_s(), scene.particle_count());
    let mut session = Session::new(&gpu(), &scene).unwrap();
    let d = scene.fitted_spacing_m();
    let t = std::time::Instant::now();
    for k in 0..=steps {
        if k % every == 0 {
            session.measure().unwrap();
            session.finish().unwrap();
            let s = session.stats().unwrap();
            let p = session.read_particles().unwrap();
            let mut ys: Vec<f32> = p.positions.iter().filter(|p| is_simulated(p.tag)).map(|p| p.position_m[1]).collect();
            ys.sort_by(f32::total_cmp);
            let near: Vec<String> = (0..3).map(|a| { let size = scene.domain.size_m()[a]; let lo = p.positions.iter().filter(|p| f64::from(p.position_m[a]) < 0.75 * d).count(); let hi = p.positions.iter().filter(|p| f64::from(p.position_m[a]) > size - 0.75 * d).count(); format!("{lo}/{hi}") }).collect();
            println!("t {:.3} comp {:.4}/{:.4}/{:.4} err {:.4} kin {:.3e} E {:.4} vmax {:.3} com y {:.5} front {:.3} ymin {:.4} ymax {:.4} walls {:?} q {} esc {} long {} P {:.2e}",
                session.simulated_s(), s.compression.mean, s.compression.p99, s.compression.max, s.density_error.mean, s.kinetic_j, s.kinetic_j + s.potential_j, s.max_speed_m_s, s.centre_of_mass_m[1], s.front_m, ys[0], ys[ys.len() - 1], near, s.quarantined, s.escaped, s.counters.long_substeps, s.momentum_kg_m_s[0].hypot(s.momentum_kg_m_s[1]).hypot(s.momentum_kg_m_s[2]));
            if std::env::var("LAYERS").is_ok() {
                let n = (ys[ys.len()-1] as f64 / d).ceil() as usize + 1;
                let mut c = vec![0; 2*n+2];
                for y in &ys { c[(f64::from(*y) / d * 2.0) as usize] += 1; }
                println!("   half-spacing bins {c:?}");
            }
        }
        session.step().unwrap();
    }
    session.finish().unwrap();
    println!("{:.1} s", t.elapsed().as_secs_f64());
}
