//! What is not there, and why: what the sweep dropped, and what a setting of the scene left out
//! before anything was recorded.
//!
//! The second kind is found by planning the scene once more with that setting on, and looking at
//! what comes along. So the list can never name a pass or a buffer that the setting does not
//! really cost. Those plans are of as many particles, but make none.

use std::collections::{BTreeMap, BTreeSet};

use brooklet_fluid::Scene;
use brooklet_fluid::scene::{Field, Smoothing};
use brooklet_gpu::{LeftOutKind, Plan, Tier};
use serde::Serialize;

use crate::{ScenePlan, ScenePlanError};

/// Something that does not run, or that there is no memory of.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Absent {
    /// Its name.
    pub name: String,
    /// `pass`, `variant`, `command`, `buffer`, `texture`, `timestamps` or `file`.
    pub kind: &'static str,
    /// Memory it would take.
    pub bytes: u64,
    /// Why it is not there.
    pub reason: String,
}

/// The scene with what its settings come to on a tier, as the table of settings can compare it: caustics and
/// the water's own shadow, whose default is the tier's; walls, which no periodic axis has; and smoothing, which is none without iterations.
fn come_to(scene: &Scene, tier: Tier) -> Scene {
    let mut scene = scene.clone();
    scene.surface.caustics.get_or_insert(tier == Tier::Desktop);
    scene.surface.self_shadow.get_or_insert(tier == Tier::Desktop);
    scene.domain.walls = scene.domain.has_walls();
    if scene.surface.iterations() == 0 {
        scene.surface.smoothing = Smoothing::None;
    }
    scene
}

/// The scene with the term of a field, and without what would keep it out all the same.
fn with_term(scene: &Scene, field: &Field) -> Scene {
    let mut scene = scene.with_term(field);
    match field.path {
        "domain.walls" => scene.domain.periodic = [false; 3],
        "surface.smoothing" => scene.surface.iterations = None,
        _ => {}
    }
    scene
}

/// What is recorded beside the simulation.
#[derive(Clone, Copy, Debug, Default)]
pub struct Recorded {
    /// Why no GPU times are taken, if they are not.
    pub no_times: Option<&'static str>,
    /// Whether no capture is written.
    pub no_capture: bool,
}

/// Everything that the plan of `scene` for `tier` does without.
pub fn list(
    scene: &Scene,
    tier: Tier,
    planned: &ScenePlan,
    recorded: &Recorded,
) -> Result<Vec<Absent>, ScenePlanError> {
    let (plan, particles) = (planned.plan(), planned.session.slot_count());
    let mut absent: Vec<Absent> = plan
        .left_out()
        .iter()
        .map(|left_out| Absent {
            name: left_out.name.clone(),
            kind: match left_out.kind {
                LeftOutKind::Stage => "pass",
                LeftOutKind::Command => "command",
                LeftOutKind::Buffer => "buffer",
                LeftOutKind::Texture => "texture",
            },
            bytes: left_out.bytes,
            reason: left_out.reason.clone(),
        })
        .collect();
    for field in come_to(scene, tier).terms_left_out() {
        let other = with_term(scene, field);
        absent.extend(difference(plan, ScenePlan::of_count(&other, particles, tier)?.plan(), &field.reason()));
    }
    if let Some(reason) = recorded.no_times {
        let (name, kind, bytes) = ("timestamps".into(), "timestamps", planned.timestamp_memory());
        absent.push(Absent { name, kind, bytes, reason: reason.into() });
    }
    if recorded.no_capture {
        // The host's alone: nothing of it is in the plan.
        let (name, kind) = ("capture.mcap".into(), "file");
        absent.push(Absent { name, kind, bytes: 0, reason: "--no-capture".into() });
    }
    Ok(absent)
}

