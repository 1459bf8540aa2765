//! Heights from a PNG.

use png::{BitDepth, ColorType, Decoder, Limits, Transformations};

/// Pixels that an image may have.
const MOST_PIXELS: usize = 1 << 24;

/// What an image is darker than white by.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// Pixels along x.
    pub columns: usize,
    /// Pixels along z.
    pub rows: usize,
    /// Row by row, from 0, black, to 1, white.
    pub shares: Vec<f64>,
}

/// A gray image of 8 or 16 bits.
///
/// # Errors
/// In words, without the file's name.
pub fn image(bytes: &[u8]) -> Result<Image, String> {
    let unreadable = |error: png::DecodingError| format!("is no PNG file that can be read: {error}");
    let mut decoder = Decoder::new_with_limits(std::io::Cursor::new(bytes), Limits { bytes: 64 << 20 });
    decoder.set_transformations(Transformations::IDENTITY);
    let mut reader = decoder.read_info().map_err(unreadable)?;
    let info = reader.info();
    let (columns, rows, color, depth) = (info.width as usize, info.height as usize, info.color_type, info.bit_depth);
    let is_gray = color == ColorType::Grayscale && matches!(depth, BitDepth::Eight | BitDepth::Sixteen);
    if !is_gray {
        return Err(format!("has {color:?} pixels of {} bits: must be gray, of 8 or 16", depth as u8));
    }
    if columns < 2 || rows < 2 || columns.saturating_mul(rows) > MOST_PIXELS {
        return Err(format!("has {columns} x {rows} pixels: must be 2 or more a side, and {MOST_PIXELS} at most"));
    }
    let mut pixels = vec![0; columns * rows * if depth == BitDepth::Sixteen { 2 } else { 1 }];
    reader.next_frame(&mut pixels).map_err(unreadable)?;
    let shares = match depth {
        BitDepth::Sixteen => {
            pixels.chunks_exact(2).map(|pair| f64::from(u16::from_be_bytes([pair[0], pair[1]])) / 65535.0).collect()
        }
        _ => pixels.iter().map(|&pixel| f64::from(pixel) / 255.0).collect(),
    };
    Ok(Image { columns, rows, shares })
}
