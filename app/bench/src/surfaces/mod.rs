//! How far each way to smooth or mesh is from surfaces that are known, at what cost.

mod csv_tables;
mod density_field;
mod distance;
mod drawn;
mod errors;
mod listed;
mod mesh_errors;
mod meshes;
mod other_program;
mod picture;
mod plot;
mod plot_meshes;
mod plot_style;
mod seen;
mod shapes;
mod timed;
mod ways;

use brooklet_gpu::{Gpu, tier_name};
use brooklet_render::{Camera, View};
use glam::DVec3;
use serde::Serialize;

use crate::{BenchError, Observer};
use density_field::DensityField;
use drawn::Drawn;
pub use errors::Errors;
use errors::errors;
pub use mesh_errors::MeshErrors;
pub use meshes::MeshRow;
pub use other_program::OtherProgram;
pub use picture::Sheet;
use seen::Seen;
use shapes::{DOMAIN_M, SPACING_M, Shape};
use ways::{Cells, FILTERS, Filter, MARCHED, Mesh};

/// How surfaces are drawn and timed.
#[derive(Clone, Debug)]
pub struct Options {
    /// Which of [`bodies`].
    pub bodies: Vec<&'static str>,
    /// Which of [`ways`].
    pub ways: Vec<&'static str>,
    /// Width and height of the pictures, pixels.
    pub size_px: [u32; 2],
    /// Pictures and meshes that are timed of each.
    pub repeats: usize,
    /// What else meshes the bodies, with the cells of these ways.
    pub beside: Option<OtherProgram>,
}

/// From the middle of a body to the eye.
const TOWARD_EYE: DVec3 = DVec3::new(0.45, 0.55, 0.85);
const FOV_DEG: f64 = 30.0;
/// How far the eye is, m: a spacing takes many pixels, some, and one or two.
const DISTANCES_M: [f64; 3] = [1.8, 3.6, 7.2];

/// What is seen of a body with one filter from one distance.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// The body.
    pub shape: &'static str,
    /// What smoothed it.
    pub filter: &'static str,
    /// From its middle to the eye, m.
    pub distance_m: f64,
    /// Pixels that a particle spacing takes.
    pub spacing_px: f64,
    /// How far it is from the known surface.
    #[serde(flatten)]
    pub errors: Errors,
    /// Of the smoothing's passes, ms of a picture; none for what no GPU drew.
    pub smoothing_ms: Option<f64>,
    /// Of all passes, ms of a picture.
    pub surface_ms: Option<f64>,
    /// Of the textures that the surface needs.
    pub texture_bytes: Option<u64>,
}

/// Every way to smooth on every body from every distance.
#[derive(Clone, Debug, Serialize)]
pub struct Surfaces {
    /// What it ran on.
    pub device: String,
    /// `cpu` of a driver that runs on the processor.
    pub device_type: String,
    /// What the device was used as.
    pub tier: &'static str,
    /// Width and height of the pictures, pixels.
    pub size_px: [u32; 2],
    /// Of the bodies' particles, m.
    pub spacing_m: f64,
    /// By body, distance, filter.
    pub rows: Vec<Row>,
    /// The meshes themselves: by body, and how it was meshed.
    pub meshes: Vec<MeshRow>,
}

impl Surfaces {
    /// For each body the normals' error over the distance; of all, what that costs, and meshes' distances likewise.
    /// An SVG picture.
    ///
    /// # Errors
    /// What the plot cannot be drawn for.
    pub fn to_svg(&self) -> Result<String, BenchError> {
        plot::svg(self)
    }
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

/// What the bodies are called, those first that are drawn as well as meshed.
pub fn bodies() -> Vec<&'static str> {
    Shape::MESHED.map(Shape::name).to_vec()
}

/// What the ways to smooth and to mesh are called.
pub fn ways() -> Vec<&'static str> {
    ways::names().collect()
}

