//! Whole pictures, held against stored ones: every pass of a frame, those that have no twin too.
//!
//! What is stored is the mean color of blocks of 16 x 15 pixels, as Mesa's CPU driver drew them. Devices may cover other pixels
//! along outlines and round each color another way; a light, a shadow or a surface that is missing is off by much more.

use brooklet_fluid::{Scene, Session};
use brooklet_kernels::CrossFadeParams;
use brooklet_render::ScenePlan;

use crate::device::Device;
use crate::wrong::{Found, OrRaise as _, Wrong, ensure, note};

/// Pixels of a picture, in blocks.
const BLOCK_PX: [usize; 2] = [16, 15];
const BLOCKS: [usize; 2] = [5, 3];
/// Of a block's mean, of 255.
const TOLERANCE: i32 = 5;

/// Red, green and blue of the blocks, rows from the top.
type Means = [u8; 45];

/// What is changed of the scene, and what is seen.
struct Picture {
    name: &'static str,
    has_solids: bool,
    settings: &'static [&'static str],
    means: Means,
}

const POINTS: Picture = Picture {
    name: "points",
    has_solids: false,
    settings: &["surface.method=points"],
    means: [
        165, 176, 184, 149, 163, 180, 161, 172, 183, 164, 175, 183, 163, 174, 182, 158, 164, 172, 24, 50, 107, 130,
        138, 154, 186, 186, 185, 174, 176, 177, 185, 182, 178, 109, 118, 133, 135, 148, 153, 190, 186, 181, 189, 185,
        179,
    ],
};

const DENSITIES: Picture = Picture {
    name: "points by density",
    has_solids: false,
    settings: &["surface.method=points", "surface.color_by=density"],
    means: [
        165, 176, 184, 168, 179, 188, 166, 176, 185, 164, 175, 183, 163, 174, 182, 177, 180, 181, 159, 169, 177, 166,
        171, 175, 186, 186, 185, 174, 176, 177, 188, 184, 179, 148, 155, 157, 138, 151, 156, 190, 186, 181, 189, 185,
        179,
    ],
};

const FLUIDS: Picture = Picture {
    name: "points by fluid",
    has_solids: false,
    settings: &["surface.method=points", "surface.color_by=fluid"],
    means: [
        165, 176, 184, 149, 170, 186, 161, 174, 185, 164, 175, 183, 163, 174, 182, 158, 169, 178, 25, 90, 156, 131,
        149, 170, 186, 186, 185, 174, 176, 177, 185, 183, 178, 109, 128, 149, 135, 148, 155, 190, 186, 181, 189, 185,
        179,
    ],
};

const NOTHING: Picture = Picture {
    name: "no fluid",
    has_solids: false,
    settings: &["surface.method=none"],
    means: [
        165, 176, 184, 163, 173, 182, 165, 176, 184, 164, 175, 183, 163, 174, 182, 177, 179, 179, 183, 183, 183, 187,
        187, 186, 186, 186, 185, 174, 176, 177, 189, 186, 180, 194, 190, 184, 196, 192, 185, 190, 186, 181, 189, 185,
        179,
    ],
};

const WATER: Picture = Picture {
    name: "water",
    has_solids: false,
    settings: &["surface.caustics=true", "surface.self_shadow=true"],
    means: [
        165, 176, 184, 160, 175, 184, 164, 175, 184, 164, 175, 183, 163, 174, 182, 172, 177, 179, 57, 130, 154, 164,
        177, 179, 186, 186, 185, 174, 176, 177, 189, 185, 180, 142, 171, 173, 164, 181, 180, 190, 186, 181, 189, 185,
        179,
    ],
};

const PLAIN: Picture = Picture {
    name: "water without light of its own",
    has_solids: false,
    settings: &["surface.anisotropic=false", "surface.caustics=false", "surface.self_shadow=false"],
    means: [
        165, 176, 184, 160, 175, 185, 164, 175, 184, 164, 175, 183, 163, 174, 182, 172, 177, 178, 56, 131, 155, 164,
        177, 180, 186, 186, 185, 174, 176, 177, 189, 185, 180, 134, 161, 165, 152, 169, 170, 190, 186, 181, 189, 185,
        179,
    ],
};

const SPHERES: Picture = Picture {
    name: "water of spheres",
    has_solids: false,
    settings: &["surface.anisotropic=false", "surface.caustics=true"],
    means: [
        165, 176, 184, 160, 175, 185, 164, 175, 184, 164, 175, 183, 163, 174, 182, 172, 177, 178, 55, 129, 153, 164,
        177, 179, 186, 186, 185, 174, 176, 177, 189, 185, 180, 142, 170, 173, 164, 181, 180, 190, 186, 181, 189, 185,
        179,
    ],
};

