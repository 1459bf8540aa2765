//! The table as a picture: what a particle's iteration costs, pass by pass, and the rate.

use plotters::{coord::Shift, element::DashedPathElement, prelude::*};

use super::{
    figures::{Row, Scaling},
    targets::{DEFAULT_RATE, EVERY_TERM_RATE},
    workload::LOADS,
};
use crate::BenchError;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

const FONT: &str = "sans-serif";
const INK: RGBColor = RGBColor(40, 44, 52);
const GRID_LINE: RGBColor = RGBColor(226, 228, 232);
/// One for each load.
const RATES: [RGBColor; 3] = [RGBColor(0, 114, 178), RGBColor(86, 180, 233), RGBColor(213, 94, 0)];

/// Colours of the passes: the grid's are blue, the list's orange, the iterations' green, the rest
/// violet, what lies between passes grey.
fn color_of(stage: &str) -> RGBColor {
    match stage {
        "count_cells" => RGBColor(8, 48, 107),
        "reduce_groups" => RGBColor(33, 113, 181),
        "scan_groups" => RGBColor(107, 174, 214),
        "reorder" => RGBColor(158, 202, 225),
        "predict" => RGBColor(84, 39, 136),
        "list_neighbours" => RGBColor(230, 140, 40),
        "constrain_density" => RGBColor(35, 139, 69),
        "correct_positions" => RGBColor(120, 198, 121),
        "update_velocity" => RGBColor(128, 115, 172),
        "xsph" => RGBColor(178, 171, 210),
        BETWEEN => RGBColor(200, 200, 200),
        _ => RGBColor(214, 96, 77),
    }
}

const BETWEEN: &str = "between passes";

impl Scaling {
    /// What a particle's iteration costs, pass by pass, and the rate, as an SVG picture.
    ///
    /// # Errors
    /// What the plot cannot be drawn for: a table without rows.
    pub fn to_svg(&self) -> Result<String, BenchError> {
        svg(self)
    }
}

/// Draws the table.
fn svg(scaling: &Scaling) -> Result<String, BenchError> {
    let mut text = String::new();
    draw(scaling, &mut text).map_err(|error| BenchError::stopped(format_args!("the plot cannot be drawn: {error}")))?;
    Ok(text)
}

fn draw(scaling: &Scaling, text: &mut String) -> Result<(), Box<dyn std::error::Error>> {
    let area = SVGBackend::with_string(text, (1240, 560)).into_drawing_area();
    area.fill(&WHITE)?;
    let (title, charts) = area.split_vertically(44);
    let caption = format!("{} as {}: a block of water at rest, h = 2d", scaling.device, scaling.tier);
    title.draw(&Text::new(caption, (24, 14), (FONT, 20).into_font().color(&INK)))?;
    let (left, right) = charts.split_horizontally(680);
    let first = LOADS[0];
    let rows: Vec<&Row> = scaling.rows.iter().filter(|row| row.is_of(first)).collect();
    if rows.is_empty() {
        return Err("there are no figures".into());
    }
    costs(&left, &rows)?;
    rates(&right, scaling, &rows)?;
    area.present()?;
    Ok(())
}

/// `4k`, `1M`.
fn short(particles: u32) -> String {
    match particles {
        0..1_000_000 => format!("{:.0}k", f64::from(particles) * 1e-3),
        _ => format!("{:.0}M", f64::from(particles) * 1e-6),
    }
}

/// The label of column `x`, which only whole columns have.
fn column_label(rows: &[&Row], x: f64) -> String {
    let row = rows.get(x.round().max(0.0) as usize).filter(|_| (x - x.round()).abs() < 1e-6 && x > -0.5);
    row.map_or_else(String::new, |row| short(row.particles))
}

/// Passes from the bottom of a column to its top.
fn parts(row: &Row) -> Vec<(&'static str, f64)> {
    let mut parts: Vec<_> = row.passes.0.iter().map(|(stage, pass)| (*stage, pass.ns_per_particle_iteration)).collect();
    let passes: f64 = parts.iter().map(|(_, ns)| ns).sum();
    parts.push((BETWEEN, (row.ns_per_particle_iteration - passes).max(0.0)));
    parts
}

