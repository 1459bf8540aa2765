//! From a folder of shaders to the files of the crates that hold its kernels, in memory.

use std::collections::BTreeMap;

use crate::compile::Compiler;
use crate::flags::FLAGS;
use crate::generate::{self, Formatter};
use crate::hash;
use crate::layouts::{self, LayoutFile};
use crate::lint;
use crate::manifest::{LayoutEntry, Manifest, ModuleEntry, VariantEntry};
use crate::model::{self, Known, Model, ModuleModel, VariantRecord};
use crate::problem::{Problem, Problems};
use crate::program::Tree;
use crate::text::Text;

/// A repository may hold so many modules...
pub const MAX_MODULES: usize = 460;
/// ...and so many bytes of SPIR-V.
pub const MAX_BYTES: u64 = 5 << 20;

/// Every generated file of a crate by its path below the crate's folder.
pub type Files = BTreeMap<String, Vec<u8>>;

/// What a build made of a crate.
pub struct Built {
    /// The files.
    pub files: Files,
    /// The manifest among them.
    pub manifest: Manifest,
}

/// Compiles, checks and generates; nothing is written. The first of `trees` is what the others build on.
pub fn build(compiler: &Compiler, formatter: &Formatter, trees: &[Tree]) -> Result<Vec<Built>, Problems> {
    let mut problems = Vec::new();
    let mut take = |found: Problems| problems.extend(found.0);
    let mut compiled = Vec::new();
    for tree in trees {
        let layouts = layouts::read_layouts(compiler, tree).map_err(&mut take);
        let combinations = compiler.compile_tree(tree).map_err(&mut take);
        compiled.extend(layouts.ok().zip(combinations.ok()));
    }
    if !problems.is_empty() {
        return Err(Problems(problems).merged());
    }
    for (tree, (_, combinations)) in trees.iter().zip(&compiled) {
        for (program, combinations) in tree.programs.iter().zip(combinations) {
            let text = Text::new(&tree.sources[program.source].text);
            problems.extend(lint::lint(program, combinations, &text));
        }
    }
    if !problems.is_empty() {
        return Err(Problems(problems).merged());
    }
    let mut models: Vec<(Model, Vec<VariantRecord>)> = Vec::new();
    for (tree, (layouts, combinations)) in trees.iter().zip(&compiled) {
        let known = models.first().map(|(model, _)| Known::of(model));
        models.push(model::model(tree, layouts, combinations, known)?);
    }
    over_budget(models.iter().flat_map(|(model, _)| &model.modules))?;
    models
        .iter()
        .zip(&compiled)
        .map(|((model, records), (layouts, _))| files_of(compiler, formatter, model, layouts, records))
        .collect()
}

/// The files of one crate.
fn files_of(
    compiler: &Compiler,
    formatter: &Formatter,
    model: &Model,
    layouts: &[LayoutFile],
    records: &[VariantRecord],
) -> Result<Built, Problems> {
    let mut files = Files::new();
    for (name, text) in generate::rust_files(model, formatter)? {
        files.insert(format!("src/generated/{name}"), text.into_bytes());
    }
    for module in &model.modules {
        files.insert(format!("spirv/{}", module.file), module.stage.spirv.clone());
    }
    if model.known.is_none() {
        files.insert("spirv/packs.txt".to_owned(), generate::packs(model).into_bytes());
    }
    let manifest = manifest_of(compiler.dxc.version(), model, layouts, records, &files);
    let mut text =
        serde_json::to_string_pretty(&manifest).map_err(|error| Problem::new(format!("manifest.json: {error}")))?;
    text.push('\n');
    files.insert("manifest.json".to_owned(), text.into_bytes());
    Ok(Built { files, manifest })
}

fn over_budget<'a>(modules: impl Iterator<Item = &'a ModuleModel>) -> Result<(), Problem> {
    let sizes: Vec<u64> = modules.map(|module| module.stage.spirv.len() as u64).collect();
    let (count, bytes) = (sizes.len(), sizes.iter().sum::<u64>());
    if count <= MAX_MODULES && bytes <= MAX_BYTES {
        return Ok(());
    }
    Err(Problem::new(format!(
        "{count} modules of {bytes} bytes together; at most {MAX_MODULES} modules and {MAX_BYTES} bytes are committed"
    ))
    .way_out("drop keywords, or split files so that each kernel has only the keywords that it uses"))
}

fn manifest_of(
    compiler: &str,
    model: &Model,
    layouts: &[LayoutFile],
    records: &[VariantRecord],
    files: &Files,
) -> Manifest {
    let mut manifest =
        Manifest { compiler: compiler.to_owned(), flags: FLAGS.map(str::to_owned).to_vec(), ..Manifest::default() };
    for layout in layouts {
        manifest.layouts.push(LayoutEntry { source: layout.file.clone(), hash: layout.hash.clone() });
    }
    for module in &model.modules {
        let reflection = &module.stage.reflection;
        manifest.modules.push(ModuleEntry {
            name: module.name.clone(),
            spirv: format!("spirv/{}", module.file),
            source: module.source.clone(),
            entry: module.stage.entry.clone(),
            tier: module.tier.name().to_owned(),
            group_size: reflection.group_size,
            shared_bytes: reflection.shared_bytes,
            bindings: reflection.bindings.iter().map(|binding| binding.name.clone()).collect(),
            bytes: module.stage.spirv.len() as u64,
        });
    }
    for record in records {
        manifest.variants.push(VariantEntry {
            name: record.stage.label.clone(),
            source: record.source.clone(),
            profile: record.stage.profile.to_owned(),
            defines: record.stage.defines.clone(),
            hash: record.stage.hash.clone(),
            module: record.module.clone(),
        });
    }
    for (path, bytes) in files {
        manifest.files.insert(path.clone(), hash::of_bytes(bytes));
    }
    manifest
}
