//! A running scene in a file: saved in one go, read back whole or not at all.
//!
//! A running scene is its scene, the time, its particles, bodies, and spray, foam and bubbles. So a saved state goes on bit for
//! bit where sorting is deterministic, and a scene of another spacing takes the fluid over by resampling it. With
//! `solver.pbf.warm_start` the last substep's pressure lasts as well; it is not saved, and the first substep begins cold.
//!
//! A `.brooklet` file is, in this order and little-endian:
//!
//! | bytes | what |
//! |---|---|
//! | 8 | `BROOKLET` |
//! | 4 | version of the format, u32: 2 |
//! | 4 | length of the header in bytes, u32 |
//! | | the header, JSON: program's version, name, scene as TOML, time, steps, number of particles |
//! | 4 | number of sections, u32 |
//! | 16 and its length | each section: name, 4 ASCII characters; its version, u16; flags, u16; length in bytes, u64; content |
//! | 4 | CRC-32 of everything before it, u32 |
//!
//! Of a section's flags bit 0 says that a program which does not know the section may leave it out; without it, a
//! section that is unknown, or of a newer version than is known, refuses the file. Sections are in any order, each once.
//!
//! | section | version | content |
//! |---|---|---|
//! | `PART` | 1 | for each slot, inactive ones too, its position relative to the domain's lowest corner, 3 f32 in m, and its tag, u32 (`shared/layout.hlsli`); then for each its velocity, 3 f32 in m/s |
//! | `AGES` | 1 | for each slot its particle's age, f32 in s, below 0 what is left of its lifetime; there only if some are not 0 |
//! | `FOAM` | 1 | may be left out. The slot that the next diffuse particle takes, u32; then for each slot in use its position relative to the domain's lowest corner (3 f32, m), what is left of its lifetime (f32, s), velocity (3 f32, m/s) and crowd (f32), `diffuse/layout.hlsli`; there only if any is in use |
//! | `BODY` | 1 | for each of the scene's bodies, in the order of its solids, f32: its centre of mass relative to the domain's lowest corner (3, m), rotation (quaternion x, y, z, w), velocity (3, m/s), spin (3, rad/s), and what the fluid owes it, momentum (3, kg m/s) and angular momentum (3, kg m²/s); then the 16 u32 of its reaction (`boundary/bodies/layout.hlsli`); there only if there are any |
//!
//! In version 1 of the format the content of `PART` follows the header, without a list of sections, and the scene has
//! the keys of `[solver.pbf]` and `[forces]` in `[solver]`.

mod bodies;
mod diffuse;
mod sections;

use std::fs::File;
use std::io::{Read, Write};
use std::path::Path;

use brooklet_kernels::{Position, QUARANTINED, REACTION_WORDS, Velocity};
use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::body_motion::BodyMotion;
use crate::diffuse::DiffuseSet;
use crate::particles::{ParticleSet, id_of};
use crate::scene::{MAX_PARTICLES, Scene, SceneError, shortened};
use sections::{Cut, Known, Section};

/// The format's version, which is written.
pub const VERSION: u32 = 2;
/// The oldest version that is read.
const OLDEST: u32 = 1;
/// What files are called by.
pub const EXTENSION: &str = "brooklet";

const MAGIC: &[u8; 8] = b"BROOKLET";
/// Magic, version, length of the header.
const FRONT_BYTES: usize = 16;
const CHECKSUM_BYTES: usize = 4;
const PARTICLE_BYTES: usize = 28;
const AGE_BYTES: usize = 4;
const BODY_FLOATS: usize = 19;
const BODY_BYTES: usize = 4 * (BODY_FLOATS + REACTION_WORDS as usize);
const PARTICLES: Known = Known::new(b"PART");
const AGES: Known = Known::new(b"AGES");
const BODIES: Known = Known::new(b"BODY");
/// Nothing goes wrong without them.
const DIFFUSE: Known = Known { optional: true, ..Known::new(b"FOAM") };
/// Every section that this program knows.
const SECTIONS: &[Known] = &[PARTICLES, AGES, BODIES, DIFFUSE];
/// More than any state has; a device that never ends is none.
const MOST_BYTES: u64 = 1 << 30;
/// A header is a scene, which has at most 1 MiB, and a line.
const MOST_HEADER_BYTES: usize = 4 << 20;

