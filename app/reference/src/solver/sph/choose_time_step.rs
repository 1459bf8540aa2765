//! How long a substep is. (Shader: `solver/sph/choose_time_step.compute`.)

use brooklet_kernels::SphLimits;

/// What limits it; see `SphLimits`.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// Over the speed of sound and the fastest particle's, m.
    pub cfl_m: f64,
    /// m/s.
    pub sound_m_s: f64,
    /// Over the largest acceleration, under the root, m.
    pub force_m: f64,
    /// The least of those that stay, s.
    pub steady_s: f64,
    /// What a step advances, s.
    pub step_s: f64,
    /// Of a step, at most.
    pub substeps: u32,
    /// That particles may move until they are listed anew, m.
    pub list_reach_m: f64,
}

/// What is left of a step whose substeps the limits choose.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Left {
    /// Time, s.
    pub left_s: f64,
    /// Substeps that there may still be.
    pub substeps: u32,
}

/// A substep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chosen {
    /// Its length; 0 of one that visits nothing.
    pub dt_s: f64,
    /// Whether that is above the limit.
    pub is_long: bool,
    /// What it leaves.
    pub left: Left,
}

impl Limits {
    /// What shaders are given.
    pub fn of(limits: &SphLimits) -> Self {
        Self {
            cfl_m: limits.cfl_m.into(),
            sound_m_s: limits.sound_m_s.into(),
            force_m: limits.force_m.into(),
            steady_s: limits.steady_s.into(),
            step_s: limits.step_s.into(),
            substeps: limits.substeps,
            list_reach_m: limits.list_reach_m.into(),
        }
    }

    /// The longest allowed substep after one with this fastest particle and largest acceleration, s.
    pub fn limit_s(&self, max_speed_m_s: f64, max_acceleration_m_s2: f64) -> f64 {
        let cfl_s = self.cfl_m / (self.sound_m_s + max_speed_m_s);
        let force_s = if max_acceleration_m_s2 > 0.0 { (self.force_m / max_acceleration_m_s2).sqrt() } else { cfl_s };
        cfl_s.min(force_s).min(self.steady_s)
    }

    /// As few substeps to the step's end as the limit allows.
    pub fn choose(&self, limit_s: f64, before: Left) -> Chosen {
        let before = match before.substeps {
            0 => Left { left_s: self.step_s, substeps: self.substeps },
            _ => before,
        };
        if before.left_s <= 0.0 {
            let left = Left { left_s: 0.0, substeps: before.substeps - 1 };
            return Chosen { dt_s: 0.0, is_long: false, left };
        }
        let substeps = (before.left_s / limit_s).ceil().clamp(1.0, f64::from(before.substeps));
        let dt_s = before.left_s / substeps;
        let left_s = if substeps == 1.0 { 0.0 } else { before.left_s - dt_s };
        Chosen { dt_s, is_long: is_long(dt_s, limit_s), left: Left { left_s, substeps: before.substeps - 1 } }
    }
}

impl Limits {
    /// How far particles may have moved since they were listed when a substep of `dt_s` has moved them, after one with this
    /// fastest particle and largest acceleration, m; 0 of one that lists them.
    pub fn drift_m(&self, drift_m: f64, dt_s: f64, [speed_m_s, acceleration_m_s2]: [f64; 2], is_first: bool) -> f64 {
        let drifted_m = drift_m + dt_s * (speed_m_s + dt_s * acceleration_m_s2);
        if !is_first && drifted_m <= self.list_reach_m { drifted_m } else { 0.0 }
    }
}

/// Whether a substep is above its limit, by more than a rounding.
pub fn is_long(dt_s: f64, limit_s: f64) -> bool {
    dt_s > 1.0001 * limit_s
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIMITS: Limits = Limits {
        cfl_m: 0.008,
        sound_m_s: 30.0,
        force_m: 0.00125,
        steady_s: 1.0,
        step_s: 1.0 / 240.0,
        substeps: 30,
        list_reach_m: 0.002,
    };

    #[test]
    fn substeps_add_up_to_the_step_and_keep_the_limit() {
        let mut left = Left::default();
        let (mut time_s, mut taken) = (0.0, 0);
        for _ in 0..LIMITS.substeps {
            let chosen = LIMITS.choose(LIMITS.limit_s(2.0, 100.0), left);
            assert!(!chosen.is_long);
            taken += u32::from(chosen.dt_s > 0.0);
            time_s += chosen.dt_s;
            left = chosen.left;
        }
        assert!((time_s - LIMITS.step_s).abs() < 1e-15 && left == Left::default());
        // .008 / 32 = 250 us, and 4,167 us are 16.7 of them.
        assert_eq!(taken, 17);
    }

    #[test]
    fn what_has_no_room_for_its_substeps_says_so_and_still_ends_in_time() {
        let limits = Limits { substeps: 4, ..LIMITS };
        let mut left = Left::default();
        let (mut time_s, mut long) = (0.0, 0);
        for _ in 0..4 {
            let chosen = limits.choose(2.5e-4, left);
            (time_s, long, left) = (time_s + chosen.dt_s, long + u32::from(chosen.is_long), chosen.left);
        }
        assert_eq!(long, 4);
        assert!((time_s - limits.step_s).abs() < 1e-15);
    }

    #[test]
    fn particles_are_listed_anew_before_they_have_gone_too_far() {
        let moved = |drift_m, dt_s, is_first| LIMITS.drift_m(drift_m, dt_s, [3.0, 1000.0], is_first);
        assert_eq!(moved(0.0012, 1.0e-4, true), 0.0, "a step's first");
        assert!((moved(0.0012, 1.0e-4, false) - 0.00151).abs() < 1e-15);
        assert_eq!(moved(0.0018, 1.0e-4, false), 0.0, "too far");
        assert_eq!(moved(0.0, f64::NAN, false), 0.0, "nobody knows where to");
        assert_eq!(Limits { list_reach_m: 0.0, ..LIMITS }.drift_m(0.0, 1.0e-4, [1e-9, 0.0], false), 0.0, "always");
    }

    #[test]
    fn each_limit_is_the_least_where_it_bites() {
        assert!((LIMITS.limit_s(10.0, 0.0) - 0.008 / 40.0).abs() < 1e-18);
        assert!((LIMITS.limit_s(0.0, 1e6) - (0.00125e-6_f64).sqrt()).abs() < 1e-18);
        assert_eq!(Limits { steady_s: 1e-5, ..LIMITS }.limit_s(0.0, 1.0), 1e-5);
    }
}
