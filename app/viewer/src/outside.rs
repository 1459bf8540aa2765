//! What the program round the window knows of the world outside: heat, memory, which way is down, what it is itself.

use brooklet_fluid::Scene;
use brooklet_fluid::state::State;
use brooklet_gpu::GpuError;

use crate::ViewerError;
use crate::ladder::RUNGS;
use crate::messages::Kind;
use crate::recorder;
use crate::viewer::Viewer;
use crate::viewer_scene::{SceneDesc, Start};

impl Viewer {
    /// Goes on with what another viewer showed: the same scene, particles and rung, and who chooses that.
    pub fn resume(&mut self, state: State, rung: usize, auto: bool) {
        (self.rung, self.auto) = (rung.min(RUNGS.len() - 1), auto);
        self.load(state.scene.clone(), Start::State(Box::new(state)), "tier");
    }

    /// Takes the budget as `share` of itself from now on, above 0 to 1: a device that is about to be throttled.
    pub fn be_strict(&mut self, share: f64) {
        self.governor.be_strict(share);
    }

    /// Gravity in place of the scene's own, m/s², from the next frame on and for every scene; none: its own, from the next
    /// scene on.
    pub fn set_gravity(&mut self, gravity_m_s2: Option<[f64; 3]>) {
        self.gravity_m_s2 = gravity_m_s2;
    }

    /// Gives up particles for good: the ladder goes to the next rung that has fewer, and no higher from then on. False if there
    /// is none; said either way, with `reason`.
    pub fn give_up_particles(&mut self, reason: &str) -> bool {
        let scene = self.current.as_ref().map(|current| current.scene.clone());
        let Some(rung) = self.rung_of_fewer(scene.as_ref(), reason) else { return false };
        self.least_rung = rung;
        if let Some(scene) = scene {
            self.weigh(&scene);
        }
        self.take_rung(rung);
        true
    }

    /// The next rung that has fewer particles of `scene`, or of any where there is none; said either way, with `reason`.
    fn rung_of_fewer(&mut self, scene: Option<&Scene>, reason: &str) -> Option<usize> {
        let given_up_of = |rung: usize| match scene {
            Some(scene) => RUNGS[rung].fewer_particles_of(scene),
            None => f64::from(RUNGS[rung].fewer_particles),
        };
        let fewer = |rung: &usize| given_up_of(*rung) > 1.01 * given_up_of(self.rung);
        let Some(rung) = (self.rung..RUNGS.len()).find(fewer) else {
            self.messages.notify(Kind::Warning, format!("{reason}: there is nothing left to give up"));
            return None;
        };
        let given_up = scene.map_or_else(|| RUNGS[rung].name.to_owned(), |scene| RUNGS[rung].given_up(scene));
        self.messages.notify(Kind::Warning, format!("{reason}: {given_up}"));
        Some(rung)
    }

    /// Loads a scene that the device has no room for once more, with fewer particles, if it is to run from its start. The ladder
    /// goes no higher as long as that scene is open; what ran before goes on until it is there.
    pub(crate) fn load_less(&mut self, error: &ViewerError, desc: SceneDesc) {
        let no_room = matches!(error, ViewerError::Gpu(GpuError::OutOfMemory { .. } | GpuError::BufferTooLarge { .. }));
        if !no_room || !self.auto || !matches!(desc.start, Start::Scene) {
            return;
        }
        let Some(rung) = self.rung_of_fewer(Some(&desc.scene), "there is no room") else { return };
        (self.rung, self.roomy_rung) = (rung, rung);
        self.governor.settle();
        self.load(desc.scene, Start::Scene, "fewer particles");
    }

    /// Frames that were handed to the GPU, of all scenes.
    pub fn frames(&self) -> u64 {
        self.playback.frames
    }

    /// The program's name, for captures from the next one on.
    pub fn set_program(&mut self, program: &str) {
        self.set_about("build", recorder::build(program));
    }

    /// Facts that captures have as metadata `name` from the next one on.
    pub fn set_about(&mut self, name: &str, fields: Vec<(String, String)>) {
        self.about.retain(|(known, _)| known != name);
        self.about.push((name.to_owned(), fields));
    }

    /// Writes what is recorded of the capture, and goes on with it.
    pub fn flush_capture(&mut self) {
        self.playback.flush_capture(&mut self.messages);
    }

    /// Paints the picture anew, whatever moves: the window had another, or none.
    pub fn repaint(&mut self) {
        self.playback.redraw();
    }
}
