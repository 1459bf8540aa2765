//! The study as a picture: for each body the normals' error over the distance, and what it costs.

use plotters::{coord::Shift, prelude::*};

use super::{
    DISTANCES_M, Row, Shape, Surfaces,
    ways::{FILTERS, MARCHED, names},
};
use crate::BenchError;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawing = Result<(), Box<dyn std::error::Error>>;

const FONT: &str = "sans-serif";
const INK: RGBColor = RGBColor(40, 44, 52);
const GRID_LINE: RGBColor = RGBColor(226, 228, 232);
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
    RGBColor(106, 81, 163),
    RGBColor(84, 39, 143),
    RGBColor(63, 0, 125),
    RGBColor(120, 140, 60),
    RGBColor(60, 90, 20),
    RGBColor(20, 20, 20),
];

/// Draws the study.
pub fn svg(study: &Surfaces) -> Result<String, BenchError> {
    let mut text = String::new();
    draw(study, &mut text).map_err(|error| BenchError::stopped(format_args!("the plot cannot be drawn: {error}")))?;
    Ok(text)
}

fn draw(study: &Surfaces, text: &mut String) -> Drawing {
    let area = SVGBackend::with_string(text, (1240, 700)).into_drawing_area();
    area.fill(&WHITE)?;
    let (title, rest) = area.split_vertically(44);
    let [width, height] = study.size_px;
    let caption =
        format!("Surfaces in screen space and meshed, on {} as {}, {width} x {height}", study.device, study.tier);
    title.draw(&Text::new(caption, (24, 14), (FONT, 20).into_font().color(&INK)))?;
    let (upper, lower) = rest.split_vertically(310);
    for (panel, shape) in upper.split_evenly((1, Shape::ALL.len())).iter().zip(Shape::ALL) {
        errors_over_distance(panel, study, shape)?;
    }
    let (left, right) = lower.split_horizontally(820);
    errors_over_time(&left, study)?;
    for (line, name) in names().enumerate() {
        let y = 8 + 22 * line as i32;
        right.draw(&Circle::new((20, y + 7), 5, COLORS[line].filled()))?;
        right.draw(&Text::new(name, (36, y), (FONT, 15).into_font().color(&INK)))?;
    }
    area.present()?;
    Ok(())
}

fn of<'a>(study: &'a Surfaces, filter: &'a str) -> impl Iterator<Item = &'a Row> {
    study.rows.iter().filter(move |row| row.filter == filter)
}

fn errors_over_distance(area: &Area<'_>, study: &Surfaces, shape: Shape) -> Drawing {
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
    for (name, color) in names().zip(COLORS) {
        let points: Vec<(f64, f64)> = of(study, name)
            .filter(|row| row.shape == shape.name())
            .map(|row| (row.distance_m, row.errors.normal_mean_deg))
            .collect();
        chart.draw_series(LineSeries::new(points.clone(), color.stroke_width(2)))?;
        chart.draw_series(points.into_iter().map(|point| Circle::new(point, 3, color.filled())))?;
    }
    Ok(())
}

/// Each filter's error, the mean of all bodies and distances, over its time.
fn errors_over_time(area: &Area<'_>, study: &Surfaces) -> Drawing {
    let mean = |values: Vec<f64>| values.iter().sum::<f64>() / values.len().max(1) as f64;
    let points: Vec<(f64, f64, RGBColor)> = FILTERS
        .into_iter()
        .zip(COLORS)
        .map(|(filter, color)| {
            let ms = mean(of(study, filter.name).filter_map(|row| row.surface_ms).collect());
            let deg = mean(of(study, filter.name).map(|row| row.errors.normal_mean_deg).collect());
            (ms, deg, color)
        })
        .collect();
    let best = mean(of(study, MARCHED).map(|row| row.errors.normal_mean_deg).collect());
    let slowest = points.iter().map(|point| point.0).fold(1e-3, f64::max);
    let highest = points.iter().map(|point| point.1).fold(best, f64::max);
    let mut chart = ChartBuilder::on(area)
        .margin(8)
        .caption("normals' mean error over the time of a picture's surface", (FONT, 15).into_font().color(&INK))
        .x_label_area_size(40)
        .y_label_area_size(44)
        .build_cartesian_2d(0.0..slowest * 1.1, 0.0..highest * 1.1)?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(GRID_LINE)
        .axis_style(INK)
        .x_label_formatter(&|ms| format!("{ms:.1}"))
        .y_label_formatter(&|deg| format!("{deg:.0}°"))
        .x_desc("ms")
        .label_style((FONT, 13).into_font().color(&INK))
        .draw()?;
    let line = [(0.0, best), (slowest * 1.1, best)];
    chart.draw_series(DashedLineSeries::new(line, 5, 4, COLORS[FILTERS.len()].stroke_width(1)))?;
    chart.draw_series(points.into_iter().map(|(ms, deg, color)| Circle::new((ms, deg), 6, color.filled())))?;
    Ok(())
}
