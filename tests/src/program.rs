//! The built program, and a scene that takes no time.

use std::{
    ffi::OsStr,
    path::{Path, PathBuf},
    process::{Command, Output},
    sync::OnceLock,
};

use serde_json::Value;
use tempfile::TempDir;

/// The program, in the profile of the tests: Cargo builds it before the tests of its package, which these are,
/// and puts it above them.
pub fn program() -> &'static Path {
    static PATH: OnceLock<PathBuf> = OnceLock::new();
    PATH.get_or_init(|| {
        let test = std::env::current_exe().expect("the test's own file");
        let folder = test.ancestors().nth(2).expect("cargo's folder of tests lies in that of programs");
        let path = folder.join(format!("brooklet{}", std::env::consts::EXE_SUFFIX));
        assert!(path.is_file(), "no program at {}: `cargo test -p brooklet` builds it", path.display());
        path
    })
}

/// A column of water of 64 particles in a box, with small pictures.
pub const SCENE: &str = r#"
summary = "A small column of water"
spacing_m = 0.05
[domain]
min_m = [1.0, 2.0, 3.0]
max_m = [1.4, 2.4, 3.4]
[[fluid]]
block = { min_m = [1.0, 2.0, 3.0], max_m = [1.2, 2.2, 3.2] }
[outputs]
images = 0
width_px = 64
height_px = 36
measure_every_steps = 2
"#;

/// `SCENE` without its water.
pub fn without_fluid() -> String {
    let (fluid, rest) = (SCENE.find("[[fluid]]").unwrap(), SCENE.find("[outputs]").unwrap());
    [&SCENE[..fluid], &SCENE[rest..]].concat()
}

/// A folder of its own with the scene in it, to run the program in.
pub struct Workshop {
    folder: TempDir,
}

impl Default for Workshop {
    fn default() -> Self {
        Self::new()
    }
}

impl Workshop {
    /// An empty folder but for `scene.toml`.
    pub fn new() -> Self {
        let folder = tempfile::tempdir().expect("a temporary folder");
        std::fs::write(folder.path().join("scene.toml"), SCENE).expect("the scene is written");
        Self { folder }
    }

    /// A path in the folder.
    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// The program, about to be started in the folder.
    pub fn command(&self, arguments: impl IntoIterator<Item = impl AsRef<OsStr>>) -> Command {
        let mut command = Command::new(program());
        command.current_dir(self.folder.path()).args(arguments);
        // Mesa looks for a Wayland display there, and complains where the variable is not set.
        command.env("XDG_RUNTIME_DIR", self.folder.path());
        // The program has nobody who listens to the validation layers, so they would only cost.
        command.env_remove("BROOKLET_VALIDATION");
        command
    }

    /// Runs the program to its end.
    pub fn run(&self, arguments: &[&str]) -> Ended {
        Ended::new(self.command(arguments).output().expect("the program starts"))
    }

    /// Runs the program, which has to succeed.
    pub fn succeed(&self, arguments: &[&str]) -> Ended {
        let ended = self.run(arguments);
        assert_eq!(ended.code, Some(0), "{arguments:?}: {}", ended.stderr);
        ended
    }

    /// Reads a JSON file of the folder.
    pub fn json(&self, name: &str) -> Value {
        let text = std::fs::read_to_string(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
        serde_json::from_str(&text).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// Whether a file of the folder exists.
    pub fn has(&self, name: &str) -> bool {
        self.path(name).exists()
    }
}

/// A finished run of the program.
pub struct Ended {
    /// Its exit code; none if a signal ended it.
    pub code: Option<i32>,
    /// Its standard output.
    pub stdout: String,
    /// Its standard error.
    pub stderr: String,
}

impl Ended {
    /// Takes what the system knows of it.
    pub fn new(output: Output) -> Self {
        Self {
            code: output.status.code(),
            stdout: String::from_utf8_lossy(&output.stdout).into_owned(),
            stderr: String::from_utf8_lossy(&output.stderr).into_owned(),
        }
    }

    /// Its standard output as JSON.
    pub fn json(&self) -> Value {
        serde_json::from_str(&self.stdout).unwrap_or_else(|error| panic!("{error} in {:?}", self.stdout))
    }
}
