//! The triangles of solids: read, made and checked with the scene that asks for them.

use std::fmt::Write as _;
use std::path::Path;

use brooklet_shapes::{
    Field, Heights, MOST_HEIGHTS, MOST_NODES, MOST_NODES_A_SIDE, Mesh, Relief, Repairs, Wheel, checked, hull, terrain,
};
use glam::DVec3;
use toml::Value;

use super::{Checker, rounded_up, tidied};
use crate::scene::field::Short;
use crate::scene::forms::{Form, Triangles};
use crate::scene::{HullShape, MeshShape, Scene, SceneError, SolidSettings, TerrainShape};

/// Share of a surface that may be lost between the nodes of its field: needles, and edges that are sharper than its cells.
const MOST_LOST: f64 = 0.01;
/// Of what particles keep from a surface, how far outside a field may have it: a path that steps by a quarter and a field's
/// steepness then meets it before it is through.
const LOST_AT: f64 = 0.5;
/// Cells that a spacing must have at least.
const COARSEST_SPACINGS: f64 = 1.0;

impl Scene {
    /// Reads and makes the triangles of its solids; paths become absolute, so that the scene means the same wherever it is
    /// written to.
    pub(in crate::scene) fn form_solids(&mut self, source_name: &str) -> Result<(), SceneError> {
        let check = Checker { source_name };
        let folder = Path::new(source_name).parent().unwrap_or(Path::new("")).to_owned();
        if !self.solids.iter().any(SolidSettings::has_triangles) {
            return Ok(());
        }
        // Nothing is made of a number that is none.
        let values = Value::try_from(&*self).map_err(|error| SceneError::Malformed {
            source_name: source_name.into(),
            place: String::new(),
            reason: error.to_string(),
        })?;
        check.limits("", &values)?;
        for index in 0..self.solids.len() {
            if self.solids[index].shapes_given() == 1 && self.solids[index].has_triangles() {
                self.solids[index].resolve_files(&folder);
                let form = self.form_of(&check, &format!("solid.{index}"), &self.solids[index])?;
                self.solids[index].form = form;
            }
        }
        Ok(())
    }

    fn form_of(&self, check: &Checker, field: &str, solid: &SolidSettings) -> Result<Form, SceneError> {
        let is_sheet = solid.thickness_m.is_some();
        let (name, value, form) = match (&solid.mesh, &solid.hull, &solid.wheel, &solid.terrain) {
            (Some(shape), ..) => {
                let key = format!("{} {shape:?} {is_sheet}", stamp(&shape.file));
                ("mesh.file", quoted(&shape.file), Form::of(key, || mesh(shape, is_sheet)))
            }
            (_, Some(shape), ..) => {
                let key = format!("{} {shape:?}", shape.file.as_deref().map_or_else(String::new, stamp));
                let (name, value) = match &shape.file {
                    Some(file) => ("hull.file", quoted(file)),
                    None => ("hull.points_m", format!("{} points", shape.points_m.len())),
                };
                (name, value, Form::of(key, || hull_of(shape)))
            }
            (.., Some(shape), _) => {
                let wheel = shape.wheel();
                let value = format!("radius {}", Short(wheel.radius_m));
                ("wheel", value, Form::of(format!("{wheel:?}"), || wheel_of(&wheel)))
            }
            (.., Some(shape)) => {
                let ground = Ground::of(shape, self, solid);
                let key = format!("{} {ground:?}", shape.file.as_deref().map_or_else(String::new, stamp));
                let name = if shape.file.is_some() { "terrain.file" } else { "terrain" };
                let value = shape.file.as_deref().map_or_else(|| "ground".to_owned(), quoted);
                (name, value, Form::of(key, || ground.triangles()))
            }
            (None, None, None, None) => return Ok(Form::default()),
        };
        let name = format!("{field}.{name}");
        form.or_else(|reason| check.require(false, &name, value, reason).map(|()| Form::default()))
    }

    /// What was repaired of its solids' meshes, in words.
    pub fn repairs(&self) -> Vec<String> {
        let of = |(index, solid): (usize, &SolidSettings)| {
            let said = solid.triangles()?.repairs.said()?;
            Some(format!("solid.{index}.{}, repaired: {said}", solid.triangles_name()))
        };
        self.solids.iter().enumerate().filter_map(of).collect()
    }

