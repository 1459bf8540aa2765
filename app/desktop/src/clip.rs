//! The run's pictures as one animated WebP, which browsers and README pages play.

use std::path::PathBuf;

use webp_animation::{Encoder, EncoderOptions, EncodingConfig};

use crate::{failure::Failure, out_dir};

/// Of libwebp's 0 to 100: water's edges stay clean, and a picture takes a tenth of a PNG's bytes.
const QUALITY: f32 = 70.0;

/// A clip under way: at the pace of the scene's own time, over and over.
pub struct Clip {
    /// Where it is written at the end.
    pub path: PathBuf,
    encoder: Encoder,
    /// When the last two pictures are shown, ms.
    shown_ms: [i32; 2],
    pictures: u32,
}

impl Clip {
    /// One without pictures yet. The format holds sides of 16,383 pixels, more than a scene's pictures have.
    pub fn new(path: PathBuf, size_px: [u32; 2]) -> Result<Self, Failure> {
        let options =
            EncoderOptions { encoding_config: Some(EncodingConfig::new_lossy(QUALITY)), ..EncoderOptions::default() };
        let encoder = Encoder::new_with_options(size_px.into(), options).map_err(Failure::stopped)?;
        Ok(Self { path, encoder, shown_ms: [0; 2], pictures: 0 })
    }

    /// Takes the picture of `time_s`, sRGB, four bytes a pixel.
    pub fn add(&mut self, rgba: &[u8], time_s: f64) -> Result<(), Failure> {
        let last_ms = self.shown_ms[1];
        // The format counts whole milliseconds.
        let time_ms = (1000.0 * time_s).round() as i32;
        let time_ms = if self.pictures == 0 { time_ms } else { time_ms.max(last_ms + 1) };
        self.encoder.add_frame(rgba, time_ms).map_err(Failure::stopped)?;
        self.shown_ms = [if self.pictures == 0 { 0 } else { last_ms }, time_ms];
        self.pictures += 1;
        Ok(())
    }

    /// Writes the file, whole or not at all; its path. None if no picture was taken.
    pub fn finish(self) -> Option<(PathBuf, Result<(), Failure>)> {
        let Self { path, encoder, shown_ms: [before_ms, last_ms], pictures } = self;
        if pictures == 0 {
            return None;
        }
        // The last picture stands as long as the one before it.
        let encoded = encoder.finalize(last_ms + (last_ms - before_ms).max(1)).map_err(Failure::stopped);
        let written = encoded.and_then(|clip| out_dir::write_file(&path, &clip));
        Some((path, written))
    }
}

#[cfg(test)]
mod tests {
    use webp_animation::Decoder;

    use super::*;

    fn grey(value: u8) -> Vec<u8> {
        [value, value, value, 255].repeat(32 * 16)
    }

    #[test]
    fn pictures_are_shown_when_they_were_taken() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("clip.webp");
        let mut clip = Clip::new(path.clone(), [32, 16]).unwrap();
        let taken = [(0.1, 20), (0.2, 120), (0.2001, 180), (0.35, 240)];
        for (time_s, value) in taken {
            clip.add(&grey(value), time_s).unwrap();
        }
        let (written_to, written) = clip.finish().unwrap();
        written.unwrap();
        assert_eq!(written_to, path);
        let bytes = std::fs::read(path).unwrap();
        let frames: Vec<_> = Decoder::new(&bytes).unwrap().into_iter().collect();
        // A decoder tells when a picture's time is over; the format begins its clock with the first one.
        let over_ms: Vec<i32> = frames.iter().map(|frame| frame.timestamp() - frames[0].timestamp()).collect();
        assert_eq!(over_ms, [0, 1, 150, 299]);
        for (frame, (_, value)) in frames.iter().zip(taken) {
            assert_eq!(frame.dimensions(), (32, 16));
            // Lossy: within a few of 255.
            assert!(frame.data().chunks_exact(4).all(|pixel| pixel[0].abs_diff(value) < 6), "{value}");
        }
    }

    #[test]
    fn what_cannot_be_a_clip_is_said() {
        let folder = tempfile::tempdir().unwrap();
        assert!(Clip::new(folder.path().join("a.webp"), [4, 4]).unwrap().finish().is_none(), "no picture, no file");
        let mut nowhere = Clip::new(folder.path().join("no/a.webp"), [32, 16]).unwrap();
        assert!(nowhere.add(&grey(3)[4..], 0.0).is_err(), "a picture of another size");
        nowhere.add(&grey(3), 0.0).unwrap();
        assert!(nowhere.finish().unwrap().1.is_err());
    }
}