/// A scene, and its particles at some time.
#[derive(Clone, Debug)]
pub struct State {
    /// The scene, with the settings that it runs with.
    pub scene: Scene,
    /// Simulated time, s.
    pub time_s: f64,
    /// Steps done.
    pub steps: u64,
    /// The particles, in any order.
    pub particles: ParticleSet,
    /// How the bodies move.
    pub bodies: BodyMotion,
    /// Spray, foam and bubbles.
    pub diffuse: DiffuseSet,
}

/// Why a state cannot be saved or read.
#[derive(Debug, Error)]
pub enum StateError {
    /// The file cannot be read or written.
    #[error("state {path}: cannot be {doing}: {reason}")]
    Io {
        /// The file.
        path: String,
        /// `read` or `written`.
        doing: &'static str,
        /// What the system says.
        reason: String,
    },
    /// The file is no state, or not a whole one.
    #[error("state {path}: {reason}")]
    Damaged {
        /// The file.
        path: String,
        /// What is wrong with it, and what is allowed.
        reason: String,
    },
    /// The scene in it cannot be run.
    #[error("state {path}: its {error}")]
    Scene {
        /// The file.
        path: String,
        /// What is wrong with it.
        error: Box<SceneError>,
    },
}

/// What is known of a state before its particles are read.
#[derive(Clone, Debug, Serialize, Deserialize)]
struct Header {
    /// Version of the program that wrote it.
    program: String,
    name: String,
    /// The scene as TOML.
    scene: String,
    time_s: f64,
    steps: u64,
    particles: u32,
}

impl State {
    /// Whether a file of this name is a state's.
    pub fn is_file_name(name: &str) -> bool {
        Path::new(name).extension().is_some_and(|ending| ending == EXTENSION)
    }

    /// Writes the state to `path`, whole or not at all: to another name first, which then becomes `path`.
    /// A particle whose numbers are not finite is saved as the next step would leave it: quarantined.
    ///
    /// # Errors
    /// If the system does not let it.
    pub fn save(&self, path: &Path) -> Result<(), StateError> {
        let temporary = path.with_extension(format!("{}.tmp", std::process::id()));
        let written = File::create(&temporary)
            .and_then(|mut file| {
                file.write_all(&self.to_bytes())?;
                file.sync_all()
            })
            .and_then(|()| std::fs::rename(&temporary, path));
        written.map_err(|error| {
            // The first error is the one to report; a left-over temporary file is only litter.
            let _ = std::fs::remove_file(&temporary);
            StateError::Io { path: path.display().to_string(), doing: "written", reason: error.to_string() }
        })
    }

    /// Reads what [`State::save`] wrote.
    ///
    /// # Errors
    /// If the file is no whole state of this version, or its scene or particles are not allowed.
    pub fn load(path: &Path) -> Result<State, StateError> {
        let name = path.display().to_string();
        let unreadable =
            |error: std::io::Error| StateError::Io { path: name.clone(), doing: "read", reason: error.to_string() };
        let file = File::open(path).map_err(unreadable)?;
        let mut bytes = Vec::new();
        file.take(MOST_BYTES + 1).read_to_end(&mut bytes).map_err(unreadable)?;
        if bytes.len() as u64 > MOST_BYTES {
            let reason = format!("it has more than the {MOST_BYTES} bytes that a state may have");
            return Err(StateError::Damaged { path: name, reason });
        }
        Self::from_bytes(&bytes, &name)
    }

    /// The content of a file.
    pub fn to_bytes(&self) -> Vec<u8> {
        let header = Header {
            program: env!("CARGO_PKG_VERSION").to_owned(),
            name: self.scene.name.clone(),
            scene: self.scene.to_toml(),
            time_s: self.time_s,
            steps: self.steps,
            particles: self.particles.positions.len() as u32,
        };
        // Texts and finite numbers are always representable.
        let header = serde_json::to_vec(&header).unwrap_or_default();
        let mut bytes =
            Vec::with_capacity(FRONT_BYTES + header.len() + PARTICLE_BYTES * self.particles.positions.len());
        bytes.extend_from_slice(MAGIC);
        bytes.extend_from_slice(&VERSION.to_le_bytes());
        bytes.extend_from_slice(&(header.len() as u32).to_le_bytes());
        bytes.extend_from_slice(&header);
        let has_ages = self.particles.velocities.iter().any(|velocity| velocity.age_s != 0.0);
        let has_bodies = !self.bodies.states.is_empty();
        let has_diffuse = !self.diffuse.particles.is_empty();
        let sections = 1 + [has_ages, has_bodies, has_diffuse].map(u32::from).iter().sum::<u32>();
        bytes.extend_from_slice(&sections.to_le_bytes());
        sections::append(&mut bytes, PARTICLES, |bytes| append_particles(bytes, &self.particles));
        if has_ages {
            sections::append(&mut bytes, AGES, |bytes| append_ages(bytes, &self.particles));
        }
        if has_bodies {
            sections::append(&mut bytes, BODIES, |bytes| bodies::append(bytes, &self.bodies));
        }
        if has_diffuse {
            sections::append(&mut bytes, DIFFUSE, |bytes| diffuse::append(bytes, &self.diffuse));
        }
        bytes.extend_from_slice(&crc32fast::hash(&bytes).to_le_bytes());
        bytes
    }

