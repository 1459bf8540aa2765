//! Holds a frame's time near a budget by going up and down the quality ladder, without swinging between two rungs.
//!
//! From the median times of a few frames it learns how fast the device is, and goes at once to the first rung of which that
//! says that it holds. Going down takes a few frames, going up many, and more each time that it did not hold. Where no rung
//! keeps the fluid's own pace, the fluid moves slower before everything is given up.

use crate::device_speed::{DeviceSpeed, Work};
use crate::ladder::RUNGS;

/// Holds a budget.
#[derive(Clone, Debug)]
pub struct Governor {
    /// What a frame may take, ms.
    pub budget_ms: f64,
    speed: DeviceSpeed,
    /// How fast the fluid shall move at least, over what is wanted.
    pace: f64,
    /// Times of a step and of a picture, ms.
    times_ms: Vec<[f64; 2]>,
    /// Frames to look away after a change: the first ones build caches.
    ignored: u32,
    /// Good frames it takes to go up, doubled by each step up that did not hold.
    patience: u32,
    good_frames: u32,
    frames_since_up: Option<u32>,
    /// A push from outside, as of a hot phone: budgets are taken as so much of themselves.
    strictness: f64,
}

/// What a frame took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameCost {
    /// One step, ms.
    pub step_ms: f64,
    /// The rest, ms.
    pub draw_ms: f64,
}

/// Where the ladder stands.
#[derive(Clone, Copy, Debug)]
pub struct Standing<'a> {
    /// The rung.
    pub rung: usize,
    /// What each rung comes to.
    pub works: &'a [Work],
    /// Steps a frame of the budget's length is to have, for the pace that is wanted.
    pub steps_due: f64,
}

/// Frames a median is taken of.
const WINDOW: usize = 24;
/// Frames that tell of a device nothing is known of, or of a frame far over its budget.
const FEW: usize = 4;
const FAR: f64 = 1.5;
const SETTLING: u32 = 2;
/// Frames in a row so far over their budget at first are told at once: six would be seconds of a still.
const PAIR: usize = 2;
const FAR_OFF: f64 = 4.0;
/// What is gone down to shall hold with a little room,
const ROOM_DOWN: f64 = 0.9;
/// what is gone up to with more.
const ROOM_UP: f64 = 0.7;
/// A frame a tenth over its budget is not yet too slow.
const TOLERANCE: f64 = 1.1;
/// Good frames before the first way up: what the device's kind made of it may be far too low.
const FIRST_PATIENCE: u32 = 12;
const PATIENCE: u32 = 90;
const MOST_PATIENCE: u32 = 60 * 60;
/// A step up that came back within so many frames did not hold.
const HELD: u32 = 600;
/// Paces over what is wanted, and how much at most is given up for each: a fluid in slow motion looks better than
/// a sixteenth of it, and anything better than a still.
const PACES: [(f64, usize); 4] = [(1.0, 10), (0.5, 10), (0.25, 11), (0.0, RUNGS.len() - 1)];

impl Governor {
    /// For a budget, ms, on a device of that speed.
    pub fn new(budget_ms: f64, speed: DeviceSpeed) -> Self {
        Self {
            budget_ms,
            speed,
            pace: 1.0,
            times_ms: Vec::with_capacity(WINDOW),
            ignored: SETTLING,
            patience: FIRST_PATIENCE,
            good_frames: 0,
            frames_since_up: None,
            strictness: 1.0,
        }
    }

    /// For another budget, ms; what is known of the device stays.
    pub fn set_budget(&mut self, budget_ms: f64) {
        *self = Self { strictness: self.strictness, ..Self::new(budget_ms, self.speed) };
    }

    /// Takes budgets as `share` of themselves from now on, above 0 to 1: a device that is about to be throttled.
    pub fn be_strict(&mut self, share: f64) {
        let share = if share.is_finite() { share.clamp(0.25, 1.0) } else { 1.0 };
        if share != self.strictness {
            self.strictness = share;
            self.settle();
        }
    }

    /// How fast the fluid shall move at least, over what is wanted; 0: a step a frame.
    pub fn pace(&self) -> f64 {
        self.pace
    }

