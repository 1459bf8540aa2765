//! The repository keeps its own rules: one GPU backend, the packages and rooms agreed on, the
//! direction of dependencies, licences, and files that are right on anybody's machine.
//!
//! Every check is a function over plain data that returns what is wrong; `checks_fail` feeds each
//! of them something wrong.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::{Path, PathBuf},
    process::Command,
};

use cargo_metadata::{CargoOpt, DependencyKind, Metadata, MetadataCommand};

type Names = BTreeSet<String>;

/// What the checks need to know of one workspace member.
struct Member {
    name: String,
    license: Option<String>,
    rust_version: Option<String>,
    /// Members it builds on; a test's or an example's needs do not count.
    rooms: Names,
    /// Packages from outside, and the features asked of each (`default` included).
    packages: BTreeMap<String, Names>,
}

/// Which rooms each room may build on (DESIGN: dependencies run one way).
const ROOMS: &[(&str, &[&str])] = &[
    ("brooklet-kernels", &[]),
    ("brooklet-gpu", &["kernels"]),
    ("brooklet-shapes", &[]),
    ("brooklet-fluid", &["kernels", "gpu", "shapes"]),
    ("brooklet-render", &["kernels", "gpu", "shapes", "fluid"]),
    ("brooklet-bench", &["kernels", "gpu", "fluid", "render"]),
    ("brooklet-capture", &["gpu"]),
    ("brooklet-reference", &["kernels"]),
    ("brooklet-check", &["kernels", "gpu", "fluid", "render", "reference"]),
    ("brooklet-study", &["kernels", "gpu", "fluid", "render", "capture", "reference"]),
    ("brooklet-viewer", &["kernels", "gpu", "fluid", "render", "capture"]),
    // The window compiles a changed shader while it runs.
    ("brooklet", &["kernels", "gpu", "fluid", "render", "bench", "capture", "viewer", "check", "study", "compiler"]),
    ("brooklet-mobile", &["kernels", "gpu", "fluid", "render", "capture", "check", "viewer"]),
    ("brooklet-android", &["fluid", "capture", "mobile"]),
    (
        "brooklet-tests",
        &["kernels", "gpu", "shapes", "fluid", "render", "bench", "capture", "reference", "check", "study", "compiler"],
    ),
    // A broken generated file must never keep the shader compiler from being built.
    ("brooklet-compiler", &[]),
];

/// Rooms that must not reach a GPU, directly or through others.
const WITHOUT_GPU: &[&str] = &["brooklet-kernels", "brooklet-reference", "brooklet-shapes", "brooklet-compiler"];

/// The one package for each purpose, and packages that would be a second one.
const CHOSEN: &[(&str, &[&str])] = &[
    ("wgpu", &["ash", "vulkano", "glow", "metal", "opencl3", "cudarc"]),
    ("glam", &["nalgebra", "cgmath", "ultraviolet", "euclid", "vek"]),
    ("mcap", &["rosbag", "foxglove", "rerun"]),
];

const BACKENDS: &[&str] = &["dx12", "gles", "metal", "webgl", "webgpu", "angle", "vulkan-portability"];

const TOP_LEVEL: &[&str] = &[
    "Cargo.lock",
    "Cargo.toml",
    "LICENSE-APACHE",
    "LICENSE-MIT",
    "README.md",
    "app",
    "mobile",
    "shaders",
    "tests",
    "tools",
];

const INDEX: &str = "registry+https://github.com/rust-lang/crates.io-index";

const MAX_LINES: usize = 500;

/// `features` by package, as resolved: nothing but Vulkan may be compiled into wgpu.
fn other_backends(features: &BTreeMap<String, Names>) -> Vec<String> {
    let mut wrong = Vec::new();
    for package in ["wgpu", "wgpu-core", "wgpu-hal"] {
        let Some(features) = features.get(package) else {
            wrong.push(format!("{package} is not built"));
            continue;
        };
        if !features.contains("vulkan") {
            wrong.push(format!("{package} is built without vulkan"));
        }
        for backend in BACKENDS {
            if features.contains(*backend) {
                wrong.push(format!("{package} is built with {backend}"));
            }
        }
    }
    wrong
}

/// Features asked of wgpu hold on every platform, where the resolved ones are this machine's.
fn other_backends_asked(members: &[Member]) -> Vec<String> {
    let mut wrong = Vec::new();
    for member in members {
        for feature in member.packages.get("wgpu").into_iter().flatten() {
            if feature == "default" || BACKENDS.contains(&feature.as_str()) {
                wrong.push(format!("{} asks wgpu for {feature}", member.name));
            }
        }
    }
    wrong
}