/// All rows, and the pictures of the nearest view.
///
/// # Errors
/// Every [`BenchError`]; bodies and ways that leave nothing to do, and a body that a way leaves nothing of, among them.
pub fn run(gpu: &Gpu, options: &Options, observer: &dyn Observer) -> Result<(Surfaces, Sheet), BenchError> {
    let filters: Vec<Filter> = FILTERS.into_iter().filter(|filter| options.ways.contains(&filter.name)).collect();
    let meshed: Vec<(Filter, Mesh)> = filters.iter().filter_map(|&filter| Some((filter, filter.mesh?))).collect();
    let chosen = |shape: &Shape| options.bodies.contains(&shape.name());
    let drawn: Vec<Shape> = Shape::ALL.into_iter().filter(chosen).collect();
    let meshed_bodies: Vec<Shape> = Shape::MESHED.into_iter().filter(chosen).collect();
    let mut cells: Vec<Cells> = Vec::new();
    for (_, mesh) in meshed.iter().filter(|_| options.beside.is_some()) {
        if !cells.contains(&mesh.cells) {
            cells.push(mesh.cells);
        }
    }
    let parts = drawn.len() * options.ways.len() + meshed_bodies.len() * (meshed.len() + 2 * cells.len());
    if parts == 0 {
        return Err(BenchError::input("these bodies are meshed, not drawn, and none of these ways meshes"));
    }
    observer.begin(parts as u64);
    let mut meshes = Vec::new();
    for shape in meshed_bodies {
        let particles_m = shape.particles_m();
        for &way in &meshed {
            observer.message(format!("{}: {}", shape.name(), way.0.name));
            meshes.push(meshes::mesh(gpu, (shape, &particles_m), way, options.repeats, observer)?);
            observer.advance();
        }
        let Some(program) = &options.beside else { continue };
        for is_smoothed in [false, true] {
            for &cells in &cells {
                let how = (cells, is_smoothed);
                meshes.push(program.mesh((shape, &particles_m), how, options.repeats, observer)?);
                observer.advance();
            }
        }
    }
    let (mut rows, mut sheet) = (Vec::new(), Sheet::new(options.size_px));
    for shape in drawn {
        rows.extend(draw_body(gpu, shape, (&filters, options), &mut sheet, observer)?);
    }
    let info = gpu.info();
    let surfaces = Surfaces {
        device: info.name.clone(),
        device_type: info.device_type.clone(),
        tier: tier_name(gpu.tier()),
        size_px: options.size_px,
        spacing_m: SPACING_M,
        rows,
        meshes,
    };
    Ok((surfaces, sheet))
}

/// The rows of a body by distance and way; its nearest pictures go to `sheet`.
fn draw_body(
    gpu: &Gpu,
    shape: Shape,
    (filters, options): (&[Filter], &Options),
    sheet: &mut Sheet,
    observer: &dyn Observer,
) -> Result<Vec<Row>, BenchError> {
    let particles_m = shape.particles_m();
    let views = DISTANCES_M.map(|distance_m| view(shape, distance_m, options.size_px));
    let known = views.each_ref().map(|view| Seen::of(&shape, view, DOMAIN_M));
    let mut rows = Vec::new();
    let mut add = |filter: &'static str, i: usize, seen: &Seen, cost: Option<&Drawn>| {
        let (distance_m, view) = (DISTANCES_M[i], &views[i]);
        let spacing_px = SPACING_M / distance_m / view.tan_half().y * 0.5 * f64::from(options.size_px[1]);
        let errors = errors(seen, &known[i], spacing_px).ok_or_else(|| {
            BenchError::stopped(format_args!("the {} at {distance_m} m is not seen with {filter}", shape.name()))
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
        if i == 0 {
            sheet.add(shape.name(), seen);
        }
        Ok::<_, BenchError>(())
    };
    for &filter in filters {
        observer.message(format!("{}: {}", shape.name(), filter.name));
        let drawn = drawn::draw(gpu, (shape, &particles_m), filter, &views, options.repeats, observer)?;
        for (i, drawn) in drawn.iter().enumerate() {
            add(filter.name, i, &drawn.seen, Some(drawn))?;
        }
        observer.advance();
    }
    if options.ways.contains(&MARCHED) {
        observer.message(format!("{}: {MARCHED}", shape.name()));
        let field = DensityField::new(&particles_m, SPACING_M, shape.in_walls().then_some(DOMAIN_M));
        for (i, view) in views.iter().enumerate() {
            observer.check()?;
            add(MARCHED, i, &Seen::of(&field, view, DOMAIN_M), None)?;
        }
        observer.advance();
    }
    sheet.add(shape.name(), &known[0]);
    rows.sort_by(|a, b| a.distance_m.total_cmp(&b.distance_m));
    Ok(rows)
}
