//! To logcat, under the tag `brooklet`.

use ::log::{LevelFilter, error};
use android_logger::{Config, FilterBuilder};

/// Once for a process; later calls change nothing.
pub fn begin() {
    // wgpu says at `info` what it does every frame.
    let filter =
        FilterBuilder::new().filter_level(LevelFilter::Warn).filter_module("brooklet", LevelFilter::Info).build();
    android_logger::init_once(
        Config::default().with_tag("brooklet").with_max_level(LevelFilter::Info).with_filter(filter),
    );
    // The default hook writes to stderr, which is not always forwarded.
    std::panic::set_hook(Box::new(|panic| error!("{panic}")));
}
