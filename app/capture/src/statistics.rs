//! Medians of times that are alike from frame to frame, and how far they can be believed.

use statrs::distribution::{ContinuousCDF, StudentsT};

/// Resamples of a median.
const RESAMPLES: usize = 300;
/// Frames that are resampled; of more, every second, third or so.
const MOST_RESAMPLED: usize = 4096;
/// Fewer blocks than this say nothing of an error.
const LEAST_BLOCKS: usize = 10;

/// The middle of some values; 0 of none.
pub(crate) fn median(values: &[f32]) -> f64 {
    let mut values = values.to_vec();
    middle(&mut values)
}

fn middle(values: &mut [f32]) -> f64 {
    let at = values.len() / 2;
    if values.is_empty() {
        return 0.0;
    }
    let odd = values.len() % 2 == 1;
    let (below, upper, _) = values.select_nth_unstable_by(at, f32::total_cmp);
    let upper = f64::from(*upper);
    if odd {
        return upper;
    }
    let lower = below.iter().copied().max_by(f32::total_cmp).map_or(upper, f64::from);
    0.5 * (lower + upper)
}

/// The standard error of a median's logarithm.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BlockError {
    pub of_log: f64,
    pub blocks: usize,
}

impl BlockError {
    /// By resampling blocks of frames; the same values give the same error.
    pub fn of(values: &[f32]) -> Self {
        let thin = values.len().div_ceil(MOST_RESAMPLED).max(1);
        let values: Vec<f32> = values.iter().copied().step_by(thin).collect();
        let count = values.len();
        let length = block_length(&values);
        let blocks = (count / length).max(2);
        let mut random = fastrand::Rng::with_seed(count as u64);
        let mut resampled = Vec::with_capacity(blocks * length);
        let logs: Vec<f64> = (0..RESAMPLES)
            .map(|_| {
                resampled.clear();
                for _ in 0..blocks {
                    let begin = random.usize(..count);
                    // Around the end: each frame is drawn as often as any other.
                    let first = (begin + length).min(count);
                    resampled.extend_from_slice(&values[begin..first]);
                    resampled.extend_from_slice(&values[..length - (first - begin)]);
                }
                middle(&mut resampled).max(f64::MIN_POSITIVE).ln()
            })
            .collect();
        let mean = logs.iter().sum::<f64>() / RESAMPLES as f64;
        let variance = logs.iter().map(|log| (log - mean).powi(2)).sum::<f64>() / (RESAMPLES - 1) as f64;
        // Too few blocks vary too little: of K draws, the variance of a mean comes out (K - 1) / K of itself.
        let few = blocks as f64 / (blocks - 1) as f64;
        Self { of_log: (variance * few).sqrt(), blocks }
    }
}

/// Three times as long as being above the median lasts, at least the cube root of the number of frames, and
/// short enough for ten blocks.
fn block_length(values: &[f32]) -> usize {
    let count = values.len();
    let middle = median(values) as f32;
    let above: Vec<f64> = values.iter().map(|value| if *value > middle { 0.5 } else { -0.5 }).collect();
    let mean = above.iter().sum::<f64>() / count as f64;
    let covariance = |lag: usize| -> f64 {
        above.iter().zip(&above[lag..]).map(|(a, b)| (a - mean) * (b - mean)).sum::<f64>() / count as f64
    };
    let variance = covariance(0);
    let longest = (count / LEAST_BLOCKS).max(1);
    let mut sum = 0.0;
    if variance > 0.0 {
        // Geyer's initial positive sequence: sums of two lags are positive for any reversible process.
        for pair in 0..longest / 2 {
            let both = covariance(2 * pair) + covariance(2 * pair + 1);
            if both <= 0.0 {
                break;
            }
            sum += both;
        }
        sum = (2.0 * sum / variance - 1.0).max(1.0);
    }
    ((3.0 * sum).ceil() as usize).max((count as f64).cbrt().ceil() as usize).clamp(1, longest)
}

/// The quantile of Student's t with `freedom` degrees of freedom, at least 1.
pub(crate) fn student_t(share: f64, freedom: usize) -> f64 {
    // Its parameters are wrong for no whole number from 1 on.
    StudentsT::new(0.0, 1.0, freedom.max(1) as f64).map_or(f64::INFINITY, |t| t.inverse_cdf(share))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_of_t_are_those_of_the_tables() {
        for (share, freedom, table) in [(0.975, 1, 12.706), (0.975, 9, 2.262), (0.9995, 9, 4.781), (0.975, 1000, 1.962)]
        {
            assert!((student_t(share, freedom) - table).abs() < 2e-3, "{share} {freedom}");
        }
    }

    #[test]
    fn the_error_of_independent_frames_is_that_of_the_textbook() {
        let mut random = fastrand::Rng::with_seed(1);
        // Uniform between 1 and 2: the median's standard error is 1 / (2 f sqrt(n)) = .5 / sqrt(n), of a median of 1.5.
        let values: Vec<f32> = (0..2000).map(|_| 1.0 + random.f32()).collect();
        let error = BlockError::of(&values);
        let textbook = 0.5 / 2000_f64.sqrt() / 1.5;
        assert!((0.7..1.4).contains(&(error.of_log / textbook)), "{error:?} against {textbook}");
        assert!(error.blocks > 50, "{error:?}");
    }

    #[test]
    fn frames_that_repeat_count_once() {
        let mut random = fastrand::Rng::with_seed(2);
        let few: Vec<f32> = (0..200).map(|_| 1.0 + random.f32()).collect();
        let repeated: Vec<f32> = few.iter().flat_map(|value| [*value; 10]).collect();
        let (few, repeated) = (BlockError::of(&few), BlockError::of(&repeated));
        assert!((0.6..1.7).contains(&(repeated.of_log / few.of_log)), "{repeated:?} against {few:?}");
    }

    #[test]
    fn a_constant_has_no_error() {
        // But for the rounding of the logarithms' mean.
        assert!(BlockError::of(&[2.0; 50]).of_log < 1e-12);
        assert_eq!((median(&[3.0, 1.0, 2.0]), median(&[4.0, 1.0]), median(&[])), (2.0, 2.5, 0.0));
    }
}
