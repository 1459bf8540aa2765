# Shared by the scripts in tools/: where the repository is, and how they speak. Sourced, never run.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
name=$(basename "$0")

# One line for each thing done.
say() { printf '%s: %s\n' "$name" "$*"; }

# One clear message, and the exit code for "this machine cannot do it".
die() {
    printf '%s: error: %s\n' "$name" "$*" >&2
    exit 2
}

# Whether Vulkan's validation layers are where its loader looks for them.
validation_layers_installed() {
    local folder file
    for folder in /usr/share /usr/local/share /etc; do
        for file in "$folder"/vulkan/explicit_layer.d/*hronos_validation.json; do
            [ ! -e "$file" ] || return 0
        done
    done
    return 1
}

# rustup's own folder is on the PATH only of shells started after its installation.
if ! command -v cargo >/dev/null && [ -x "${CARGO_HOME:-$HOME/.cargo}/bin/cargo" ]; then
    PATH="${CARGO_HOME:-$HOME/.cargo}/bin:$PATH"
    export PATH
fi

# Without a desktop session, Mesa's layer that picks a device by the screen only prints errors.
[ -n "${XDG_RUNTIME_DIR:-}" ] || export NODEVICE_SELECT=1
