//! Saved states, and bytes of ones that no program writes: of other versions of the format, with sections of newer
//! programs.

use brooklet_fluid::diffuse::DiffuseSet;
use brooklet_fluid::particles::ParticleSet;
use brooklet_fluid::state::State;
use brooklet_fluid::{BodyMotion, Scene};

/// A state of nothing but particles.
pub fn state_of(scene: Scene, particles: ParticleSet, steps: u64, time_s: f64) -> State {
    State { scene, time_s, steps, particles, bodies: BodyMotion::default(), diffuse: DiffuseSet::default() }
}

/// The file with other bytes from `at` on, and a checksum that is right again.
pub fn patched(bytes: &[u8], at: usize, with: &[u8]) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    bytes[at..at + with.len()].copy_from_slice(with);
    let end = bytes.len() - 4;
    let checksum = crc32fast::hash(&bytes[..end]);
    bytes[end..].copy_from_slice(&checksum.to_le_bytes());
    bytes
}

/// The file as one of another version of the format.
pub fn of_version(bytes: &[u8], version: u32) -> Vec<u8> {
    patched(bytes, 8, &version.to_le_bytes())
}

/// The bytes that version 1 of the format has of a state whose scene is `scene`, as TOML.
pub fn version_1(state: &State, scene: &str) -> Vec<u8> {
    let header = serde_json::json!({
        "program": "0.1.0",
        "name": state.scene.name,
        "scene": scene,
        "time_s": state.time_s,
        "steps": state.steps,
        "particles": state.particles.positions.len(),
    });
    let header = header.to_string();
    let mut bytes = b"BROOKLET\x01\0\0\0".to_vec();
    bytes.extend((header.len() as u32).to_le_bytes());
    bytes.extend(header.as_bytes());
    for position in &state.particles.positions {
        bytes.extend(position.position_m.iter().flat_map(|x| x.to_le_bytes()));
        bytes.extend(position.tag.to_le_bytes());
    }
    bytes.extend(state.particles.velocities.iter().flat_map(|v| v.velocity_m_s).flat_map(f32::to_le_bytes));
    let checksum = crc32fast::hash(&bytes);
    bytes.extend(checksum.to_le_bytes());
    bytes
}

/// As version 1 wrote it: PBF's keys, XSPH and vorticity in `[solver]`.
pub const OLD_SCENE: &str = "summary = \"old\"\nspacing_m = 0.08\ngravity_m_s2 = [0.0, -9.81, 0.0]\n\
    [domain]\nmin_m = [0.0, 0.0, 0.0]\nmax_m = [1.6, 1.0, 0.6]\nwalls = true\nperiodic = [false, false, false]\ndimensions = 3\n\
    [[fluid]]\nvelocity_m_s = [0.25, -1.0, 0.5]\nrest_density_kg_m3 = 1000.0\n\
    [fluid.block]\nmin_m = [0.0, 0.0, 0.0]\nmax_m = [0.6, 0.68, 0.6]\n\
    [solver]\nmethod = \"pbf\"\ndt_s = 0.004166667\nsubsteps = 1\niterations = 7\nsupport_ratio = 2.0\nrelaxation = 0.4\n\
    cfm = 0.02\ns_corr_k = 0.001\ns_corr_distance_ratio = 0.3\nxsph = 0.05\nvorticity_m_s = 0.125\ndeterministic = true\n\
    precision = \"full\"\npacked_positions = false\n\
    [outputs]\nseconds = 2.0\nimages = 6\nwidth_px = 960\nheight_px = 540\nmeasure_every_steps = 4\n";

/// Where the list of sections starts: behind the header.
pub fn sections_at(bytes: &[u8]) -> usize {
    16 + u32::from_le_bytes(*bytes[12..].first_chunk().unwrap()) as usize
}

/// The file with one section more, in front of the others.
pub fn with_section(bytes: &[u8], name: &[u8; 4], version: u16, flags: u16, content: &[u8]) -> Vec<u8> {
    let at = sections_at(bytes);
    let count = u32::from_le_bytes(*bytes[at..].first_chunk().unwrap());
    let mut more = bytes[..at].to_vec();
    more.extend((count + 1).to_le_bytes());
    more.extend(name);
    more.extend([version.to_le_bytes(), flags.to_le_bytes()].concat());
    more.extend((content.len() as u64).to_le_bytes());
    more.extend(content);
    more.extend(&bytes[at + 4..]);
    patched(&more, 0, b"BROOKLET")
}
