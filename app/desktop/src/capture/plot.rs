//! Pictures of a summary and of a comparison.

use std::path::Path;

use brooklet_capture::{PassRatio, Quantiles, Verdict};
use plotters::{coord::Shift, prelude::*};

use crate::{failure::Failure, out_dir::write_file};

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawn = Result<(), Box<dyn std::error::Error>>;

const FONT: &str = "sans-serif";
const INK: RGBColor = RGBColor(40, 44, 52);
const GRID_LINE: RGBColor = RGBColor(226, 228, 232);
const BAR: RGBColor = RGBColor(86, 180, 233);
const TAIL: RGBColor = RGBColor(0, 114, 178);
const SLOWER: RGBColor = RGBColor(213, 94, 0);
const FASTER: RGBColor = RGBColor(0, 158, 115);
const NOT_TOLD: RGBColor = RGBColor(140, 146, 158);

const WIDTH: u32 = 960;
const ROW: u32 = 22;
/// Left of the axes, for the names.
const NAMES: u32 = 220;

/// Draws each pass's median as a bar and its p95 as a line, the longest first.
pub fn passes(path: &Path, passes: &[(&str, Quantiles)]) -> Result<(), Failure> {
    let mut longest = passes.to_vec();
    longest.sort_by(|a, b| b.1.median.total_cmp(&a.1.median));
    let names: Vec<&str> = longest.iter().map(|(name, _)| *name).collect();
    let most = longest.iter().map(|(_, quantiles)| quantiles.p95).fold(1e-6, f64::max);
    let title = "GPU time of each pass a frame, ms: median (bar) and p95 (line)";
    picture(path, title, &names, 0.0..1.05 * most, |row| {
        let (_, quantiles) = longest[row];
        vec![(Mark::Bar, BAR, 0.0, quantiles.median), (Mark::Line, TAIL, quantiles.median, quantiles.p95)]
    })
}

/// Draws each pass's ratio with its interval, in percent.
pub fn ratios(path: &Path, passes: &[PassRatio], threshold: Option<f64>) -> Result<(), Failure> {
    let names: Vec<&str> = passes.iter().map(|pass| &*pass.stage).collect();
    let percent = |ratio: f64| (100.0 * (ratio - 1.0)).clamp(-100.0, 400.0);
    let ends = passes.iter().flat_map(|pass| pass.interval.map(percent));
    let (least, most) = ends.fold((-5.0_f64, 5.0_f64), |(least, most), end| (least.min(end), most.max(end)));
    let title = "B to A, %: ratio of medians with an interval for all passes at once";
    picture(path, title, &names, 1.1 * least..1.1 * most, |row| {
        let pass = &passes[row];
        let color = match pass.verdict {
            Verdict::Slower => SLOWER,
            Verdict::Faster => FASTER,
            Verdict::NotTold => NOT_TOLD,
        };
        let mut marks = vec![
            (Mark::Line, color, percent(pass.interval[0]), percent(pass.interval[1])),
            (Mark::Point, color, percent(pass.ratio), percent(pass.ratio)),
        ];
        marks.extend(threshold.map(|share| (Mark::Tick, SLOWER, 100.0 * share, 100.0 * share)));
        marks.push((Mark::Tick, INK, 0.0, 0.0));
        marks
    })
}

#[derive(Clone, Copy)]
enum Mark {
    Bar,
    Line,
    Point,
    Tick,
}

/// A row for each name, with its marks along the axis.
fn picture(
    path: &Path,
    title: &str,
    names: &[&str],
    axis: std::ops::Range<f64>,
    marks: impl Fn(usize) -> Vec<(Mark, RGBColor, f64, f64)>,
) -> Result<(), Failure> {
    let height = ROW * names.len().max(1) as u32 + 100;
    let mut text = String::new();
    let draw = |area: &Area<'_>| -> Drawn {
        area.fill(&WHITE)?;
        area.draw(&Text::new(title, (24, 14), (FONT, 18).into_font().color(&INK)))?;
        let (_, body) = area.split_vertically(44);
        let rows = names.len().max(1) as f64;
        let mut chart = ChartBuilder::on(&body)
            .margin_right(24)
            .x_label_area_size(36)
            .y_label_area_size(NAMES)
            .build_cartesian_2d(axis.clone(), rows..0.0)?;
        chart
            .configure_mesh()
            .disable_y_mesh()
            .light_line_style(WHITE)
            .bold_line_style(GRID_LINE)
            .axis_style(GRID_LINE)
            .y_labels(0)
            .label_style((FONT, 13).into_font().color(&INK))
            .draw()?;
        for (row, name) in names.iter().enumerate() {
            let middle = row as f64 + 0.5;
            let (_, y) = chart.backend_coord(&(axis.start, middle));
            area.draw(&Text::new((*name).to_string(), (24, y - 7), (FONT, 13).into_font().color(&INK)))?;
            for (mark, color, from, to) in marks(row) {
                let bar = |half: f64| Rectangle::new([(from, middle - half), (to, middle + half)], color.filled());
                match mark {
                    Mark::Bar => drop(chart.draw_series([bar(0.35)])?),
                    Mark::Line => {
                        let line = PathElement::new(vec![(from, middle), (to, middle)], color.stroke_width(2));
                        chart.draw_series([line])?;
                    }
                    Mark::Point => drop(chart.draw_series([Circle::new((from, middle), 4, color.filled())])?),
                    Mark::Tick => {
                        let ends = vec![(from, middle - 0.5), (from, middle + 0.5)];
                        chart.draw_series([PathElement::new(ends, color.stroke_width(1))])?;
                    }
                }
            }
        }
        Ok(())
    };
    let drawn = {
        let area = SVGBackend::with_string(&mut text, (WIDTH, height)).into_drawing_area();
        draw(&area).and_then(|()| Ok(area.present()?))
    };
    drawn.map_err(|error| Failure::stopped(format_args!("the plot cannot be drawn: {error}")))?;
    write_file(path, text.as_bytes())
}
