//! Particles in a nozzle and before it keep to its flow. (Shader: `emitters/guide_particles.compute`.)

use glam::DVec3;

use super::open_emitters::Flow;

/// The space in which a nozzle's flow leads; in its frame.
#[derive(Clone, Copy, Debug)]
pub struct Channel {
    /// Where it flows to, of length 1.
    pub direction: DVec3,
    /// How fast, m/s.
    pub speed_m_s: f64,
    /// From behind the nozzle to before it, along the direction, m.
    pub along_m: [f64; 2],
    /// Along its width and height, of length 1.
    pub axes: [DVec3; 2],
    /// Half its width and height, a margin with them, m; no height: it is round, and in two dimensions has none either.
    pub half_m: [Option<f64>; 2],
}

impl Channel {
    /// How far a place of the frame is inside, m; negative outside.
    pub fn depth_m(&self, place_m: DVec3) -> f64 {
        let ahead_m = place_m.dot(self.direction);
        let along_m = (ahead_m - self.along_m[0]).min(self.along_m[1] - ahead_m);
        let [u_m, v_m] = self.axes.map(|axis| place_m.dot(axis));
        let across_m = match self.half_m {
            [Some(width_m), Some(height_m)] => (width_m - u_m.abs()).min(height_m - v_m.abs()),
            [Some(radius_m), None] => radius_m - u_m.hypot(v_m),
            [None, _] => f64::NEG_INFINITY,
        };
        along_m.min(across_m)
    }
}

/// The velocity that a particle inside has.
pub fn guided_m_s(channel: &Channel, flow: &Flow, position_m: DVec3, dt_s: f64) -> DVec3 {
    let [before, after] = flow.poses;
    let moved_m = after.from_frame(before.in_frame(position_m)) - position_m;
    before.rotation * channel.direction * channel.speed_m_s + moved_m / dt_s
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_round_channel_is_narrower_at_its_corners() {
        let round = Channel {
            direction: DVec3::X,
            speed_m_s: 1.0,
            along_m: [-0.1, 0.2],
            axes: [DVec3::Z, DVec3::Y],
            half_m: [Some(0.3), None],
        };
        let square = Channel { half_m: [Some(0.3); 2], ..round };
        let corner_m = DVec3::new(0.0, 0.25, 0.25);
        assert!(round.depth_m(corner_m) < 0.0 && square.depth_m(corner_m) > 0.0);
        assert!((round.depth_m(DVec3::ZERO) - 0.1).abs() < 1e-12 && round.depth_m(0.25 * DVec3::X) < 0.0);
    }
}
