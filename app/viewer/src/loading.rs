//! Builds scenes on a thread of its own, so that the window never stands still.

use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread;
use std::time::Instant;

use brooklet_gpu::Gpu;

use crate::ViewerError;
use crate::viewer_scene::{SceneDesc, ViewerScene};

/// How far a scene is.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Progress {
    /// Parts that are done.
    pub done: usize,
    /// Parts in all; 0 if that is not known.
    pub all: usize,
    /// What is being done.
    pub what: String,
}

/// A scene in the making.
pub struct Loading {
    /// What it will be.
    pub desc: SceneDesc,
    /// How far it is.
    pub progress: Progress,
    /// Since when.
    pub begun: Instant,
    news: Receiver<News>,
    _builder: Builder,
}

/// The thread that builds. Nobody leaves before it is done: drivers crash where a program ends while they build.
struct Builder(Option<thread::JoinHandle<()>>);

impl Drop for Builder {
    fn drop(&mut self) {
        // One that panicked has said so by its silence.
        let _ = self.0.take().map(thread::JoinHandle::join);
    }
}

enum News {
    Progress(Progress),
    Done(Box<Result<ViewerScene, ViewerError>>),
}

impl Loading {
    /// Begins.
    ///
    /// # Errors
    /// If the system has no thread left.
    pub fn begin(gpu: &Gpu, desc: SceneDesc) -> Result<Self, ViewerError> {
        let (sender, news) = channel();
        let (gpu, wanted) = (gpu.clone(), desc.clone());
        let thread = thread::Builder::new()
            .name("loading".into())
            .spawn(move || build(&gpu, wanted, &sender))
            .map_err(|error| ViewerError::NoThread { reason: error.to_string() })?;
        let (progress, begun) = (Progress::default(), Instant::now());
        Ok(Self { desc, progress, begun, news, _builder: Builder(Some(thread)) })
    }

    /// The scene, or why there is none, once it is ready.
    pub fn poll(&mut self) -> Option<Result<ViewerScene, ViewerError>> {
        loop {
            match self.news.try_recv() {
                Ok(News::Progress(progress)) => self.progress = progress,
                Ok(News::Done(result)) => return Some(*result),
                Err(std::sync::mpsc::TryRecvError::Empty) => return None,
                Err(std::sync::mpsc::TryRecvError::Disconnected) => {
                    return Some(Err(ViewerError::NoThread { reason: "it ended early".into() }));
                }
            }
        }
    }
}

fn build(gpu: &Gpu, desc: SceneDesc, news: &Sender<News>) {
    // Where nobody listens any more, the window was closed or something else was opened.
    let mut tell = |done, all, what: &str| {
        let _ = news.send(News::Progress(Progress { done, all, what: what.to_owned() }));
    };
    let result = ViewerScene::build(gpu, desc, &mut tell);
    let _ = news.send(News::Done(Box::new(result)));
}
