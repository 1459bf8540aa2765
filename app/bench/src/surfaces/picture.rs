//! Normals as colours, side by side.

use std::path::Path;

use brooklet_render::png;
use glam::DVec3;

use super::seen::Seen;
use crate::BenchError;

/// What is cut out of the middle of each picture, pixels.
const TILE_PX: usize = 212;
const GAP_PX: usize = 4;

/// Pictures in rows, one for each body.
pub struct Sheet {
    size_px: [u32; 2],
    rows: Vec<(&'static str, Vec<Seen>)>,
}

impl Sheet {
    /// Without any picture yet, each of `size_px`.
    pub(crate) fn new(size_px: [u32; 2]) -> Self {
        Self { size_px, rows: Vec::new() }
    }

    /// Adds a picture to the right of the row of `body`.
    pub(crate) fn add(&mut self, body: &'static str, seen: &Seen) {
        match self.rows.last_mut().filter(|(name, _)| *name == body) {
            Some((_, row)) => row.push(seen.clone()),
            None => self.rows.push((body, vec![seen.clone()])),
        }
    }

    /// Writes all as one PNG.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn save(&self, path: &Path) -> Result<(), BenchError> {
        let (size_px, rgba) = self.pixels();
        png::save(path, size_px, &rgba).map_err(BenchError::stopped)
    }

    fn pixels(&self) -> ([u32; 2], Vec<u8>) {
        let [width, height] = self.size_px.map(|side| side as usize);
        let tile = [width.min(TILE_PX), height.min(TILE_PX)];
        let columns = self.rows.iter().map(|(_, row)| row.len()).max().unwrap_or(0).max(1);
        let sheet = [columns * (tile[0] + GAP_PX) - GAP_PX, self.rows.len().max(1) * (tile[1] + GAP_PX) - GAP_PX];
        let mut rgba = vec![255; sheet[0] * sheet[1] * 4];
        for (j, (_, row)) in self.rows.iter().enumerate() {
            for (i, seen) in row.iter().enumerate() {
                for y in 0..tile[1] {
                    for x in 0..tile[0] {
                        let from = (y + (height - tile[1]) / 2) * width + x + (width - tile[0]) / 2;
                        let to = (j * (tile[1] + GAP_PX) + y) * sheet[0] + i * (tile[0] + GAP_PX) + x;
                        rgba[4 * to..4 * to + 3].copy_from_slice(&color(seen.normals[from]));
                    }
                }
            }
        }
        (sheet.map(|side| side as u32), rgba)
    }
}

/// x, y and z of a normal as red, green and blue; nothing is near black.
fn color(normal: Option<DVec3>) -> [u8; 3] {
    normal.map_or([18; 3], |n| n.to_array().map(|x| (127.5 * (x + 1.0)).round() as u8))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pictures_stand_side_by_side() {
        let seen = |normal| Seen { size_px: [2, 2], normals: vec![Some(normal), None, None, Some(normal)] };
        let mut sheet = Sheet::new([2, 2]);
        sheet.add("a", &seen(DVec3::X));
        sheet.add("a", &seen(DVec3::Z));
        sheet.add("b", &seen(DVec3::Y));
        let (size_px, rgba) = sheet.pixels();
        assert_eq!(size_px, [8, 8]);
        let at = |x: usize, y: usize| &rgba[4 * (y * 8 + x)..4 * (y * 8 + x) + 3];
        assert_eq!(at(0, 0), [255, 128, 128]);
        assert_eq!(at(1, 0), [18, 18, 18]);
        assert_eq!(at(6, 0), [128, 128, 255]);
        assert_eq!(at(0, 6), [128, 255, 128]);
        assert_eq!(at(6, 6), [255, 255, 255]);
    }
}
