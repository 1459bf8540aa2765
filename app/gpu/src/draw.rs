//! What a draw is drawn to, and the fixed state of its pipeline. Plain data.

use brooklet_kernels::{Format, ResourceId, Texture};

/// What a target holds when a draw starts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Load<V> {
    /// This value everywhere.
    Clear(V),
    /// What was drawn before.
    Keep,
}

/// Textures a draw writes.
#[derive(Clone, Debug, Default)]
pub struct Targets<'a> {
    /// Colour targets by `SV_Target` number; a clear value is linear RGBA.
    pub color: Vec<(&'a Texture, Load<[f64; 4]>)>,
    /// Depth target; a clear value is a depth in 0..=1.
    pub depth: Option<(&'a Texture, Load<f32>)>,
}

/// How vertices become primitives.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Topology {
    /// Every three vertices are a triangle.
    #[default]
    TriangleList,
    /// Each vertex after the second adds a triangle.
    TriangleStrip,
    /// Every two vertices are a line.
    LineList,
    /// Each vertex after the first adds a line.
    LineStrip,
    /// Each vertex is a point.
    PointList,
}

/// Which faces are not drawn; a front face is counter-clockwise.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Cull {
    /// Both are drawn.
    #[default]
    None,
    /// Front faces are not drawn.
    Front,
    /// Back faces are not drawn.
    Back,
}

/// How a fragment is mixed with what its colour targets hold.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Blend {
    /// It replaces it.
    #[default]
    None,
    /// `source * alpha + target * (1 - alpha)`.
    Alpha,
    /// `source + target`.
    Additive,
}

/// Which fragments pass the depth test.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum DepthTest {
    /// All.
    #[default]
    Off,
    /// Those with a smaller depth than the target holds.
    Less,
    /// Those with no greater depth.
    LessEqual,
    /// Those with a greater depth (reversed depth).
    Greater,
    /// Those with no smaller depth (reversed depth).
    GreaterEqual,
}

/// Fixed state of a draw's pipeline.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DrawState {
    /// How vertices become primitives.
    pub topology: Topology,
    /// Which faces are not drawn.
    pub cull: Cull,
    /// How colours are mixed.
    pub blend: Blend,
    /// Which fragments pass.
    pub depth_test: DepthTest,
    /// Whether passing fragments write their depth.
    pub depth_write: bool,
}

/// [`Targets`] as a recording keeps them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RecordedTargets {
    /// Colour targets in order.
    pub color: Vec<(ResourceId, Load<[f64; 4]>)>,
    /// Depth target.
    pub depth: Option<(ResourceId, Load<f32>)>,
}

impl RecordedTargets {
    /// Whether a draw to `next` may share the render pass of a draw to these: the same textures,
    /// all kept.
    pub fn continued_by(&self, next: &Self) -> bool {
        let all_kept = next.color.iter().all(|(_, load)| *load == Load::Keep)
            && next.depth.is_none_or(|(_, load)| load == Load::Keep);
        let colours = |targets: &Self| targets.color.iter().map(|(id, _)| *id).collect::<Vec<_>>();
        all_kept && colours(self) == colours(next) && self.depth.map(|(id, _)| id) == next.depth.map(|(id, _)| id)
    }
}

impl From<&Targets<'_>> for RecordedTargets {
    fn from(targets: &Targets<'_>) -> Self {
        Self {
            color: targets.color.iter().map(|(t, load)| (t.id, *load)).collect(),
            depth: targets.depth.map(|(t, load)| (t.id, load)),
        }
    }
}

/// wgpu's name of a format.
pub fn texture_format(format: Format) -> wgpu::TextureFormat {
    use wgpu::TextureFormat as F;
    match format {
        Format::R32Float => F::R32Float,
        Format::Rg32Float => F::Rg32Float,
        Format::Rgba32Float => F::Rgba32Float,
        Format::R16Float => F::R16Float,
        Format::Rg16Float => F::Rg16Float,
        Format::Rgba16Float => F::Rgba16Float,
        Format::R32Uint => F::R32Uint,
        Format::Rgba8Unorm => F::Rgba8Unorm,
        Format::Rgba8UnormSrgb => F::Rgba8UnormSrgb,
        Format::Depth32Float => F::Depth32Float,
        Format::Depth24Plus => F::Depth24Plus,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_kept_targets_continue_a_pass() {
        let a = ResourceId(0);
        let depth = Some((ResourceId(1), Load::Keep));
        let cleared = RecordedTargets { color: vec![(a, Load::Clear([0.0; 4]))], depth };
        let kept = RecordedTargets { color: vec![(a, Load::Keep)], depth };
        let no_depth = RecordedTargets { depth: None, ..kept.clone() };
        assert!(cleared.continued_by(&kept));
        assert!(!kept.continued_by(&cleared));
        assert!(!cleared.continued_by(&no_depth));
    }
}
