# Installing Debian and Ubuntu packages. Sourced after common.sh.

apt_updated=no
apt_scratch=

# Runs apt-get as root, without questions, waiting for another apt to finish.
apt_get() {
    local as_root=()
    [ "$(id -u)" -eq 0 ] || as_root=(sudo)
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get -q -o Dpkg::Use-Pty=0 -o DPkg::Lock::Timeout=300 "$@"
}

# Runs a command; its output is shown only where it fails.
quietly() {
    local log
    log=$(mktemp)
    if "$@" >"$log" 2>&1; then
        rm -f "$log"
        return 0
    fi
    tail -n 20 "$log" >&2
    rm -f "$log"
    return 1
}

# Package lists are fetched once, and only when something has to be installed. A source of the
# machine's own that does not answer is no reason to stop: the packages may come from another.
apt_update_once() {
    [ "$apt_updated" = no ] || return 0
    apt_updated=yes
    say "fetching the package lists"
    quietly apt_get update || say "not every package list could be fetched; going on with what is there"
}

# apt_install REASON PACKAGE...
apt_install() {
    local reason=$1
    shift
    if ! command -v apt-get >/dev/null; then
        die "$reason: this is neither Debian nor Ubuntu; install what they call '$*', then run this again"
    fi
    if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
        die "$reason: apt-get has to install $*, which needs root, and there is no sudo here: run it as root once"
    fi
    apt_update_once
    say "installing $* ($reason)"
    quietly apt_get install -y --no-install-recommends "$@" ||
        die "apt-get could not install: $* ($reason)"
}

os_field() { (. /etc/os-release 2>/dev/null && eval "printf '%s' \"\${$1:-}\""); }

# Prints an apt source line for bookworm-backports, on the mirror the machine already uses.
backports_line() {
    local mirror keyring=/usr/share/keyrings/debian-archive-keyring.gpg signed=
    mirror=$(apt-get indextargets --no-release-info --format '$(RELEASE) $(COMPONENT) $(REPO_URI)' \
        'Created-By: Packages' 2>/dev/null | awk '$1 == "bookworm" && $2 == "main" { print $3; exit }')
    [ -n "$mirror" ] || return 1
    [ -r "$keyring" ] && signed="[signed-by=$keyring] "
    printf 'deb %s%s bookworm-backports main\n' "$signed" "$mirror"
}

# Installs packages from bookworm-backports without touching the machine's own sources or lists:
# both are copied to a folder that goes away afterwards.
apt_install_from_backports() {
    local line status=0
    line=$(backports_line) || return 1
    apt_scratch=$(mktemp -d)
    trap 'rm -rf "$apt_scratch"' EXIT
    mkdir -p "$apt_scratch/lists/partial"
    chmod -R a+rX "$apt_scratch"
    { cat /etc/apt/sources.list 2>/dev/null || true; printf '%s\n' "$line"; } >"$apt_scratch/sources.list"
    local options=(-o "Dir::Etc::SourceList=$apt_scratch/sources.list" -o "Dir::State::Lists=$apt_scratch/lists"
        -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache=)
    say "installing $* from bookworm-backports (1.5 times faster than Debian 12's own)"
    quietly apt_get "${options[@]}" update &&
        quietly apt_get "${options[@]}" install -y --no-install-recommends -t bookworm-backports "$@" ||
        { status=1 && say "that did not work; taking what this system has of its own"; }
    # apt wrote the lists as root.
    if [ "$(id -u)" -eq 0 ]; then rm -rf "$apt_scratch"; else sudo rm -rf "$apt_scratch"; fi
    return $status
}
