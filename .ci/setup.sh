# Sourced by run.sh and test.sh: installs what is missing, one line a step. Works as root or with sudo on Debian 12.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
say() { printf '\033[1m==>\033[0m %s\n' "$*"; }
mkdir -p build

install_missing() {
    local missing=()
    local name
    while read -r name; do
        case "$name" in ''|'#'*) continue ;; esac
        dpkg-query -W -f='${Status}' "$name" 2>/dev/null | grep -q 'ok installed' || missing+=("$name")
    done < <(cat .ci/packages.txt; printf '%s\n' "$@")
    if [ ${#missing[@]} -eq 0 ]; then
        say "packages: all there"
        return
    fi
    say "packages: installing ${missing[*]}"
    local root=()
    if [ "$(id -u)" != 0 ]; then
        command -v sudo >/dev/null || { echo "These packages are missing and sudo is not there to install them: ${missing[*]}" >&2; exit 1; }
        root=(sudo)
    fi
    "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update -q >build/apt.log 2>&1 &&
        "${root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}" >>build/apt.log 2>&1 ||
        { tail -20 build/apt.log >&2; echo "The packages could not be installed; see build/apt.log" >&2; exit 1; }
}

configure() { # preset
    if [ ! -f "build/$1/build.ninja" ]; then
        say "configure: preset $1"
        cmake --preset "$1" >"build/configure-$1.log" 2>&1 || { tail -30 "build/configure-$1.log" >&2; exit 1; }
    fi
}

build() { # preset targets…
    local preset=$1
    shift
    say "build: preset $preset"
    # The compiler's memory in large pages: a tenth of its time where a virtual machine's host has a hand in every page.
    if ! GLIBC_TUNABLES=glibc.malloc.hugetlb=1 ninja -C "build/$preset" "$@" >"build/build-$preset.log" 2>&1; then
        grep -E 'error|FAILED|undefined' -A4 "build/build-$preset.log" | head -60 >&2
        echo "The build failed; see build/build-$preset.log" >&2
        exit 1
    fi
}