fn costs(area: &Area<'_>, rows: &[&Row]) -> Result<(), Box<dyn std::error::Error>> {
    let (chart_area, legend) = area.split_horizontally(500);
    let highest = rows.iter().map(|row| row.ns_per_particle_iteration).fold(0.0, f64::max);
    let mut chart = ChartBuilder::on(&chart_area)
        .margin_left(12)
        .margin_right(8)
        .margin_bottom(8)
        .caption("GPU time a particle and iteration, 4 iterations a step", (FONT, 16).into_font().color(&INK))
        .x_label_area_size(44)
        .y_label_area_size(58)
        .build_cartesian_2d(-0.6..rows.len() as f64 - 0.4, 0.0..highest * 1.08)?;
    chart
        .configure_mesh()
        .disable_x_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(GRID_LINE)
        .axis_style(INK)
        .x_labels(2 * rows.len() + 2)
        .set_tick_mark_size(LabelAreaPosition::Bottom, 0)
        .x_label_formatter(&|x| column_label(rows, *x))
        .y_label_formatter(&|ns| format!("{ns:.0}"))
        .x_desc("particles")
        .y_desc("ns")
        .label_style((FONT, 14).into_font().color(&INK))
        .draw()?;
    for (column, row) in rows.iter().enumerate() {
        let mut bottom = 0.0;
        for (stage, ns) in parts(row) {
            let (left, right) = (column as f64 - 0.36, column as f64 + 0.36);
            let bar = Rectangle::new([(left, bottom), (right, bottom + ns)], color_of(stage).filled());
            chart.draw_series(std::iter::once(bar))?;
            bottom += ns;
        }
    }
    // In the columns' order, from the top.
    let stages = parts(rows[rows.len() - 1]);
    for (line, (stage, _)) in stages.iter().rev().enumerate() {
        let y = 48 + 24 * line as i32;
        legend.draw(&Rectangle::new([(6, y), (20, y + 14)], color_of(stage).filled()))?;
        legend.draw(&Text::new(*stage, (28, y), (FONT, 14).into_font().color(&INK)))?;
    }
    Ok(())
}

fn rates(area: &Area<'_>, scaling: &Scaling, sizes: &[&Row]) -> Result<(), Box<dyn std::error::Error>> {
    let highest = scaling.rows.iter().map(|row| row.particle_iterations_per_s).fold(DEFAULT_RATE, f64::max) * 1e-6;
    let last = sizes.len() as f64 - 1.0;
    let mut chart = ChartBuilder::on(area)
        .margin_left(12)
        .margin_right(24)
        .margin_bottom(8)
        .caption("million particle iterations a second", (FONT, 16).into_font().color(&INK))
        .x_label_area_size(44)
        .y_label_area_size(48)
        .build_cartesian_2d(-0.3..last + 0.3, 0.0..highest * 1.45)?;
    chart
        .configure_mesh()
        .disable_x_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(GRID_LINE)
        .axis_style(INK)
        .x_labels(2 * sizes.len() + 2)
        .set_tick_mark_size(LabelAreaPosition::Bottom, 0)
        .x_label_formatter(&|x| column_label(sizes, *x))
        .y_label_formatter(&|rate| format!("{rate:.1}"))
        .x_desc("particles")
        .label_style((FONT, 14).into_font().color(&INK))
        .draw()?;
    for (target, color) in [(DEFAULT_RATE, RATES[0]), (EVERY_TERM_RATE, RATES[2])] {
        let ends = [(-0.3, target * 1e-6), (last + 0.3, target * 1e-6)];
        chart.draw_series(DashedLineSeries::new(ends, 5, 4, color.mix(0.7).stroke_width(1)))?;
    }
    for (load, color) in LOADS.into_iter().zip(RATES) {
        let column = |row: &Row| sizes.iter().position(|size| size.particles == row.particles);
        let points: Vec<(f64, f64)> = scaling
            .rows
            .iter()
            .filter(|row| row.is_of(load))
            .filter_map(|row| Some((column(row)? as f64, row.particle_iterations_per_s * 1e-6)))
            .collect();
        chart
            .draw_series(LineSeries::new(points.clone(), color.stroke_width(2)))?
            .label(format!("{}, {} iterations", load.terms(), load.iterations))
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 20, y)], color.stroke_width(2)));
        chart.draw_series(points.into_iter().map(|point| Circle::new(point, 4, color.filled())))?;
    }
    chart
        .draw_series(std::iter::empty::<Circle<(f64, f64), i32>>())?
        .label("targets, set for two CPU cores")
        .legend(|(x, y)| DashedPathElement::new([(x, y), (x + 20, y)], 5, 4, INK.stroke_width(1)));
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .background_style(WHITE.mix(0.85))
        .border_style(GRID_LINE)
        .label_font((FONT, 14).into_font().color(&INK))
        .draw()?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_named_by_their_size() {
        let names = [4096, 15_625, 27_000, 1_000_000, 4_096_000].map(short);
        assert_eq!(names, ["4k", "16k", "27k", "1M", "4M"]);
        assert_eq!(column_label(&[], 0.0), "");
    }
}