    /// No more nodes of fields than there is room for.
    pub(super) fn check_nodes(&self, check: &Checker) -> Result<(), SceneError> {
        let mut all = 0_u64;
        for (index, solid) in self.solids.iter().enumerate() {
            let Some(triangles) = solid.triangles() else { continue };
            let options = solid.field_options(self);
            let field = format!("solid.{index}");
            let coarsest_m = COARSEST_SPACINGS * self.fitted_spacing_m() * (1.0 + 1.0e-6);
            check.require(
                options.cell_m <= coarsest_m || !self.solver.method.interacts(),
                &format!("{field}.{}.cell_m", solid.triangles_name()),
                Short(options.cell_m),
                format_args!(
                    "at most a spacing, {} m: particles would pass what lies in a cell",
                    Short(tidied(COARSEST_SPACINGS * self.fitted_spacing_m()))
                ),
            )?;
            let nodes = Field::nodes_of(triangles.solid.bounds_m(), &options);
            let longest = nodes.into_iter().max().unwrap_or_default();
            let count = nodes.into_iter().fold(1_u64, u64::saturating_mul);
            all = all.saturating_add(count);
            let grows = (all as f64 / MOST_NODES as f64).cbrt().max(longest as f64 / MOST_NODES_A_SIDE as f64);
            check.require(
                all <= MOST_NODES && longest <= MOST_NODES_A_SIDE,
                &format!("{field}.{}.cell_m", solid.triangles_name()),
                Short(tidied(options.cell_m)),
                format_args!(
                    "makes {} x {} x {} nodes, {all} with those before, and {MOST_NODES} fit, {MOST_NODES_A_SIDE} along a \
                     side: {} or more, or a smaller solid",
                    nodes[0],
                    nodes[1],
                    nodes[2],
                    rounded_up(1.1 * options.cell_m * grows)
                ),
            )?;
        }
        Ok(())
    }

    /// Nothing of it so thin that the nodes of its field do not see it.
    pub(super) fn check_field(&self, check: &Checker, field: &str, solid: &SolidSettings) -> Result<(), SceneError> {
        let Some(triangles) = solid.triangles() else { return Ok(()) };
        let Some(of) = solid.field(self) else { return Ok(()) };
        let lost = of.lost(&triangles.solid, LOST_AT * self.wall_offset_m());
        let size_m = triangles.solid.bounds_m();
        let mut value = String::new();
        let size = (size_m[1] - size_m[0]).to_array().map(|side_m| Short(tidied(side_m)));
        let _ = write!(value, "{} x {} x {} m", size[0], size[1], size[2]);
        check.require(
            lost <= MOST_LOST,
            &format!("{field}.{}", solid.triangles_name()),
            value,
            format_args!(
                "{:.0} % of its surface is so thin that particles would pass it: thicker, or a cell_m below {} m, or less \
                 of spacing_m",
                100.0 * lost,
                Short(tidied(of.cell_m))
            ),
        )
    }

    /// A mesh may be a sheet; others are full.
    pub(super) fn check_sheet(&self, check: &Checker, field: &str, solid: &SolidSettings) -> Result<(), SceneError> {
        let thickness_m = Short(solid.thickness_m.unwrap_or_default());
        let is_mesh = solid.mesh.is_some();
        check.require(
            is_mesh,
            &format!("{field}.thickness_m"),
            thickness_m,
            "not with a hull, a wheel or terrain, which are full",
        )?;
        let open = solid.open.is_none();
        check.require(open, &format!("{field}.open"), "a face", "not with a mesh: leave its triangles out there")
    }
}

impl SolidSettings {
    fn triangles_name(&self) -> &'static str {
        match (&self.mesh, &self.hull, &self.wheel) {
            (Some(_), ..) => "mesh",
            (_, Some(_), _) => "hull",
            (.., Some(_)) => "wheel",
            (None, None, None) => "terrain",
        }
    }

    fn resolve_files(&mut self, folder: &Path) {
        let files = [
            self.mesh.as_mut().map(|mesh| &mut mesh.file),
            self.hull.as_mut().and_then(|hull| hull.file.as_mut()),
            self.terrain.as_mut().and_then(|terrain| terrain.file.as_mut()),
        ];
        for file in files.into_iter().flatten().filter(|file| !file.is_empty()) {
            let path = folder.join(&*file);
            *file = std::path::absolute(&path).unwrap_or(path).to_string_lossy().into_owned();
        }
    }
}

/// What tells a file from the same one after it changed.
fn stamp(file: &str) -> String {
    std::fs::metadata(file)
        .map_or_else(|_| String::new(), |known| format!("{:?} {}", known.modified().ok(), known.len()))
}

fn quoted(file: &str) -> String {
    format!("\"{}\"", one_line(file, 200))
}

/// What a scene or a file says may have anything in it, and any length.
fn one_line(text: &str, most: usize) -> String {
    text.chars().take(most).map(|c| if c.is_control() { ' ' } else { c }).collect()
}

