//! The smoothing kernel's constants: Wendland C2 in q = r/h with W(0) = 1, scaled so that the
//! initial lattice has density ratio 1. (Shader: `shared/wendland.hlsli`.)

/// W(q) = (1-q)⁴ (4q+1) for q < 1 (Wendland 1995).
pub fn wendland(q: f64) -> f64 {
    let t = (1.0 - q).max(0.0);
    t.powi(4) * (4.0 * q + 1.0)
}

/// Length of W's gradient over r/h: 20 q (1-q)³.
pub fn wendland_slope(q: f64) -> f64 {
    20.0 * q * (1.0 - q).max(0.0).powi(3)
}

/// Sums over the infinite lattice of spacing d = h / `support_ratio` around one of its points: the cubic
/// lattice, or in two dimensions the square one.
#[derive(Clone, Copy, Debug)]
pub struct Lattice {
    /// 1 / ΣW, the point itself among them.
    pub weight: f64,
    /// Σ|∇C|² h²: the density constraint's stiffness in the bulk.
    pub stiffness: f64,
}

/// The sums in 2 or 3 `dimensions` at a support of `support_ratio` spacings.
pub fn lattice(dimensions: u32, support_ratio: f64) -> Lattice {
    let (mut density, mut slopes) = (0.0, 0.0);
    for_lattice(dimensions, support_ratio, |_, q| {
        density += wendland(q);
        slopes += wendland_slope(q).powi(2);
    });
    let weight = 1.0 / density;
    Lattice { weight, stiffness: slopes * weight * weight }
}

/// Calls `visit` with each lattice point inside the support, as steps along the axes, and its q.
pub(crate) fn for_lattice(dimensions: u32, support_ratio: f64, mut visit: impl FnMut([i32; 3], f64)) {
    let reach = support_ratio.ceil() as i32;
    let deep = if dimensions == 2 { 0 } else { reach };
    for z in -deep..=deep {
        for y in -reach..=reach {
            for x in -reach..=reach {
                let q = f64::from(x * x + y * y + z * z).sqrt() / support_ratio;
                if q < 1.0 {
                    visit([x, y, z], q);
                }
            }
        }
    }
}
