//! Lattices whose particles each have a spacing's volume, and that fill what has to be filled from end to end.
//!
//! A block between two walls rarely is a whole number of spacings wide. A lattice that leaves what is over as a
//! gap falls into it: water at rest would swing. So the steps along such an axis are those of the nearest whole
//! number, and the steps along free axes make up for it: a particle keeps its volume, and with it its mass and
//! the density ratio 1, to second order in the strain (at h = 2 d and a strain of 5 %: .2 % in the bulk, 1.5 % in
//! the layer at a wall).

/// A side within this share of a spacing of a whole number of spacings is that number: .3 / .1 is 3.
pub(super) const WHOLE: f64 = 0.01;

/// The steps along the axes, m, of a lattice of particles of `spacing_m`^`dimensions` each. An axis that is to be
/// filled from end to end has its length in `filled_m`, m, and steps of which a whole number fit there.
pub(super) fn steps_m(spacing_m: f64, dimensions: u32, filled_m: [Option<f64>; 3]) -> [f64; 3] {
    let axes = 0..dimensions as usize;
    let step_m = |side_m: f64, count: f64| match side_m / count {
        // To the bit where it fits: .25 / 10 is not always .025.
        step_m if (step_m / spacing_m - 1.0).abs() < 1.0e-9 => spacing_m,
        step_m => step_m,
    };
    let near = |side_m: f64| {
        let cells = side_m / spacing_m;
        let whole = cells.round();
        match (cells - whole).abs() <= WHOLE && whole >= 1.0 {
            true => [whole; 2],
            false => [cells.floor().max(1.0), cells.ceil()],
        }
    };
    let free = axes.clone().filter(|&axis| filled_m[axis].is_none()).count();
    // Every way to round. A free axis makes up for any; then the least strained along each axis is best.
    let mut best = ([spacing_m; 3], f64::INFINITY);
    for up in 0..1 << dimensions {
        let mut steps_m = [spacing_m; 3];
        let (mut volume, mut strain) = (1.0f64, 0.0);
        for axis in axes.clone() {
            if let Some(side_m) = filled_m[axis] {
                steps_m[axis] = step_m(side_m, near(side_m)[up >> axis & 1]);
                let ratio = steps_m[axis] / spacing_m;
                volume *= ratio;
                strain += ratio.ln().abs();
            }
        }
        let cost = if free > 0 { strain } else { volume.ln().abs() };
        if cost < best.1 {
            if volume != 1.0 && free > 0 {
                for axis in axes.clone().filter(|&axis| filled_m[axis].is_none()) {
                    steps_m[axis] = spacing_m * volume.powf(-1.0 / free as f64);
                }
            }
            best = (steps_m, cost);
        }
    }
    best.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lattice_that_fits_keeps_its_spacing_to_the_bit() {
        for spacing_m in [0.02, 0.025, 0.05] {
            let side_m = 0.1 + 0.2;
            assert_eq!(steps_m(spacing_m, 3, [Some(side_m), None, Some(0.5)]), [spacing_m; 3]);
            assert_eq!(steps_m(spacing_m, 2, [Some(0.6), None, None]), [spacing_m; 3]);
        }
        assert_eq!(steps_m(0.1, 3, [None; 3]), [0.1; 3]);
    }

    #[test]
    fn whole_steps_fill_a_side_and_free_axes_keep_the_volume() {
        for cells in [1.2, 1.49, 6.93, 7.5, 8.67, 40.3] {
            for (filled_m, dimensions) in
                [([Some(cells), None, Some(5.4)], 3), ([None, None, Some(cells)], 3), ([Some(cells), None, None], 2)]
            {
                let steps = steps_m(1.0, dimensions, filled_m);
                let volume: f64 = steps.iter().product();
                assert!((volume - 1.0).abs() < 1.0e-12, "{cells} {filled_m:?}: {steps:?}");
                for axis in 0..dimensions as usize {
                    let Some(side) = filled_m[axis] else { continue };
                    let count = side / steps[axis];
                    assert!((count - count.round()).abs() < 1.0e-9, "{cells} {filled_m:?}: {steps:?}");
                    assert!([side.floor(), side.ceil()].contains(&count.round()), "{cells} {filled_m:?}: {steps:?}");
                }
            }
        }
    }

    #[test]
    fn a_box_filled_along_every_axis_comes_as_near_to_the_volume_as_it_can() {
        let steps = steps_m(1.0, 3, [Some(8.5), Some(8.5), Some(8.5)]);
        let mut counts = steps.map(|step| (8.5 / step).round());
        counts.sort_by(f64::total_cmp);
        // 8.5^3 = 614: 8 * 9 * 9 = 648 is 5.5 % more, 8 * 8 * 9 = 576 6.2 % less.
        assert_eq!(counts, [8.0, 9.0, 9.0]);
    }
}
