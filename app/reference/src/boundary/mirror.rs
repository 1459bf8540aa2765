//! The fluid mirrored in flat walls. (Shader: `boundary/mirror.hlsli`.)

use super::walls::DomainWalls;
use glam::{BVec3, DVec2, DVec3, Vec3Swizzles as _};

/// Further than any image reaches, in h.
const NO_WALL: f64 = 2.0;

/// The half-space that stands for the solids near a particle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolidMirror {
    /// Out of it.
    pub normal: DVec3,
    /// From it, signed, in h.
    pub distance: f64,
    /// Of it along the normal.
    pub speed_m_s: f64,
}

/// What a particle sees of its own images and its neighbours': those in the nearest wall of each axis, and in several, and those
/// of all of them in solids.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mirrors {
    /// From the nearest wall of each axis, signed, in h.
    pub from_walls: DVec3,
    /// Solids, if any are near.
    pub solids: Option<SolidMirror>,
}

impl Default for Mirrors {
    fn default() -> Self {
        Self { from_walls: DVec3::splat(NO_WALL), solids: None }
    }
}

/// What an image is mirrored in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Image {
    /// Along which axes, in walls.
    pub flipped: BVec3,
    /// Whether then in solids.
    pub in_solids: bool,
}

impl Mirrors {
    /// Those at a position; of an open domain none.
    pub fn at(position_m: DVec3, walls: Option<&DomainWalls>) -> Self {
        let Some(walls) = walls else { return Self::default() };
        let low = (position_m / walls.support_m).min(DVec3::splat(NO_WALL));
        let high = ((walls.domain_size_m - position_m) / walls.support_m).min(DVec3::splat(NO_WALL));
        let nearest = DVec3::select(low.cmple(high), low, -high);
        Self { from_walls: DVec3::select(walls.axes, nearest, DVec3::splat(NO_WALL)), solids: None }
    }

    /// What each image is mirrored in; the first is the particle itself.
    pub fn images(&self) -> impl Iterator<Item = Image> + use<> {
        let near = self.from_walls.abs().cmplt(DVec3::ONE);
        let solids_are_near = self.solids.is_some_and(|solids| solids.distance.abs() < 1.0);
        let all = (0..16).map(|bits| Image {
            flipped: BVec3::new(bits & 1 != 0, bits & 2 != 0, bits & 4 != 0),
            in_solids: bits & 8 != 0,
        });
        all.filter(move |image| image.flipped & near == image.flipped && (solids_are_near || !image.in_solids))
    }

    fn solids_of(&self, image: Image) -> Option<SolidMirror> {
        self.solids.filter(|_| image.in_solids)
    }

    /// From an image of x_j to x_i, in h, of the offset from x_j itself: further than the kernel reaches where x_j has none.
    pub fn offset(&self, offset: DVec3, image: Image) -> DVec3 {
        let in_walls = DVec3::select(image.flipped, 2.0 * self.from_walls - offset, offset);
        match self.solids_of(image) {
            None => in_walls,
            Some(solids) => {
                let from_solids = solids.distance - solids.normal.dot(in_walls);
                if from_solids > 0.0 { in_walls + 2.0 * from_solids * solids.normal } else { DVec3::splat(NO_WALL) }
            }
        }
    }

    /// A direction as it is in an image.
    pub fn mirrored(&self, direction: DVec3, image: Image) -> DVec3 {
        let in_walls = DVec3::select(image.flipped, -direction, direction);
        self.solids_of(image).map_or(in_walls, |solids| in_walls.reflect(solids.normal))
    }

    /// The other way.
    pub fn mirrored_back(&self, direction: DVec3, image: Image) -> DVec3 {
        let out_of_solids = self.solids_of(image).map_or(direction, |solids| direction.reflect(solids.normal));
        DVec3::select(image.flipped, -out_of_solids, out_of_solids)
    }

    /// A velocity as it is in an image.
    pub fn mirrored_velocity(&self, velocity_m_s: DVec3, image: Image) -> DVec3 {
        let besides = self.solids_of(image).map_or(DVec3::ZERO, |solids| 2.0 * solids.speed_m_s * solids.normal);
        self.mirrored(velocity_m_s, image) + besides
    }
}

