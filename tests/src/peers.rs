//! The workload that Brooklet and other programs are measured on: a box of 2 x 1 x 1 m, a block of
//! water of 0.5 x 0.5 x 1 m at one end, h = 2 d, 0 to 1 s. 31k particles at d = 1/50 m.

use crate::{compare::vector, gpu};
use brooklet_fluid::{Scene, Session};
use brooklet_reference::compression::{Compression, Summary, compression};
use glam::DVec3;

/// When a snapshot is taken, s.
pub const SNAPSHOTS_S: [f64; 5] = [0.2, 0.4, 0.6, 0.8, 1.0];

/// A snapshot.
#[derive(Clone, Copy, Debug)]
pub struct Snapshot {
    /// When, s.
    pub time_s: f64,
    /// By the yardstick of `brooklet_reference::compression`.
    pub compression: Compression,
    /// Largest x of a particle, m.
    pub front_m: f64,
    /// Mean height of the particles, m.
    pub height_m: f64,
}

/// The scene at a spacing, with `settings` (`path=value`) on top: dt 1/240 s and, of PBF, its default of 4 iterations.
///
/// # Errors
/// If a setting is not allowed.
pub fn scene(spacing_m: f64, settings: &[String]) -> Result<Scene, String> {
    let text = format!(
        "spacing_m = {spacing_m}\n[domain]\nmin_m = [0, 0, 0]\nmax_m = [2, 1, 1]\n\
         [[fluid]]\nblock = {{ min_m = [0, 0, 0], max_m = [0.5, 0.5, 1.0] }}\n\
         [solver]\ndt_s = {}\n[outputs]\nmeasure_every_steps = 0\n",
        1.0 / 240.0
    );
    Scene::from_toml(&text, "peers.toml", settings).map_err(|error| error.to_string())
}

/// Runs a scene of [`scene`] and looks at it at [`SNAPSHOTS_S`].
///
/// # Errors
/// If the device fails, or a particle is not finite.
pub fn run(scene: &Scene) -> Result<Vec<Snapshot>, String> {
    let mut session = Session::new(&gpu(), scene).map_err(failed)?;
    let mut snapshots = Vec::new();
    let mut step = 0;
    for time_s in SNAPSHOTS_S {
        let until = (time_s / scene.solver.dt_s).round() as u32;
        while step < until {
            session.step().map_err(failed)?;
            step += 1;
        }
        let positions = session.read_particles().map_err(failed)?.positions;
        let at_m: Vec<DVec3> = positions.iter().map(|p| vector(p.position_m)).collect();
        let size_m = DVec3::from_array(scene.domain.size_m());
        let compression = compression(&at_m, DVec3::ZERO, size_m, scene.spacing_m)
            .ok_or_else(|| format!("a particle's position is not finite at {time_s} s"))?;
        snapshots.push(Snapshot {
            time_s,
            compression,
            front_m: at_m.iter().map(|p| p.x).fold(0.0, f64::max),
            height_m: at_m.iter().map(|p| p.y).sum::<f64>() / at_m.len() as f64,
        });
    }
    Ok(snapshots)
}

fn failed(error: impl std::fmt::Display) -> String {
    error.to_string()
}

/// Averages over the snapshots, number by number.
pub fn average(snapshots: &[Snapshot]) -> Compression {
    let of = |pick: fn(&Compression) -> Summary| {
        let mean = |value: fn(&Summary) -> f64| {
            snapshots.iter().map(|s| value(&pick(&s.compression))).sum::<f64>() / snapshots.len().max(1) as f64
        };
        Summary {
            particles: mean(|s| s.particles as f64) as usize,
            mean: mean(|s| s.mean),
            p99: mean(|s| s.p99),
            max: mean(|s| s.max),
        }
    };
    Compression { all: of(|c| c.all), wall: of(|c| c.wall), inner: of(|c| c.inner) }
}
