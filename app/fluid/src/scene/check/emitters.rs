//! What emitters and drains may be.

use glam::DVec3;

use super::{Checker, numbers, tidied};
use crate::scene::emitter_shapes::{MOST_DRAINS, MOST_EMITTERS, MOST_LAYERS};
use crate::scene::field::Short;
use crate::scene::solid_shapes::{Pose, StandingSolid};
use crate::scene::{DrainSettings, EmitterSettings, Scene, SceneError};

/// Places between two poses of a nozzle that are looked at.
const PARTS: u32 = 8;
/// Points that a nozzle's layer may have, and particles that fill at once.
const MOST_NOZZLE_POINTS: f64 = 65_536.0;
const MOST_FILLED: f64 = 16_777_216.0;

impl Scene {
    /// Each with one shape, inside the domain and no solid, and no faster than fluid may be.
    pub(super) fn check_emitters(&self, check: &Checker) -> Result<(), SceneError> {
        let count = self.emitters.len();
        check.require(
            count <= MOST_EMITTERS,
            "emitter",
            format_args!("{count} emitters"),
            format_args!("at most {MOST_EMITTERS}"),
        )?;
        let each = self.emitters.iter().enumerate();
        each.map(|(index, emitter)| (format!("emitter.{index}"), emitter)).try_for_each(|(field, emitter)| {
            self.check_nozzle(check, &field, emitter)?;
            self.check_flow(check, &field, emitter)?;
            match emitter.fills() {
                true => self.check_body(check, &field, emitter),
                false => {
                    self.check_emitter_motion(check, &field, emitter)?;
                    self.check_nozzle_places(check, &field, emitter)
                }
            }
        })
    }

    fn check_nozzle(&self, check: &Checker, field: &str, emitter: &EmitterSettings) -> Result<(), SceneError> {
        let is_flat = self.domain.is_flat();
        let given = [
            emitter.radius_m.is_some(),
            emitter.width_m.is_some() || emitter.height_m.is_some(),
            emitter.block.is_some(),
            emitter.sphere.is_some(),
        ];
        let shapes = given.into_iter().filter(|&given| given).count();
        check.require(
            shapes == 1,
            field,
            format_args!("{shapes} shapes"),
            "give it one of `radius_m`, `width_m` with `height_m`, `block` and `sphere`",
        )?;
        if let (Some(side_m), None) | (None, Some(side_m)) = (emitter.width_m, emitter.height_m) {
            let ok = is_flat && emitter.width_m.is_some();
            check.require(
                ok,
                field,
                format_args!("one side, {} m", Short(side_m)),
                "needs `width_m` and `height_m`",
            )?;
        }
        // Before any of its points are made.
        let spacing_m = self.fitted_spacing_m();
        let across = |side_m: Option<f64>| side_m.unwrap_or_default() / spacing_m;
        let (name, layer) = match (emitter.radius_m, is_flat) {
            (Some(_), true) => ("radius_m", 2.0 * across(emitter.radius_m)),
            (Some(_), false) => ("radius_m", std::f64::consts::PI * across(emitter.radius_m).powi(2)),
            (None, true) => ("width_m", across(emitter.width_m)),
            (None, false) => ("width_m", across(emitter.width_m) * across(emitter.height_m)),
        };
        check.require(
            layer <= MOST_NOZZLE_POINTS,
            &format!("{field}.{name}"),
            Short(emitter.radius_m.or(emitter.width_m).unwrap_or_default()),
            format_args!("a layer of {layer:.1e} particles: at most {MOST_NOZZLE_POINTS}"),
        )?;
        let direction = &format!("{field}.direction");
        check.require(
            DVec3::from_array(emitter.direction).try_normalize().is_some(),
            direction,
            numbers(emitter.direction),
            "must have a length",
        )?;
        check.require(
            !is_flat || emitter.direction[2] == 0.0,
            direction,
            numbers(emitter.direction),
            "must be 0 along z with domain.dimensions = 2",
        )
    }