    /// The rung to begin on, from all that is known of the device.
    pub fn first(&mut self, works: &[Work], steps_due: f64) -> usize {
        let (rung, pace) = self.fit(works, steps_due, ROOM_DOWN);
        self.pace = pace;
        rung
    }

    /// Takes a frame's times; says which other rung is called for.
    pub fn take(&mut self, cost: FrameCost, at: &Standing<'_>) -> Option<usize> {
        let times_ms = [cost.step_ms, cost.draw_ms];
        if !times_ms.iter().all(|ms| ms.is_finite()) {
            return None;
        }
        if let Some(frames) = &mut self.frames_since_up {
            *frames = frames.saturating_add(1);
        }
        let budget_ms = self.strictness * self.budget_ms;
        let searches = self.patience == FIRST_PATIENCE;
        let is_far_off = |times_ms: [f64; 2]| searches && self.needed_ms(times_ms, at.steps_due) > FAR_OFF * budget_ms;
        if self.ignored > 1 || self.ignored == 1 && !is_far_off(times_ms) {
            self.ignored -= 1;
            return None;
        }
        // The first frames of a rung build caches, and only one is looked away from where all are slow.
        let is_far_off_again = self.times_ms.last().is_some_and(|before| is_far_off(*before)) && is_far_off(times_ms);
        let first = if is_far_off_again { PAIR } else { FEW };
        self.ignored = 0;
        if self.times_ms.len() == WINDOW {
            self.times_ms.remove(0);
        }
        self.times_ms.push(times_ms);
        let few = self.medians(self.times_ms.len().clamp(first, FEW))?;
        let is_far = self.needed_ms(few, at.steps_due) > FAR * budget_ms;
        let [step_ms, draw_ms] = if searches || is_far { few } else { self.medians(WINDOW)? };
        self.speed.learn(&at.works[at.rung], step_ms, draw_ms);
        if self.needed_ms([step_ms, draw_ms], at.steps_due) > TOLERANCE * budget_ms {
            return self.ease(at);
        }
        self.improve(at)
    }

    /// Looks away for some frames: something else changed.
    pub fn settle(&mut self) {
        self.times_ms.clear();
        self.good_frames = 0;
        self.ignored = SETTLING;
    }

    fn ease(&mut self, at: &Standing<'_>) -> Option<usize> {
        let (rung, pace) = self.fit(at.works, at.steps_due, ROOM_DOWN);
        let last = at.works.len() - 1;
        // On the last rung and at the least pace there is nothing left to give up.
        if rung == at.rung && pace == self.pace {
            return None;
        }
        if self.frames_since_up.take().is_some_and(|frames| frames < HELD) {
            self.patience = (2 * self.patience).clamp(PATIENCE, MOST_PATIENCE);
        }
        let slower = pace < self.pace;
        self.pace = pace;
        self.settle();
        // Times that a slower pace mends may leave more than there was.
        let rung = if slower { rung } else { rung.max(at.rung + 1).min(last) };
        (rung != at.rung).then_some(rung)
    }

    fn improve(&mut self, at: &Standing<'_>) -> Option<usize> {
        let (rung, pace) = self.fit(at.works, at.steps_due, ROOM_UP);
        let is_better = pace > self.pace || pace == self.pace && rung < at.rung;
        self.good_frames = if is_better { self.good_frames + 1 } else { 0 };
        if self.good_frames < self.patience {
            return None;
        }
        self.frames_since_up = Some(0);
        self.pace = pace;
        self.settle();
        (rung != at.rung).then_some(rung)
    }

    fn needed_ms(&self, [step_ms, draw_ms]: [f64; 2], steps_due: f64) -> f64 {
        draw_ms + step_ms * (self.pace * steps_due).max(1.0)
    }

    fn medians(&self, count: usize) -> Option<[f64; 2]> {
        let last = &self.times_ms[self.times_ms.len().checked_sub(count)?..];
        Some(std::array::from_fn(|part| {
            let mut sorted: Vec<f64> = last.iter().map(|times| times[part]).collect();
            sorted.sort_unstable_by(f64::total_cmp);
            sorted[(count - 1) / 2]
        }))
    }

