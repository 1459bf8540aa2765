//! The study as a picture: errors over the distance and over the time.

use plotters::prelude::*;

use super::{
    DISTANCES_M, Row, Shape, Surfaces,
    plot_meshes::{self, meshes_over_time},
    plot_style::{Area, COLORS, Drawing, FONT, GRID_LINE, INK, Marker, around, mean, short},
    ways::{FILTERS, MARCHED, names},
};
use crate::BenchError;

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
