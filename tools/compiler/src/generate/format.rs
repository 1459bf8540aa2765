//! Runs rustfmt over what is generated, so that `cargo fmt --check` agrees.

use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Stdio};

use crate::cache::keep;
use crate::hash;
use crate::problem::Problem;

/// A rustfmt with the settings of the folder that is written to.
pub struct Formatter {
    /// Where rustfmt looks for its settings.
    pub folder: PathBuf,
    /// Where formatted texts are kept, by hash; `None` formats everything anew.
    pub cache: Option<PathBuf>,
}

impl Formatter {
    /// A text, formatted.
    pub fn formatted(&self, text: &str) -> Result<String, Problem> {
        let settings: String = self
            .folder
            .ancestors()
            .flat_map(|folder| ["rustfmt.toml", ".rustfmt.toml"].map(|name| folder.join(name)))
            .filter_map(|path| std::fs::read_to_string(path).ok())
            .collect();
        let name = hash::of_bytes(format!("{settings}\0{text}").as_bytes());
        let kept = self.cache.as_ref().map(|cache| cache.join(format!("{name}.rs")));
        if let Some(text) = kept.as_ref().and_then(|kept| std::fs::read_to_string(kept).ok()) {
            return Ok(text);
        }
        let formatted = self.run(text)?;
        if let Some(kept) = kept {
            keep(&kept, formatted.as_bytes());
        }
        Ok(formatted)
    }

    fn run(&self, text: &str) -> Result<String, Problem> {
        let problem = |what: String| Problem::new(format!("rustfmt: {what}")).way_out("rustup component add rustfmt");
        let mut child = Command::new("rustfmt")
            .args(["--edition", "2024", "--emit", "stdout", "--quiet"])
            .current_dir(&self.folder)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .map_err(|error| problem(error.to_string()))?;
        if let Some(mut input) = child.stdin.take() {
            input.write_all(text.as_bytes()).map_err(|error| problem(error.to_string()))?;
        }
        let run = child.wait_with_output().map_err(|error| problem(error.to_string()))?;
        if !run.status.success() {
            return Err(problem(String::from_utf8_lossy(&run.stderr).trim().to_owned()));
        }
        Ok(String::from_utf8_lossy(&run.stdout).into_owned())
    }
}
