//! One kind of plot for everything that has two axes: lines, points, rings and crosses, linear or
//! logarithmic, as SVG.

use plotters::coord::Shift;
use plotters::coord::ranged1d::{DefaultFormatting, KeyPointHint, Ranged};
use plotters::element::DashedPathElement;
use plotters::prelude::*;

/// Ink of axes and texts.
pub const INK: RGBColor = RGBColor(40, 44, 52);
const GRID_LINE: RGBColor = RGBColor(228, 230, 234);
const FONT: &str = "sans-serif";
/// Told apart by most people, the colour-blind too (Okabe & Ito 2008, and more: as many as all solvers have knobs).
pub const PALETTE: [RGBColor; 17] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
    RGBColor(120, 94, 60),
    RGBColor(110, 110, 110),
    RGBColor(148, 52, 110),
    RGBColor(60, 60, 160),
    RGBColor(141, 160, 50),
    RGBColor(30, 30, 30),
    RGBColor(240, 128, 110),
    RGBColor(0, 150, 190),
    RGBColor(110, 60, 190),
    RGBColor(200, 180, 90),
    RGBColor(90, 150, 90),
];
/// What failed.
pub const RED: RGBColor = RGBColor(190, 30, 45);

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// A line with dots.
    LineDots,
    /// A line with squares.
    LineSquares,
    /// A line with triangles.
    LineTriangles,
    /// A line.
    Line,
    /// A dashed line.
    Dashed,
    /// Dots.
    Dots,
    /// Rings around other dots.
    Rings,
    /// Crosses.
    Crosses,
}

/// Some points.
#[derive(Clone, Debug)]
pub struct Line {
    /// In the legend; empty for none.
    pub name: String,
    /// Its colour.
    pub color: RGBColor,
    /// How it is drawn.
    pub mark: Mark,
    /// Where.
    pub points: Vec<(f64, f64)>,
}

/// A plot.
#[derive(Clone, Debug, Default)]
pub struct Plot {
    /// Above it.
    pub title: String,
    /// Below the horizontal axis.
    pub x: String,
    /// Beside the vertical axis.
    pub y: String,
    /// Whether the horizontal axis is logarithmic.
    pub log_x: bool,
    /// Whether the vertical axis is.
    pub log_y: bool,
    /// What it shows.
    pub lines: Vec<Line>,
    /// Width and height, pixels.
    pub size_px: (u32, u32),
}

/// What a drawing may fail with; into memory it does not.
pub type Drawn<T> = Result<T, Box<dyn std::error::Error>>;

impl Plot {
    /// As SVG; empty where nothing can be shown.
    pub fn svg(&self) -> String {
        let mut text = String::new();
        match self.draw(&mut text) {
            Ok(()) => text,
            Err(_) => String::new(),
        }
    }

    fn axis(&self, value: f64, log: bool) -> Option<f64> {
        let shown = if log { value.log10() } else { value };
        shown.is_finite().then_some(shown)
    }

    fn shown(&self, line: &Line) -> Vec<(f64, f64)> {
        line.points.iter().filter_map(|&(x, y)| Some((self.axis(x, self.log_x)?, self.axis(y, self.log_y)?))).collect()
    }

    fn draw(&self, text: &mut String) -> Drawn<()> {
        let area = SVGBackend::with_string(text, self.size_px).into_drawing_area();
        area.fill(&WHITE)?;
        let named = self.lines.iter().filter(|line| !line.name.is_empty()).count();
        let (chart, legend) =
            if named > 0 { area.split_horizontally(self.size_px.0 - 150) } else { (area.clone(), area.clone()) };
        let all: Vec<(f64, f64)> = self.lines.iter().flat_map(|line| self.shown(line)).collect();
        let (x, y) = (
            span(all.iter().map(|p| p.0)).ok_or("nothing to show")?,
            span(all.iter().map(|p| p.1)).ok_or("nothing to show")?,
        );
        self.chart(&chart, x, y)?;
        if named > 0 {
            self.legend(&legend)?;
        }
        area.present()?;
        Ok(())
    }

