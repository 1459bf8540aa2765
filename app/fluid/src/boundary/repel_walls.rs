//! Walls that keep the fluid by what they do to velocities across them: one pass at a substep's end, and none where its
//! pressure or their stop keeps it. (Shader: `boundary/repel_walls.compute`.)

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{Buffer, RepelParams, WALLS_BY_DEFLECTION, WALLS_BY_PENALTY};

use crate::particles::buffers::Particles;
use crate::scene::{Scene, WallModel};
use crate::step_context::StepContext;

/// What the walls of a scene are told, if they repel.
pub struct RepelWalls {
    params: Buffer<RepelParams>,
}

/// What the shaders are given; none where pressure or the walls' stop keeps the fluid.
pub fn repel_params(scene: &Scene) -> Option<RepelParams> {
    let model = match scene.domain.wall.model {
        WallModel::Pressure | WallModel::Distance => return None,
        WallModel::Penalty => WALLS_BY_PENALTY,
        WallModel::Deflection => WALLS_BY_DEFLECTION,
    };
    scene.repels_at_walls().then(|| RepelParams {
        model,
        reach_m: (0.5 * scene.fitted_spacing_m()) as f32,
        stiffness_per_s2: scene.wall_stiffness_per_s2() as f32,
        damping_per_s: scene.wall_damping_per_s() as f32,
        restitution: scene.domain.wall.restitution as f32,
        ..RepelParams::default()
    })
}

impl RepelWalls {
    /// None where pressure or the walls' stop keeps the fluid.
    pub(crate) fn declare(resources: &mut Resources, scene: &Scene) -> Option<Self> {
        repel_params(scene).map(|_| Self { params: resources.persistent("repel_params", 1) })
    }

    pub(crate) fn record_init(&mut self, init: &mut Recording, scene: &Scene) {
        init.upload(&mut self.params, repel_params(scene).as_slice());
    }

    /// Repels `particles` where a solver's substep left them.
    pub(crate) fn record(&self, recording: &mut Recording, context: &StepContext, particles: &mut Particles) {
        context.slots.dispatch(
            recording,
            &brooklet_kernels::RepelWalls {
                positions: particles.positions.read(),
                velocities: particles.velocities.write(),
                step_state: context.slots.state.uniform(),
                step_params: context.step.uniform(),
                repel: self.params.uniform(),
            },
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene(settings: &[&str]) -> Scene {
        let settings: Vec<String> = settings.iter().map(|&s| s.into()).collect();
        Scene::load("dam-break", &settings).unwrap()
    }

    #[test]
    fn walls_repel_by_their_model_alone() {
        assert_eq!(repel_params(&scene(&[])), None);
        assert_eq!(repel_params(&scene(&["domain.wall.model=distance"])), None);
        let of = |setting: &str| repel_params(&scene(&[setting])).unwrap();
        let penalty = of("domain.wall={ model = \"penalty\", stiffness_per_s2 = 400, damping_per_s = 3 }");
        assert_eq!((penalty.model, penalty.stiffness_per_s2, penalty.damping_per_s), (WALLS_BY_PENALTY, 400.0, 3.0));
        let own = of("domain.wall.model=penalty");
        let dt_s = 1.0 / 240.0;
        assert!(f64::from(own.stiffness_per_s2) * dt_s * dt_s <= 0.0901, "{own:?}");
        assert!((own.damping_per_s - 2.0 * own.stiffness_per_s2.sqrt()).abs() < 1e-3 * own.damping_per_s);
        let deflection = of("domain.wall={ model = \"deflection\", restitution = 0.5 }");
        assert_eq!((deflection.model, deflection.restitution), (WALLS_BY_DEFLECTION, 0.5));
    }
}
