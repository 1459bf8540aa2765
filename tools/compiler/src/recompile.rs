//! Single files compiled anew while a program runs their kernels: for hot reload. Nothing is written.

use std::path::Path;

use crate::compile::{CompiledCombination, CompiledStage, in_parallel, parsed};
use crate::freshness::read_manifest;
use crate::manifest::{Manifest, VariantEntry};
use crate::problem::{Problem, Problems, io_problem};
use crate::program::{Program, Tree};
use crate::reflect::{self, Binding};
use crate::source::Source;
use crate::text::Text;
use crate::tier::Tier;
use crate::{Places, compiler, layouts, lint, output, program};

/// A module compiled anew, which binds exactly what the committed one of its name binds.
#[derive(Clone, Debug)]
pub struct Recompiled {
    /// The module's name: `CountCells+KEYWORD`, `DrawFloor.vertex+KEYWORD`.
    pub name: String,
    /// The new SPIR-V, validated.
    pub spirv: Vec<u8>,
    /// Threads of a group; ones for graphics stages.
    pub group_size: [u32; 3],
    /// Bytes of groupshared memory.
    pub shared_bytes: u32,
    /// The lowest tier whose limits it keeps.
    pub tier: Tier,
}

/// [`compile_one`] with the product's own places: `shaders_root` is `shaders/hlsl` of a checkout.
///
/// # Errors
/// As [`compile_one`].
pub fn compile_below(shaders_root: &Path, path: &Path) -> Result<Vec<Recompiled>, Problems> {
    let root = shaders_root.parent().and_then(Path::parent).unwrap_or(Path::new("."));
    compile_one(&Places { shaders: shaders_root.to_owned(), ..Places::below(root) }, path)
}

/// Compiles every kernel of the file at `path` or, where it is an include, of all files that include it;
/// `path` may lead there from anywhere, or be one below the shader folder. A file without kernels that
/// nobody includes gives nothing, and nothing comes of the kernels of [`Places::parts`]: no program that
/// reloads runs one. About 20 ms a variant, on all cores.
///
/// # Errors
/// What DXC, the validator or the tiers have against a kernel, naming file and line; and what only a whole
/// build changes: other bindings, other host-visible structs, a new kernel, a keyword that now matters.
pub fn compile_one(places: &Places, path: &Path) -> Result<Vec<Recompiled>, Problems> {
    let _lock = output::lock(&places.target)?;
    let path = below(&places.shaders, path);
    let tree = program::read_tree(&places.shaders).map_err(|problems| problems.below(&places.shaders))?;
    let tree = places.divided(&tree).swap_remove(0);
    let concerned = |program: &Program| tree.sources[program.source].files.contains(&path);
    let tree = Tree { programs: tree.programs.iter().filter(|program| concerned(program)).cloned().collect(), ..tree };
    if tree.programs.is_empty() {
        return Ok(Vec::new());
    }
    let manifest = read_manifest(&places.out)?;
    let compiler = compiler(places, true, false)?;
    if let Some(layout) = changed_layout(&manifest, compiler.dxc.version(), &tree) {
        return Err(Problems::from(
            Problem::new("the host has these structs and numbers too").at(layout, 1).way_out(WHOLE_BUILD),
        )
        .below(&places.shaders));
    }
    let compiled = compiler.compile_tree(&tree).map_err(|all| all.below(&places.shaders))?;
    let mut problems = Vec::new();
    for (program, combinations) in tree.programs.iter().zip(&compiled) {
        let text = Text::new(&tree.sources[program.source].text);
        problems.extend(lint::lint(program, combinations, &text));
    }
    let stages: Vec<(&Program, &CompiledStage)> =
        tree.programs.iter().zip(&compiled).flat_map(|(program, all)| stages_of(program, all)).collect();
    let checked = in_parallel(&stages, |(program, stage)| recompiled(places, &manifest, &tree, program, stage));
    let mut modules: Vec<Recompiled> = Vec::new();
    for ((program, stage), result) in stages.iter().zip(checked) {
        match result {
            Ok(new) => match modules.iter().find(|known| known.name == new.name) {
                Some(known) if known.spirv != new.spirv => problems.push(whole_build(
                    program,
                    stage,
                    format!("its keywords now make a difference, and {} stands for several choices of them", new.name),
                )),
                Some(_) => {}
                None => modules.push(new),
            },
            Err(problem) => problems.push(problem),
        }
    }
    if problems.is_empty() { Ok(modules) } else { Err(Problems(problems).merged().below(&places.shaders)) }
}

