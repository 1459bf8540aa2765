//! The host-visible structs: asks DXC how it places each one, in uniform and in structured
//! buffers, and refuses padding that the struct does not show.

use crate::compile::{Compiler, parsed};
use crate::dxc::Job;
use crate::hash;
use crate::layout::{Field, Struct, Type};
use crate::problem::{Place, Problem, Problems};
use crate::program::Tree;
use crate::reflect::{self, Kind};
use crate::source::Source;
use crate::text::{ConstantText, StructText, Text};

/// A layout file's structs.
#[derive(Clone, Debug)]
pub struct LayoutFile {
    /// Path below the shader folder.
    pub file: String,
    /// Hash of its flattened text, for the manifest.
    pub hash: String,
    /// Its structs in order, with the comments of struct and fields.
    pub structs: Vec<DocumentedStruct>,
    /// Its numbers that host and shaders share.
    pub constants: Vec<ConstantText>,
}

/// A struct with its comments.
#[derive(Clone, Debug)]
pub struct DocumentedStruct {
    /// As it is placed.
    pub layout: Struct,
    /// The comment above it.
    pub doc: Option<String>,
    /// The comment behind each field.
    pub field_docs: Vec<Option<String>>,
}

impl DocumentedStruct {
    /// Joins a placed struct with its text, if that was found.
    pub fn new(layout: Struct, text: Option<&StructText>) -> Self {
        let field_docs = layout
            .fields
            .iter()
            .map(|field| {
                let text = text?.fields.iter().find(|text| text.name == field.name)?;
                text.doc.clone()
            })
            .collect();
        Self { layout, doc: text.and_then(|text| text.doc.clone()), field_docs }
    }
}

/// The hash of a layout file.
pub fn hash_of(compiler: &str, source: &Source) -> String {
    hash::of_module(compiler, "layout", "", &[], &source.text)
}

/// Reads and checks every layout file.
pub fn read_layouts(compiler: &Compiler, tree: &Tree) -> Result<Vec<LayoutFile>, Problems> {
    let mut files = Vec::new();
    let mut problems = Vec::new();
    for source in &tree.layouts {
        match read_layout(compiler, source) {
            Ok(file) => files.push(file),
            Err(found) => problems.extend(found.0),
        }
    }
    if problems.is_empty() { Ok(files) } else { Err(Problems(problems)) }
}

fn read_layout(compiler: &Compiler, source: &Source) -> Result<LayoutFile, Problems> {
    let text = Text::new(&source.text);
    let texts = text.structs(Some(&source.file));
    let constants = text.constants(&source.file);
    let hash = hash_of(compiler.dxc.version(), source);
    let mut file = LayoutFile { file: source.file.clone(), hash, structs: Vec::new(), constants };
    if texts.is_empty() {
        return Ok(file);
    }
    let probe = probe_of(source, &texts);
    let job = Job {
        source: &probe,
        entry: "Probe",
        profile: "cs_6_0",
        defines: &[],
        label: format!("(layout of {})", source.file),
        place: Place { file: source.file.clone(), line: 1 },
    };
    let hash = hash::of_module(compiler.dxc.version(), job.profile, job.entry, &[], &probe.text);
    let compiled = compiler.compile(&job, &hash)?;
    let reflection = reflect::reflect(&parsed(&compiled.spirv, &job.label)?);
    let mut problems = Vec::new();
    for text in &texts {
        let mut structured = None;
        let mut uniform = None;
        for binding in &reflection.bindings {
            match &binding.kind {
                Kind::Storage { element: Type::Struct(element), stride, .. }
                    if binding.name == structured_name(&text.name) =>
                {
                    structured = Some((element.clone(), *stride));
                }
                Kind::Uniform { block, .. } if binding.name == uniform_name(&text.name) => {
                    uniform = Some(block.clone());
                }
                _ => {}
            }
        }
        let (Some((structured, stride)), Some(uniform)) = (structured, uniform) else {
            problems.push(
                Problem::new(format!("struct {} has no host layout", text.name))
                    .at(text.place.file.clone(), text.place.line)
                    .way_out("host-visible structs hold floats, ints, uints, vectors, arrays and structs"),
            );
            continue;
        };
        problems.extend(gaps(text, &structured, "a structured buffer", Some(stride)));
        problems.extend(gaps(text, &uniform, "a uniform buffer", None));
        for field in &structured.fields {
            if let Err(why) = field.ty.rust() {
                let place = text.fields.iter().find(|text| text.name == field.name);
                let place = place.map_or(&text.place, |field| &field.place);
                problems.push(
                    Problem::new(format!("field {} of {}: {why}", field.name, text.name))
                        .at(place.file.clone(), place.line),
                );
            }
        }
        file.structs.push(DocumentedStruct::new(structured, Some(text)));
    }
    if problems.is_empty() { Ok(file) } else { Err(Problems(problems)) }
}

