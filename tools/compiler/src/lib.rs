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
pub mod problem;
pub mod program;
pub mod recompile;
pub mod reflect;
pub mod source;
pub mod text;
pub mod tier;
pub mod validate;

pub use recompile::{Recompiled, compile_below, compile_one};

use std::path::{Path, PathBuf};

use build::Built;
use compile::Compiler;
use dxc::Dxc;
use generate::Formatter;
use problem::{Problem, Problems, io_problem};

/// Where a build reads and writes.
#[derive(Clone, Debug)]
pub struct Places {
    /// The folder of shaders.
    pub shaders: PathBuf,
    /// The folder that gets `src/generated`, `spirv` and `manifest.json`.
    pub out: PathBuf,
    /// Cargo's target folder: DXC and the caches are kept there.
    pub target: PathBuf,
}

impl Places {
    /// The product's own, from the repository that holds the current folder.
    pub fn of_repository() -> Result<Self, Problem> {
        let here = std::env::current_dir().map_err(|error| Problem::new(format!("no current folder: {error}")))?;
        let root = here
            .ancestors()
            .find(|folder| folder.join("shaders/hlsl").is_dir() && folder.join("app/kernels").is_dir())
            .ok_or_else(|| {
                Problem::new(format!("no folder above {} holds shaders/hlsl and app/kernels", here.display()))
                    .way_out("run it inside the repository, or name --shaders and --out")
            })?;
        Ok(Self::below(root))
    }

    /// The product's own, below the repository's root.
    pub fn below(root: &Path) -> Self {
        Self { shaders: root.join("shaders/hlsl"), out: root.join("app/kernels"), target: target_below(root) }
    }
}

/// Cargo's target folder of the repository at `root`.
pub fn target_below(root: &Path) -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), PathBuf::from)
}

/// What a build wrote.
pub struct Report {
    /// Paths that changed, below the output folder.
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
    let changed = output::replace(&places.out, &built.files)?;
    Ok(Report {
        changed,
        modules: built.manifest.modules.len(),
        variants: built.manifest.variants.len(),
        bytes: built.manifest.modules.iter().map(|module| module.bytes).sum(),
    })
}

/// Compiles everything and checks it against the tiers; writes nothing. Gives the manifest.
pub fn lint(places: &Places) -> Result<manifest::Manifest, Problems> {
    let _lock = output::lock(&places.target)?;
    built(places, true, false).map(|built| built.manifest)
}

/// Compiles everything anew with the pinned DXC and gives every generated file that differs.
pub fn check(places: &Places) -> Result<Vec<String>, Problems> {
    let _lock = output::lock(&places.target)?;
    let built = built(places, false, true)?;
    Ok(output::differences(&places.out, &built.files))
}

fn built(places: &Places, cached: bool, pinned: bool) -> Result<Built, Problems> {
    let tree = program::read_tree(&places.shaders).map_err(|problems| problems.below(&places.shaders))?;
    let compiler = compiler(places, cached, pinned)?;
    std::fs::create_dir_all(&places.out).map_err(|error| io_problem("create", &places.out, &error))?;
    let folder = std::path::absolute(&places.out).map_err(|error| io_problem("find", &places.out, &error))?;
    let formatter = Formatter { folder, cache: compiler.cache.clone() };
    if !validate::is_available() {
        eprintln!("warning: spirv-val is not installed, so no module is validated (Debian: spirv-tools)");
    }
    build::build(&compiler, &formatter, &tree).map_err(|problems| problems.below(&places.shaders))
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
