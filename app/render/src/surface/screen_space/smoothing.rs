//! The smoothing filters, each a chain of passes between two textures.

use brooklet_fluid::scene::Smoothing;
use brooklet_gpu::{Load, Recording, Resources, Targets};
use brooklet_kernels::{
    AlongKeyword, DrawSmoothBilateral, DrawSmoothBilateralVariant, DrawSmoothCurvatureFlow, DrawSmoothGaussian,
    DrawSmoothGaussianVariant, DrawSmoothNarrowRange, DrawSmoothNarrowRangeVariant, FilterKeyword, FrameView,
    SurfaceParams, Texture, Uniform,
};

use super::{ON_FLUID, ScreenSpaceOptions};
use crate::formats;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Pass {
    Gaussian(AlongKeyword),
    Bilateral(FilterKeyword),
    NarrowRange(FilterKeyword),
    CurvatureFlow,
}

fn passes(smoothing: Smoothing, iterations: u32) -> Vec<Pass> {
    let once: &[Pass] = match smoothing {
        Smoothing::None => &[],
        Smoothing::Gaussian => &[Pass::Gaussian(AlongKeyword::AlongX), Pass::Gaussian(AlongKeyword::AlongY)],
        Smoothing::Bilateral => &[Pass::Bilateral(FilterKeyword::FilterX), Pass::Bilateral(FilterKeyword::FilterY)],
        Smoothing::Bilateral2d => &[Pass::Bilateral(FilterKeyword::FilterPlane)],
        Smoothing::NarrowRange => {
            &[Pass::NarrowRange(FilterKeyword::FilterX), Pass::NarrowRange(FilterKeyword::FilterY)]
        }
        Smoothing::CurvatureFlow => &[Pass::CurvatureFlow],
    };
    let mut passes: Vec<Pass> = (0..iterations).flat_map(|_| once).copied().collect();
    if smoothing == Smoothing::NarrowRange && iterations > 0 {
        passes.push(Pass::NarrowRange(FilterKeyword::FilterPlane));
    }
    passes
}

/// Smooths `raw`; the result is another texture, or `raw` itself where nothing smooths.
pub(super) fn record(
    resources: &mut Resources,
    recording: &mut Recording,
    view: Uniform<'_, FrameView>,
    raw: &Texture,
    covered: &Texture,
    surface: Uniform<'_, SurfaceParams>,
    options: &ScreenSpaceOptions,
) -> Texture {
    let passes = passes(options.smoothing, options.iterations);
    if passes.is_empty() {
        return raw.alias();
    }
    // Two take turns; the raw surface is kept, for whoever wants to see what smoothing changed.
    let mut turns = vec![resources.texture_in("smoothed_inverse_depth", formats::DEPTH, raw.size_px)];
    if passes.len() > 1 {
        turns.push(resources.texture_in("half_smoothed_inverse_depth", formats::DEPTH, raw.size_px));
    }
    let mut from = raw.alias();
    for (number, pass) in passes.iter().enumerate() {
        // The last one ends in the first of the two.
        let to = turns[(passes.len() - 1 - number) % turns.len()].alias();
        let targets = Targets { color: vec![(&to, Load::Clear([0.0; 4]))], depth: Some((covered, Load::Keep)) };
        let inverse_depth = from.read();
        match *pass {
            Pass::Gaussian(along) => {
                let variant = DrawSmoothGaussianVariant { along };
                recording.draw(&DrawSmoothGaussian { variant, inverse_depth, view, surface }, &targets, ON_FLUID, 3, 1);
            }
            Pass::Bilateral(filter) => {
                let variant = DrawSmoothBilateralVariant { filter };
                recording.draw(
                    &DrawSmoothBilateral { variant, inverse_depth, view, surface },
                    &targets,
                    ON_FLUID,
                    3,
                    1,
                );
            }
            Pass::NarrowRange(filter) => {
                let variant = DrawSmoothNarrowRangeVariant { filter };
                recording.draw(
                    &DrawSmoothNarrowRange { variant, inverse_depth, view, surface },
                    &targets,
                    ON_FLUID,
                    3,
                    1,
                );
            }
            Pass::CurvatureFlow => {
                recording.draw(&DrawSmoothCurvatureFlow { inverse_depth, view, surface }, &targets, ON_FLUID, 3, 1);
            }
        }
        from = to;
    }
    from
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_filter_runs_as_often_as_asked() {
        for (smoothing, once, more) in [
            (Smoothing::Gaussian, 2, 0),
            (Smoothing::Bilateral, 2, 0),
            (Smoothing::Bilateral2d, 1, 0),
            (Smoothing::NarrowRange, 2, 1),
            (Smoothing::CurvatureFlow, 1, 0),
            (Smoothing::None, 0, 0),
        ] {
            assert!(passes(smoothing, 0).is_empty(), "{smoothing:?}");
            for iterations in [1, 2, 7] {
                assert_eq!(passes(smoothing, iterations).len(), once * iterations as usize + more, "{smoothing:?}");
            }
        }
    }
}
