//! A folder of shaders whose kernels get a crate of their own: it takes structs and keywords of the other crate
//! from there, makes only its own, and both are written or none.

use std::path::{Path, PathBuf};

use brooklet_compiler::{Part, Places, problem::Problem};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

const LAYOUT: &str = "struct Shared { float4 value; };\n";

/// A kernel that reads `Shared`, with lines above it.
fn kernel(name: &str, layout: &str, above: &str, body: &str) -> String {
    format!(
        "#include \"{layout}\"\n#pragma kernel {name}\n{above}\nStructuredBuffer<Shared> given;\n\
         RWStructuredBuffer<float4> result;\n[numthreads(64, 1, 1)]\n\
         void {name}(uint3 id : SV_DispatchThreadID)\n{{\n    {body}\n}}\n"
    )
}

const WALLS: &str = "#pragma multi_compile NARROW_WALLS WIDE_WALLS";
const CHOICE: &str = "#if WIDE_WALLS\nresult[id.x] = given[0].value;\n#else\nresult[id.x] = 1;\n#endif\n";

/// Shaders, two crates' folders beside them, and what they were compiled with.
struct Trial {
    folder: tempfile::TempDir,
}

impl Trial {
    fn new(extra: &str) -> Self {
        let trial = Self { folder: tempfile::tempdir().unwrap() };
        let product = kernel("Product", "layout.hlsli", WALLS, CHOICE);
        for (file, text) in [("layout.hlsli", LAYOUT), ("product.compute", &product), ("extra/extra.compute", extra)] {
            let path = trial.folder.path().join("shaders").join(file);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, text).unwrap();
        }
        trial
    }
    fn places(&self) -> Places {
        let below = |name: &str| self.folder.path().join(name);
        let parts = vec![Part { shaders: "extra".to_owned(), out: below("extra_crate") }];
        Places { shaders: below("shaders"), out: below("crate"), parts, target: Places::below(&root()).target }
    }
    fn refused(&self) -> Problem {
        let Err(problems) = brooklet_compiler::build(&self.places()) else { panic!("it was not refused") };
        for out in self.places().outs() {
            assert!(!out.join("manifest.json").exists(), "something was written to {}", out.display());
        }
        problems.0.into_iter().next().unwrap()
    }
}

fn names(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name());
    let mut names: Vec<String> = entries.map(|name| name.into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn a_part_makes_its_own_and_takes_the_rest_from_the_other_crate() {
    let above = format!(
        "{WALLS}\n#pragma multi_compile THIN_LINES THICK_LINES\nstruct Own {{ float4 more; }};\nStructuredBuffer<Own> owns;"
    );
    let body = format!("{CHOICE}#if THICK_LINES\nresult[id.x] += owns[0].more;\n#endif\n");
    let trial = Trial::new(&kernel("Extra", "../layout.hlsli", &above, &body));
    brooklet_compiler::build(&trial.places()).unwrap_or_else(|problems| panic!("{problems}"));
    let (product, extra) = (trial.places().out, trial.places().parts[0].out.clone());
    assert_eq!(names(&product.join("src/generated")), ["keywords.rs", "layout.rs", "mod.rs", "product.rs"]);
    assert_eq!(names(&extra.join("src/generated")), ["extra_extra.rs", "keywords.rs", "mod.rs", "structs.rs"]);
    assert_eq!(names(&product.join("spirv")), ["packs.txt", "product+narrow_walls.spv", "product+wide_walls.spv"]);
    assert_eq!(names(&extra.join("spirv")).len(), 4);
    let rust = std::fs::read_to_string(extra.join("src/generated/extra_extra.rs")).unwrap();
    let uses = |from: &str| {
        let (_, rest) = rust.split_once(&format!("use {from}::{{")).unwrap();
        rest.split_once('}').unwrap().0.to_owned()
    };
    assert!(uses("brooklet_kernels").contains("Shared") && uses("brooklet_kernels").contains("WallsKeyword"), "{rust}");
    assert!(uses("super").contains("Own") && uses("super").contains("LinesKeyword"), "{rust}");
    assert!(!rust.contains("use crate::"), "{rust}");
    let keywords = std::fs::read_to_string(extra.join("src/generated/keywords.rs")).unwrap();
    assert!(keywords.contains("enum LinesKeyword") && !keywords.contains("enum WallsKeyword"), "{keywords}");
    assert_eq!(brooklet_compiler::check(&trial.places()).unwrap(), Vec::<String>::new());
}

#[test]
fn a_part_that_disagrees_with_the_other_crate_is_refused_and_nothing_is_written() {
    let other_order = kernel("Extra", "../layout.hlsli", "#pragma multi_compile WIDE_WALLS NARROW_WALLS", CHOICE);
    assert!(Trial::new(&other_order).refused().message.contains("the enum WallsKeyword"));
    let same_name = kernel("Product", "../layout.hlsli", "", "result[id.x] = given[0].value;");
    assert!(Trial::new(&same_name).refused().message.contains("is also the name of what stands in"));
    let other_struct = kernel("Extra", "../layout.hlsli", "", "result[id.x] = given[0].value;")
        .replace("#include \"../layout.hlsli\"", "struct Shared { float2 value; };")
        .replace("given[0].value;", "given[0].value.xyxy;");
    assert!(Trial::new(&other_struct).refused().message.contains("struct Shared of given is placed differently"));
    let broken = kernel("Extra", "../layout.hlsli", "", "nonsense");
    assert_eq!(Trial::new(&broken).refused().kernels, ["Extra"]);
}