fn difference(plan: &Plan, fuller: &Plan, reason: &str) -> Vec<Absent> {
    let names = |plan: &Plan| {
        let mut modules: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
        for pass in plan.passes() {
            modules.entry(pass.stage).or_default().insert(pass.module.name);
        }
        modules
    };
    let absent = |name: &str, kind, bytes| Absent { name: name.into(), kind, bytes, reason: reason.into() };
    let here = names(plan);
    let mut found = Vec::new();
    for (stage, modules) in names(fuller) {
        match here.get(stage) {
            None => found.push(absent(stage, "pass", 0)),
            // The pass is there, in a variant without this term's code and bindings.
            Some(ours) => found.extend(modules.difference(ours).map(|module| absent(module, "variant", 0))),
        }
    }
    let ours: BTreeSet<String> = plan.buffers().into_iter().map(|b| b.label).collect();
    for buffer in fuller.buffers() {
        if !ours.contains(&buffer.label) {
            let kind = match fuller.resources().get(buffer.id) {
                Some(entry) if entry.is_texture() => "texture",
                _ => "buffer",
            };
            found.push(absent(&buffer.label, kind, buffer.bytes));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene(settings: &[&str]) -> Scene {
        let settings: Vec<String> = settings.iter().map(|s| s.to_string()).collect();
        Scene::load("dam-break", &settings).unwrap()
    }

    fn names(absent: &[Absent], kind: &str) -> Vec<String> {
        let of_kind = absent.iter().filter(|a| a.kind == kind);
        of_kind.map(|a| a.name.clone()).collect()
    }

    #[test]
    fn a_term_that_is_off_is_named_with_all_it_would_bring() {
        let base = ["spacing_m=0.1", "outputs.images=0"];
        let off = scene(&[&base[..], &["forces.vorticity_m_s=0"]].concat());
        let on = scene(&[&base[..], &["forces.vorticity_m_s=0.5"]].concat());
        let planned_off = ScenePlan::new(&off, Tier::Desktop).unwrap();
        let planned_on = ScenePlan::new(&on, Tier::Desktop).unwrap();
        let vorticity: Vec<Absent> = list(&off, Tier::Desktop, &planned_off, &Recorded::default())
            .unwrap()
            .into_iter()
            .filter(|absent| absent.reason.starts_with("forces.vorticity"))
            .collect();
        assert_eq!(names(&vorticity, "pass"), ["confine_vorticity", "curl"]);
        let bytes: u64 = vorticity.iter().map(|absent| absent.bytes).sum();
        assert!(bytes > 0);
        let [bytes_off, bytes_on] =
            [&planned_off, &planned_on].map(|planned| planned.plan().clone().without_sharing().bytes());
        assert_eq!(bytes_off + bytes, bytes_on);
        let on_list = list(&on, Tier::Desktop, &planned_on, &Recorded::default()).unwrap();
        assert!(on_list.iter().all(|absent| !absent.reason.starts_with("forces.vorticity")));
    }

    #[test]
    fn each_term_that_is_named_comes_with_what_is_turned_on() {
        let scene = scene(&[
            "spacing_m=0.1",
            "domain.walls=true",
            "solver.deterministic=false",
            "forces.xsph=0",
            "surface.smoothing=narrow-range",
            "surface.iterations=0",
            "surface.anisotropic=false",
            "outputs.images=0",
            "outputs.measure_every_steps=0",
        ]);
        // As a file may not say it with these sides.
        let mut scene = scene;
        scene.domain.periodic = [true; 3];
        let left_out = |scene: &Scene, tier| come_to(scene, tier).terms_left_out();
        let paths = |tier| left_out(&scene, tier).iter().map(|field| field.path).collect::<Vec<_>>();
        let both = [
            "domain.walls",
            "solver.deterministic",
            "solver.pbf.warm_start",
            "solver.pbf.s_corr_k",
            "forces.xsph",
            "forces.vorticity_m_s",
            "surface.smoothing",
            "surface.anisotropic",
        ];
        let outputs = ["outputs.images", "outputs.measure_every_steps"];
        assert_eq!(paths(Tier::Desktop), [&both[..], &outputs].concat());
        assert_eq!(paths(Tier::Mobile), [&both[..], &["surface.caustics", "surface.self_shadow"], &outputs].concat());
        for field in left_out(&scene, Tier::Mobile) {
            let other = with_term(&scene, field);
            let still = left_out(&other, Tier::Mobile);
            assert!(still.iter().all(|other| other.path != field.path), "{} is not turned on", field.path);
        }
    }

    #[test]
    fn without_measurements_nothing_measures() {
        let scene = scene(&["spacing_m=0.1", "outputs.images=0", "outputs.measure_every_steps=0"]);
        let planned = ScenePlan::new(&scene, Tier::Desktop).unwrap();
        assert!(planned.session.recorded.measure.is_none() && planned.passes.is_none());
        let stages: Vec<_> = planned.plan().passes().iter().map(|pass| pass.stage).collect();
        assert!(stages.iter().all(|stage| !stage.starts_with("measure")), "{stages:?}");
        assert!(stages.iter().all(|stage| !stage.starts_with("draw")), "{stages:?}");
        let absent = list(&scene, Tier::Desktop, &planned, &Recorded::default()).unwrap();
        let passes = names(&absent, "pass");
        assert!(passes.contains(&"measure_totals".into()), "{passes:?}");
        assert!(passes.iter().any(|name| name.starts_with("draw")), "{passes:?}");
    }
}
