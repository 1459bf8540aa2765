//! Fetches the pinned DXC into `target/dxc`: the library and headers that a source package on PyPI
//! carries, and a small `dxc` program built around them. Nobody needs a GPU vendor's or a Vulkan
//! SDK for it, and nothing of it is committed.

use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::Command;

use sha2::{Digest, Sha256};

use crate::problem::{Problem, io_problem};

const PACKAGE: &str = "compushady";
const VERSION: &str = "0.17.5";
const SHA256: &str = "5052caf9e955d8e7a48e22f536e82b44b72e83af46e824a9e99157c7809de691";
const WRAPPER: &str = include_str!("../../dxc/dxc.cpp");

/// Program and library of the fetched DXC; fetches and builds it unless it is there already.
/// Several processes may ask at once: one works, the others wait for its lock.
pub fn fetched(target: &Path) -> Result<(PathBuf, PathBuf), Problem> {
    let folder = target.join("dxc");
    // Another wrapper is another folder, so that an old cache is never mistaken for a new one.
    let wrapper = crate::hash::hex(&Sha256::digest(WRAPPER))[..12].to_owned();
    let program = folder.join(format!("dxc-{wrapper}"));
    let library = folder.join(library_name()?);
    if program.is_file() && library.is_file() {
        return Ok((program, library));
    }
    std::fs::create_dir_all(&folder).map_err(|error| io_problem("create", &folder, &error))?;
    let lock_path = folder.join("lock");
    let lock = File::create(&lock_path).map_err(|error| io_problem("create", &lock_path, &error))?;
    lock.lock().map_err(|error| io_problem("lock", &lock_path, &error))?;
    if !program.is_file() || !library.is_file() {
        let headers = unpacked(&folder)?;
        build_wrapper(&headers, &program)?;
    }
    Ok((program, library))
}

fn library_name() -> Result<&'static str, Problem> {
    Ok(match (std::env::consts::OS, std::env::consts::ARCH) {
        ("linux", "x86_64") => "libdxcompiler_x86_64.so.3.7",
        ("linux", "aarch64") => "libdxcompiler_aarch64.so.3.7",
        ("linux", "arm") => "libdxcompiler_armv7l.so.3.7",
        ("macos", _) => "libdxcompiler.3.7.dylib",
        (os, arch) => {
            return Err(Problem::new(format!("no pinned DXC for {os} on {arch}"))
                .way_out("install a Vulkan SDK and set BROOKLET_DXC to its dxc"));
        }
    })
}

/// Fetches and unpacks the package, unless that was done before; gives the folder of its headers.
fn unpacked(folder: &Path) -> Result<PathBuf, Problem> {
    let inside = format!("{PACKAGE}-{VERSION}/{PACKAGE}/backends");
    let headers = folder.join(&inside);
    let library = folder.join(library_name()?);
    if library.is_file() && headers.join("dxcapi.h").is_file() && headers.join("WinAdapter.h").is_file() {
        return Ok(headers);
    }
    let archive = folder.join(format!("{PACKAGE}-{VERSION}.tar.gz"));
    if !verified(&archive) {
        eprintln!("fetching DXC ({PACKAGE} {VERSION}, 67 MB) into {}", folder.display());
        download(folder, &archive)?;
    }
    run(Command::new("tar")
        .arg("-xzf")
        .arg(&archive)
        .arg("-C")
        .arg(folder)
        .args(["dxcapi.h", "WinAdapter.h", library_name()?].map(|name| format!("{inside}/{name}"))))?;
    std::fs::rename(headers.join(library_name()?), &library).map_err(|error| io_problem("write", &library, &error))?;
    let _ = std::fs::remove_file(&archive);
    Ok(headers)
}

fn verified(archive: &Path) -> bool {
    std::fs::read(archive).is_ok_and(|bytes| crate::hash::hex(&Sha256::digest(bytes)) == SHA256)
}

/// By curl or wget from the package index this machine names, or by pip, which knows more ways to an
/// index (and the public one) but runs the package's own set-up program first. The archive counts
/// only with the pinned hash.
fn download(folder: &Path, archive: &Path) -> Result<(), Problem> {
    let mut said = Vec::new();
    for way in [by_index, by_pip] {
        match way(folder, archive) {
            Ok(()) if verified(archive) => return Ok(()),
            Ok(()) => said.push("what came is not the pinned package (SHA-256 differs)".to_owned()),
            Err(problem) => said.push(problem.message),
        }
        let _ = std::fs::remove_file(archive);
    }
    Err(Problem::new(format!("the pinned DXC could not be fetched: {}", said.join("; ")))
        .way_out(format!("install python3-pip, or put {PACKAGE}-{VERSION}.tar.gz from PyPI into {}", folder.display())))
}