fn wrong_packages(members: &[Member]) -> Vec<String> {
    let mut wrong = Vec::new();
    for (chosen, rivals) in CHOSEN {
        if !members.iter().any(|m| m.packages.contains_key(*chosen)) {
            wrong.push(format!("no room uses {chosen}"));
        }
        for member in members {
            for rival in rivals.iter().filter(|r| member.packages.contains_key(**r)) {
                wrong.push(format!("{} uses {rival} beside {chosen}", member.name));
            }
        }
    }
    wrong
}

fn wrong_directions(members: &[Member]) -> Vec<String> {
    let mut wrong = Vec::new();
    for member in members {
        let Some((_, allowed)) = ROOMS.iter().find(|(name, _)| *name == member.name) else {
            wrong.push(format!("{} is no room of the design", member.name));
            continue;
        };
        for room in &member.rooms {
            let short = room.strip_prefix("brooklet-").unwrap_or(room);
            if !allowed.contains(&short) {
                wrong.push(format!("{} builds on {room}", member.name));
            }
        }
    }
    wrong
}

fn rooms_that_reach_a_gpu(members: &[Member]) -> Vec<String> {
    fn reaches(members: &[Member], name: &str) -> bool {
        members.iter().filter(|m| m.name == name).any(|member| {
            member.packages.contains_key("wgpu") || member.rooms.iter().any(|room| reaches(members, room))
        })
    }
    WITHOUT_GPU.iter().filter(|name| reaches(members, name)).map(|name| format!("{name} reaches wgpu")).collect()
}

fn wrong_terms(members: &[Member]) -> Vec<String> {
    let mut wrong = Vec::new();
    for member in members {
        if member.license.as_deref() != Some("MIT OR Apache-2.0") {
            wrong.push(format!("{} has licence {:?}", member.name, member.license));
        }
        if member.rust_version.is_none() {
            wrong.push(format!("{} states no rust-version", member.name));
        }
    }
    wrong
}

/// `files` are relative to the top of the repository, with `/` between names.
fn wrong_places(files: &[(String, String)]) -> Vec<String> {
    let mut wrong = Vec::new();
    let tops: BTreeSet<&str> = files.iter().filter_map(|(file, _)| file.split('/').next()).collect();
    for top in &tops {
        if !TOP_LEVEL.contains(top) && !top.starts_with('.') {
            wrong.push(format!("{top} does not belong at the top"));
        }
    }
    for wanted in TOP_LEVEL {
        if !tops.contains(wanted) {
            wrong.push(format!("{wanted} is missing at the top"));
        }
    }
    for (file, _) in files {
        if file.starts_with("shaders/") && !file.starts_with("shaders/hlsl/") {
            wrong.push(format!("{file} is in shaders but not in shaders/hlsl"));
        }
    }
    wrong
}

/// Paths and hosts that exist on the machine of whoever wrote the file, and nowhere else.
fn machine_traces(files: &[(String, String)]) -> Vec<String> {
    // In two halves each, so that this file passes its own check.
    let paths = ["root", "home", "work", "farm", "tmp", "Users"].map(|top| format!("/{top}/"));
    let hosts = [
        ("index.", "crates.io"),
        ("static.", "crates.io"),
        ("deb.", "debian.org"),
        ("archive.", "ubuntu.com"),
        ("pypi", ".org"),
        ("files.", "pythonhosted.org"),
        ("registry.", "npmjs.org"),
    ]
    .map(|(host, domain)| format!("{host}{domain}"));
    let mut wrong = Vec::new();
    for (file, text) in files {
        for (number, line) in text.lines().enumerate() {
            let found =
                paths.iter().find(|path| names_a_path(line, path)).or(hosts.iter().find(|host| line.contains(*host)));
            if let Some(found) = found {
                wrong.push(format!("{file}:{} names {found}", number + 1));
            }
        }
    }
    wrong
}

/// True where `path` stands at the start of an absolute path, not inside a longer one.
fn names_a_path(line: &str, path: &str) -> bool {
    line.match_indices(path).any(|(at, _)| {
        let before = line[..at].chars().next_back();
        let after = line[at + path.len()..].chars().next();
        !before.is_some_and(|c| c.is_alphanumeric() || "_-.~*})".contains(c))
            && after.is_some_and(char::is_alphanumeric)
    })
}

fn long_files(files: &[(String, String)]) -> Vec<String> {
    files
        .iter()
        .filter(|(file, _)| {
            let written = !file.contains("/src/generated/");
            written && [".rs", ".hlsl", ".hlsli", ".compute", ".sh", ".py"].iter().any(|e| file.ends_with(e))
        })
        .map(|(file, text)| (file, text.lines().count()))
        .filter(|(_, lines)| *lines > MAX_LINES)
        .map(|(file, lines)| format!("{file} has {lines} lines, and {MAX_LINES} are allowed"))
        .collect()
}