    fn check_flow(&self, check: &Checker, field: &str, emitter: &EmitterSettings) -> Result<(), SceneError> {
        if let Some(end_s) = emitter.end_s {
            check.require(
                end_s > emitter.start_s,
                &format!("{field}.end_s"),
                Short(end_s),
                format_args!("must be after start_s = {}", Short(emitter.start_s)),
            )?;
        }
        let speed = &format!("{field}.speed_m_s");
        let value = Short(emitter.speed_m_s);
        check.require(emitter.fills() || emitter.speed_m_s > 0.0, speed, &value, "must be above 0: nothing flows")?;
        check.require(
            emitter.speed_m_s <= self.max_speed_m_s(),
            speed,
            &value,
            format_args!(
                "at most {}, the speed that particles may have: a higher solver.max_speed_m_s, a shorter solver.dt_s or \
                 more solver.substeps",
                Short(tidied(self.max_speed_m_s()))
            ),
        )?;
        let layers = emitter.speed_m_s * self.solver.dt_s / self.fitted_spacing_m();
        check.require(
            emitter.fills() || layers <= MOST_LAYERS * f64::from(self.solver.substeps),
            speed,
            &value,
            format_args!("flows {layers:.0} spacings a step; at most {MOST_LAYERS} a substep: more solver.substeps"),
        )
    }

    /// What fills at once: of the domain, with room, and without what only nozzles have.
    fn check_body(&self, check: &Checker, field: &str, emitter: &EmitterSettings) -> Result<(), SceneError> {
        let still = EmitterSettings {
            block: emitter.block.clone(),
            sphere: emitter.sphere.clone(),
            direction: emitter.direction,
            speed_m_s: emitter.speed_m_s,
            fluid: emitter.fluid,
            start_s: emitter.start_s,
            lifetime_s: emitter.lifetime_s,
            ..EmitterSettings::default()
        };
        check.require(
            *emitter == still,
            field,
            "a body that fills at once",
            "has no centre_m, end_s, turned_deg, velocity_m_s, spin_deg_s, keyframe or repeat: those are a nozzle's",
        )?;
        let (min_m, max_m) = match (&emitter.block, &emitter.sphere) {
            (Some(block), _) => {
                check.ordered(&format!("{field}.block"), block.min_m, block.max_m)?;
                (block.min_m, block.max_m)
            }
            (_, Some(ball)) => (ball.centre_m.map(|x| x - ball.radius_m), ball.centre_m.map(|x| x + ball.radius_m)),
            (None, None) => return Ok(()),
        };
        let slack_m = 1.0e-6 * self.spacing_m;
        let domain = &self.domain;
        let inside = (0..domain.dimensions as usize)
            .all(|axis| min_m[axis] >= domain.min_m[axis] - slack_m && max_m[axis] <= domain.max_m[axis] + slack_m);
        check.require(
            inside,
            field,
            format_args!("{} to {}", numbers(min_m), numbers(max_m)),
            format_args!("must lie inside the domain, {} to {}", numbers(domain.min_m), numbers(domain.max_m)),
        )?;
        let filled = (0..domain.dimensions as usize)
            .map(|axis| (max_m[axis] - min_m[axis]) / self.fitted_spacing_m())
            .product::<f64>();
        check.require(
            filled <= MOST_FILLED,
            field,
            format_args!("{} to {}", numbers(min_m), numbers(max_m)),
            format_args!("holds {filled:.1e} particles: at most {MOST_FILLED}, or a larger spacing_m"),
        )?;
        check.require(
            !emitter.points_m(self).is_empty(),
            field,
            format_args!("{} to {}", numbers(min_m), numbers(max_m)),
            format_args!(
                "has no room for a particle: larger than spacing_m = {}, and not inside a solid",
                Short(self.spacing_m)
            ),
        )
    }

    /// Keyframes in order, and one way to move.
    fn check_emitter_motion(&self, check: &Checker, field: &str, emitter: &EmitterSettings) -> Result<(), SceneError> {
        self.check_motion(check, field, &emitter.frame())?;
        let turns = emitter.keyframes.iter().map(|keyframe| keyframe.turned_deg);
        for turned_deg in turns.chain([emitter.turned_deg, emitter.spin_deg_s]) {
            check.require(
                !self.domain.is_flat() || turned_deg[..2] == [0.0; 2],
                field,
                format_args!("turned around {}", numbers(turned_deg)),
                "must be around z with domain.dimensions = 2",
            )?;
        }
        Ok(())
    }

