//! The study as a picture: errors over the distance and over the time.

use std::ops::Range;

use plotters::{coord::Shift, prelude::*};

use super::{
    DISTANCES_M, Row, Shape, Surfaces,
    plot_meshes::{self, meshes_over_time},
    ways::{FILTERS, MARCHED, names},
};
use crate::BenchError;

pub type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
pub type Drawing = Result<(), Box<dyn std::error::Error>>;

pub const FONT: &str = "sans-serif";
pub const INK: RGBColor = RGBColor(40, 44, 52);
pub const GRID_LINE: RGBColor = RGBColor(226, 228, 232);
/// One for each filter, then the marched field.
const COLORS: [RGBColor; FILTERS.len() + 1] = [
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
/// A line of the legend, pixels.
const LINE_PX: i32 = 19;

/// Draws the study.
pub fn svg(study: &Surfaces) -> Result<String, BenchError> {
    let mut text = String::new();
    draw(study, &mut text).map_err(|error| BenchError::stopped(format_args!("the plot cannot be drawn: {error}")))?;
    Ok(text)
}

fn draw(study: &Surfaces, text: &mut String) -> Drawing {
    let area = SVGBackend::with_string(text, (1240, 780)).into_drawing_area();
    area.fill(&WHITE)?;
    let (title, rest) = area.split_vertically(44);
    let [width, height] = study.size_px;
    let caption =
        format!("Surfaces in screen space and meshed, on {} as {}, {width} x {height}", study.device, study.tier);
    title.draw(&Text::new(caption, (24, 14), (FONT, 20).into_font().color(&INK)))?;
    let (upper, lower) = rest.split_vertically(300);
    let bodies: Vec<Shape> =
        Shape::ALL.into_iter().filter(|shape| study.rows.iter().any(|row| row.shape == shape.name())).collect();
    for (panel, shape) in upper.split_evenly((1, bodies.len().max(1))).iter().zip(bodies) {
        errors_over_distance(panel, &area, study, shape)?;
    }
    let (left, rest) = lower.split_horizontally(490);
    let (right, legend) = rest.split_horizontally(490);
    if !study.rows.is_empty() {
        errors_over_time(&left, &area, study)?;
    }
    meshes_over_time(&right, &area, study)?;
    let mut line = 0;
    for (i, name) in names().enumerate().filter(|(_, name)| of(study, name).next().is_some()) {
        let label = if name == MARCHED { format!("{name} (dashed)") } else { format!("{}  {name}", i + 1) };
        legend_line(&legend, line, Marker::of(i), COLORS[i], &label)?;
        line += 1;
    }
    for (name, color) in plot_meshes::others(study) {
        legend_line(&legend, line, Marker::Triangle, color, &name)?;
        line += 1;
    }
    area.present()?;
    Ok(())
}

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
    fn of(way: usize) -> Self {
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

fn legend_line(area: &Area<'_>, line: i32, marker: Marker, color: RGBColor, label: &str) -> Drawing {
    let y = 8 + LINE_PX * line;
    marker.draw(area, (20, y + 7), (color, false), "")?;
    Ok(area.draw(&Text::new(label.to_owned(), (34, y), (FONT, 14).into_font().color(&INK)))?)
}

fn of<'a>(study: &'a Surfaces, way: &'a str) -> impl Iterator<Item = &'a Row> {
    study.rows.iter().filter(move |row| row.filter == way)
}

fn errors_over_distance(area: &Area<'_>, picture: &Area<'_>, study: &Surfaces, shape: Shape) -> Drawing {
    let rows = || study.rows.iter().filter(|row| row.shape == shape.name());
    let highest = rows().map(|row| row.errors.normal_mean_deg).fold(1.0, f64::max);
    let (near, far) = (DISTANCES_M[0] / 1.2, DISTANCES_M[DISTANCES_M.len() - 1] * 1.2);
    let mut chart = ChartBuilder::on(area)
        .margin(8)
        .caption(format!("{}: normals, mean error", shape.name()), (FONT, 15).into_font().color(&INK))
        .x_label_area_size(40)
        .y_label_area_size(44)
        .build_cartesian_2d((near..far).log_scale().base(2.0), 0.0..highest * 1.08)?;
    chart
        .configure_mesh()
        .disable_x_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(GRID_LINE)
        .axis_style(INK)
        .x_label_formatter(&|m| format!("{m:.1}"))
        .y_label_formatter(&|deg| format!("{deg:.0}°"))
        .x_desc("distance, m")
        .label_style((FONT, 13).into_font().color(&INK))
        .draw()?;
    for (i, (name, color)) in names().zip(COLORS).enumerate() {
        let points: Vec<(f64, f64)> = of(study, name)
            .filter(|row| row.shape == shape.name())
            .map(|row| (row.distance_m, row.errors.normal_mean_deg))
            .collect();
        chart.draw_series(LineSeries::new(points.clone(), color.stroke_width(2)))?;
        for point in points {
            Marker::of(i).draw(picture, chart.backend_coord(&point), (color, false), "")?;
        }
    }
    Ok(())
}

/// Each way's error, the mean of all bodies and distances, over its time.
fn errors_over_time(area: &Area<'_>, picture: &Area<'_>, study: &Surfaces) -> Drawing {
    let drawn: Vec<(usize, (f64, f64))> = FILTERS
        .into_iter()
        .enumerate()
        .filter_map(|(i, filter)| {
            let ms = mean(of(study, filter.name).filter_map(|row| row.surface_ms))?;
            Some((i, (ms, mean(of(study, filter.name).map(|row| row.errors.normal_mean_deg))?)))
        })
        .collect();
    let marched = mean(of(study, MARCHED).map(|row| row.errors.normal_mean_deg));
    let highest = drawn.iter().map(|(_, point)| point.1).chain(marched).fold(1.0, f64::max);
    let times = around(drawn.iter().map(|(_, point)| point.0));
    let mut chart = ChartBuilder::on(area)
        .margin(8)
        .caption("normals in pictures: mean error over time", (FONT, 15).into_font().color(&INK))
        .x_label_area_size(40)
        .y_label_area_size(44)
        .build_cartesian_2d(times.clone().log_scale().base(2.0), 0.0..highest * 1.1)?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(GRID_LINE)
        .axis_style(INK)
        .x_label_formatter(&|ms| short(*ms))
        .y_label_formatter(&|deg| format!("{deg:.0}°"))
        .x_desc("all passes of a picture's surface, ms; bodies and distances alike")
        .label_style((FONT, 13).into_font().color(&INK))
        .draw()?;
    if let Some(deg) = marched {
        let line = [(times.start, deg), (times.end, deg)];
        chart.draw_series(DashedLineSeries::new(line, 5, 4, COLORS[FILTERS.len()].stroke_width(1)))?;
    }
    for (i, point) in drawn {
        Marker::of(i).draw(picture, chart.backend_coord(&point), (COLORS[i], false), &(i + 1).to_string())?;
    }
    Ok(())
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
