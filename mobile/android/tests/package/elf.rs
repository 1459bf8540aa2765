//! The library as Android's linker reads it.

use std::collections::BTreeSet;

use object::elf::{DT_NEEDED, EM_AARCH64, ET_DYN, FileHeader64, PF_W, PF_X, PT_LOAD, SHN_UNDEF, SHT_DYNSYM, STB_WEAK};
use object::read::elf::{Dyn, FileHeader, ProgramHeader, Sym};
use object::{Endianness, Error};

use crate::{library, nothing, own};

/// Of the library of the tests, which is quick to build and larger than that for phones. More is a package too many.
const MOST_BYTES: usize = 30_000_000;
/// Devices with pages of 16 KiB load nothing that is aligned to less.
const PAGE: u64 = 16 << 10;
/// What Android loads the app by, and what the test under an emulator calls.
const ENTRIES: [&str; 4] =
    ["ANativeActivity_onCreate", "android_main", "brooklet_self_test", "brooklet_self_test_count"];
/// The NDK's libraries, each with the list of its names that API 26 has.
const LISTS: [(&str, &str); 5] = [
    ("libandroid.so", "ndk-api26/android.txt"),
    ("libc.so", "ndk-api26/c.txt"),
    ("libdl.so", "ndk-api26/dl.txt"),
    ("liblog.so", "ndk-api26/log.txt"),
    ("libm.so", "ndk-api26/m.txt"),
];

/// What matters of an ELF.
#[derive(Clone, Debug, Default)]
struct Elf {
    bytes: usize,
    machine: u16,
    kind: u16,
    needed: Vec<String>,
    exported: BTreeSet<String>,
    /// Names that others must have; a weak one may be missing.
    undefined: Vec<String>,
    /// Of the segments that are loaded.
    alignments: Vec<u64>,
    /// Segments that are written to and executed.
    writable_code: usize,
}

fn read(data: &[u8]) -> Result<Elf, Error> {
    let header = FileHeader64::<Endianness>::parse(data)?;
    let endian = header.endian()?;
    let mut elf =
        Elf { bytes: data.len(), machine: header.e_machine(endian).0, kind: header.e_type(endian).0, ..Elf::default() };
    for segment in header.program_headers(endian, data)? {
        if segment.p_type(endian) == PT_LOAD {
            elf.alignments.push(segment.p_align(endian));
            let flags = segment.p_flags(endian);
            elf.writable_code += usize::from(flags.0 & PF_W.0 != 0 && flags.0 & PF_X.0 != 0);
        }
    }
    let sections = header.sections(endian, data)?;
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    if let Some((entries, section)) = sections.dynamic(endian, data)? {
        let strings = sections.strings(endian, data, section)?;
        for entry in entries {
            if entry.d_tag(endian) == DT_NEEDED {
                elf.needed.push(text(entry.string(endian, strings)?));
            }
        }
    }
    let symbols = sections.symbols(endian, data, SHT_DYNSYM)?;
    for symbol in symbols.iter() {
        let name = text(symbol.name(endian, symbols.strings())?);
        if symbol.st_shndx(endian) != SHN_UNDEF {
            elf.exported.insert(name);
        } else if !name.is_empty() && symbol.st_bind() != STB_WEAK {
            elf.undefined.push(name);
        }
    }
    Ok(elf)
}

/// What would keep a phone of API 26 or later from loading it.
fn problems(elf: &Elf) -> Vec<String> {
    let mut wrong = Vec::new();
    if (elf.machine, elf.kind) != (EM_AARCH64.0, ET_DYN.0) {
        wrong.push(format!("machine {} and type {}: no library for 64-bit ARM", elf.machine, elf.kind));
    }
    if elf.bytes > MOST_BYTES {
        wrong.push(format!("{} bytes, {MOST_BYTES} are allowed", elf.bytes));
    }
    for entry in ENTRIES.iter().filter(|entry| !elf.exported.contains(**entry)) {
        wrong.push(format!("{entry} is not exported"));
    }
    let strange = |library: &&String| !LISTS.iter().any(|(name, _)| name == library);
    wrong.extend(elf.needed.iter().filter(strange).map(|library| format!("{library} is none of the NDK's libraries")));
    let linked = LISTS.iter().filter(|(name, _)| elf.needed.iter().any(|library| library == name));
    let names: BTreeSet<String> =
        linked.flat_map(|(_, list)| own(list).lines().map(String::from).collect::<Vec<_>>()).collect();
    let unknown = elf.undefined.iter().filter(|name| !names.contains(*name));
    wrong.extend(unknown.map(|name| format!("{name} is in no list of API 26 of a library that is linked")));
    if elf.alignments.is_empty() {
        wrong.push("no segment is loaded".into());
    }
    for alignment in elf.alignments.iter().filter(|alignment| **alignment == 0 || **alignment % PAGE != 0) {
        wrong.push(format!("a segment is aligned to {alignment}, {PAGE} are needed"));
    }
    if elf.writable_code > 0 {
        wrong.push("a segment is both written to and executed".into());
    }
    wrong
}

