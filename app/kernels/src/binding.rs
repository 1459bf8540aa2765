//! Puts named resources at the slots of a module.

use crate::module::{BindingError, BindingInfo, BindingKind, Bound, Module};
use crate::resource::ResourceId;

/// A binding's name in HLSL, and what was given for it.
pub type Given = (&'static str, Option<ResourceId>);

/// What is bound at each slot of a compute module.
pub fn bind(module: &'static Module, given: &[Given]) -> Result<Vec<Bound>, BindingError> {
    module.bindings.iter().map(|info| bound(module, info, given)).collect()
}

/// What is bound at each slot of the union of a draw's stages.
pub fn bind_draw(
    vertex: &'static Module,
    fragment: Option<&'static Module>,
    given: &[Given],
) -> Result<Vec<Bound>, BindingError> {
    let mut all: Vec<Bound> = Vec::new();
    for module in std::iter::once(vertex).chain(fragment) {
        for info in module.bindings {
            if all.iter().all(|known| known.info.slot != info.slot) {
                all.push(bound(module, info, given)?);
            }
        }
    }
    all.sort_by_key(|bound| bound.info.slot);
    Ok(all)
}

fn bound(module: &'static Module, info: &BindingInfo, given: &[Given]) -> Result<Bound, BindingError> {
    let resource = given.iter().find(|(name, _)| *name == info.name).and_then(|(_, resource)| *resource);
    if resource.is_none() && info.kind != BindingKind::Sampler {
        return Err(BindingError { module: module.name, field: info.name });
    }
    Ok(Bound { info: *info, resource })
}
