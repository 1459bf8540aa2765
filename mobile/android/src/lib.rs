//! The phone's app as Android loads it: `libbrooklet.so`, whose `ANativeActivity_onCreate` is android-activity's.
//!
//! What the app does is in `brooklet-mobile`. Here it is handed what Android has: a window, touches, the back key,
//! the accelerometer, the display's rotation, thermal headroom, the files' place. `android` is compiled for Android
//! alone; what stands beside it knows no Android and is tested on any machine.

pub mod lifecycle;
pub mod screen;
pub mod self_test;
pub mod touches;

#[cfg(target_os = "android")]
mod android;

#[cfg(all(target_os = "android", feature = "no-ndk"))]
extern crate unwinding as _;

/// What Android knows the app by.
pub fn application_id() -> &'static str {
    let properties = include_str!("../android.properties");
    properties.lines().find_map(|line| line.strip_prefix("applicationId=")).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_application_has_an_id() {
        assert_eq!(super::application_id(), "org.brooklet.app");
    }
}
