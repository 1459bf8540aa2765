//! Writes the model as Rust.

mod format;
mod kernels;
mod structs;

use std::collections::BTreeMap;

pub use format::Formatter;

use crate::compile::in_parallel;
use crate::model::Model;
use crate::naming::{pascal, snake};
use crate::problem::Problem;

const HEADER: &str =
    "// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`\n// makes it anew from";

/// The Rust files by name, formatted.
pub fn rust_files(model: &Model, formatter: &Formatter) -> Result<BTreeMap<String, String>, Problem> {
    let mut files = Vec::new();
    let mut modules = Vec::new();
    for layout in model.layouts {
        if !layout.structs.is_empty() || !layout.constants.is_empty() {
            files.push((file_stem(&layout.file), structs::file(&layout.file, &layout.constants, &layout.structs)?));
        }
    }
    if !model.structs.is_empty() {
        files.push(("structs".to_owned(), structs::file("all shaders", &[], &model.structs)?));
    }
    if !model.keywords.is_empty() {
        files.push(("keywords".to_owned(), keywords(model)));
    }
    let mut sources: Vec<&str> = model.programs.iter().map(|program| program.source.as_str()).collect();
    sources.dedup();
    for source in sources {
        let stem = file_stem(source);
        modules.push(stem.clone());
        files.push((stem, kernels::file(model, source)));
    }
    files.push(("mod".to_owned(), index(home(model), &files, &modules)));
    let formatted =
        in_parallel(&files, |(stem, text)| Ok::<_, Problem>((format!("{stem}.rs"), formatter.formatted(text)?)));
    formatted.into_iter().collect()
}

/// Which modules are packed together, by the file that holds them (`app/kernels/build.rs`).
pub fn packs(model: &Model) -> String {
    let mut packs: BTreeMap<String, Vec<&str>> = BTreeMap::new();
    for module in &model.modules {
        packs.entry(file_stem(&module.source)).or_default().push(&module.file);
    }
    packs.iter().map(|(stem, files)| format!("{stem} {}\n", files.join(" "))).collect()
}

/// `grid/count_cells.compute` to `grid_count_cells`.
fn file_stem(source: &str) -> String {
    let path = source.rsplit_once('.').map_or(source, |(path, _)| path);
    path.split('/').map(snake).collect::<Vec<_>>().join("_")
}

/// The crate that holds the types that generated code is made of, as that code calls it.
fn home(model: &Model) -> &'static str {
    if model.known.is_some() { "brooklet_kernels" } else { "crate" }
}

fn index(home: &str, files: &[(String, String)], modules: &[String]) -> String {
    let mut text = format!("{HEADER} shaders/hlsl.\n//! All kernels, draws and host-visible structs.\n\n");
    for (stem, _) in files {
        text.push_str(&format!("mod {stem};\n"));
    }
    text.push('\n');
    for (stem, _) in files {
        text.push_str(&format!("pub use {stem}::*;\n"));
    }
    text.push_str(&format!(
        "\n/// Every module of this crate, for building all pipelines at start.\n\
         pub fn modules() -> impl Iterator<Item = &'static {home}::Module> {{\n    [\n",
    ));
    for stem in modules {
        text.push_str(&format!("        {stem}::MODULES,\n"));
    }
    text.push_str("    ].into_iter().flatten().copied()\n}\n");
    if modules.is_empty() {
        text = text.replace("[\n    ]", "[[].as_slice()]");
    }
    text
}

fn keywords(model: &Model) -> String {
    let mut text = format!("{HEADER} all shaders.\n//! Choices among keywords, of which one is on.\n");
    for (name, axis) in &model.keywords {
        let words: Vec<&str> = axis.entries.iter().map(|entry| entry.as_deref().unwrap_or("_")).collect();
        text.push_str(&format!(
            "\n/// `#pragma multi_compile {}`.\n#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]\npub enum {name} {{\n",
            words.join(" ")
        ));
        for (index, entry) in axis.entries.iter().enumerate() {
            let default = if index == 0 { "#[default]\n" } else { "" };
            let doc = match entry {
                Some(keyword) => format!("`{keyword}` is on."),
                None => "None of them is on.".to_owned(),
            };
            text.push_str(&format!("    /// {doc}\n    {default}{},\n", entry_name(entry.as_deref())));
        }
        text.push_str("}\n");
        if let [None, Some(first), ..] = axis.entries.as_slice() {
            text.push_str(&format!(
                "\n/// `{first}` on or off, and no other.\nimpl From<bool> for {name} {{\n    fn from(on: bool) -> Self {{\n        \
                 if on {{ Self::{} }} else {{ Self::Off }}\n    }}\n}}\n",
                pascal(first)
            ));
        }
    }
    text
}

/// An enum variant's name.
fn entry_name(keyword: Option<&str>) -> String {
    keyword.map_or_else(|| "Off".to_owned(), pascal)
}

/// Comment text as doc lines; what Markdown would take for a link or a tag is escaped.
fn doc(text: &str, indent: &str) -> String {
    let mut doc = String::new();
    for line in text.lines() {
        let mut in_code = false;
        let mut escaped = String::new();
        for letter in line.chars() {
            in_code ^= letter == '`';
            if !in_code && ['[', ']', '<', '>', '*', '_'].contains(&letter) {
                escaped.push('\\');
            }
            escaped.push(letter);
        }
        doc.push_str(format!("{indent}/// {escaped}").trim_end());
        doc.push('\n');
    }
    doc
}
