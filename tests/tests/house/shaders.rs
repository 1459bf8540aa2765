//! What is committed of the shaders: fresh, valid, dense, within budget, and all of it.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use brooklet_bench::kernels as bench_kernels;
use brooklet_compiler::build::{MAX_BYTES, MAX_MODULES};
use brooklet_compiler::compile::parsed;
use brooklet_compiler::freshness::{read_manifest, stale};
use brooklet_compiler::reflect::reflect;
use brooklet_compiler::{Places, validate};
use brooklet_kernels::{BindingInfo, Module, StageKind};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Every module that is committed: the product's and those that only benchmarks run.
fn modules() -> impl Iterator<Item = &'static Module> {
    brooklet_kernels::modules().chain(bench_kernels::modules())
}

fn copy_folder(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).unwrap();
    for entry in std::fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        let target = to.join(entry.file_name());
        if entry.path().is_dir() {
            copy_folder(&entry.path(), &target);
        } else {
            std::fs::copy(entry.path(), target).unwrap();
        }
    }
}

/// A copy of the shaders and of what was made of them, to spoil.
fn copy_of_product() -> (tempfile::TempDir, Places) {
    let folder = tempfile::tempdir().unwrap();
    copy_folder(&root().join("shaders/hlsl"), &folder.path().join("shaders/hlsl"));
    for folder_of_crate in ["app/kernels", "app/bench"] {
        copy_folder(&root().join(folder_of_crate), &folder.path().join(folder_of_crate));
    }
    // Generated Rust is formatted with the repository's settings.
    std::fs::copy(root().join(".rustfmt.toml"), folder.path().join(".rustfmt.toml")).unwrap();
    let places = Places::below(folder.path());
    (folder, places)
}

fn append(path: &Path, text: &str) {
    let mut whole = std::fs::read_to_string(path).unwrap();
    whole.push_str(text);
    std::fs::write(path, whole).unwrap();
}

#[test]
fn what_is_committed_belongs_to_the_shaders() {
    let places = Places::below(&root());
    let stale = stale(&places).unwrap();
    assert!(stale.is_empty(), "run `cargo run -p brooklet-compiler -- build`:\n{}", stale.join("\n"));
}

#[test]
fn an_edited_include_is_noticed() {
    let (_folder, places) = copy_of_product();
    assert_eq!(stale(&places).unwrap(), Vec::<String>::new());
    append(&places.shaders.join("shared/wendland.hlsli"), "// one comment more\n");
    let found = stale(&places).unwrap();
    for kernel in ["ConstrainDensity of", "ConstrainDensityByIndex of"] {
        assert!(found.iter().any(|line| line.contains(kernel)), "no {kernel} in {found:?}");
    }
    assert!(!found.iter().any(|line| line.contains("ReduceGroups")), "{found:?}");
}

#[test]
fn edited_lost_and_stray_files_are_noticed() {
    let (_folder, places) = copy_of_product();
    append(&places.shaders.join("shared/layout.hlsli"), "struct Another { uint word; };\n");
    append(&places.shaders.join("grid/scan.compute"), "#pragma kernel Another\n");
    append(&places.out.join("src/generated/shared_layout.rs"), "// by hand\n");
    std::fs::remove_file(places.out.join("spirv/reduce_groups.spv")).unwrap();
    std::fs::write(places.out.join("spirv/stray.spv"), [0; 4]).unwrap();
    let bench = &places.parts[0].out;
    append(&places.shaders.join("bench/copy.compute"), "#pragma kernel Further\n");
    append(&bench.join("src/generated/bench_copy.rs"), "// by hand\n");
    std::fs::remove_file(bench.join("spirv/scan_step.spv")).unwrap();
    std::fs::write(bench.join("spirv/reduce_groups.spv"), [0; 4]).unwrap();
    let found = stale(&places).unwrap();
    for expected in [
        "(layout) of shared/layout.hlsli: the source",
        "Another of grid/scan.compute was never built",
        "kernels/src/generated/shared_layout.rs is not the file",
        "kernels/spirv/reduce_groups.spv is missing",
        "kernels/spirv/stray.spv is not in the manifest",
        "Further of bench/copy.compute was never built",
        "bench/src/generated/bench_copy.rs is not the file",
        "bench/spirv/scan_step.spv is missing",
        "bench/spirv/reduce_groups.spv is not in the manifest",
    ] {
        assert!(found.iter().any(|line| line.contains(expected)), "no {expected:?} in {found:#?}");
    }
}

/// The second gate: the pinned DXC, fetched on demand, gives every committed byte anew.
#[test]
fn the_pinned_compiler_gives_the_committed_bytes() {
    let differences = brooklet_compiler::check(&Places::below(&root())).unwrap_or_else(|problems| panic!("{problems}"));
    assert!(differences.is_empty(), "{}", differences.join("\n"));
}

/// Of a product of the two files whose kernels are spoiled, for all of it takes as long again.
#[test]
fn a_recompilation_notices_one_wrong_byte() {
    let (_folder, mut places) = copy_of_product();
    places.target = Places::below(&root()).target;
    keep_kernels(&places.shaders, &["scan", "scan_step"]);
    brooklet_compiler::build(&places).unwrap_or_else(|problems| panic!("{problems}"));
    let differences = || brooklet_compiler::check(&places).unwrap_or_else(|problems| panic!("{problems}"));
    assert_eq!(differences(), Vec::<String>::new());
    for spirv in [places.out.join("spirv/reduce_groups.spv"), places.parts[0].out.join("spirv/scan_step.spv")] {
        let mut bytes = std::fs::read(&spirv).unwrap();
        *bytes.last_mut().unwrap() ^= 1;
        std::fs::write(&spirv, bytes).unwrap();
    }
    assert_eq!(differences(), ["kernels/spirv/reduce_groups.spv is stale", "bench/spirv/scan_step.spv is stale"]);
}

