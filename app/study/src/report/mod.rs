//! What a study found: one page of HTML that needs nothing beside it, and the same as CSV, JSON and MCAP.

mod capture;
mod deck;
mod heat;
mod html;
mod plot;
mod precision;
mod stability;
mod table;
mod validation;
mod work_precision;

pub use heat::Heat;
pub use html::whole_page;
pub use plot::{Line, Mark, PALETTE, Plot};

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::session::StudyError;
use crate::store::StoreError;
use crate::{Store, Study};

/// Name of the page.
pub const PAGE: &str = "report.html";

/// Where and with what it was found.
#[derive(Clone, Debug)]
pub struct Facts {
    /// Devices that ran it.
    pub devices: Vec<String>,
    /// Version and commit of the program.
    pub program: String,
    /// What a reader must know: parts that are missing, references computed anew.
    pub notes: Vec<String>,
}

/// The files of a report.
#[derive(Clone, Debug)]
pub struct Written {
    /// The page.
    pub page: PathBuf,
    /// Every task a row.
    pub csv: PathBuf,
    /// Everything.
    pub json: PathBuf,
    /// Step times and figures of every run.
    pub mcap: PathBuf,
}

/// The key plots, by name: what the page shows, as SVG.
///
/// # Errors
/// If the study names what there is not.
pub fn plots(study: &Study, store: &Store) -> Result<Vec<(String, String)>, StudyError> {
    let mut plots = Vec::new();
    if let Some(choice) = &study.error {
        plots.extend(work_precision::plots(choice, store)?);
        plots.extend(deck::plots(study.quick, store));
    }
    if study.validation {
        plots.extend(validation::plots(study.quick, store));
    }
    if study.stability {
        plots.extend(stability::plots(study.quick, store));
    }
    plots.retain(|(_, svg)| !svg.is_empty());
    Ok(plots)
}

/// Writes the report into `folder`; each file is there whole or not at all.
///
/// # Errors
/// If the study names what there is not, or a file cannot be written.
pub fn write(folder: &Path, study: &Study, store: &Store, facts: &Facts) -> Result<Written, StudyError> {
    let tasks = study.tasks()?;
    let written = Written {
        page: folder.join(PAGE),
        csv: folder.join("results.csv"),
        json: folder.join("results.json"),
        mcap: folder.join("runs.mcap"),
    };
    file(&written.csv, |to| table::csv(to, &tasks, store))?;
    file(&written.json, |to| table::json(to, &tasks, store, facts))?;
    file(&written.mcap, |to| capture::mcap(to, &tasks, store, facts))?;
    // Each plot alone, for a page of somebody's own.
    let plots_folder = folder.join("plots");
    fs::create_dir_all(&plots_folder)
        .map_err(|error| StoreError::File { path: plots_folder.display().to_string(), reason: error.to_string() })?;
    for (name, svg) in plots(study, store)? {
        file(&plots_folder.join(format!("{name}.svg")), |to| to.write_all(svg.as_bytes()))?;
    }
    if let Some(choice) = &study.error {
        let text = work_precision::solvers_markdown(choice, store)?;
        file(&folder.join("solvers.md"), |to| to.write_all(text.as_bytes()))?;
    }
    if study.precision {
        let text = precision::markdown(study.quick, store);
        file(&folder.join("precision.md"), |to| to.write_all(text.as_bytes()))?;
    }
    // The page last: where it is, the study is whole.
    let page = html::page(study, &tasks, store, facts)?;
    file(&written.page, |to| to.write_all(page.as_bytes()))?;
    Ok(written)
}

/// Writes a file under a temporary name and renames it.
fn file(path: &Path, write: impl FnOnce(&mut fs::File) -> io::Result<()>) -> Result<(), StudyError> {
    let folder = path.parent().unwrap_or(path);
    let made = || -> io::Result<()> {
        let mut file = tempfile::Builder::new().prefix(".brooklet-").tempfile_in(folder)?;
        write(file.as_file_mut())?;
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            file.as_file().set_permissions(fs::Permissions::from_mode(0o644))?;
        }
        file.persist(path)?;
        Ok(())
    };
    made().map_err(|error| {
        StoreError::File { path: path.display().to_string(), reason: format!("cannot be written: {error}") }.into()
    })
}