    /// Reads the content of a file; `path` is what errors call it.
    ///
    /// # Errors
    /// As [`State::load`].
    pub fn from_bytes(bytes: &[u8], path: &str) -> Result<State, StateError> {
        let damaged = |reason: String| StateError::Damaged { path: path.to_owned(), reason };
        let foreign = || damaged("it is no saved state of Brooklet".to_owned());
        let version =
            bytes.strip_prefix(MAGIC).ok_or_else(foreign).and_then(|rest| number(rest).ok_or_else(foreign))?;
        if !(OLDEST..=VERSION).contains(&version) {
            return Err(damaged(format!(
                "it has version {version} of the format, and this program reads versions {OLDEST} to {VERSION}"
            )));
        }
        let cut = |needed: usize| damaged(format!("it is cut off: it has {} bytes of {needed}", bytes.len()));
        let header_bytes = number(&bytes[12..]).ok_or_else(|| cut(FRONT_BYTES))? as usize;
        if header_bytes > MOST_HEADER_BYTES {
            let most = MOST_HEADER_BYTES;
            return Err(damaged(format!("its header has {header_bytes} bytes; at most {most} are allowed")));
        }
        let cut_at = |Cut { needed }: Cut| cut(needed);
        let header = sections::slice(bytes, FRONT_BYTES, header_bytes).map_err(cut_at)?;
        let header: Header =
            serde_json::from_slice(header).map_err(|error| damaged(format!("its header is damaged: {error}")))?;
        if header.particles > MAX_PARTICLES {
            return Err(damaged(format!("it has {} particles; at most {MAX_PARTICLES} are allowed", header.particles)));
        }
        let count = header.particles as usize;
        let start = FRONT_BYTES + header_bytes;
        let (sections, end) = match version {
            1 => {
                let content = sections::slice(bytes, start, PARTICLE_BYTES * count).map_err(cut_at)?;
                (vec![Section { name: PARTICLES.name, version: 1, optional: false, content }], start + content.len())
            }
            _ => sections::read(bytes, start).map_err(cut_at)?,
        };
        match bytes.len() {
            has if has < end + CHECKSUM_BYTES => return Err(cut(end + CHECKSUM_BYTES)),
            has if has > end + CHECKSUM_BYTES => {
                return Err(damaged(format!("it has {has} bytes, and ends at {}", end + CHECKSUM_BYTES)));
            }
            _ => {}
        }
        let (content, checksum) = bytes.split_at(end);
        if number(checksum) != Some(crc32fast::hash(content)) {
            return Err(damaged("its content is damaged: its checksum is another".to_owned()));
        }
        known(&sections, &header.program).map_err(damaged)?;
        let content_of = |known: Known| {
            let found = sections.iter().find(|section| section.name == known.name && is_known(section));
            found.map(|section| section.content)
        };
        // The content of a section of so many bytes a particle, if it is there.
        let section = |known: Known, bytes_each: usize, of: (usize, &str)| {
            let Some(content) = content_of(known) else { return Ok(None) };
            let (count, what) = of;
            let (has, needed) = (content.len(), bytes_each * count);
            if has == needed {
                return Ok(Some(content));
            }
            let name = known.name.escape_ascii();
            Err(damaged(format!("its section {name} has {has} bytes, and its {count} {what} take {needed}")))
        };
        let content = section(PARTICLES, PARTICLE_BYTES, (count, "particles"))?
            .ok_or_else(|| damaged("it has no section PART of version 1".to_owned()))?;
        if !(header.time_s.is_finite() && header.time_s >= 0.0) {
            return Err(damaged(format!("its time is {} s; it must be 0 or more", header.time_s)));
        }
        let read = Scene::from_saved_toml(&header.scene, &header.name, version == 1);
        let mut scene = read.map_err(|error| StateError::Scene { path: path.to_owned(), error: Box::new(error) })?;
        scene.name = header.name;
        let mut particles = ParticleSet {
            positions: content[..16 * count].chunks_exact(16).map(position).collect(),
            velocities: content[16 * count..].chunks_exact(12).map(velocity).collect(),
        };
        if let Some(ages) = section(AGES, AGE_BYTES, (count, "particles"))? {
            for (velocity, age) in particles.velocities.iter_mut().zip(ages.chunks_exact(AGE_BYTES)) {
                velocity.age_s = f32::from_bits(number(age).unwrap_or_default());
            }
        }
        check(&particles).map_err(damaged)?;
        let first = BodyMotion::first(&scene);
        let bodies = match section(BODIES, BODY_BYTES, (first.states.len(), "bodies"))? {
            Some(content) => bodies::read(content).map_err(damaged)?,
            None => first,
        };
        let diffuse = content_of(DIFFUSE).map_or_else(|| Ok(DiffuseSet::default()), diffuse::read).map_err(damaged)?;
        Ok(State { scene, time_s: header.time_s, steps: header.steps, particles, bodies, diffuse })
    }
}

