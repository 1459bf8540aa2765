//! Going up and down the quality ladder: by hand, or by the governor.

use brooklet_fluid::Scene;

use crate::device_speed::{Crowd, Work};
use crate::governor::Standing;
use crate::ladder::RUNGS;
use crate::messages::Kind;
use crate::viewer::Viewer;
use crate::viewer_scene::{Start, needs_reset};

/// How what is said of a rung begins.
const QUALITY: &str = "to hold";

impl Viewer {
    /// Loads another scene from its start, on the rung that what is known of the device lets it have.
    pub(crate) fn begin(&mut self, scene: Scene) {
        self.roomy_rung = 0;
        if self.auto {
            self.weigh(&scene);
            self.rung = self.governor.first(&self.works, self.steps_due(&scene));
        }
        self.load(scene, Start::Scene, "scene");
    }

    /// What each rung comes to for `scene` in the window as it is.
    pub(crate) fn weigh(&mut self, scene: &Scene) {
        let (tier, room_px, crowd) = (self.gpu.tier(), self.room_px, Crowd::of(scene));
        let weigh = |(index, rung)| match index < self.least_rung.max(self.roomy_rung) {
            true => Work { step: f64::INFINITY, draw: f64::INFINITY },
            false => Work::of(rung, scene, crowd, tier, room_px),
        };
        self.works = RUNGS.iter().enumerate().map(weigh).collect();
    }

    /// Steps that a frame of the budget's length is to have.
    fn steps_due(&self, scene: &Scene) -> f64 {
        self.playback.clock.speed * 1e-3 * self.governor.budget_ms / scene.solver.dt_s
    }

    pub(crate) fn take_rung(&mut self, rung: usize) {
        let rung = rung.min(RUNGS.len() - 1);
        if rung == self.rung {
            return;
        }
        self.rung = rung;
        self.governor.settle();
        let Some(current) = &mut self.current else { return };
        let simulated = RUNGS[rung].scene(&current.scene);
        let scene = current.scene.clone();
        let start = if needs_reset(current.session.scene(), &simulated) {
            match current.read_state() {
                Ok(state) => Start::Resampled(Box::new(state)),
                Err(error) => return self.messages.notify(Kind::Error, error.to_string()),
            }
        } else {
            Start::Carry(current.session.slot_count())
        };
        self.load(scene, start, &format!("quality: {}", RUNGS[rung].name));
    }

    pub(crate) fn hold_budget(&mut self) {
        if !self.auto || self.loading.is_some() || self.playback.paused {
            return;
        }
        let (Some(cost), Some(current)) = (self.playback.take_cost(), &self.current) else { return };
        let standing = Standing { rung: self.rung, works: &self.works, steps_due: self.steps_due(&current.scene) };
        if let Some(rung) = self.governor.take(cost, &standing) {
            self.take_rung(rung);
        }
    }

    /// Says what the ladder gave up by itself, once it stands there.
    pub(crate) fn tell_quality(&mut self) {
        let told = self.auto.then_some(self.rung).filter(|rung| *rung > 0);
        if told == self.told_rung {
            return;
        }
        self.told_rung = told;
        // What was said of another rung no longer holds.
        self.messages.withdraw(QUALITY);
        if let (Some(rung), Some(current)) = (told, &self.current) {
            let (budget_ms, given_up) = (self.governor.budget_ms, RUNGS[rung].given_up(&current.scene));
            self.messages.notify(Kind::Done, format!("{QUALITY} {budget_ms:.0} ms a frame: {given_up}"));
        }
    }
}
