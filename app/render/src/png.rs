//! Pictures as PNG files.

use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::Path;

use crate::RenderError;

/// Writes `rgba` (four bytes a pixel, sRGB, rows from the top) to `path`. The file appears whole
/// or not at all: it is written under another name in the same folder and renamed.
///
/// # Errors
/// When the bytes are not as many as the size says, or the file cannot be written.
pub fn save(path: &Path, size_px: [u32; 2], rgba: &[u8]) -> Result<(), RenderError> {
    let [width_px, height_px] = size_px;
    let wanted = width_px as usize * height_px as usize * 4;
    if rgba.len() != wanted || wanted == 0 {
        return Err(RenderError::PixelCount { width_px, height_px, wanted, got: rgba.len() });
    }
    let mut unfinished = path.as_os_str().to_owned();
    unfinished.push(".part");
    let unfinished = Path::new(&unfinished);
    let written = encode(unfinished, size_px, rgba).and_then(|()| fs::rename(unfinished, path));
    written.map_err(|error| {
        // Nothing more can be done when even this fails, and the first error is what matters.
        let _ = fs::remove_file(unfinished);
        RenderError::Write { path: path.to_owned(), reason: error.to_string() }
    })
}

fn encode(path: &Path, [width_px, height_px]: [u32; 2], rgba: &[u8]) -> std::io::Result<()> {
    // The picture covers everything it shows: alpha would only cost bytes.
    let rgb: Vec<u8> = rgba.chunks_exact(4).flat_map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect();
    let mut file = BufWriter::new(File::create(path)?);
    let mut encoder = png::Encoder::new(&mut file, width_px, height_px);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(&rgb)?;
    writer.finish()?;
    file.flush()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder(name: &str) -> std::path::PathBuf {
        let folder = std::env::temp_dir().join(format!("brooklet-png-{name}-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a temporary folder");
        folder
    }

    #[test]
    fn what_is_saved_is_what_was_given() {
        let folder = folder("round-trip");
        let path = folder.join("picture.png");
        let rgba: Vec<u8> = (0..5 * 3 * 4).map(|i| (i * 7 % 256) as u8).collect();
        save(&path, [5, 3], &rgba).expect("saved");
        let mut reader =
            png::Decoder::new(std::io::BufReader::new(File::open(&path).expect("there"))).read_info().expect("a PNG");
        let mut read = vec![0; reader.output_buffer_size().expect("small")];
        let info = reader.next_frame(&mut read).expect("a picture");
        assert_eq!((info.width, info.height, info.color_type), (5, 3, png::ColorType::Rgb));
        let expected: Vec<u8> = rgba.chunks(4).flat_map(|p| p[..3].to_vec()).collect();
        assert_eq!(read, expected);
        assert_eq!(fs::read_dir(&folder).expect("there").count(), 1, "no unfinished file stays behind");
        fs::remove_dir_all(folder).expect("removed");
    }

    #[test]
    fn errors_name_what_is_wrong() {
        let folder = folder("errors");
        let path = folder.join("missing").join("picture.png");
        let error = save(&path, [1, 1], &[0; 4]).expect_err("no such folder").to_string();
        assert!(error.contains(&path.display().to_string()), "{error}");
        let error = save(&folder.join("a.png"), [2, 2], &[0; 4]).expect_err("too few pixels").to_string();
        assert!(error.contains("16 bytes, 4"), "{error}");
        fs::remove_dir_all(folder).expect("removed");
    }
}
