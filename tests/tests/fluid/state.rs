//! A saved state goes on as the run it was taken of, and a file that is not one is refused with a reason.

use brooklet_fluid::particles::{ParticleSet, sample_lattice};
use brooklet_fluid::state::{State, StateError};
use brooklet_fluid::{Scene, Session};
use brooklet_kernels::QUARANTINED;
use brooklet_tests::states::{OLD_SCENE, of_version, patched, sections_at, state_of, version_1, with_section};
use brooklet_tests::{gpu, rng};
use rand::{Rng, RngExt};

fn scene(settings: &[&str]) -> Scene {
    let settings: Vec<String> = ["spacing_m=0.08"].iter().chain(settings).map(|&s| s.into()).collect();
    Scene::load("dam-break", &settings).unwrap()
}

fn state() -> State {
    let scene = scene(&["fluid.0.velocity_m_s=[0.25,-1,0.5]"]);
    let particles = sample_lattice(&scene);
    state_of(scene, particles, 30, 0.125)
}

fn bits(particles: &ParticleSet) -> (&[u8], &[u8]) {
    (bytemuck::cast_slice(&particles.positions), bytemuck::cast_slice(&particles.velocities))
}

#[test]
fn a_state_comes_back_as_it_was() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("pool.brooklet");
    let saved = state();
    saved.save(&path).unwrap();
    // A second time over the first, and nothing else is left.
    saved.save(&path).unwrap();
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    let loaded = State::load(&path).unwrap();
    assert_eq!(loaded.scene, saved.scene);
    assert_eq!((loaded.time_s, loaded.steps), (0.125, 30));
    assert_eq!(bits(&loaded.particles), bits(&saved.particles));
}

#[test]
fn going_on_from_a_saved_state_is_going_on() {
    let scene = scene(&["solver.deterministic=true", "forces.vorticity_m_s=0.05"]);
    let gpu = gpu();
    let mut session = Session::new(&gpu, &scene).unwrap();
    let run = |session: &mut Session| {
        for _ in 0..12 {
            session.step().unwrap();
        }
        session.read_particles().unwrap()
    };
    let particles = run(&mut session);
    let bytes = state_of(scene.clone(), particles, 12, 12.0 * scene.solver.dt_s).to_bytes();
    let expected = run(&mut session);

    let restored = State::from_bytes(&bytes, "restored").unwrap();
    let mut again = Session::new(&gpu, &restored.scene).unwrap();
    again.write_particles(&restored.particles);
    let got = run(&mut again);
    assert!(bits(&got) == bits(&expected), "bit for bit");
    let start = sample_lattice(&scene);
    again.write_particles(&start);
    assert!(bits(&run(&mut again)) != bits(&expected), "another start ends elsewhere");
}

#[test]
fn ages_come_back_and_bad_ones_are_refused() {
    let mut state = state();
    let plain = state.to_bytes().len();
    for (i, velocity) in state.particles.velocities.iter_mut().enumerate() {
        velocity.age_s = i as f32 / 64.0;
    }
    let bytes = state.to_bytes();
    let count = state.particles.positions.len();
    assert_eq!(bytes.len(), plain + 16 + 4 * count, "the section and its head");
    let loaded = State::from_bytes(&bytes, "aged").unwrap();
    assert_eq!(bits(&loaded.particles), bits(&state.particles));
    state.particles.velocities[7].age_s = -1.0;
    let loaded = State::from_bytes(&state.to_bytes(), "aged").unwrap();
    assert_eq!(bits(&loaded.particles), bits(&state.particles), "what is left of a lifetime, too");
    let nan: Vec<u8> = (0..count).flat_map(|_| f32::NAN.to_le_bytes()).collect();
    let bad = with_section(&state_without_ages(&state), b"AGES", 1, 0, &nan);
    let message = State::from_bytes(&bad, "aged").map(drop).unwrap_err().to_string();
    assert!(message.contains("state aged: the age of particle 0 is NaN s; it must be finite"), "{message}");
    let short = with_section(&state_without_ages(&state), b"AGES", 1, 0, &[0; 8]);
    let message = State::from_bytes(&short, "aged").unwrap_err().to_string();
    assert!(message.contains(&format!("section AGES has 8 bytes, and its {count} particles take")), "{message}");
}

fn state_without_ages(state: &State) -> Vec<u8> {
    let mut young = state.clone();
    young.particles.velocities.iter_mut().for_each(|velocity| velocity.age_s = 0.0);
    young.to_bytes()
}

#[test]
fn what_is_not_finite_is_saved_as_the_next_step_would_leave_it() {
    let mut state = state();
    state.particles.positions[3].position_m[1] = f32::NAN;
    state.particles.velocities[5].velocity_m_s[0] = f32::INFINITY;
    let loaded = State::from_bytes(&state.to_bytes(), "state").unwrap();
    for (i, (position, velocity)) in loaded.particles.positions.iter().zip(&loaded.particles.velocities).enumerate() {
        assert_eq!(position.tag & QUARANTINED != 0, i == 3 || i == 5);
        if i == 3 || i == 5 {
            assert_eq!((position.position_m, velocity.velocity_m_s), ([0.0; 3], [0.0; 3]));
        }
    }
}

