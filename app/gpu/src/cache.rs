//! Compiled pipelines kept in a file between runs, and never trusted: a driver given broken data
//! may crash, so the file carries what it was made for and a hash, and is written whole or not
//! at all.

use crate::canary::{Canary, Skipped};
use std::hash::{DefaultHasher, Hasher};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

const MAGIC: &[u8; 16] = b"brooklet cache 1";

/// How a pipeline cache was found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CacheStatus {
    /// Not asked for.
    Off,
    /// The device has none.
    Unsupported,
    /// There was no file yet.
    Fresh,
    /// The file was used.
    Loaded {
        /// Its size in bytes, without the header.
        bytes: usize,
    },
    /// The file was not used, and will be replaced.
    Rejected {
        /// Why.
        reason: &'static str,
    },
}

/// Where a device's cache lies, and what it must be made for.
#[derive(Clone, Debug)]
pub(crate) struct CacheFile {
    path: PathBuf,
    key: String,
}

impl CacheFile {
    /// In `folder`, for the device, its driver's version and this program's version.
    pub fn new(folder: &Path, adapter: &wgpu::AdapterInfo) -> Option<Self> {
        let device_key = wgpu::util::pipeline_cache_key(adapter)?;
        Some(Self {
            path: folder.join(&device_key),
            key: format!(
                "{device_key} {} {} {} {}",
                adapter.name,
                adapter.driver,
                adapter.driver_info,
                env!("CARGO_PKG_VERSION")
            ),
        })
    }

    /// What watches the building of pipelines, in `folder`, and what it knows from earlier starts.
    pub fn canary(&self, folder: &Path) -> Option<(Canary, Skipped)> {
        Some(Canary::open(folder, self.path.file_name()?.to_str()?, &self.key))
    }

    /// The driver's data, if the file is whole and made for this device and driver.
    pub fn load(&self) -> (Option<Vec<u8>>, CacheStatus) {
        let Ok(bytes) = std::fs::read(&self.path) else {
            return (None, CacheStatus::Fresh);
        };
        match unpack(&bytes, &self.key) {
            Ok(data) => (Some(data.to_vec()), CacheStatus::Loaded { bytes: data.len() }),
            Err(reason) => (None, CacheStatus::Rejected { reason }),
        }
    }

    /// Replaces the file at once: to a temporary name first, which two programs never share.
    pub fn save(&self, data: &[u8]) -> std::io::Result<()> {
        static COUNT: AtomicU64 = AtomicU64::new(0);
        if let Some(folder) = self.path.parent() {
            std::fs::create_dir_all(folder)?;
        }
        let count = COUNT.fetch_add(1, Ordering::Relaxed);
        let temporary = self.path.with_extension(format!("{}.{count}.tmp", std::process::id()));
        let written = std::fs::File::create(&temporary)
            .and_then(|mut file| {
                file.write_all(&pack(data, &self.key))?;
                file.sync_all()
            })
            .and_then(|()| std::fs::rename(&temporary, &self.path));
        if written.is_err() {
            // The first error is the one to report; a left-over temporary file is only litter.
            let _ = std::fs::remove_file(&temporary);
        }
        written
    }
}

fn pack(data: &[u8], key: &str) -> Vec<u8> {
    let mut file = Vec::with_capacity(data.len() + key.len() + 64);
    file.extend_from_slice(MAGIC);
    file.extend_from_slice(&(key.len() as u64).to_le_bytes());
    file.extend_from_slice(&(data.len() as u64).to_le_bytes());
    file.extend_from_slice(&hash(key.as_bytes(), data).to_le_bytes());
    file.extend_from_slice(key.as_bytes());
    file.extend_from_slice(data);
    file
}

fn unpack<'a>(file: &'a [u8], key: &str) -> Result<&'a [u8], &'static str> {
    let rest = file.strip_prefix(MAGIC).ok_or("it is no cache of this version")?;
    let (key_len, rest) = number(rest)?;
    let (data_len, rest) = number(rest)?;
    let (stored_hash, rest) = number(rest)?;
    let has = rest.len() as u64;
    if key_len.checked_add(data_len) != Some(has) {
        return Err("it is cut off");
    }
    let (stored_key, data) = rest.split_at(key_len as usize);
    if hash(stored_key, data) != stored_hash {
        return Err("its content is damaged");
    }
    if stored_key != key.as_bytes() {
        return Err("it was made by another driver, device or version");
    }
    Ok(data)
}

fn number(bytes: &[u8]) -> Result<(u64, &[u8]), &'static str> {
    let (number, rest) = bytes.split_first_chunk::<8>().ok_or("it is cut off")?;
    Ok((u64::from_le_bytes(*number), rest))
}

fn hash(key: &[u8], data: &[u8]) -> u64 {
    // Not stable across Rust versions, which only costs one rebuild of the cache.
    let mut hasher = DefaultHasher::new();
    hasher.write(key);
    hasher.write(data);
    hasher.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_packed_comes_back() {
        let data: Vec<u8> = (0..=255).collect();
        assert_eq!(unpack(&pack(&data, "key"), "key"), Ok(data.as_slice()));
        assert_eq!(unpack(&pack(&[], "key"), "key"), Ok([].as_slice()));
    }

    #[test]
    fn any_cut_and_any_flipped_byte_is_noticed() {
        let file = pack(b"what the driver compiled", "a device");
        for len in 0..file.len() {
            assert!(unpack(&file[..len], "a device").is_err(), "cut at {len}");
        }
        for index in 0..file.len() {
            let mut damaged = file.clone();
            damaged[index] ^= 0x20;
            assert!(unpack(&damaged, "a device").is_err(), "byte {index}");
        }
        assert!(unpack(&file, "another device").is_err());
    }
}
