//! Which way is down, from the accelerometer.
//!
//! Readings are turned to the display's axes, then so that the attitude that was called level has gravity straight down in the
//! scene. Between readings gravity follows the last one: a sensor that tells once a second tilts the water all the same, only
//! later. Whoever has no sensor keeps the scene's own gravity.

use std::time::Instant;

use glam::{DQuat, DVec3};

use crate::touch::Acceleration;

/// Gravity follows a reading within 1/e in this time at least.
const TAU_S: f64 = 0.08;
/// And in half the time between two readings, up to this.
const MOST_TAU_S: f64 = 0.5;
/// A shaken phone pulls no harder than this.
const MOST_M_S2: f64 = 25.0;
/// Less than this says nothing of which way is down: the phone falls.
const LEAST_LEVEL_M_S2: f64 = 3.0;
/// No accelerometer of a phone reaches so far: a reading beyond it is none.
const SENSELESS_M_S2: f64 = 400.0;
/// Down, in the display's axes.
const DOWN: DVec3 = DVec3::new(0.0, -1.0, 0.0);

/// What is known of it.
#[derive(Clone, Debug, Default)]
pub struct Gravity {
    /// The last reading, as gravity in the display's axes, and when it came.
    last: Option<(DVec3, Instant)>,
    /// Between the last two readings, s.
    interval_s: f64,
    smooth_m_s2: DVec3,
    smoothed: Option<Instant>,
    /// From the display's axes to those of the attitude that is level.
    level: Option<DQuat>,
}

impl Gravity {
    /// Takes a reading; whether it is one. The first is level.
    pub fn take(&mut self, reading: &Acceleration, now: Instant) -> bool {
        let [x, y, z] = reading.m_s2.map(f64::from);
        let device = -DVec3::new(x, y, z);
        if !(device.is_finite() && device.length() < SENSELESS_M_S2) {
            return false;
        }
        let display = on_display(device, reading.rotation_degrees);
        match self.last {
            Some((_, before)) => self.interval_s = (now - before).as_secs_f64(),
            None => (self.smooth_m_s2, self.smoothed) = (display, Some(now)),
        }
        self.last = Some((display, now));
        if self.level.is_none() {
            self.set_level();
        }
        true
    }

    /// Whether there is a sensor.
    pub fn is_known(&self) -> bool {
        self.last.is_some()
    }

    /// Calls the last reading level; whether it says which way is down.
    pub fn set_level(&mut self) -> bool {
        let Some((display, _)) = self.last.filter(|(display, _)| display.length() >= LEAST_LEVEL_M_S2) else {
            return false;
        };
        self.level = Some(DQuat::from_rotation_arc(display.normalize(), DOWN));
        true
    }

    /// Gravity in a scene that is seen from a camera with these axes (right, up, towards the eye), m/s²; none without a sensor.
    pub fn now(&mut self, camera: [DVec3; 3], now: Instant) -> Option<DVec3> {
        let (target, _) = self.last?;
        let tau_s = (0.5 * self.interval_s).clamp(TAU_S, MOST_TAU_S);
        let passed_s = self.smoothed.map_or(0.0, |before| (now - before).as_secs_f64());
        self.smooth_m_s2 += (target - self.smooth_m_s2) * (1.0 - (-passed_s / tau_s).exp());
        self.smoothed = Some(now);
        let level = self.level.unwrap_or_default() * self.smooth_m_s2;
        let [right, _, back] = upright(camera);
        Some((level.x * right + level.y * DVec3::Y + level.z * back).clamp_length_max(MOST_M_S2))
    }
}

/// A vector of the device's axes in the display's: the device is turned counterclockwise by as much.
fn on_display(DVec3 { x, y, z }: DVec3, rotation_degrees: u32) -> DVec3 {
    match rotation_degrees % 360 {
        90 => DVec3::new(-y, x, z),
        180 => DVec3::new(-x, -y, z),
        270 => DVec3::new(y, -x, z),
        _ => DVec3::new(x, y, z),
    }
}

