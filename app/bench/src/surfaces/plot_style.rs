//! Colours, markers and axes that the study's plots share.

use std::ops::Range;

use plotters::{coord::Shift, prelude::*};

use super::ways::{FILTERS, names};

pub type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
pub type Drawing = Result<(), Box<dyn std::error::Error>>;

pub const FONT: &str = "sans-serif";
pub const INK: RGBColor = RGBColor(40, 44, 52);
pub const GRID_LINE: RGBColor = RGBColor(226, 228, 232);
/// One for each filter, then the marched field.
pub const COLORS: [RGBColor; FILTERS.len() + 1] = [
    RGBColor(160, 160, 160),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(213, 94, 0),
    RGBColor(0, 114, 178),
    RGBColor(86, 180, 233),
    RGBColor(0, 158, 115),
    RGBColor(240, 190, 170),
    RGBColor(150, 30, 30),
    RGBColor(188, 189, 220),
    RGBColor(158, 140, 200),
    RGBColor(106, 81, 163),
    RGBColor(63, 0, 125),
    RGBColor(120, 140, 60),
    RGBColor(60, 90, 20),
    RGBColor(20, 20, 20),
];
/// Half of a marker's side, pixels.
const SIZE_PX: i32 = 4;

/// What a point is drawn as.
#[derive(Clone, Copy, PartialEq)]
pub enum Marker {
    /// In screen space.
    Circle,
    /// A mesh.
    Square,
    /// Another program's.
    Triangle,
}

impl Marker {
    /// That of a way among [`names`].
    pub fn of(way: usize) -> Self {
        if FILTERS.get(way).is_some_and(|filter| filter.mesh.is_some()) { Self::Square } else { Self::Circle }
    }

    /// Draws it in pixels of the picture, with a text to its upper right; open ones are white inside.
    pub fn draw(
        self,
        picture: &Area<'_>,
        (x, y): (i32, i32),
        (color, is_open): (RGBColor, bool),
        text: &str,
    ) -> Drawing {
        self.fill(picture, (x, y), SIZE_PX, color)?;
        if is_open {
            self.fill(picture, (x, y), SIZE_PX - 2, WHITE)?;
        }
        let font = (FONT, 12).into_font().color(&INK);
        Ok(picture.draw(&Text::new(text.to_owned(), (x + SIZE_PX + 2, y - SIZE_PX - 8), font))?)
    }

    fn fill(self, picture: &Area<'_>, (x, y): (i32, i32), size_px: i32, color: RGBColor) -> Drawing {
        let style = color.filled();
        match self {
            Self::Circle => picture.draw(&Circle::new((x, y), size_px, style))?,
            Self::Square => {
                picture.draw(&Rectangle::new([(x - size_px, y - size_px), (x + size_px, y + size_px)], style))?;
            }
            Self::Triangle => picture.draw(&TriangleMarker::new((x, y), size_px + 2, style))?,
        }
        Ok(())
    }
}

pub fn color_of(way: &str) -> Option<RGBColor> {
    names().position(|name| name == way).map(|i| COLORS[i])
}

pub fn mean(values: impl Iterator<Item = f64>) -> Option<f64> {
    let (sum, count) = values.fold((0.0, 0.0), |(sum, count), value| (sum + value, count + 1.0));
    (count > 0.0).then(|| sum / count)
}

/// From a bit below the least to a bit above the largest.
pub fn around(values: impl Iterator<Item = f64> + Clone) -> Range<f64> {
    let least = values.clone().fold(f64::INFINITY, f64::min).max(1e-3);
    let largest = values.fold(least, f64::max);
    if least.is_finite() { least / 1.25..largest * 1.25 } else { 1.0..10.0 }
}

/// A number of an axis whose ticks double, or halve.
pub fn short(value: f64) -> String {
    let figures = format!("{value:.3}");
    figures.trim_end_matches('0').trim_end_matches('.').to_owned()
}
