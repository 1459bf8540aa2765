//! The activity: what only Java tells and does of it.

use android_activity::AndroidApp;
use jni::objects::JObject;
use jni::refs::Global;
use jni::{Env, JavaVM, jni_sig, jni_str};

/// Pixels a point: Android's points are 160 to an inch.
pub fn pixels_per_point(android: &AndroidApp) -> f32 {
    android.config().density().map_or(1.0, |dpi| (dpi as f32 / 160.0).clamp(0.5, 8.0))
}

/// Degrees that the display is turned from its natural orientation: 0, 90, 180 or 270. The NDK does not tell before
/// API 34, so the activity's display is asked; 0 if it does not answer.
pub fn rotation_degrees(android: &AndroidApp) -> u32 {
    let quarters = in_java(android, |env, activity| {
        let windows = env
            .call_method(activity, jni_str!("getWindowManager"), jni_sig!(() -> android.view.WindowManager), &[])?
            .l()?;
        let display =
            env.call_method(&windows, jni_str!("getDefaultDisplay"), jni_sig!(() -> android.view.Display), &[])?.l()?;
        env.call_method(&display, jni_str!("getRotation"), jni_sig!(() -> jint), &[])?.i()
    });
    u32::try_from(quarters.unwrap_or(0)).unwrap_or(0) % 4 * 90
}

/// Leaves the app running behind what the user had before.
pub fn move_to_back(android: &AndroidApp) {
    in_java(android, |env, activity| {
        env.call_method(activity, jni_str!("moveTaskToBack"), jni_sig!((jboolean) -> jboolean), &[true.into()])?.z()
    });
}

/// What `call` gives; an exception is logged, and gives none.
fn in_java<T>(
    android: &AndroidApp,
    call: impl FnOnce(&mut Env<'_>, &JObject<'_>) -> jni::errors::Result<T>,
) -> Option<T> {
    // SAFETY: the pointer is the process's Java VM, which outlives it.
    let vm = unsafe { JavaVM::from_raw(android.vm_as_ptr().cast()) };
    let activity = android.activity_as_ptr().cast();
    vm.attach_current_thread(|env| {
        // The thread stays attached: what is local to this call is dropped with its frame.
        env.with_local_frame(8, |env| {
            // SAFETY: a global reference that `android` keeps; it is borrowed, not deleted.
            let activity = unsafe { env.as_cast_raw::<Global<JObject<'_>>>(&activity)? };
            call(env, &activity)
        })
    })
    .inspect_err(|error| ::log::warn!("Java: {error}"))
    .ok()
}
