//! The shader compiler on shaders of others: Unity's ways compile unchanged, what cannot be carried
//! over is refused with file, line and the way out, and nothing half-made is ever written.

use std::path::{Path, PathBuf};
use std::process::Command;

use brooklet_compiler::problem::Problem;
use brooklet_compiler::reflect::{Kind, reflect};
use brooklet_compiler::{Places, Report, compile::parsed};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// A folder of shaders, made of (path, text), beside an empty output folder.
struct Trial {
    folder: tempfile::TempDir,
}

impl Trial {
    fn new(files: &[(&str, &str)]) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let trial = Self { folder };
        for (path, text) in files {
            trial.write(path, text);
        }
        trial
    }
    fn write(&self, path: &str, text: &str) {
        let path = self.folder.path().join("shaders").join(path);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }
    fn out(&self) -> PathBuf {
        self.folder.path().join("out")
    }
    fn places(&self) -> Places {
        Places {
            shaders: self.folder.path().join("shaders"),
            out: self.out(),
            parts: Vec::new(),
            target: Places::below(&root()).target,
        }
    }
    fn build(&self) -> Result<Report, Vec<Problem>> {
        brooklet_compiler::build(&self.places()).map_err(|problems| problems.0)
    }
    fn built(&self) -> Report {
        self.build().unwrap_or_else(|problems| panic!("{}", problems[0]))
    }
    /// The first of the problems, which must be at `file`:`line`.
    fn refused(&self, file: &str, line: u32) -> Problem {
        let problems = match self.build() {
            Ok(_) => panic!("it was not refused"),
            Err(problems) => problems,
        };
        assert!(!self.out().join("manifest.json").exists(), "something was written");
        let problem = problems.into_iter().next().unwrap();
        let place = problem.place.clone().unwrap_or_else(|| panic!("no place: {problem}"));
        assert!(place.file.ends_with(file), "{problem}");
        assert_eq!(place.line, line, "{problem}");
        problem
    }
}

/// A file with one kernel that reads `positions[0]` of the given declaration.
fn one_kernel(declarations: &str, body: &str) -> String {
    format!(
        "#pragma kernel Trial\n{declarations}\nRWStructuredBuffer<float4> result;\n\
         [numthreads(64, 1, 1)]\nvoid Trial(uint3 id : SV_DispatchThreadID)\n{{\n    {body}\n}}\n"
    )
}

#[test]
fn unity_files_compile_unchanged() {
    let unity = root().join("tests/unity");
    let flock = std::fs::read(unity.join("Flock.compute")).unwrap();
    assert!(flock.starts_with(b"\xef\xbb\xbf"), "the fixture lost its byte-order mark");
    assert!(flock.windows(2).any(|pair| pair == b"\r\n"), "the fixture lost its CRLF");
    let trial = Trial::new(&[]);
    let report = brooklet_compiler::build(&Places { shaders: unity, ..trial.places() })
        .unwrap_or_else(|problems| panic!("{problems}"));
    assert_eq!(report.variants, 14);
    // Sum has no use for the keywords of its file, Apply for all.
    assert_eq!(report.modules, 9);
    let rust = |name: &str| std::fs::read_to_string(trial.out().join("src/generated").join(name)).unwrap();
    let structs = rust("structs.rs");
    for expected in [
        "pub struct Boid {",
        "pub struct FlockGlobals {",
        "pub struct Settings {",
        "/// which flock it flies with\n    pub flock: u32,",
        "assert!(offset_of!(FlockGlobals, local_to_world) == 32);",
        "pub weights: [[f32; 4]; 3],",
    ] {
        assert!(structs.contains(expected), "no {expected:?} in\n{structs}");
    }
    assert!(rust("flock.rs").contains("pub globals: Uniform<'a, FlockGlobals>"));
    assert!(rust("blur.rs").contains("pub weights: Option<Buf<'a, [f32; 2]>>"));
    compiles_as_crate(&trial);
}

