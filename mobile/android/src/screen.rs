//! A screen of text without a GPU: what a phone shows whose Vulkan cannot run the app.
//!
//! It is drawn in points, about 160 to an inch, and the system scales it to the window.

use std::convert::Infallible;

use embedded_graphics::{
    Pixel,
    mono_font::{MonoFont, MonoTextStyle, iso_8859_1::FONT_10X20},
    pixelcolor::Rgb888,
    prelude::{DrawTarget, Drawable, OriginDimensions, Point, RgbColor, Size},
    text::{Baseline, Text},
};

const FONT: &MonoFont<'_> = &FONT_10X20;
const MARGIN: usize = 12;
const LINE: usize = 24;
const BACKGROUND: [u8; 4] = [16, 24, 32, 255];
const TEXT: Rgb888 = Rgb888::WHITE;
/// A window is no larger; a wrong size would otherwise ask for all memory.
const MOST: usize = 8192;

/// A picture, 8 bits a channel, rows from the top.
pub struct Screen {
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Red, green, blue, 255.
    pub rgba: Vec<[u8; 4]>,
}

impl Screen {
    /// `text` on a screen of a size in points: paragraphs as they are, long lines wrapped, long words broken. What there
    /// is no room for is cut, and three dots stand for it. Characters beyond Latin-1 are question marks.
    pub fn of_text(text: &str, size: [usize; 2]) -> Self {
        let [width, height] = size.map(|size| size.clamp(1, MOST));
        let mut screen = Self { width, height, rgba: vec![BACKGROUND; width * height] };
        let columns = width.saturating_sub(2 * MARGIN) / FONT.character_size.width as usize;
        let rows = height.saturating_sub(2 * MARGIN) / LINE;
        let style = MonoTextStyle::new(FONT, TEXT);
        for (row, line) in lines(text, columns, rows).iter().enumerate() {
            let at = Point::new(MARGIN as i32, (MARGIN + row * LINE) as i32);
            let Ok(_) = Text::with_baseline(line, at, style, Baseline::Top).draw(&mut screen);
        }
        screen
    }

    /// Its rows, top first.
    pub fn rows(&self) -> impl Iterator<Item = &[[u8; 4]]> {
        self.rgba.chunks_exact(self.width)
    }
}

impl OriginDimensions for Screen {
    fn size(&self) -> Size {
        Size::new(self.width as u32, self.height as u32)
    }
}

impl DrawTarget for Screen {
    type Color = Rgb888;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb888>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(at, color) in pixels {
            let (Ok(x), Ok(y)) = (usize::try_from(at.x), usize::try_from(at.y)) else { continue };
            if x < self.width && y < self.height {
                self.rgba[y * self.width + x] = [color.r(), color.g(), color.b(), 255];
            }
        }
        Ok(())
    }
}

/// At most `rows` lines of at most `columns` characters.
fn lines(text: &str, columns: usize, rows: usize) -> Vec<String> {
    if columns < 3 || rows == 0 {
        return Vec::new();
    }
    let mut lines: Vec<String> = textwrap::wrap(text, columns).into_iter().map(String::from).collect();
    if lines.len() > rows {
        lines.truncate(rows);
        lines[rows - 1] = "...".into();
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lit(screen: &Screen) -> Vec<[usize; 2]> {
        let lit = screen.rgba.iter().enumerate().filter(|(_, pixel)| **pixel != BACKGROUND);
        lit.map(|(index, _)| [index % screen.width, index / screen.width]).collect()
    }

    #[test]
    fn text_is_drawn_inside_the_margins_and_reads_as_the_font_has_it() {
        let screen = Screen::of_text("|", [360, 640]);
        let bar = lit(&screen);
        assert!(!bar.is_empty());
        // A bar of the font is two columns wide at most, in the first cell.
        let columns: std::collections::BTreeSet<_> = bar.iter().map(|[x, _]| *x).collect();
        assert!(columns.len() <= 2 && columns.iter().all(|x| (MARGIN..MARGIN + 10).contains(x)), "{columns:?}");
        assert!(bar.iter().all(|[_, y]| (MARGIN..MARGIN + LINE).contains(y)));
        assert!(lit(&Screen::of_text("", [360, 640])).is_empty());
        assert_ne!(lit(&Screen::of_text("O", [360, 640])), lit(&Screen::of_text("Q", [360, 640])));
    }

    #[test]
    fn long_text_is_wrapped_and_what_has_no_room_is_cut_and_said() {
        let words = "no Vulkan device ".repeat(40);
        assert!(lines(&words, 33, 99).iter().all(|line| line.chars().count() <= 33));
        assert_eq!(lines(&words, 33, 3)[2], "...");
        assert_eq!(lines(&"x".repeat(70), 33, 9).len(), 3);
        assert_eq!(lines("a\nb", 33, 9), ["a", "b"]);
        let screen = Screen::of_text(&words, [360, 640]);
        assert!(lit(&screen).iter().all(|[x, y]| (MARGIN..360 - MARGIN).contains(x) && (MARGIN..640).contains(y)));
    }

    #[test]
    fn no_size_is_too_small_or_too_large() {
        for size in [[0, 0], [1, 1], [40, 30], [usize::MAX, 1]] {
            let screen = Screen::of_text("Brooklet", size);
            assert_eq!(screen.rgba.len(), screen.width * screen.height);
            assert_eq!(screen.rows().count(), screen.height);
        }
    }
}
