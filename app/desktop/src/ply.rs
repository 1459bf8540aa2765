//! Particles as binary little-endian PLY: x y z, vx vy vz, id, fluid.

use std::path::Path;

use brooklet_fluid::particles::{fluid_of, id_of, is_simulated};
use brooklet_kernels::{Position, Velocity};
use serde::Serialize;

use crate::{failure::Failure, out_dir};

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
struct Vertex {
    x: f32,
    y: f32,
    z: f32,
    vx: f32,
    vy: f32,
    vz: f32,
    id: u32,
    fluid: u8,
}

#[derive(Serialize)]
struct Cloud {
    vertex: Vec<Vertex>,
}

/// Writes the particles in order of their ids, in the scene's coordinates; `origin_m` is the
/// corner of the domain that the GPU's positions are relative to. Quarantined particles, whose
/// position is no number, are left out.
pub fn write(path: &Path, positions: &[Position], velocities: &[Velocity], origin_m: [f64; 3]) -> Result<(), Failure> {
    let bytes = serde_ply::to_bytes(
        &cloud(positions, velocities, origin_m),
        serde_ply::SerializeOptions::binary_le().with_comments(vec!["metres, metres per second; y is up".into()]),
    )
    .map_err(|error| Failure::stopped(format_args!("{}: {error}", path.display())))?;
    out_dir::write_file(path, &bytes)
}

fn cloud(positions: &[Position], velocities: &[Velocity], origin_m: [f64; 3]) -> Cloud {
    let mut vertex: Vec<Vertex> = positions
        .iter()
        .zip(velocities)
        .filter(|(position, _)| is_simulated(position.tag))
        .map(|(position, velocity)| {
            let at = |axis: usize| (origin_m[axis] + f64::from(position.position_m[axis])) as f32;
            let [vx, vy, vz] = velocity.velocity_m_s;
            Vertex {
                x: at(0),
                y: at(1),
                z: at(2),
                vx,
                vy,
                vz,
                id: id_of(position.tag),
                fluid: fluid_of(position.tag) as u8,
            }
        })
        .collect();
    vertex.sort_unstable_by_key(|vertex| vertex.id);
    Cloud { vertex }
}

#[cfg(test)]
mod tests {
    use super::*;
    use brooklet_kernels::QUARANTINED;

    fn particle(x: f32, tag: u32) -> (Position, Velocity) {
        let position = Position { position_m: [x, 2.0, 3.0], tag };
        let velocity = Velocity { velocity_m_s: [-x, 0.5, 0.25], ..Default::default() };
        (position, velocity)
    }

    /// The file by the format's description: a text header, then the rows without padding.
    #[test]
    fn the_bytes_are_those_of_the_format() {
        let (positions, velocities): (Vec<_>, Vec<_>) =
            [particle(7.0, 5 | 2 << 24), particle(f32::NAN, 4 | QUARANTINED), particle(9.0, 3)].into_iter().unzip();
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("p.ply");
        write(&path, &positions, &velocities, [10.0, 20.0, 30.0]).unwrap();
        let bytes = std::fs::read(&path).unwrap();
        let marker = b"end_header\n";
        let end = bytes.windows(marker.len()).position(|window| window == marker).expect("a header") + marker.len();
        let header = std::str::from_utf8(&bytes[..end]).unwrap();
        assert!(header.starts_with("ply\nformat binary_little_endian 1.0\n"), "{header}");
        let body: Vec<&str> =
            header.lines().filter(|line| line.starts_with("element") || line.starts_with("property")).collect();
        assert_eq!(
            body.join("\n").replace("float32", "float").replace("uint32", "uint").replace("uint8", "uchar"),
            "element vertex 2\nproperty float x\nproperty float y\nproperty float z\n\
             property float vx\nproperty float vy\nproperty float vz\nproperty uint id\n\
             property uchar fluid"
        );
        let rows = &bytes[end..];
        assert_eq!(rows.len(), 2 * 29, "7 words and a byte a row");
        let float = |at: usize| f32::from_le_bytes(rows[at..at + 4].try_into().unwrap());
        let whole = |at: usize| u32::from_le_bytes(rows[at..at + 4].try_into().unwrap());
        assert_eq!([0, 4, 8, 12, 16, 20].map(float), [19.0, 22.0, 33.0, -9.0, 0.5, 0.25]);
        assert_eq!((whole(24), rows[28]), (3, 0));
        assert_eq!((float(29), whole(29 + 24), rows[29 + 28]), (17.0, 5, 2));
    }
}
