//! Touches by a script: every button once, fingers on the water, a capture, a way into the background and back.

use std::time::{Duration, Instant};

use brooklet_mobile::App;
use brooklet_mobile::script::{Hand, Readings};
use brooklet_render::png;

use crate::Options;

/// A phone in software takes its time.
const LONG: Duration = Duration::from_secs(300);

pub fn run(mut app: App, options: &Options, readings: &Readings) -> Result<(), String> {
    let size = [options.size[0], options.size[1]];
    let size_px = size.map(|points| (points * options.scale).round() as u32);
    app.resume_offscreen(size_px, options.scale);
    if let Some(reason) = app.failure() {
        return Err(reason.to_owned());
    }
    let mut script = Script { hand: Hand::new(app, options.scale), options, pictures: 0, begun: Instant::now() };
    std::fs::create_dir_all(&options.files).map_err(|error| format!("{}: {error}", options.files.display()))?;
    script.hand.until(Duration::from_millis(400), |_| false);
    script.keep("start")?;
    if !script.hand.until(LONG, |hand| hand.app.viewer().is_some_and(|viewer| viewer.current().is_some())) {
        return Err("no scene began".into());
    }
    script.simulate(readings, 20)?;
    script.keep("scene")?;
    script.hand.tap("capture")?;
    script.hand.tap("times")?;
    script.simulate(readings, 20)?;
    script.keep("times")?;
    let [x, y] = [0.5 * size[0], 0.5 * size[1]];
    script.hand.drag(&[([x - 60.0, y], [x + 60.0, y - 20.0])]);
    script.simulate(readings, 6)?;
    script.hand.drag(&[([x - 40.0, y], [x - 80.0, y + 20.0]), ([x + 40.0, y], [x + 80.0, y + 20.0])]);
    script.simulate(readings, 6)?;
    script.keep("nearer")?;
    script.hand.tap("times")?;
    script.hand.tap("scenes")?;
    script.keep("scenes")?;
    script.hand.tap("scene phone-5k")?;
    let begins = |hand: &mut Hand| {
        hand.app.viewer().and_then(|viewer| viewer.current()).is_some_and(|current| current.scene.name == "phone-5k")
    };
    if !script.hand.until(LONG, begins) {
        return Err("the other scene did not begin".into());
    }
    script.simulate(readings, 30)?;
    script.keep("other")?;
    script.hand.app.suspend();
    script.hand.app.resume_offscreen(size_px, options.scale);
    script.simulate(readings, 4)?;
    script.hand.tap("capture")?;
    script.keep("said")?;
    script.hand.tap("menu")?;
    script.keep("menu")?;
    script.hand.app.resume_offscreen([size_px[1], size_px[0]], options.scale);
    script.hand.until(Duration::from_secs(3), |_| false);
    script.keep("menu_turned")?;
    script.hand.app.back();
    script.hand.until(Duration::from_secs(3), |_| false);
    script.keep("turned")?;
    if let Some(viewer) = script.hand.app.viewer() {
        viewer.messages().for_each(|message| println!("{message}"));
    }
    Ok(())
}

struct Script<'a> {
    hand: Hand,
    options: &'a Options,
    pictures: u32,
    begun: Instant,
}

impl Script<'_> {
    /// So many steps, with the sensor's readings as they come.
    fn simulate(&mut self, readings: &Readings, steps: u64) -> Result<(), String> {
        let (begun, rotation) = (self.begun, self.options.rotation);
        for _ in 0..steps {
            if let Some(reading) = readings.at(begun.elapsed().as_secs_f64(), rotation) {
                self.hand.app.acceleration(reading);
            }
            if !self.hand.steps(1, LONG) {
                let said: Vec<&str> = self.hand.app.viewer().map_or(Vec::new(), |viewer| viewer.messages().collect());
                return Err(format!("no step in {} s: {}", LONG.as_secs(), said.join("; ")));
            }
        }
        Ok(())
    }

    fn keep(&mut self, name: &str) -> Result<(), String> {
        self.hand.settle();
        let picture = self.hand.app.picture().ok_or("nothing was painted")?;
        let path = self.options.files.join(format!("screen_{:02}_{name}.png", self.pictures));
        self.pictures += 1;
        png::save(&path, picture.size_px, &picture.rgba).map_err(|error| error.to_string())?;
        println!("{}", path.display());
        Ok(())
    }
}
