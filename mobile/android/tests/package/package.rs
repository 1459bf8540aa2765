//! The package as it is installed.

use std::path::Path;
use std::process::Command;

use crate::{built, output};

fn aligned(package: &Path) -> Result<String, String> {
    output(Command::new("zipalign").args(["-c", "-v", "16384"]).arg(package))
}

fn signed(package: &Path) -> Result<String, String> {
    output(Command::new("apksigner").args(["verify", "--verbose"]).arg(package))
}

#[test]
fn the_package_is_aligned_and_signed() {
    let Some(folder) = built() else { return };
    let package = folder.join("brooklet.apk");
    let files = aligned(&package).unwrap();
    // Stored, not deflated: Android maps it from the package.
    let library = files.lines().find(|line| line.contains("lib/arm64-v8a/libbrooklet.so")).expect(&files);
    assert!(library.contains("(OK)") && !library.contains("compressed"), "{library}");
    let schemes = signed(&package).unwrap();
    assert!(schemes.contains("Verified using v2 scheme (APK Signature Scheme v2): true"), "{schemes}");

    // With a byte of the library changed the signature is another's; with a byte before it nothing is where it was.
    let mut bytes = std::fs::read(&package).unwrap();
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
    let wrong = folder.join("wrong.apk");
    std::fs::write(&wrong, &bytes).unwrap();
    let (changed, error) = (signed(&wrong), "apksigner takes a package whose library was changed");
    bytes[middle] ^= 1;
    bytes.insert(0, 0);
    std::fs::write(&wrong, &bytes).unwrap();
    let moved = aligned(&wrong);
    std::fs::remove_file(&wrong).unwrap();
    assert!(changed.is_err(), "{error}");
    assert!(moved.is_err(), "zipalign takes a package that is not aligned");
}
