//! `brooklet mesh`: the surface of anybody's particles.

use std::time::{Duration, Instant};

use brooklet_gpu::tier_name;
use brooklet_kernels::Position;
use brooklet_render::MarchingCubesOptions;
use brooklet_render::surface::marching_cubes::export::{ExportError, HostMesh, mesh_particles};
use indicatif::{ProgressBar, ProgressStyle};
use serde::Serialize;

use crate::{
    estimate_spacing::estimate_spacing,
    failure::Failure,
    job,
    mesh_file::{self, MeshFormat},
    mesh_options::{CellSide, MeshOptions},
    out_dir,
    point_cloud::{self, PointCloud},
};

/// Spacings that a surface stands out from its particles at most, and there is room for around them.
const MARGIN_SPACINGS: f64 = 2.0;
/// Sides of a cell over the spacing at least: the grid of blocks ends one behind the particles.
const LEAST_CELL_RATIO: f64 = 0.25;

/// What was done.
#[derive(Serialize)]
struct Meshed {
    particles: usize,
    /// Left out: their positions are not finite.
    not_finite: usize,
    /// Left out: beyond the walls.
    outside: usize,
    spacing_m: f64,
    spacing_is_estimated: bool,
    cell_m: f64,
    blocks_of_box: [u32; 3],
    blocks: u32,
    vertices: usize,
    triangles: usize,
    volume_m3: f64,
    read_s: f64,
    mesh_s: f64,
    write_s: f64,
    device: String,
    tier: &'static str,
    file: String,
}

/// Meshes particles.
pub fn mesh(options: &MeshOptions) -> Result<(), Failure> {
    let out = &options.out;
    let Some(format) = MeshFormat::of(out) else {
        return Err(Failure::Input(format!("--out {}: its name must end in .ply or .obj", out.display())));
    };
    let walls_m = options.walls.as_deref().map(walls).transpose()?;
    out_dir::check_writable("--out", out)?;

    let begun = Instant::now();
    let bar = reading_bar();
    let cloud = point_cloud::read(&options.particles, &bar)?;
    bar.finish_and_clear();
    let PointCloud { mut positions_m, not_finite } = cloud;
    let finite = positions_m.len();
    if let Some([min_m, max_m]) = walls_m {
        positions_m.retain(|position_m| (0..3).all(|axis| (min_m[axis]..=max_m[axis]).contains(&position_m[axis])));
        if positions_m.is_empty() {
            let name = options.particles.display();
            return Err(Failure::Input(format!("--walls: none of the {finite} particles of {name} is between them")));
        }
    }
    let read_s = begun.elapsed().as_secs_f64();

    let begun = Instant::now();
    let bar = waiting_bar("spacing");
    let spacing_m = match options.spacing.or_else(|| estimate_spacing(&positions_m)) {
        Some(spacing_m) => spacing_m,
        None => return Err(no_spacing(options, positions_m.len())),
    };
    let cell_m = match options.cell {
        CellSide::Metres(cell_m) => cell_m,
        CellSide::Ratio(ratio) => ratio * spacing_m,
    };
    // A quarter of a spacing, rounded on the way, is a quarter of a spacing.
    if cell_m < (1.0 - 1.0e-9) * LEAST_CELL_RATIO * spacing_m {
        return Err(Failure::Input(format!(
            "--cell {cell_m}: a cell of particles {spacing_m} m apart must have a side of {} m or more",
            LEAST_CELL_RATIO * spacing_m
        )));
    }
    let (positions, origin_m, meshing) = within_box(&positions_m, walls_m, spacing_m, cell_m);
    let particles = positions.len();
    drop(positions_m);
    let gpu = job::open(&options.device, false)?;
    bar.set_message(format!("meshing {particles} particles"));
    let meshed = mesh_particles(&gpu, &positions, &meshing).map_err(|error| refused(options, &error))?;
    let mesh_s = begun.elapsed().as_secs_f64();

    let begun = Instant::now();
    bar.set_message(format!("writing {} triangles", meshed.triangles.len()));
    mesh_file::write(out, format, &meshed, origin_m)?;
    bar.finish_and_clear();
    let done = Meshed {
        particles,
        not_finite,
        outside: finite - particles,
        spacing_m,
        spacing_is_estimated: options.spacing.is_none(),
        cell_m,
        blocks_of_box: meshing.blocks(),
        blocks: meshed.blocks,
        vertices: meshed.vertices.len(),
        triangles: meshed.triangles.len(),
        volume_m3: meshed.volume_m3(),
        read_s,
        mesh_s,
        write_s: begun.elapsed().as_secs_f64(),
        device: gpu.info().name.clone(),
        tier: tier_name(gpu.tier()),
        file: out.display().to_string(),
    };
    if options.json {
        say!("{}", serde_json::to_string_pretty(&done).map_err(Failure::stopped)?);
    } else {
        print(&done, &meshed);
    }
    Ok(())
}

