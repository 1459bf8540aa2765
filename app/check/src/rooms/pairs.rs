//! How kernels of PBF compute pairs, and the fluids that they are tested on.

use crate::cases::{Around, Case, SUPPORT_M, fluid, precisions, quantization_of, sizes};
use crate::device::Device;
use brooklet_kernels::{ConstrainDensity, Kernel, PrecisionKeyword};
use brooklet_reference::shared::quantized_position::Quantization;
use glam::DVec3;

/// A case whose domain has opposite walls in reach of one particle, if the variant is for that.
pub fn case_for(rng: &mut impl rand::Rng, size: usize, walls: Around) -> Case {
    let mut case = fluid(rng, size);
    if walls == Around::NarrowWalls {
        case.size_m = case.size_m.min(DVec3::new(1.4 * SUPPORT_M, 9.0, 1.1 * SUPPORT_M));
    }
    case
}

/// How a kernel's pairs are computed: the precision, and the positions that it gathers.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct Pairs {
    /// Of the arithmetic.
    pub precision: PrecisionKeyword,
    /// Of the positions.
    pub quantization: Quantization,
}

/// f32.
pub const FULL: Pairs = Pairs { precision: PrecisionKeyword::Off, quantization: Quantization::Full };

/// Every way there is, with how large a rounding is.
pub fn all_pairs(device: &Device) -> Vec<(Pairs, f64)> {
    let pairs = |precision| Pairs { precision, quantization: quantization_of(precision) };
    precisions(device).into_iter().map(|(precision, rounding)| (pairs(precision), rounding)).collect()
}

impl Pairs {
    /// Particle counts: every edge with full precision; the others differ from it inside a pair only.
    pub fn sizes(self, device: &Device) -> Vec<usize> {
        let edges = sizes(device, ConstrainDensity::GROUP_SIZE[0] as usize);
        match self {
            FULL => edges,
            _ => vec![edges[1], edges[5], 333],
        }
    }

    /// A stage with it, for reports.
    pub fn name(self, stage: &str) -> String {
        format!("{stage} {:?}", self.precision)
    }

    /// Whether positions share their words with a lambda.
    pub fn packed(self) -> bool {
        self.quantization == Quantization::Packed
    }
}
