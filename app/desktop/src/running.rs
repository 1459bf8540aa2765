//! A run under way: steps, and what is written in between.

use std::path::{Path, PathBuf};

use brooklet_fluid::{FrameRequest, Scene, Session};
use brooklet_render::FramePasses;
use indicatif::ProgressBar;

use crate::{failure::Failure, interrupt::Interrupt, pictures::Picture, ply, recorder::Recorder, summary::Files};

/// A run under way.
pub struct Running<'a> {
    /// Takes the session's reports.
    pub recorder: Recorder,
    /// The scene.
    pub scene: &'a Scene,
    /// The folder.
    pub out: &'a Path,
    /// Steps to do.
    pub steps: u64,
    /// Steps handed to the GPU.
    pub done: u64,
    /// Steps at whose end a picture is due, in order.
    pub images: Vec<u64>,
    /// What simulates.
    pub session: Session,
    /// The picture's, if there is one.
    pub passes: Option<FramePasses>,
    /// Whether particles are written beside the pictures and at the end.
    pub writes_particles: bool,
    /// What was written, and what could not be.
    pub files: Files,
    /// Why it could not, once for all of a kind.
    pub troubles: Vec<String>,
    /// Whether the first picture was told.
    pub told_first: bool,
}

impl Running<'_> {
    /// All steps, or those before Ctrl-C.
    pub fn all(&mut self, interrupt: &Interrupt, bar: &ProgressBar) -> Result<(), Failure> {
        let result = self.steps(interrupt, bar);
        // What came back before a failure belongs to the capture as well.
        match self.session.finish() {
            Ok(reports) => self.recorder.take(&reports),
            Err(error) => {
                self.recorder.take(&self.session.reports());
                result?;
                return Err(Failure::stopped(error));
            }
        }
        result
    }

    fn steps(&mut self, interrupt: &Interrupt, bar: &ProgressBar) -> Result<(), Failure> {
        while self.done < self.steps && !interrupt.is_pressed() {
            self.step(self.done + 1)?;
            bar.inc(1);
            // Whoever watches need not wait for the end to look.
            if let [first] = self.files.images.as_slice()
                && !std::mem::replace(&mut self.told_first, true)
            {
                bar.println(format!("first picture: {first}"));
            }
            if let Some(stats) = self.recorder.measured.last {
                bar.set_message(match stats.has_density {
                    true => format!("density error {:.2} %", 100.0 * stats.density_error.mean),
                    false => format!("largest speed {:.2} m/s", stats.max_speed_m_s),
                });
            }
        }
        Ok(())
    }

    /// Step number `step`, from 1, with what is due at its end.
    fn step(&mut self, step: u64) -> Result<(), Failure> {
        let is_last = step == self.steps;
        let every = u64::from(self.scene.outputs.measure_every_steps);
        let measures = every > 0 && (is_last || step.is_multiple_of(every));
        let image = self.images.binary_search(&step).ok();

        let draw = self.passes.as_ref().filter(|_| image.is_some()).map(|passes| passes.draw.id());
        let request = FrameRequest { steps: 1, measure: measures, then: draw.as_slice(), ..FrameRequest::default() };
        self.session.submit(&request).map_err(Failure::stopped)?;
        self.done = step;
        self.recorder.take(&self.session.reports());

        if let (Some(number), Some(picture)) = (image, self.passes.as_ref().map(Picture::of)) {
            let path = self.numbered("frame", number, "png");
            let rgba = picture.read(self.session.engine_mut())?;
            let written = picture.save(&path, &rgba);
            self.note(path, written, |files| &mut files.images);
        }
        if self.writes_particles && (image.is_some() || is_last) {
            let number = image.unwrap_or(self.images.len());
            let path = self.numbered("particles", number, "ply");
            let particles = self.session.read_particles().map_err(Failure::stopped)?;
            let written = ply::write(&path, &particles.positions, &particles.velocities, self.scene.domain.min_m);
            self.note(path, written, |files| &mut files.particles);
        }
        Ok(())
    }

    fn numbered(&self, name: &str, number: usize, ending: &str) -> PathBuf {
        self.out.join(format!("{name}_{number:04}.{ending}"))
    }

    /// A file that cannot be written does not end the run, as a capture does not: the disk may
    /// have room again for the next one, and the summary is worth having. It is told at the end.
    fn note(&mut self, path: PathBuf, written: Result<(), Failure>, list: fn(&mut Files) -> &mut Vec<String>) {
        let name = path.display().to_string();
        match written {
            Ok(()) => list(&mut self.files).push(name),
            Err(failure) => {
                if self.files.not_written.is_empty() {
                    self.troubles.push(failure.text().to_owned());
                }
                self.files.not_written.push(name);
            }
        }
    }
}

/// Steps at whose end one of `count` pictures is due: spread evenly, the last at the end. A run
/// of fewer steps has a picture after each.
pub fn due_steps(steps: u64, count: u32) -> Vec<u64> {
    let count = u64::from(count).min(steps);
    (1..=count).map(|number| (u128::from(number) * u128::from(steps) / u128::from(count)) as u64).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_are_spread_evenly_and_the_last_is_at_the_end() {
        assert_eq!(due_steps(480, 6), [80, 160, 240, 320, 400, 480]);
        assert_eq!(due_steps(10, 3), [3, 6, 10]);
        assert_eq!(due_steps(2, 5), [1, 2]);
        assert_eq!(due_steps(7, 1), [7]);
        assert!(due_steps(7, 0).is_empty());
    }
}
