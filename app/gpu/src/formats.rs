//! What a device can do with the formats of textures.

use crate::draw::texture_format;
use brooklet_kernels::Format;
use wgpu::{Features, TextureFormatFeatureFlags as Can, TextureFormatFeatures, TextureUsages};

/// What a device can do with a format.
pub trait FormatSupport {
    /// Its features for `format`.
    fn features(&self, format: Format) -> TextureFormatFeatures;
}

impl<F: Fn(Format) -> TextureFormatFeatures> FormatSupport for F {
    fn features(&self, format: Format) -> TextureFormatFeatures {
        self(format)
    }
}

const FORMATS: [Format; 11] = [
    Format::R32Float,
    Format::Rg32Float,
    Format::Rgba32Float,
    Format::R16Float,
    Format::Rg16Float,
    Format::Rgba16Float,
    Format::R32Uint,
    Format::Rgba8Unorm,
    Format::Rgba8UnormSrgb,
    Format::Depth32Float,
    Format::Depth24Plus,
];

const NOTHING: TextureFormatFeatures =
    TextureFormatFeatures { allowed_usages: TextureUsages::empty(), flags: Can::empty() };

/// What is done with a texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FormatUse {
    /// Anything at all.
    Any,
    /// Drawn to, blended or not.
    Drawn,
    /// Blended to.
    Blended,
    /// Read with a filter.
    Filtered,
}

/// What a device said of each format.
#[derive(Clone, Debug)]
pub(crate) struct DeviceFormats(Vec<(Format, TextureFormatFeatures)>);

impl DeviceFormats {
    /// What the adapter has and wgpu allows a device with these features, but for those `without` which it is to be used.
    pub fn of(adapter: &wgpu::Adapter, features: Features, without: &[(Format, FormatUse)]) -> Self {
        let of = |format| {
            let wgpu = texture_format(format);
            let (has, allowed) = (adapter.get_texture_format_features(wgpu), wgpu.guaranteed_format_features(features));
            let allowed_usages = has.allowed_usages & allowed.allowed_usages;
            let mut known = TextureFormatFeatures { allowed_usages, flags: has.flags & allowed.flags };
            for (_, used) in without.iter().filter(|(other, _)| *other == format) {
                match used {
                    FormatUse::Any => known = NOTHING,
                    FormatUse::Drawn => known.allowed_usages -= TextureUsages::RENDER_ATTACHMENT,
                    FormatUse::Blended => known.flags -= Can::BLENDABLE,
                    FormatUse::Filtered => known.flags -= Can::FILTERABLE,
                }
            }
            (format, known)
        };
        Self(FORMATS.into_iter().map(of).collect())
    }

    /// Whether the device lacks anything of what every one is to have.
    pub fn lacks_any(&self) -> bool {
        FORMATS.into_iter().any(|format| {
            let promised = texture_format(format).guaranteed_format_features(Features::empty());
            let has = self.features(format);
            !has.allowed_usages.contains(promised.allowed_usages) || !has.flags.contains(promised.flags)
        })
    }
}

impl FormatSupport for DeviceFormats {
    fn features(&self, format: Format) -> TextureFormatFeatures {
        self.0.iter().find(|(known, _)| *known == format).map_or(NOTHING, |(_, features)| *features)
    }
}

/// A texture that has another format than it was declared with first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OtherFormat {
    /// The texture.
    pub label: String,
    /// The format that the device cannot use so.
    pub lacking: Format,
    /// What the plan does with it.
    pub used_as: &'static str,
    /// What it has instead.
    pub format: Format,
}
