//! Where a build reads and writes.

use std::path::{Path, PathBuf};

use crate::problem::Problem;
use crate::program::Tree;

/// Where a build reads and writes.
#[derive(Clone, Debug)]
pub struct Places {
    /// The folder of shaders.
    pub shaders: PathBuf,
    /// The crate that gets the kernels, structs and keywords: its folder gets `src/generated`, `spirv` and
    /// `manifest.json`.
    pub out: PathBuf,
    /// Crates that get the kernels of a folder instead.
    pub parts: Vec<Part>,
    /// Cargo's target folder: DXC and the caches are kept there.
    pub target: PathBuf,
}

/// A folder of shaders whose kernels a crate of its own gets, which builds on that of the others.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// The folder, below the folder of shaders.
    pub shaders: String,
    /// The crate's folder, which gets what [`Places::out`] gets.
    pub out: PathBuf,
}

impl Part {
    /// Whether the file at `path` below the folder of shaders is one of its own.
    pub fn holds(&self, path: &str) -> bool {
        path.strip_prefix(&self.shaders).is_some_and(|rest| rest.starts_with('/'))
    }
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

    /// The product's own, below the repository's root: what only benchmarks run is not shipped.
    pub fn below(root: &Path) -> Self {
        Self {
            shaders: root.join("shaders/hlsl"),
            out: root.join("app/kernels"),
            parts: vec![Part { shaders: "bench".to_owned(), out: root.join("app/bench") }],
            target: target_below(root),
        }
    }

    /// The crates' folders: [`Places::out`], then those of the parts.
    pub fn outs(&self) -> Vec<&Path> {
        std::iter::once(&self.out).chain(self.parts.iter().map(|part| &part.out)).map(PathBuf::as_path).collect()
    }

    /// The programs and layouts of each crate, in the order of [`Places::outs`]; sources are not divided.
    pub fn divided(&self, tree: &Tree) -> Vec<Tree> {
        let owner = |file: &str| self.parts.iter().position(|part| part.holds(file)).map_or(0, |part| part + 1);
        let of = |crate_index: usize| Tree {
            sources: tree.sources.clone(),
            programs: tree
                .programs
                .iter()
                .filter(|program| owner(&tree.sources[program.source].file) == crate_index)
                .cloned()
                .collect(),
            layouts: tree.layouts.iter().filter(|layout| owner(&layout.file) == crate_index).cloned().collect(),
        };
        (0..=self.parts.len()).map(of).collect()
    }
}

/// Cargo's target folder of the repository at `root`.
pub fn target_below(root: &Path) -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), PathBuf::from)
}
