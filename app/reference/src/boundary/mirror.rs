//! The fluid mirrored in flat walls. (Shader: `boundary/mirror.hlsli`.)

use super::walls::DomainWalls;
use glam::{BVec3, DVec3};

/// Further than any image reaches, in h.
const NO_WALL: f64 = 2.0;

/// What a particle sees of its own images and its neighbours': those in the nearest wall of each axis, and in several.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mirrors {
    /// From the nearest wall of each axis, signed, in h.
    pub from_walls: DVec3,
}

impl Default for Mirrors {
    fn default() -> Self {
        Self { from_walls: DVec3::splat(NO_WALL) }
    }
}

impl Mirrors {
    /// Those at a position; of an open domain none.
    pub fn at(position_m: DVec3, walls: Option<&DomainWalls>) -> Self {
        let Some(walls) = walls else { return Self::default() };
        let low = (position_m / walls.support_m).min(DVec3::splat(NO_WALL));
        let high = ((walls.domain_size_m - position_m) / walls.support_m).min(DVec3::splat(NO_WALL));
        let nearest = DVec3::select(low.cmple(high), low, -high);
        Self { from_walls: DVec3::select(walls.axes, nearest, DVec3::splat(NO_WALL)) }
    }

    /// Along which axes each image is mirrored; the first is the particle itself.
    pub fn images(&self) -> impl Iterator<Item = BVec3> {
        let near = self.from_walls.abs().cmplt(DVec3::ONE);
        let all = (0..8).map(|bits| BVec3::new(bits & 1 != 0, bits & 2 != 0, bits & 4 != 0));
        all.filter(move |&flipped| flipped & near == flipped)
    }

    /// From an image of x_j to x_i, in h, of the offset from x_j itself.
    pub fn offset(&self, offset: DVec3, flipped: BVec3) -> DVec3 {
        DVec3::select(flipped, 2.0 * self.from_walls - offset, offset)
    }
}

/// A direction as it is in an image, or back.
pub fn mirrored(direction: DVec3, flipped: BVec3) -> DVec3 {
    DVec3::select(flipped, -direction, direction)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_image_is_where_a_mirror_shows_it() {
        let mirrors = Mirrors { from_walls: DVec3::new(0.25, -0.5, NO_WALL) };
        let images: Vec<BVec3> = mirrors.images().collect();
        assert_eq!(images.len(), 4);
        // x_i stands a quarter off a low wall and a half off a high one; x_j is .1 nearer to both.
        let offset = DVec3::new(0.1, -0.1, 0.3);
        let seen = mirrors.offset(offset, BVec3::new(true, true, false));
        // In the low wall x_j = .15, its image -.15, .4 from .25; in the high one -.4 and .4, .9 away.
        assert!((seen - DVec3::new(0.4, -0.9, 0.3)).length() < 1e-15, "{seen}");
        assert_eq!(mirrors.offset(offset, BVec3::FALSE), offset);
        assert_eq!(mirrored(offset, BVec3::new(false, true, false)), DVec3::new(0.1, 0.1, 0.3));
    }

    #[test]
    fn a_pair_and_its_image_push_each_other_equally() {
        let [a, b] = [DVec3::new(0.2, 0.3, 1.0), DVec3::new(0.4, 0.15, 1.2)];
        let of = |x: DVec3| Mirrors { from_walls: DVec3::new(x.x, x.y, NO_WALL) };
        for flipped in of(a).images() {
            let from_b = of(a).offset(a - b, flipped);
            let from_a = of(b).offset(b - a, flipped);
            // As b's image pushes a, so a's image pushes b, mirrored.
            assert!((mirrored(from_a, flipped) + from_b).length() < 1e-15);
        }
    }
}