const MESHED: Picture = Picture {
    name: "meshed water",
    has_solids: false,
    settings: &["surface.method=marching-cubes", "surface.caustics=true", "surface.self_shadow=true"],
    means: [
        165, 176, 184, 164, 177, 186, 165, 176, 185, 164, 175, 183, 163, 174, 182, 172, 177, 179, 60, 130, 154, 166,
        177, 179, 186, 186, 185, 174, 176, 177, 189, 185, 180, 143, 171, 173, 164, 181, 180, 190, 186, 181, 189, 185,
        179,
    ],
};

const PLAIN_MESHED: Picture = Picture {
    name: "meshed water without light of its own",
    has_solids: false,
    settings: &["surface.method=marching-cubes", "surface.caustics=false", "surface.self_shadow=false"],
    means: [
        165, 176, 184, 164, 177, 186, 165, 176, 185, 164, 175, 183, 163, 174, 182, 172, 177, 179, 61, 132, 155, 166,
        178, 180, 186, 186, 185, 174, 176, 177, 189, 185, 180, 136, 162, 166, 153, 169, 170, 190, 186, 181, 189, 185,
        179,
    ],
};

const BOTH: Picture = Picture {
    name: "half meshed water over the other",
    has_solids: false,
    settings: &["surface.method=auto", "surface.caustics=false", "surface.self_shadow=false"],
    means: [
        165, 176, 184, 162, 176, 185, 164, 176, 184, 164, 175, 183, 163, 174, 182, 172, 177, 179, 59, 132, 155, 165,
        178, 180, 186, 186, 185, 174, 176, 177, 189, 185, 180, 135, 162, 166, 152, 169, 170, 190, 186, 181, 189, 185,
        179,
    ],
};

const METAL: Picture = Picture {
    name: "metal",
    has_solids: false,
    settings: &["surface.metal_reflectance=[0.9, 0.7, 0.5]"],
    means: [
        165, 176, 184, 171, 180, 187, 166, 176, 184, 164, 175, 183, 163, 174, 182, 178, 176, 173, 190, 173, 146, 186,
        180, 170, 186, 186, 185, 174, 176, 177, 188, 185, 179, 139, 137, 131, 117, 126, 134, 190, 186, 181, 189, 185,
        179,
    ],
};

const MESHED_METAL: Picture = Picture {
    name: "meshed metal",
    has_solids: false,
    settings: &["surface.method=marching-cubes", "surface.metal_reflectance=[0.9, 0.7, 0.5]"],
    means: [
        165, 176, 184, 172, 181, 188, 167, 177, 185, 164, 175, 183, 163, 174, 182, 178, 176, 171, 191, 170, 136, 186,
        180, 169, 186, 186, 185, 174, 176, 177, 189, 185, 179, 144, 142, 134, 117, 126, 133, 190, 186, 181, 189, 185,
        179,
    ],
};

/// Half of them under water, one of glass.
const SOLIDS: &str = "
spacing_m = 0.05
[domain]
min_m = [0, 0, 0]
max_m = [1.6, 0.8, 0.8]
[[fluid]]
block = { min_m = [0, 0, 0], max_m = [1.6, 0.25, 0.8] }
[[fluid]]
block = { min_m = [1.1, 0.45, 0.25], max_m = [1.4, 0.65, 0.55] }
[[solid]]
sphere = { radius_m = 0.2 }
centre_m = [0.35, 0.3, 0.45]
[[solid]]
cylinder = { radius_m = 0.1, length_m = 0.5 }
centre_m = [0.75, 0.5, 0.4]
turned_deg = [0, 0, 40]
[[solid]]
box = { size_m = [0.5, 0.4, 0.5] }
thickness_m = 0.05
open = \"y_max\"
centre_m = [1.25, 0.55, 0.4]
look = \"glass\"
[solver]
method = \"pbf\"
dt_s = 0.002
";

const POINTS_AND_SOLIDS: Picture = Picture {
    name: "points and solids",
    has_solids: true,
    settings: &["surface.method=points"],
    means: [
        164, 174, 182, 163, 172, 180, 163, 166, 155, 146, 160, 177, 162, 172, 181, 156, 162, 171, 117, 94, 104, 96,
        104, 119, 100, 118, 153, 157, 162, 170, 178, 176, 173, 127, 134, 147, 95, 108, 134, 66, 86, 125, 110, 126, 141,
    ],
};

