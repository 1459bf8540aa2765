//! Steps to wgpu commands, with as few passes as can be, and a timestamp around each stage.

use crate::device::Gpu;
use crate::readback::Ticks;
use crate::recording::RecordingId;
use crate::steps::{DispatchStep, DrawsStep, Ready, Step, StepGroups, StepInstances};
use crate::timing::{SpanSlot, TimingStatus};
use brooklet_kernels::Tier;

/// At most this many timestamps are taken while these steps are encoded.
pub(crate) fn tick_bound(steps: &[Step]) -> u32 {
    steps
        .iter()
        .map(|step| match step {
            Step::Dispatch(_) => 2,
            Step::Draws(pass) => 2 + pass.draws.len() as u32,
            Step::Clear { .. } | Step::Copy { .. } => 0,
        })
        .sum()
}

pub(crate) struct Encoder<'a> {
    commands: wgpu::CommandEncoder,
    ticks: &'a mut Ticks,
    timing: TimingStatus,
    /// Whether draws that share a pass are timed one by one. Tile-based GPUs draw them together,
    /// tile by tile: there only the pass has a time.
    time_each_draw: bool,
    dispatches: u64,
}

impl<'a> Encoder<'a> {
    pub fn new(gpu: &Gpu, ticks: &'a mut Ticks) -> Self {
        let timing = gpu.timing();
        Self {
            commands: gpu.device().create_command_encoder(&wgpu::CommandEncoderDescriptor::default()),
            ticks,
            timing,
            time_each_draw: timing == TimingStatus::InsidePasses && gpu.tier() == Tier::Desktop,
            dispatches: 0,
        }
    }

    pub fn finish(self) -> (wgpu::CommandEncoder, u64) {
        (self.commands, self.dispatches)
    }

    pub fn recording(&mut self, ready: &Ready) {
        let mut steps = ready.steps.as_slice();
        while let Some((first, rest)) = steps.split_first() {
            match first {
                Step::Clear { buffer, bytes } => self.commands.clear_buffer(buffer, 0, Some(*bytes)),
                Step::Copy { from, to, bytes } => {
                    self.commands.copy_buffer_to_buffer(from, 0, to, 0, *bytes);
                }
                Step::Draws(pass) => self.draws(ready.id, pass),
                Step::Dispatch(dispatch) if self.timing == TimingStatus::PassPerStage => {
                    self.lone_dispatch(ready.id, dispatch);
                }
                Step::Dispatch(_) => {
                    let run = steps.iter().take_while(|step| matches!(step, Step::Dispatch(_))).count();
                    self.dispatches(ready.id, &steps[..run]);
                    steps = &steps[run..];
                    continue;
                }
            }
            steps = rest;
        }
    }

    /// One pass for all: each wgpu pass is a command buffer of its own.
    fn dispatches(&mut self, recording: RecordingId, steps: &[Step]) {
        let mut pass = self.commands.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
        let timed = self.timing == TimingStatus::InsidePasses;
        let mut before = None;
        if timed && let Some((set, place, number)) = self.ticks.take(1) {
            pass.write_timestamp(set, place);
            before = Some(number);
        }
        for step in steps {
            let Step::Dispatch(step) = step else { continue };
            dispatch(&mut pass, step);
            self.dispatches += 1;
            let Some(begin) = before else { continue };
            if let Some((set, place, end)) = self.ticks.take(1) {
                pass.write_timestamp(set, place);
                before = Some(end);
                self.ticks.spans.push(SpanSlot { recording, stage: step.stage, begin, end });
            }
        }
    }

    fn lone_dispatch(&mut self, recording: RecordingId, step: &DispatchStep) {
        let pair = self.ticks.take(2);
        let first = pair.map(|(_, _, number)| number);
        let mut pass = self.commands.begin_compute_pass(&wgpu::ComputePassDescriptor {
            label: Some(step.stage),
            timestamp_writes: pair.map(|(set, place, _)| wgpu::ComputePassTimestampWrites {
                query_set: set,
                beginning_of_pass_write_index: Some(place),
                end_of_pass_write_index: Some(place + 1),
            }),
        });
        dispatch(&mut pass, step);
        drop(pass);
        self.dispatches += 1;
        self.pair_span(recording, step.stage, first);
    }

    fn pair_span(&mut self, recording: RecordingId, stage: &'static str, first: Option<u32>) {
        if let Some(begin) = first {
            self.ticks.spans.push(SpanSlot { recording, stage, begin, end: begin + 1 });
        }
    }

    fn draws(&mut self, recording: RecordingId, step: &DrawsStep) {
        let pass_pair = (self.timing.is_measured() && !self.time_each_draw).then(|| self.ticks.take(2)).flatten();
        let first = pass_pair.map(|(_, _, number)| number);
        let color: Vec<_> = step
            .color
            .iter()
            .map(|(view, load)| {
                Some(wgpu::RenderPassColorAttachment {
                    view,
                    depth_slice: None,
                    resolve_target: None,
                    ops: wgpu::Operations { load: *load, store: wgpu::StoreOp::Store },
                })
            })
            .collect();
        let mut pass = self.commands.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: None,
            color_attachments: &color,
            depth_stencil_attachment: step.depth.as_ref().map(|(view, load)| wgpu::RenderPassDepthStencilAttachment {
                view,
                depth_ops: Some(wgpu::Operations { load: *load, store: wgpu::StoreOp::Store }),
                stencil_ops: None,
            }),
            timestamp_writes: pass_pair.map(|(set, place, _)| wgpu::RenderPassTimestampWrites {
                query_set: set,
                beginning_of_pass_write_index: Some(place),
                end_of_pass_write_index: Some(place + 1),
            }),
            occlusion_query_set: None,
            multiview_mask: None,
        });
        let mut before = None;
        if self.time_each_draw
            && let Some((set, place, number)) = self.ticks.take(1)
        {
            pass.write_timestamp(set, place);
            before = Some(number);
        }
        for draw in &step.draws {
            pass.set_pipeline(&draw.pipeline);
            pass.set_bind_group(0, &draw.bind_group, &[]);
            match &draw.instances {
                StepInstances::Fixed(count) if draw.vertices > 0 && *count > 0 => {
                    pass.draw(0..draw.vertices, 0..*count);
                }
                StepInstances::Fixed(_) => {}
                StepInstances::Indirect { args, offset_bytes } => pass.draw_indirect(args, *offset_bytes),
            }
            self.dispatches += 1;
            let Some(begin) = before else { continue };
            if let Some((set, place, end)) = self.ticks.take(1) {
                pass.write_timestamp(set, place);
                before = Some(end);
                self.ticks.spans.push(SpanSlot { recording, stage: draw.stage, begin, end });
            }
        }
        drop(pass);
        if let Some(draw) = step.draws.first() {
            self.pair_span(recording, draw.stage, first);
        }
    }
}

fn dispatch(pass: &mut wgpu::ComputePass<'_>, step: &DispatchStep) {
    pass.set_pipeline(&step.pipeline);
    pass.set_bind_group(0, &step.bind_group, &[]);
    match &step.groups {
        StepGroups::Fixed([x, y, z]) => pass.dispatch_workgroups(*x, *y, *z),
        StepGroups::Indirect { args, offset_bytes } => pass.dispatch_workgroups_indirect(args, *offset_bytes),
    }
}
