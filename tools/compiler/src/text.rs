//! Finds in a shader's text what the compiled module no longer tells: places and comments.

use std::sync::LazyLock;

use regex::Regex;

use crate::problem::Place;
use crate::source::{each_line, without_comments};

static RESOURCE: LazyLock<Regex> = LazyLock::new(|| {
    pattern(
        r"\b(RW|Append|Consume|RasterizerOrdered)?(StructuredBuffer|ByteAddressBuffer|Buffer|Texture\w*)\b|\b(ConstantBuffer|Sampler\w*|sampler|[ct]buffer)\b",
    )
});
static STRUCT: LazyLock<Regex> = LazyLock::new(|| pattern(r"^\s*(struct|cbuffer)\s+(\w+)"));
static CONSTANT: LazyLock<Regex> =
    LazyLock::new(|| pattern(r"^\s*static\s+const\s+(uint|int|float)\s+(\w+)\s*=\s*([^;]+?)\s*;"));
static FIELD: LazyLock<Regex> = LazyLock::new(|| pattern(r"(\w+)\s*(\[[^\]]*\]\s*)*(:[^;,]*)?[;,]"));

#[allow(clippy::expect_used)] // The patterns are those above, and every run compiles them.
fn pattern(text: &str) -> Regex {
    Regex::new(text).expect("a correct pattern")
}

/// A flattened source, line by line.
pub struct Text {
    lines: Vec<Line>,
}

struct Line {
    place: Place,
    /// Without comments.
    code: String,
    /// What stands behind `//`.
    comment: Option<String>,
}

/// A resource's declaration.
pub struct Declaration {
    /// Where it stands.
    pub place: Place,
    /// The declaration itself.
    pub code: String,
    /// The comment behind or above it.
    pub doc: Option<String>,
    /// Whether `[[vk::image_format(...)]]` stands before it.
    pub has_format: bool,
}

/// A constant as it is written.
#[derive(Clone, Debug)]
pub struct ConstantText {
    /// Where it stands.
    pub place: Place,
    /// Its name.
    pub name: String,
    /// `uint`, `int` or `float`.
    pub ty: String,
    /// Its value.
    pub value: String,
    /// The comment behind or above it.
    pub doc: Option<String>,
}

/// A struct or constant buffer as it is written.
pub struct StructText {
    /// Where it starts.
    pub place: Place,
    /// Its name.
    pub name: String,
    /// The comment above it.
    pub doc: Option<String>,
    /// Its fields.
    pub fields: Vec<FieldText>,
}

/// A field as it is written.
pub struct FieldText {
    /// Where it stands.
    pub place: Place,
    /// Its name.
    pub name: String,
    /// The comment behind it.
    pub doc: Option<String>,
}

impl Text {
    /// Splits a flattened source.
    pub fn new(flattened: &str) -> Self {
        let mut lines = Vec::new();
        let mut in_comment = false;
        each_line(flattened, |file, number, line| {
            let code = without_comments(line, &mut in_comment);
            let comment = line
                .split_once("//")
                .map(|(_, comment)| comment.trim().to_owned())
                .filter(|comment| !comment.is_empty());
            lines.push(Line { place: Place { file: file.to_owned(), line: number }, code, comment });
        });
        Self { lines }
    }

    /// The declaration of the resource `name`.
    pub fn resource(&self, name: &str) -> Option<Declaration> {
        let at = self
            .lines
            .iter()
            .position(|line| declares(&line.code, name) && RESOURCE.is_match(&line.code))
            .or_else(|| self.lines.iter().position(|line| declares(&line.code, name)))?;
        let line = &self.lines[at];
        let above = self.lines[..at].iter().rev().find(|line| !line.code.trim().is_empty());
        let has_format = line.code.contains("vk::image_format")
            || above.is_some_and(|above| above.code.contains("vk::image_format") && !above.code.contains(';'));
        Some(Declaration {
            place: line.place.clone(),
            code: line.code.trim().trim_end_matches('{').trim().trim_end_matches(';').to_owned(),
            doc: line.comment.clone().or_else(|| self.comment_above(at)),
            has_format,
        })
    }

    /// The line of the entry point's function.
    pub fn function(&self, name: &str) -> Option<(Place, Option<String>)> {
        let at = self.lines.iter().position(|line| calls(&line.code, name))?;
        let first = if at > 0 && self.lines[at - 1].code.contains("numthreads") { at - 1 } else { at };
        Some((self.lines[at].place.clone(), self.comment_above(first)))
    }

    /// The comment that a file begins with.
    pub fn head(&self, file: &str) -> Option<String> {
        let words: Vec<&str> = self
            .lines
            .iter()
            .filter(|line| line.place.file == file)
            .take_while(|line| line.code.trim().is_empty() && line.comment.is_some())
            .filter_map(|line| line.comment.as_deref())
            .collect();
        (!words.is_empty()).then(|| words.join("\n"))
    }

