//! `brooklet bench surfaces`: how far each way to smooth is from surfaces that are known, at what cost.

mod density_field;
mod drawn;
mod errors;
mod listed;
mod picture;
mod plot;
mod seen;
mod shapes;

use brooklet_gpu::{Gpu, tier_name};
use brooklet_render::{Camera, View};
use glam::DVec3;
use serde::Serialize;

use super::{check_folder, open};
use crate::{
    bench_options::SurfacesOptions,
    commit::COMMIT,
    failure::Failure,
    interrupt::Interrupt,
    out_dir, progress,
    table::{bytes, table},
};
use density_field::DensityField;
use drawn::{Drawn, FILTERS};
use errors::{Errors, errors};
use seen::Seen;
use shapes::{DOMAIN_M, SPACING_M, Shape};

/// From the middle of a body to the eye.
const TOWARD_EYE: DVec3 = DVec3::new(0.45, 0.55, 0.85);
const FOV_DEG: f64 = 30.0;
/// How far the eye is, m: a spacing takes many pixels, some, and one or two.
const DISTANCES_M: [f64; 3] = [1.8, 3.6, 7.2];
/// The reference that is no filter.
const MARCHED: &str = "density field";

/// What is seen of a body with one filter from one distance.
#[derive(Clone, Debug, Serialize)]
struct Row {
    shape: &'static str,
    filter: &'static str,
    distance_m: f64,
    spacing_px: f64,
    #[serde(flatten)]
    errors: Errors,
    /// None for what no GPU drew.
    smoothing_ms: Option<f64>,
    surface_ms: Option<f64>,
    texture_bytes: Option<u64>,
}

/// Everything, as `--json` has it.
#[derive(Clone, Debug, Serialize)]
struct Study {
    device: String,
    device_type: String,
    tier: &'static str,
    commit: &'static str,
    size_px: [u32; 2],
    spacing_m: f64,
    rows: Vec<Row>,
}

/// Runs and prints the study.
pub fn bench(options: &SurfacesOptions) -> Result<(), Failure> {
    for (option, file) in [("--plot", &options.plot), ("--csv", &options.csv), ("--picture", &options.picture)] {
        if let Some(file) = file {
            check_folder(option, file)?;
        }
    }
    let gpu = open(&options.device)?;
    let interrupt = Interrupt::listen()?;
    let (study, sheet) = study(&gpu, options, &interrupt)?;
    if let Some(file) = &options.csv {
        out_dir::write_file(file, csv(&study)?.as_bytes())?;
    }
    if let Some(file) = &options.plot {
        out_dir::write_file(file, plot::svg(&study)?.as_bytes())?;
    }
    if let Some(file) = &options.picture {
        sheet.save(file)?;
    }
    match options.json {
        true => say!("{}", serde_json::to_string_pretty(&study).map_err(Failure::stopped)?),
        false => print(&study),
    }
    Ok(())
}

fn view(shape: Shape, distance_m: f64, size_px: [u32; 2]) -> View {
    let target_m = shape.middle_m();
    View {
        camera: Camera { eye_m: target_m + distance_m * TOWARD_EYE.normalize(), target_m, fov_deg: FOV_DEG },
        domain_min_m: DVec3::ZERO,
        domain_max_m: DVec3::splat(DOMAIN_M),
        size_px,
    }
}

