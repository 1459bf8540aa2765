//! Files that are written beside the frames, each on a thread of its own.

use std::sync::mpsc::{Receiver, TryRecvError, channel};

use crate::messages::{Kind, Messages};

/// What is being written.
#[derive(Default)]
pub struct Jobs {
    running: Vec<Receiver<Result<String, String>>>,
}

impl Jobs {
    /// Begins one, which says at its end what was done, or why it was not.
    pub fn begin(&mut self, messages: &mut Messages, job: impl FnOnce() -> Result<String, String> + Send + 'static) {
        let (sender, receiver) = channel();
        let worker = std::thread::Builder::new().name("writing".into());
        // Nobody listens any more only where the window is closed.
        match worker.spawn(move || drop(sender.send(job()))) {
            Ok(_) => self.running.push(receiver),
            Err(error) => messages.notify(Kind::Error, format!("nothing can be written: {error}")),
        }
    }

    /// Says what is done; whether something is still under way.
    pub fn poll(&mut self, messages: &mut Messages) -> bool {
        self.running.retain(|job| match job.try_recv() {
            Ok(Ok(done)) => {
                messages.notify(Kind::Done, done);
                false
            }
            Ok(Err(reason)) => {
                messages.notify(Kind::Error, reason);
                false
            }
            Err(TryRecvError::Empty) => true,
            Err(TryRecvError::Disconnected) => false,
        });
        !self.running.is_empty()
    }

    /// Waits for all: the window is closed.
    pub fn finish(&mut self) -> Vec<Result<String, String>> {
        self.running.drain(..).filter_map(|job| job.recv().ok()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_job_says_is_said() {
        let (mut jobs, mut messages) = (Jobs::default(), Messages::default());
        jobs.begin(&mut messages, || Ok("written".into()));
        jobs.begin(&mut messages, || Err("the disk is full".into()));
        while jobs.poll(&mut messages) {
            std::thread::yield_now();
        }
        let said: Vec<_> = messages.latest().iter().map(|message| (message.kind, message.text.as_str())).collect();
        assert!(
            said.contains(&(Kind::Done, "written")) && said.contains(&(Kind::Error, "the disk is full")),
            "{said:?}"
        );
    }
}