/// The camera's axes as if it looked level: water stays level for whoever looks down on it.
fn upright([right, _, back]: [DVec3; 3]) -> [DVec3; 3] {
    let level = DVec3::new(right.x, 0.0, right.z).try_normalize();
    let right = level.or_else(|| DVec3::new(back.z, 0.0, -back.x).try_normalize()).unwrap_or(DVec3::X);
    [right, DVec3::Y, right.cross(DVec3::Y)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    const CAMERA: [DVec3; 3] = [DVec3::X, DVec3::Y, DVec3::Z];
    const LATER: Duration = Duration::from_secs(20);

    fn reading(m_s2: [f32; 3], rotation_degrees: u32) -> Acceleration {
        Acceleration { m_s2, rotation_degrees }
    }

    /// Gravity some time after the last of these readings, which came a tenth of a second apart.
    fn after(readings: &[Acceleration]) -> DVec3 {
        let (mut gravity, mut now) = (Gravity::default(), Instant::now());
        for reading in readings {
            assert!(gravity.take(reading, now));
            now += Duration::from_millis(100);
        }
        gravity.now(CAMERA, now + LATER).unwrap()
    }

    fn is_near(got: DVec3, wanted: [f64; 3]) -> bool {
        got.abs_diff_eq(DVec3::from(wanted), 1e-4)
    }

    #[test]
    fn a_phone_upright_and_turned_to_the_right_has_water_at_its_right() {
        let upright = reading([0.0, 9.81, 0.0], 0);
        assert!(is_near(after(&[upright]), [0.0, -9.81, 0.0]));
        // Its right side down: up is its left.
        let got = after(&[upright, reading([-9.81, 0.0, 0.0], 0)]);
        assert!(is_near(got, [9.81, 0.0, 0.0]), "{got}");
        let got = after(&[upright, reading([0.0, 0.0, 9.81], 0)]);
        assert!(is_near(got, [0.0, 0.0, -9.81]), "on its back, gravity goes into the picture: {got}");
        assert!(
            !is_near(after(&[upright, reading([9.81, 0.0, 0.0], 0)]), [9.81, 0.0, 0.0]),
            "the other side is another"
        );
    }

    #[test]
    fn a_display_that_turned_with_the_phone_has_water_at_its_foot() {
        let held = [(0, [0.0, 9.81, 0.0]), (90, [9.81, 0.0, 0.0]), (180, [0.0, -9.81, 0.0]), (270, [-9.81, 0.0, 0.0])];
        for (rotation, m_s2) in held {
            let got = on_display(-DVec3::from(m_s2.map(f64::from)), rotation);
            assert!(is_near(got, [0.0, -9.81, 0.0]), "{rotation}: {got}");
        }
        // Turned without the display: not so.
        assert!(!is_near(on_display(DVec3::new(-9.81, 0.0, 0.0), 0), [0.0, -9.81, 0.0]));
    }

    #[test]
    fn however_it_is_held_that_may_be_level() {
        let flat = reading([0.3, 0.2, 9.8], 0);
        let got = after(&[flat]);
        assert!(got.x.abs() < 1e-6 && got.z.abs() < 1e-6 && got.y < -9.7, "{got}");
        let mut gravity = Gravity::default();
        let now = Instant::now();
        assert!(!gravity.set_level(), "nothing is known");
        gravity.take(&reading([0.0, 9.81, 0.0], 0), now);
        gravity.take(&reading([0.0, 6.9, 6.9], 0), now + LATER);
        let tilted = gravity.now(CAMERA, now + 2 * LATER).unwrap();
        assert!(tilted.z < -6.0, "{tilted}");
        assert!(gravity.set_level());
        let level = gravity.now(CAMERA, now + 3 * LATER).unwrap();
        assert!(level.z.abs() < 1e-4 && level.y < -9.7, "{level}");
        gravity.take(&reading([0.0, 0.1, 0.1], 0), now + 4 * LATER);
        assert!(!gravity.set_level(), "it falls");
    }

    #[test]
    fn a_hand_that_trembles_does_not_shake_the_water_and_one_hertz_is_no_jump() {
        let (mut gravity, begun) = (Gravity::default(), Instant::now());
        let mut most: f64 = 0.0;
        for index in 0..400u32 {
            let now = begun + index * Duration::from_millis(5);
            let tremble = if index % 2 == 0 { 2.0 } else { -2.0 };
            gravity.take(&reading([tremble, 9.81, 0.0], 0), now);
            let g = gravity.now(CAMERA, now).unwrap();
            let level = gravity.level.unwrap() * DVec3::new(0.0, -9.81, 0.0);
            if index > 100 {
                most = most.max((g.x - level.x).abs());
            }
        }
        assert!(most < 0.2, "{most}");
        let (mut gravity, mut last, mut jump) = (Gravity::default(), None::<DVec3>, 0.0f64);
        for frame in 0..240u32 {
            let now = begun + frame * Duration::from_millis(16);
            if frame % 60 == 0 {
                let side = if frame / 60 % 2 == 0 { 0.0 } else { 5.0 };
                gravity.take(&reading([side, 8.0, 0.0], 0), now);
            }
            let g = gravity.now(CAMERA, now).unwrap();
            jump = jump.max(last.map_or(0.0, |last| (g - last).length()));
            last = Some(g);
        }
        assert!(jump > 0.05 && jump < 1.2, "{jump} m/s² a frame, of 5");
    }

    #[test]
    fn senseless_readings_are_none_and_shaking_has_an_end() {
        let mut gravity = Gravity::default();
        let now = Instant::now();
        for m_s2 in [[f32::NAN, 0.0, 0.0], [f32::INFINITY, 0.0, 0.0], [1.0e6, 0.0, 0.0]] {
            assert!(!gravity.take(&reading(m_s2, 0), now));
        }
        assert!(gravity.now(CAMERA, now).is_none() && !gravity.is_known());
        let shaken = after(&[reading([0.0, 9.81, 0.0], 0), reading([0.0, 150.0, 0.0], 0)]);
        assert!((shaken.length() - MOST_M_S2).abs() < 1e-9);
    }

    #[test]
    fn down_on_the_screen_is_down_in_the_picture_from_wherever_it_is_seen() {
        let mut gravity = Gravity::default();
        let now = Instant::now();
        gravity.take(&reading([0.0, 9.81, 0.0], 0), now);
        gravity.take(&reading([-9.81, 0.0, 0.0], 0), now);
        // From the right side, and from above.
        let from_the_right = [-DVec3::Z, DVec3::Y, DVec3::X];
        assert!(is_near(gravity.now(from_the_right, now + LATER).unwrap(), [0.0, 0.0, -9.81]));
        let from_above = [DVec3::X, -DVec3::Z, DVec3::Y];
        assert!(is_near(gravity.now(from_above, now + LATER).unwrap(), [9.81, 0.0, 0.0]));
    }
}
