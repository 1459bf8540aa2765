//! The sun's parallel projection, as the shadow map has it.

use brooklet_kernels::{FrameLight, SurfaceParams};
use glam::{DVec3, DVec4};

/// Surfaces within so many spacings of a wall are the wall.
const AT_WALL: f64 = 0.5;

/// Numbers over the sun's map: rows from the top, as many as columns.
#[derive(Clone, Debug, PartialEq)]
pub struct SunMap {
    /// Quantization along a side.
    pub side: usize,
    /// Rows from the top.
    pub values: Vec<f64>,
}

impl SunMap {
    /// The value of a texel, 0 outside.
    pub fn at(&self, x: i64, y: i64) -> f64 {
        let inside = x >= 0 && y >= 0 && x < self.side as i64 && y < self.side as i64;
        if inside { self.values[y as usize * self.side + x as usize] } else { 0.0 }
    }

    /// Column and row of each texel.
    pub fn texels(&self) -> impl Iterator<Item = (i64, i64)> {
        let side = self.side;
        (0..side * side).map(move |i| ((i % side) as i64, (i / side) as i64))
    }

    /// Between the middles of four texels, as a sampler does it that repeats the border's.
    pub fn bilinear(&self, u: f64, v: f64) -> f64 {
        let [x, y] = [u, v].map(|at| at * self.side as f64 - 0.5);
        let last = self.side as i64 - 1;
        let at =
            |dx: i64, dy: i64| self.at((x.floor() as i64 + dx).clamp(0, last), (y.floor() as i64 + dy).clamp(0, last));
        let (across, down) = (x - x.floor(), y - y.floor());
        let row = |dy| at(0, dy) * (1.0 - across) + at(1, dy) * across;
        row(0) * (1.0 - down) + row(1) * down
    }
}

/// The rows u, v and depth of the map as vectors and what is added to them.
pub(crate) fn rows(light: &FrameLight) -> [(DVec3, f64); 3] {
    [light.shadow_u, light.shadow_v, light.shadow_depth].map(|row| {
        let row = DVec4::from_array(row.map(f64::from));
        (row.truncate(), row.w)
    })
}

/// Column and row in 0..1, and depth, 1 nearest the sun. (Shader: `ShadowPosition`.)
pub fn shadow_position(light: &FrameLight, at_m: DVec3) -> DVec3 {
    DVec3::from_array(rows(light).map(|(row, shift)| row.dot(at_m) + shift))
}

/// The position in the world of a point of the map. (Shader: `WorldFromShadow`.)
pub fn world_from_shadow(light: &FrameLight, at: DVec3) -> DVec3 {
    let parts = rows(light).into_iter().zip(at.to_array());
    parts.map(|((row, shift), at)| row * ((at - shift) / row.length_squared())).sum()
}

/// Distance between two photons of the grid, m.
pub(crate) fn photon_spacing_m(params: &SurfaceParams, light: &FrameLight) -> f64 {
    f64::from(light.shadow_texel_m) * f64::from(light.shadow_texels) / f64::from(params.photons)
}

/// Where a ray of the sun enters the box of the walls.
pub(crate) struct Entry {
    /// Shadow depth there.
    pub depth: f64,
    /// Outward normal of the wall.
    pub outward: DVec3,
    /// What lies so much deeper, or less, is the wall.
    wall_depth: f64,
}

impl Entry {
    /// Whether a surface at this shadow depth is the wall's own.
    pub fn is_wall(&self, depth: f64) -> bool {
        depth > self.depth - self.wall_depth
    }
}

/// The entry of the ray through a cell of the photons' grid. (Shader: `EntryAt`.)
pub(crate) fn entry_at(params: &SurfaceParams, light: &FrameLight, x: i64, y: i64) -> Entry {
    let side = f64::from(params.photons);
    let vector = |v: [f32; 3]| DVec3::from_array(v.map(f64::from));
    let to_sun = vector(light.to_sun);
    let from_m = world_from_shadow(light, DVec3::new((x as f64 + 0.5) / side, (y as f64 + 0.5) / side, 0.0));
    let high_m = ((vector(params.wall_min_m) - from_m) / to_sun).max((vector(params.wall_max_m) - from_m) / to_sun);
    let along_m = high_m.min_element();
    let axis = (0..3).find(|&axis| high_m[axis] == along_m).unwrap_or(1);
    let range_m = f64::from(light.shadow_range_m);
    Entry {
        depth: along_m / range_m,
        outward: DVec3::AXES[axis] * to_sun[axis].signum(),
        wall_depth: AT_WALL * f64::from(params.spacing_m) / (to_sun[axis].abs() * range_m),
    }
}

/// Whether what sunlight meets at the cell `there` goes on the surface that it meets at `here`, along a row or a column, and
/// is no wall. (Shader: `IsSameSurface`.)
pub(super) fn is_same_surface(
    map: &SunMap,
    params: &SurfaceParams,
    light: &FrameLight,
    here: [i64; 2],
    there: [i64; 2],
) -> bool {
    let [depth, other] = [here, there].map(|[x, y]| map.at(x, y));
    let apart = (there[0] - here[0]).abs() + (there[1] - here[1]).abs();
    let range_m = f64::from(params.range_m) + 2.0 * apart as f64 * photon_spacing_m(params, light);
    let is_near = (other - depth).abs() < range_m / f64::from(light.shadow_range_m);
    other > 0.0 && is_near && !entry_at(params, light, there[0], there[1]).is_wall(other)
}
