//! The pinned DXC: found or fetched, and run.

mod fetch;

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::flags::FLAGS;
use crate::problem::{Place, Problem, Problems, io_problem};
use crate::source::Source;

/// The DXC whose bytes are committed.
pub const PINNED_VERSION: &str = "dxc 1.7 3435 d66bdf94";

/// Where a DXC was found.
#[derive(Clone, Debug)]
pub struct Dxc {
    program: PathBuf,
    /// The library of the wrapper that is built here; a whole `dxc` knows its own.
    library: Option<PathBuf>,
    version: String,
}

/// What is compiled to one module.
#[derive(Clone, Debug)]
pub struct Job<'a> {
    /// The flattened source.
    pub source: &'a Source,
    /// Name of the entry point.
    pub entry: &'a str,
    /// `cs_6_0`, or `cs_6_2` for 16-bit types; `vs_` and `ps_` likewise.
    pub profile: &'static str,
    /// `NAME` or `NAME=VALUE`.
    pub defines: &'a [String],
    /// How messages name it: the kernel and the keywords that are on.
    pub label: String,
    /// Where it is asked for: the place of an error that names none.
    pub place: Place,
}

/// A module as DXC made it, with what DXC warned of.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// SPIR-V words, little-endian.
    pub spirv: Vec<u8>,
    /// Warnings, as text.
    pub warnings: String,
}

impl Dxc {
    /// A pinned `dxc` from BROOKLET_DXC, the PATH or the Vulkan SDK, else the pinned one fetched
    /// into `target`/dxc. Another version is taken only if BROOKLET_DXC names it, or if nothing
    /// could be fetched; it compiles, but its bytes differ from the committed ones.
    pub fn find(target: &Path) -> Result<Self, Problem> {
        if let Some(program) = std::env::var_os("BROOKLET_DXC") {
            let dxc = Self::whole(PathBuf::from(&program)).ok_or_else(|| {
                Problem::new(format!("BROOKLET_DXC is {}, which does not run as a dxc", Path::new(&program).display()))
            })?;
            dxc.warn_unless_pinned();
            return Ok(dxc);
        }
        let sdk = std::env::var_os("VULKAN_SDK").map(|sdk| Path::new(&sdk).join("bin/dxc"));
        let mut others = Vec::new();
        for program in [Some(PathBuf::from("dxc")), sdk].into_iter().flatten() {
            match Self::whole(program) {
                Some(dxc) if dxc.is_pinned() => return Ok(dxc),
                Some(dxc) => others.push(dxc),
                None => {}
            }
        }
        match (fetch::fetched(target), others.into_iter().next()) {
            (Ok((program, library)), _) => {
                let version = version_of(&program, Some(&library)).ok_or_else(|| {
                    Problem::new(format!("{} does not run", program.display()))
                        .way_out("remove target/dxc and try again")
                })?;
                Ok(Self { program, library: Some(library), version })
            }
            (Err(problem), Some(other)) => {
                eprintln!("warning: {problem}");
                other.warn_unless_pinned();
                Ok(other)
            }
            (Err(problem), None) => Err(problem),
        }
    }

    /// A complete `dxc` program, if it runs.
    fn whole(program: PathBuf) -> Option<Self> {
        let version = version_of(&program, None)?;
        Some(Self { program, library: None, version })
    }

    /// What it calls itself.
    pub fn version(&self) -> &str {
        &self.version
    }

    /// Whether its bytes are the committed ones.
    pub fn is_pinned(&self) -> bool {
        self.version == PINNED_VERSION
    }

    fn warn_unless_pinned(&self) {
        if !self.is_pinned() {
            eprintln!(
                "warning: {} is {}, not the pinned {PINNED_VERSION}: what it makes is not to be committed",
                self.program.display(),
                self.version
            );
        }
    }

