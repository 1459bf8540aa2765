//! Host-visible structs, with their offsets asserted.

use crate::generate::{HEADER, doc};
use crate::layouts::DocumentedStruct;
use crate::naming::{pascal, snake};
use crate::problem::Problem;
use crate::text::ConstantText;

/// The file of a shader file's constants and structs.
pub fn file(source: &str, constants: &[ConstantText], structs: &[DocumentedStruct]) -> Result<String, Problem> {
    let mut text = format!(
        "{HEADER} {source}.\n//! Host-visible structs of `{source}`.\n\nuse std::mem::{{offset_of, size_of}};\n\nuse bytemuck::{{Pod, Zeroable}};\n"
    );
    for constant in constants {
        text.push('\n');
        text.push_str(&self::constant(constant)?);
    }
    for documented in structs {
        text.push('\n');
        text.push_str(
            &structure(documented).map_err(|why| Problem::new(format!("struct {}: {why}", documented.layout.name)))?,
        );
    }
    Ok(text)
}

fn constant(constant: &ConstantText) -> Result<String, Problem> {
    let digits = constant.value.trim_end_matches(['u', 'U', 'f', 'F']);
    let hexadecimal = digits.strip_prefix("0x").map(|digits| i64::from_str_radix(digits, 16).is_ok());
    let (ty, known) = match constant.ty.as_str() {
        "uint" => ("u32", hexadecimal.unwrap_or_else(|| digits.parse::<u32>().is_ok())),
        "int" => ("i32", hexadecimal.unwrap_or_else(|| digits.parse::<i32>().is_ok())),
        _ => ("f32", digits.parse::<f32>().is_ok()),
    };
    // A value that ends in F may be hexadecimal: only plain numbers lose a suffix.
    let value = if constant.value.starts_with("0x") { constant.value.trim_end_matches(['u', 'U']) } else { digits };
    if !known {
        return Err(Problem::new(format!("constant {} = {}", constant.name, constant.value))
            .at(constant.place.file.clone(), constant.place.line)
            .way_out("a constant that the host shares is one plain number"));
    }
    let comment = doc(constant.doc.as_deref().unwrap_or(&format!("`{}`.", constant.name)), "");
    Ok(format!("{comment}pub const {}: {ty} = {value};\n", constant.name))
}

fn structure(documented: &DocumentedStruct) -> Result<String, String> {
    let layout = &documented.layout;
    let name = pascal(&layout.name);
    let mut text = doc(documented.doc.as_deref().unwrap_or(&format!("`{}`.", layout.name)), "");
    text.push_str(&format!(
        "#[repr(C)]\n#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]\npub struct {name} {{\n"
    ));
    let mut asserts = String::new();
    let mut end = 0;
    for (field, comment) in layout.fields.iter().zip(&documented.field_docs) {
        if field.offset > end {
            let words = (field.offset - end) / 4;
            text.push_str(&format!("    /// Not used.\n    pub padding_{end}: [u32; {words}],\n"));
        }
        let plain = format!("`{}`.", field.ty.hlsl());
        let rust_name = snake(&field.name);
        text.push_str(&doc(comment.as_deref().unwrap_or(&plain), "    "));
        text.push_str(&format!("    pub {rust_name}: {},\n", field.ty.rust()?));
        asserts.push_str(&format!("    assert!(offset_of!({name}, {rust_name}) == {});\n", field.offset));
        end = field.offset + field.ty.bytes();
    }
    text.push_str(&format!("}}\nconst _: () = {{\n{asserts}    assert!(size_of::<{name}>() == {end});\n}};\n"));
    Ok(text)
}
