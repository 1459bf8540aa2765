//! What a folder of shaders holds: compute kernels and draws, each with its axes of keywords.

use std::path::Path;

use crate::naming::{pascal, snake};
use crate::problem::{Place, Problem, Problems, io_problem};
use crate::source::{self, Source};
use crate::tier::Tier;

/// A stage of the pipeline.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    /// A compute kernel.
    Compute,
    /// A vertex stage.
    Vertex,
    /// A fragment stage.
    Fragment,
}

impl Stage {
    /// DXC's target profile for it; 16-bit arithmetic came with shader model 6.2.
    fn profile(self, native_16_bit: bool) -> &'static str {
        match (self, native_16_bit) {
            (Self::Compute, false) => "cs_6_0",
            (Self::Compute, true) => "cs_6_2",
            (Self::Vertex, false) => "vs_6_0",
            (Self::Vertex, true) => "vs_6_2",
            (Self::Fragment, false) => "ps_6_0",
            (Self::Fragment, true) => "ps_6_2",
        }
    }
    /// The define that Unity sets for it.
    fn unity_define(self) -> &'static str {
        match self {
            Self::Compute => "SHADER_STAGE_COMPUTE=1",
            Self::Vertex => "SHADER_STAGE_VERTEX=1",
            Self::Fragment => "SHADER_STAGE_FRAGMENT=1",
        }
    }
}

/// One `#pragma multi_compile`: exactly one of its entries is on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Axis {
    /// The keywords; `None` is `_`, no keyword.
    pub entries: Vec<Option<String>>,
}

impl Axis {
    /// Whether it is one keyword, on or off.
    pub fn is_switch(&self) -> bool {
        self.entries.len() == 2 && self.entries[0].is_none()
    }
    fn of(words: &[String], optional: bool) -> Self {
        let mut entries: Vec<Option<String>> =
            words.iter().map(|word| (!word.chars().all(|c| c == '_')).then(|| word.clone())).collect();
        if optional && !entries.contains(&None) && entries.len() == 1 {
            entries.insert(0, None);
        }
        // Off first: the default of every axis that can be off.
        entries.sort_by_key(Option::is_some);
        let mut known = Vec::new();
        entries.retain(|entry| {
            !known.contains(entry) && {
                known.push(entry.clone());
                true
            }
        });
        Self { entries }
    }
}

/// A compute kernel, or a draw's vertex and fragment stages.
#[derive(Clone, Debug)]
pub struct Program {
    /// Its type's name in Rust: `CountCells`, `DrawFloor`.
    pub name: String,
    /// Its one name everywhere: `count_cells`, `draw_floor`.
    pub stage_name: String,
    /// Entry points: one of a kernel; vertex, then fragment of a draw.
    pub entries: Vec<(Stage, String)>,
    /// Defines of the kernel's own pragma.
    pub defines: Vec<String>,
    /// Axes of keywords of its file.
    pub axes: Vec<Axis>,
    /// Where 16-bit types are 16 bits wide (`#pragma require Native16Bit : KEYWORDS`): with any
    /// of these keywords, or always if none is named.
    pub native_16_bit: Option<Vec<String>>,
    /// The tier whose limits it may use up (`#pragma tier`).
    pub tier: Tier,
    /// The same of variants with one of some keywords (`#pragma tier NAME : KEYWORDS`).
    pub keyword_tiers: Vec<(Tier, Vec<String>)>,
    /// Where its pragma stands.
    pub place: Place,
    /// Name in Rust of its file's loose globals.
    pub globals: String,
    /// Index of its source.
    pub source: usize,
}

