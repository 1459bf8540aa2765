//! Body forces of place and time. (Shader: `forces/apply_fields.compute`.)

use std::f64::consts::TAU;

use glam::DVec3;

/// One; see `ForceField` of the shaders' layout.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ForceField {
    /// Everywhere alike.
    pub acceleration_m_s2: DVec3,
    /// Around the centre, 1/s².
    pub swirl_per_s2: DVec3,
    /// A point of the swirl's axis.
    pub centre_m: DVec3,
    /// 0: steady.
    pub frequency_hz: f64,
    /// From when on.
    pub begin_s: f64,
    /// Until when.
    pub end_s: f64,
}

/// What of all of them acts at a place and a time, m/s².
pub fn fields_at(fields: &[ForceField], position_m: DVec3, time_s: f64) -> DVec3 {
    let active = fields.iter().filter(|field| (field.begin_s..field.end_s).contains(&time_s));
    let of = |field: &ForceField| {
        let swing = (TAU * field.frequency_hz * (time_s - field.begin_s)).cos();
        swing * (field.acceleration_m_s2 + field.swirl_per_s2.cross(position_m - field.centre_m))
    };
    active.map(of).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_swirl_turns_around_its_axis_and_swings() {
        let swirl = ForceField {
            swirl_per_s2: DVec3::new(0.0, 2.0, 0.0),
            centre_m: DVec3::X,
            frequency_hz: 0.5,
            begin_s: 1.0,
            end_s: 4.0,
            ..ForceField::default()
        };
        let at = |x: f64, time_s: f64| fields_at(&[swirl], DVec3::new(x, 7.0, 0.0), time_s);
        assert_eq!(at(3.0, 1.0), DVec3::new(0.0, 0.0, -4.0));
        assert!((at(3.0, 2.0) - DVec3::new(0.0, 0.0, 4.0)).length() < 1e-12, "half a period later");
        assert_eq!((at(3.0, 0.5), at(3.0, 4.0), at(1.0, 1.0)), (DVec3::ZERO, DVec3::ZERO, DVec3::ZERO));
    }
}
