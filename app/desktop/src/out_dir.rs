//! The folder a run writes to, and files that are there whole or not at all.

use std::{
    fmt, fs,
    io::{self, BufWriter, ErrorKind, Write},
    path::{Path, PathBuf},
};

use crate::failure::Failure;

/// A folder of the run's own.
pub struct OutDir {
    /// Where it is.
    pub path: PathBuf,
    /// What had to be created, outermost first.
    created: Vec<PathBuf>,
}

impl OutDir {
    /// Creates `wanted`, or, where that exists, the first free of `wanted-1`, `wanted-2` and so on:
    /// what an earlier run wrote is kept.
    pub fn create(wanted: &Path) -> Result<Self, Failure> {
        let refused = |why: &str| Failure::Input(format!("--out {}: {why}", wanted.display()));
        if wanted.file_name().is_none() {
            return Err(refused("name a folder of the run's own, which is created"));
        }
        // Without the slash at the end, behind which a number would be another folder's name.
        let wanted = &wanted.components().collect::<PathBuf>();
        if fs::metadata(wanted).is_ok_and(|found| !found.is_dir()) {
            return Err(refused("is a file; name a folder, which is created"));
        }
        let mut dir = Self { path: wanted.clone(), created: missing_parents(wanted) };
        dir.make(wanted).map_err(|(path, error)| {
            dir.remove();
            Failure::Input(format!("--out {}: cannot create the folder: {error}", path.display()))
        })?;
        Ok(dir)
    }

    fn make(&mut self, wanted: &Path) -> Result<(), (PathBuf, io::Error)> {
        if let Some(parent) = wanted.parent() {
            fs::create_dir_all(parent).map_err(|error| (parent.to_path_buf(), error))?;
        }
        for number in 0_u32.. {
            let path = match number {
                0 => wanted.to_path_buf(),
                _ => numbered(wanted, number),
            };
            match fs::create_dir(&path) {
                Ok(()) => {
                    self.created.push(path.clone());
                    self.path = path;
                    break;
                }
                Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
                Err(error) => return Err((path, error)),
            }
        }
        Ok(())
    }

    /// Takes it away again, as far as nothing is in it: the run did not begin.
    pub fn remove(&self) {
        for path in self.created.iter().rev() {
            // One that is not empty is somebody's.
            if fs::remove_dir(path).is_err() {
                break;
            }
        }
    }
}

/// The folders above `path` that are not there yet, outermost first.
fn missing_parents(path: &Path) -> Vec<PathBuf> {
    let above = path.ancestors().skip(1).filter(|above| !above.as_os_str().is_empty());
    let mut missing: Vec<PathBuf> = above.take_while(|above| !above.exists()).map(Path::to_path_buf).collect();
    missing.reverse();
    missing
}

fn numbered(wanted: &Path, number: u32) -> PathBuf {
    let mut name = wanted.as_os_str().to_os_string();
    name.push(format!("-{number}"));
    name.into()
}

/// Writes a file under a temporary name and renames it: nobody ever sees half of it.
pub fn write_file(path: &Path, content: &[u8]) -> Result<(), Failure> {
    write_with(path, |to| to.write_all(content))
}

/// [`write_file`] for what need not be in memory whole.
pub fn write_with(path: &Path, content: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Failure> {
    let write = || -> io::Result<()> {
        let mut file = temporary_beside(path)?;
        // Through the file itself: the other way, an error names the temporary file.
        let mut to = BufWriter::new(file.as_file_mut());
        content(&mut to)?;
        to.flush()?;
        drop(to);
        make_readable(file.as_file())?;
        file.persist(path)?;
        Ok(())
    };
    write().map_err(|error| Failure::stopped(format_args!("{}: cannot be written: {error}", path.display())))
}

/// That a file can be written at `path` later on, as far as that can be known; `option` asked for it.
pub fn check_writable(option: &str, path: &Path) -> Result<(), Failure> {
    let refused = |why: &dyn fmt::Display| Failure::Input(format!("{option} {}: {why}", path.display()));
    if path.is_dir() {
        return Err(refused(&"is a folder; name a file, which is created"));
    }
    temporary_beside(path).map(drop).map_err(|error| refused(&format_args!("cannot be written: {error}")))
}

fn temporary_beside(path: &Path) -> io::Result<tempfile::NamedTempFile> {
    let folder = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    // The library's own error names the temporary file.
    let made = tempfile::Builder::new().prefix(".brooklet-").tempfile_in(folder);
    made.map_err(|error| error.raw_os_error().map_or(error, io::Error::from_raw_os_error))
}

/// A temporary file is its owner's alone; a result is for whoever the folder is for.
pub fn make_readable(file: &fs::File) -> io::Result<()> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        file.set_permissions(fs::Permissions::from_mode(0o644))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_there_is_kept() {
        let folder = tempfile::tempdir().unwrap();
        let wanted = folder.path().join("deep/out");
        let first = OutDir::create(&wanted).unwrap().path;
        assert_eq!(first, wanted);
        write_file(&first.join("a.txt"), b"first").unwrap();
        assert_eq!(OutDir::create(&wanted).unwrap().path, folder.path().join("deep/out-1"));
        assert_eq!(OutDir::create(&folder.path().join("deep/out/")).unwrap().path, folder.path().join("deep/out-2"));
        assert_eq!(fs::read(first.join("a.txt")).unwrap(), b"first");
    }

    #[test]
    fn a_folder_that_cannot_be_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        write_file(&file, b"").unwrap();
        for wrong in [file.join("out"), file.clone(), PathBuf::from("..")] {
            let Err(Failure::Input(text)) = OutDir::create(&wrong) else { panic!("{} is created", wrong.display()) };
            assert!(text.contains("--out ") && text.contains(&*wrong.parent().unwrap().to_string_lossy()), "{text}");
        }
    }

    #[test]
    fn a_run_that_did_not_begin_leaves_no_folder() {
        let folder = tempfile::tempdir().unwrap();
        let deep = folder.path().join("deep/deeper/out");
        OutDir::create(&deep).unwrap().remove();
        assert!(!folder.path().join("deep").exists());
        let dir = OutDir::create(&deep).unwrap();
        write_file(&folder.path().join("deep/note"), b"mine").unwrap();
        dir.remove();
        assert!(!folder.path().join("deep/deeper").exists() && folder.path().join("deep/note").exists());
    }

    #[test]
    fn a_file_is_whole_or_absent() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("summary.json");
        write_file(&path, b"{}").unwrap();
        write_file(&path, b"{\"again\": 1}").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"{\"again\": 1}");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "no file is left behind");
        assert!(write_file(&folder.path().join("no/summary.json"), b"").is_err());
    }
}
