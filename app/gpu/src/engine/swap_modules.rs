//! Another plan over the same memory, while the program runs.

use super::Engine;
use crate::error::GpuError;
use crate::plan::Plan;
use crate::steps::prepare;

impl Engine {
    /// Goes on with `plan`, which was made over the same resources as the one it replaces: as
    /// [`Plan::with_modules`] makes it from recompiled shaders. Buffers and textures keep their
    /// content, frames in flight finish as they began, and of the pipelines only those of modules
    /// that are new to the device are built.
    ///
    /// # Errors
    /// If the plan needs other memory than there is, naming the first resource; if a module is above
    /// the device's tier, or the driver cannot compile it. The engine then runs what it ran before,
    /// unless the driver gave up the device over it ([`crate::Gpu::is_lost`]).
    pub fn swap_modules(&mut self, plan: Plan) -> Result<(), GpuError> {
        self.gpu.check()?;
        if let Some(label) = other_resource(&self.plan, &plan) {
            return Err(GpuError::OtherMemory { label, reason: "the two plans declare it differently" });
        }
        self.arena.serves(&plan)?;
        let (ready, staging) = prepare(&self.gpu, &plan, &self.arena, &mut |_, _, _| ())?;
        self.ready = ready;
        self.staging.bytes = staging.bytes;
        self.staging.count += staging.count;
        self.plan = plan;
        Ok(())
    }
}

/// The first resource that two plans declare differently.
fn other_resource(has: &Plan, needs: &Plan) -> Option<String> {
    let (mut has, mut needs) = (has.resources().iter(), needs.resources().iter());
    loop {
        match (has.next(), needs.next()) {
            (None, None) => return None,
            (Some((_, one)), Some((_, other))) if one == other => {}
            (one, other) => return other.or(one).map(|(_, entry)| entry.label.clone()),
        }
    }
}