impl Program {
    /// Whether it draws.
    pub fn is_draw(&self) -> bool {
        self.entries[0].0 != Stage::Compute
    }
    /// Every choice of one entry an axis, the first axis fastest.
    pub fn combinations(&self) -> Vec<Vec<usize>> {
        let mut all = vec![vec![]];
        for axis in self.axes.iter().rev() {
            all = (0..axis.entries.len())
                .flat_map(|entry| {
                    all.iter().map(move |rest| {
                        let mut combination = vec![entry];
                        combination.extend(rest);
                        combination
                    })
                })
                .collect();
        }
        all
    }
    /// The keywords that are on in a combination.
    pub fn keywords(&self, combination: &[usize]) -> Vec<String> {
        let chosen = self.axes.iter().zip(combination);
        chosen.filter_map(|(axis, &entry)| axis.entries[entry].clone()).collect()
    }
    /// All defines of a stage in a combination.
    pub fn defines_of(&self, stage: Stage, combination: &[usize]) -> Vec<String> {
        let mut defines = vec![stage.unity_define().to_owned()];
        defines.extend(self.defines.iter().cloned());
        let keywords = self.keywords(combination);
        defines.extend(keywords.into_iter().map(|keyword| format!("{keyword}=1")));
        defines
    }
    /// DXC's target profile for a stage in a combination.
    pub fn profile(&self, stage: Stage, combination: &[usize]) -> &'static str {
        let keywords = self.keywords(combination);
        let native = self
            .native_16_bit
            .as_ref()
            .is_some_and(|needs| needs.is_empty() || needs.iter().any(|need| keywords.contains(need)));
        stage.profile(native)
    }
    /// The tier whose limits a combination may use up.
    pub fn tier_of(&self, combination: &[usize]) -> Tier {
        let keywords = self.keywords(combination);
        let asked = self.keyword_tiers.iter().filter(|(_, needs)| needs.iter().any(|need| keywords.contains(need)));
        asked.map(|(tier, _)| *tier).fold(self.tier, Tier::max)
    }
    /// How messages and modules name a combination's entry point: `Name+KEYWORD`.
    pub fn label(&self, entry: &str, combination: &[usize]) -> String {
        let mut label = entry.to_owned();
        for keyword in self.keywords(combination) {
            label.push('+');
            label.push_str(&keyword);
        }
        label
    }
}

/// A folder of shaders, read.
#[derive(Clone, Debug, Default)]
pub struct Tree {
    /// Every file with kernels or draws, flattened, in order of path.
    pub sources: Vec<Source>,
    /// Every kernel and draw.
    pub programs: Vec<Program>,
    /// The `layout.hlsli` files, flattened: the homes of host-visible structs.
    pub layouts: Vec<Source>,
}

/// More than this many combinations of a file's keywords are a mistake.
const MAX_COMBINATIONS: usize = 64;

/// Reads every shader below `folder`.
pub fn read_tree(folder: &Path) -> Result<Tree, Problems> {
    let mut paths = Vec::new();
    list(folder, "", &mut paths)?;
    paths.sort();
    let mut tree = Tree::default();
    let mut problems = Vec::new();
    for path in paths {
        if path == "layout.hlsli" || path.ends_with("/layout.hlsli") {
            tree.layouts.push(source::read(folder, &path)?);
        } else if path.ends_with(".compute") || path.ends_with(".hlsl") {
            let source = match source::read(folder, &path) {
                Ok(source) => source,
                Err(problem) => {
                    problems.push(problem);
                    continue;
                }
            };
            let index = tree.sources.len();
            match programs_of(&source, index) {
                Ok(programs) if programs.is_empty() => {}
                Ok(programs) => {
                    tree.programs.extend(programs);
                    tree.sources.push(source);
                }
                Err(problem) => problems.push(problem),
            }
        }
    }
    for (i, program) in tree.programs.iter().enumerate() {
        let same = tree.programs[..i]
            .iter()
            .find(|other| other.stage_name == program.stage_name || other.name == program.name);
        if let Some(other) = same {
            problems.push(
                Problem::new(format!("{} is also the name of what stands in {}", program.name, other.place.file))
                    .at(program.place.file.clone(), program.place.line)
                    .way_out("rename one of them: a kernel's name is its stage's one name everywhere"),
            );
        }
    }
    if problems.is_empty() { Ok(tree) } else { Err(Problems(problems)) }
}

fn list(folder: &Path, below: &str, paths: &mut Vec<String>) -> Result<(), Problem> {
    let here = folder.join(below);
    let entries = std::fs::read_dir(&here).map_err(|error| io_problem("read", &here, &error))?;
    for entry in entries {
        let entry = entry.map_err(|error| io_problem("read", &here, &error))?;
        let name = entry.file_name().to_string_lossy().into_owned();
        let path = if below.is_empty() { name } else { format!("{below}/{name}") };
        if entry.path().is_dir() {
            list(folder, &path, paths)?;
        } else {
            paths.push(path);
        }
    }
    Ok(())
}

