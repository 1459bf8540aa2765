//! The study as CSV, a table a file.

use super::{MeshRow, Surfaces};
use crate::BenchError;

const PICTURES: [&str; 13] = [
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
];
const MESHES: [&str; 12] = [
    "shape",
    "program",
    "mesh",
    "cell_ratio",
    "vertices",
    "triangles",
    "mean_spacings",
    "hausdorff_spacings",
    "volume_error",
    "normal_mean_deg",
    "ms",
    "bytes",
];

impl Surfaces {
    /// The pictures' rows as CSV.
    ///
    /// # Errors
    /// Of the text's encoding: none is known.
    pub fn to_csv(&self) -> Result<String, BenchError> {
        let rows = self.rows.iter().map(|row| {
            let errors = &row.errors;
            [
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
                optional(row.texture_bytes),
            ]
        });
        table(PICTURES, rows)
    }

    /// The meshes' rows as CSV.
    ///
    /// # Errors
    /// As [`Self::to_csv`].
    pub fn meshes_to_csv(&self) -> Result<String, BenchError> {
        let rows = self.meshes.iter().map(|row: &MeshRow| {
            let errors = &row.errors;
            [
                row.shape.to_owned(),
                row.program.clone(),
                row.mesh.clone(),
                row.cell_ratio.to_string(),
                row.vertices.to_string(),
                row.triangles.to_string(),
                errors.mean_spacings.to_string(),
                errors.hausdorff_spacings.to_string(),
                errors.volume_error.to_string(),
                errors.normal_mean_deg.to_string(),
                optional(row.ms),
                optional(row.bytes),
            ]
        });
        table(MESHES, rows)
    }
}

fn optional(value: Option<impl ToString>) -> String {
    value.map_or_else(String::new, |value| value.to_string())
}

fn table<const N: usize>(header: [&str; N], rows: impl Iterator<Item = [String; N]>) -> Result<String, BenchError> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(header).map_err(BenchError::stopped)?;
    for row in rows {
        writer.write_record(row).map_err(BenchError::stopped)?;
    }
    String::from_utf8(writer.into_inner().map_err(BenchError::stopped)?).map_err(BenchError::stopped)
}
