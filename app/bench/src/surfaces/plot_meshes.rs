//! Meshes' distances from the known surfaces over their time.

use plotters::prelude::*;

use super::{
    MeshRow, Shape, Surfaces,
    meshes::THIS,
    plot_style::{Area, Drawing, FONT, GRID_LINE, INK, Marker, around, color_of, mean, short},
};

/// Of another program: as it is, and smoothed.
const OTHERS: [RGBColor; 2] = [RGBColor(213, 94, 0), RGBColor(0, 114, 178)];

/// A way to mesh, of the bodies in the open, by cells.
struct Point<'a> {
    mesh: &'a str,
    cells: &'a str,
    ms: f64,
    mean_spacings: f64,
    hausdorff_spacings: f64,
}

/// The way without its cells.
fn way(mesh: &str) -> &str {
    mesh.split_once(", cells ").map_or(mesh, |(way, _)| way)
}

/// Ways of another program, with their colours.
pub fn others(study: &Surfaces) -> Vec<(String, RGBColor)> {
    let mut ways: Vec<&str> = Vec::new();
    for row in study.meshes.iter().filter(|row| row.program != THIS) {
        if !ways.contains(&way(&row.mesh)) {
            ways.push(way(&row.mesh));
        }
    }
    ways.into_iter().map(str::to_owned).zip(OTHERS).collect()
}

/// Means of the bodies that no wall cuts and that are more than a layer.
fn points(study: &Surfaces) -> Vec<Point<'_>> {
    let open: Vec<&str> = Shape::MESHED
        .into_iter()
        .filter(|shape| !shape.in_walls() && *shape != Shape::Sheet)
        .map(Shape::name)
        .collect();
    let mut points: Vec<Point> = Vec::new();
    for MeshRow { mesh, cells, .. } in &study.meshes {
        let rows = || study.meshes.iter().filter(|row| row.mesh == *mesh && open.contains(&row.shape));
        let mean_of = |figure: fn(&MeshRow) -> Option<f64>| mean(rows().filter_map(figure));
        let figures = (
            mean_of(|row| row.ms),
            mean_of(|row| Some(row.errors.mean_spacings)),
            mean_of(|row| Some(row.errors.hausdorff_spacings)),
        );
        let is_new = points.iter().all(|point| point.mesh != mesh);
        if let (true, (Some(ms), Some(mean_spacings), Some(hausdorff_spacings))) = (is_new, figures) {
            points.push(Point { mesh, cells, ms, mean_spacings, hausdorff_spacings });
        }
    }
    points
}

/// Draws them: filled the mean distance, open the largest; a line joins the cells of a way.
pub fn meshes_over_time(area: &Area<'_>, picture: &Area<'_>, study: &Surfaces) -> Drawing {
    let points = points(study);
    if points.is_empty() {
        return Ok(());
    }
    let times = around(points.iter().map(|point| point.ms));
    let spacings = around(points.iter().flat_map(|point| [point.mean_spacings, point.hausdorff_spacings]));
    let mut chart = ChartBuilder::on(area)
        .margin(8)
        .caption("meshes: distance, mean (filled) and Hausdorff (open), over time", (FONT, 15).into_font().color(&INK))
        .x_label_area_size(40)
        .y_label_area_size(44)
        .build_cartesian_2d(times.log_scale().base(2.0), spacings.log_scale().base(2.0))?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(GRID_LINE)
        .axis_style(INK)
        .x_label_formatter(&|ms| short(*ms))
        .y_label_formatter(&|spacings| short(*spacings))
        .x_desc("ms of a mesh; the mean of the bodies in the open, in spacings d; texts: cells")
        .label_style((FONT, 13).into_font().color(&INK))
        .draw()?;
    let others = others(study);
    let mut ways: Vec<&str> = points.iter().map(|point| way(point.mesh)).collect();
    ways.dedup();
    for name in ways {
        let of_way = || points.iter().filter(|point| way(point.mesh) == name);
        let other = others.iter().find(|(other, _)| other == name);
        let marker = if other.is_some() { Marker::Triangle } else { Marker::Square };
        let color = |point: &Point| other.map_or_else(|| color_of(point.mesh).unwrap_or(INK), |(_, color)| *color);
        for figure in [|point: &Point| point.mean_spacings, |point: &Point| point.hausdorff_spacings] {
            let line: Vec<(f64, f64)> = of_way().map(|point| (point.ms, figure(point))).collect();
            chart.draw_series(LineSeries::new(line, of_way().map(color).next_back().unwrap_or(INK).stroke_width(1)))?;
        }
        for point in of_way() {
            let [mean, largest] = [point.mean_spacings, point.hausdorff_spacings]
                .map(|spacings| chart.backend_coord(&(point.ms, spacings)));
            marker.draw(picture, mean, (color(point), false), point.cells)?;
            marker.draw(picture, largest, (color(point), true), "")?;
        }
    }
    Ok(())
}