/// Appends what is finite of the particles, and what is not as the next step would leave it.
fn append_particles(bytes: &mut Vec<u8>, particles: &ParticleSet) {
    let pairs = || {
        particles.positions.iter().zip(&particles.velocities).map(|(position, velocity)| {
            match position.position_m.iter().chain(&velocity.velocity_m_s).all(|x| x.is_finite()) {
                true => (*position, *velocity),
                false => (Position { position_m: [0.0; 3], tag: position.tag | QUARANTINED }, Velocity::default()),
            }
        })
    };
    for (position, _) in pairs() {
        bytes.extend(position.position_m.iter().flat_map(|x| x.to_le_bytes()));
        bytes.extend(position.tag.to_le_bytes());
    }
    for (_, velocity) in pairs() {
        bytes.extend(velocity.velocity_m_s.iter().flat_map(|v| v.to_le_bytes()));
    }
}

fn append_ages(bytes: &mut Vec<u8>, particles: &ParticleSet) {
    let ages = particles.velocities.iter().map(|velocity| velocity.age_s);
    bytes.extend(ages.flat_map(|age_s| if age_s.is_finite() { age_s } else { 0.0 }.to_le_bytes()));
}

fn is_known(section: &Section) -> bool {
    SECTIONS.iter().any(|known| known.name == section.name && section.version <= known.version)
}

/// That this program knows every section it has to know, and each is there once.
fn known(sections: &[Section], program: &str) -> Result<(), String> {
    for (index, section) in sections.iter().enumerate() {
        let (name, version) = (section.name.escape_ascii(), section.version);
        if !is_known(section) && !section.optional {
            return Err(format!(
                "it has a section {name} of version {version}, which this program does not know: a newer one, {}, \
                 wrote it and can read it",
                shortened(program)
            ));
        }
        if sections[..index].iter().any(|before| before.name == section.name) {
            return Err(format!("it has two sections {name}"));
        }
    }
    Ok(())
}

/// Finite numbers, and each id once and below the number of particles: sorts and samples count on it.
fn check(particles: &ParticleSet) -> Result<(), String> {
    let mut seen = vec![false; particles.positions.len()];
    for (index, (position, velocity)) in particles.positions.iter().zip(&particles.velocities).enumerate() {
        for (what, value) in [("position", position.position_m), ("velocity", velocity.velocity_m_s)] {
            if !value.iter().all(|x| x.is_finite()) {
                return Err(format!("the {what} of particle {index} is {value:?}; it must be finite"));
            }
        }
        let id = id_of(position.tag) as usize;
        if seen.get(id).is_none_or(|seen| *seen) {
            let most = seen.len() - 1;
            return Err(format!("particle {index} has the id {id}; each from 0 to {most} must be there once"));
        }
        if !velocity.age_s.is_finite() {
            return Err(format!("the age of particle {index} is {} s; it must be finite", velocity.age_s));
        }
        seen[id] = true;
    }
    Ok(())
}

/// The first four bytes as a number.
fn number(bytes: &[u8]) -> Option<u32> {
    bytes.first_chunk().map(|bytes| u32::from_le_bytes(*bytes))
}

fn floats(bytes: &[u8]) -> [f32; 3] {
    std::array::from_fn(|axis| f32::from_bits(number(&bytes[4 * axis..]).unwrap_or_default()))
}

fn position(bytes: &[u8]) -> Position {
    Position { position_m: floats(bytes), tag: number(&bytes[12..]).unwrap_or_default() }
}

fn velocity(bytes: &[u8]) -> Velocity {
    Velocity { velocity_m_s: floats(bytes), age_s: 0.0 }
}
