//! `manifest.json`: what every committed file comes from.

use serde::{Deserialize, Serialize};

/// All that was generated, and from what.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Manifest {
    /// The DXC.
    pub compiler: String,
    /// Its flags.
    pub flags: Vec<String>,
    /// The layout files.
    pub layouts: Vec<LayoutEntry>,
    /// The modules, by name.
    pub modules: Vec<ModuleEntry>,
    /// Every kernel × variant that was compiled; equal ones share a module.
    pub variants: Vec<VariantEntry>,
    /// SHA-256 of every other generated file, by path.
    pub files: std::collections::BTreeMap<String, String>,
}

/// A layout file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct LayoutEntry {
    /// Path below `shaders/hlsl`.
    pub source: String,
    /// Hash of its flattened text.
    pub hash: String,
}

/// A module.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct ModuleEntry {
    /// `CountCells+KEYWORD`.
    pub name: String,
    /// Path of its SPIR-V.
    pub spirv: String,
    /// Path of its source below `shaders/hlsl`.
    pub source: String,
    /// Name of the entry point.
    pub entry: String,
    /// Lowest tier that it fits.
    pub tier: String,
    /// Threads of a group.
    pub group_size: [u32; 3],
    /// Bytes of groupshared memory.
    pub shared_bytes: u32,
    /// Names of its bindings, by slot.
    pub bindings: Vec<String>,
    /// Bytes of its SPIR-V.
    pub bytes: u64,
}

/// A compiled kernel × variant.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct VariantEntry {
    /// Entry point and keywords.
    pub name: String,
    /// Path of its source below `shaders/hlsl`.
    pub source: String,
    /// DXC's target profile.
    pub profile: String,
    /// Defines.
    pub defines: Vec<String>,
    /// Hash of flattened source, defines, flags and compiler version.
    pub hash: String,
    /// The module that it became.
    pub module: String,
}
