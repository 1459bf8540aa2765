// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/dfsph/solve_state.compute.
//! Kernels of `solver/dfsph/solve_state.compute`.

use super::{Counters, PressureSolve, SolveState, StepState};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Ends a pressure solve on the GPU: where the mean residual is small enough, or nothing is left to try, the iterations behind
/// have no groups. The host recorded the most there may be, and is not asked.
#[derive(Debug)]
pub struct BeginSolve<'a> {
    /// `RWStructuredBuffer<SolveState> solve_state`.
    pub solve_state: BufMut<'a, SolveState>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
}

impl Kernel for BeginSolve<'_> {
    const STAGE: &'static str = "begin_solve";
    const GROUP_SIZE: [u32; 3] = [1, 1, 1];

    fn module(&self) -> &'static Module {
        &BEGIN_SOLVE
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(self.module(), &[("solve_state", Some(self.solve_state.id)), ("step_state", Some(self.step_state.id))])
    }
}

/// Between the two halves of an iteration: the second one is the first that may be left out.
#[derive(Debug)]
pub struct EndIteration<'a> {
    /// `StructuredBuffer<float> group_residuals`.
    pub group_residuals: Buf<'a, f32>,
    /// `RWStructuredBuffer<SolveState> solve_state`.
    pub solve_state: BufMut<'a, SolveState>,
    /// `RWStructuredBuffer<Counters> counters`.
    pub counters: BufMut<'a, Counters>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<PressureSolve> solve`.
    pub solve: Uniform<'a, PressureSolve>,
}

impl Kernel for EndIteration<'_> {
    const STAGE: &'static str = "end_iteration";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        &END_ITERATION
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("group_residuals", Some(self.group_residuals.id)),
                ("solve_state", Some(self.solve_state.id)),
                ("counters", Some(self.counters.id)),
                ("step_state", Some(self.step_state.id)),
                ("solve", Some(self.solve.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&BEGIN_SOLVE, &END_ITERATION];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "solve_state",
        slot: 0,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo { name: "step_state", slot: 1, kind: BindingKind::Uniform { bytes: 48 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo {
        name: "group_residuals",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 4 },
    },
    BindingInfo {
        name: "solve_state",
        slot: 1,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo {
        name: "counters",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 64 },
    },
    BindingInfo { name: "step_state", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "solve", slot: 4, kind: BindingKind::Uniform { bytes: 48 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_dfsph_solve_state.deflate"));

static BEGIN_SOLVE: Module = Module {
    name: "BeginSolve",
    entry: "BeginSolve",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 1596 },
    bindings: BINDINGS_0,
    group_size: [1, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/dfsph/solve_state.compute",
    hash: "2a699aec3eda80c79659072e8e42bb4ea77f25cae24b04b40da852322bce139d",
};

static END_ITERATION: Module = Module {
    name: "EndIteration",
    entry: "EndIteration",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 1596, bytes: 6116 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 256,
    tier: Tier::Floor,
    source: "solver/dfsph/solve_state.compute",
    hash: "0b60f7cfb638f94a4c882f7197364afba2dd50938178e38710b960b3c0fb89cf",
};
