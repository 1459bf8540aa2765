//! How many steps a drawn frame holds: the simulation keeps its own time, whatever the display's rate.

/// Turns the time that passes into steps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clock {
    /// Simulated seconds a second: 1 is real time.
    pub speed: f64,
    due_s: f64,
}

/// A frame that took longer than this (a window was moved, a laptop slept) is not made up for.
const LONGEST_FRAME_S: f64 = 0.25;

impl Default for Clock {
    fn default() -> Self {
        Self { speed: 1.0, due_s: 0.0 }
    }
}

impl Clock {
    /// Steps of `dt_s` to do after `elapsed_s`, at most `most`. What is beyond that is let go: the
    /// simulation then runs slower than it should instead of falling ever further behind.
    pub fn steps(&mut self, elapsed_s: f64, dt_s: f64, most: u32) -> u32 {
        self.due_s += elapsed_s.clamp(0.0, LONGEST_FRAME_S) * self.speed.max(0.0);
        let due = (self.due_s / dt_s).floor();
        if due > f64::from(most) {
            self.due_s = 0.0;
            return most;
        }
        self.due_s -= due * dt_s;
        due as u32
    }
}

/// How many steps fit into a frame of `budget_ms`, drawing included: at least one, so that a slow
/// device shows slow motion and not a still.
pub fn steps_within(budget_ms: f64, draw_ms: f64, step_ms: f64) -> u32 {
    // Not so many that a wrong time of a step could hang the device.
    const MOST: f64 = 64.0;
    let fit = ((budget_ms - draw_ms) / step_ms.max(1e-6)).floor();
    if fit.is_finite() { fit.clamp(1.0, MOST) as u32 } else { 1 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn over_time_as_much_is_simulated_as_passes() {
        for (speed, frame_s) in [(1.0, 1.0 / 60.0), (0.25, 1.0 / 144.0), (2.0, 0.031)] {
            let mut clock = Clock { speed, ..Clock::default() };
            let dt_s = 1.0 / 240.0;
            let frames = 1000;
            let steps: u32 = (0..frames).map(|_| clock.steps(frame_s, dt_s, 1000)).sum();
            let simulated_s = f64::from(steps) * dt_s;
            assert!((simulated_s - speed * frame_s * f64::from(frames)).abs() < dt_s + 1e-9, "{simulated_s}");
        }
    }

    #[test]
    fn what_cannot_be_done_is_not_owed() {
        let mut clock = Clock::default();
        assert_eq!(clock.steps(0.2, 0.01, 3), 3);
        assert_eq!(clock.steps(0.0, 0.01, 3), 0, "the other seventeen are let go");
        assert_eq!(clock.steps(3600.0, 0.01, 100), 25, "a sleep is not made up for");
        assert_eq!(clock.steps(-1.0, 0.01, 100), 0);
    }

    #[test]
    fn a_slow_device_still_moves() {
        assert_eq!(steps_within(16.0, 6.0, 2.0), 5);
        assert_eq!(steps_within(16.0, 40.0, 2.0), 1);
        assert_eq!(steps_within(16.0, 0.0, 0.0), 64);
        assert_eq!(steps_within(f64::NAN, 0.0, 1.0), 1);
    }
}
