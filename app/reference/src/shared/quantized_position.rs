//! Fixed-point quantization modulo four supports. (Shader: `shared/quantized_position.hlsli`.)

use glam::DVec3;

/// Bits of a coordinate.
const BITS: u32 = 21;
/// Length of a step of it, in h.
const STORED_STEP: f64 = 4.0 / (1u32 << BITS) as f64;

/// How many bits of a coordinate pairs see.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantization {
    /// 21 bits an axis.
    Full,
    /// As many, of which pairs see the first 16: beside an f16 no more have room.
    Packed,
}

impl Quantization {
    /// Bits of a coordinate that pairs see.
    pub fn bits(self) -> u32 {
        match self {
            Self::Full => BITS,
            Self::Packed => 16,
        }
    }

    /// Length of a step of a coordinate as pairs see it, in h: 4 h are 2^bits of them.
    pub fn step(self) -> f64 {
        4.0 / f64::from(1u32 << self.bits())
    }

    /// The quantized of a position in h. In f32 and in the shader's order, every operation of which but
    /// the caller's product is exact, so that this is the GPU's result bit for bit.
    pub fn quantize(self, position_h: [f32; 3]) -> [u32; 2] {
        self.pack(position_h.map(|x| {
            let turns = x * 0.25;
            self.fixed_point(f64::from((turns - turns.floor()) * 4.0))
        }))
    }

    /// A length in h in steps, rounded, as a coordinate in the top bits of 32.
    pub fn fixed_point(self, length_h: f64) -> u32 {
        ((length_h / STORED_STEP).round_ties_even() as i64 as u32) << (32 - BITS)
    }

    /// The coordinates as they are stored.
    pub fn pack(self, [x, y, z]: [u32; 3]) -> [u32; 2] {
        match self {
            Self::Full => [(x & !0x7ff) | y >> 21, (z & !0x7ff) | (y >> 10 & 0x7ff)],
            Self::Packed => {
                let last = [x, y, z].map(|c| c >> 11 & 0x1f);
                [(x & 0xffff_0000) | y >> 16, (z & 0xffff_0000) | last[0] << 10 | last[1] << 5 | last[2]]
            }
        }
    }

    /// The coordinates of a quantized.
    pub fn coordinates(self, [low, high]: [u32; 2]) -> [u32; 3] {
        match self {
            Self::Full => [low & !0x7ff, low << 21 | (high & 0x7ff) << 10, high & !0x7ff],
            Self::Packed => [
                (low & 0xffff_0000) | (high >> 10 & 0x1f) << 11,
                (low << 16) | (high >> 5 & 0x1f) << 11,
                (high & 0xffff_0000) | (high & 0x1f) << 11,
            ],
        }
    }

    /// The position, in h, that has this quantized and is nearest to `position_h`.
    pub fn near(self, quantized: [u32; 2], position_h: DVec3) -> DVec3 {
        let modulo = DVec3::from_array(self.coordinates(quantized).map(f64::from)) / f64::from(1u32 << 30);
        modulo + 4.0 * ((position_h - modulo) / 4.0).round()
    }

    /// As pairs see it, with nothing in the bits that a lambda takes.
    pub fn of_pairs(self, [low, high]: [u32; 2]) -> [u32; 2] {
        match self {
            Self::Full => [low, high],
            Self::Packed => [low, high & 0xffff_0000],
        }
    }

    /// From x_j to x_i, in h, as long as it is less than two along each axis.
    pub fn offset(self, x_i: [u32; 2], x_j: [u32; 2]) -> DVec3 {
        let [x_i, x_j] = [x_i, x_j].map(|quantized| self.coordinates(quantized));
        let difference: [f64; 3] = std::array::from_fn(|axis| f64::from(x_i[axis].wrapping_sub(x_j[axis]) as i32));
        DVec3::from_array(difference) / f64::from(1u32 << 30)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_survive_the_wrap() {
        for quantization in [Quantization::Full, Quantization::Packed] {
            // Either side of a multiple of 4 h, and far from the origin.
            for (x_i, x_j) in [([3.9, 0.1, 8.0], [4.3, -0.3, 7.2]), ([103.0, 1.0, 0.0], [102.5, 1.9, 1.0])] {
                let offset = quantization.offset(quantization.quantize(x_i), quantization.quantize(x_j));
                for axis in 0..3 {
                    let expected = f64::from(x_i[axis]) - f64::from(x_j[axis]);
                    // Half a step each.
                    assert!(
                        (offset[axis] - expected).abs() <= quantization.step() * 1.0001,
                        "{quantization:?} {offset}"
                    );
                }
            }
        }
    }

    #[test]
    fn coordinates_are_kept() {
        for quantization in [Quantization::Full, Quantization::Packed] {
            let mask = u32::MAX << (32 - BITS);
            for seed in [0u32, 1, 0x1234_5678, 0xffff_ffff, 0x8000_0800] {
                let coordinates = [seed, seed.rotate_left(11), seed.rotate_left(23)].map(|c| c & mask);
                let quantized = quantization.pack(coordinates);
                assert_eq!(quantization.coordinates(quantized), coordinates);
                let seen = u32::MAX << (32 - quantization.bits());
                let of_pairs = quantization.coordinates(quantization.of_pairs(quantized));
                assert_eq!(of_pairs, coordinates.map(|c| c & seen));
            }
        }
    }
}
