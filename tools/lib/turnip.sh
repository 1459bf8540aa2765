# Mesa's Turnip, the open Vulkan driver for Adreno 6xx and 7xx, with its no-op DRM shim: it compiles for the real chip
# on any x86 machine, and executes nothing. Sourced after apt.sh. Debian builds Turnip for arm alone, so it is built
# here out of Debian's source: about 3 minutes on two cores.

turnip_version=25.0.7

# fetch_mesa FOLDER: unpacks Mesa's sources to FOLDER/source.
fetch_mesa() {
    local folder=$1 mirror line=
    [ ! -s "$folder/source/meson.build" ] || return 0
    rm -rf "$folder/source" "$folder/lists"
    mkdir -p "$folder/source" "$folder/lists/partial"
    line=$(backports_line) || return 1
    # Sources alone, in lists of their own: the machine's stay as they are.
    printf '%s\n' "${line/#deb /deb-src }" >"$folder/sources.list"
    local options=(-o "Dir::Etc::SourceList=$folder/sources.list" -o Dir::Etc::SourceParts=- -o APT::Sandbox::User=root
        -o "Dir::State::Lists=$folder/lists" -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache=)
    say "fetching Mesa's sources from bookworm-backports"
    quietly apt-get -q "${options[@]}" update || return 1
    # The Debian tarball may be missing, and is not needed.
    (cd "$folder" && apt-get -q "${options[@]}" source --download-only "mesa=$turnip_version*" ||
        apt-get -q "${options[@]}" source --download-only mesa) >"$folder/fetch.log" 2>&1 || true
    local archive
    archive=$(find "$folder" -maxdepth 1 -name 'mesa_*.orig.tar.*' ! -name '*.asc' -print -quit)
    [ -n "$archive" ] || { tail -n 5 "$folder/fetch.log" >&2; return 1; }
    tar -x -f "$archive" -C "$folder/source" --strip-components=1
    rm -f "$archive"
}

# build_turnip FOLDER: makes FOLDER/icd.json and FOLDER/shim.so, unless they are there.
build_turnip() {
    local folder=$1
    [ ! -s "$folder/icd.json" ] || [ ! -s "$folder/shim.so" ] || return 0
    mkdir -p "$folder"
    local packages=() program
    for program in bison flex glslangValidator:glslang-tools ninja:ninja-build g++ pkg-config xz:xz-utils; do
        command -v "${program%%:*}" >/dev/null || packages+=("${program##*:}")
    done
    [ ${#packages[@]} -eq 0 ] || apt_install "to build Mesa" "${packages[@]}"
    if ! pkg-config --exists libdrm; then
        # In the version of the libdrm2 that is there, which may be a backport.
        apt_install_from_backports libdrm-dev || apt_install "to build Mesa" libdrm-dev
    fi
    fetch_mesa "$folder" || die "Mesa's sources could not be fetched: tools/adreno needs Debian 12's bookworm-backports"
    [ -x "$folder/python/bin/meson" ] || {
        python3 -m venv "$folder/python"
        quietly "$folder/python/bin/pip" install -q meson==1.7.2 mako packaging pyyaml setuptools blake3 ||
            die "pip could not install meson, mako, packaging, pyyaml and blake3"
    }
    say "building Turnip (minutes)"
    local build=$folder/build PATH=$folder/python/bin:$PATH
    [ -s "$build/build.ninja" ] || quietly nice -n 10 meson setup "$build" "$folder/source" \
        -Dvulkan-drivers=freedreno -Dfreedreno-kmds=msm -Dtools=drm-shim -Dplatforms= -Dgallium-drivers= \
        -Dllvm=disabled -Dzstd=disabled -Dexpat=disabled -Dxmlconfig=disabled -Dbuildtype=release -Dglx=disabled \
        -Degl=disabled -Dgbm=disabled -Dopengl=false -Dgles1=disabled -Dgles2=disabled ||
        die "meson could not set Mesa up"
    # The shim says how far the chip has come by leaving the number as it finds it: nobody who waits for it would go on.
    local shim=$folder/source/src/drm-shim/device.c
    grep -q all_done "$shim" || sed -i \
        -e '/^ioctl_fn_t core_ioctls/i static int all_done(int fd, unsigned long request, void *arg) {\n   struct drm_syncobj_timeline_array *of = arg;\n   for (unsigned i = 0; i < of->count_handles; ++i)\n      ((uint64_t *)(uintptr_t)of->points)[i] = UINT64_MAX / 2;\n   return 0;\n}\n' \
        -e 's/\(_IOC_NR(DRM_IOCTL_SYNCOBJ_QUERY)\] = \)drm_shim_ioctl_stub/\1all_done/' "$shim"
    quietly nice -n 10 ninja -C "$build" src/freedreno/vulkan/libvulkan_freedreno.so \
        src/freedreno/drm-shim/libfreedreno_noop_drm_shim.so || die "Turnip could not be built"
    cp "$build/src/freedreno/drm-shim/libfreedreno_noop_drm_shim.so" "$folder/shim.so"
    cp "$build/src/freedreno/vulkan/libvulkan_freedreno.so" "$folder/driver.so"
    printf '{"file_format_version":"1.0.0","ICD":{"library_path":"%s","api_version":"1.3.0"}}\n' \
        "$folder/driver.so" >"$folder/icd.json"
}