/// Puts what was generated beside the hand-written part of app/kernels and checks it as a crate.
fn compiles_as_crate(trial: &Trial) {
    let kernels = root().join("app/kernels");
    let by_hand = ["build.rs", "src/lib.rs", "src/module.rs", "src/resource.rs", "src/spirv.rs", "src/binding.rs"];
    for name in by_hand {
        std::fs::copy(kernels.join(name), trial.out().join(name)).unwrap();
    }
    std::fs::copy(root().join("Cargo.lock"), trial.out().join("Cargo.lock")).unwrap();
    std::fs::write(
        trial.out().join("Cargo.toml"),
        "[package]\nname = \"trial\"\nedition = \"2024\"\n[dependencies]\nbytemuck = { version = \"1\", features = [\"derive\"] }\n\
         miniz_oxide = \"0.9\"\n[build-dependencies]\nminiz_oxide = \"0.9\"\n[workspace]\n",
    )
    .unwrap();
    let run = Command::new(env!("CARGO"))
        .args(["check", "--offline", "--quiet"])
        .current_dir(trial.out())
        .env("CARGO_TARGET_DIR", Places::below(&root()).target.join("unity-trial"))
        .output()
        .unwrap();
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
}

#[test]
fn a_float3_buffer_is_refused_with_its_line() {
    let text = one_kernel("\nStructuredBuffer<float3> positions;", "result[id.x] = positions[id.x].xyzx;");
    let problem = Trial::new(&[("Bad.compute", &text)]).refused("Bad.compute", 3);
    assert!(problem.message.contains("12 bytes apart in Unity, but 16"), "{problem}");
    assert!(problem.way_out.as_ref().unwrap().contains("float4"), "{problem}");
    assert_eq!(problem.kernels, ["Trial"]);
    // float4 in its place is taken.
    let text = text.replace("float3>", "float4>");
    Trial::new(&[("Good.compute", &text)]).built();
}

#[test]
fn a_struct_with_another_stride_than_unitys_is_refused() {
    let text = one_kernel(
        "struct Body { float3 at; float3 speed; };\nRWStructuredBuffer<Body> bodies;",
        "result[id.x] = bodies[id.x].at.xyzx;",
    );
    let problem = Trial::new(&[("Bad.compute", &text)]).refused("Bad.compute", 3);
    assert!(problem.message.contains("24 bytes apart in Unity, but 32"), "{problem}");
}

#[test]
fn hidden_padding_of_a_layout_is_refused_with_its_field() {
    let layout = "struct Good { float3 at; float mass; };\n\nstruct Bad\n{\n    float2 low;\n    float3 at;\n    float mass;\n    float2 end;\n};\n";
    let kernel = one_kernel("#include \"layout.hlsli\"", "result[id.x] = 0;");
    let trial = Trial::new(&[("layout.hlsli", layout), ("Trial.compute", &kernel)]);
    let problem = trial.refused("layout.hlsli", 6);
    assert!(problem.message.contains("field at of Bad"), "{problem}");
    assert!(problem.message.contains("gap of 8 bytes"), "{problem}");
    let array = "struct Bad\n{\n    uint4 head;\n    float weights[4];\n};\n";
    let trial = Trial::new(&[("layout.hlsli", array)]);
    let problem = trial.refused("layout.hlsli", 4);
    assert!(problem.message.contains("in a uniform buffer"), "{problem}");
    let end = "struct Bad\n{\n    float3 at;\n};\n";
    let trial = Trial::new(&[("layout.hlsli", end)]);
    assert!(trial.refused("layout.hlsli", 1).message.contains("behind its last field"));
}

