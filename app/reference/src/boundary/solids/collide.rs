//! The way of a particle among solids. (Shaders: `boundary/solids/collide.hlsli` and the kernels that include it.)

use super::motion::Pose;
use super::shapes::Solid;
use glam::DVec3;

const STEPS: u32 = 64;
const LEAST_STEP: f64 = 0.25;
const TOUCHING: f64 = 0.02;
const UNTOUCHED: f64 = 1e-3;
const ROUNDS: u32 = 3;
const JAMMED: f64 = 0.5;

/// The end of a path in a solid's frame: as far as a particle that stays `stop_m` away gets, sliding along what it touches.
pub fn traced_path(solid: &Solid, start_m: DVec3, end_m: DVec3, stop_m: f64) -> DVec3 {
    let (mut place_m, mut rest_m) = (start_m, end_m - start_m);
    for step in 0..=STEPS {
        let (distance_m, out) = solid.surface(place_m);
        let gap_m = distance_m - stop_m;
        place_m -= out * gap_m.min(0.0);
        if gap_m <= TOUCHING * stop_m {
            rest_m -= out * rest_m.dot(out).min(0.0);
        }
        let length_m = rest_m.length();
        if gap_m >= solid.steepness() * length_m {
            return place_m + rest_m;
        }
        if step == STEPS || length_m <= UNTOUCHED * stop_m && gap_m >= -UNTOUCHED * stop_m {
            break;
        }
        let share = ((gap_m / solid.steepness()).max(LEAST_STEP * stop_m) / length_m.max(1e-30)).min(1.0);
        place_m += rest_m * share;
        rest_m -= rest_m * share;
    }
    place_m
}

/// The same, with friction and restitution.
pub fn contact_path(solid: &Solid, start_m: DVec3, end_m: DVec3, stop_m: f64) -> DVec3 {
    let stopped_m = traced_path(solid, start_m, end_m, stop_m);
    let pushed_m = stopped_m - end_m;
    let push_m = pushed_m.length();
    if push_m <= UNTOUCHED * stop_m || solid.friction + solid.restitution == 0.0 {
        return stopped_m;
    }
    let normal = pushed_m / push_m;
    let slid_m = (stopped_m - start_m).reject_from_normalized(normal);
    let held = (solid.friction * push_m / slid_m.length().max(1e-30)).min(1.0);
    traced_path(solid, stopped_m, stopped_m - held * slid_m + solid.restitution * pushed_m, stop_m)
}

/// A solid, where it was at the path's begin, and where it is at its end.
pub type Moving = (Solid, Pose, Pose);

/// The end of a path among solids, which walls then confine by `confined`.
pub fn path_among_solids(
    start_m: DVec3,
    end_m: DVec3,
    solids: &[Moving],
    stop_m: f64,
    confined: impl Fn(DVec3) -> DVec3,
) -> DVec3 {
    let mut now_m = end_m;
    for round in 0..ROUNDS {
        let mut furthest_m: f64 = 0.0;
        for (solid, before, after) in solids {
            let [from_m, to_m] = [before.in_frame(start_m), after.in_frame(now_m)];
            let pushed_m = contact_path(solid, from_m, to_m, stop_m) - to_m;
            if pushed_m.length() > UNTOUCHED * stop_m {
                now_m += after.rotation * pushed_m;
            }
            furthest_m = furthest_m.max(pushed_m.length());
        }
        // Without a solid near walls have nothing to add.
        if !solids.is_empty() {
            now_m = confined(now_m);
        }
        if furthest_m <= TOUCHING * stop_m {
            return now_m;
        }
        if round + 1 == ROUNDS && furthest_m > JAMMED * stop_m {
            return start_m;
        }
    }
    now_m
}