    /// Every struct and constant buffer written in it; in `file` only, if one is named.
    pub fn structs(&self, file: Option<&str>) -> Vec<StructText> {
        let mut structs: Vec<StructText> = Vec::new();
        let mut depth = 0;
        let mut inside = false;
        for (at, line) in self.lines.iter().enumerate() {
            if file.is_some_and(|file| line.place.file != file) {
                continue;
            }
            let mut code = line.code.as_str();
            if let (false, Some(found)) = (inside, STRUCT.captures(code)) {
                structs.push(StructText {
                    place: line.place.clone(),
                    name: found[2].to_owned(),
                    doc: self.comment_above(at),
                    fields: Vec::new(),
                });
                (inside, depth) = (true, 0);
                code = &code[found[0].len()..];
            }
            if !inside {
                continue;
            }
            let declaration = code.split('(').next().unwrap_or(code);
            if let Some(current) = structs.last_mut()
                && (depth == 1 || code.contains('{'))
            {
                for found in FIELD.captures_iter(declaration) {
                    current.fields.push(FieldText {
                        place: line.place.clone(),
                        name: found[1].to_owned(),
                        doc: line.comment.clone(),
                    });
                }
            }
            depth += code.matches('{').count() as i32 - code.matches('}').count() as i32;
            if code.contains('}') && depth <= 0 {
                inside = false;
            }
        }
        structs
    }

    /// Every `static const` number written in `file`.
    pub fn constants(&self, file: &str) -> Vec<ConstantText> {
        let of_file = |(_, line): &(usize, &Line)| line.place.file == file;
        let constant = |(at, line): (usize, &Line)| {
            let found = CONSTANT.captures(&line.code)?;
            Some(ConstantText {
                place: line.place.clone(),
                name: found[2].to_owned(),
                ty: found[1].to_owned(),
                value: found[3].to_owned(),
                doc: line.comment.clone().or_else(|| self.comment_above(at)),
            })
        };
        self.lines.iter().enumerate().filter(of_file).filter_map(constant).collect()
    }

    fn comment_above(&self, at: usize) -> Option<String> {
        let mut words: Vec<&str> = self.lines[..at]
            .iter()
            .rev()
            .take_while(|line| line.code.trim().is_empty() && line.comment.is_some())
            .filter_map(|line| line.comment.as_deref())
            .collect();
        words.reverse();
        (!words.is_empty()).then(|| words.join("\n"))
    }
}

/// Where `name` stands in `code` as a whole word: what is before it and behind it.
fn words<'c>(code: &'c str, name: &'c str) -> impl Iterator<Item = (&'c str, &'c str)> {
    let part_of_name = |c: char| c.is_alphanumeric() || c == '_';
    code.match_indices(name)
        .map(move |(at, _)| (&code[..at], &code[at + name.len()..]))
        .filter(move |(before, behind)| !before.ends_with(part_of_name) && !behind.starts_with(part_of_name))
}

/// Whether a line declares `name` outside any parenthesis (inside, it is a function's parameter).
fn declares(code: &str, name: &str) -> bool {
    let code = code.rsplit_once("]]").map_or(code, |(_attributes, code)| code);
    words(code, name).any(|(before, behind)| {
        let behind = behind.trim_start();
        !before.contains('(')
            && !before.trim().is_empty()
            && (behind.is_empty() || behind.starts_with([';', ',', '{', '[', ':']))
    })
}

/// Whether `name` stands before an opening parenthesis.
fn calls(code: &str, name: &str) -> bool {
    words(code, name).any(|(_, behind)| behind.trim_start().starts_with('('))
}

#[cfg(test)]
mod tests {
    use super::*;

    const SHADER: &str = "#line 1 \"a.compute\"
// Head of the file.

// Of the struct.
struct Body
{
    float3 at;      // where it is
    float mass, charge;
    float Weight() { return mass; }
};
float Load(Texture2D<float> map, float2 uv) { return 0; }
[[vk::image_format(\"r32f\")]] RWTexture2D<float> image;
StructuredBuffer<Body> bodies;  // all of them
Texture2D<float> map : register(t0);

// Of the kernel.
[numthreads(64, 1, 1)]
void Move(uint3 id : SV_DispatchThreadID)
{
}
";

    #[test]
    fn declarations_are_found_and_parameters_are_not() {
        let text = Text::new(SHADER);
        let line = |name| text.resource(name).map(|found| found.place.line);
        assert_eq!(line("bodies"), Some(12));
        assert_eq!(line("map"), Some(13));
        assert_eq!(line("absent"), None);
        assert!(text.resource("image").is_some_and(|found| found.has_format));
        assert!(text.resource("map").is_some_and(|found| !found.has_format));
        assert_eq!(text.resource("bodies").and_then(|found| found.doc).as_deref(), Some("all of them"));
    }

    #[test]
    fn structs_kernels_and_their_comments_are_found() {
        let text = Text::new(SHADER);
        let structs = text.structs(Some("a.compute"));
        assert_eq!(structs.len(), 1);
        assert_eq!(structs[0].doc.as_deref(), Some("Of the struct."));
        let names: Vec<&str> = structs[0].fields.iter().map(|field| field.name.as_str()).collect();
        assert_eq!(names[..3], ["at", "mass", "charge"]);
        assert_eq!(structs[0].fields[0].doc.as_deref(), Some("where it is"));
        let (place, doc) = text.function("Move").unwrap_or_else(|| panic!("Move is not found"));
        assert_eq!((place.line, doc.as_deref()), (17, Some("Of the kernel.")));
        assert_eq!(text.head("a.compute").as_deref(), Some("Head of the file."));
    }
}
