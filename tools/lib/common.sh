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

# rustup's own folder is on the PATH only of shells started after its installation.
if ! command -v cargo >/dev/null && [ -x "${CARGO_HOME:-$HOME/.cargo}/bin/cargo" ]; then
    PATH="${CARGO_HOME:-$HOME/.cargo}/bin:$PATH"
    export PATH
fi

# Without a desktop session, Mesa's layer that picks a device by the screen only prints errors.
[ -n "${XDG_RUNTIME_DIR:-}" ] || export NODEVICE_SELECT=1
