//! What of the library needs no GPU and no Android, on known answers: `brooklet_self_test`, which a test calls in the
//! arm64 library under an emulator.

use std::io::Cursor;
use std::panic::catch_unwind;

use brooklet_capture::{Capture, CaptureOptions, CaptureWriter, StatField};
use brooklet_fluid::Scene;

use crate::screen::Screen;

/// A check. With `wrong` one of its inputs is another, and it has to fail.
type Check = fn(wrong: bool) -> bool;

/// In the order of their numbers, from 1.
pub const CHECKS: [(&str, Check); 7] = [
    ("f64 arithmetic and libm", doubles),
    ("f32 arithmetic and rounding", singles),
    ("a shipped scene", scene),
    ("a scene that is refused", refusal),
    ("PNG", picture),
    ("MCAP", capture),
    ("a panic is caught", panics),
];

/// Runs all checks, and returns the number of the first that fails, or 0. The check numbered `wrong` gets a wrong
/// input; 0 for none.
///
/// Nothing unwinds out of it: a check that panics has failed.
#[unsafe(no_mangle)]
pub extern "C" fn brooklet_self_test(wrong: u32) -> u32 {
    (1..).zip(CHECKS).find(|(number, (_, check))| !passes(*check, *number == wrong)).map_or(0, |(number, _)| number)
}

/// How many checks there are.
#[unsafe(no_mangle)]
pub extern "C" fn brooklet_self_test_count() -> u32 {
    CHECKS.len() as u32
}

fn passes(check: Check, wrong: bool) -> bool {
    catch_unwind(|| check(wrong)).unwrap_or(false)
}

/// What the compiler may not work out beforehand.
fn hidden<T>(value: T) -> T {
    std::hint::black_box(value)
}

/// Poly6's normalization and its value at r = h/2, a sine and an exponential; digits by another libm.
fn doubles(wrong: bool) -> bool {
    let h = hidden(if wrong { 1.0001 } else { 1.0_f64 });
    let poly6 = 315.0 / (64.0 * std::f64::consts::PI * h.powi(9)) * (h * h - 0.25_f64).powi(3);
    let near = |got: f64, known: f64| (got - known).abs() <= 4.0 * f64::EPSILON * known.abs();
    near(poly6, 0.660_943_745_603_793_9)
        && near(hidden(1.0_f64).sin(), 0.841_470_984_807_896_5)
        && near(hidden(1.0_f64).exp(), std::f64::consts::E)
        && near(hidden(2.0_f64).powf(0.5), std::f64::consts::SQRT_2)
}

/// 2^24 + 1 is no f32 and rounds to even; 0.1 + 0.2 in f32 is known to the bit; a NaN is not a number.
fn singles(wrong: bool) -> bool {
    let whole = hidden(16_777_216.0_f32) + hidden(if wrong { 2.0 } else { 1.0 });
    whole.to_bits() == 16_777_216.0_f32.to_bits()
        && (hidden(0.1_f32) + hidden(0.2_f32)).to_bits() == 0x3e99_999a
        && hidden(0.75_f32).sqrt().to_bits() == 0x3f5d_b3d7
        && hidden(f32::NAN).max(1.0) == 1.0
}

/// The dam break by its name, with a setting in place of its own: 0.6 m x 0.68 m x 0.6 m of water at 0.1 m.
fn scene(wrong: bool) -> bool {
    let spacing = format!("spacing_m={}", if wrong { 0.05 } else { 0.1 });
    Scene::load("dam-break", &[spacing]).is_ok_and(|scene| {
        let again = Scene::from_toml(&scene.to_toml(), "dam-break", &[]);
        scene.particle_count() == DAM_BREAK_AT_0_1_M && again.is_ok_and(|again| again == scene)
    })
}

/// What the desktop program counts.
const DAM_BREAK_AT_0_1_M: u64 = 216;

/// A spacing below nought is refused, by the field's name.
fn refusal(wrong: bool) -> bool {
    let spacing = if wrong { "spacing_m=0.1" } else { "spacing_m=-1" };
    Scene::load("dam-break", &[spacing.into()]).is_err_and(|error| error.to_string().contains("spacing_m"))
}

/// A screen of text through PNG and back.
fn picture(wrong: bool) -> bool {
    let screen = Screen::of_text("Brooklet", [120, 60]);
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, screen.width as u32, screen.height as u32);
    encoder.set_color(png::ColorType::Rgba);
    let written = encoder.write_header().and_then(|mut writer| writer.write_image_data(screen.rgba.as_flattened()));
    if written.is_err() {
        return false;
    }
    let Ok(mut reader) = png::Decoder::new(Cursor::new(&file)).read_info() else { return false };
    let mut pixels = vec![0; screen.rgba.len() * 4];
    let read = reader.next_frame(&mut pixels);
    let other = if wrong { "Brooklets" } else { "Brooklet" };
    read.is_ok() && pixels == Screen::of_text(other, [120, 60]).rgba.as_flattened()
}

/// A capture of ten measurements in memory, read back.
fn capture(wrong: bool) -> bool {
    let known: Vec<f64> = (0..10).map(|frame| f64::from(frame) * 0.5).collect();
    let options = CaptureOptions { stats: vec![StatField::new("speed", "m/s", "largest speed")], ..Default::default() };
    let mut file = Vec::new();
    let written = CaptureWriter::new(&mut file, "memory".into(), options).and_then(|mut writer| {
        for (frame, value) in (0..).zip(&known) {
            writer.stats(frame, frame * 1_000_000, &[value + f64::from(u8::from(wrong))])?;
        }
        writer.finish()
    });
    let length = file.len() as u64;
    written.is_ok()
        && Capture::read(Cursor::new(file), length, "memory")
            .is_ok_and(|capture| capture.stats.iter().filter_map(|row| row.values.get("speed").copied()).eq(known))
}

/// What a panic says comes back from where it is caught, through frames of this library.
fn panics(wrong: bool) -> bool {
    let thrown = catch_unwind(|| refuse(hidden(if wrong { 1 } else { 0 })));
    thrown.is_err_and(|payload| payload.downcast_ref::<String>().is_some_and(|said| said == "refused 0"))
}

#[inline(never)]
fn refuse(number: u32) -> u32 {
    // Without the hook's lines: this panic is meant.
    std::panic::resume_unwind(Box::new(format!("refused {number}")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_checks_pass_and_each_fails_on_a_wrong_input() {
        assert_eq!(brooklet_self_test(0), 0);
        for number in 1..=brooklet_self_test_count() {
            let name = CHECKS[number as usize - 1].0;
            assert_eq!(brooklet_self_test(number), number, "{name} passes on a wrong input");
        }
    }
}
