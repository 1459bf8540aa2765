//! A window that is looked at for long, with scene after scene, takes no more and more memory.
//!
//! A minute here; `BROOKLET_SOAK_S=1800` makes it half an hour. On a CPU driver the process's memory is
//! the GPU's as well.

use std::time::{Duration, Instant};

use crate::support::User;
use brooklet_tests::program::Workshop;

/// From scene to scene the window builds another engine, of other sizes.
const SCENES: [&str; 4] = ["falling-ball", "calm-pool", "colliding-drops", "dam-break"];
const STAY: Duration = Duration::from_secs(5);

#[test]
fn memory_does_not_grow_from_scene_to_scene() {
    let seconds = std::env::var("BROOKLET_SOAK_S").ok().and_then(|text| text.parse().ok()).unwrap_or(60);
    let shop = Workshop::new();
    let mut command = shop.command(["view", "dam-break", "--rung", "6", "--budget", "100", "--out", "soak"]);
    let mut user = User::open(&mut command, shop.path("").as_path());
    let begun = Instant::now();
    let mut megabytes: Vec<f64> = Vec::new();
    let mut round = 0;
    while begun.elapsed() < Duration::from_secs(seconds) || round < 2 {
        for scene in SCENES {
            user.click("scenes");
            user.click(&format!("scene {scene}"));
            let running = |user: &User| user.fact("scene") == scene && user.fact("steps").as_u64() > Some(3);
            user.wait(scene, |user| running(user).then_some(()));
            std::thread::sleep(STAY.min(Duration::from_secs(seconds) / 12));
        }
        round += 1;
        // Each round ends with the same scene, and everything has been opened once after the first.
        megabytes.push(user.memory_mb());
        println!("{:6.0} s: round {round}, {:.0} MB", begun.elapsed().as_secs_f64(), megabytes[round - 1]);
    }
    user.screen.key(u32::from(b'q'), true);
    assert!(user.ended().success(), "{}", user.words());
    // A leak of one engine a round would be tens of megabytes each time.
    let (first, last) = (megabytes[0], megabytes[megabytes.len() - 1]);
    assert!(last < 1.1 * first + 20.0, "{megabytes:.0?} MB");
    if megabytes.len() >= 12 {
        let middle = |range: &[f64]| {
            let mut range = range.to_vec();
            range.sort_unstable_by(f64::total_cmp);
            range[range.len() / 2]
        };
        let third = megabytes.len() / 3;
        let (early, late) = (middle(&megabytes[third..2 * third]), middle(&megabytes[2 * third..]));
        println!("middle third {early:.1} MB, last third {late:.1} MB");
        assert!(late < 1.03 * early + 4.0, "{megabytes:.0?} MB");
    }
}
