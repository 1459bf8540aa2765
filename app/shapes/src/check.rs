//! What a mesh must be to have an inside, and what is repaired of one that is not.

use std::collections::HashMap;

use glam::DVec3;
use thiserror::Error;

use crate::mesh::{MOST_SIZE_M, MOST_TRIANGLES, Mesh};

/// Corners nearer than this share of the mesh's size are one.
const WELD: f64 = 1.0e-6;

/// Why a mesh is no solid.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum Flaw {
    /// No triangles.
    #[error("has no triangles")]
    Empty,
    /// More than are read.
    #[error("has {0} triangles, and {MOST_TRIANGLES} fit")]
    TooMany(usize),
    /// A triangle of a corner that is not there.
    #[error("triangle {triangle} has corner {corner}, and there are {corners}")]
    NoCorner {
        /// Which triangle.
        triangle: usize,
        /// The number it asks for.
        corner: u32,
        /// How many there are.
        corners: usize,
    },
    /// A corner that is nowhere, or too far away.
    #[error("corner {corner} is at [{x}, {y}, {z}]: each must be from -1e6 to 1e6 m")]
    NoPlace {
        /// Which corner.
        corner: usize,
        /// Along x.
        x: f64,
        /// Along y.
        y: f64,
        /// Along z.
        z: f64,
    },
    /// Triangles without an area only.
    #[error("has {0} triangles, none of which has an area")]
    Flat(usize),
    /// Edges with one triangle.
    #[error(
        "is open: {edges} of its edges have one triangle, the first from [{a}] to [{b}]; close it, or give it a \
         thickness_m, and it is a sheet"
    )]
    Open {
        /// How many.
        edges: usize,
        /// The first's begin.
        a: String,
        /// The first's end.
        b: String,
    },
    /// No side of it is the outside.
    #[error("has no outside: its triangles meet at an edge from [{a}] to [{b}] so that no way to turn them fits")]
    OneSided {
        /// The edge's begin.
        a: String,
        /// The edge's end.
        b: String,
    },
    /// Closed, but nothing is in it.
    #[error("holds nothing: its triangles enclose {0:.1e} m3")]
    Hollow(f64),
}

/// What was repaired.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Repairs {
    /// Triangles without an area that were left out.
    pub degenerate: usize,
    /// Triangles that were turned over to face the way that their neighbours do.
    pub turned: usize,
    /// Whether the whole faced inward.
    pub inverted: bool,
}

impl Repairs {
    /// What was done, in words; none of a mesh that was in order.
    pub fn said(&self) -> Option<String> {
        let mut said = Vec::new();
        if self.degenerate > 0 {
            said.push(format!("{} triangles without an area left out", self.degenerate));
        }
        if self.turned > 0 {
            said.push(format!("{} triangles turned over to face as their neighbours do", self.turned));
        }
        if self.inverted {
            said.push("all of it faced inward, and was turned over".to_owned());
        }
        (!said.is_empty()).then(|| said.join("; "))
    }
}

/// The mesh with corners at one place made one, without triangles that have no area, facing outward. One that is to be a
/// sheet may be open, and face any way.
///
/// # Errors
/// Every [`Flaw`].
pub fn checked(mesh: Mesh, is_sheet: bool) -> Result<(Mesh, Repairs), Flaw> {
    let given = mesh.triangles.len();
    if given == 0 {
        return Err(Flaw::Empty);
    }
    if given > MOST_TRIANGLES {
        return Err(Flaw::TooMany(given));
    }
    let corners = mesh.positions_m.len();
    for (triangle, of) in mesh.triangles.iter().enumerate() {
        if let Some(&corner) = of.iter().find(|&&corner| corner as usize >= corners) {
            return Err(Flaw::NoCorner { triangle, corner, corners });
        }
    }
    let is_near = |at_m: &DVec3| at_m.is_finite() && at_m.abs().max_element() <= MOST_SIZE_M;
    if let Some((corner, &DVec3 { x, y, z })) = mesh.positions_m.iter().enumerate().find(|(_, at_m)| !is_near(at_m)) {
        return Err(Flaw::NoPlace { corner, x, y, z });
    }
    let mut repairs = Repairs::default();
    let mut mesh = welded(&mesh);
    mesh.triangles.retain(|[a, b, c]| a != b && b != c && c != a);
    repairs.degenerate = given - mesh.triangles.len();
    let [low_m, high_m] = mesh.bounds_m();
    let longest_m = (high_m - low_m).max_element();
    if mesh.triangles.is_empty() || mesh.area_m2() <= 1.0e-12 * longest_m * longest_m {
        return Err(Flaw::Flat(given));
    }
    if !is_sheet {
        repairs.turned = turn_alike(&mut mesh)?;
        let volume_m3 = mesh.volume_m3();
        if volume_m3.abs() <= 1.0e-9 * longest_m.powi(3) {
            return Err(Flaw::Hollow(volume_m3));
        }
        repairs.inverted = volume_m3 < 0.0;
        if repairs.inverted {
            mesh.flip();
        }
    }
    Ok((mesh, repairs))
}

