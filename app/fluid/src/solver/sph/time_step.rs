//! How long a substep is, and how long it may be. (Shaders: `solver/sph/find_fastest.compute`,
//! `choose_time_step.compute`.)

use brooklet_gpu::{Recording, Resources};
use brooklet_kernels::{
    Buffer, ChooseTimeStep, ChooseTimeStepVariant, FindFastest, SearchGroups, SphLimits, SphTimeStep, Velocity,
};

use crate::grid::scan_groups;
use crate::scene::Scene;
use crate::slots::Slots;
use crate::step_context::StepContext;

/// The limits, and what the substeps came to.
pub(super) struct TimeStep {
    state: Buffer<SphTimeStep>,
    limits: Buffer<SphLimits>,
    adaptive: bool,
    /// What sorts and lists, where not every substep does.
    search_groups: Option<Buffer<SearchGroups>>,
}

/// h that a particle may move until it is listed anew. Two then come no closer than .9 h unseen, where Wendland's slope is below
/// a hundredth of its largest, and only where both go head-on as fast as the fastest do.
const LIST_REACH: f64 = 0.05;

/// What the shader is given. h/2 stands for the smoothing length, of which the limits are: .4 (h/2) / (c + v) and
/// .25 √((h/2) / a), the square of which goes under the root.
pub fn limits(scene: &Scene) -> SphLimits {
    let half_m = 0.5 * scene.support_m();
    SphLimits {
        cfl_m: (0.4 * half_m) as f32,
        sound_m_s: scene.stiffness_m2_s2().sqrt() as f32,
        force_m: (0.0625 * half_m) as f32,
        steady_s: scene.steady_limit_s() as f32,
        step_s: scene.solver.dt_s as f32,
        substeps: scene.substeps(),
        list_reach_m: if scene.keeps_lists() { (LIST_REACH * scene.support_m()) as f32 } else { 0.0 },
        ..SphLimits::default()
    }
}

impl TimeStep {
    pub(super) fn declare(resources: &mut Resources, scene: &Scene) -> Self {
        Self {
            state: resources.persistent("sph_time_step", 1),
            limits: resources.persistent("sph_limits", 1),
            adaptive: scene.adapts_substeps(),
            search_groups: scene.keeps_lists().then(|| resources.persistent("search_groups", 1)),
        }
    }

    /// For a grid of so many cells.
    pub(super) fn record_init(&mut self, init: &mut Recording, scene: &Scene, cells: u32) {
        init.upload(&mut self.limits, &[SphLimits { scan_groups: scan_groups(cells), ..limits(scene) }]);
        init.clear(&mut self.state);
    }

    pub(super) fn choose(&mut self, recording: &mut Recording, context: &mut StepContext) {
        let kernel = ChooseTimeStep {
            variant: ChooseTimeStepVariant { adaptive: self.adaptive, keeps_lists: self.search_groups.is_some() },
            step_state: context.slots.state.write(),
            time_step: self.state.write(),
            counters: context.counters.write(),
            search_groups: self.search_groups.as_mut().map(Buffer::write),
            step_params: (!self.adaptive).then(|| context.step.uniform()),
            limits: self.limits.uniform(),
        };
        recording.dispatch_groups(&kernel, [1; 3]);
    }

    /// What sorts and lists, where not every substep does.
    pub(super) fn search_groups(&self) -> Option<&Buffer<SearchGroups>> {
        self.search_groups.as_ref()
    }

    /// Notes what limits the next substep.
    pub(super) fn find_fastest(
        &mut self,
        recording: &mut Recording,
        slots: &Slots,
        velocities: &Buffer<Velocity>,
        accelerations: &Buffer<[f32; 4]>,
    ) {
        slots.dispatch(
            recording,
            &FindFastest {
                velocities: velocities.read(),
                accelerations: accelerations.read(),
                time_step: self.state.write(),
                step_state: slots.state.uniform(),
            },
        );
    }
}
