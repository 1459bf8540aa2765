//! Whole pictures, held against stored ones: every pass of a frame, those that have no twin too.
//!
//! What is stored is the mean color of blocks of 16 x 15 pixels, as Mesa's CPU driver drew them. Devices may cover other pixels
//! along outlines and round each color another way; a light, a shadow or a surface that is missing is off by much more.

use brooklet_fluid::{Scene, Session};
use brooklet_gpu::Tier;
use brooklet_render::ScenePlan;

use crate::device::Device;
use crate::wrong::{Found, OrRaise as _, Wrong, ensure, note};

/// Pixels of a picture, in blocks.
const BLOCK_PX: [usize; 2] = [16, 15];
const BLOCKS: [usize; 2] = [5, 3];
/// Of a block's mean, of 255.
const TOLERANCE: i32 = 5;

type Means = [[u8; 3]; 15];

/// What is changed of the scene, and what is seen.
struct Picture {
    name: &'static str,
    settings: &'static [&'static str],
    means: Means,
    /// What is otherwise on tiers that draw no caustics.
    without_caustics: &'static [(usize, [u8; 3])],
}

const PICTURES: &[Picture] = &[
    Picture {
        name: "points",
        settings: &["surface.method=points"],
        means: [
            [165, 176, 184],
            [149, 163, 180],
            [161, 172, 183],
            [164, 175, 183],
            [163, 174, 182],
            [158, 164, 172],
            [24, 50, 107],
            [130, 138, 154],
            [186, 186, 185],
            [174, 176, 177],
            [185, 182, 178],
            [109, 118, 133],
            [135, 148, 153],
            [190, 186, 181],
            [189, 185, 179],
        ],
        without_caustics: &[],
    },
    Picture {
        name: "water",
        settings: &[],
        means: [
            [165, 176, 184],
            [160, 175, 184],
            [164, 175, 184],
            [164, 175, 183],
            [163, 174, 182],
            [173, 178, 179],
            [64, 134, 156],
            [166, 178, 180],
            [186, 186, 185],
            [174, 176, 177],
            [189, 185, 180],
            [146, 173, 174],
            [164, 182, 180],
            [190, 186, 181],
            [189, 185, 179],
        ],
        without_caustics: &[(11, [138, 163, 166]), (12, [152, 169, 170])],
    },
    Picture {
        name: "water without light of its own",
        settings: &["surface.anisotropic=false", "surface.caustics=false", "surface.self_shadow=false"],
        means: [
            [165, 176, 184],
            [160, 175, 185],
            [164, 175, 184],
            [164, 175, 183],
            [163, 174, 182],
            [173, 177, 179],
            [62, 135, 157],
            [166, 178, 180],
            [186, 186, 185],
            [174, 176, 177],
            [189, 185, 180],
            [138, 163, 166],
            [152, 169, 170],
            [190, 186, 181],
            [189, 185, 179],
        ],
        without_caustics: &[],
    },
    Picture {
        name: "meshed water",
        settings: &["surface.method=marching-cubes"],
        means: [
            [165, 176, 184],
            [164, 177, 186],
            [165, 176, 185],
            [164, 175, 183],
            [163, 174, 182],
            [173, 178, 179],
            [67, 135, 156],
            [167, 178, 180],
            [186, 186, 185],
            [174, 176, 177],
            [189, 185, 180],
            [146, 173, 174],
            [165, 182, 180],
            [190, 186, 181],
            [189, 185, 179],
        ],
        without_caustics: &[(11, [139, 164, 167]), (12, [153, 170, 170])],
    },
];

/// The mean colors of a picture's blocks, from the top, after two steps.
fn drawn(device: &Device, settings: &[&str]) -> Means {
    let [width, height] = [0, 1].map(|axis| BLOCK_PX[axis] * BLOCKS[axis]);
    let sizes = [format!("outputs.width_px={width}"), format!("outputs.height_px={height}")];
    let fixed = ["spacing_m=0.05", "outputs.images=1", "solver.deterministic=true"].map(String::from);
    let settings: Vec<String> = settings.iter().map(|s| (*s).to_owned()).chain(fixed).chain(sizes).collect();
    let scene = Scene::load("dam-break", &settings).or_raise();
    let mut planned = ScenePlan::new(&scene, device.gpu().tier()).or_raise();
    let mut passes = planned.passes.take().or_raise();
    planned.session.plan = device.plan(planned.session.plan);
    let count = planned.session.slot_count();
    let mut session = Session::start(device.gpu(), planned.session).or_raise();
    for _ in 0..2 {
        session.step().or_raise();
    }
    let draw = passes.next(session.engine_mut(), count, false);
    session.engine_mut().run(&[draw], &[]).or_raise();
    let rgba = session.engine_mut().read_texture(&passes.color).or_raise();
    ensure!(rgba.len() == 4 * width * height, "{} bytes of a picture", rgba.len());
    std::array::from_fn(|block| {
        let [left, top] = [block % BLOCKS[0] * BLOCK_PX[0], block / BLOCKS[0] * BLOCK_PX[1]];
        std::array::from_fn(|channel| {
            let rows =
                (top..top + BLOCK_PX[1]).flat_map(|y| (left..left + BLOCK_PX[0]).map(move |x| (y * width + x) * 4));
            let sum: u32 = rows.map(|at| u32::from(rgba[at + channel])).sum();
            (sum / (BLOCK_PX[0] * BLOCK_PX[1]) as u32) as u8
        })
    })
}

/// How far two pictures are apart at most.
///
/// # Errors
/// Names the block that is furthest off, if it is by more than the tolerance.
fn compare(got: &Means, expected: &Means) -> Result<i32, Wrong> {
    let off = |(a, b): (&[u8; 3], &[u8; 3])| {
        a.iter().zip(b).map(|(a, b)| (i32::from(*a) - i32::from(*b)).abs()).max().unwrap_or_default()
    };
    let apart: Vec<i32> = got.iter().zip(expected).map(off).collect();
    let (block, &worst) = apart.iter().enumerate().max_by_key(|(_, off)| **off).or_raise();
    if worst <= TOLERANCE {
        return Ok(worst);
    }
    Err(Found {
        element: Some(block),
        got: format!("{:?}", got[block]),
        expected: format!("{:?}", expected[block]),
        difference: Some([f64::from(worst), f64::from(TOLERANCE)]),
        note: "mean color of a block".into(),
        beyond: Some([apart.iter().filter(|off| **off > TOLERANCE).count(), apart.len()]),
        ..Found::default()
    }
    .into())
}

pub(crate) fn pictures_are_those_stored(device: &Device) {
    for picture in PICTURES {
        let mut expected = picture.means;
        if device.gpu().tier() != Tier::Desktop {
            picture.without_caustics.iter().for_each(|(block, mean)| expected[*block] = *mean);
        }
        let got = drawn(device, picture.settings);
        let worst = compare(&got, &expected).map_err(|wrong| wrong.named(picture.name)).or_raise();
        device.compared("draw", expected.len(), [f64::from(worst), f64::from(TOLERANCE)]);
        note!(device, "picture {}: within {worst} of 255, tolerance {TOLERANCE}", picture.name);
        // Particles are not water, nor water particles.
        let other = if picture.name == PICTURES[0].name { &PICTURES[1] } else { &PICTURES[0] };
        ensure!(compare(&got, &other.means).is_err(), "{} is taken for {}", other.name, picture.name);
    }
}