fn welded(mesh: &Mesh) -> Mesh {
    let [low_m, high_m] = mesh.bounds_m();
    let unit_m = (WELD * (high_m - low_m).max_element()).max(f64::MIN_POSITIVE);
    let mut found = HashMap::new();
    let mut positions_m = Vec::new();
    let numbers: Vec<u32> = mesh
        .positions_m
        .iter()
        .map(|&at_m| {
            let key = ((at_m - low_m) / unit_m).round().to_array().map(|x| x as i64);
            *found.entry(key).or_insert_with(|| {
                positions_m.push(at_m);
                positions_m.len() as u32 - 1
            })
        })
        .collect();
    let triangles = mesh.triangles.iter().map(|triangle| triangle.map(|corner| numbers[corner as usize])).collect();
    Mesh { positions_m, triangles }
}

/// An edge's triangles, and whether each goes along it from its lower corner to its higher.
type Edges = HashMap<[u32; 2], Vec<(usize, bool)>>;

fn sides(triangle: [u32; 3]) -> [([u32; 2], bool); 3] {
    let [a, b, c] = triangle;
    [(a, b), (b, c), (c, a)].map(|(from, to)| ([from.min(to), from.max(to)], from < to))
}

fn edges(mesh: &Mesh) -> Edges {
    let mut edges = Edges::with_capacity(2 * mesh.triangles.len());
    for (triangle, &of) in mesh.triangles.iter().enumerate() {
        for (edge, forward) in sides(of) {
            edges.entry(edge).or_default().push((triangle, forward));
        }
    }
    edges
}

/// Turns triangles over until each edge is gone along as often one way as the other; how many were.
fn turn_alike(mesh: &mut Mesh) -> Result<usize, Flaw> {
    let edges = edges(mesh);
    let at = |corner: u32| {
        let DVec3 { x, y, z } = mesh.positions_m[corner as usize];
        format!("{x:.4}, {y:.4}, {z:.4}")
    };
    let odd = edges.iter().filter(|(_, of)| of.len() % 2 == 1).map(|(&edge, _)| edge);
    if let Some(&[a, b]) = odd.clone().min().as_ref() {
        return Err(Flaw::Open { edges: odd.count(), a: at(a), b: at(b) });
    }
    let is_balanced = |of: &[(usize, bool)]| 2 * of.iter().filter(|(_, forward)| *forward).count() == of.len();
    if edges.values().all(|of| is_balanced(of)) {
        return Ok(0);
    }
    // From the first triangle of each piece across edges with two of them.
    let mut turned: Vec<Option<bool>> = vec![None; mesh.triangles.len()];
    for first in 0..turned.len() {
        if turned[first].is_some() {
            continue;
        }
        turned[first] = Some(false);
        let (mut waiting, mut piece) = (vec![first], vec![first]);
        while let Some(triangle) = waiting.pop() {
            let is_turned = turned[triangle] == Some(true);
            for (edge, forward) in sides(mesh.triangles[triangle]) {
                let [(a, of_a), (b, of_b)] = edges[&edge][..] else { continue };
                let (other, other_forward) = if a == triangle { (b, of_b) } else { (a, of_a) };
                let wanted = (forward == other_forward) != is_turned;
                match turned[other] {
                    None => {
                        turned[other] = Some(wanted);
                        waiting.push(other);
                        piece.push(other);
                    }
                    Some(is) if is != wanted => return Err(Flaw::OneSided { a: at(edge[0]), b: at(edge[1]) }),
                    Some(_) => {}
                }
            }
        }
        // The way that most of it faced.
        if 2 * piece.iter().filter(|&&triangle| turned[triangle] == Some(true)).count() > piece.len() {
            piece.iter().for_each(|&triangle| turned[triangle] = turned[triangle].map(|is| !is));
        }
    }
    let mut count = 0;
    for (triangle, _) in turned.iter().enumerate().filter(|(_, is)| **is == Some(true)) {
        mesh.triangles[triangle].swap(1, 2);
        count += 1;
    }
    let after = self::edges(mesh);
    match after.iter().filter(|(_, of)| !is_balanced(of)).map(|(&edge, _)| edge).min() {
        None => Ok(count),
        Some([a, b]) => {
            let at = |corner: u32| {
                let DVec3 { x, y, z } = mesh.positions_m[corner as usize];
                format!("{x:.4}, {y:.4}, {z:.4}")
            };
            Err(Flaw::OneSided { a: at(a), b: at(b) })
        }
    }
}
