// Written by the shader compiler; do not edit. `cargo run -p brooklet-compiler -- build`
// makes it anew from solver/sph/add_solid_density.compute.
//! Kernels of `solver/sph/add_solid_density.compute`.

use super::{
    Position, SmoothingKernelParams, SolidContact, SphParams, StepParams, StepState, VelocityPressure,
    VelocityPressureNormal,
};
use crate::{
    Access, BindingError, BindingInfo, BindingKind, Bound, Buf, BufMut, Kernel, Module, Spirv, StageKind, Tier,
    Uniform, bind,
};

/// Which variant of [`AddSolidDensity`] runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct AddSolidDensityVariant {
    /// Keyword `SURFACE_TENSION`.
    pub surface_tension: bool,
}

/// What solids add to the density that compute\_density left in place of the pressure, and the pressure of both; with
/// SURFACE\_TENSION what they add to the gradient of the colour field. A stage of its own: with what a particle knows of
/// solids compute\_density would bind more buffers than the floor tier has.
#[derive(Debug)]
pub struct AddSolidDensity<'a> {
    /// Its variant.
    pub variant: AddSolidDensityVariant,
    /// `StructuredBuffer<Position> sorted_positions`.
    pub sorted_positions: Buf<'a, Position>,
    /// `StructuredBuffer<SolidContact> solid_contacts`.
    pub solid_contacts: Buf<'a, SolidContact>,
    /// `RWStructuredBuffer<VelocityPressure> velocity_pressures`.
    pub velocity_pressures: Option<BufMut<'a, VelocityPressure>>,
    /// `ConstantBuffer<StepState> step_state`.
    pub step_state: Uniform<'a, StepState>,
    /// `ConstantBuffer<StepParams> step_params`.
    pub step_params: Uniform<'a, StepParams>,
    /// `ConstantBuffer<SmoothingKernelParams> density_walls`.
    pub density_walls: Uniform<'a, SmoothingKernelParams>,
    /// `ConstantBuffer<SphParams> sph`.
    pub sph: Uniform<'a, SphParams>,
    /// `RWStructuredBuffer<VelocityPressureNormal> velocity_pressure_normals`.
    pub velocity_pressure_normals: Option<BufMut<'a, VelocityPressureNormal>>,
    /// `ConstantBuffer<SmoothingKernelParams> tension_walls`.
    pub tension_walls: Option<Uniform<'a, SmoothingKernelParams>>,
}

impl Kernel for AddSolidDensity<'_> {
    const STAGE: &'static str = "add_solid_density";
    const GROUP_SIZE: [u32; 3] = [64, 1, 1];

    fn module(&self) -> &'static Module {
        if self.variant.surface_tension { &ADD_SOLID_DENSITY_WITH_SURFACE_TENSION } else { &ADD_SOLID_DENSITY }
    }
    fn bindings(&self) -> Result<Vec<Bound>, BindingError> {
        bind(
            self.module(),
            &[
                ("sorted_positions", Some(self.sorted_positions.id)),
                ("solid_contacts", Some(self.solid_contacts.id)),
                ("velocity_pressures", self.velocity_pressures.as_ref().map(|bound| bound.id)),
                ("step_state", Some(self.step_state.id)),
                ("step_params", Some(self.step_params.id)),
                ("density_walls", Some(self.density_walls.id)),
                ("sph", Some(self.sph.id)),
                ("velocity_pressure_normals", self.velocity_pressure_normals.as_ref().map(|bound| bound.id)),
                ("tension_walls", self.tension_walls.as_ref().map(|bound| bound.id)),
            ],
        )
    }
}

/// The modules of this file.
pub(super) static MODULES: &[&Module] = &[&ADD_SOLID_DENSITY, &ADD_SOLID_DENSITY_WITH_SURFACE_TENSION];

static BINDINGS_0: &[BindingInfo] = &[
    BindingInfo {
        name: "sorted_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "solid_contacts",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 64 },
    },
    BindingInfo {
        name: "velocity_pressures",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 16 },
    },
    BindingInfo { name: "step_state", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 4, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "density_walls", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "sph", slot: 6, kind: BindingKind::Uniform { bytes: 64 } },
];

static BINDINGS_1: &[BindingInfo] = &[
    BindingInfo {
        name: "sorted_positions",
        slot: 0,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 16 },
    },
    BindingInfo {
        name: "solid_contacts",
        slot: 1,
        kind: BindingKind::Storage { access: Access::Read, stride_bytes: 64 },
    },
    BindingInfo {
        name: "velocity_pressure_normals",
        slot: 2,
        kind: BindingKind::Storage { access: Access::ReadWrite, stride_bytes: 32 },
    },
    BindingInfo { name: "step_state", slot: 3, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "step_params", slot: 4, kind: BindingKind::Uniform { bytes: 96 } },
    BindingInfo { name: "density_walls", slot: 5, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "tension_walls", slot: 6, kind: BindingKind::Uniform { bytes: 48 } },
    BindingInfo { name: "sph", slot: 7, kind: BindingKind::Uniform { bytes: 64 } },
];

static PACK: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/solver_sph_add_solid_density.deflate"));

static ADD_SOLID_DENSITY: Module = Module {
    name: "AddSolidDensity",
    entry: "AddSolidDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 0, bytes: 8092 },
    bindings: BINDINGS_0,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/add_solid_density.compute",
    hash: "261011ea3916e931332443551e67e688d9120ae2a41ad3233188423ee401230a",
};

static ADD_SOLID_DENSITY_WITH_SURFACE_TENSION: Module = Module {
    name: "AddSolidDensity+SURFACE_TENSION",
    entry: "AddSolidDensity",
    stage: StageKind::Compute,
    spirv: Spirv::Packed { pack: PACK, first: 8092, bytes: 11824 },
    bindings: BINDINGS_1,
    group_size: [64, 1, 1],
    shared_bytes: 0,
    tier: Tier::Floor,
    source: "solver/sph/add_solid_density.compute",
    hash: "7c2affae8242cc7776eedeea432a22425bff991fb3965bfe8922dbe8bca5b756",
};