/// A direction of length 1 in two words of 16 bits, as shaders keep it: an octahedron unfolded (Meyer et al. 2010).
pub fn pack_direction(direction: DVec3) -> u32 {
    let flat = direction.xy() / (direction.x.abs() + direction.y.abs() + direction.z.abs());
    let flat = if direction.z < 0.0 { folded(flat) } else { flat };
    let bits = ((0.5 + 0.5 * flat) * 65535.0).round();
    bits.x as u32 | (bits.y as u32) << 16
}

/// The direction that was packed, within 6e-5.
pub fn unpack_direction(packed: u32) -> DVec3 {
    let flat = DVec2::new(f64::from(packed & 0xffff), f64::from(packed >> 16)) * (2.0 / 65535.0) - 1.0;
    let z = 1.0 - flat.x.abs() - flat.y.abs();
    (if z < 0.0 { folded(flat) } else { flat }).extend(z).normalize()
}

/// The lower half of an octahedron, turned outward.
fn folded(flat: DVec2) -> DVec2 {
    let side = |x: f64| if x < 0.0 { -1.0 } else { 1.0 };
    DVec2::new((1.0 - flat.y.abs()) * side(flat.x), (1.0 - flat.x.abs()) * side(flat.y))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_image_is_where_a_mirror_shows_it() {
        let mirrors = Mirrors { from_walls: DVec3::new(0.25, -0.5, NO_WALL), solids: None };
        let images: Vec<Image> = mirrors.images().collect();
        assert_eq!(images.len(), 4);
        // x_i stands a quarter off a low wall and a half off a high one; x_j is .1 nearer to both.
        let offset = DVec3::new(0.1, -0.1, 0.3);
        let in_walls = |x, y| Image { flipped: BVec3::new(x, y, false), in_solids: false };
        let seen = mirrors.offset(offset, in_walls(true, true));
        // In the low wall x_j = .15, its image -.15, .4 from .25; in the high one -.4 and .4, .9 away.
        assert!((seen - DVec3::new(0.4, -0.9, 0.3)).length() < 1e-15, "{seen}");
        assert_eq!(mirrors.offset(offset, in_walls(false, false)), offset);
        assert_eq!(mirrors.mirrored(offset, in_walls(false, true)), DVec3::new(0.1, 0.1, 0.3));
    }

    #[test]
    fn a_pair_and_its_image_push_each_other_equally() {
        let [a, b] = [DVec3::new(0.2, 0.3, 1.0), DVec3::new(0.4, 0.15, 1.2)];
        let of = |x: DVec3| Mirrors { from_walls: DVec3::new(x.x, x.y, NO_WALL), solids: None };
        for image in of(a).images() {
            let from_b = of(a).offset(a - b, image);
            let from_a = of(b).offset(b - a, image);
            // As b's image pushes a, so a's image pushes b, mirrored.
            assert!((of(a).mirrored(from_a, image) + from_b).length() < 1e-15);
        }
    }

    /// A half-space that faces along x is a wall.
    #[test]
    fn solids_mirror_as_walls_do_and_whom_they_hold_has_no_image() {
        let wall = Mirrors { from_walls: DVec3::new(0.25, NO_WALL, NO_WALL), solids: None };
        let half_space = SolidMirror { normal: DVec3::X, distance: 0.25, speed_m_s: 0.5 };
        let solid = Mirrors { solids: Some(half_space), ..Mirrors::default() };
        let [in_wall, in_solid] = [&wall, &solid].map(|mirrors| mirrors.images().nth(1).unwrap());
        for offset in [DVec3::ZERO, DVec3::new(0.2, 0.1, -0.3), DVec3::new(-0.4, 0.0, 0.2)] {
            assert!((wall.offset(offset, in_wall) - solid.offset(offset, in_solid)).length() < 1e-15);
            assert!((wall.mirrored(offset, in_wall) - solid.mirrored(offset, in_solid)).length() < 1e-15);
            assert_eq!(solid.mirrored_back(solid.mirrored(offset, in_solid), in_solid), offset);
        }
        assert!(solid.offset(DVec3::X * 0.3, in_solid).length() > 1.0);
        // What moves with the half-space stays before it.
        assert_eq!(solid.mirrored_velocity(DVec3::X * 0.5, in_solid), DVec3::X * 0.5);
    }

    #[test]
    fn directions_survive_packing() {
        for k in 0..200 {
            let k = f64::from(k);
            let direction = DVec3::new((2.4 * k).cos(), (2.4 * k).sin(), (k - 100.0) / 60.0).normalize();
            let off = (unpack_direction(pack_direction(direction)) - direction).length();
            assert!(off < 6e-5, "{direction}: {off}");
        }
    }
}