fn structured_name(name: &str) -> String {
    format!("probe_structured_{name}")
}

fn uniform_name(name: &str) -> String {
    format!("probe_uniform_{name}")
}

/// A kernel that uses every struct both ways.
fn probe_of(source: &Source, texts: &[StructText]) -> Source {
    let mut declarations = String::new();
    let mut body = String::new();
    for StructText { name, .. } in texts {
        let (structured, uniform) = (structured_name(name), uniform_name(name));
        declarations
            .push_str(&format!("RWStructuredBuffer<{name}> {structured};\nConstantBuffer<{name}> {uniform};\n"));
        body.push_str(&format!("    {structured}[0] = {uniform};\n"));
    }
    let mut probe = source.clone();
    probe.text.push_str(&format!("{declarations}[numthreads(1, 1, 1)]\nvoid Probe()\n{{\n{body}}}\n"));
    probe
}

/// Gaps before fields, inside arrays and behind the last field.
fn gaps(text: &StructText, layout: &Struct, where_placed: &str, stride: Option<u32>) -> Vec<Problem> {
    let mut problems = Vec::new();
    let mut end = 0;
    let mut say = |field: Option<&Field>, message: String, gap: u32| {
        let place = field
            .and_then(|field| text.fields.iter().find(|text| text.name == field.name))
            .map_or(&text.place, |field| &field.place);
        problems.push(Problem::new(message).at(place.file.clone(), place.line).way_out(format!(
            "fill the gap with a field of {gap} bytes ({}), or order the fields so that every row of 16 bytes is full",
            filler(gap)
        )));
    };
    for field in &layout.fields {
        if field.offset > end {
            let gap = field.offset - end;
            say(
                Some(field),
                format!(
                    "field {} of {} starts at byte {} in {where_placed}, but what stands before it ends at byte {end}: a hidden gap of {gap} bytes",
                    field.name, layout.name, field.offset
                ),
                gap,
            );
        }
        let bytes = field.ty.bytes();
        if let Type::Array { of, stride, len } = &field.ty
            && *stride > of.packed_bytes()
        {
            let gap = stride - of.packed_bytes();
            say(
                Some(field),
                format!(
                    "field {} of {} has {len} elements of {} bytes that lie {stride} bytes apart in {where_placed}: a hidden gap of {gap} bytes behind each",
                    field.name,
                    layout.name,
                    of.packed_bytes()
                ),
                gap,
            );
        }
        end = field.offset + bytes;
    }
    if let Some(stride) = stride.filter(|stride| *stride > end) {
        let gap = stride - end;
        say(
            None,
            format!(
                "{} ends at byte {end}, but its elements lie {stride} bytes apart in {where_placed}: a hidden gap of {gap} bytes behind its last field",
                layout.name
            ),
            gap,
        );
    }
    problems
}

fn filler(gap: u32) -> String {
    match gap / 4 {
        0 => "16-bit fields are not for the host".to_owned(),
        1 => "uint reserved;".to_owned(),
        count @ 2..=4 => format!("uint{count} reserved;"),
        count => format!("uint reserved[{count}];"),
    }
}
