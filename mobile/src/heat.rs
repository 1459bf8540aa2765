//! How strict the quality ladder is to be, so that the phone does not get hot: from the system's thermal headroom, or where
//! that is unknown, from frames that take ever longer for the same work.

use std::collections::VecDeque;
use std::time::{Duration, Instant};

/// Up to here nothing is given up.
const COOL: f32 = 0.75;
/// At 1 the system slows the device down: then half of the budget is used, and less beyond.
const SHARE_AT_1: f64 = 0.5;
/// The least share.
const LEAST_SHARE: f64 = 0.3;

/// Frame times are looked at so often,
const EVERY: Duration = Duration::from_secs(1);
/// so many of them make a median,
const MEDIAN_OF: usize = 9;
/// and if that rose by so much since the rung was taken, the device is being slowed down.
const RISE: f64 = 1.2;
/// After so long without a rise a little more is tried.
const RECOVERS: Duration = Duration::from_secs(30);
const RECOVERS_BY: f64 = 0.1;

/// What is known of the device's heat.
#[derive(Clone, Debug, Default)]
pub struct Heat {
    headroom: Option<f32>,
    /// Times of frames on one rung, ms.
    times_ms: VecDeque<f64>,
    first_ms: Option<f64>,
    rung: Option<usize>,
    looked: Option<Instant>,
    /// What the trend made of it, and since when.
    share: Option<(f64, Instant)>,
}

impl Heat {
    /// Takes the system's answer; NaN, or what is no headroom, is none.
    pub fn take_headroom(&mut self, headroom: f32) {
        self.headroom = Some(headroom).filter(|headroom| headroom.is_finite() && *headroom >= 0.0);
    }

    /// Takes what a frame of a rung takes now, ms.
    pub fn take_frame(&mut self, rung: usize, frame_ms: f64, now: Instant) {
        if self.looked.is_some_and(|looked| now - looked < EVERY) || !frame_ms.is_finite() {
            return;
        }
        self.looked = Some(now);
        if self.rung != Some(rung) {
            (self.rung, self.first_ms) = (Some(rung), None);
            self.times_ms.clear();
        }
        self.times_ms.push_back(frame_ms);
        if self.times_ms.len() > MEDIAN_OF {
            self.times_ms.pop_front();
        }
        if self.times_ms.len() == MEDIAN_OF {
            self.follow(now);
        }
    }

    /// What share of the budget is to be used.
    pub fn share(&self) -> f64 {
        match self.headroom {
            Some(headroom) if headroom <= COOL => 1.0,
            Some(headroom) => {
                let beyond = f64::from(headroom - COOL) / f64::from(1.0 - COOL);
                (1.0 - beyond * (1.0 - SHARE_AT_1)).max(LEAST_SHARE)
            }
            None => self.share.map_or(1.0, |(share, _)| share),
        }
    }

    fn follow(&mut self, now: Instant) {
        let mut sorted: Vec<f64> = self.times_ms.iter().copied().collect();
        sorted.sort_unstable_by(f64::total_cmp);
        let median_ms = sorted[MEDIAN_OF / 2];
        let first_ms = *self.first_ms.get_or_insert(median_ms);
        let (share, since) = self.share.unwrap_or((1.0, now));
        if median_ms > RISE * first_ms {
            self.share = Some(((share * first_ms / median_ms).max(LEAST_SHARE), now));
            // From here on the rise is another one.
            self.first_ms = None;
            self.times_ms.clear();
        } else if share < 1.0 && now - since >= RECOVERS {
            self.share = Some(((share + RECOVERS_BY).min(1.0), now));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Seconds of frames of such times on one rung.
    fn drive(heat: &mut Heat, begun: Instant, seconds: std::ops::Range<u64>, frame_ms: impl Fn(u64) -> f64) {
        for second in seconds {
            heat.take_frame(3, frame_ms(second), begun + Duration::from_secs(second));
        }
    }

    #[test]
    fn less_headroom_makes_it_stricter() {
        let mut heat = Heat::default();
        let shares = [0.2, 0.75, 0.9, 1.0, 1.5].map(|headroom| {
            heat.take_headroom(headroom);
            heat.share()
        });
        assert_eq!([shares[0], shares[1], shares[4]], [1.0, 1.0, LEAST_SHARE]);
        assert!(shares[2] < 0.8 && shares[2] > 0.6 && (shares[3] - 0.5).abs() < 1e-9, "{shares:?}");
    }

    #[test]
    fn without_headroom_frames_that_take_ever_longer_tell() {
        let (mut heat, begun) = (Heat::default(), Instant::now());
        heat.take_headroom(f32::NAN);
        drive(&mut heat, begun, 0..60, |_| 16.0);
        assert_eq!(heat.share(), 1.0, "nothing rose");
        drive(&mut heat, begun, 60..120, |second| 16.0 + 0.3 * (second - 60) as f64);
        let hot = heat.share();
        assert!((LEAST_SHARE..0.9).contains(&hot), "{hot}");
        drive(&mut heat, begun, 120..1000, |_| 16.0);
        assert_eq!(heat.share(), 1.0, "it recovers");
        heat.take_headroom(0.1);
        assert_eq!(heat.share(), 1.0, "what the system says counts");
    }

    #[test]
    fn another_rung_is_no_rise() {
        let (mut heat, begun) = (Heat::default(), Instant::now());
        drive(&mut heat, begun, 0..30, |_| 10.0);
        for second in 30..60 {
            heat.take_frame(1, 30.0, begun + Duration::from_secs(second));
        }
        assert_eq!(heat.share(), 1.0);
    }
}