#[test]
fn a_state_of_the_version_before_opens_with_its_settings_where_they_are_now() {
    let state = state();
    let bytes = version_1(&state, OLD_SCENE);
    let loaded = State::from_bytes(&bytes, "old").unwrap();
    let settings = [
        "fluid.0.velocity_m_s=[0.25,-1,0.5]",
        "summary=old",
        "solver.deterministic=true",
        "solver.pbf.iterations=7",
        "solver.pbf.acceleration=none",
        "solver.pbf.relaxation=0.4",
        "solver.pbf.cfm=0.02",
        "solver.pbf.s_corr_k=0.001",
        "solver.pbf.s_corr_distance_ratio=0.3",
        "forces.xsph=0.05",
        "forces.vorticity_m_s=0.125",
    ];
    assert_eq!(loaded.scene, scene(&settings));
    assert_eq!((loaded.time_s, loaded.steps), (state.time_s, state.steps));
    assert_eq!(bits(&loaded.particles), bits(&state.particles));
    let again = State::from_bytes(&loaded.to_bytes(), "new").unwrap();
    assert_eq!(again.scene, loaded.scene, "and is saved as the new version");
    // The same with a list of sections.
    let at = sections_at(&bytes);
    let length = 28 * state.particles.positions.len() as u64;
    let list = [&b"\x01\0\0\0PART\x01\0\0\0"[..], &length.to_le_bytes()].concat();
    let newer = of_version(&[&bytes[..at], &list, &bytes[at..]].concat(), 2);
    let newer = State::from_bytes(&newer, "newer").expect_err("old keys in a new file").to_string();
    assert!(newer.contains("solver.iterations = 7 is now solver.pbf.iterations"), "{newer}");
    for (damage, words) in [
        (bytes[..bytes.len() - 1].to_vec(), "it is cut off"),
        ([&bytes[..], &[0]].concat(), "and ends at"),
        (patched(&bytes, bytes.len() - 8, &f32::NAN.to_le_bytes()), "the velocity of particle"),
        (version_1(&state, &OLD_SCENE.replace("iterations = 7", "iterations = -7")), "solver.pbf.iterations = -7"),
        (version_1(&state, &OLD_SCENE.replace("iterations = 7", "iterations 7")), "its scene"),
    ] {
        let error = State::from_bytes(&damage, "old.brooklet").expect_err(words).to_string();
        assert!(error.starts_with("state old.brooklet: ") && error.contains(words), "{error}");
    }
}

fn replaced(bytes: &[u8], text: &str, with: &str) -> Vec<u8> {
    assert_eq!(text.len(), with.len());
    let at = bytes.windows(text.len()).position(|window| window == text.as_bytes()).unwrap();
    patched(bytes, at, with.as_bytes())
}

#[test]
fn every_fault_is_one_line_that_names_the_file_and_what_is_wrong() {
    let state = state();
    let good = state.to_bytes();
    let count = state.particles.positions.len();
    let particles_at = good.len() - 4 - 28 * count;
    let mut flipped = good.clone();
    flipped[particles_at + 5] ^= 1;
    let mut longer = good.clone();
    longer.push(0);
    let count_text = format!("\"particles\":{count}");
    let more_text = format!("\"particles\":{}", count + 1);
    let nan = f32::NAN.to_le_bytes();
    for (bytes, words) in [
        (Vec::new(), "it is no saved state"),
        (b"BROOK".to_vec(), "it is no saved state"),
        (b"\x89PNG\r\n\x1a\n and so on".to_vec(), "it is no saved state"),
        (of_version(&good, 3), "version 3 of the format, and this program reads versions 1 to 2"),
        (of_version(&good, 0), "version 0 of the format, and this program reads versions 1 to 2"),
        (good[..14].to_vec(), "it is cut off"),
        (good[..100].to_vec(), "it is cut off: it has 100 bytes of"),
        (good[..good.len() - 1].to_vec(), "it is cut off"),
        (longer, "and ends at"),
        (flipped, "its checksum is another"),
        (patched(&good, 12, &u32::MAX.to_le_bytes()), "its header has 4294967295 bytes"),
        (patched(&good, 16, b"?"), "its header is damaged"),
        (replaced(&good, &count_text, &more_text), "its section PART has"),
        (replaced(&good, "\"time_s\":0.125", "\"time_s\":-1.25"), "its time is -1.25 s"),
        (replaced(&good, "spacing_m = 0.08", "spacing_m = -.08"), "its scene"),
        (replaced(&good, "spacing_m = 0.08", "spacing_m = 9e99"), "its scene"),
        (patched(&good, particles_at + 16 * 2 + 4, &nan), "the position of particle 2 is"),
        (patched(&good, particles_at + 16 * count + 12 * 7, &nan), "the velocity of particle 7 is"),
        (patched(&good, particles_at + 12, &9u32.to_le_bytes()), "particle 9 has the id 9"),
        (patched(&good, particles_at + 12, &0x00ff_ffffu32.to_le_bytes()), "particle 0 has the id 16777215"),
    ] {
        let error = State::from_bytes(&bytes, "some.brooklet").expect_err(words).to_string();
        assert!(error.starts_with("state some.brooklet: ") && error.contains(words), "{error}");
        assert_eq!(error.lines().count(), 1, "{error}");
    }
    let folder = tempfile::tempdir().unwrap();
    let missing = folder.path().join("none.brooklet");
    assert!(matches!(State::load(&missing), Err(StateError::Io { doing: "read", .. })));
    let nowhere = folder.path().join("no/such/folder.brooklet");
    assert!(matches!(state.save(&nowhere), Err(StateError::Io { doing: "written", .. })));
    assert!(State::load(folder.path()).is_err(), "a folder");
}

