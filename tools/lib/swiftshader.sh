# SwiftShader, a Vulkan driver for the CPU with the limits of a small phone. Sourced after apt.sh.
#
# Debian ships it inside chromium-common. The package is unpacked, not installed, because its
# dependencies are hundreds of megabytes of a browser.

# fetch_swiftshader FOLDER: makes FOLDER/icd.json. Returns 1 where this system has no such package.
fetch_swiftshader() {
    local folder=$1 library
    [ ! -s "$folder/icd.json" ] || return 0
    [ "$(os_field ID)" = debian ] && command -v apt-get >/dev/null || return 1
    if ! apt-cache show chromium-common >/dev/null 2>&1; then
        apt_update_once
    fi
    say "fetching SwiftShader from Debian's chromium-common"
    rm -rf "$folder"
    mkdir -p "$folder"
    # A mirror may have replaced the version that older package lists name: then ask again.
    (cd "$folder" && quietly apt-get -q download chromium-common) ||
        { apt_update_once && (cd "$folder" && quietly apt-get -q download chromium-common); } || return 1
    dpkg-deb --fsys-tarfile "$folder"/chromium-common_*.deb |
        tar -x -C "$folder" --wildcards '*/libvk_swiftshader.so' '*/vk_swiftshader_icd.json' || return 1
    rm -f "$folder"/chromium-common_*.deb
    library=$(find "$folder" -name libvk_swiftshader.so -print -quit)
    sed "s#\"library_path\": *\"[^\"]*\"#\"library_path\": \"$library\"#" \
        "$(find "$folder" -name vk_swiftshader_icd.json -print -quit)" >"$folder/icd.json"
    grep -qF "$library" "$folder/icd.json"
}