/// Removes the sources of all other kernels.
fn keep_kernels(folder: &Path, names: &[&str]) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            keep_kernels(&path, names);
        } else if path.extension().is_some_and(|ending| ending != "hlsli")
            && !names.iter().any(|name| path.file_stem().is_some_and(|stem| stem == *name))
        {
            std::fs::remove_file(path).unwrap();
        }
    }
}

#[test]
fn each_crate_holds_every_module_of_its_manifest_and_no_other() {
    let of_kernels: Vec<_> = brooklet_kernels::modules().collect();
    let of_bench: Vec<_> = bench_kernels::modules().collect();
    for (folder, modules) in [("app/kernels", of_kernels), ("app/bench", of_bench)] {
        let manifest = read_manifest(&root().join(folder)).unwrap();
        let listed: BTreeSet<&str> = manifest.modules.iter().map(|module| module.name.as_str()).collect();
        let built: BTreeSet<&str> = modules.iter().map(|module| module.name).collect();
        assert_eq!(listed, built);
        assert_eq!(manifest.modules.len(), listed.len(), "a name stands twice");
        for module in &manifest.modules {
            let crate_module = modules.iter().find(|known| known.name == module.name).unwrap();
            let file = std::fs::read(root().join(folder).join(&module.spirv)).unwrap();
            assert_eq!(file, *crate_module.spirv.bytes(), "{}", module.name);
            // What only benchmarks run is not shipped, and nothing else is theirs.
            assert_eq!(module.source.starts_with("bench/"), folder == "app/bench", "{}", module.name);
        }
        for variant in &manifest.variants {
            assert!(listed.contains(variant.module.as_str()), "{}", variant.name);
        }
    }
}

#[test]
fn modules_keep_the_budget() {
    let bytes: usize = modules().map(|module| module.spirv.len()).sum();
    assert!(modules().count() > 0);
    assert!(modules().count() <= MAX_MODULES);
    assert!(bytes as u64 <= MAX_BYTES, "{bytes} bytes");
}

/// Slots 0..n without gaps, each once: wgpu numbers a layout so and does not remap these modules.
fn are_dense(mut slots: Vec<u32>) -> bool {
    slots.sort_unstable();
    slots.iter().copied().eq(0..slots.len() as u32)
}

#[test]
fn gaps_and_doubles_are_not_dense() {
    assert!(are_dense(vec![]));
    assert!(are_dense(vec![1, 0, 2]));
    assert!(!are_dense(vec![0, 2]));
    assert!(!are_dense(vec![1]));
    assert!(!are_dense(vec![0, 0, 1]));
}

#[test]
fn bindings_are_dense_and_as_the_module_says() {
    for module in modules() {
        let reflected = reflect(&parsed(&module.spirv.bytes(), module.name).unwrap());
        let of_spirv: Vec<(String, u32)> =
            reflected.bindings.iter().map(|binding| (binding.name.clone(), binding.slot)).collect();
        let of_crate: Vec<(String, u32)> =
            module.bindings.iter().map(|info| (info.name.to_owned(), info.slot)).collect();
        assert_eq!(of_spirv, of_crate, "{}", module.name);
        assert_eq!(reflected.group_size, module.group_size, "{}", module.name);
        let union: Vec<u32> = match module.stage {
            StageKind::Compute => module.bindings.iter().map(|info| info.slot).collect(),
            _ => union_with_partners(module),
        };
        assert!(are_dense(union.clone()), "{}: {union:?}", module.name);
    }
}

/// A draw's slots are dense over both stages together; a vertex module with several fragment
/// modules (or the reverse) is numbered alike for each, so the union over all is dense too.
fn union_with_partners(module: &Module) -> Vec<u32> {
    let draw = |module: &Module| module.name.replace(".vertex", "").replace(".fragment", "");
    let partners: Vec<&Module> = modules().filter(|other| draw(other) == draw(module)).collect();
    let infos: Vec<&BindingInfo> = partners.iter().flat_map(|partner| partner.bindings).collect();
    let slots: BTreeSet<u32> = infos.iter().map(|info| info.slot).collect();
    slots.into_iter().collect()
}

#[test]
fn spirv_val_passes_every_module() {
    if !validate::is_available() {
        eprintln!("SKIPPED: spirv-val is not installed (Debian: spirv-tools)");
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("module.spv");
    for module in modules() {
        let spirv = module.spirv.bytes();
        assert_eq!(spirv[4..8], [0, 0, 1, 0], "{} is not SPIR-V 1.0", module.name);
        std::fs::write(&file, spirv).unwrap();
        validate::validate_file(&file).unwrap_or_else(|said| panic!("{}: {said}", module.name));
    }
    // And it does refuse: the same module without its last instruction.
    let module = modules().next().unwrap();
    std::fs::write(&file, &module.spirv.bytes()[..module.spirv.len() - 4]).unwrap();
    assert!(validate::validate_file(&file).is_err());
}