fn wrong_sources(lock: &str) -> Vec<String> {
    lock.lines()
        .filter_map(|line| line.strip_prefix("source = "))
        .map(|source| source.trim_matches('"'))
        .filter(|source| *source != INDEX)
        .map(|source| format!("Cargo.lock takes a package from {source}"))
        .collect()
}

fn wrong_licence_texts(mit: &str, apache: &str) -> Vec<String> {
    let mut wrong = Vec::new();
    for (name, text, part) in [
        ("LICENSE-MIT", mit, "Permission is hereby granted, free of charge"),
        ("LICENSE-APACHE", apache, "Version 2.0, January 2004"),
    ] {
        for part in [part, "The Brooklet developers"] {
            if !text.contains(part) {
                wrong.push(format!("{name} does not say \"{part}\""));
            }
        }
    }
    wrong
}

fn top() -> PathBuf {
    let tests = Path::new(env!("CARGO_MANIFEST_DIR"));
    tests.parent().expect("tests/ is in the repository").into()
}

fn metadata() -> Metadata {
    // Only this platform's packages are sure to have been fetched, and a test needs no network.
    let rustc = Command::new("rustc").arg("-vV").output().unwrap();
    let version = String::from_utf8(rustc.stdout).unwrap();
    let host = version.lines().find_map(|line| line.strip_prefix("host: "));
    MetadataCommand::new()
        .manifest_path(top().join("Cargo.toml"))
        .features(CargoOpt::SomeFeatures(Vec::new()))
        .other_options(["--filter-platform".to_string(), host.unwrap().to_string()])
        .exec()
        .unwrap()
}

fn resolved_features(metadata: &Metadata) -> BTreeMap<String, Names> {
    let resolve = metadata.resolve.as_ref().unwrap();
    let nodes = resolve.nodes.iter();
    nodes
        .map(|node| {
            let features = node.features.iter().map(ToString::to_string);
            (metadata[&node.id].name.to_string(), features.collect())
        })
        .collect()
}

fn members(metadata: &Metadata) -> Vec<Member> {
    let mut members = Vec::new();
    for package in metadata.workspace_packages() {
        let mut member = Member {
            name: package.name.to_string(),
            license: package.license.clone(),
            rust_version: package.rust_version.as_ref().map(ToString::to_string),
            rooms: Names::new(),
            packages: BTreeMap::new(),
        };
        for dependency in &package.dependencies {
            if dependency.kind == DependencyKind::Development {
                continue;
            }
            if dependency.path.is_some() {
                member.rooms.insert(dependency.name.clone());
                continue;
            }
            let features = member.packages.entry(dependency.name.clone());
            let features = features.or_default();
            features.extend(dependency.features.iter().cloned());
            if dependency.uses_default_features {
                features.insert("default".into());
            }
        }
        members.push(member);
    }
    members
}

/// Every text file git would take, and binary ones with an empty text.
fn files() -> Vec<(String, String)> {
    let top = top();
    ignore::WalkBuilder::new(&top)
        .hidden(false)
        .require_git(false)
        .filter_entry(|entry| entry.file_name() != ".git")
        .build()
        .map(Result::unwrap)
        .filter(|entry| entry.file_type().is_some_and(|kind| kind.is_file()))
        .map(|entry| {
            let path = entry.path().strip_prefix(&top).unwrap();
            let name = path.to_str().unwrap().replace('\\', "/");
            let text = String::from_utf8(fs::read(entry.path()).unwrap());
            (name, text.unwrap_or_default())
        })
        .collect()
}

