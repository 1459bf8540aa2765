//! A plan with other modules: for shaders that are compiled anew while the program runs, and for tests
//! that put a fault in.

use brooklet_kernels::Module;

use crate::plan::Plan;
use crate::recording::Command;

impl Plan {
    /// Every module that it runs, each as often as it is recorded.
    pub fn modules(&self) -> impl Iterator<Item = &'static Module> + '_ {
        self.recordings.iter().flat_map(|recording| &recording.commands).flat_map(|command| {
            let modules: [Option<&'static Module>; 2] = match command {
                Command::Dispatch(dispatch) => [Some(dispatch.module), None],
                Command::Draw(draw) => [Some(draw.vertex), draw.fragment],
                _ => [None, None],
            };
            modules.into_iter().flatten()
        })
    }

    /// The plan with each module that `other` has another for exchanged. One that binds otherwise than its
    /// predecessor is not taken: what is bound was checked against the first.
    ///
    /// # Errors
    /// Names the first module that binds otherwise.
    pub fn with_modules(mut self, other: impl Fn(&'static Module) -> Option<&'static Module>) -> Result<Plan, String> {
        let exchange = |module: &mut &'static Module| match other(module) {
            Some(new) if new.bindings != module.bindings => {
                Err(format!("{}: the new module binds {:?}, not {:?}", module.name, new.bindings, module.bindings))
            }
            Some(new) => {
                *module = new;
                Ok(())
            }
            None => Ok(()),
        };
        for command in self.recordings.iter_mut().flat_map(|recording| &mut recording.commands) {
            match command {
                Command::Dispatch(dispatch) => exchange(&mut dispatch.module)?,
                Command::Draw(draw) => {
                    exchange(&mut draw.vertex)?;
                    draw.fragment.as_mut().map_or(Ok(()), exchange)?;
                }
                _ => {}
            }
        }
        Ok(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Resources;
    use brooklet_kernels::{Kernel, ReduceGroups};

    #[test]
    fn modules_are_exchanged_and_one_that_binds_otherwise_is_refused() {
        let mut resources = Resources::new();
        let values = resources.persistent::<u32>("values", 4);
        let mut sums = resources.persistent::<u32>("group_sums", 1);
        let mut recording = resources.recording("sum");
        let kernel = ReduceGroups { values: values.read(), group_sums: sums.write() };
        let module = kernel.module();
        recording.dispatch(&kernel, 4);
        let plan = Plan::sweep(resources, vec![recording], &[]).unwrap();
        let renamed: &'static Module = Box::leak(Box::new(Module { name: "Other", ..*module }));
        let changed = plan.clone().with_modules(|of| (of.name == module.name).then_some(renamed)).unwrap();
        assert_eq!(changed.passes()[0].module.name, "Other");
        let unbound: &'static Module = Box::leak(Box::new(Module { bindings: &[], ..*module }));
        let error = plan.clone().with_modules(|_| Some(unbound)).unwrap_err();
        assert!(error.contains(module.name), "{error}");
        assert_eq!(plan.with_modules(|_| None).unwrap().passes()[0].module.name, module.name);
    }
}