const WATER_AND_SOLIDS: Picture = Picture {
    name: "water and solids",
    has_solids: true,
    settings: &["surface.caustics=true", "surface.self_shadow=true"],
    means: [
        164, 174, 182, 163, 172, 180, 163, 166, 155, 158, 174, 183, 162, 172, 181, 173, 178, 178, 136, 125, 117, 123,
        152, 147, 138, 173, 185, 166, 174, 177, 185, 183, 178, 155, 171, 171, 126, 158, 163, 92, 140, 153, 144, 166,
        168,
    ],
};

const PLAIN_AND_SOLIDS: Picture = Picture {
    name: "water without light of its own and solids",
    has_solids: true,
    settings: &["surface.caustics=false", "surface.self_shadow=false"],
    means: [
        164, 174, 182, 163, 172, 180, 163, 166, 155, 158, 174, 183, 162, 172, 181, 173, 178, 178, 134, 121, 114, 122,
        146, 143, 137, 170, 183, 166, 174, 176, 185, 184, 178, 148, 163, 165, 118, 148, 156, 87, 135, 149, 133, 157,
        160,
    ],
};

const MESHED_AND_SOLIDS: Picture = Picture {
    name: "meshed water and solids",
    has_solids: true,
    settings: &["surface.method=marching-cubes", "surface.caustics=false", "surface.self_shadow=true"],
    means: [
        164, 174, 182, 163, 172, 180, 163, 166, 155, 161, 176, 184, 162, 172, 181, 172, 178, 178, 137, 122, 114, 129,
        150, 146, 140, 171, 184, 166, 174, 177, 185, 184, 178, 148, 164, 165, 118, 148, 156, 91, 137, 150, 134, 157,
        160,
    ],
};

const METAL_AND_SOLIDS: Picture = Picture {
    name: "metal and solids",
    has_solids: true,
    settings: &["surface.metal_reflectance=[0.9, 0.7, 0.5]"],
    means: [
        164, 174, 182, 163, 172, 180, 163, 166, 155, 164, 173, 180, 162, 172, 181, 181, 180, 177, 184, 146, 126, 192,
        184, 165, 200, 196, 190, 177, 178, 178, 183, 179, 172, 157, 153, 144, 150, 145, 135, 134, 132, 124, 113, 121,
        127,
    ],
};

const MESHED_METAL_AND_SOLIDS: Picture = Picture {
    name: "meshed metal and solids",
    has_solids: true,
    settings: &["surface.method=marching-cubes", "surface.metal_reflectance=[0.9, 0.7, 0.5]"],
    means: [
        164, 174, 182, 163, 172, 180, 163, 166, 155, 170, 178, 183, 162, 172, 181, 181, 179, 175, 188, 147, 121, 198,
        189, 167, 204, 199, 191, 179, 180, 180, 185, 180, 173, 162, 157, 147, 160, 151, 134, 157, 147, 129, 122, 127,
        129,
    ],
};

/// The mean colors of a picture's blocks after two steps.
fn drawn(device: &Device, has_solids: bool, settings: &[&str]) -> Means {
    let [width, height] = [0, 1].map(|axis| BLOCK_PX[axis] * BLOCKS[axis]);
    let sizes = [format!("outputs.width_px={width}"), format!("outputs.height_px={height}")];
    let fixed = ["spacing_m=0.05", "outputs.images=1", "solver.deterministic=true"].map(String::from);
    let settings: Vec<String> = settings.iter().map(|s| (*s).to_owned()).chain(fixed).chain(sizes).collect();
    let scene = match has_solids {
        true => Scene::from_toml(SOLIDS, "solids", &settings),
        false => Scene::load("dam-break", &settings),
    };
    let scene = scene.or_raise();
    let mut planned = ScenePlan::new(&scene, device.gpu().tier()).or_raise();
    let mut passes = planned.passes.take().or_raise();
    planned.session.plan = device.plan(planned.session.plan);
    let count = planned.session.slot_count();
    let mut session = Session::start(device.gpu(), planned.session).or_raise();
    for _ in 0..2 {
        session.step().or_raise();
    }
    let draw = match &passes.auto {
        // Half of each method's picture.
        Some(auto) => {
            session
                .engine_mut()
                .write(&auto.cross_fade, &[CrossFadeParams { opacity: 0.5, ..CrossFadeParams::default() }]);
            auto.both.id()
        }
        None => passes.next(session.engine_mut(), count, false),
    };
    session.engine_mut().run(&[draw], &[]).or_raise();
    let rgba = session.engine_mut().read_texture(&passes.color).or_raise();
    ensure!(rgba.len() == 4 * width * height, "{} bytes of a picture", rgba.len());
    std::array::from_fn(|number| {
        let (block, channel) = (number / 3, number % 3);
        let [left, top] = [block % BLOCKS[0] * BLOCK_PX[0], block / BLOCKS[0] * BLOCK_PX[1]];
        let rows = (top..top + BLOCK_PX[1]).flat_map(|y| (left..left + BLOCK_PX[0]).map(move |x| (y * width + x) * 4));
        let sum: u32 = rows.map(|at| u32::from(rgba[at + channel])).sum();
        (sum / (BLOCK_PX[0] * BLOCK_PX[1]) as u32) as u8
    })
}

