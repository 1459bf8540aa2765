//! A picture that either method draws, as the next one is chosen. Frames run one of three recordings: screen space, the mesh,
//! or both with one picture over the other. What they need they have together.

use brooklet_gpu::{Blend, DrawState, Engine, FrameReport, Load, Recording, RecordingId, Targets};
use brooklet_kernels::{
    Buffer, COVERED_GROUP, COVERED_STRIDE, CountCovered, CrossFadeParams, DrawCrossFade, Format, Texture,
};

use super::{Frame, WaterPasses};
use crate::View;
use crate::surface::auto::{Shown, SurfaceChoice, expected_cover_px};
use crate::surface::{AutoOptions, MarchingCubesOptions, Particles, ScreenSpaceOptions};

/// What draws the picture with a mesh, and chooses. Beside it stands what draws it in screen space.
#[derive(Debug)]
pub struct AutoPasses {
    /// Draws the picture with a mesh.
    pub meshed: Recording,
    /// Draws it in screen space and with a mesh over that.
    pub both: Recording,
    /// The water of `meshed`.
    pub meshed_water: WaterPasses,
    /// How much of the mesh shows where both are drawn; to be written before.
    pub cross_fade: Buffer<CrossFadeParams>,
    /// One number, counted with each picture: of one in 16 drawn pixels, those that show the fluid.
    pub covered_px: Buffer<u32>,
    choice: SurfaceChoice,
    /// What the last picture showed, and by how many drawn pixels of fluid the next one is chosen.
    shown: Shown,
    seen_px: f64,
}

impl AutoPasses {
    /// The recording of the next picture, of `particles`, where `in_screen_space` is the one without a mesh. `fades`: the
    /// picture follows the last one closely enough for a change to be seen.
    pub fn next(
        &mut self,
        engine: &mut Engine,
        in_screen_space: RecordingId,
        particles: u32,
        fades: bool,
    ) -> RecordingId {
        self.shown = self.choice.next(self.seen_px, particles, fades);
        match self.shown {
            Shown::ScreenSpace => in_screen_space,
            Shown::Mesh => self.meshed.id(),
            Shown::Both(opacity) => {
                let params = CrossFadeParams { opacity: opacity as f32, ..CrossFadeParams::default() };
                engine.write(&self.cross_fade, &[params]);
                self.both.id()
            }
        }
    }

    /// Takes what a finished frame counted.
    pub fn learn(&mut self, report: &FrameReport) {
        if let Some(counted) = report.first(&self.covered_px) {
            self.seen_px = f64::from(counted) * f64::from(COVERED_STRIDE * COVERED_STRIDE);
        }
    }

    /// Whether the next picture would show something else than the last one.
    pub fn fades(&self, particles: u32) -> bool {
        { self.choice }.next(self.seen_px, particles, true) != self.shown
    }

    /// Goes on with the choice of the passes before these, so that a plan made anew changes no method.
    pub fn go_on_from(&mut self, before: &AutoPasses) {
        self.choice = before.choice.with(self.choice.options());
        self.seen_px = before.seen_px;
    }

    /// What the last picture showed.
    pub fn shown(&self) -> Shown {
        self.shown
    }

    /// Drawn pixels of fluid that the next picture is chosen by.
    pub fn seen_px(&self) -> f64 {
        self.seen_px
    }
}

/// Records all three: that in screen space into the frame's own recording.
pub(super) fn record(
    frame: &mut Frame<'_>,
    init: &mut Recording,
    (view, water, mesh, auto): (&View, &ScreenSpaceOptions, &MarchingCubesOptions, &AutoOptions),
    particles: &Particles<'_>,
    onto: (&Texture, &Texture),
    color: &Texture,
) -> (WaterPasses, AutoPasses) {
    let mut covered_px = frame.resources.buffer("covered_px", 1);
    let mut cross_fade = frame.resources.persistent("cross_fade", 1);
    init.upload(&mut cross_fade, &[CrossFadeParams::default()]);
    let beside = frame.resources.texture("picture_beside", Format::Rgba8Unorm, view.size_px);
    let mut meshed = frame.resources.recording("draw_meshed");
    let mut both = frame.resources.recording("draw_both");

    let first = frame.resources.len();
    let in_screen_space = frame.water(init, (view, water, None), particles, onto, color);
    count_covered(frame, &in_screen_space, &mut covered_px);
    both.append(frame.recording);
    let meshed_water = frame.repeating(first, &mut meshed, |frame| {
        let meshed_water = frame.water(init, (view, water, Some(mesh)), particles, onto, color);
        count_covered(frame, &meshed_water, &mut covered_px);
        meshed_water
    });
    frame.repeating(first, &mut both, |frame| {
        frame.water(init, (view, water, Some(mesh)), particles, onto, &beside);
        frame.recording.draw(
            &DrawCrossFade { picture: beside.read(), cross_fade: cross_fade.uniform() },
            &Targets { color: vec![(color, Load::Keep)], depth: None },
            DrawState { blend: Blend::Alpha, ..DrawState::default() },
            3,
            1,
        );
    });
    let seen_px = expected_cover_px(view, frame.options.supersample, water.spacing_m, particles.slots.capacity);
    let passes = AutoPasses {
        meshed,
        both,
        meshed_water,
        cross_fade,
        covered_px,
        choice: SurfaceChoice::new(*auto),
        shown: Shown::ScreenSpace,
        seen_px,
    };
    (in_screen_space, passes)
}

fn count_covered(frame: &mut Frame<'_>, water: &WaterPasses, covered_px: &mut Buffer<u32>) {
    let inverse_depth = &water.surface.inverse_depth;
    frame.recording.clear(covered_px);
    let [width, height] = inverse_depth.size_px.map(|side| side.div_ceil(COVERED_STRIDE).div_ceil(COVERED_GROUP));
    frame.recording.dispatch_groups(
        &CountCovered {
            inverse_depth: inverse_depth.read(),
            covered_px: covered_px.write(),
            view: frame.uniforms.view.uniform(),
        },
        [width, height, 1],
    );
}
