//! Compiles every kernel × variant, in parallel, and numbers the bindings densely.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use rspirv::binary::Assemble;
use rspirv::dr;

use crate::cache::keep;
use crate::dxc::{Compiled, Dxc, Job};
use crate::hash;
use crate::problem::{Problem, Problems};
use crate::program::{Program, Stage, Tree};
use crate::reflect::{self, Reflection};
use crate::relaxed;
use crate::validate;

/// One entry point of one combination, compiled, numbered and reflected.
#[derive(Clone, Debug)]
pub struct CompiledStage {
    /// The stage.
    pub stage: Stage,
    /// Name of the entry point.
    pub entry: String,
    /// Entry point and keywords: `Name+KEYWORD`.
    pub label: String,
    /// DXC's target profile.
    pub profile: &'static str,
    /// All defines.
    pub defines: Vec<String>,
    /// Hash of all it comes from.
    pub hash: String,
    /// Final SPIR-V.
    pub spirv: Vec<u8>,
    /// What it says of itself.
    pub reflection: Reflection,
}

/// One combination of a program's keywords, compiled: its stages in order.
#[derive(Clone, Debug)]
pub struct CompiledCombination {
    /// One entry an axis.
    pub combination: Vec<usize>,
    /// One stage of a kernel; vertex, then fragment of a draw.
    pub stages: Vec<CompiledStage>,
}

/// How a build compiles.
pub struct Compiler {
    /// The DXC.
    pub dxc: Dxc,
    /// Folder of what was compiled before, by hash; `None` compiles everything anew.
    pub cache: Option<PathBuf>,
    /// Folder for DXC's input and output.
    pub scratch: PathBuf,
}

impl Compiler {
    /// Compiles every combination of every program; the outer list is by program.
    pub fn compile_tree(&self, tree: &Tree) -> Result<Vec<Vec<CompiledCombination>>, Problems> {
        let jobs: Vec<(usize, Vec<usize>)> = tree
            .programs
            .iter()
            .enumerate()
            .flat_map(|(index, program)| {
                program.combinations().into_iter().map(move |combination| (index, combination))
            })
            .collect();
        let results = in_parallel(&jobs, |(index, combination)| {
            let program = &tree.programs[*index];
            self.compile_combination(tree, program, combination)
        });
        let mut compiled = vec![Vec::new(); tree.programs.len()];
        let mut problems = Vec::new();
        for ((index, _), result) in jobs.iter().zip(results) {
            match result {
                Ok(combination) => compiled[*index].push(combination),
                Err(found) => problems.extend(found.0),
            }
        }
        if problems.is_empty() { Ok(compiled) } else { Err(Problems(problems).merged()) }
    }

    fn compile_combination(
        &self,
        tree: &Tree,
        program: &Program,
        combination: &[usize],
    ) -> Result<CompiledCombination, Problems> {
        let source = &tree.sources[program.source];
        let mut modules = Vec::new();
        for (stage, entry) in &program.entries {
            let defines = program.defines_of(*stage, combination);
            let job = Job {
                source,
                entry,
                profile: program.profile(*stage, combination),
                defines: &defines,
                label: program.label(entry, combination),
                place: program.place.clone(),
            };
            let hash = hash::of_module(self.dxc.version(), job.profile, entry, &defines, &source.text);
            let compiled = self.compile(&job, &hash)?;
            let mut module = parsed(&compiled.spirv, &job.label)?;
            relaxed::decorate_copies(&mut module);
            modules.push((*stage, entry.clone(), job.label, job.profile, defines.clone(), hash, module));
        }
        let slots = dense_slots(modules.iter().map(|(.., module)| reflect::reflect(module)));
        let stages = modules
            .into_iter()
            .map(|(stage, entry, label, profile, defines, hash, mut module)| {
                reflect::renumber(&mut module, &slots);
                let spirv: Vec<u8> = module.assemble().iter().flat_map(|word| word.to_le_bytes()).collect();
                validate::validate(&spirv, &label, self.cache.as_deref(), &self.scratch)?;
                let reflection = reflect::reflect(&module);
                Ok(CompiledStage { reflection, stage, entry, label, profile, defines, hash, spirv })
            })
            .collect::<Result<Vec<_>, Problem>>()?;
        Ok(CompiledCombination { combination: combination.to_vec(), stages })
    }

    /// DXC's module, from the cache if it was compiled before.
    pub fn compile(&self, job: &Job, hash: &str) -> Result<Compiled, Problems> {
        let kept = self.cache.as_ref().map(|cache| cache.join(format!("{hash}.spv")));
        if let Some(spirv) = kept.as_ref().and_then(|kept| std::fs::read(kept).ok()) {
            return Ok(Compiled { spirv, warnings: String::new() });
        }
        let compiled = self.dxc.compile(job, &self.scratch)?;
        if !compiled.warnings.trim().is_empty() {
            eprintln!("warning: kernel {}:\n{}", job.label, compiled.warnings.trim_end());
        } else if let Some(kept) = kept {
            keep(&kept, &compiled.spirv);
        }
        Ok(compiled)
    }
}

/// SPIR-V parsed.
pub fn parsed(spirv: &[u8], label: &str) -> Result<dr::Module, Problem> {
    dr::load_bytes(spirv)
        .map_err(|error| Problem::new(format!("DXC gave a module that cannot be read: {error}")).kernel(label))
}

/// Slots 0..n over the union of the stages' bindings by name, in the order in which HLSL declares
/// them: wgpu numbers a layout's bindings so, and does not remap modules passed through.
fn dense_slots(stages: impl Iterator<Item = Reflection>) -> BTreeMap<String, u32> {
    let mut names: Vec<(u32, String)> = Vec::new();
    for stage in stages {
        for binding in stage.bindings {
            if !names.iter().any(|(_, name)| *name == binding.name) {
                names.push((binding.slot, binding.name));
            }
        }
    }
    names.sort();
    names.into_iter().zip(0..).map(|((_, name), slot)| (name, slot)).collect()
}

/// Maps in parallel over all cores, keeping the order.
pub fn in_parallel<T: Sync, R: Send>(items: &[T], map: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let next = AtomicUsize::new(0);
    let results: Mutex<Vec<(usize, R)>> = Mutex::new(Vec::new());
    let threads = std::thread::available_parallelism().map_or(2, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads.min(items.len()) {
            scope.spawn(|| {
                loop {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    let Some(item) = items.get(index) else { break };
                    let result = map(item);
                    if let Ok(mut results) = results.lock() {
                        results.push((index, result));
                    }
                }
            });
        }
    });
    let mut results = results.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    results.sort_by_key(|(index, _)| *index);
    results.into_iter().map(|(_, result)| result).collect()
}