#[cfg(feature = "import")]
fn read(file: &str) -> Result<Mesh, String> {
    brooklet_shapes::import::mesh(Path::new(file)).map_err(|reason| one_line(&reason, 300))
}

#[cfg(feature = "import")]
fn image(file: &str) -> Result<(usize, usize, Vec<f64>), String> {
    let read = brooklet_shapes::import::bytes(Path::new(file)).and_then(|bytes| brooklet_shapes::import::image(&bytes));
    read.map(|image| (image.columns, image.rows, image.shares)).map_err(|reason| one_line(&reason, 300))
}

#[cfg(not(feature = "import"))]
fn read(_: &str) -> Result<Mesh, String> {
    Err("this program is built without what reads files of meshes (feature `import`)".to_owned())
}

#[cfg(not(feature = "import"))]
fn image(_: &str) -> Result<(usize, usize, Vec<f64>), String> {
    Err("this program is built without what reads pictures of heights (feature `import`)".to_owned())
}

fn mesh(shape: &MeshShape, is_sheet: bool) -> Result<Triangles, String> {
    let (mesh, repairs) =
        checked(read(&shape.file)?.scaled(shape.scale_m), is_sheet).map_err(|flaw| flaw.to_string())?;
    Ok(Triangles::new(mesh, None, repairs))
}

fn hull_of(shape: &HullShape) -> Result<Triangles, String> {
    let points_m = match &shape.file {
        Some(_) if !shape.points_m.is_empty() => return Err("not with points_m: give one of the two".to_owned()),
        Some(file) => {
            let mut points_m = read(file)?.scaled(shape.scale_m).positions_m;
            points_m.sort_by(|a, b| a.to_array().partial_cmp(&b.to_array()).unwrap_or(std::cmp::Ordering::Equal));
            points_m.dedup();
            points_m
        }
        None => shape.points_m.iter().copied().map(DVec3::from_array).collect(),
    };
    let (mesh, repairs) = checked(hull(&points_m)?, false).map_err(|flaw| flaw.to_string())?;
    Ok(Triangles::new(mesh, None, repairs))
}

fn wheel_of(wheel: &Wheel) -> Result<Triangles, String> {
    let (mesh, repairs) = checked(wheel.mesh()?, false).map_err(|flaw| flaw.to_string())?;
    Ok(Triangles::new(mesh, None, repairs))
}

/// All that ground's triangles depend on.
#[derive(Debug)]
struct Ground<'a> {
    shape: &'a TerrainShape,
    /// Heights along each side, at most: as fine as the field's cells.
    counts: [usize; 2],
    /// How far it goes on around its sides and below its lowest point: as far as a particle feels.
    beyond_m: f64,
}

impl<'a> Ground<'a> {
    fn of(shape: &'a TerrainShape, scene: &Scene, solid: &SolidSettings) -> Self {
        let cell_m = solid.field_options(scene).cell_m;
        let count = |side_m: f64| (side_m / cell_m).ceil().clamp(2.0, MOST_HEIGHTS as f64 - 1.0) as usize + 1;
        let [x_m, _, z_m] = shape.size_m;
        let beyond_m = if scene.solver.method.interacts() { scene.support_m() } else { scene.fitted_spacing_m() };
        Self { shape, counts: [count(x_m), count(z_m)], beyond_m }
    }

    fn triangles(&self) -> Result<Triangles, String> {
        let shape = self.shape;
        let [x_m, y_m, z_m] = shape.size_m;
        let mut heights = match &shape.file {
            Some(file) => {
                let (columns, rows, shares) = image(file)?;
                Heights { columns, rows, heights_m: shares.into_iter().map(|share| y_m * share).collect() }
                    .resampled(self.counts)
            }
            None => {
                let relief = Relief {
                    kind: shape.relief.into(),
                    seed: shape.seed,
                    feature_m: shape.feature_m.unwrap_or(0.5 * x_m),
                    channel_m: shape.channel_m.unwrap_or(z_m / 3.0),
                };
                relief.heights([x_m, z_m], y_m, self.counts)
            }
        };
        let last = (heights.columns - 1) as f64;
        for (index, height_m) in heights.heights_m.iter_mut().enumerate() {
            *height_m += shape.fall_m * (1.0 - (index % heights.columns) as f64 / last);
        }
        let bottom_m = -self.beyond_m.max(0.05 * x_m.max(z_m));
        let solid = terrain(&heights, [x_m, z_m], self.beyond_m, bottom_m);
        let drawn = terrain(&heights, [x_m, z_m], 0.0, bottom_m);
        let (solid, _) = checked(solid, false).map_err(|flaw| flaw.to_string())?;
        Ok(Triangles::new(solid, Some(drawn), Repairs::default()))
    }
}
