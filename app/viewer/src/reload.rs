//! Shaders that were compiled anew while they run.

use std::collections::BTreeMap;

use brooklet_gpu::Plan;
use brooklet_kernels::{Module, Tier};

/// A module compiled anew.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NewModule {
    /// The name of the module it takes the place of.
    pub name: String,
    /// Its SPIR-V.
    pub spirv: Vec<u8>,
    /// Bytes of groupshared memory.
    pub shared_bytes: u32,
    /// The lowest tier whose limits it keeps.
    pub tier: Tier,
}

/// All that were since the window was opened, the newest of each name.
#[derive(Clone, Debug, Default)]
pub struct NewModules {
    modules: BTreeMap<String, NewModule>,
}

impl NewModules {
    /// Adds some.
    pub fn add(&mut self, modules: Vec<NewModule>) {
        self.modules.extend(modules.into_iter().map(|module| (module.name.clone(), module)));
    }

    /// The plan with them.
    ///
    /// # Errors
    /// Names a module that binds otherwise than the one before it.
    pub fn put_into(&self, plan: Plan) -> Result<Plan, String> {
        if self.modules.is_empty() {
            return Ok(plan);
        }
        plan.with_modules(|module: &'static Module| {
            let new = self.modules.get(module.name)?;
            // A module is kept until the program ends, as all are: so many bytes an edit.
            Some(module.with_spirv(&new.spirv, new.shared_bytes, new.tier))
        })
    }
}
