# Building the phone's library and package. Sourced after apt.sh, in the repository's root.
#
# With an NDK (ANDROID_NDK_HOME) its compiler links. Without one rustc's own rust-lld does: what the library takes from
# Android is linked against stubs made of lists of names (mobile/android/ndk-api26), so that a name which is on none of
# them, because Android 8 has it not, ends the build.

android=$root/mobile/android
android_triple=aarch64-linux-android
# Where Debian's libc6-dev-arm64-cross and android-framework-res put things.
arm64_libraries=/usr/aarch64-linux-gnu/lib
debian_framework=/usr/share/android-framework-res/framework-res.apk
# SDK's folders that Android Studio's users have, newest last.
sdk=${ANDROID_HOME:-${ANDROID_SDK_ROOT:-}}

# android_property NAME: one of mobile/android/android.properties.
android_property() { sed -n "s/^$1=//p" "$android/android.properties"; }

ensure_android_target() {
    [ ! -d "$(rustc --print sysroot)/lib/rustlib/$android_triple" ] || return 0
    command -v rustup >/dev/null || die "Rust's target $android_triple is needed: install it beside your Rust"
    say "adding Rust's target $android_triple"
    quietly rustup target add "$android_triple" || die "rustup could not add the target $android_triple"
}

# Puts the newest build tools of an SDK on the PATH; what is missing then comes from Debian's packages.
ensure_package_tools() {
    local packages=() tools
    if [ -n "$sdk" ]; then
        tools=$(find "$sdk/build-tools" -mindepth 1 -maxdepth 1 -type d 2>/dev/null | sort -V | tail -n 1)
        [ -z "$tools" ] || PATH=$tools:$PATH
    fi
    command -v aapt2 >/dev/null || packages+=(aapt)
    command -v zipalign >/dev/null || packages+=(zipalign)
    command -v apksigner >/dev/null || packages+=(apksigner)
    command -v keytool >/dev/null || packages+=(default-jre-headless)
    command -v zip >/dev/null || packages+=(zip)
    [ -n "$(android_framework)" ] || packages+=(android-framework-res)
    [ ${#packages[@]} -eq 0 ] || apt_install "to package the phone's app" "${packages[@]}"
}

ensure_emulator() {
    local packages=()
    command -v qemu-aarch64-static >/dev/null || packages+=(qemu-user-static)
    [ -e "$arm64_libraries/libc.so.6" ] || packages+=(libc6-dev-arm64-cross)
    [ ${#packages[@]} -eq 0 ] || apt_install "to run the phone's library" "${packages[@]}"
}

# Android's own resources, that the manifest's attributes are looked up in. Nothing if there are none.
android_framework() {
    local jar=''
    [ -z "$sdk" ] || jar=$(find "$sdk/platforms" -name android.jar 2>/dev/null | sort -V | tail -n 1)
    [ -n "$jar" ] || [ ! -e "$debian_framework" ] || jar=$debian_framework
    printf '%s' "$jar"
}

rust_lld() { printf '%s/lib/rustlib/%s/bin/rust-lld' "$(rustc --print sysroot)" "$(rustc -vV | sed -n 's/^host: //p')"; }

# arm64_object SOURCE OBJECT: one Rust file without the standard library.
arm64_object() {
    quietly rustc --edition 2024 --target "$android_triple" --crate-type lib --crate-name "$(basename "$2" .o)" \
        -C panic=abort -C opt-level=1 --emit obj -o "$2" "$1" || die "rustc could not compile $1"
}

# make_stubs FOLDER: a library for each list of names, with nothing but the names.
make_stubs() {
    local folder=$1 list library
    rm -rf "$folder"
    mkdir -p "$folder"
    for list in "$android"/ndk-api26/*.txt; do
        library=lib$(basename "$list" .txt)
        {
            echo '#![no_std]'
            echo 'core::arch::global_asm!(".data",'
            sed 's/.*/    ".globl &", "&:",/' "$list"
            echo '    ".quad 0");'
        } >"$folder/$library.rs"
        arm64_object "$folder/$library.rs" "$folder/$library.o"
        "$(rust_lld)" -flavor gnu -shared -soname "$library.so" -o "$folder/$library.so" "$folder/$library.o" ||
            die "rust-lld could not link $library.so"
    done
    # The standard library asks for it; the crate unwinding has its functions.
    printf '!<arch>\n' >"$folder/libunwind.a"
}

# link_by_ndk: exports what Cargo links with. Sets `features`.
link_by_ndk() {
    local clang
    clang=$(find "$ANDROID_NDK_HOME/toolchains/llvm/prebuilt" -name "$android_triple$(android_property minSdk)-clang" \
        2>/dev/null | head -n 1)
    [ -n "$clang" ] ||
        die "ANDROID_NDK_HOME is '$ANDROID_NDK_HOME', and there is no $android_triple$(android_property minSdk)-clang in it: NDK r28 or newer is needed"
    say "linking with the NDK: $clang"
    features=()
    export CARGO_TARGET_AARCH64_LINUX_ANDROID_LINKER=$clang
    export CARGO_TARGET_AARCH64_LINUX_ANDROID_RUSTFLAGS="-Clink-arg=-Wl,-z,max-page-size=16384"
}

# link_without_ndk STUBS: as above.
link_without_ndk() {
    make_stubs "$1"
    features=(--features no-ndk)
    export CARGO_TARGET_AARCH64_LINUX_ANDROID_LINKER=rust-lld
    export CARGO_TARGET_AARCH64_LINUX_ANDROID_RUSTFLAGS="-Clinker-flavor=ld.lld -Lnative=$1 -Clink-arg=--no-undefined \
-Clink-arg=-zmax-page-size=16384 -Clink-arg=--hash-style=gnu -Clink-arg=--icf=all -Clink-arg=-O2"
}

# make_package LIBRARY FOLDER: FOLDER/brooklet.apk, signed with a key of this machine's own and aligned.
make_package() {
    local library=$1 folder=$2 key=$target/android/debug.keystore version
    version=$(sed -n 's/^version = "\(.*\)"/\1/p' "$root/Cargo.toml" | head -n 1)
    mkdir -p "$folder/lib/arm64-v8a"
    cp "$library" "$folder/lib/arm64-v8a/libbrooklet.so"
    sed "s/<manifest /&package=\"$(android_property applicationId)\" /" "$android/AndroidManifest.xml" \
        >"$folder/AndroidManifest.xml"
    rm -f "$folder"/*.apk
    # 1.2.3 is version code 10203.
    quietly aapt2 link -I "$(android_framework)" --manifest "$folder/AndroidManifest.xml" \
        --min-sdk-version "$(android_property minSdk)" --target-sdk-version "$(android_property targetSdk)" \
        --version-name "$version" --version-code "$(awk -F. '{ print $1 * 10000 + $2 * 100 + $3 }' <<<"$version")" \
        -o "$folder/bare.apk" || die "aapt2 could not make the package"
    # Stored as it is, so that Android maps it from the package.
    (cd "$folder" && quietly zip -q -0 -X bare.apk lib/arm64-v8a/libbrooklet.so) || die "zip could not add the library"
    quietly zipalign -f 16384 "$folder/bare.apk" "$folder/brooklet.apk" || die "zipalign could not align the package"
    [ -e "$key" ] || quietly keytool -genkeypair -keystore "$key" -alias debug -storepass android -keypass android \
        -keyalg RSA -keysize 2048 -validity 10000 -dname CN=Debug || die "keytool could not make a key"
    quietly apksigner sign --ks "$key" --ks-pass pass:android "$folder/brooklet.apk" ||
        die "apksigner could not sign the package"
    rm -f "$folder/bare.apk" "$folder/brooklet.apk.idsig"
}

# make_emulator FOLDER: the program that loads the library and runs its self-test, beside Android's libraries as far as
# that needs them: they pass on to glibc. Of libandroid there are the names alone.
make_emulator() {
    local folder=$1 lld part
    lld=$(rust_lld)
    mkdir -p "$folder"
    for part in libc liblog run; do
        arm64_object "$android/emulator/$part.rs" "$folder/$part.o"
    done
    make_stubs "$folder/stubs"
    cp "$folder/stubs/libandroid.so" "$folder/"
    "$lld" -flavor gnu -shared -soname libc.so -o "$folder/libc.so" "$folder/libc.o" "$arm64_libraries/libc.so.6" &&
        "$lld" -flavor gnu -shared -soname libm.so -o "$folder/libm.so" "$arm64_libraries/libm.so.6" &&
        "$lld" -flavor gnu -shared -soname libdl.so -o "$folder/libdl.so" "$arm64_libraries/libc.so.6" &&
        "$lld" -flavor gnu -shared -soname liblog.so -o "$folder/liblog.so" "$folder/liblog.o" \
            "$arm64_libraries/libc.so.6" &&
        "$lld" -flavor gnu -dynamic-linker /lib/ld-linux-aarch64.so.1 -o "$folder/run" "$arm64_libraries/crt1.o" \
            "$arm64_libraries/crti.o" "$folder/run.o" "$arm64_libraries/libc.so.6" "$arm64_libraries/crtn.o" ||
        die "rust-lld could not link what runs the library's self-test"
}
