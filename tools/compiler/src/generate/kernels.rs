//! One shader file's kernels and draws: binding structs, variants, modules.

use crate::generate::{HEADER, doc, entry_name, file_stem, home};
use crate::lint::format_of;
use crate::model::{Model, ModuleModel, ProgramModel};
use crate::naming::pascal;
use crate::program::Stage;
use crate::reflect::{Binding, Kind};
use crate::tier::Tier;

/// The file of a shader file's programs.
pub fn file(model: &Model, source: &str) -> String {
    let mut body = String::new();
    for program in model.programs.iter().filter(|program| program.source == source) {
        body.push_str(&program_text(model, program));
    }
    let modules: Vec<&ModuleModel> = model.modules.iter().filter(|module| module.source == source).collect();
    let list: Vec<String> = modules.iter().map(|module| format!("&{}", module.constant)).collect();
    body.push_str(&format!(
        "\n/// The modules of this file.\npub(super) static MODULES: &[&Module] = &[{}];\n",
        list.join(", ")
    ));
    let mut lists: Vec<String> = Vec::new();
    for module in &modules {
        let list = bindings_text(module);
        if !list.is_empty() && !lists.contains(&list) {
            lists.push(list);
        }
    }
    for (index, list) in lists.iter().enumerate() {
        body.push_str(&format!("\nstatic BINDINGS_{index}: &[BindingInfo] = &[{list}];\n"));
    }
    let is_packed = model.known.is_none();
    if is_packed {
        body.push_str(&format!(
            "\nstatic PACK: &[u8] = include_bytes!(concat!(env!(\"OUT_DIR\"), \"/{}.deflate\"));\n",
            file_stem(source)
        ));
    }
    let mut first = 0;
    for module in modules {
        let bytes = module.stage.spirv.len();
        let spirv = match is_packed {
            true => format!("Spirv::Packed {{ pack: PACK, first: {first}, bytes: {bytes} }}"),
            false => format!("Spirv::Plain(include_bytes!(\"../../spirv/{}\"))", module.file),
        };
        first += bytes;
        body.push_str(&module_text(module, &lists, &spirv));
    }
    let used = |name: &str| {
        let word = regex::Regex::new(&format!(r"\b{name}\b"));
        word.is_ok_and(|word| word.is_match(&body))
    };
    let ours = [
        "Access",
        "BindingError",
        "BindingInfo",
        "BindingKind",
        "Bound",
        "Buf",
        "BufMut",
        "Draw",
        "Format",
        "Kernel",
        "Module",
        "Spirv",
        "StageKind",
        "Tex",
        "TexMut",
        "Tier",
        "Uniform",
        "bind",
        "bind_draw",
    ];
    let mut imports: Vec<&str> = ours.into_iter().filter(|name| used(name)).collect();
    let own = model.structs().map(|known| pascal(&known.layout.name)).chain(model.keywords.keys().cloned());
    let own: Vec<String> = own.filter(|name| used(name)).collect();
    let known = model.known.as_ref();
    let known: Vec<String> = known
        .map(|known| known.structs.iter().map(|known| pascal(&known.name)).chain(known.keywords.keys().cloned()))
        .into_iter()
        .flatten()
        .filter(|name| used(name))
        .collect();
    imports.extend(known.iter().map(String::as_str));
    imports.sort_unstable();
    let home = home(model);
    let mut text =
        format!("{HEADER} {source}.\n//! Kernels of `{source}`.\n\nuse {home}::{{{}}};\n", imports.join(", "));
    if !own.is_empty() {
        text.push_str(&format!("use super::{{{}}};\n", own.join(", ")));
    }
    text + &body
}

fn program_text(model: &Model, program: &ProgramModel) -> String {
    let name = &program.program.name;
    let variant_name = format!("{name}Variant");
    let mut text = String::new();
    if !program.axes.is_empty() {
        text.push_str(&format!(
            "\n/// Which variant of [`{name}`] runs.\n#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]\npub struct {variant_name} {{\n"
        ));
        for axis in &program.axes {
            let keywords: Vec<&str> = axis.axis.entries.iter().flatten().map(String::as_str).collect();
            let ty = axis.enumeration.as_deref().unwrap_or("bool");
            text.push_str(&format!("    /// Keyword `{}`.\n    pub {}: {ty},\n", keywords.join("` or `"), axis.field));
        }
        text.push_str("}\n");
    }
    let lifetime = if program.fields.is_empty() { "" } else { "<'a>" };
    let elided = if program.fields.is_empty() { "" } else { "<'_>" };
    text.push('\n');
    text.push_str(&doc(&program.doc, ""));
    text.push_str("#[derive(Debug)]\n");
    text.push_str(&format!("pub struct {name}{lifetime} {{\n"));
    if !program.axes.is_empty() {
        text.push_str(&format!("    /// Its variant.\n    pub variant: {variant_name},\n"));
    }
    for field in &program.fields {
        text.push_str(&doc(&field.doc, "    "));
        let ty = if field.optional { format!("Option<{}>", field.ty) } else { field.ty.clone() };
        text.push_str(&format!("    pub {}: {ty},\n", field.name));
    }
    text.push_str("}\n\n");
    let given: Vec<String> = program
        .fields
        .iter()
        .map(|field| {
            let id = if field.optional {
                format!("self.{}.as_ref().map(|bound| bound.id)", field.name)
            } else {
                format!("Some(self.{}.id)", field.name)
            };
            format!("({:?}, {id})", field.hlsl)
        })
        .collect();
    let stage = &program.program.stage_name;
    let given = given.join(", ");
    if program.program.is_draw() {
        let vertex = choice(model, program, 0, false);
        let fragment =
            if program.program.entries.len() > 1 { choice(model, program, 1, true) } else { "None".to_owned() };
        text.push_str(&format!(
            "impl Draw for {name}{elided} {{\n    const STAGE: &'static str = {stage:?};\n\n\
             fn vertex(&self) -> &'static Module {{\n{vertex}\n}}\n\
             fn fragment(&self) -> Option<&'static Module> {{\n{fragment}\n}}\n\
             fn bindings(&self) -> Result<Vec<Bound>, BindingError> {{\n\
             bind_draw(self.vertex(), self.fragment(), &[{given}])\n}}\n}}\n"
        ));
    } else {
        let module = choice(model, program, 0, false);
        text.push_str(&format!(
            "impl Kernel for {name}{elided} {{\n    const STAGE: &'static str = {stage:?};\n\
             const GROUP_SIZE: [u32; 3] = {:?};\n\n\
             fn module(&self) -> &'static Module {{\n{module}\n}}\n\
             fn bindings(&self) -> Result<Vec<Bound>, BindingError> {{\n\
             bind(self.module(), &[{given}])\n}}\n}}\n",
            program.group_size
        ));
    }
    text
}