#[test]
fn an_error_in_an_include_names_file_line_and_kernel() {
    let kernel = one_kernel("#include \"../shared/maths.hlsl\"", "result[id.x] = Twice(2.0);");
    let trial = Trial::new(&[
        ("shared/maths.hlsl", "\u{feff}// a comment\r\nfloat Twice(float x)\r\n{\r\n    return x * two;\r\n}\r\n"),
        ("grid/Trial.compute", &kernel),
    ]);
    let problem = trial.refused("shared/maths.hlsl", 4);
    assert!(problem.message.contains("two"), "{problem}");
    assert_eq!(problem.kernels, ["Trial"]);
    // Behind an include the file's own lines still count from its own start.
    trial.write("shared/maths.hlsl", "\n\n\nfloat Twice(float x) { return x * 2; }\n");
    trial.write("grid/Trial.compute", &kernel.replace("Twice(2.0)", "Thrice(2.0)"));
    let problem = trial.refused("grid/Trial.compute", 7);
    assert!(problem.message.contains("Thrice"), "{problem}");
}

#[test]
fn what_cannot_be_carried_over_is_refused() {
    for (declarations, body, line, message) in [
        ("#include \"UnityCG.cginc\"", "result[id.x] = 0;", 2, "Unity's own"),
        ("#include \"Missing.cginc\"", "result[id.x] = 0;", 2, "is neither beside"),
        ("#pragma geometry Geo", "result[id.x] = 0;", 2, "not supported"),
        ("\nRWTexture2D<float4> image;", "image[id.xy] = 1; result[id.x] = 0;", 3, "has no format"),
        (
            "\n[[vk::image_format(\"rg16f\")]] RWTexture2D<float2> image;",
            "image[id.xy] = 1; result[id.x] = 0;",
            3,
            "has format Rg16f",
        ),
        ("AppendStructuredBuffer<float4> list;", "list.Append(1); result[id.x] = 0;", 2, "hidden counter"),
        ("Buffer<float4> typed;", "result[id.x] = typed[id.x];", 2, "typed buffer"),
        ("Texture3D<float4> volume;", "result[id.x] = volume.Load(int4(id, 0));", 2, "not a plain Texture2D"),
        ("Texture2D<float4> many[4];", "result[id.x] = many[1].Load(int3(id));", 2, "array of resources"),
    ] {
        let text = one_kernel(declarations, body);
        let problem = Trial::new(&[("Bad.compute", &text)]).refused("Bad.compute", line);
        assert!(problem.message.contains(message), "{declarations}: {problem}");
        assert!(problem.way_out.is_some() || message == "is neither beside", "{declarations}: {problem}");
    }
    // With its format, a storage image is taken.
    let text = one_kernel(
        "[[vk::image_format(\"rgba16f\")]]\nRWTexture2D<float4> image;",
        "image[id.xy] = 1; result[id.x] = 0;",
    );
    Trial::new(&[("Good.compute", &text)]).built();
}

#[test]
fn a_kernel_beyond_the_floor_tier_must_say_so() {
    let wide = one_kernel("", "result[id.x] = 0;").replace("numthreads(64", "numthreads(512");
    let problem = Trial::new(&[("Wide.compute", &wide)]).refused("Wide.compute", 5);
    assert!(problem.message.contains("512 threads a group (at most 256)"), "{problem}");
    assert!(problem.way_out.as_ref().unwrap().contains("#pragma tier mobile"), "{problem}");
    Trial::new(&[("Wide.compute", &format!("#pragma tier mobile\n{wide}"))]).built();

    let shared = one_kernel("groupshared float4 rows[1025];", "rows[id.x] = 1; result[id.x] = rows[id.x + 1];");
    let problem = Trial::new(&[("Shared.compute", &shared)]).refused("Shared.compute", 5);
    assert!(problem.message.contains("16400 bytes of groupshared memory (at most 16384)"), "{problem}");

    let buffers: String = (0..8).map(|i| format!("StructuredBuffer<float4> buffer{i}; ")).collect();
    let sum: Vec<String> = (0..8).map(|i| format!("buffer{i}[0]")).collect();
    let many = one_kernel(&buffers, &format!("result[id.x] = {};", sum.join(" + ")));
    let problem = Trial::new(&[("Many.compute", &many)]).refused("Many.compute", 5);
    assert!(problem.message.contains("9 storage buffers (at most 8)"), "{problem}");
}

