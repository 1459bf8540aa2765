//! `brooklet bench surfaces` for people.

use brooklet_bench::surfaces::Surfaces;

use crate::table::{bytes, table};

/// Prints the tables of ways to smooth and to mesh.
pub fn print(surfaces: &Surfaces) {
    let [width, height] = surfaces.size_px;
    say!("{width} x {height} pixels, spacing {} m, on {} as {}", surfaces.spacing_m, surfaces.device, surfaces.tier);
    if surfaces.device_type == "cpu" {
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
    for row in &surfaces.rows {
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
    print_meshes(surfaces);
}

/// Prints the table of meshes, if there are any.
fn print_meshes(surfaces: &Surfaces) {
    if surfaces.meshes.is_empty() {
        return;
    }
    let header =
        ["body", "mesh", "vertices", "triangles", "mean", "Hausdorff", "volume %", "normals deg", "ms", "buffers"];
    let mut list = table(&header, &[2, 3, 4, 5, 6, 7, 8, 9]);
    for row in &surfaces.meshes {
        list.add_row([
            row.shape.to_owned(),
            row.mesh.clone(),
            row.vertices.to_string(),
            row.triangles.to_string(),
            format!("{:.3}", row.errors.mean_spacings),
            format!("{:.2}", row.errors.hausdorff_spacings),
            format!("{:+.2}", 100.0 * row.errors.volume_error),
            format!("{:.2}", row.errors.normal_mean_deg),
            row.ms.map_or_else(|| "-".into(), |ms| format!("{ms:.2}")),
            row.bytes.map_or_else(|| "-".into(), bytes),
        ]);
    }
    say!("\n{}", list.trim_fmt());
    say!(
        "\nmean: from the mesh to the known surface, by area; Hausdorff: the largest distance either way; both in spacings"
    );
    if surfaces.meshes.iter().any(|row| row.bytes.is_none()) {
        say!("another program's ms are what it says of itself, without reading and writing; it runs on the processor");
    }
}
