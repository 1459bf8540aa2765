//! A run under way: steps, and what is written in between.

use std::path::{Path, PathBuf};

use brooklet_fluid::{FrameRequest, Scene, Session};
use brooklet_gpu::ResourceId;
use brooklet_render::surface::marching_cubes::{MeshRoom, is_whole};
use brooklet_render::{FrameOptions, FramePasses, ScenePlan, StartError};
use indicatif::ProgressBar;

use crate::{failure::Failure, interrupt::Interrupt, pictures::Picture, ply, recorder::Recorder, summary::Files};

/// Pictures of a run further apart are looked at one by one, not as a film, s.
const LONGEST_FILM_FRAME_S: f64 = 0.05;

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
    /// Room for its mesh, if it has one.
    pub mesh_room: Option<MeshRoom>,
    /// Takes the pictures as well, if a clip is wanted.
    #[cfg(feature = "clip")]
    pub clip: Option<crate::clip::Clip>,
    /// Whether particles are written beside the pictures and at the end.
    pub writes_particles: bool,
    /// What was written, and what could not be.
    pub files: Files,
    /// Why it could not, once for all of a kind.
    pub troubles: Vec<String>,
    /// Whether the first picture was told.
    pub told_first: bool,
    /// Whether it was told that what runs is unstable.
    pub told_unstable: bool,
}

impl Running<'_> {
    /// All steps, or those before Ctrl-C.
    pub fn all(&mut self, interrupt: &Interrupt, bar: &ProgressBar) -> Result<(), Failure> {
        let result = self.steps(interrupt, bar);
        // What came back before a failure belongs to the capture as well.
        match self.session.finish() {
            Ok(reports) => self.recorder.take(reports, self.passes.as_mut()),
            Err(error) => {
                self.recorder.take(self.session.reports(), self.passes.as_mut());
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
            // Nor whoever would stop it.
            if let Some(word) = self.recorder.measured.counted.instability()
                && !std::mem::replace(&mut self.told_unstable, true)
            {
                bar.println(word);
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

        self.submit(FrameRequest { steps: 1, measure: measures, ..FrameRequest::default() }, image.is_some())?;
        self.done = step;
        self.recorder.take(self.session.reports(), self.passes.as_mut());

        if let Some(number) = image {
            let path = self.numbered("frame", number, "png");
            if let Some(written) = self.write_picture(&path)? {
                self.note(path, written, |files| &mut files.images);
            }
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

    /// Hands a frame to the GPU, with a picture at its end if one is due.
    fn submit(&mut self, request: FrameRequest<'_>, draws: bool) -> Result<(), Failure> {
        let (fades, particles) = (self.pictures_are_close(), self.session.slot_count());
        let mut passes = self.passes.as_mut().filter(|_| draws);
        let draw = passes.as_mut().map(|passes| passes.next(self.session.engine_mut(), particles, fades));
        let readbacks: Vec<ResourceId> = passes.iter().flat_map(|passes| passes.readbacks()).collect();
        let request = FrameRequest { then: draw.as_slice(), readbacks: &readbacks, ..request };
        self.session.submit(&request).map(drop).map_err(Failure::stopped)
    }

    /// Whether a person who sees the pictures as a film would see one change into the next.
    fn pictures_are_close(&self) -> bool {
        let steps = self.images.first().map_or(0, |first| *first);
        steps as f64 * self.scene.solver.dt_s <= LONGEST_FILM_FRAME_S
    }

    /// The picture of the last frame, drawn once more where its mesh lacked room; whether it is written. None if the run
    /// has no pictures.
    fn write_picture(&mut self, path: &Path) -> Result<Option<Result<(), Failure>>, Failure> {
        loop {
            let Some(passes) = &self.passes else { return Ok(None) };
            let picture = Picture::of(passes);
            let rgba = picture.read(self.session.engine_mut())?;
            if passes.readbacks().next().is_some() {
                let has_mesh = passes.draws_mesh();
                // All was waited for with the picture.
                let reports = self.session.finish().map_err(Failure::stopped)?;
                self.recorder.take(reports, self.passes.as_mut());
                if has_mesh && self.make_room()? {
                    self.submit(FrameRequest::default(), true)?;
                    continue;
                }
            }
            #[cfg(feature = "clip")]
            if let Some(clip) = &mut self.clip {
                clip.add(&rgba, self.done as f64 * self.scene.solver.dt_s)?;
            }
            let Some(passes) = &self.passes else { return Ok(None) };
            return Ok(Some(Picture::of(passes).save(path, &rgba)));
        }
    }

    /// Goes on with more room for the pictures' mesh if the last one lacked some and the device has it.
    fn make_room(&mut self) -> Result<bool, Failure> {
        let (Some(room), Some(counts)) = (self.mesh_room, self.recorder.meshes.last()) else { return Ok(false) };
        if is_whole(counts) {
            return Ok(false);
        }
        let tier = self.session.engine().gpu().tier();
        let looks = FrameOptions::for_scene(self.scene, tier).with_mesh_room(room);
        for spare in [MeshRoom::SPARE, 0.0] {
            let Some(needed) = looks.lacked_mesh_room(counts, spare) else { continue };
            match enlarge(&self.session, self.scene, needed) {
                Ok((session, mut passes)) => {
                    if let (Some(passes), Some(before)) = (&mut passes, &self.passes) {
                        passes.go_on_from(before);
                    }
                    self.recorder.go_on_in(&session);
                    (self.session, self.passes, self.mesh_room) = (session, passes, Some(needed));
                    return Ok(true);
                }
                Err(Failure::Input(_)) => {}
                Err(failure) => return Err(failure),
            }
        }
        self.recorder.meshes.cut_short += 1;
        Ok(false)
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

/// The same run in a plan with other room for its pictures' mesh. That the device has no such room is
/// [`Failure::Input`].
fn enlarge(session: &Session, scene: &Scene, room: MeshRoom) -> Result<(Session, Option<FramePasses>), Failure> {
    let gpu = session.engine().gpu();
    let ScenePlan { session: planned, passes, .. } =
        ScenePlan::with_mesh_room(scene, session.slot_count(), gpu.tier(), room).map_err(Failure::stopped)?;
    let mut larger = brooklet_render::start(gpu, planned).map_err(|error| match error {
        StartError::Misfit { .. } => Failure::input(error),
        StartError::Gpu(_) => Failure::stopped(error),
    })?;
    larger.adopt(session).map_err(Failure::stopped)?;
    Ok((larger, passes))
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
