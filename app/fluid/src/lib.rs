//! The particle-fluid simulation: scene, particles, neighbour grid, solvers, measures.
//!
//! [`scene::Scene`] says what to simulate; [`record`] turns it into recordings that any engine of
//! `brooklet-gpu` runs; [`Session`] runs them, beside others' that a [`SessionRecorder`] was given (pictures,
//! say), and is what every program that steps a scene goes through.

mod body_motion;
pub mod boundary;
pub mod diffuse;
pub mod drag;
pub mod drag_body;
pub mod emitters;
pub mod forces;
pub mod grid;
pub mod measure;
pub mod particles;
pub mod scene;
pub mod session;
mod slot_changes;
mod slots;
pub mod smoothing_kernel;
mod smoothing_kernel_params;
mod solid_forces;
pub mod solver;
pub mod spectrum;
mod stat_fields;
pub mod state;
mod step;
mod step_context;
mod step_params;

pub use body_motion::{BodyMotion, reaction_sums};
pub use measure::Stats;
pub use particles::buffers::Particles;
pub use scene::{Scene, SceneError, shipped_scenes};
pub use session::{
    FrameRequest, ParticleSource, Relaxation, Session, SessionError, SessionPlan, SessionRecorder, SessionReport,
    relax_particles,
};
pub use slot_changes::{DrainBox, ParticleBlock, SlotChanges, activate_params, deactivate_params, record_slot_changes};
pub use slots::{Slots, visit_slots};
pub use smoothing_kernel_params::smoothing_kernel_params;
pub use stat_fields::{STAT_FIELDS, StatField, captured_fields, captured_values};
pub use step::{Recorded, RecordedMeasure, RecordedRelaxation, record, record_count, record_particles};
pub use step_context::StepContext;
pub use step_params::step_params;