    /// Every point of the nozzle inside the domain wherever it moves while the scene runs, and in no solid where both begin.
    fn check_nozzle_places(&self, check: &Checker, field: &str, emitter: &EmitterSettings) -> Result<(), SceneError> {
        let points_m = emitter.points_m(self);
        check.require(
            !points_m.is_empty(),
            field,
            "a nozzle",
            format_args!(
                "has no room for a particle: each side must be at least spacing_m = {}",
                Short(self.spacing_m)
            ),
        )?;
        let (poses, _) = emitter.motion(self);
        let slack_m = 1.0e-6 * self.spacing_m;
        let is_inside = |place_m: DVec3| {
            (0..self.domain.dimensions as usize).all(|axis| {
                (self.domain.min_m[axis] - slack_m..=self.domain.max_m[axis] + slack_m).contains(&place_m[axis])
            })
        };
        let last_s = emitter.end_s.unwrap_or(f64::INFINITY).min(self.outputs.seconds.max(emitter.start_s));
        let between = poses.windows(2).flat_map(|pair| {
            (0..=PARTS).map(|part| {
                // Of a motion without end what it does until then.
                let length_s = (last_s - pair[0].time_s).clamp(0.0, pair[1].time_s - pair[0].time_s);
                let share = f64::from(part) / f64::from(PARTS) * length_s / (pair[1].time_s - pair[0].time_s);
                let rotation = pair[0].rotation.slerp(pair[1].rotation, share);
                let time_s = pair[0].time_s + share * (pair[1].time_s - pair[0].time_s);
                Pose { time_s, centre_m: pair[0].centre_m.lerp(pair[1].centre_m, share), rotation }
            })
        });
        for pose in poses.first().copied().into_iter().chain(between) {
            for point_m in &points_m {
                let place_m = pose.centre_m + pose.rotation * *point_m;
                check.require(
                    is_inside(place_m),
                    field,
                    format_args!(
                        "a nozzle that is at {} at {} s",
                        numbers(place_m.to_array().map(tidied)),
                        Short(tidied(pose.time_s))
                    ),
                    format_args!(
                        "must lie inside the domain, {} to {}",
                        numbers(self.domain.min_m),
                        numbers(self.domain.max_m)
                    ),
                )?;
            }
        }
        let Some(first) = poses.first() else { return Ok(()) };
        for (index, solid) in self.solids.iter().enumerate() {
            let standing = StandingSolid::of(solid, self);
            for point_m in &points_m {
                let place_m = (first.centre_m + first.rotation * *point_m).to_array();
                check.require(
                    standing.distance_m(place_m) >= 0.0,
                    field,
                    format_args!("a nozzle at {}", numbers(place_m.map(tidied))),
                    format_args!("must not lie inside solid.{index}"),
                )?;
            }
        }
        Ok(())
    }

    /// Each with one region, which something may enter.
    pub(super) fn check_drains(&self, check: &Checker) -> Result<(), SceneError> {
        let count = self.drains.len();
        check.require(
            count <= MOST_DRAINS,
            "drain",
            format_args!("{count} drains"),
            format_args!("at most {MOST_DRAINS}"),
        )?;
        let each = self.drains.iter().enumerate();
        each.map(|(index, drain)| (format!("drain.{index}"), drain))
            .try_for_each(|(field, drain)| self.check_drain(check, &field, drain))
    }

    fn check_drain(&self, check: &Checker, field: &str, drain: &DrainSettings) -> Result<(), SceneError> {
        let given = [drain.block.is_some(), drain.sphere.is_some(), drain.domain_exit];
        let regions = given.into_iter().filter(|&given| given).count();
        check.require(
            regions == 1,
            field,
            format_args!("{regions} regions"),
            "give it one of `block`, `sphere` and `domain_exit`",
        )?;
        let domain = &self.domain;
        let is_open = |axis: usize| !domain.walls && !domain.periodic[axis];
        if drain.domain_exit {
            return check.require(
                (0..domain.dimensions as usize).any(is_open),
                &format!("{field}.domain_exit"),
                "true",
                "needs domain.walls = false and an axis that is not periodic: nothing leaves this domain",
            );
        }
        let (min_m, max_m) = match (&drain.block, &drain.sphere) {
            (Some(block), _) => {
                check.ordered(&format!("{field}.block"), block.min_m, block.max_m)?;
                (block.min_m, block.max_m)
            }
            (_, Some(ball)) => (ball.centre_m.map(|x| x - ball.radius_m), ball.centre_m.map(|x| x + ball.radius_m)),
            (None, None) => return Ok(()),
        };
        let reaches = (0..domain.dimensions as usize)
            .all(|axis| is_open(axis) || min_m[axis] < domain.max_m[axis] && max_m[axis] > domain.min_m[axis]);
        check.require(
            reaches,
            field,
            format_args!("{} to {}", numbers(min_m), numbers(max_m)),
            format_args!(
                "must reach into the domain, {} to {}: nothing would enter it",
                numbers(domain.min_m),
                numbers(domain.max_m)
            ),
        )
    }
}
