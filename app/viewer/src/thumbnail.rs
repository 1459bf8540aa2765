//! Small pictures for captures, made on a thread of their own.

use std::sync::mpsc::{Receiver, Sender, SyncSender, channel, sync_channel};
use std::thread::JoinHandle;
use std::time::Instant;

use jpeg_encoder::{ColorType, Encoder};

/// A picture as it came from the GPU.
pub struct Picture {
    /// Its size, pixels.
    pub size_px: [u32; 2],
    /// Four bytes a pixel, rows from the top.
    pub rgba: Vec<u8>,
    /// When.
    pub taken: Instant,
}

/// No side of a small picture is longer: one a second for ten minutes are then some 10 MB.
const MOST_PX: u32 = 360;
const QUALITY: u8 = 75;

/// Makes pictures small, and JPEG of them.
pub struct Thumbnails {
    give: Option<SyncSender<Picture>>,
    ready: Receiver<(Instant, Vec<u8>)>,
    worker: Option<JoinHandle<()>>,
}

impl Thumbnails {
    /// Starts the thread.
    pub fn new() -> Self {
        // One waits at most: where pictures come faster than they are made, some are left out.
        let (give, pictures) = sync_channel(1);
        let (done, ready) = channel();
        let worker = std::thread::Builder::new().name("thumbnails".into()).spawn(move || work(&pictures, &done));
        // Without a thread there are no pictures in the capture, and all else is.
        Self { give: Some(give), ready, worker: worker.ok() }
    }

    /// Hands one over; it is dropped if the last one is still waiting.
    pub fn give(&self, picture: Picture) {
        if let Some(give) = &self.give {
            let _ = give.try_send(picture);
        }
    }

    /// One that is done.
    pub fn ready(&self) -> Option<(Instant, Vec<u8>)> {
        self.ready.try_recv().ok()
    }

    /// Those still on their way.
    pub fn finish(&mut self) -> Vec<(Instant, Vec<u8>)> {
        self.give = None;
        if let Some(worker) = self.worker.take() {
            // One that panicked has nothing more to give.
            let _ = worker.join();
        }
        self.ready.try_iter().collect()
    }
}

fn work(pictures: &Receiver<Picture>, done: &Sender<(Instant, Vec<u8>)>) {
    while let Ok(picture) = pictures.recv() {
        if let Some(jpeg) = jpeg(&picture)
            && done.send((picture.taken, jpeg)).is_err()
        {
            return;
        }
    }
}

fn jpeg(picture: &Picture) -> Option<Vec<u8>> {
    let (size_px, rgb) = small(picture);
    let mut bytes = Vec::new();
    let [width, height] = size_px.map(|side| u16::try_from(side).ok());
    Encoder::new(&mut bytes, QUALITY).encode(&rgb, width?, height?, ColorType::Rgb).ok()?;
    Some(bytes)
}

/// Each pixel the mean of a square of the picture's.
fn small(picture: &Picture) -> ([u32; 2], Vec<u8>) {
    let [width, height] = picture.size_px;
    let factor = width.max(height).div_ceil(MOST_PX).max(1);
    let size_px = [width, height].map(|side| (side / factor).max(1));
    let mut rgb = Vec::with_capacity((size_px[0] * size_px[1] * 3) as usize);
    for y in 0..size_px[1] {
        for x in 0..size_px[0] {
            let mut sums = [0u32; 4];
            for row in y * factor..((y + 1) * factor).min(height) {
                for column in x * factor..((x + 1) * factor).min(width) {
                    let at = 4 * (row * width + column) as usize;
                    for (sum, value) in sums.iter_mut().zip(&picture.rgba[at..at + 3]) {
                        *sum += u32::from(*value);
                    }
                    sums[3] += 1;
                }
            }
            rgb.extend([0, 1, 2].map(|channel| (sums[channel] / sums[3].max(1)) as u8));
        }
    }
    (size_px, rgb)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn picture(size_px: [u32; 2], color: impl Fn(u32, u32) -> [u8; 3]) -> Picture {
        let pixels = (0..size_px[1]).flat_map(|y| (0..size_px[0]).map(move |x| (x, y)));
        let rgba = pixels
            .flat_map(|(x, y)| {
                let [r, g, b] = color(x, y);
                [r, g, b, 255]
            })
            .collect();
        Picture { size_px, rgba, taken: Instant::now() }
    }

    #[test]
    fn pictures_become_small_by_their_mean() {
        let checks = picture([1000, 600], |x, y| if (x + y) % 2 == 0 { [200, 100, 0] } else { [100, 0, 50] });
        let (size_px, rgb) = small(&checks);
        assert_eq!(size_px, [333, 200]);
        assert!(rgb.chunks_exact(3).all(|pixel| pixel[0].abs_diff(150) <= 6 && pixel[1].abs_diff(50) <= 6));
        let (size_px, rgb) = small(&picture([2, 1], |x, _| [x as u8, 7, 9]));
        assert_eq!((size_px, rgb), ([2, 1], vec![0, 7, 9, 1, 7, 9]));
    }

    #[test]
    fn what_is_given_comes_out_as_jpeg() {
        let mut thumbnails = Thumbnails::new();
        thumbnails.give(picture([640, 480], |x, y| [x as u8, y as u8, 0]));
        let made = thumbnails.finish();
        assert_eq!(made.len(), 1);
        assert!(made[0].1.starts_with(&[0xff, 0xd8, 0xff]) && made[0].1.len() < 60_000, "{} bytes", made[0].1.len());
    }
}