#[test]
fn unused_resources_leave_no_gap() {
    let text = one_kernel(
        "RWStructuredBuffer<uint> first;\nStructuredBuffer<float4> unused;\nRWStructuredBuffer<uint> second : register(u0);\nConstantBuffer<float4> scale : register(b0);",
        "second[id.x] = first[id.x]; result[id.x] = 1;",
    )
    .replace("\nConstantBuffer<float4> scale : register(b0);", "");
    let trial = Trial::new(&[("Trial.compute", &text)]);
    trial.built();
    let spirv = std::fs::read(trial.out().join("spirv/trial.spv")).unwrap();
    let bindings = reflect(&parsed(&spirv, "Trial").unwrap()).bindings;
    let mut names: Vec<&str> = bindings.iter().map(|binding| binding.name.as_str()).collect();
    let slots: Vec<u32> = bindings.iter().map(|binding| binding.slot).collect();
    assert_eq!(slots, [0, 1, 2]);
    names.sort_unstable();
    assert_eq!(names, ["first", "result", "second"]);
    assert!(bindings.iter().all(|binding| matches!(binding.kind, Kind::Storage { read_only: false, .. })));
}

#[test]
fn a_failing_kernel_leaves_everything_as_it_was() {
    let good = one_kernel("", "result[id.x] = 1;");
    let trial = Trial::new(&[("Good.compute", &good)]);
    trial.built();
    let spirv = trial.out().join("spirv/trial.spv");
    let before = std::fs::read(&spirv).unwrap();
    trial.write("Good.compute", &good.replace("= 1;", "= 2;"));
    trial.write("Bad.compute", "#pragma kernel Other\n[numthreads(1, 1, 1)] void Other() { nonsense }\n");
    let problems = trial.build().err().unwrap();
    assert_eq!(problems[0].kernels, ["Other"]);
    assert_eq!(std::fs::read(&spirv).unwrap(), before);
    assert!(!trial.out().join("spirv/other.spv").exists());
    // Without the failing file the change comes through, and what is gone is removed.
    std::fs::remove_file(trial.folder.path().join("shaders/Bad.compute")).unwrap();
    trial.write("Good.compute", &good.replace("= 1;", "= 2;").replace("Trial", "Renamed"));
    trial.built();
    assert!(!spirv.exists());
    assert_ne!(std::fs::read(trial.out().join("spirv/renamed.spv")).unwrap(), before);
    assert_eq!(trial.built().changed, Vec::<String>::new());
}

#[test]
fn builds_at_the_same_time_do_not_harm_one_another() {
    let trial = Trial::new(&[("Trial.compute", &one_kernel("", "result[id.x] = 3;"))]);
    std::thread::scope(|scope| {
        let builds: Vec<_> = (0..4).map(|_| scope.spawn(|| trial.build().is_ok())).collect();
        assert!(builds.into_iter().all(|build| build.join().unwrap()));
    });
    assert_eq!(trial.built().changed, Vec::<String>::new());
}

#[test]
fn two_kernels_of_one_name_are_refused() {
    let text = one_kernel("", "result[id.x] = 0;");
    let trial = Trial::new(&[("a.compute", &text), ("b.compute", &text)]);
    assert!(trial.refused("b.compute", 1).message.contains("a.compute"));
}

#[test]
fn a_kernel_without_a_function_is_refused_at_its_pragma() {
    let text = format!("\n#pragma multi_compile _ _ \n#pragma kernel Absent\n{}", one_kernel("", "result[id.x] = 0;"));
    let problem = Trial::new(&[("Bad.compute", &text)]).refused("Bad.compute", 3);
    assert_eq!(problem.kernels, ["Absent"]);
    assert!(problem.message.contains("missing entry point"), "{problem}");
}
