//! What phones' GPUs allow, from public device reports. Where a report was not at hand, what Vulkan 1.0 promises of any device
//! stands here, or what the tier needs.

use brooklet_kernels::{BindingKind, Module, Tier};
use wgpu::Limits;

/// A phone's GPU.
pub struct Phone {
    /// Its name.
    pub name: &'static str,
    /// What it is used as.
    pub tier: Tier,
    /// Threads of a group, and bytes of groupshared memory.
    pub threads: u32,
    /// Bytes of groupshared memory.
    pub shared_bytes: u32,
    /// Storage buffers, storage images, sampled textures and uniform buffers of a stage.
    pub bindings: [u32; 4],
    /// Bytes that a storage buffer's binding may have.
    pub storage_bytes: u64,
}

/// The source deck's phone (Xiaomi 6), and a newer one.
pub const PHONES: [Phone; 2] = [
    Phone {
        name: "Adreno 540",
        tier: Tier::Floor,
        threads: 512,
        shared_bytes: 32 << 10,
        bindings: [8, 4, 16, 12],
        storage_bytes: 2 << 30,
    },
    Phone {
        name: "Adreno 640",
        tier: Tier::Mobile,
        threads: 1024,
        shared_bytes: 32 << 10,
        bindings: [16, 8, 16, 12],
        storage_bytes: 128 << 20,
    },
];

/// How each binding is counted, in the order of [`Phone::bindings`].
pub const KINDS: [&str; 4] = ["storage buffers", "storage images", "textures", "uniform buffers"];

/// Bindings of a module of each of the [`KINDS`].
pub fn bindings(module: &Module) -> [u32; 4] {
    let mut count = [0; 4];
    for binding in module.bindings {
        let kind = match binding.kind {
            BindingKind::Storage { .. } => 0,
            BindingKind::StorageTexture { .. } => 1,
            BindingKind::Texture { .. } => 2,
            BindingKind::Uniform { .. } => 3,
            BindingKind::Sampler => continue,
        };
        count[kind] += 1;
    }
    count
}

impl Phone {
    /// What a module asks for beyond the phone; empty if it fits.
    pub fn excess(&self, module: &Module) -> Vec<String> {
        let threads: u32 = module.group_size.iter().product();
        let amounts =
            [("threads a group", threads, self.threads), ("groupshared bytes", module.shared_bytes, self.shared_bytes)];
        let bindings =
            KINDS.into_iter().zip(bindings(module)).zip(self.bindings).map(|((kind, n), most)| (kind, n, most));
        let all = amounts.into_iter().chain(bindings).chain([("threads along z", module.group_size[2], 64)]);
        all.filter(|(_, amount, most)| amount > most)
            .map(|(what, amount, most)| format!("{amount} {what} of {most}"))
            .collect()
    }

    /// The same as wgpu has it: all that a device of this kind may be asked for.
    pub fn limits(&self, tier: Limits) -> Limits {
        let [storage_buffers, storage_images, textures, uniforms] = self.bindings;
        Limits {
            max_compute_invocations_per_workgroup: self.threads,
            max_compute_workgroup_size_x: self.threads,
            max_compute_workgroup_size_y: self.threads,
            max_compute_workgroup_size_z: 64,
            max_compute_workgroup_storage_size: self.shared_bytes,
            max_storage_buffers_per_shader_stage: storage_buffers,
            max_storage_textures_per_shader_stage: storage_images,
            max_sampled_textures_per_shader_stage: textures,
            max_uniform_buffers_per_shader_stage: uniforms,
            max_storage_buffer_binding_size: self.storage_bytes.min(tier.max_storage_buffer_binding_size),
            max_bind_groups: 4,
            ..tier
        }
    }
}
