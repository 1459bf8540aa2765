//! A drain that takes so many particles a second at most. (Shader: `emitters/limit_drain.compute`.)

/// Who of those in the drain is taken: in the order of slots, as many whole particles as there is credit for.
pub fn take_drained(is_in: &[bool], credit: f64) -> Vec<bool> {
    let mut left = credit.floor() as usize;
    let take = |&is_in: &bool| {
        let takes = is_in && left > 0;
        left -= usize::from(takes);
        takes
    };
    is_in.iter().map(take).collect()
}

/// The credit after a substep of `dt_s`: a part of a particle is kept, whole ones that were not used are not.
pub fn settle_drain(credit: f64, particles_per_s: f64, dt_s: f64) -> f64 {
    credit.fract() + particles_per_s * dt_s
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_not_used_is_not_kept_and_parts_add_up() {
        assert_eq!(take_drained(&[true, false, true, true], 2.75), [true, false, true, false]);
        assert_eq!(take_drained(&[true; 2], 0.99), [false; 2]);
        let (mut credit, mut taken) = (0.0, 0);
        for substep in 0..1000 {
            let is_in = vec![substep >= 500; 8];
            taken += take_drained(&is_in, credit).iter().filter(|taken| **taken).count();
            credit = settle_drain(credit, 37.5, 0.01);
        }
        assert!((taken as f64 - 37.5 * 5.0).abs() <= 1.0, "{taken} in 5 s of the 10");
    }
}
