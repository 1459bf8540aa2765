//! Packs what `spirv/packs.txt` lists for [`Spirv::Packed`](src/spirv.rs): a line is a stream's name and its modules' files.

use std::path::{Path, PathBuf};

fn main() {
    let spirv = Path::new("spirv");
    println!("cargo::rerun-if-changed={}", spirv.display());
    let out = PathBuf::from(std::env::var_os("OUT_DIR").expect("Cargo sets OUT_DIR"));
    let list = read(&spirv.join("packs.txt"));
    for line in String::from_utf8(list).expect("packs.txt is text").lines() {
        let mut words = line.split(' ');
        let name = words.next().expect("a line has a name");
        let modules: Vec<u8> = words.flat_map(|file| read(&spirv.join(file))).collect();
        let packed = miniz_oxide::deflate::compress_to_vec(&modules, 9);
        std::fs::write(out.join(format!("{name}.deflate")), packed).expect("OUT_DIR can be written");
    }
}

fn read(path: &Path) -> Vec<u8> {
    std::fs::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}
