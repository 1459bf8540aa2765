//! What only Android has.

mod activity;
mod event_loop;
mod hints;
mod log;
mod sensors;
mod system;
mod text;
mod thermal;
mod window;

use std::panic::{AssertUnwindSafe, catch_unwind};

use android_activity::AndroidApp;

/// Android's thread of the app runs this, once for each activity: a process may see several, one after another. All that
/// is kept between two is the log.
///
/// A panic of the app becomes a screen that says so, until the user leaves it.
#[unsafe(no_mangle)]
fn android_main(android: AndroidApp) {
    log::begin();
    let run = catch_unwind(AssertUnwindSafe(|| event_loop::run(&android)));
    if let Err(panic) = run {
        let said = panic.downcast_ref::<String>().map(String::as_str).or(panic.downcast_ref::<&str>().copied());
        text::show(&android, &format!("Brooklet stopped.\n\n{}\n\nGo back to close it.", said.unwrap_or("")));
    }
}
