//! Brooklet's shader compiler: HLSL in Unity's ways to SPIR-V 1.0 for Vulkan 1.0, and to Rust.
//!
//! Every kernel × variant of a folder of shaders becomes one module with one entry point and dense
//! bindings, is validated, reflected and held against the device tiers, and gets a typed binding
//! struct. What is made is committed, so nobody needs a compiler to build or run; two gates keep it
//! honest: [`freshness::stale`], which needs no DXC, and [`check`], which compiles anew.

pub mod build;
mod cache;
pub mod compile;
pub mod dxc;
pub mod flags;
pub mod freshness;
pub mod generate;
pub mod hash;
pub mod layout;
pub mod layouts;
pub mod lint;
pub mod manifest;
pub mod model;
pub mod naming;
pub mod output;
mod places;
pub mod problem;
pub mod program;
pub mod recompile;
pub mod reflect;
pub mod relaxed;
pub mod source;
pub mod text;
pub mod tier;
pub mod validate;

pub use places::{Part, Places, target_below};
pub use recompile::{Recompiled, compile_below, compile_one};

use build::Built;
use compile::Compiler;
use dxc::Dxc;
use generate::Formatter;
use output::Output;
use problem::{Problem, Problems, io_problem};

/// What a build wrote.
pub struct Report {
    /// Paths that changed, from the name of their crate's folder on.
    pub changed: Vec<String>,
    /// Number of modules.
    pub modules: usize,
    /// Number of compiled kernels × variants.
    pub variants: usize,
    /// Bytes of all modules.
    pub bytes: u64,
}

/// Compiles everything and writes what changed; if anything is wrong, nothing is written.
pub fn build(places: &Places) -> Result<Report, Problems> {
    let _lock = output::lock(&places.target)?;
    let built = built(places, true, false)?;
    let changed = output::replace(&outputs(places, &built))?;
    let modules = || built.iter().flat_map(|built| &built.manifest.modules);
    Ok(Report {
        changed,
        modules: modules().count(),
        variants: built.iter().map(|built| built.manifest.variants.len()).sum(),
        bytes: modules().map(|module| module.bytes).sum(),
    })
}

/// Compiles everything and checks it against the tiers; writes nothing. Gives the
/// manifest of each crate.
pub fn lint(places: &Places) -> Result<Vec<manifest::Manifest>, Problems> {
    let _lock = output::lock(&places.target)?;
    Ok(built(places, true, false)?.into_iter().map(|built| built.manifest).collect())
}

/// Compiles everything anew with the pinned DXC and gives every generated file that differs.
pub fn check(places: &Places) -> Result<Vec<String>, Problems> {
    let _lock = output::lock(&places.target)?;
    let built = built(places, false, true)?;
    Ok(outputs(places, &built).iter().flat_map(output::differences).collect())
}

/// Where each of what was built belongs.
fn outputs<'a>(places: &'a Places, built: &'a [Built]) -> Vec<Output<'a>> {
    places.outs().into_iter().zip(built).map(|(folder, built)| Output { folder, files: &built.files }).collect()
}

/// What each crate gets, in the order of [`Places::outs`].
fn built(places: &Places, cached: bool, pinned: bool) -> Result<Vec<Built>, Problems> {
    let tree = program::read_tree(&places.shaders).map_err(|problems| problems.below(&places.shaders))?;
    let compiler = compiler(places, cached, pinned)?;
    std::fs::create_dir_all(&places.out).map_err(|error| io_problem("create", &places.out, &error))?;
    let folder = std::path::absolute(&places.out).map_err(|error| io_problem("find", &places.out, &error))?;
    let formatter = Formatter { folder, cache: compiler.cache.clone() };
    if !validate::is_available() {
        eprintln!("warning: spirv-val is not installed, so no module is validated (Debian: spirv-tools)");
    }
    build::build(&compiler, &formatter, &places.divided(&tree)).map_err(|problems| problems.below(&places.shaders))
}

/// DXC with its folders; `pinned` takes no other than the pinned one.
fn compiler(places: &Places, cached: bool, pinned: bool) -> Result<Compiler, Problem> {
    let dxc = Dxc::find(&places.target)?;
    if pinned && !dxc.is_pinned() {
        return Err(Problem::new(format!(
            "bytes are compared with {} only, not with {}",
            dxc::PINNED_VERSION,
            dxc.version()
        ))
        .way_out("unset BROOKLET_DXC: the pinned DXC is then fetched"));
    }
    let folder = |name: &str| {
        let path = places.target.join("shaders").join(name);
        std::fs::create_dir_all(&path).map_err(|error| io_problem("create", &path, &error))?;
        Ok::<_, Problem>(path)
    };
    let cache = if cached { Some(folder("cache")?) } else { None };
    Ok(Compiler { dxc, cache, scratch: folder("scratch")? })
}
