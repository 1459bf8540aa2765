//! Heights by formula: gradient noise in octaves (Perlin 2002), alone or as the banks of a river.

use crate::terrain::Heights;

/// Each octave is so much smaller and lower than the one before.
const OCTAVES: u32 = 5;

/// What ground looks like.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ReliefKind {
    /// Hills.
    Hills,
    /// A channel that winds along x, between banks.
    Valley,
}

/// Ground by formula.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Relief {
    /// What it looks like.
    pub kind: ReliefKind,
    /// Another one, another ground.
    pub seed: u32,
    /// From hill to hill, m; of a valley from bend to bend, and a quarter of it from hill to hill.
    pub feature_m: f64,
    /// Width of a valley's channel, m.
    pub channel_m: f64,
}

/// A number that looks random for a lattice point.
fn hash(x: i32, z: i32, seed: u32) -> u32 {
    let mut h =
        (x as u32).wrapping_mul(0x85EB_CA6B) ^ (z as u32).wrapping_mul(0xC2B2_AE35) ^ seed.wrapping_mul(0x27D4_EB2F);
    for factor in [0x7FEB_352D_u32, 0x846C_A68B] {
        h = (h ^ (h >> 16)).wrapping_mul(factor);
    }
    h ^ (h >> 16)
}

/// Smooth noise that changes over a length of 1, of about -.7 to .7.
pub fn noise(x: f64, z: f64, seed: u32) -> f64 {
    let (x0, z0) = (x.floor(), z.floor());
    let at = |step_x: i32, step_z: i32| {
        let (column, row) = (x0 as i32 + step_x, z0 as i32 + step_z);
        let angle = f64::from(hash(column, row, seed)) / f64::from(u32::MAX) * std::f64::consts::TAU;
        angle.cos() * (x - f64::from(column)) + angle.sin() * (z - f64::from(row))
    };
    let fade = |t: f64| t * t * t * (t * (6.0 * t - 15.0) + 10.0);
    let (u, v) = (fade(x - x0), fade(z - z0));
    let along = |row: i32| at(0, row) + u * (at(1, row) - at(0, row));
    along(0) + v * (along(1) - along(0))
}

/// From 0 to 1.
fn hills(x: f64, z: f64, seed: u32) -> f64 {
    let octave = |k: u32| {
        let scale = f64::from(1_u32 << k);
        noise(x * scale, z * scale, seed.wrapping_add(k)) / scale
    };
    (0.5 + 0.6 * (0..OCTAVES).map(octave).sum::<f64>()).clamp(0.0, 1.0)
}

impl Relief {
    /// Heights of up to `height_m` on a lattice over `size_m`.
    pub fn heights(&self, size_m: [f64; 2], height_m: f64, [columns, rows]: [usize; 2]) -> Heights {
        let mut heights_m = Vec::with_capacity(columns * rows);
        for row in 0..rows {
            let z = row as f64 / (rows - 1) as f64 * size_m[1];
            for column in 0..columns {
                let x = column as f64 / (columns - 1) as f64 * size_m[0];
                heights_m.push(height_m * self.at(x, z, size_m));
            }
        }
        Heights { columns, rows, heights_m }
    }

    fn at(&self, x: f64, z: f64, size_m: [f64; 2]) -> f64 {
        let per_m = 1.0 / self.feature_m;
        match self.kind {
            ReliefKind::Hills => hills(x * per_m, z * per_m, self.seed),
            ReliefKind::Valley => {
                let turn = std::f64::consts::TAU * (x * per_m + f64::from(hash(0, 0, self.seed) % 1000) / 1000.0);
                let bend_m = 0.5 * (0.5 * size_m[1] - self.channel_m).max(0.0);
                let aside_m = z - 0.5 * size_m[1] - bend_m * (turn.sin() + 0.25 * (2.3 * turn).sin()) / 1.25;
                // A round bed, and banks that level out.
                let bank = 1.0 - (-(aside_m / (0.6 * self.channel_m)).powi(2)).exp();
                let uneven = hills(4.0 * x * per_m, 4.0 * z * per_m, self.seed);
                bank * (0.55 + 0.45 * uneven) + 0.06 * uneven * (1.0 - bank)
            }
        }
    }
}
