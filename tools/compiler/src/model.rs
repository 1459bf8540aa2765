//! What is generated, before it is written as Rust: modules, programs, structs, keyword enums.

use std::collections::BTreeMap;

use crate::compile::{CompiledCombination, CompiledStage};
use crate::layout::{Struct, Type};
use crate::layouts::{DocumentedStruct, LayoutFile};
use crate::naming::{pascal, snake};
use crate::problem::{Problem, Problems};
use crate::program::{Axis, Program, Stage, Tree};
use crate::reflect::{Binding, Kind};
use crate::text::Text;
use crate::tier::Tier;

/// Everything that is generated.
pub struct Model<'a> {
    /// Structs of the layout files.
    pub layouts: &'a [LayoutFile],
    /// Structs of constant buffers and elements that stand in no layout file.
    pub structs: Vec<DocumentedStruct>,
    /// Enums of keywords, by name.
    pub keywords: BTreeMap<String, Axis>,
    /// Kernels and draws.
    pub programs: Vec<ProgramModel<'a>>,
    /// Modules, each with different bytes.
    pub modules: Vec<ModuleModel>,
    /// What it builds on; `None` of the crate that holds the types it is all made of.
    pub known: Option<Known>,
}

/// What a crate makes of host-visible structs and keywords, for those that build on it.
#[derive(Clone, Debug)]
pub struct Known {
    /// Its structs.
    pub structs: Vec<Struct>,
    /// Its enums of keywords, by name.
    pub keywords: BTreeMap<String, Axis>,
}

impl Known {
    /// All that `model` makes.
    pub fn of(model: &Model<'_>) -> Self {
        Self { structs: model.structs().map(|known| known.layout.clone()).collect(), keywords: model.keywords.clone() }
    }
}

impl Model<'_> {
    /// Every struct that is generated.
    pub fn structs(&self) -> impl Iterator<Item = &DocumentedStruct> {
        self.layouts.iter().flat_map(|file| &file.structs).chain(&self.structs)
    }
}

/// A kernel or draw.
pub struct ProgramModel<'a> {
    /// What was read.
    pub program: &'a Program,
    /// Its source's path.
    pub source: String,
    /// The comment above it.
    pub doc: String,
    /// Axes that change something for it, by index into the program's.
    pub axes: Vec<AxisModel>,
    /// Its resources, in order of declaration.
    pub fields: Vec<FieldModel>,
    /// For each choice of one entry per kept axis: the modules of its stages.
    pub variants: Vec<(Vec<usize>, Vec<usize>)>,
    /// Threads of a group.
    pub group_size: [u32; 3],
}

/// An axis that a program keeps.
pub struct AxisModel {
    /// Field of the variant struct.
    pub field: String,
    /// Name of its enum; `None` for a switch.
    pub enumeration: Option<String>,
    /// Its entries.
    pub axis: Axis,
}

/// A resource of a program.
pub struct FieldModel {
    /// Name in HLSL.
    pub hlsl: String,
    /// Name in Rust.
    pub name: String,
    /// Type in Rust, without `Option`.
    pub ty: String,
    /// Bound in some variants only.
    pub optional: bool,
    /// Its declaration and comment.
    pub doc: String,
}

/// A module.
pub struct ModuleModel {
    /// `CountCells+KEYWORD`, `DrawFloor.vertex+KEYWORD`.
    pub name: String,
    /// Name of its static.
    pub constant: String,
    /// Name of its file.
    pub file: String,
    /// Which source's Rust file it stands in.
    pub source: String,
    /// What was compiled.
    pub stage: CompiledStage,
    /// The lowest tier that it fits.
    pub tier: Tier,
}

/// Where each compiled variant went, for the manifest.
pub struct VariantRecord {
    /// The stage of it.
    pub stage: CompiledStage,
    /// Its source's path.
    pub source: String,
    /// The module that it became.
    pub module: String,
}

/// Makes the model of a crate, which builds on what is `known`; the records name every compiled variant, those without a module of their own too.
pub fn model<'a>(
    tree: &'a Tree,
    layouts: &'a [LayoutFile],
    compiled: &[Vec<CompiledCombination>],
    known: Option<Known>,
) -> Result<(Model<'a>, Vec<VariantRecord>), Problems> {
    let mut model = Model {
        layouts,
        structs: Vec::new(),
        keywords: BTreeMap::new(),
        programs: Vec::new(),
        modules: Vec::new(),
        known,
    };
    let mut records = Vec::new();
    let mut problems = Vec::new();
    for (program, combinations) in tree.programs.iter().zip(compiled) {
        let source = &tree.sources[program.source];
        let text = Text::new(&source.text);
        let kept = kept_axes(program, combinations);
        let mut fields = Vec::new();
        match fields_of(program, combinations, &text) {
            Ok(found) => fields = found,
            Err(problem) => problems.push(problem),
        }
        problems.extend(add_structs(&mut model, program, combinations, &text));
        let axes = kept.iter().map(|&index| axis_model(&program.axes[index])).collect::<Vec<_>>();
        for axis in &axes {
            let Some(name) = &axis.enumeration else { continue };
            let known = model.known.as_ref().and_then(|known| known.keywords.get(name)).cloned();
            let known = known
                .unwrap_or_else(|| model.keywords.entry(name.clone()).or_insert_with(|| axis.axis.clone()).clone());
            if known != axis.axis {
                problems.push(
                    Problem::new(format!("two multi_compile lines would both become the enum {name}"))
                        .at_place(Some(program.place.clone()))
                        .way_out("use the same keywords in the same order in both, or rename those of one"),
                );
            }
        }
        let variants = add_modules(&mut model, &mut records, program, combinations, &kept, &source.file);
        model.programs.push(ProgramModel {
            doc: doc_of(program, &text, &source.file),
            source: source.file.clone(),
            axes,
            fields,
            variants,
            group_size: combinations[0].stages[0].reflection.group_size,
            program,
        });
    }
    if problems.is_empty() { Ok((model, records)) } else { Err(Problems(problems)) }
}