#[test]
fn a_phone_can_load_the_library() {
    let Some(library) = library() else { return };
    let elf = read(&std::fs::read(library).unwrap()).unwrap();
    println!("{} bytes; {} names of Android's; {:?}", elf.bytes, elf.undefined.len(), elf.needed);
    nothing(&problems(&elf));
}

/// The bytes of the library itself, each with one thing changed in place.
#[test]
fn a_library_with_one_thing_changed_is_refused() {
    let Some(library) = library() else { return };
    let good = std::fs::read(library).unwrap();
    let replaced = |from: &[u8], to: &[u8]| {
        let mut bytes = good.clone();
        let places: Vec<usize> = (0..bytes.len() - from.len()).filter(|at| bytes[*at..].starts_with(from)).collect();
        assert!(!places.is_empty(), "{:?} is not there", String::from_utf8_lossy(from));
        places.into_iter().for_each(|at| bytes[at..at + to.len()].copy_from_slice(to));
        bytes
    };
    let refused = |bytes: &[u8], reason: &str| {
        let wrong = problems(&read(bytes).unwrap());
        assert!(wrong.iter().any(|wrong| wrong.contains(reason)), "{reason:?} is not among {wrong:?}");
    };
    refused(&replaced(b"\0liblog.so\0", b"\0libxyz.so\0"), "libxyz.so is none");
    refused(&replaced(b"\0ANativeActivity_onCreate\0", b"\0ANativeActivity_onCrate_\0"), "onCreate is not exported");
    refused(&replaced(b"\0ALooper_pollOnce\0", b"\0ALooper_pollNone\0"), "ALooper_pollNone is in no list");
    // The machine stands in bytes 18 and 19: x86-64 is 62.
    let mut other_machine = good.clone();
    other_machine[18..20].copy_from_slice(&[62, 0]);
    refused(&other_machine, "no library for 64-bit ARM");
    // A program header is 56 bytes from byte 64 on; its type stands first, its alignment last.
    let mut narrow = good.clone();
    let load = (64..).step_by(56).find(|at| narrow[*at..*at + 4] == [1, 0, 0, 0]).unwrap();
    narrow[load + 48..load + 56].copy_from_slice(&4096_u64.to_le_bytes());
    refused(&narrow, "aligned to 4096");
    // Cut off and empty files are errors.
    assert!(read(&good[..good.len() / 2]).is_err());
    assert!(read(&[]).is_err());
}

#[test]
fn each_rule_refuses_what_breaks_it() {
    let good = Elf {
        bytes: 1000,
        machine: EM_AARCH64.0,
        kind: ET_DYN.0,
        needed: vec!["libc.so".into(), "libm.so".into()],
        exported: ENTRIES.map(String::from).into(),
        undefined: vec!["malloc".into(), "sin".into()],
        alignments: vec![PAGE, 4 * PAGE],
        writable_code: 0,
    };
    nothing(&problems(&good));
    let one = |change: fn(&mut Elf)| {
        let mut elf = good.clone();
        change(&mut elf);
        assert_eq!(problems(&elf).len(), 1, "{:?}", problems(&elf));
    };
    one(|elf| elf.machine = 62);
    one(|elf| elf.kind = 2);
    one(|elf| elf.bytes = MOST_BYTES + 1);
    one(|elf| elf.needed.push("libc++_shared.so".into()));
    one(|elf| assert!(elf.exported.remove("android_main")));
    // In Android 11's, not in 8's.
    one(|elf| elf.undefined.push("AThermal_acquireManager".into()));
    // In a list, of a library that is not linked.
    one(|elf| elf.undefined.push("ALooper_wake".into()));
    one(|elf| elf.alignments.push(4096));
    one(|elf| elf.alignments.clear());
    one(|elf| elf.writable_code = 1);
}
