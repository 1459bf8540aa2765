//! The triangles of solids, made or read once, and their distance fields, made once for each spacing.

use std::fmt::{Debug, Formatter};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

use brooklet_shapes::{Field, FieldOptions, MassProperties, Mesh, Repairs};
use glam::DVec3;

use super::{Scene, SolidSettings};

/// Forms that are kept for the next scene that asks for the same: a slider that moves makes a scene at each stop.
const MOST_KEPT: usize = 4;
/// Fields that a form keeps.
const MOST_FIELDS: usize = 2;
/// Points that a body touches others with: no nearer to each other than this share of its longest side, and at most so many.
const POINTS_APART: f64 = 0.1;
const MOST_POINTS: usize = 96;

/// The triangles of a solid.
pub struct Triangles {
    /// What it is, closed but for a sheet.
    pub solid: Mesh,
    /// What is drawn of it, where that is not all.
    pub drawn: Option<Mesh>,
    /// What was repaired.
    pub repairs: Repairs,
    fields: Mutex<Vec<(FieldOptions, Arc<Field>)>>,
    mass: OnceLock<MassProperties>,
    points_m: OnceLock<Vec<DVec3>>,
}

impl Triangles {
    pub(super) fn new(solid: Mesh, drawn: Option<Mesh>, repairs: Repairs) -> Self {
        let (mass, points_m) = (OnceLock::new(), OnceLock::new());
        Self { solid, drawn, repairs, fields: Mutex::default(), mass, points_m }
    }

    pub(super) fn field(&self, options: &FieldOptions) -> Arc<Field> {
        let mut fields = unpoisoned(&self.fields);
        if let Some((_, field)) = fields.iter().find(|(own, _)| own == options) {
            return Arc::clone(field);
        }
        let field = Arc::new(Field::new(&self.solid, options));
        if fields.len() == MOST_FIELDS {
            fields.remove(0);
        }
        fields.push((*options, Arc::clone(&field)));
        field
    }

    /// Of a body of it.
    pub(super) fn mass_properties(&self) -> MassProperties {
        *self.mass.get_or_init(|| self.solid.mass_properties())
    }

    /// What a body of it touches others with, m.
    pub(super) fn points_m(&self) -> &[DVec3] {
        self.points_m.get_or_init(|| {
            let [low_m, high_m] = self.solid.bounds_m();
            self.solid.spread_points_m(POINTS_APART * (high_m - low_m).max_element(), MOST_POINTS)
        })
    }

    /// Half the sides of the box around its origin that holds it.
    pub(super) fn extent_m(&self, thickness_m: f64) -> DVec3 {
        let [low_m, high_m] = self.solid.bounds_m();
        low_m.abs().max(high_m.abs()) + 0.5 * thickness_m
    }
}

/// The triangles of a solid, if it has any: what its settings say, so that two scenes differ by those alone.
#[derive(Clone, Default)]
pub struct Form(Option<Arc<Triangles>>);

impl Form {
    /// What the settings that `key` tells apart make, or what they made before.
    pub(super) fn of(key: String, make: impl FnOnce() -> Result<Triangles, String>) -> Result<Self, String> {
        static KEPT: Mutex<Vec<(String, Arc<Triangles>)>> = Mutex::new(Vec::new());
        if let Some((_, triangles)) = unpoisoned(&KEPT).iter().find(|(kept, _)| *kept == key) {
            return Ok(Self(Some(Arc::clone(triangles))));
        }
        let triangles = Arc::new(make()?);
        let mut kept = unpoisoned(&KEPT);
        if kept.len() == MOST_KEPT {
            kept.remove(0);
        }
        kept.push((key, Arc::clone(&triangles)));
        Ok(Self(Some(triangles)))
    }
}

fn unpoisoned<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl PartialEq for Form {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Debug for Form {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        f.write_str(if self.0.is_some() { "triangles" } else { "none" })
    }
}

impl SolidSettings {
    /// Its triangles: none of a plain shape, or of a scene that was made by hand and not checked.
    pub fn triangles(&self) -> Option<&Triangles> {
        self.form.0.as_deref()
    }

    /// How its field is made in a scene.
    pub(super) fn field_options(&self, scene: &Scene) -> FieldOptions {
        let given = [
            self.mesh.as_ref().and_then(|mesh| mesh.cell_m),
            self.hull.as_ref().and_then(|hull| hull.cell_m),
            self.wheel.and_then(|wheel| wheel.cell_m),
            self.terrain.as_ref().and_then(|terrain| terrain.cell_m),
        ];
        // Ground is smooth, and thick.
        let spacings = if self.terrain.is_some() { 1.0 } else { 0.5 };
        FieldOptions {
            cell_m: given.into_iter().flatten().next().unwrap_or(spacings * scene.fitted_spacing_m()),
            support_m: scene.solver.method.interacts().then(|| scene.support_m()),
            sheet_m: self.mesh.as_ref().and(self.thickness_m),
        }
    }

    /// Its distance field in a scene; none of a plain shape.
    pub(super) fn field(&self, scene: &Scene) -> Option<Arc<Field>> {
        self.triangles().map(|triangles| triangles.field(&self.field_options(scene)))
    }
}

/// The fields of a scene's solids, those alike once: each with the number of its first node.
pub(super) fn fields(scene: &Scene) -> Vec<(Arc<Field>, u32)> {
    let mut all: Vec<(Arc<Field>, u32)> = Vec::new();
    for field in scene.solids.iter().filter_map(|solid| solid.field(scene)) {
        if !all.iter().any(|(other, _)| Arc::ptr_eq(other, &field)) {
            let first = all.last().map_or(0, |(last, first)| first + last.distances_m.len() as u32);
            all.push((field, first));
        }
    }
    all
}

/// The nodes of all fields of a scene, as the shaders have them: a distance, m, and a plane's, in supports. One node, which
/// nobody asks, of a scene without.
pub fn field_nodes(scene: &Scene) -> Vec<[f32; 2]> {
    let mut nodes = Vec::new();
    for (field, _) in fields(scene) {
        nodes.extend(field.distances_m.iter().zip(field.planes()).map(|(away_m, plane)| [*away_m, *plane]));
    }
    if nodes.is_empty() {
        nodes.push([0.0; 2]);
    }
    nodes
}
