//! What a scene leaves out: each optional term that is off, with the stages, buffers and bytes
//! that are not there because of it.

use std::collections::BTreeSet;

use brooklet_gpu::{Plan, PlanError, Resources};

use crate::particles::{Emitted, emit};
use crate::scene::Scene;
use crate::step::record_particles;

/// An optional term that a scene does not have.
#[derive(Clone, Debug, PartialEq)]
pub struct OffTerm {
    /// The term.
    pub term: &'static str,
    /// Setting that leaves it out.
    pub reason: String,
    /// Stages that are not dispatched.
    pub stages: Vec<String>,
    /// Shader variants that the scene's stages do without.
    pub variants: Vec<String>,
    /// Buffers that are not allocated, with their bytes.
    pub buffers: Vec<(String, u64)>,
}

/// A term: its name, whether a scene has it, the setting that decides, and how to switch it on.
struct Term {
    name: &'static str,
    has: fn(&Scene) -> bool,
    reason: fn(&Scene) -> String,
    switch_on: fn(&mut Scene),
}

const TERMS: [Term; 5] = [
    Term {
        name: "artificial pressure",
        has: |scene| scene.solver.s_corr_k > 0.0,
        reason: |_| "solver.s_corr_k = 0".into(),
        switch_on: |scene| scene.solver.s_corr_k = 0.1,
    },
    Term {
        name: "XSPH viscosity",
        has: |scene| scene.solver.xsph > 0.0,
        reason: |_| "solver.xsph = 0".into(),
        switch_on: |scene| scene.solver.xsph = 0.1,
    },
    Term {
        name: "vorticity confinement",
        has: |scene| scene.solver.vorticity_m_s > 0.0,
        reason: |_| "solver.vorticity_m_s = 0".into(),
        switch_on: |scene| scene.solver.vorticity_m_s = 0.1,
    },
    Term {
        name: "walls",
        has: |scene| scene.domain.walls,
        reason: |_| "domain.walls = false".into(),
        switch_on: |scene| scene.domain.walls = true,
    },
    Term {
        name: "measuring",
        has: |scene| scene.outputs.measure_every_steps > 0,
        reason: |_| "outputs.measure_every_steps = 0".into(),
        switch_on: |scene| scene.outputs.measure_every_steps = 1,
    },
];

/// The optional terms that `scene` does without, found by planning it with each switched on.
///
/// # Errors
/// If a plan cannot be made (a fault of this program).
pub fn off_terms(scene: &Scene) -> Result<Vec<OffTerm>, PlanError> {
    let emitted = emit(scene);
    let without = Parts::of(scene, &emitted)?;
    TERMS
        .iter()
        .filter(|term| !(term.has)(scene))
        .map(|term| {
            let mut full = scene.clone();
            (term.switch_on)(&mut full);
            let with = Parts::of(&full, &emitted)?;
            Ok(OffTerm {
                term: term.name,
                reason: (term.reason)(scene),
                stages: with.stages.difference(&without.stages).cloned().collect(),
                variants: with.modules.difference(&without.modules).cloned().collect(),
                buffers: with.buffers.difference(&without.buffers).cloned().collect(),
            })
        })
        .collect()
}

/// What a plan consists of, by name.
struct Parts {
    stages: BTreeSet<String>,
    modules: BTreeSet<String>,
    buffers: BTreeSet<(String, u64)>,
}

impl Parts {
    fn of(scene: &Scene, emitted: &Emitted) -> Result<Self, PlanError> {
        let mut resources = Resources::new();
        let recorded = record_particles(&mut resources, scene, emitted.clone());
        let wanted = recorded.measure.as_ref().map(|measure| measure.id);
        let plan = Plan::sweep(resources, recorded.recordings, wanted.as_slice())?;
        let passes = plan.passes();
        Ok(Self {
            stages: passes.iter().map(|pass| pass.stage.to_string()).collect(),
            modules: passes.iter().map(|pass| pass.module.name.to_string()).collect(),
            buffers: plan.buffers().into_iter().map(|buffer| (buffer.label, buffer.bytes)).collect(),
        })
    }
}