    /// The first rung that holds `share` of the budget, and the pace at which it does; the last one and no pace where none does.
    fn fit(&self, works: &[Work], steps_due: f64, share: f64) -> (usize, f64) {
        let limit_ms = share * self.strictness * self.budget_ms;
        let holds = |work: &Work, pace: f64| {
            let (step_ms, draw_ms) = self.speed.costs_ms(work);
            draw_ms + step_ms * (pace * steps_due).max(1.0) <= limit_ms
        };
        let fitting = |(pace, last): (f64, usize)| {
            let rung = works.iter().take(last + 1).position(|work| holds(work, pace))?;
            Some((rung, pace))
        };
        PACES.into_iter().find_map(fitting).unwrap_or((works.len().saturating_sub(1), 0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SPEED: DeviceSpeed = DeviceSpeed { steps: 1.0, draws: 1.0 };

    /// A ladder on which each rung has so much of the work of the one before.
    fn works(share: f64) -> Vec<Work> {
        (0..RUNGS.len() as i32).map(|rung| Work { step: share.powi(rung), draw: 10.0 * share.powi(rung) }).collect()
    }

    /// Frames of a device on which a rung costs `cost_ms`, a quarter of it a step, one of which is due; the rungs at the
    /// end of each.
    fn drive(
        governor: &mut Governor,
        frames: usize,
        mut rung: usize,
        works: &[Work],
        cost_ms: impl Fn(usize, usize) -> f64,
    ) -> Vec<usize> {
        (0..frames)
            .map(|frame| {
                let ms = cost_ms(frame, rung);
                let cost = FrameCost { step_ms: 0.25 * ms, draw_ms: 0.75 * ms };
                rung = governor.take(cost, &Standing { rung, works, steps_due: 1.0 }).unwrap_or(rung);
                rung
            })
            .collect()
    }

    #[test]
    fn a_slow_device_is_within_its_budget_after_a_few_frames_and_stays() {
        let works = works(0.8);
        let cost_ms = |_, rung: usize| 60.0 * 0.8f64.powi(rung as i32);
        let rungs = drive(&mut Governor::new(16.0, SPEED), 4000, 0, &works, cost_ms);
        let last = *rungs.last().unwrap();
        assert!(cost_ms(0, last) <= 16.0 * TOLERANCE && last < 8, "rung {last}");
        assert!(rungs[10..].iter().all(|rung| *rung == last), "it swings: {:?}", &rungs[..30]);
    }

    #[test]
    fn frames_of_seconds_are_told_after_three_and_one_alone_is_not() {
        let works = works(0.8);
        let mut governor = Governor::new(16.0, SPEED);
        let rungs = drive(&mut governor, 3, 0, &works, |_, rung| 600.0 * 0.8f64.powi(rung as i32));
        assert_eq!(rungs[..2], [0, 0]);
        assert!(rungs[2] > 6, "{rungs:?}");
        // What is built in the first two frames, or a hitch later, is no slow device.
        for slow in [0..2, 1..2, 3..4] {
            let cost_ms = |frame: usize, _| if slow.contains(&frame) { 600.0 } else { 12.0 };
            let rungs = drive(&mut Governor::new(16.0, SPEED), 12, 3, &works, cost_ms);
            assert!(rungs.iter().all(|rung| *rung == 3), "{slow:?}: {rungs:?}");
        }
    }

    #[test]
    fn rungs_that_cost_more_than_their_work_are_left_one_by_one() {
        // The work says that each rung halves a frame; it takes off a tenth.
        let cost_ms = |_, rung: usize| 40.0 * 0.9f64.powi(rung as i32);
        let rungs = drive(&mut Governor::new(16.0, SPEED), 4000, 0, &works(0.5), cost_ms);
        let last = *rungs.last().unwrap();
        assert!(cost_ms(0, last) <= 16.0 * TOLERANCE && cost_ms(0, last - 2) > 16.0, "rung {last}");
    }

    #[test]
    fn a_device_that_is_faster_than_its_kind_goes_up_in_half_a_second_of_frames() {
        let mut governor = Governor::new(16.0, DeviceSpeed { steps: 0.01, draws: 0.1 });
        let works = works(0.8);
        let first = governor.first(&works, 1.0);
        assert!(first > 6, "{first}");
        let rungs = drive(&mut governor, 600, first, &works, |_, rung| 4.0 * 0.8f64.powi(rung as i32));
        assert_eq!(rungs[30], 0, "{:?}", &rungs[..30]);
    }

    #[test]
    fn a_rung_that_does_not_hold_is_tried_ever_more_rarely() {
        // One rung is far below the budget, the next far above: the worst case for a ladder.
        let works = works(0.8);
        let cost_ms = |_, rung: usize| if rung == 0 { 30.0 } else { 5.0 };
        let changes = |rungs: Vec<usize>| rungs.windows(2).filter(|pair| pair[0] != pair[1]).count();
        let patient = changes(drive(&mut Governor::new(16.0, SPEED), 20_000, 0, &works, cost_ms));
        assert!((5..30).contains(&patient), "{patient} changes in 20,000 frames");
        // Without the memory of what did not hold.
        let mut governor = Governor::new(16.0, SPEED);
        let (mut rung, mut eager) = (0, 0);
        for _ in 0..20_000 {
            governor.patience = FIRST_PATIENCE;
            let cost = FrameCost { step_ms: 0.0, draw_ms: cost_ms(0, rung) };
            if let Some(to) = governor.take(cost, &Standing { rung, works: &works, steps_due: 1.0 }) {
                rung = to;
                eager += 1;
            }
        }
        assert!(eager > 4 * patient, "{eager} without, {patient} with");
    }

    #[test]
    fn a_device_that_is_free_again_goes_up() {
        let cost_ms = |frame: usize, rung: usize| if frame < 2000 { 40.0 } else { 4.0 } * 0.8f64.powi(rung as i32);
        let rungs = drive(&mut Governor::new(16.0, SPEED), 6000, 0, &works(0.8), cost_ms);
        assert!(rungs[1999] > 2 && *rungs.last().unwrap() == 0, "{} then {}", rungs[1999], rungs.last().unwrap());
    }

    #[test]
    fn single_slow_frames_change_nothing() {
        let cost_ms = |frame: usize, _| if frame.is_multiple_of(10) { 200.0 } else { 12.0 };
        let rungs = drive(&mut Governor::new(16.0, SPEED), 2000, 3, &works(0.8), cost_ms);
        assert!(rungs.iter().all(|rung| *rung == 3));
        let nothing = FrameCost { step_ms: f64::NAN, draw_ms: 1.0 };
        let standing = Standing { rung: 0, works: &works(0.8), steps_due: 1.0 };
        assert_eq!(Governor::new(16.0, SPEED).take(nothing, &standing), None);
    }

    #[test]
    fn the_fluid_slows_down_before_everything_is_given_up() {
        // 20 steps are due in a frame, and on the first rung one takes more than half of the budget.
        let works: Vec<Work> = works(0.8).into_iter().map(|work| Work { draw: 0.0, ..work }).collect();
        let mut governor = Governor::new(16.0, DeviceSpeed { steps: 0.1, draws: 1.0 });
        let rung = governor.first(&works, 20.0);
        assert!(governor.pace() == 0.5 && rung <= 10, "rung {rung} at {}", governor.pace());
        let mut slower = Governor::new(16.0, DeviceSpeed { steps: 0.001, draws: 1.0 });
        assert_eq!((slower.first(&works, 20.0), slower.pace()), (RUNGS.len() - 1, 0.0));
    }

    #[test]
    fn a_strict_governor_gives_up_more() {
        let works = works(0.8);
        let cost_ms = |_, rung: usize| 20.0 * 0.8f64.powi(rung as i32);
        let mut governor = Governor::new(16.0, SPEED);
        let before = *drive(&mut governor, 200, 0, &works, cost_ms).last().unwrap();
        governor.be_strict(0.5);
        let after = *drive(&mut governor, 200, before, &works, cost_ms).last().unwrap();
        assert!(cost_ms(0, after) <= 8.0 * TOLERANCE && after > before, "{before}, then {after}");
        governor.be_strict(f64::NAN);
        let freed = *drive(&mut governor, 4000, after, &works, cost_ms).last().unwrap();
        assert!(freed <= before + 1, "{after}, then {freed}");
    }
}