fn doc_of(program: &Program, text: &Text, file: &str) -> String {
    let own = text.function(&program.entries[0].1).and_then(|(_, doc)| doc);
    let head = text.head(file);
    let doc = if program.is_draw() { head.or(own) } else { own.or(head) };
    doc.unwrap_or_else(|| format!("`{}` of `{file}`.", program.entries[0].1))
}

/// Axes whose choice changes a module's bytes in at least one combination.
fn kept_axes(program: &Program, combinations: &[CompiledCombination]) -> Vec<usize> {
    let bytes: BTreeMap<&[usize], Vec<&[u8]>> = combinations
        .iter()
        .map(|combination| {
            let stages = combination.stages.iter().map(|stage| stage.spirv.as_slice()).collect();
            (combination.combination.as_slice(), stages)
        })
        .collect();
    (0..program.axes.len())
        .filter(|&axis| {
            combinations.iter().any(|combination| {
                let mut first = combination.combination.clone();
                first[axis] = 0;
                bytes.get(first.as_slice()) != bytes.get(combination.combination.as_slice())
            })
        })
        .collect()
}

fn axis_model(axis: &Axis) -> AxisModel {
    let keywords: Vec<&str> = axis.entries.iter().flatten().map(String::as_str).collect();
    if axis.is_switch() {
        return AxisModel { field: snake(keywords[0]), enumeration: None, axis: axis.clone() };
    }
    let field = common_words(&keywords).unwrap_or_else(|| snake(&keywords.join("_OR_")));
    AxisModel { enumeration: Some(format!("{}Keyword", pascal(&field))), field, axis: axis.clone() }
}

/// The words that all keywords begin or end with: `walls` of `WALLS` and `NARROW_WALLS`.
fn common_words(keywords: &[&str]) -> Option<String> {
    let words: Vec<Vec<&str>> = keywords.iter().map(|keyword| keyword.split('_').collect()).collect();
    let first = words.first()?;
    for len in (1..=first.len()).rev() {
        let (start, end) = (&first[..len], &first[first.len() - len..]);
        for common in [start, end] {
            if words.iter().all(|words| words.starts_with(common)) || words.iter().all(|words| words.ends_with(common))
            {
                return Some(snake(&common.join("_")));
            }
        }
    }
    None
}

fn fields_of(program: &Program, combinations: &[CompiledCombination], text: &Text) -> Result<Vec<FieldModel>, Problem> {
    let mut fields: Vec<FieldModel> = Vec::new();
    for combination in combinations {
        for stage in &combination.stages {
            for binding in &stage.reflection.bindings {
                let Some(ty) = field_type(binding, &program.globals) else { continue };
                let declaration = text.resource(&binding.name);
                match fields.iter().find(|field| field.hlsl == binding.name) {
                    Some(known) if known.ty == ty => {}
                    Some(known) => {
                        return Err(Problem::new(format!(
                            "{} is {} in one variant and {ty} in another",
                            binding.name, known.ty
                        ))
                        .at_place(declaration.map(|declaration| declaration.place))
                        .kernel(stage.label.clone())
                        .way_out("give it one type, or two names"));
                    }
                    None => fields.push(FieldModel {
                        hlsl: binding.name.clone(),
                        name: snake(&binding.name),
                        ty,
                        optional: false,
                        doc: field_doc(declaration, binding),
                    }),
                }
            }
        }
    }
    for field in &mut fields {
        field.optional = !combinations.iter().all(|combination| {
            let mut bindings = combination.stages.iter().flat_map(|stage| &stage.reflection.bindings);
            bindings.any(|binding| binding.name == field.hlsl)
        });
    }
    Ok(fields)
}

fn field_doc(declaration: Option<crate::text::Declaration>, binding: &Binding) -> String {
    let Some(declaration) = declaration else {
        return format!("`{}`.", binding.name);
    };
    match declaration.doc {
        Some(doc) => format!("{doc}\n\n`{}`.", declaration.code),
        None => format!("`{}`.", declaration.code),
    }
}