/// The keywords that a pragma is limited to, behind its colon; none if it has no colon.
fn keywords_of(words: &[String]) -> Vec<String> {
    words.iter().skip_while(|word| *word != ":").skip(1).cloned().collect()
}

fn programs_of(source: &Source, index: usize) -> Result<Vec<Program>, Problem> {
    let mut axes: Vec<Axis> = Vec::new();
    let mut tier = Tier::Floor;
    let mut keyword_tiers = Vec::new();
    let mut native_16_bit = None;
    let (mut vertex, mut fragment) = (None, None);
    let mut kernels = Vec::new();
    for pragma in &source.pragmas {
        let wrong = |message: &str| {
            Problem::new(format!("#pragma {}: {message}", pragma.name)).at(pragma.place.file.clone(), pragma.place.line)
        };
        let needs_name = || wrong("a name is missing");
        match pragma.name.as_str() {
            "kernel" => {
                let (name, defines) = pragma.words.split_first().ok_or_else(needs_name)?;
                kernels.push((name.clone(), defines.to_vec(), pragma.place.clone()));
            }
            "vertex" | "fragment" => {
                let name = pragma.words.first().ok_or_else(needs_name)?.clone();
                let slot = if pragma.name == "vertex" { &mut vertex } else { &mut fragment };
                if slot.replace((name, pragma.place.clone())).is_some() {
                    return Err(wrong("a file has one vertex and one fragment stage"));
                }
            }
            "multi_compile" | "multi_compile_local" | "shader_feature" | "shader_feature_local" => {
                if pragma.words.is_empty() {
                    return Err(needs_name());
                }
                let axis = Axis::of(&pragma.words, pragma.name.starts_with("shader_feature"));
                axes.push(axis);
            }
            "tier" => {
                let name = pragma.words.first().ok_or_else(needs_name)?;
                let named = Tier::named(name)
                    .ok_or_else(|| wrong(&format!("{name} is no tier; tiers are floor, mobile and desktop")))?;
                match keywords_of(&pragma.words) {
                    keywords if keywords.is_empty() => tier = named,
                    keywords => keyword_tiers.push((named, keywords)),
                }
            }
            "require" if pragma.words.iter().any(|word| word == "Native16Bit") => {
                native_16_bit = Some(keywords_of(&pragma.words));
            }
            "geometry" | "hull" | "domain" | "surface" | "raytracing" => {
                return Err(wrong("this stage is not supported")
                    .way_out("do its work in a compute kernel, or in the vertex stage"));
            }
            _ => {}
        }
    }
    let combinations: usize = axes.iter().map(|axis| axis.entries.len()).product();
    if combinations > MAX_COMBINATIONS {
        return Err(Problem::new(format!(
            "its multi_compile lines make {combinations} variants; at most {MAX_COMBINATIONS} are allowed"
        ))
        .at(source.file.clone(), 1)
        .way_out("split the file, so that a kernel's file has only the keywords that it uses"));
    }
    let file_name = source.file.rsplit('/').next().unwrap_or(&source.file);
    let stem = snake(file_name.split('.').next().unwrap_or(file_name));
    let globals = format!("{}Globals", pascal(&stem));
    let mut programs: Vec<Program> = kernels
        .into_iter()
        .map(|(name, defines, place)| Program {
            stage_name: snake(&name),
            name: pascal(&name),
            entries: vec![(Stage::Compute, name)],
            defines,
            axes: axes.clone(),
            native_16_bit: native_16_bit.clone(),
            tier,
            keyword_tiers: keyword_tiers.clone(),
            place,
            globals: globals.clone(),
            source: index,
        })
        .collect();
    if let Some((name, place)) = fragment.as_ref().filter(|_| vertex.is_none()) {
        return Err(Problem::new(format!("fragment stage {name} has no vertex stage"))
            .at(place.file.clone(), place.line)
            .way_out("add `#pragma vertex NAME` to the same file"));
    }
    if let Some((name, place)) = vertex {
        let mut entries = vec![(Stage::Vertex, name)];
        entries.extend(fragment.map(|(name, _)| (Stage::Fragment, name)));
        programs.push(Program {
            name: format!("Draw{}", pascal(&stem)),
            stage_name: format!("draw_{stem}"),
            entries,
            defines: Vec::new(),
            axes,
            native_16_bit,
            tier,
            keyword_tiers,
            place,
            globals: globals.clone(),
            source: index,
        });
    }
    Ok(programs)
}