/// How far two pictures are apart at most.
///
/// # Errors
/// Names the block that is furthest off, if it is by more than the tolerance.
fn compare(got: &Means, expected: &Means) -> Result<i32, Wrong> {
    let off = |(a, b): (&[u8], &[u8])| {
        a.iter().zip(b).map(|(a, b)| (i32::from(*a) - i32::from(*b)).abs()).max().unwrap_or_default()
    };
    let apart: Vec<i32> = got.chunks(3).zip(expected.chunks(3)).map(off).collect();
    let (block, &worst) = apart.iter().enumerate().max_by_key(|(_, off)| **off).or_raise();
    if worst <= TOLERANCE {
        return Ok(worst);
    }
    Err(Found {
        element: Some(block),
        got: format!("{:?}", &got[3 * block..3 * block + 3]),
        expected: format!("{:?}", &expected[3 * block..3 * block + 3]),
        difference: Some([f64::from(worst), f64::from(TOLERANCE)]),
        note: "mean color of a block".into(),
        beyond: Some([apart.iter().filter(|off| **off > TOLERANCE).count(), apart.len()]),
        ..Found::default()
    }
    .into())
}

fn is_as_stored(device: &Device, picture: &Picture) {
    let got = drawn(device, picture.has_solids, picture.settings);
    let worst = compare(&got, &picture.means).map_err(|wrong| wrong.named(picture.name)).or_raise();
    device.compared("draw", BLOCKS[0] * BLOCKS[1], [f64::from(worst), f64::from(TOLERANCE)]);
    note!(device, "picture of {}: within {worst} of 255, tolerance {TOLERANCE}", picture.name);
    // Particles are not water, nor is anything else particles.
    let other = if picture.name == POINTS.name { WATER } else { POINTS };
    ensure!(compare(&got, &other.means).is_err(), "{} is taken for {}", other.name, picture.name);
}

pub(crate) fn points_are_as_stored(device: &Device) {
    is_as_stored(device, &POINTS);
}

pub(crate) fn points_by_density_are_as_stored(device: &Device) {
    is_as_stored(device, &DENSITIES);
}

pub(crate) fn points_by_fluid_are_as_stored(device: &Device) {
    is_as_stored(device, &FLUIDS);
}

pub(crate) fn no_fluid_is_as_stored(device: &Device) {
    is_as_stored(device, &NOTHING);
}

pub(crate) fn water_is_as_stored(device: &Device) {
    is_as_stored(device, &WATER);
}

pub(crate) fn water_without_light_of_its_own_is_as_stored(device: &Device) {
    is_as_stored(device, &PLAIN);
}

pub(crate) fn water_of_spheres_is_as_stored(device: &Device) {
    is_as_stored(device, &SPHERES);
}

pub(crate) fn meshed_water_is_as_stored(device: &Device) {
    is_as_stored(device, &MESHED);
}

pub(crate) fn meshed_water_without_light_of_its_own_is_as_stored(device: &Device) {
    is_as_stored(device, &PLAIN_MESHED);
}

pub(crate) fn a_cross_fade_is_as_stored(device: &Device) {
    is_as_stored(device, &BOTH);
}

pub(crate) fn points_and_solids_are_as_stored(device: &Device) {
    is_as_stored(device, &POINTS_AND_SOLIDS);
}

pub(crate) fn water_and_solids_are_as_stored(device: &Device) {
    is_as_stored(device, &WATER_AND_SOLIDS);
}

pub(crate) fn water_without_light_of_its_own_and_solids_are_as_stored(device: &Device) {
    is_as_stored(device, &PLAIN_AND_SOLIDS);
}

pub(crate) fn meshed_water_and_solids_are_as_stored(device: &Device) {
    is_as_stored(device, &MESHED_AND_SOLIDS);
}

pub(crate) fn metal_is_as_stored(device: &Device) {
    is_as_stored(device, &METAL);
}

pub(crate) fn meshed_metal_is_as_stored(device: &Device) {
    is_as_stored(device, &MESHED_METAL);
}

pub(crate) fn metal_and_solids_are_as_stored(device: &Device) {
    is_as_stored(device, &METAL_AND_SOLIDS);
}

pub(crate) fn meshed_metal_and_solids_are_as_stored(device: &Device) {
    is_as_stored(device, &MESHED_METAL_AND_SOLIDS);
}
