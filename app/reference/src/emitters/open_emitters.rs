//! What each emitter does in a substep. (Shader: `emitters/open_emitters.compute`.)

use brooklet_kernels::Keyframe;

use crate::boundary::solids::Pose;
use crate::boundary::solids::motion::pose_at;

/// An emitter; see `Emitter` of the shaders' layout.
#[derive(Clone, Debug)]
pub struct Emitter {
    /// Of its nozzle's motion.
    pub keyframes: Vec<Keyframe>,
    /// After which they begin again; 0: never.
    pub period_s: f64,
    /// Of its flow.
    pub speed_m_s: f64,
    /// From one layer to the next; none of what fills at once.
    pub spacing_m: Option<f64>,
    /// From when on it flows.
    pub start_s: f64,
    /// Until when.
    pub end_s: f64,
    /// Layers of a substep, at most.
    pub most_layers: u32,
    /// Particles of a layer.
    pub points: u32,
}

/// What lasts of it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct State {
    /// Spacings by which its flow moved since half a spacing before the last layer.
    pub moved: f64,
    /// Layers so far.
    pub layers: u32,
}

/// What it does in a substep.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Flow {
    /// Where its nozzle is when the substep begins, and when it ends.
    pub poses: [Pose; 2],
    /// How far its oldest layer is ahead of the nozzle, m.
    pub ahead_m: f64,
    /// Its layers.
    pub layers: u32,
    /// Number of the oldest.
    pub layer: u32,
}

/// The flow of a substep from `begin_s` to `end_s`, and the state that it leaves.
pub fn open_emitter(emitter: &Emitter, state: State, begin_s: f64, end_s: f64) -> (Flow, State) {
    let poses = [begin_s, end_s].map(|time_s| pose_at(&emitter.keyframes, emitter.period_s, time_s));
    let still = Flow { poses, ahead_m: 0.0, layers: 0, layer: state.layers };
    match emitter.spacing_m {
        Some(spacing_m) => {
            let due = (state.moved + 0.5).floor();
            let flows_s = (end_s.min(emitter.end_s) - begin_s.max(emitter.start_s)).max(0.0);
            let layers = (due.max(0.0) as u32).min(emitter.most_layers);
            let moved = state.moved - due + emitter.speed_m_s * flows_s / spacing_m;
            let flow = Flow { layers, ahead_m: (state.moved - 0.5) * spacing_m, ..still };
            (flow, State { moved, layers: state.layers + layers })
        }
        None => {
            let layers = u32::from(state.layers == 0 && begin_s >= emitter.start_s);
            (Flow { layers, ..still }, State { layers: state.layers + layers, ..state })
        }
    }
}

/// The first particle of each emitter among those of all, and how many there are.
pub fn first_particles(emitters: &[Emitter], flows: &[Flow]) -> (Vec<u32>, u32) {
    let mut sum = 0;
    let counts = emitters.iter().zip(flows).map(|(emitter, flow)| emitter.points * flow.layers);
    let firsts = counts.map(|count| {
        let first = sum;
        sum += count;
        first
    });
    (firsts.collect(), sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_much_comes_as_flows_whatever_the_substep() {
        let still = Keyframe { rotation: [0.0, 0.0, 0.0, 1.0], ..Keyframe::default() };
        let emitter = Emitter {
            keyframes: vec![still],
            period_s: 0.0,
            speed_m_s: 0.7,
            spacing_m: Some(0.05),
            start_s: 0.13,
            end_s: 1.9,
            most_layers: 9,
            points: 3,
        };
        for substeps in [7, 40, 333] {
            let dt_s = 2.0 / f64::from(substeps);
            let mut state = State::default();
            // How far each layer is from the nozzle at the end.
            let mut layers_m: Vec<f64> = Vec::new();
            for n in 0..substeps {
                let begin_s = f64::from(n) * dt_s;
                let (flow, next) = open_emitter(&emitter, state, begin_s, begin_s + dt_s);
                assert_eq!(flow.layer as usize, layers_m.len());
                layers_m.extend((0..flow.layers).map(|j| flow.ahead_m - f64::from(j) * 0.05));
                let flows_s = ((begin_s + dt_s).min(1.9) - begin_s.max(0.13)).max(0.0);
                layers_m.iter_mut().for_each(|at_m| *at_m += 0.7 * flows_s);
                state = next;
            }
            // One that is due at the very end comes with the next substep.
            let wanted: f64 = 0.7 * (1.9 - 0.13) / 0.05;
            assert!(
                (layers_m.len() as f64 - wanted).abs() <= 0.5 + 0.7 * dt_s / 0.05,
                "{substeps}: {}",
                layers_m.len()
            );
            for pair in layers_m.windows(2) {
                assert!((pair[0] - pair[1] - 0.05).abs() < 1e-9, "{substeps}: a spacing from one to the next");
            }
        }
    }
}
