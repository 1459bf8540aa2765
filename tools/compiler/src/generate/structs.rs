//! Host-visible structs, with their offsets asserted.

use crate::generate::{HEADER, doc};
use crate::layouts::DocumentedStruct;
use crate::naming::{pascal, snake};
use crate::problem::Problem;

/// The file of a shader file's structs.
pub fn file(source: &str, structs: &[DocumentedStruct]) -> Result<String, Problem> {
    let mut text = format!(
        "{HEADER} {source}.\n//! Host-visible structs of `{source}`.\n\nuse std::mem::{{offset_of, size_of}};\n\nuse bytemuck::{{Pod, Zeroable}};\n"
    );
    for documented in structs {
        text.push('\n');
        text.push_str(
            &structure(documented).map_err(|why| Problem::new(format!("struct {}: {why}", documented.layout.name)))?,
        );
    }
    Ok(text)
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
