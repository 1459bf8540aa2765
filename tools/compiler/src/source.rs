//! Reads a shader and all it includes into one text, in which every line still knows its file.
//!
//! The text is what is compiled and what is hashed, so an edited include can never go unnoticed
//! (a cache keyed on the top file only would miss it). Byte-order marks and CRLF go; no line moves.

use std::path::{Component, Path, PathBuf};

use crate::problem::{Place, Problem, io_problem};

/// A shader with its includes in place.
#[derive(Clone, Debug)]
pub struct Source {
    /// Path below the shader folder, with forward slashes.
    pub file: String,
    /// The flattened text, with `#line` directives that name files and lines.
    pub text: String,
    /// Every file in it, the shader itself first, each once.
    pub files: Vec<String>,
    /// The `#pragma`s that the shader compiler answers to, in order.
    pub pragmas: Vec<Pragma>,
}

/// `#pragma NAME words...` of the shader itself.
#[derive(Clone, Debug)]
pub struct Pragma {
    /// Where it stands.
    pub place: Place,
    /// `kernel`, `vertex`, `fragment`, `multi_compile`, `tier`, ...
    pub name: String,
    /// The words behind it, without a closing semicolon.
    pub words: Vec<String>,
}

/// Pragmas that are read here and hidden from DXC.
const OWN_PRAGMAS: [&str; 16] = [
    "once",
    "kernel",
    "vertex",
    "fragment",
    "multi_compile",
    "multi_compile_local",
    "shader_feature",
    "shader_feature_local",
    "tier",
    "require",
    "geometry",
    "hull",
    "domain",
    "surface",
    "raytracing",
    "require",
];

/// Includes that only Unity has.
const UNITY_INCLUDES: [&str; 10] = [
    "UnityCG",
    "UnityShaderVariables",
    "UnityInstancing",
    "HLSLSupport",
    "Lighting.",
    "AutoLight",
    "UnityStandard",
    "UnityPBS",
    "Packages/",
    "UnityShaderUtilities",
];

/// Reads `file` (a path below `folder`) and what it includes.
pub fn read(folder: &Path, file: &str) -> Result<Source, Problem> {
    let mut reader = Reader {
        folder,
        source: Source { file: file.to_owned(), text: String::new(), files: Vec::new(), pragmas: Vec::new() },
        open: Vec::new(),
    };
    reader.read_file(file, true)?;
    Ok(reader.source)
}

struct Reader<'a> {
    folder: &'a Path,
    source: Source,
    /// The files that are being read, outermost first.
    open: Vec<String>,
}