/// The expression that chooses a stage's module by the variant.
fn choice(model: &Model, program: &ProgramModel, stage: usize, some: bool) -> String {
    let reference = |modules: &[usize]| {
        let module = format!("&{}", model.modules[modules[stage]].constant);
        if some { format!("Some({module})") } else { module }
    };
    let same = program.variants.iter().all(|(_, modules)| modules[stage] == program.variants[0].1[stage]);
    if program.axes.is_empty() || same {
        return reference(&program.variants[0].1);
    }
    let subjects: Vec<String> = program.axes.iter().map(|axis| format!("self.variant.{}", axis.field)).collect();
    let tuple = |parts: Vec<String>| {
        if parts.len() == 1 { parts[0].clone() } else { format!("({})", parts.join(", ")) }
    };
    let mut arms = String::new();
    for (entries, modules) in &program.variants {
        let patterns = program
            .axes
            .iter()
            .zip(entries)
            .map(|(axis, &entry)| match &axis.enumeration {
                None => (entry == 1).to_string(),
                Some(name) => format!("{name}::{}", entry_name(axis.axis.entries[entry].as_deref())),
            })
            .collect();
        arms.push_str(&format!("{} => {},\n", tuple(patterns), reference(modules)));
    }
    let subject = tuple(subjects);
    if program.axes.len() == 1 && program.axes[0].enumeration.is_none() {
        let of = |entry: usize| {
            let found = program.variants.iter().find(|(entries, _)| entries[0] == entry);
            found.map(|(_, modules)| reference(modules)).unwrap_or_default()
        };
        return format!("if {subject} {{ {} }} else {{ {} }}", of(1), of(0));
    }
    format!("match {subject} {{\n{arms}}}")
}

fn bindings_text(module: &ModuleModel) -> String {
    let bindings: Vec<String> = module.stage.reflection.bindings.iter().map(binding_text).collect();
    bindings.join(", ")
}

/// A module; `lists` are the binding lists of its file, shared by modules that bind alike.
fn module_text(module: &ModuleModel, lists: &[String], spirv: &str) -> String {
    let list = bindings_text(module);
    let bindings = match lists.iter().position(|known| *known == list) {
        Some(index) => format!("BINDINGS_{index}"),
        None => "&[]".to_owned(),
    };
    let stage = match module.stage.stage {
        Stage::Compute => "Compute",
        Stage::Vertex => "Vertex",
        Stage::Fragment => "Fragment",
    };
    let tier = match module.tier {
        Tier::Floor => "Floor",
        Tier::Mobile => "Mobile",
        Tier::Desktop => "Desktop",
    };
    format!(
        "\nstatic {}: Module = Module {{ name: {:?}, entry: {:?}, stage: StageKind::{stage}, \
         spirv: {spirv}, bindings: {bindings}, group_size: {:?}, shared_bytes: {}, \
         tier: Tier::{tier}, source: {:?}, hash: {:?} }};\n",
        module.constant,
        module.name,
        module.stage.entry,
        module.stage.reflection.group_size,
        module.stage.reflection.shared_bytes,
        module.source,
        module.stage.hash,
    )
}

fn binding_text(binding: &Binding) -> String {
    let kind = match &binding.kind {
        Kind::Uniform { bytes, .. } => format!("BindingKind::Uniform {{ bytes: {bytes} }}"),
        Kind::Storage { read_only, stride, .. } => {
            let access = if *read_only { "Read" } else { "ReadWrite" };
            format!("BindingKind::Storage {{ access: Access::{access}, stride_bytes: {stride} }}")
        }
        Kind::Texture { filterable } => format!("BindingKind::Texture {{ filterable: {filterable} }}"),
        Kind::StorageImage { format } => format!(
            "BindingKind::StorageTexture {{ format: Format::{}, access: Access::ReadWrite }}",
            format_of(format).unwrap_or("R32Float")
        ),
        Kind::Sampler | Kind::Unsupported { .. } => "BindingKind::Sampler".to_owned(),
    };
    format!("BindingInfo {{ name: {:?}, slot: {}, kind: {kind} }}", binding.name, binding.slot)
}