    /// Compiles one module; `scratch` is an existing folder for its input and output.
    pub fn compile(&self, job: &Job, scratch: &Path) -> Result<Compiled, Problems> {
        static NEXT: std::sync::atomic::AtomicU64 = std::sync::atomic::AtomicU64::new(0);
        let number = NEXT.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
        let stem = scratch.join(format!("{}-{number}", std::process::id()));
        let (input, output) = (stem.with_extension("hlsl"), stem.with_extension("spv"));
        let result = self.compile_files(job, &input, &output);
        let _ = std::fs::remove_file(&input);
        let _ = std::fs::remove_file(&output);
        result
    }

    fn compile_files(&self, job: &Job, input: &Path, output: &Path) -> Result<Compiled, Problems> {
        std::fs::write(input, &job.source.text).map_err(|error| io_problem("write", input, &error))?;
        let mut command = Command::new(&self.program);
        if let Some(library) = &self.library {
            command.env("BROOKLET_DXC_LIBRARY", library);
        }
        command.args(FLAGS).args(["-T", job.profile, "-E", job.entry, "-Fo"]).arg(output);
        if job.profile.ends_with("6_2") {
            command.arg("-enable-16bit-types");
        }
        for define in job.defines {
            command.arg(format!("-D{define}"));
        }
        let run = command.arg(input).output().map_err(|error| io_problem("run", &self.program, &error))?;
        let said = String::from_utf8_lossy(&run.stderr).into_owned();
        if !run.status.success() {
            return Err(problems_of(job, &said, run.status));
        }
        let spirv = std::fs::read(output).map_err(|error| io_problem("read", output, &error))?;
        Ok(Compiled { spirv, warnings: said })
    }
}

fn version_of(program: &Path, library: Option<&Path>) -> Option<String> {
    let mut command = Command::new(program);
    if let Some(library) = library {
        command.env("BROOKLET_DXC_LIBRARY", library);
    }
    let run = command.arg("--version").output().ok()?;
    let said = String::from_utf8_lossy(&run.stdout).trim().to_owned();
    if !run.status.success() {
        return None;
    }
    // The official program says `libdxcompiler.so: 1.7 - 1.7.2308.7 (d66bdf94)`.
    let pinned_commit = PINNED_VERSION.rsplit(' ').next().unwrap_or_default();
    if said.contains(pinned_commit) {
        return Some(PINNED_VERSION.to_owned());
    }
    (!said.is_empty()).then_some(said)
}

/// DXC's `file:line:column: error: message` lines as problems, each with its excerpt.
fn problems_of(job: &Job, said: &str, status: std::process::ExitStatus) -> Problems {
    let mut problems: Vec<Problem> = Vec::new();
    let mut skipping = false;
    for line in said.lines() {
        if let Some((file, number, message)) = error_line(line) {
            let (message, way_out) = match message.split_once(". Way out: ") {
                Some((message, way_out)) => (message, Some(way_out)),
                None => (message, None),
            };
            let mut problem = Problem::new(message).at(file, number).kernel(job.label.clone());
            problem.way_out = way_out.map(str::to_owned);
            problems.push(problem);
            skipping = false;
        } else if line.contains(": warning: ") {
            skipping = true;
        } else if let (Some(problem), false) = (problems.last_mut(), skipping)
            && problem.way_out.is_none()
        {
            problem.message.push_str(&format!("\n    {line}"));
        }
    }
    if problems.is_empty() {
        let what = if said.trim().is_empty() {
            format!("the compiler ended with {status} and said nothing")
        } else {
            said.trim().to_owned()
        };
        problems.push(Problem::new(what).at_place(Some(job.place.clone())).kernel(job.label.clone()));
    }
    Problems(problems)
}

fn error_line(line: &str) -> Option<(&str, u32, &str)> {
    let (place, message) = line.split_once(": error: ").or_else(|| line.split_once(": fatal error: "))?;
    let (rest, _column) = place.rsplit_once(':')?;
    let (file, number) = rest.rsplit_once(':')?;
    Some((file, number.parse().ok()?, message))
}
