//! A body that a hand holds is drawn to where the hand is. (Shader: `boundary/bodies/drag_body.compute`.)

use brooklet_gpu::{Engine, Recording, Resources};
use brooklet_kernels::{BodyDragParams, Buffer, NO_BODY};

use crate::scene::Scene;
use crate::step::Recorded;

/// How a body is dragged during one frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyDrag {
    /// The body, as they are numbered in the order of their solids.
    pub body: u32,
    /// Which point of it is held, in its solid's frame, m.
    pub grip_m: [f64; 3],
    /// Where that is drawn to, relative to the domain's lowest corner, m.
    pub target_m: [f64; 3],
    /// Simulated time that the frame advances, s.
    pub dt_s: f64,
    /// Time in which what is left of the way falls to about 2/e, once the grip moves, s.
    pub tau_s: f64,
    /// The hand makes the grip no faster, m/s.
    pub most_m_s: f64,
}

/// Spin that a held body has is lost to 1/e in so many times the drag's own time.
const SPIN_TIMES: f64 = 4.0;

/// What drags a body.
pub struct BodyDragPass {
    /// One drag; to be run before the steps of a frame in which somebody drags a body.
    pub recording: Recording,
    params: Buffer<BodyDragParams>,
}

/// Records a drag of a body beside a scene's other recordings; none of a scene without bodies. Until
/// [`BodyDragPass::write`] it moves nothing.
pub fn record_drag_body(resources: &mut Resources, recorded: &mut Recorded) -> Option<BodyDragPass> {
    let bodies = recorded.bodies.as_mut().filter(|bodies| bodies.count > 0)?;
    let mut params = resources.persistent("body_drag_params", 1);
    recorded.init.upload(&mut params, &[idle()]);
    let mut recording = resources.recording("drag_body");
    recording.dispatch_groups(
        &brooklet_kernels::DragBody {
            bodies: bodies.inertia.read(),
            body_states: bodies.states.write(),
            body_drag: params.uniform(),
        },
        [1; 3],
    );
    Some(BodyDragPass { recording, params })
}

fn idle() -> BodyDragParams {
    BodyDragParams { body: NO_BODY, ..BodyDragParams::default() }
}

impl BodyDragPass {
    /// Sets what the next run of the recording does.
    pub fn write(&self, engine: &mut Engine, scene: &Scene, drag: &BodyDrag) {
        engine.write(&self.params, &[self.params(scene, drag)]);
    }

    /// What the shader is given. A drag that is not finite, has no time, or is of a body that there is not moves nothing.
    pub fn params(&self, scene: &Scene, drag: &BodyDrag) -> BodyDragParams {
        // ω of the spring: critically damped, its fall is 2/e after 1/ω.
        let advance = drag.dt_s / drag.tau_s;
        let kept = (1.0 + advance).powi(-2);
        let params = BodyDragParams {
            grip_m: drag.grip_m.map(|x| x as f32),
            body: drag.body,
            target_m: drag.target_m.map(|x| x as f32),
            kept: kept as f32,
            pull_per_s: (kept * advance / drag.tau_s) as f32,
            kept_spin: (-advance / SPIN_TIMES).exp() as f32,
            most_m_s: drag.most_m_s as f32,
            ..idle()
        };
        let numbers = [params.grip_m, params.target_m].concat();
        let others = [params.kept, params.pull_per_s, params.kept_spin, params.most_m_s];
        let is_finite = numbers.iter().chain(&others).all(|x| x.is_finite());
        let is_there = drag.body < crate::scene::body_count(scene);
        if is_finite && is_there && drag.dt_s > 0.0 && drag.tau_s > 0.0 { params } else { idle() }
    }
}