    fn chart(&self, area: &DrawingArea<SVGBackend<'_>, Shift>, x: (f64, f64), y: (f64, f64)) -> Drawn<()> {
        let mut chart = ChartBuilder::on(area)
            .margin_left(8)
            .margin_right(14)
            .margin_bottom(6)
            .margin_top(6)
            .caption(&self.title, (FONT, 16).into_font().color(&INK))
            .x_label_area_size(42)
            .y_label_area_size(62)
            .build_cartesian_2d(
                Axis { span: x, ticks: ticks(x, self.log_x) },
                Axis { span: y, ticks: ticks(y, self.log_y) },
            )?;
        chart
            .configure_mesh()
            .light_line_style(TRANSPARENT)
            .bold_line_style(GRID_LINE)
            .axis_style(INK)
            .x_labels(6)
            .y_labels(6)
            .x_label_formatter(&|value| tick(*value, self.log_x))
            .y_label_formatter(&|value| tick(*value, self.log_y))
            .x_desc(&self.x)
            .y_desc(&self.y)
            .label_style((FONT, 13).into_font().color(&INK))
            .draw()?;
        for line in &self.lines {
            let points = self.shown(line);
            let color = line.color;
            match line.mark {
                Mark::Line | Mark::LineDots | Mark::LineSquares | Mark::LineTriangles => {
                    chart.draw_series(LineSeries::new(points.clone(), color.stroke_width(2)))?;
                }
                Mark::Dashed => {
                    chart.draw_series(DashedLineSeries::new(points.clone(), 6, 4, color.stroke_width(2)))?;
                }
                _ => {}
            }
            match line.mark {
                Mark::LineDots | Mark::Dots => {
                    chart.draw_series(points.iter().map(|&point| Circle::new(point, 4, color.filled())))?;
                }
                Mark::LineSquares => {
                    let square = || Rectangle::new([(-4, -4), (4, 4)], color.filled());
                    chart.draw_series(points.iter().map(|&point| EmptyElement::at(point) + square()))?;
                }
                Mark::LineTriangles => {
                    let triangles = points.iter().map(|&point| TriangleMarker::new(point, 6, color.filled()));
                    chart.draw_series(triangles)?;
                }
                Mark::Rings => {
                    chart.draw_series(points.iter().map(|&point| Circle::new(point, 8, color.stroke_width(2))))?;
                }
                Mark::Crosses => {
                    chart.draw_series(points.iter().map(|&point| Cross::new(point, 6, color.stroke_width(3))))?;
                }
                Mark::Line | Mark::Dashed => {}
            }
        }
        Ok(())
    }

    fn legend(&self, area: &DrawingArea<SVGBackend<'_>, Shift>) -> Drawn<()> {
        for (row, line) in self.lines.iter().filter(|line| !line.name.is_empty()).enumerate() {
            let y = 40 + 22 * row as i32;
            let color = line.color;
            match line.mark {
                Mark::Line | Mark::LineDots | Mark::LineSquares | Mark::LineTriangles => {
                    area.draw(&PathElement::new([(2, y + 6), (22, y + 6)], color.stroke_width(2)))?;
                }
                Mark::Dashed => {
                    area.draw(&DashedPathElement::new([(2, y + 6), (22, y + 6)], 5, 4, color.stroke_width(2)))?
                }
                Mark::Rings => area.draw(&Circle::new((12, y + 6), 7, color.stroke_width(2)))?,
                Mark::Crosses => area.draw(&Cross::new((12, y + 6), 5, color.stroke_width(3)))?,
                Mark::Dots => {}
            }
            let middle = (12, y + 6);
            match line.mark {
                Mark::Dots | Mark::LineDots => area.draw(&Circle::new(middle, 4, color.filled()))?,
                Mark::LineSquares => area.draw(&Rectangle::new([(8, y + 2), (16, y + 10)], color.filled()))?,
                Mark::LineTriangles => area.draw(&TriangleMarker::new(middle, 6, color.filled()))?,
                Mark::Line | Mark::Dashed | Mark::Rings | Mark::Crosses => {}
            }
            area.draw(&Text::new(line.name.clone(), (28, y), (FONT, 13).into_font().color(&INK)))?;
        }
        Ok(())
    }
}