fn stages_of<'a>(
    program: &'a Program,
    combinations: &'a [CompiledCombination],
) -> impl Iterator<Item = (&'a Program, &'a CompiledStage)> {
    combinations.iter().flat_map(|combination| &combination.stages).map(move |stage| (program, stage))
}

fn recompiled(
    places: &Places,
    manifest: &Manifest,
    tree: &Tree,
    program: &Program,
    stage: &CompiledStage,
) -> Result<Recompiled, Problem> {
    let source = &tree.sources[program.source].file;
    let is_same = |entry: &&VariantEntry| {
        entry.source == *source
            && entry.name == stage.label
            && entry.profile == stage.profile
            && entry.defines == stage.defines
    };
    let known = manifest.variants.iter().find(is_same);
    let known = known.and_then(|entry| manifest.modules.iter().find(|module| module.name == entry.module));
    let Some(known) = known else {
        return Err(whole_build(program, stage, "the running program has no such kernel or variant".to_owned()));
    };
    let committed = places.out.join(&known.spirv);
    let bytes = std::fs::read(&committed).map_err(|error| io_problem("read", &committed, &error))?;
    let before = reflect::reflect(&parsed(&bytes, &stage.label)?);
    let now = &stage.reflection;
    if let Some(difference) = difference(&before.bindings, &now.bindings) {
        return Err(whole_build(program, stage, difference));
    }
    if before.group_size != now.group_size {
        return Err(whole_build(
            program,
            stage,
            format!("its group has {:?} threads, not {:?}", now.group_size, before.group_size),
        ));
    }
    Ok(Recompiled {
        name: known.name.clone(),
        spirv: stage.spirv.clone(),
        group_size: now.group_size,
        shared_bytes: now.shared_bytes,
        tier: Tier::of(now).unwrap_or(Tier::Desktop),
    })
}

/// What the host could not know of a module with other bindings.
fn difference(before: &[Binding], now: &[Binding]) -> Option<String> {
    let missing = |from: &[Binding], name: &str| !from.iter().any(|binding| binding.name == name);
    if let Some(gone) = before.iter().find(|binding| missing(now, &binding.name)) {
        return Some(format!("it no longer uses {}", gone.name));
    }
    if let Some(new) = now.iter().find(|binding| missing(before, &binding.name)) {
        return Some(format!("it now uses {}", new.name));
    }
    let other = before.iter().zip(now).find(|(before, now)| before != now);
    other.map(|(_, now)| format!("{} is bound or laid out differently", now.name))
}

fn whole_build(program: &Program, stage: &CompiledStage, message: String) -> Problem {
    Problem::new(message).at_place(Some(program.place.clone())).kernel(stage.label.clone()).way_out(WHOLE_BUILD)
}

const WHOLE_BUILD: &str = "build the kernels and the program again: this cannot change while it runs";

/// The first layout file that is not the one that the host's structs were made from.
fn changed_layout(manifest: &Manifest, compiler: &str, tree: &Tree) -> Option<String> {
    // Another compiler's hashes say nothing.
    let same = |source: &Source| {
        let known = manifest.layouts.iter().find(|layout| layout.source == source.file);
        known.is_some_and(|layout| layout.hash == layouts::hash_of(compiler, source))
    };
    let changed = tree.layouts.iter().find(|source| !same(source));
    changed.filter(|_| manifest.compiler == compiler).map(|source| source.file.clone())
}

/// The path below the shader folder, with forward slashes, as sources name their files.
fn below(folder: &Path, path: &Path) -> String {
    let whole = |path: &Path| path.canonicalize().ok();
    let relative = whole(path)
        .zip(whole(folder))
        .and_then(|(path, folder)| path.strip_prefix(&folder).ok().map(Path::to_owned))
        .unwrap_or_else(|| path.to_owned());
    let parts: Vec<_> = relative.components().map(|part| part.as_os_str().to_string_lossy().into_owned()).collect();
    parts.join("/")
}
