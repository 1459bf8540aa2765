//! Hashes that say whether what is committed still belongs to its source.

use sha2::{Digest, Sha256};

use crate::flags::FLAGS;

/// Raised when the same source is to give other files than before.
const FORMAT: &str = "brooklet shaders 2";

/// Bytes in hex.
pub fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// SHA-256 of bytes, in hex.
pub fn of_bytes(bytes: &[u8]) -> String {
    hex(&Sha256::digest(bytes))
}

/// SHA-256 of everything a module comes from: compiler, flags, profile, entry point, defines and
/// flattened source.
pub fn of_module(compiler: &str, profile: &str, entry: &str, defines: &[String], flattened: &str) -> String {
    let mut hasher = Sha256::new();
    let mut part = |text: &str| {
        // With its length, so that no two lists of parts read alike.
        hasher.update((text.len() as u64).to_le_bytes());
        hasher.update(text.as_bytes());
    };
    part(FORMAT);
    part(compiler);
    FLAGS.iter().for_each(|flag| part(flag));
    part(profile);
    part(entry);
    part(&defines.len().to_string());
    defines.iter().for_each(|define| part(define));
    part(flattened);
    hex(&hasher.finalize())
}
