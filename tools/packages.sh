#!/usr/bin/env bash
# Installs the Debian packages that building and testing Carrel takes. Does nothing when all are there.
#   tools/packages.sh [--dry-run] [PACKAGE...]      --dry-run: only says what is missing; exit 0 either way
#   PACKAGE: what a further task needs besides, such as clang-format
set -euo pipefail

dry_run=
if [[ ${1:-} == --dry-run ]]; then
    dry_run=1
    shift
fi

packages=(
    g++ make cmake ninja-build pkg-config
    libeigen3-dev     # vectors
    libbullet-dev     # instruments; the double precision build, bullet-float64
    libassimp-dev     # meshes
    libosmesa6-dev    # pictures without a display
    libpng-dev        # pictures as files
    libsdl2-dev libimgui-dev libgl1 libgl1-mesa-dri fonts-dejavu-core  # the window
    xvfb xauth xdotool x11-utils                                       # a display for its tests
    nlohmann-json3-dev libcli11-dev libsqlite3-dev libzstd-dev
    libssl-dev        # SHA-256
    libgtest-dev libbenchmark-dev
    git python3       # tools/lint and its tests
    "$@"
)

if ! command -v apt-get > /dev/null; then
    echo "packages: not a Debian system; please install the equivalents of: ${packages[*]}" >&2
    exit 0
fi

missing=()
installed=$(dpkg-query -W -f '${db:Status-Status} ${Package}\n' "${packages[@]}" 2> /dev/null || true)
for package in "${packages[@]}"; do
    grep -qxF "installed $package" <<< "$installed" || missing+=("$package")
done
((${#missing[@]})) || exit 0

if [[ $dry_run ]]; then
    echo "packages: would install ${missing[*]}"
    exit 0
fi

as_root=()
if ((EUID != 0)); then
    if ! command -v sudo > /dev/null || ! { [[ -t 0 ]] || sudo -n true 2> /dev/null; }; then
        echo "packages: neither root nor sudo; ask for: apt-get install ${missing[*]}" >&2
        exit 1
    fi
    as_root=(sudo)
fi

log=$(mktemp)
trap 'rm -f "$log"' EXIT
root() { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive "$@" >> "$log" 2>&1; }
install() { root apt-get install -y -q --no-install-recommends "${missing[@]}"; }

echo "packages: installing ${missing[*]}"
# Fails when the package lists are absent or too old; only then are new ones worth fetching.
if ! install && ! { root apt-get update -q && install; }; then
    cat "$log" >&2
    echo "packages: could not install ${missing[*]}; what apt-get said is above" >&2
    exit 1
fi