fn by_index(folder: &Path, archive: &Path) -> Result<(), Problem> {
    let index = index_address().ok_or_else(|| Problem::new("this machine's settings name no package index"))?;
    let page = folder.join("index.html");
    fetch_address(&format!("{}/{PACKAGE}/", index.trim_end_matches('/')), &page)?;
    let text = std::fs::read_to_string(&page).map_err(|error| io_problem("read", &page, &error))?;
    let _ = std::fs::remove_file(&page);
    let file = format!("{PACKAGE}-{VERSION}.tar.gz");
    let address = text
        .split(['"', '\''])
        .find(|part| part.split('#').next().unwrap_or(part).ends_with(&file))
        .and_then(|part| part.split('#').next())
        .ok_or_else(|| Problem::new(format!("the package index names no {file}")))?;
    let address = joined_address(&format!("{}/{PACKAGE}/", index.trim_end_matches('/')), address);
    fetch_address(&address, archive)
}

/// The package index that this machine is set to use, as pip would find it.
fn index_address() -> Option<String> {
    if let Ok(address) = std::env::var("PIP_INDEX_URL") {
        return Some(address);
    }
    let home = std::env::var("HOME").unwrap_or_default();
    let named = std::env::var("PIP_CONFIG_FILE").unwrap_or_default();
    for path in
        [named, format!("{home}/.config/pip/pip.conf"), format!("{home}/.pip/pip.conf"), "/etc/pip.conf".to_owned()]
    {
        let text = std::fs::read_to_string(path).unwrap_or_default();
        let set = text.lines().find_map(|line| {
            let (key, value) = line.split_once('=')?;
            (key.trim() == "index-url").then(|| value.trim().to_owned())
        });
        if set.is_some() {
            return set;
        }
    }
    None
}

/// `link` as found on `page`: whole, from the host's root, or relative.
fn joined_address(page: &str, link: &str) -> String {
    if link.contains("://") {
        return link.to_owned();
    }
    let host_end =
        page.find("://").and_then(|start| page[start + 3..].find('/').map(|end| start + 3 + end)).unwrap_or(page.len());
    match link.strip_prefix('/') {
        Some(path) => format!("{}/{path}", &page[..host_end]),
        None => format!("{page}{link}"),
    }
}

fn fetch_address(address: &str, to: &Path) -> Result<(), Problem> {
    let curl = run(Command::new("curl")
        .args(["--fail", "--silent", "--show-error", "--location", "--output"])
        .arg(to)
        .arg(address));
    curl.or_else(|_| run(Command::new("wget").arg("--quiet").arg("-O").arg(to).arg(address)))
}

fn by_pip(folder: &Path, _archive: &Path) -> Result<(), Problem> {
    run(Command::new("python3")
        .args(["-m", "pip", "download", "--no-deps", "--no-binary", ":all:", "-d"])
        .arg(folder)
        .arg(format!("{PACKAGE}=={VERSION}")))
}

fn build_wrapper(headers: &Path, program: &Path) -> Result<(), Problem> {
    let source = program.with_extension("cpp");
    std::fs::write(&source, WRAPPER).map_err(|error| io_problem("write", &source, &error))?;
    let unfinished = program.with_extension("unfinished");
    run(Command::new(std::env::var("CXX").unwrap_or_else(|_| "g++".to_owned()))
        .args(["-std=c++17", "-O1", "-fms-extensions", "-Wno-attributes", "-I"])
        .arg(headers)
        .arg(&source)
        .arg("-o")
        .arg(&unfinished)
        .arg("-ldl"))
    .map_err(|problem| problem.way_out("install a C++ compiler (Debian: g++)"))?;
    std::fs::rename(&unfinished, program).map_err(|error| io_problem("write", program, &error))
}

fn run(command: &mut Command) -> Result<(), Problem> {
    let name = command.get_program().to_string_lossy().into_owned();
    let run = command.output().map_err(|error| Problem::new(format!("{name}: {error}")))?;
    if run.status.success() {
        return Ok(());
    }
    let said = String::from_utf8_lossy(&run.stderr);
    let last = said.lines().rfind(|line| !line.trim().is_empty());
    Err(Problem::new(format!("{name}: {}", last.unwrap_or("it failed and said nothing"))))
}
