//! The gate that needs no DXC: does what is committed still belong to the shaders as they are?

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use crate::dxc::PINNED_VERSION;
use crate::flags::FLAGS;
use crate::hash;
use crate::layouts;
use crate::manifest::Manifest;
use crate::output::shown;
use crate::places::Places;
use crate::problem::{Problem, Problems, io_problem};
use crate::program::{self, Tree};

/// Reads a manifest.
pub fn read_manifest(out: &Path) -> Result<Manifest, Problem> {
    let path = out.join("manifest.json");
    let text = std::fs::read_to_string(&path).map_err(|error| io_problem("read", &path, &error))?;
    serde_json::from_str(&text).map_err(|error| Problem::new(format!("{}: {error}", path.display())))
}

/// Everything in the crates' folders that does not belong to the shaders as they are, in words.
pub fn stale(places: &Places) -> Result<Vec<String>, Problems> {
    let tree = program::read_tree(&places.shaders)?;
    let mut stale = Vec::new();
    for (out, tree) in places.outs().into_iter().zip(places.divided(&tree)) {
        stale.extend(stale_in(out, &tree)?);
    }
    Ok(stale)
}

fn stale_in(out: &Path, tree: &Tree) -> Result<Vec<String>, Problem> {
    let manifest = read_manifest(out)?;
    let mut stale = Vec::new();
    if manifest.compiler != PINNED_VERSION {
        stale.push(format!(
            "{}: built with {}, not with the pinned {PINNED_VERSION}",
            out.display(),
            manifest.compiler
        ));
    }
    if manifest.flags != FLAGS {
        stale.push(format!("{}: built with other flags", out.display()));
    }
    let mut expected = BTreeMap::new();
    for program in &tree.programs {
        let source = &tree.sources[program.source];
        for combination in program.combinations() {
            for (stage, entry) in &program.entries {
                let defines = program.defines_of(*stage, &combination);
                let hash = hash::of_module(
                    PINNED_VERSION,
                    program.profile(*stage, &combination),
                    entry,
                    &defines,
                    &source.text,
                );
                expected.insert((source.file.clone(), program.label(entry, &combination)), hash);
            }
        }
    }
    for layout in &tree.layouts {
        expected.insert((layout.file.clone(), "(layout)".to_owned()), layouts::hash_of(PINNED_VERSION, layout));
    }
    let variants =
        manifest.variants.iter().map(|variant| ((variant.source.clone(), variant.name.clone()), variant.hash.clone()));
    let layouts =
        manifest.layouts.iter().map(|layout| ((layout.source.clone(), "(layout)".to_owned()), layout.hash.clone()));
    let committed: BTreeMap<(String, String), String> = variants.chain(layouts).collect();
    for ((source, name), hash) in &expected {
        match committed.get(&(source.clone(), name.clone())) {
            Some(there) if there == hash => {}
            Some(_) => stale.push(format!("{name} of {source}: the source, or what it includes, has changed")),
            None => stale.push(format!("{name} of {source} was never built")),
        }
    }
    for (source, name) in committed.keys() {
        if !expected.contains_key(&(source.clone(), name.clone())) {
            stale.push(format!("{name} of {source} is no longer in the shaders"));
        }
    }
    stale.extend(files(out, &manifest));
    Ok(stale)
}

/// Generated files that were edited, lost, or are not in the manifest.
fn files(out: &Path, manifest: &Manifest) -> Vec<String> {
    let mut stale = Vec::new();
    for (path, hash) in &manifest.files {
        match std::fs::read(out.join(path)) {
            Ok(bytes) if hash::of_bytes(&bytes) == *hash => {}
            Ok(_) => stale.push(format!("{} is not the file that was generated", shown(out, path))),
            Err(_) => stale.push(format!("{} is missing", shown(out, path))),
        }
    }
    for folder in ["src/generated", "spirv"] {
        let there: BTreeSet<String> = std::fs::read_dir(out.join(folder))
            .map(|entries| {
                let names = entries.flatten().map(|entry| entry.file_name().to_string_lossy().into_owned());
                names.collect()
            })
            .unwrap_or_default();
        for name in there {
            let path = format!("{folder}/{name}");
            if !manifest.files.contains_key(&path) {
                stale.push(format!("{} is not in the manifest", shown(out, &path)));
            }
        }
    }
    stale
}