fn walls(corners: &[f64]) -> Result<[[f64; 3]; 2], Failure> {
    let (min_m, max_m): ([f64; 3], [f64; 3]) =
        (std::array::from_fn(|axis| corners[axis]), std::array::from_fn(|axis| corners[3 + axis]));
    let is_box = (0..3).all(|axis| min_m[axis] < max_m[axis] && min_m[axis] >= -1.0e12 && max_m[axis] <= 1.0e12);
    is_box.then_some([min_m, max_m]).ok_or_else(|| {
        Failure::Input(format!(
            "--walls {min_m:?} to {max_m:?}: the second corner must be above the first along each axis, each from \
             -1e12 to 1e12 m"
        ))
    })
}

fn no_spacing(options: &MeshOptions, count: usize) -> Failure {
    let name = options.particles.display();
    let why = match count {
        1 => "one particle has no spacing".into(),
        _ => format!("most of its {count} particles are in one place"),
    };
    Failure::Input(format!("{name}: {why}; say one with --spacing"))
}

/// The particles relative to the lowest corner of a box around them, that corner, and how they are meshed there.
fn within_box(
    positions_m: &[[f64; 3]],
    walls_m: Option<[[f64; 3]; 2]>,
    spacing_m: f64,
    cell_m: f64,
) -> (Vec<Position>, [f64; 3], MarchingCubesOptions) {
    let margin_m = MARGIN_SPACINGS * spacing_m;
    let bound = |start: f64, of: fn(f64, f64) -> f64| -> [f64; 3] {
        std::array::from_fn(|axis| positions_m.iter().map(|position_m| position_m[axis]).fold(start, of))
    };
    let [min_m, max_m] = walls_m.unwrap_or_else(|| {
        [bound(f64::INFINITY, f64::min).map(|m| m - margin_m), bound(f64::NEG_INFINITY, f64::max).map(|m| m + margin_m)]
    });
    let size_m: [f64; 3] = std::array::from_fn(|axis| max_m[axis] - min_m[axis]);
    let positions: Vec<Position> = positions_m
        .iter()
        .map(|position_m| Position {
            position_m: std::array::from_fn(|axis| (position_m[axis] - min_m[axis]) as f32),
            tag: 0,
        })
        .collect();
    let wall_bounds_m = match walls_m {
        Some(_) => [[0.0; 3], size_m],
        None => [[f64::NEG_INFINITY; 3], [f64::INFINITY; 3]],
    };
    let meshing = MarchingCubesOptions::for_particles(positions.len(), spacing_m, cell_m, size_m, wall_bounds_m);
    (positions, min_m, meshing)
}

fn refused(options: &MeshOptions, error: &ExportError) -> Failure {
    let advice = match error {
        ExportError::TooFine { .. } => " (--cell); particles far from all others make the box large",
        _ => "",
    };
    let text = format!("{}: {error}{advice}", options.particles.display());
    if error.is_input() { Failure::Input(text) } else { Failure::Stopped(text) }
}

fn print(done: &Meshed, mesh: &HostMesh) {
    say!("particles {}", done.particles);
    if done.not_finite > 0 {
        say!("          {} more are left out: their positions are not finite", done.not_finite);
    }
    if done.outside > 0 {
        say!("          {} more are left out: they are not between the walls", done.outside);
    }
    let how = if done.spacing_is_estimated { " (estimated: half of them have their six nearest within)" } else { "" };
    say!("spacing   {:.6} m{how}", done.spacing_m);
    let [x, y, z] = done.blocks_of_box;
    say!("cells     {:.6} m; {} blocks of 4 x 4 x 4 of {x} x {y} x {z} may have surface", done.cell_m, done.blocks);
    say!("mesh      {} vertices, {} triangles, volume {:.6e} m3", done.vertices, done.triangles, done.volume_m3);
    let again = if mesh.runs > 1 { format!(", {} times for want of room", mesh.runs) } else { String::new() };
    say!(
        "time      {:.2} s to read, {:.2} s to mesh on {} as {}{again}, {:.2} s to write",
        done.read_s,
        done.mesh_s,
        done.device,
        done.tier,
        done.write_s
    );
    say!("file      {}", done.file);
}

/// A bar over a file's bytes, on standard error.
fn reading_bar() -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:32} reading, {bytes} of {total_bytes}");
    ProgressBar::new(0).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

/// What is being done, and for how long.
fn waiting_bar(what: &'static str) -> ProgressBar {
    let style = ProgressStyle::with_template("{spinner} {msg}, {elapsed}");
    let bar = ProgressBar::new_spinner().with_style(style.unwrap_or_else(|_| ProgressStyle::default_spinner()));
    bar.set_message(what);
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}