/// The binding's type in Rust; samplers have no field.
fn field_type(binding: &Binding, globals: &str) -> Option<String> {
    Some(match &binding.kind {
        Kind::Uniform { block, .. } => format!("Uniform<'a, {}>", block_name(block, globals)),
        Kind::Storage { read_only, element, .. } => {
            let wrapper = if *read_only { "Buf" } else { "BufMut" };
            format!("{wrapper}<'a, {}>", element.rust().unwrap_or_default())
        }
        Kind::Texture { .. } => "Tex<'a>".to_owned(),
        Kind::StorageImage { .. } => "TexMut<'a>".to_owned(),
        Kind::Sampler | Kind::Unsupported { .. } => return None,
    })
}

/// A uniform block's type: `$Globals` is named after its file.
fn block_name(block: &Struct, globals: &str) -> String {
    if block.name == "$Globals" { globals.to_owned() } else { pascal(&block.name) }
}

fn add_structs(
    model: &mut Model,
    program: &Program,
    combinations: &[CompiledCombination],
    text: &Text,
) -> Vec<Problem> {
    let texts = text.structs(None);
    let mut problems = Vec::new();
    for stage in combinations.iter().flat_map(|combination| &combination.stages) {
        for binding in &stage.reflection.bindings {
            let whole = match &binding.kind {
                Kind::Uniform { block, .. } => {
                    let mut block = block.clone();
                    block.name = if block.name == "$Globals" { program.globals.clone() } else { block.name };
                    Type::Struct(block)
                }
                Kind::Storage { element, .. } => element.clone(),
                _ => continue,
            };
            for found in whole.structs() {
                let rust_name = pascal(&found.name);
                let own = model.structs().map(|known| &known.layout);
                let known = own
                    .chain(model.known.iter().flat_map(|known| &known.structs))
                    .find(|known| pascal(&known.name) == rust_name);
                match known {
                    Some(known) if known.fields == found.fields => {}
                    Some(_) => {
                        let place = text.resource(&binding.name).map(|declaration| declaration.place);
                        problems.push(
                            Problem::new(format!(
                                "struct {} of {} is placed differently elsewhere",
                                found.name, binding.name
                            ))
                            .at_place(place)
                            .kernel(stage.label.clone())
                            .way_out("two structs of one name must be equal, with no gaps in uniform and in structured buffers; rename one, or move it to layout.hlsli"),
                        );
                    }
                    None => {
                        let text = texts.iter().find(|text| text.name == found.name);
                        model.structs.push(DocumentedStruct::new(found.clone(), text));
                    }
                }
            }
        }
    }
    problems
}

fn add_modules(
    model: &mut Model,
    records: &mut Vec<VariantRecord>,
    program: &Program,
    combinations: &[CompiledCombination],
    kept: &[usize],
    source: &str,
) -> Vec<(Vec<usize>, Vec<usize>)> {
    let own = model.modules.len();
    let mut variants: Vec<(Vec<usize>, Vec<usize>)> = Vec::new();
    for combination in combinations {
        let choice: Vec<usize> = kept.iter().map(|&axis| combination.combination[axis]).collect();
        let mut modules = Vec::new();
        for stage in &combination.stages {
            let same = model.modules[own..]
                .iter()
                .position(|module| module.stage.stage == stage.stage && module.stage.spirv == stage.spirv);
            let index = same.map(|index| own + index).unwrap_or_else(|| {
                model.modules.push(module_model(program, combination, stage, kept, source));
                model.modules.len() - 1
            });
            records.push(VariantRecord {
                stage: stage.clone(),
                source: source.to_owned(),
                module: model.modules[index].name.clone(),
            });
            modules.push(index);
        }
        if !variants.iter().any(|(known, _)| *known == choice) {
            variants.push((choice, modules));
        }
    }
    variants
}

fn module_model(
    program: &Program,
    combination: &CompiledCombination,
    stage: &CompiledStage,
    kept: &[usize],
    source: &str,
) -> ModuleModel {
    let keywords: Vec<&String> =
        kept.iter().filter_map(|&axis| program.axes[axis].entries[combination.combination[axis]].as_ref()).collect();
    let suffix = match stage.stage {
        Stage::Compute => "",
        Stage::Vertex => ".vertex",
        Stage::Fragment => ".fragment",
    };
    let mut name = format!("{}{suffix}", program.name);
    let mut file = format!("{}{suffix}", program.stage_name);
    // Two keywords apart, so that no two variants share a constant: A_B is not A and B.
    let mut constant = file.replace('.', "_").to_ascii_uppercase();
    for keyword in &keywords {
        name.push_str(&format!("+{keyword}"));
        file.push_str(&format!("+{}", keyword.to_ascii_lowercase()));
        constant.push_str(&format!("_WITH_{}", snake(keyword).to_ascii_uppercase()));
    }
    ModuleModel {
        name,
        constant,
        file: format!("{file}.spv"),
        source: source.to_owned(),
        tier: Tier::of(&stage.reflection).unwrap_or(Tier::Desktop),
        stage: stage.clone(),
    }
}
