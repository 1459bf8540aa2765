//! A map as coloured cells, with theory's line over it and the energy budget in it.

use plotters::prelude::*;

use super::plot::{Drawn, INK, RED};
use crate::State;
use crate::energy::RISE;
use crate::stability::Cell;

/// What a map shows.
pub struct Heat<'a> {
    /// Above it.
    pub title: &'a str,
    /// Below the horizontal axis.
    pub x: &'a str,
    /// Beside the vertical axis.
    pub y: &'a str,
    /// The cells, in any order.
    pub cells: &'a [Cell],
    /// Value of the palest colour and of the darkest, on a logarithmic scale.
    pub range: (f64, f64),
    /// What theory's value of a cell is called.
    pub theory: &'a str,
    /// Whether theory gives the largest y of each x, drawn as a line; else a value for each cell, written
    /// under the measured one.
    pub limit: bool,
}

type Area<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;

const CELL_PX: (i32, i32) = (92, 58);
const LEFT_PX: i32 = 74;
const TOP_PX: i32 = 46;

impl Heat<'_> {
    /// As SVG; empty without cells.
    pub fn svg(&self) -> String {
        let mut text = String::new();
        match self.draw(&mut text) {
            Ok(()) => text,
            Err(_) => String::new(),
        }
    }

    fn values(&self, of: fn(&Cell) -> f64) -> Vec<f64> {
        let mut values: Vec<f64> = self.cells.iter().map(of).collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        values
    }

    fn color(&self, value: f64) -> RGBColor {
        let (low, high) = (self.range.0.log10(), self.range.1.log10());
        let part = ((value.max(1e-30).log10() - low) / (high - low)).clamp(0.0, 1.0);
        let mix = |from: f64, to: f64| (from + (to - from) * part) as u8;
        RGBColor(mix(238.0, 20.0), mix(246.0, 80.0), mix(252.0, 140.0))
    }

    fn draw(&self, text: &mut String) -> Drawn<()> {
        let (xs, ys) = (self.values(|cell| cell.x), self.values(|cell| cell.y));
        if xs.is_empty() {
            return Err("no cells".into());
        }
        let size_px =
            ((LEFT_PX + CELL_PX.0 * xs.len() as i32 + 20).max(620), TOP_PX + CELL_PX.1 * ys.len() as i32 + 72);
        let area = SVGBackend::with_string(text, (size_px.0 as u32, size_px.1 as u32)).into_drawing_area();
        area.fill(&WHITE)?;
        let ink = |size: i32| ("sans-serif", size).into_font().color(&INK);
        area.draw(&Text::new(self.title, (LEFT_PX, 10), ink(16)))?;
        let left = |column: usize| LEFT_PX + CELL_PX.0 * column as i32;
        let top = |row: usize| TOP_PX + CELL_PX.1 * (ys.len() - 1 - row) as i32;
        for cell in self.cells {
            let column = xs.iter().position(|x| *x == cell.x).unwrap_or(0);
            let row = ys.iter().position(|y| *y == cell.y).unwrap_or(0);
            self.draw_cell(&area, cell, (left(column), top(row)))?;
        }
        for (column, x) in xs.iter().enumerate() {
            area.draw(&Text::new(
                x.to_string(),
                (left(column) + 36, TOP_PX + CELL_PX.1 * ys.len() as i32 + 4),
                ink(13),
            ))?;
        }
        for (row, y) in ys.iter().enumerate() {
            area.draw(&Text::new(y.to_string(), (LEFT_PX - 34, top(row) + 20), ink(13)))?;
        }
        area.draw(&Text::new(self.x, (LEFT_PX, size_px.1 - 42), ink(13)))?;
        // What the last line of a cell says.
        let energy = format!("E: what energy rose by beyond what compression holds, over g d; ok up to {RISE}");
        area.draw(&Text::new(energy, (LEFT_PX, size_px.1 - 20), ink(11)))?;
        area.draw(&Text::new(self.y, (8, TOP_PX - 20), ink(13)))?;
        if self.limit {
            self.draw_limit(&area, &xs, &ys)?;
        }
        area.present()?;
        Ok(())
    }

    fn draw_cell(&self, area: &Area<'_>, cell: &Cell, corner: (i32, i32)) -> Drawn<()> {
        let opposite = (corner.0 + CELL_PX.0 - 2, corner.1 + CELL_PX.1 - 2);
        let sound = matches!(cell.state, State::Stable | State::Clamped);
        let fill = match cell.value {
            Some(value) => self.color(value),
            None => RGBColor(245, 245, 245),
        };
        area.draw(&Rectangle::new([corner, opposite], fill.filled()))?;
        if !sound {
            area.draw(&Rectangle::new([corner, opposite], RED.stroke_width(2)))?;
        }
        let dark = cell.value.is_some_and(|value| value > (self.range.0 * self.range.1).sqrt());
        let ink = if dark { &WHITE } else { &INK };
        let theory = match (sound, self.limit) {
            (false, _) => cell.state.word().to_string(),
            (true, false) => format!("{} {}", self.theory, short(cell.theory)),
            (true, true) => String::new(),
        };
        let energy =
            cell.energy.map(|(rise, most)| if rise > most { format!("E {} !", short(rise)) } else { "E ok".into() });
        let lines = [(cell.value.map_or("–".into(), short), 13), (theory, 11), (energy.unwrap_or_default(), 11)];
        for ((text, size), below) in lines.into_iter().zip([6, 24, 39]) {
            let style = ("sans-serif", size).into_font().color(ink);
            area.draw(&Text::new(text, (corner.0 + 8, corner.1 + below), style))?;
        }
        Ok(())
    }

    /// Steps at theory's largest y of each column, between the rows it lies between.
    fn draw_limit(&self, area: &Area<'_>, xs: &[f64], ys: &[f64]) -> Drawn<()> {
        let mut path = Vec::new();
        for (column, x) in xs.iter().enumerate() {
            let Some(limit) = self.cells.iter().find(|cell| cell.x == *x).map(|cell| cell.theory) else { continue };
            // A row's middle stands for its value.
            let above = ys.partition_point(|y| *y < limit);
            let rows = match (above.checked_sub(1).map(|i| ys[i]), ys.get(above)) {
                (Some(low), Some(high)) => above as f64 - 1.0 + (limit - low) / (high - low) + 0.5,
                (None, _) => 0.25,
                (_, None) => ys.len() as f64,
            };
            let y = TOP_PX + ((ys.len() as f64 - rows) * f64::from(CELL_PX.1)) as i32;
            let left = LEFT_PX + CELL_PX.0 * column as i32;
            path.extend([(left, y), (left + CELL_PX.0 - 2, y)]);
        }
        area.draw(&PathElement::new(path, RED.stroke_width(3)))?;
        Ok(())
    }
}

fn short(value: f64) -> String {
    if value >= 0.001 { format!("{value:.3}") } else { format!("{value:.0e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_that_failed_have_a_frame() {
        let cell =
            |x: f64, state| Cell { x, y: 0.5, state, value: Some(0.01), energy: Some((x - 2.0, 0.01)), theory: 0.7 };
        let cells = [cell(2.0, State::Stable), cell(3.0, State::Unstable)];
        let heat = |cells| Heat { title: "t", x: "x", y: "y", cells, range: (1e-4, 1.0), theory: "", limit: true };
        let svg = heat(&cells).svg();
        assert!(svg.contains("unstable, said"));
        assert!(svg.contains("E ok") && svg.contains("E 1.000 !"), "{svg}");
        assert_eq!(heat(&[]).svg(), "");
    }
}