impl Reader<'_> {
    fn read_file(&mut self, file: &str, pragmas: bool) -> Result<(), Problem> {
        let text = read_text(&self.folder.join(file))?;
        if !self.source.files.iter().any(|known| known == file) {
            self.source.files.push(file.to_owned());
        }
        self.open.push(file.to_owned());
        let once = is_once(&text).then(|| format!("BROOKLET_ONCE_{}", mangled(file)));
        if let Some(guard) = &once {
            self.source.text.push_str(&format!("#ifndef {guard}\n#define {guard}\n"));
        }
        self.mark(1, file);
        let mut in_comment = false;
        for (index, line) in text.lines().enumerate() {
            let number = index as u32 + 1;
            let code = without_comments(line, &mut in_comment);
            match Directive::of(&code) {
                Directive::Include(name) => {
                    self.include(file, number, &name, code.contains("include_with_pragmas"))?;
                }
                Directive::Pragma(name, words) if OWN_PRAGMAS.contains(&name.as_str()) => {
                    if pragmas {
                        let place = Place { file: file.to_owned(), line: number };
                        self.source.pragmas.push(Pragma { place, name, words });
                    }
                    self.source.text.push('\n');
                }
                _ => {
                    self.source.text.push_str(line);
                    self.source.text.push('\n');
                }
            }
        }
        if once.is_some() {
            self.source.text.push_str("#endif\n");
        }
        self.open.pop();
        Ok(())
    }

    /// An include that cannot be followed becomes an `#error`, because the preprocessor may never
    /// come to it: many files include Unity's own only under Unity.
    fn include(&mut self, file: &str, line: u32, name: &str, pragmas: bool) -> Result<(), Problem> {
        if UNITY_INCLUDES.iter().any(|start| name.starts_with(start)) {
            self.refuse(&format!(
                "include {name} is Unity's own and is not here. Way out: copy what is used of it \
                 into a file of yours, or put the include inside an ifdef of a keyword that only \
                 Unity sets"
            ));
            return Ok(());
        }
        match self.resolve(file, name) {
            None => self.refuse(&format!("include {name} is neither beside {file} nor in the shader folder")),
            Some(found) if self.open.contains(&found) => {
                let text = read_text(&self.folder.join(&found))?;
                if !is_once(&text) && !text.contains("#ifndef") {
                    return Err(Problem::new(format!("include {name} includes itself"))
                        .at(file, line)
                        .way_out("give it an include guard, or #pragma once"));
                }
                self.source.text.push('\n');
            }
            Some(found) => {
                self.read_file(&found, pragmas)?;
                self.mark(line + 1, file);
            }
        }
        Ok(())
    }

    fn resolve(&self, file: &str, name: &str) -> Option<String> {
        let name = name.replace('\\', "/");
        let beside = Path::new(file).parent().unwrap_or(Path::new("")).join(&name);
        [beside, PathBuf::from(&name)].iter().map(|path| normal(path)).find(|path| self.folder.join(path).is_file())
    }

    fn refuse(&mut self, message: &str) {
        self.source.text.push_str(&format!("#error {message}\n"));
    }

    fn mark(&mut self, line: u32, file: &str) {
        self.source.text.push_str(&format!("#line {line} \"{file}\"\n"));
    }
}

/// The text of a file without byte-order mark and carriage returns.
pub fn read_text(path: &Path) -> Result<String, Problem> {
    let bytes = std::fs::read(path).map_err(|error| io_problem("read", path, &error))?;
    let text = String::from_utf8_lossy(&bytes);
    let text = text.strip_prefix('\u{feff}').unwrap_or(&text);
    Ok(text.replace("\r\n", "\n").replace('\r', "\n"))
}

/// The places of a flattened text: calls `visit` with each line that is not a `#line` directive.
pub fn each_line<'t>(text: &'t str, mut visit: impl FnMut(&str, u32, &'t str)) {
    let (mut file, mut number) = (String::new(), 0);
    for line in text.lines() {
        if let Some((line, name)) = line.strip_prefix("#line ").and_then(|rest| rest.split_once(' ')) {
            number = line.parse().unwrap_or(1);
            file = name.trim_matches('"').to_owned();
            continue;
        }
        visit(&file, number, line);
        number += 1;
    }
}

enum Directive {
    Include(String),
    Pragma(String, Vec<String>),
    None,
}

impl Directive {
    fn of(code: &str) -> Self {
        let Some(rest) = code.trim_start().strip_prefix('#') else {
            return Self::None;
        };
        let rest = rest.trim_start();
        if let Some(name) = rest.strip_prefix("include_with_pragmas").or_else(|| rest.strip_prefix("include")) {
            let name = name.trim().trim_end_matches(';').trim();
            return Self::Include(name.trim_matches(['"', '<', '>']).to_owned());
        }
        if let Some(words) = rest.strip_prefix("pragma") {
            let mut words = words
                .trim()
                .trim_end_matches(';')
                .split_whitespace()
                .map(|word| word.trim_end_matches(';').to_owned())
                .filter(|word| !word.is_empty());
            if let Some(name) = words.next() {
                return Self::Pragma(name, words.collect());
            }
        }
        Self::None
    }
}

