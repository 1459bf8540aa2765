//! Random numbers of a counter. (Shader: `shared/hash.hlsli`.)

/// Wellons' lowbias32.
pub fn hash(x: u32) -> u32 {
    let x = (x ^ x >> 16).wrapping_mul(0x7feb_352d);
    let x = (x ^ x >> 15).wrapping_mul(0x846c_a68b);
    x ^ x >> 16
}

/// Evenly from 0 to below 1.
pub fn share(seed: u32) -> f64 {
    f64::from(hash(seed) >> 8) / f64::from(1 << 24)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_even() {
        let all: Vec<f64> = (0..20_000).map(share).collect();
        let mean = all.iter().sum::<f64>() / all.len() as f64;
        let below = all.iter().filter(|&&share| share < 0.1).count() as f64 / all.len() as f64;
        assert!((mean - 0.5).abs() < 0.01 && (below - 0.1).abs() < 0.01, "{mean}, {below}");
        assert!(all.iter().all(|share| (0.0..1.0).contains(share)));
    }
}
