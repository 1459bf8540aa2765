//! Watches the shaders of a checkout, and compiles those that change while the window shows what they draw.

use std::{
    collections::BTreeMap,
    path::{Path, PathBuf},
    sync::mpsc::{Receiver, Sender, channel},
    time::{Duration, SystemTime},
};

use brooklet_compiler::{Recompiled, compile_below};
use brooklet_kernels::Tier;
use brooklet_viewer::NewModule;

/// Files are looked at so often.
const LOOK_EVERY: Duration = Duration::from_millis(400);

/// What came of a changed file.
pub type News = Result<Vec<NewModule>, String>;

/// Watches a folder.
pub struct Reload {
    news: Receiver<News>,
}

impl Reload {
    /// Watches `shaders`, `shaders/hlsl` of a checkout, from now on; none if there is no such folder, or no
    /// thread for it.
    pub fn watch(shaders: &Path) -> Option<Self> {
        if !shaders.is_dir() {
            return None;
        }
        let (sender, news) = channel();
        let folder = shaders.to_owned();
        let worker = std::thread::Builder::new().name("shaders".into());
        worker.spawn(move || look(&folder, &sender)).ok().map(|_| Self { news })
    }

    /// What there is to say, and to run.
    pub fn poll(&self) -> Option<News> {
        self.news.try_recv().ok()
    }
}

/// When each file was changed last.
type Times = BTreeMap<PathBuf, SystemTime>;

fn look(folder: &Path, news: &Sender<News>) {
    let mut known = times(folder);
    loop {
        std::thread::sleep(LOOK_EVERY);
        let now = times(folder);
        let changed: Vec<&PathBuf> =
            now.iter().filter(|(path, at)| known.get(*path) != Some(at)).map(|(path, _)| path).collect();
        for path in changed {
            if news.send(compile(folder, path)).is_err() {
                return;
            }
        }
        known = now;
    }
}

fn compile(folder: &Path, path: &Path) -> News {
    let compiled = compile_below(folder, path).map_err(|problems| problems.to_string())?;
    Ok(compiled.into_iter().map(module).collect())
}

fn module(compiled: Recompiled) -> NewModule {
    let Recompiled { name, spirv, shared_bytes, tier, .. } = compiled;
    let tier = match tier {
        brooklet_compiler::tier::Tier::Desktop => Tier::Desktop,
        brooklet_compiler::tier::Tier::Mobile => Tier::Mobile,
        brooklet_compiler::tier::Tier::Floor => Tier::Floor,
    };
    NewModule { name, spirv, shared_bytes, tier }
}

fn times(folder: &Path) -> Times {
    let mut found = Times::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
            let (path, Ok(about)) = (entry.path(), entry.metadata()) else { continue };
            if about.is_dir() {
                folders.push(path);
            } else if let Ok(at) = about.modified() {
                found.insert(path, at);
            }
        }
    }
    found
}