/// From the least to the largest, with a margin; none of nothing.
fn span(values: impl Iterator<Item = f64>) -> Option<(f64, f64)> {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
    if low > high {
        return None;
    }
    let margin = 0.06 * (high - low).max(1e-3 * high.abs()).max(1e-9);
    Some((low - margin, high + margin))
}

/// An axis with ticks of its own.
struct Axis {
    span: (f64, f64),
    ticks: Vec<f64>,
}

impl Ranged for Axis {
    type FormatOption = DefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        let part = (value - self.span.0) / (self.span.1 - self.span.0);
        limit.0 + (part * f64::from(limit.1 - limit.0)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.ticks.clone()
    }

    fn range(&self) -> std::ops::Range<f64> {
        self.span.0..self.span.1
    }
}

/// Where an axis has ticks: round numbers, some four to eight of them.
fn ticks((low, high): (f64, f64), log: bool) -> Vec<f64> {
    if log {
        // 1, 2 and 5 of each decade, or the decades alone where there are many.
        let steps: &[f64] = if high - low > 2.5 { &[1.0] } else { &[1.0, 2.0, 5.0] };
        let every = ((high - low) / 8.0).ceil().max(1.0) as usize;
        let decades = low.floor() as i32..=high.ceil() as i32;
        let all =
            decades.step_by(every).flat_map(|decade| steps.iter().map(move |step| f64::from(decade) + step.log10()));
        let shown: Vec<f64> = all.filter(|at| (low..=high).contains(at)).collect();
        if shown.len() > 1 {
            return shown;
        }
        // Within one such step: even ones, however odd their numbers.
        return (0..5).map(|k| low + (high - low) * (f64::from(k) + 0.5) / 5.0).collect();
    }
    let rough = (high - low) / 6.0;
    let power = 10f64.powf(rough.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].into_iter().map(|step| step * power).find(|step| *step >= rough).unwrap_or(rough);
    let (first, last) = ((low / step).ceil() as i64, (high / step).floor() as i64);
    (first..=last).map(|k| k as f64 * step).collect()
}

/// A tick's label; logarithmic ones are of the number itself.
fn tick(value: f64, log: bool) -> String {
    let number = if log { 10f64.powf(value) } else { value };
    // Where a linear axis passes zero, its tick may be a rounding away from it.
    let number = if !log && number.abs() < 1e-12 { 0.0 } else { number };
    match number.abs() {
        size if size == 0.0 || (0.01..1000.0).contains(&size) => {
            let digits = if size >= 100.0 {
                0
            } else if size >= 10.0 {
                1
            } else {
                3
            };
            let text = format!("{number:.digits$}");
            if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').into() } else { text }
        }
        _ => format!("{number:.1e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round() {
        let numbers = |span, log| ticks(span, log).into_iter().map(|at| tick(at, log)).collect::<Vec<_>>();
        assert_eq!(numbers((0.0, 1.0), false), ["0", "0.2", "0.4", "0.6", "0.8", "1"]);
        assert_eq!(numbers((-1.1, 0.8), true), ["0.1", "0.2", "0.5", "1", "2", "5"]);
        assert_eq!(numbers((-3.2, 0.5), true), ["1.0e-3", "0.01", "0.1", "1"]);
        assert_eq!(numbers((-16.0, 0.5), true).len(), 6);
        assert_eq!(numbers((0.4, 0.6), true).len(), 5);
    }

    #[test]
    fn ticks_are_short() {
        let shown = [tick(0.25, false), tick(-2.0, true), tick(3.0, true), tick(1e-17, false), tick(12.0, false)];
        assert_eq!(shown, ["0.25", "0.01", "1.0e3", "0", "12"]);
    }

    #[test]
    fn what_cannot_be_shown_is_left_out_and_nothing_is_no_picture() {
        let line = |points| Line { name: "a".into(), color: INK, mark: Mark::LineDots, points };
        let plot = |points| Plot { lines: vec![line(points)], log_x: true, size_px: (400, 300), ..Plot::default() };
        assert!(plot(vec![(0.0, 1.0), (f64::NAN, 2.0)]).svg().is_empty());
        let svg = plot(vec![(0.0, 1.0), (0.1, 2.0), (1.0, 3.0)]).svg();
        assert!(svg.starts_with("<svg") && svg.matches("<circle").count() == 3, "two points and the legend's");
    }
}
