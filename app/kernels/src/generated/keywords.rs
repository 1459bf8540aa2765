// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from all shaders.
//! Choices among keywords, of which one is on.

/// `#pragma multi_compile ALONG_X ALONG_Y`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum AlongKeyword {
    /// `ALONG_X` is on.
    #[default]
    AlongX,
    /// `ALONG_Y` is on.
    AlongY,
}

/// `#pragma multi_compile _ COLOR_FLUID COLOR_DENSITY`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ColorKeyword {
    /// None of them is on.
    #[default]
    Off,
    /// `COLOR_FLUID` is on.
    ColorFluid,
    /// `COLOR_DENSITY` is on.
    ColorDensity,
}

/// `COLOR_FLUID` on or off, and no other.
impl From<bool> for ColorKeyword {
    fn from(on: bool) -> Self {
        if on { Self::ColorFluid } else { Self::Off }
    }
}

/// `#pragma multi_compile FILTER_X FILTER_Y FILTER_PLANE`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum FilterKeyword {
    /// `FILTER_X` is on.
    #[default]
    FilterX,
    /// `FILTER_Y` is on.
    FilterY,
    /// `FILTER_PLANE` is on.
    FilterPlane,
}

/// `#pragma multi_compile _ MOMENTUM ACCUMULATED_MOMENTUM RESTRICTED_MOMENTUM`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum MomentumKeyword {
    /// None of them is on.
    #[default]
    Off,
    /// `MOMENTUM` is on.
    Momentum,
    /// `ACCUMULATED_MOMENTUM` is on.
    AccumulatedMomentum,
    /// `RESTRICTED_MOMENTUM` is on.
    RestrictedMomentum,
}

/// `MOMENTUM` on or off, and no other.
impl From<bool> for MomentumKeyword {
    fn from(on: bool) -> Self {
        if on { Self::Momentum } else { Self::Off }
    }
}

/// `#pragma multi_compile _ VELOCITIES_ONLY POSITIONS_ONLY`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum OnlyKeyword {
    /// None of them is on.
    #[default]
    Off,
    /// `VELOCITIES_ONLY` is on.
    VelocitiesOnly,
    /// `POSITIONS_ONLY` is on.
    PositionsOnly,
}

/// `VELOCITIES_ONLY` on or off, and no other.
impl From<bool> for OnlyKeyword {
    fn from(on: bool) -> Self {
        if on { Self::VelocitiesOnly } else { Self::Off }
    }
}

/// `#pragma multi_compile _ RELAXED_PRECISION HALF_PRECISION`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum PrecisionKeyword {
    /// None of them is on.
    #[default]
    Off,
    /// `RELAXED_PRECISION` is on.
    RelaxedPrecision,
    /// `HALF_PRECISION` is on.
    HalfPrecision,
}

/// `RELAXED_PRECISION` on or off, and no other.
impl From<bool> for PrecisionKeyword {
    fn from(on: bool) -> Self {
        if on { Self::RelaxedPrecision } else { Self::Off }
    }
}

/// `#pragma multi_compile _ POINTS_SHADOW WATER_SHADOW CAUSTICS_SHADOW`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ShadowKeyword {
    /// None of them is on.
    #[default]
    Off,
    /// `POINTS_SHADOW` is on.
    PointsShadow,
    /// `WATER_SHADOW` is on.
    WaterShadow,
    /// `CAUSTICS_SHADOW` is on.
    CausticsShadow,
}

/// `POINTS_SHADOW` on or off, and no other.
impl From<bool> for ShadowKeyword {
    fn from(on: bool) -> Self {
        if on { Self::PointsShadow } else { Self::Off }
    }
}

/// `#pragma multi_compile _ SPRAY_SHAPE ELLIPSOID_SHAPE`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ShapeKeyword {
    /// None of them is on.
    #[default]
    Off,
    /// `SPRAY_SHAPE` is on.
    SprayShape,
    /// `ELLIPSOID_SHAPE` is on.
    EllipsoidShape,
}

/// `SPRAY_SHAPE` on or off, and no other.
impl From<bool> for ShapeKeyword {
    fn from(on: bool) -> Self {
        if on { Self::SprayShape } else { Self::Off }
    }
}

/// `#pragma multi_compile _ POINTS_SUN VOLUME_SUN`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum SunKeyword {
    /// None of them is on.
    #[default]
    Off,
    /// `POINTS_SUN` is on.
    PointsSun,
    /// `VOLUME_SUN` is on.
    VolumeSun,
}

/// `POINTS_SUN` on or off, and no other.
impl From<bool> for SunKeyword {
    fn from(on: bool) -> Self {
        if on { Self::PointsSun } else { Self::Off }
    }
}

/// `#pragma multi_compile _ KEEP_VELOCITY IN_PLACE_VELOCITY`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum VelocityKeyword {
    /// None of them is on.
    #[default]
    Off,
    /// `KEEP_VELOCITY` is on.
    KeepVelocity,
    /// `IN_PLACE_VELOCITY` is on.
    InPlaceVelocity,
}

/// `KEEP_VELOCITY` on or off, and no other.
impl From<bool> for VelocityKeyword {
    fn from(on: bool) -> Self {
        if on { Self::KeepVelocity } else { Self::Off }
    }
}

/// `#pragma multi_compile _ WALLS SOLID_WALLS`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum WallsKeyword {
    /// None of them is on.
    #[default]
    Off,
    /// `WALLS` is on.
    Walls,
    /// `SOLID_WALLS` is on.
    SolidWalls,
}

/// `WALLS` on or off, and no other.
impl From<bool> for WallsKeyword {
    fn from(on: bool) -> Self {
        if on { Self::Walls } else { Self::Off }
    }
}

/// `#pragma multi_compile _ BEHIND_WATER BEFORE_WATER`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum WaterKeyword {
    /// None of them is on.
    #[default]
    Off,
    /// `BEHIND_WATER` is on.
    BehindWater,
    /// `BEFORE_WATER` is on.
    BeforeWater,
}

/// `BEHIND_WATER` on or off, and no other.
impl From<bool> for WaterKeyword {
    fn from(on: bool) -> Self {
        if on { Self::BehindWater } else { Self::Off }
    }
}