#[test]
fn sections_of_newer_programs_are_told_or_left_out() {
    let state = state();
    let good = state.to_bytes();
    let count = state.particles.positions.len() as u64;
    let at = sections_at(&good);
    assert_eq!(good[at..at + 12], *b"\x01\0\0\0PART\x01\0\0\0");
    assert_eq!(good[at + 12..at + 20], (28 * count).to_le_bytes());
    let refused = |bytes: &[u8]| State::from_bytes(bytes, "newer.brooklet").expect_err("refused").to_string();
    for content in [&b""[..], b"what a later version knows"] {
        let message = refused(&with_section(&good, b"EMIT", 1, 0, content));
        for words in ["state newer.brooklet: ", "a section EMIT of version 1", "a newer one, 0.1.0, wrote it"] {
            assert!(message.contains(words), "{message}");
        }
        // Unknown, and nothing that is needed.
        let loaded = State::from_bytes(&with_section(&good, b"LOOK", 3, 1, content), "newer").unwrap();
        assert_eq!(loaded.scene, state.scene);
        assert_eq!(bits(&loaded.particles), bits(&state.particles));
    }
    assert!(refused(&with_section(&good, b"\n\xff\"A", 1, 0, b"")).contains("a section \\n\\xff\\\"A of version 1"));
    assert!(refused(&with_section(&good, b"PART", 1, 0, b"")).contains("two sections PART"));
    // A section that is known, in a later version of it.
    assert!(refused(&patched(&good, at + 8, &2u16.to_le_bytes())).contains("a section PART of version 2"));
    let skipped = patched(&good, at + 8, &[2, 0, 1, 0]);
    assert!(refused(&skipped).contains("no section PART of version 1"));
    let none = patched(&good[..good.len() - 28 * count as usize - 16], at, &0u32.to_le_bytes());
    assert!(refused(&none).contains("no section PART of version 1"));
    // Lengths and counts that lead out of the file.
    for (offset, number) in [(12, u64::MAX), (12, good.len() as u64), (12, u64::MAX - 30)] {
        assert!(refused(&patched(&good, at + offset, &number.to_le_bytes())).contains("it is cut off"));
    }
    assert!(refused(&patched(&good, at, &u32::MAX.to_le_bytes())).contains("it is cut off"));
    assert!(refused(&patched(&good, at + 12, &(28 * count - 28).to_le_bytes())).contains("and ends at"));
    // Damage is told before what it made of the sections' names.
    let mut damaged = good.clone();
    damaged[at + 4] = b'Q';
    assert!(refused(&damaged).contains("its checksum is another"));
}

#[test]
fn no_damage_is_taken_for_a_state_and_none_ends_the_program() {
    let good = state().to_bytes();
    let mut rng = rng(91);
    for case in 0..3000 {
        let mut bytes = good.clone();
        match case % 3 {
            0 => bytes.truncate(rng.random_range(0..good.len())),
            1 => {
                for _ in 0..rng.random_range(1..4) {
                    let at = rng.random_range(0..bytes.len());
                    bytes[at] ^= 1u8 << rng.random_range(0..8);
                }
            }
            _ => {
                // Damage with a right checksum: it may only be refused, or give a state that is whole.
                let at = rng.random_range(0..good.len() - 8);
                let mut with = [0u8; 4];
                rng.fill_bytes(&mut with);
                bytes = patched(&good, at, &with);
            }
        }
        match State::from_bytes(&bytes, "damaged") {
            Err(error) => assert_eq!(error.to_string().lines().count(), 1, "{error}"),
            Ok(state) => {
                assert!(case % 3 == 2 || bytes == good, "case {case} was taken");
                let numbers = state.particles.positions.iter().flat_map(|p| p.position_m);
                assert!(
                    numbers.chain(state.particles.velocities.iter().flat_map(|v| v.velocity_m_s)).all(f32::is_finite)
                );
            }
        }
    }
}
