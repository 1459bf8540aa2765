//! Lattices that fill what has to be filled from end to end.
//!
//! A block between two walls rarely is a whole number of spacings wide. A lattice that leaves what is over as a
//! gap falls by it: water at rest would swing. So the nearest spacing is taken of which a whole number fit there.
//! Mass, support, walls and pictures follow it (`Scene::fitted_spacing_m`), and the lattice is at rest.
//!
//! Where blocks reach from wall to wall along axes whose sides no one spacing fits, the lattice is strained: each axis
//! gets whole steps of its own, and a particle keeps its volume by the steps along free axes.

/// A side within this share of a spacing of a whole number of spacings is that number: .3 / .1 is 3.
pub(crate) const WHOLE: f64 = 0.01;

/// Strain counts so much more than a spacing that is not the one asked for: a strained lattice settles into another.
const STRAIN_COST: f64 = 3.0;

/// Whole steps along the axes that are to be filled, each with its length in `filled_m`: every way to round them.
fn whole_steps_m(
    spacing_m: f64,
    dimensions: u32,
    filled_m: [Option<f64>; 3],
) -> impl Iterator<Item = [Option<f64>; 3]> {
    let step_m = move |side_m: f64, up: bool| {
        let cells = side_m / spacing_m;
        let whole = cells.round();
        let count = match (cells - whole).abs() <= WHOLE && whole >= 1.0 {
            true => whole,
            false if up => cells.ceil(),
            false => cells.floor().max(1.0),
        };
        match side_m / count {
            // To the bit where it fits: .25 / 10 is not always .025.
            step_m if (step_m / spacing_m - 1.0).abs() < 1.0e-9 => spacing_m,
            step_m => step_m,
        }
    };
    let is_filled = move |axis: usize| axis < dimensions as usize;
    (0..1 << dimensions).map(move |ups| {
        std::array::from_fn(|axis| {
            filled_m[axis].filter(|_| is_filled(axis)).map(|side_m| step_m(side_m, ups >> axis & 1 == 1))
        })
    })
}

/// The spacing nearest to `spacing_m` of which a whole number fit along each axis that is to be filled, or nearly,
/// where no spacing fits them all.
pub(super) fn fitted_spacing_m(spacing_m: f64, dimensions: u32, filled_m: [Option<f64>; 3]) -> f64 {
    let fits = whole_steps_m(spacing_m, dimensions, filled_m).map(|steps_m| {
        let steps = || steps_m.into_iter().flatten();
        if steps().all(|step_m| step_m == spacing_m) {
            return (spacing_m, 0.0);
        }
        let mean_m = (steps().map(f64::ln).sum::<f64>() / steps().count() as f64).exp();
        let strain: f64 = steps().map(|step_m| (step_m / mean_m).ln().abs()).sum();
        (mean_m, STRAIN_COST * strain + (mean_m / spacing_m).ln().abs())
    });
    fits.min_by(|(_, a), (_, b)| a.total_cmp(b)).map_or(spacing_m, |(fitted_m, _)| fitted_m)
}

/// The steps along the axes, m, of a lattice of particles of `spacing_m`^`dimensions` each: whole ones along the axes
/// that are to be filled, and such along the others that a particle has its volume.
pub(crate) fn steps_m(spacing_m: f64, dimensions: u32, filled_m: [Option<f64>; 3]) -> [f64; 3] {
    let all = whole_steps_m(spacing_m, dimensions, filled_m).map(|filled_steps_m| {
        let ratios = || filled_steps_m.into_iter().flatten().map(|step_m| step_m / spacing_m);
        let free = f64::from(dimensions) - ratios().count() as f64;
        let volume: f64 = ratios().product();
        let free_m = if volume == 1.0 || free == 0.0 { spacing_m } else { spacing_m * volume.powf(-1.0 / free) };
        let strain: f64 = ratios().map(|ratio| ratio.ln().abs()).sum();
        let steps_m: [f64; 3] = std::array::from_fn(|axis| match axis < dimensions as usize {
            true => filled_steps_m[axis].unwrap_or(free_m),
            false => spacing_m,
        });
        // Without a free axis nothing makes up for the volume.
        (steps_m, if free > 0.0 { strain } else { volume.ln().abs() })
    });
    all.min_by(|(_, a), (_, b)| a.total_cmp(b)).map_or([spacing_m; 3], |(steps_m, _)| steps_m)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_fits_keeps_its_spacing_to_the_bit() {
        for spacing_m in [0.02, 0.025, 0.05] {
            for (dimensions, filled_m) in
                [(3, [Some(0.1 + 0.2), None, Some(0.5)]), (2, [Some(0.6), None, None]), (3, [None; 3])]
            {
                assert_eq!(fitted_spacing_m(spacing_m, dimensions, filled_m), spacing_m);
                assert_eq!(steps_m(spacing_m, dimensions, filled_m), [spacing_m; 3]);
            }
        }
    }

    #[test]
    fn the_nearest_spacing_that_fits_is_taken() {
        for cells in [1.2, 6.3, 6.93, 8.67, 40.3] {
            let side = Some(cells);
            for (dimensions, filled) in
                [(3, [side, None, side]), (3, [None, None, side]), (2, [side, None, None]), (3, [side; 3])]
            {
                let fitted = fitted_spacing_m(1.0, dimensions, filled);
                assert!((fitted * cells.round() - cells).abs() < 1e-9 * cells, "{cells}: {fitted}");
                // And nothing is strained.
                assert!(steps_m(fitted, dimensions, filled).iter().all(|step| (step / fitted - 1.0).abs() < 1e-9));
            }
        }
    }

    #[test]
    fn sides_that_no_spacing_fits_are_filled_all_the_same_and_volume_is_kept() {
        let filled = [Some(10.0), None, Some(3.3)];
        let fitted = fitted_spacing_m(1.0, 3, filled);
        let steps = steps_m(fitted, 3, filled);
        assert_eq!([10.0 / steps[0], 3.3 / steps[2]].map(|count| (count * 1e9).round() / 1e9), [10.0, 3.0]);
        assert!((steps.iter().product::<f64>() / fitted.powi(3) - 1.0).abs() < 1e-12, "{steps:?} of {fitted}");
        // No free axis: the spacing itself is that of the volume.
        let filled = [Some(10.0), Some(7.0), Some(3.3)];
        let fitted = fitted_spacing_m(1.0, 3, filled);
        let steps = steps_m(fitted, 3, filled);
        assert!((steps.iter().product::<f64>() / fitted.powi(3) - 1.0).abs() < 1e-12, "{steps:?} of {fitted}");
    }
}