/// A line's code; `in_comment` says whether a block comment is open before and after it.
pub fn without_comments(line: &str, in_comment: &mut bool) -> String {
    let mut code = String::new();
    let mut rest = line;
    loop {
        if *in_comment {
            let Some((_, after)) = rest.split_once("*/") else {
                return code;
            };
            *in_comment = false;
            code.push(' ');
            rest = after;
        }
        match (rest.find("/*"), rest.find("//")) {
            (Some(block), line) if line.is_none_or(|line| block < line) => {
                code.push_str(&rest[..block]);
                rest = &rest[block + 2..];
                *in_comment = true;
            }
            (_, Some(line)) => {
                code.push_str(&rest[..line]);
                return code;
            }
            _ => {
                code.push_str(rest);
                return code;
            }
        }
    }
}

fn is_once(text: &str) -> bool {
    let mut in_comment = false;
    text.lines().any(|line| {
        let code = without_comments(line, &mut in_comment);
        matches!(Directive::of(&code), Directive::Pragma(name, _) if name == "once")
    })
}

/// `a/b/../c` to `a/c`, with forward slashes; a path that leaves the folder keeps its `..`.
fn normal(path: &Path) -> String {
    let mut parts: Vec<String> = Vec::new();
    for component in path.components() {
        match component {
            Component::CurDir => {}
            Component::ParentDir if parts.last().is_some_and(|last| last != "..") => {
                parts.pop();
            }
            other => parts.push(other.as_os_str().to_string_lossy().into_owned()),
        }
    }
    parts.join("/")
}

fn mangled(file: &str) -> String {
    file.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where the line that holds `wanted` stands.
    fn place_of(text: &str, wanted: &str) -> (String, u32) {
        let mut found = None;
        each_line(text, |file, number, line| {
            if line.contains(wanted) {
                found = Some((file.to_owned(), number));
            }
        });
        found.unwrap_or_default()
    }

    #[test]
    fn comments_end_where_they_end() {
        let mut open = false;
        assert_eq!(without_comments("a /* b */ c // d", &mut open), "a   c ");
        assert_eq!(without_comments("a // b /* c", &mut open), "a ");
        assert!(!open);
        assert_eq!(without_comments("a /* b", &mut open), "a ");
        assert!(open);
        assert_eq!(without_comments("b */ c", &mut open).trim(), "c");
        assert!(!open);
    }

    #[test]
    fn every_line_knows_its_file() -> Result<(), Box<dyn std::error::Error>> {
        let folder = std::env::temp_dir().join(format!("brooklet-source-{}", std::process::id()));
        std::fs::create_dir_all(folder.join("sub"))?;
        std::fs::write(
            folder.join("top.compute"),
            "\u{feff}first\r\n#include \"sub/a.hlsl\"\r\nthird\r\n#include \"b.hlsl\"\r\nfifth\r\n// #include \"none.hlsl\"\r\n#pragma kernel Name;\r\n",
        )?;
        std::fs::write(
            folder.join("sub/a.hlsl"),
            "#pragma once\n#include \"../b.hlsl\"\nin_a\n#pragma kernel NotHere\n",
        )?;
        std::fs::write(folder.join("b.hlsl"), "\nin_b\n")?;
        let source = read(&folder, "top.compute");
        std::fs::remove_dir_all(&folder)?;
        let source = source.map_err(|problem| problem.to_string())?;
        for (wanted, file, line) in [
            ("first", "top.compute", 1),
            ("in_a", "sub/a.hlsl", 3),
            ("in_b", "b.hlsl", 2),
            ("third", "top.compute", 3),
            ("fifth", "top.compute", 5),
        ] {
            assert_eq!(place_of(&source.text, wanted), (file.to_owned(), line), "{wanted}");
        }
        assert_eq!(source.files, ["top.compute", "sub/a.hlsl", "b.hlsl"]);
        assert_eq!(source.pragmas.iter().filter(|pragma| pragma.name == "kernel").count(), 1);
        assert_eq!(source.pragmas[0].words, ["Name"]);
        assert_eq!(source.pragmas[0].place.line, 7);
        assert!(!source.text.contains('\r') && !source.text.contains('\u{feff}'));
        Ok(())
    }
}