fn nothing(wrong: Vec<String>) {
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn only_the_vulkan_backend_is_compiled_in() {
    let metadata = metadata();
    nothing(other_backends(&resolved_features(&metadata)));
    nothing(other_backends_asked(&members(&metadata)));
}

#[test]
fn wgpu_glam_and_mcap_are_the_packages_used() {
    nothing(wrong_packages(&members(&metadata())));
}

#[test]
fn dependencies_run_one_way() {
    let members = members(&metadata());
    nothing(wrong_directions(&members));
    nothing(rooms_that_reach_a_gpu(&members));
}

#[test]
fn every_member_states_licence_and_rust_version() {
    nothing(wrong_terms(&members(&metadata())));
    let read = |name| fs::read_to_string(top().join(name)).unwrap();
    nothing(wrong_licence_texts(&read("LICENSE-MIT"), &read("LICENSE-APACHE")));
    nothing(wrong_sources(&read("Cargo.lock")));
}

#[test]
fn files_are_where_they_belong_and_right_on_any_machine() {
    let files = files();
    nothing(wrong_places(&files));
    nothing(machine_traces(&files));
    nothing(long_files(&files));
}

#[cfg(unix)]
#[test]
fn scripts_can_be_run() {
    use std::os::unix::fs::PermissionsExt;
    for script in ["tools/setup", "tools/demo", "tools/test", "tools/android", ".ci/run"] {
        let mode = fs::metadata(top().join(script)).unwrap().permissions();
        assert_eq!(mode.mode() & 0o111, 0o111, "{script} is not executable");
    }
}

mod checks_fail {
    use super::*;

    fn names(names: &[&str]) -> Names {
        names.iter().map(ToString::to_string).collect()
    }

    fn member(name: &str, rooms: &[&str], package: &str, features: &[&str]) -> Member {
        Member {
            name: name.into(),
            license: Some("MIT".into()),
            rust_version: None,
            rooms: names(rooms),
            packages: [(package.into(), names(features))].into(),
        }
    }

    fn file(name: &str, text: &str) -> Vec<(String, String)> {
        vec![(name.into(), text.into())]
    }

    #[test]
    fn on_another_backend() {
        let mut features: BTreeMap<_, _> =
            ["wgpu", "wgpu-core", "wgpu-hal"].map(|package| (package.into(), names(&["vulkan"]))).into();
        assert!(other_backends(&features).is_empty());
        features.insert("wgpu-hal".into(), names(&["vulkan", "gles"]));
        assert_eq!(other_backends(&features), ["wgpu-hal is built with gles"]);
        features.insert("wgpu-hal".into(), Names::new());
        assert_eq!(other_backends(&features), ["wgpu-hal is built without vulkan"]);
        for feature in ["default", "dx12"] {
            let members = [member("brooklet-gpu", &[], "wgpu", &["vulkan", feature])];
            assert_eq!(other_backends_asked(&members).len(), 1);
        }
    }

    #[test]
    fn on_a_second_package_for_one_purpose() {
        let members = ["wgpu", "glam", "mcap"].map(|used| member("brooklet", &[], used, &[]));
        assert!(wrong_packages(&members).is_empty());
        assert_eq!(wrong_packages(&members[1..]), ["no room uses wgpu"]);
        let rival = [member("brooklet", &[], "nalgebra", &[])];
        assert!(wrong_packages(&rival).contains(&"brooklet uses nalgebra beside glam".into()));
    }

    #[test]
    fn on_a_dependency_in_the_wrong_direction() {
        let gpu = member("brooklet-gpu", &["brooklet-fluid"], "wgpu", &[]);
        assert_eq!(wrong_directions(&[gpu]), ["brooklet-gpu builds on brooklet-fluid"]);
        let stranger = member("brooklet-extra", &[], "serde", &[]);
        assert_eq!(wrong_directions(&[stranger]).len(), 1);
        let members =
            [member("brooklet-reference", &["brooklet-gpu"], "glam", &[]), member("brooklet-gpu", &[], "wgpu", &[])];
        assert_eq!(rooms_that_reach_a_gpu(&members), ["brooklet-reference reaches wgpu"]);
    }

    #[test]
    fn on_missing_terms() {
        assert_eq!(wrong_terms(&[member("brooklet", &[], "serde", &[])]).len(), 2);
        assert_eq!(wrong_licence_texts("", "").len(), 4);
        let lock = "source = \"registry+https://mirror.example/index\"\n";
        assert_eq!(wrong_sources(lock).len(), 1);
        assert!(wrong_sources(&format!("source = \"{INDEX}\"\n")).is_empty());
    }

    #[test]
    fn on_files_in_the_wrong_place() {
        let mut files: Vec<_> = TOP_LEVEL.iter().map(|top| (top.to_string(), String::new())).collect();
        assert!(wrong_places(&files).is_empty());
        files.extend(file("notes.txt", ""));
        files.extend(file("shaders/glsl/a.glsl", ""));
        assert_eq!(wrong_places(&files).len(), 2);
        assert_eq!(wrong_places(&files[1..]).len(), 3);
    }

    #[test]
    fn on_traces_of_a_machine() {
        let home = ["/", "root", "/"].concat();
        assert_eq!(machine_traces(&file("a", &format!("see {home}x"))).len(), 1);
        assert_eq!(machine_traces(&file("a", &format!("see app{home}x"))).len(), 0);
        let host = ["deb.", "debian.org"].concat();
        assert_eq!(machine_traces(&file("a", &format!("from {host}"))), [format!("a:1 names {host}")]);
    }

    #[test]
    fn on_a_file_too_long() {
        let long = "x\n".repeat(MAX_LINES + 1);
        assert_eq!(long_files(&file("app/gpu/src/lib.rs", &long)).len(), 1);
        assert!(long_files(&file("app/kernels/src/generated/a.rs", &long)).is_empty());
        assert!(long_files(&file("a.rs", &long[2..])).is_empty());
    }
}
