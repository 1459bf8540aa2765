//! A disk that is full: of the program's files alone, whatever else it and its driver write.
//!
//! A limit on the length of files (`ulimit -f`) is not that: Mesa 25's CPU driver keeps its memory in a file that
//! has no name, which then cannot grow, and the program dies of it before it has a device.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::OnceLock;

use crate::program::{Ended, Workshop, program};

/// Where the small disk is, in the workshop.
pub const DISK: &str = "disk";
/// What was on it at the end.
pub const KEPT: &str = "kept";
/// A page: a file takes whole ones.
const BLOCK_KIB: u32 = 4;

/// What makes it full.
#[derive(Clone, Copy, Debug)]
pub enum FullDisk {
    /// A file system in memory of so many kilobytes, in a mount namespace of the program's own.
    Mounted,
    /// A library before the C library, whose `write` says that the disk is full.
    Interposed,
}

/// The ways there are on this machine: a namespace needs root or the kernel's leave, which containers often lack.
pub fn full_disks() -> Vec<FullDisk> {
    static CAN_MOUNT: OnceLock<bool> = OnceLock::new();
    let can_mount = *CAN_MOUNT.get_or_init(|| {
        let shop = Workshop::new();
        std::fs::create_dir(shop.path(DISK)).expect("a folder");
        let tried = mounting(BLOCK_KIB, "true").current_dir(shop.path("")).stderr(Stdio::null()).status();
        let can_mount = tried.is_ok_and(|status| status.success());
        if !can_mount {
            println!("no file system can be mounted here: the disk is full by interposition alone");
        }
        can_mount
    });
    if can_mount { vec![FullDisk::Mounted, FullDisk::Interposed] } else { vec![FullDisk::Interposed] }
}

/// A shell that mounts a disk of `kib` and runs `then`.
fn mounting(kib: u32, then: &str) -> Command {
    let mut command = Command::new("unshare");
    command.args(["--map-root-user", "--mount", "sh", "-c"]);
    command.arg(format!("mount -t tmpfs -o size={kib}k tmpfs {DISK} || exit 99; {then}"));
    command
}

/// Runs the program in the workshop, where `disk` has room for `kib` and no more; what is on it at the end is in
/// `kept`.
pub fn run_on(disk: FullDisk, shop: &Workshop, kib: u32, arguments: &[&str]) -> Ended {
    for folder in [DISK, KEPT] {
        std::fs::create_dir(shop.path(folder)).expect("a folder");
    }
    let mut command = match disk {
        FullDisk::Mounted => {
            // A size of 0 would be no limit: a file of one block takes it.
            let script = format!(
                "head -c {} /dev/zero >{DISK}/filler; \"$0\" \"$@\"; code=$?; rm {DISK}/filler; cp -r {DISK}/. {KEPT}; \
                 exit $code",
                1024 * BLOCK_KIB
            );
            let mut command = mounting(kib + BLOCK_KIB, &script);
            command.arg(program());
            command
        }
        FullDisk::Interposed => {
            let script =
                format!("LD_PRELOAD={} \"$0\" \"$@\"; code=$?; cp -r {DISK}/. {KEPT}; exit $code", shim().display());
            let mut command = Command::new("sh");
            command.arg("-c").arg(script).arg(program());
            command.env("FULL_DISK_PATH", shop.path(DISK).canonicalize().expect("it is there"));
            command.env("FULL_DISK_BYTES", (1024 * kib).to_string());
            command
        }
    };
    command.args(arguments).current_dir(shop.path("")).env("XDG_RUNTIME_DIR", shop.path(""));
    command.env_remove("BROOKLET_VALIDATION");
    let ended = Ended::new(command.output().expect("a shell"));
    assert_ne!(ended.code, Some(99), "{disk:?}: {}", ended.stderr);
    ended
}

/// The library, built once by the compiler that builds the tests.
fn shim() -> &'static Path {
    static PATH: OnceLock<PathBuf> = OnceLock::new();
    PATH.get_or_init(|| {
        let path = program().with_file_name(format!("full_disk_{}.so", std::process::id()));
        let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/full_disk/interposed.rs");
        let built = Command::new("rustc")
            .args(["--edition", "2024", "--crate-type", "cdylib", "-C", "panic=abort", "-O", "-o"])
            .args([&path, &source])
            .output()
            .expect("rustc");
        assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
        path
    })
}
