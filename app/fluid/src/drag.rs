//! Dragging draws what is under a cursor along. (Shader: `particles/drag.compute`.)

use brooklet_gpu::{Engine, Recording, Resources};
use brooklet_kernels::{Buffer, DragParams};

use crate::scene::Scene;
use crate::step::Recorded;

/// A drag during one frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drag {
    /// Where the ray begins: the eye. Relative to the domain's lowest corner, m.
    pub origin_m: [f64; 3],
    /// Where it goes: through the cursor. Of any length but 0.
    pub direction: [f64; 3],
    /// Nothing farther from the ray is touched, m.
    pub radius_m: f64,
    /// Nothing nearer to the origin than this along the ray is touched, m.
    pub near_m: f64,
    /// Nor what is farther than this, m; may be infinite.
    pub far_m: f64,
    /// What particles are drawn toward: the cursor's own velocity at the fluid's depth, m/s.
    pub velocity_m_s: [f64; 3],
    /// Simulated time that the frame advances, s.
    pub dt_s: f64,
    /// Time in which a particle on the ray comes within 1/e of the velocity, s; 0: at once.
    pub tau_s: f64,
}

/// What drags.
pub struct DragPass {
    /// One drag; to be run before the steps of a frame in which somebody drags.
    pub recording: Recording,
    params: Buffer<DragParams>,
}

/// Records a drag beside a scene's other recordings: v += w(r) (1 − exp(−dt/τ)) (v_drag − v) with
/// w(r) = (1 − r²)² and r the distance from the ray over the radius, so that no edge shows. Until
/// [`DragPass::write`] it moves nothing. A scene that nobody drags does without it, and then has neither its
/// pass nor its buffer.
pub fn record_drag(resources: &mut Resources, recorded: &mut Recorded) -> DragPass {
    let mut params = resources.persistent("drag_params", 1);
    recorded.init.upload(&mut params, &[DragParams::default()]);
    let mut recording = resources.recording("drag");
    recorded.slots.dispatch(
        &mut recording,
        &brooklet_kernels::Drag {
            positions: recorded.positions.read(),
            velocities: recorded.velocities.write(),
            step_state: recorded.slots.state.uniform(),
            drag: params.uniform(),
        },
    );
    DragPass { recording, params }
}

impl DragPass {
    /// Sets what the next run of the recording does.
    pub fn write(&self, engine: &mut Engine, scene: &Scene, drag: &Drag) {
        engine.write(&self.params, &[self.params(scene, drag)]);
    }

    /// What the shader is given. A drag that is not finite, or has no direction or radius, moves nothing.
    pub fn params(&self, scene: &Scene, drag: &Drag) -> DragParams {
        let idle = DragParams::default();
        let length = dot(drag.direction, drag.direction).sqrt();
        let direction = drag.direction.map(|x| x / length);
        let size_m = scene.domain.size_m();
        // From the foot of the domain's middle on the ray: in f32 a far eye's own position would blur it.
        let to_middle_m: [f64; 3] = std::array::from_fn(|axis| 0.5 * size_m[axis] - drag.origin_m[axis]);
        let foot_m = dot(to_middle_m, direction);
        let mut params = DragParams {
            origin_m: std::array::from_fn(|axis| (drag.origin_m[axis] + foot_m * direction[axis]) as f32),
            radius_m: drag.radius_m as f32,
            direction: direction.map(|x| x as f32),
            share: -(-drag.dt_s / drag.tau_s).exp_m1() as f32,
            velocity_m_s: drag.velocity_m_s.map(|v| v as f32),
            along_z: if scene.domain.is_flat() { 0.0 } else { 1.0 },
            near_m: (drag.near_m - foot_m).max(-BEYOND_M) as f32,
            far_m: (drag.far_m - foot_m).min(BEYOND_M) as f32,
            ..idle
        };
        if drag.dt_s == 0.0 {
            params.share = 0.0;
        }
        let numbers = [params.origin_m, params.direction, params.velocity_m_s].concat();
        let others = [params.radius_m, params.share, params.near_m, params.far_m];
        let finite = numbers.iter().chain(&others).all(|x| x.is_finite());
        if finite && params.radius_m > 0.0 && params.share > 0.0 { params } else { idle }
    }
}

/// Behind everything a scene may have, and finite in f32 when squared.
const BEYOND_M: f64 = 1.0e18;

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|axis| a[axis] * b[axis]).sum()
}