/// All rows, and the pictures of the nearest view.
fn study(gpu: &Gpu, options: &SurfacesOptions, interrupt: &Interrupt) -> Result<(Study, picture::Sheet), Failure> {
    let size_px = [options.width, options.height];
    let bar = progress::bar((Shape::ALL.len() * DISTANCES_M.len() * (FILTERS.len() + 1)) as u64);
    let mut rows = Vec::new();
    let mut sheet = picture::Sheet::new(size_px);
    for shape in Shape::ALL {
        let particles_m = shape.particles_m();
        let field = DensityField::new(&particles_m, SPACING_M, shape.in_glass().then_some(DOMAIN_M));
        for distance_m in DISTANCES_M {
            let view = view(shape, distance_m, size_px);
            let spacing_px = SPACING_M / distance_m / view.tan_half().y * 0.5 * f64::from(size_px[1]);
            let known = Seen::of(&shape, &view, DOMAIN_M);
            let mut add = |filter: &'static str, seen: &Seen, cost: Option<&Drawn>| {
                let errors = errors(seen, &known, spacing_px).ok_or_else(|| {
                    Failure::stopped(format_args!("the {} at {distance_m} m is not seen with {filter}", shape.name()))
                })?;
                rows.push(Row {
                    shape: shape.name(),
                    filter,
                    distance_m,
                    spacing_px,
                    errors,
                    smoothing_ms: cost.map(|drawn| drawn.smoothing_ms),
                    surface_ms: cost.map(|drawn| drawn.all_ms),
                    texture_bytes: cost.map(|drawn| drawn.texture_bytes),
                });
                if distance_m == DISTANCES_M[0] {
                    sheet.add(shape.name(), seen);
                }
                bar.inc(1);
                Ok::<_, Failure>(())
            };
            for filter in FILTERS {
                let body = (shape, &particles_m[..]);
                let drawn = drawn::draw(gpu, body, filter, &view, options.repeats as usize, interrupt)?;
                add(filter.name, &drawn.seen, Some(&drawn))?;
            }
            add(MARCHED, &Seen::of(&field, &view, DOMAIN_M), None)?;
            if distance_m == DISTANCES_M[0] {
                sheet.add(shape.name(), &known);
            }
        }
    }
    bar.finish_and_clear();
    let info = gpu.info();
    let study = Study {
        device: info.name.clone(),
        device_type: info.device_type.clone(),
        tier: tier_name(gpu.tier()),
        commit: COMMIT,
        size_px,
        spacing_m: SPACING_M,
        rows,
    };
    Ok((study, sheet))
}

fn csv(study: &Study) -> Result<String, Failure> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer
        .write_record([
            "shape",
            "filter",
            "distance_m",
            "spacing_px",
            "normal_mean_deg",
            "normal_p95_deg",
            "normal_inner_mean_deg",
            "outline_px",
            "outline_spacings",
            "covered_px",
            "smoothing_ms",
            "surface_ms",
            "texture_bytes",
        ])
        .map_err(Failure::stopped)?;
    let optional = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
    for row in &study.rows {
        let errors = &row.errors;
        writer
            .write_record([
                row.shape.to_owned(),
                row.filter.to_owned(),
                row.distance_m.to_string(),
                row.spacing_px.to_string(),
                errors.normal_mean_deg.to_string(),
                errors.normal_p95_deg.to_string(),
                errors.normal_inner_mean_deg.to_string(),
                errors.outline_px.to_string(),
                errors.outline_spacings.to_string(),
                errors.covered_px.to_string(),
                optional(row.smoothing_ms),
                optional(row.surface_ms),
                row.texture_bytes.map_or_else(String::new, |bytes| bytes.to_string()),
            ])
            .map_err(Failure::stopped)?;
    }
    String::from_utf8(writer.into_inner().map_err(Failure::stopped)?).map_err(Failure::stopped)
}

fn print(study: &Study) {
    let [width, height] = study.size_px;
    say!("{width} x {height} pixels, spacing {} m, on {} as {}", study.spacing_m, study.device, study.tier);
    if study.device_type == "cpu" {
        say!("(this driver runs on the processor: its times are the processor's)");
    }
    let header = [
        "body",
        "filter",
        "m",
        "normals deg",
        "p95",
        "inside",
        "outline px",
        "spacings",
        "smoothing ms",
        "all ms",
        "textures",
    ];
    let mut list = table(&header, &[2, 3, 4, 5, 6, 7, 8, 9, 10]);
    let ms = |value: Option<f64>| value.map_or_else(|| "-".into(), |ms| format!("{ms:.2}"));
    for row in &study.rows {
        let errors = &row.errors;
        list.add_row([
            row.shape.to_owned(),
            row.filter.to_owned(),
            format!("{}", row.distance_m),
            format!("{:.2}", errors.normal_mean_deg),
            format!("{:.2}", errors.normal_p95_deg),
            format!("{:.2}", errors.normal_inner_mean_deg),
            format!("{:.2}", errors.outline_px),
            format!("{:.2}", errors.outline_spacings),
            ms(row.smoothing_ms),
            ms(row.surface_ms),
            row.texture_bytes.map_or_else(|| "-".into(), bytes),
        ]);
    }
    say!("\n{}", list.trim_fmt());
    say!(
        "\nnormals: angle to the known surface's, mean and 95 of 100 pixels; inside: without 3 pixels at outlines;\n\
         outline: pixels that one of the surfaces alone covers, over the length of the known outline"
    );
}
