#!/usr/bin/env bash
# Installs the Debian 12 packages of the named groups that are missing, as root or with sudo. Says nothing and asks
# no network when none is.
#
# usage: install_packages.sh GROUP...   groups: build test matrix bench
set -euo pipefail

declare -A groups=(
    [build]="cmake ninja-build g++ libxsimd-dev libcli11-dev"
    [test]="libgtest-dev nlohmann-json3-dev pkg-config python3"
    [matrix]="clang libclang-rt-14-dev clang-format clang-tidy qemu-user g++-aarch64-linux-gnu"
    [bench]="libbenchmark-dev libeigen3-dev libglm-dev"
)

fail() {
    echo "install_packages.sh: $1" >&2
    exit 1
}

missing=()
for group in "$@"; do
    for package in ${groups[$group]?unknown group}; do
        [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || missing+=("$package")
    done
done
((${#missing[@]})) || exit 0

as_root=(env DEBIAN_FRONTEND=noninteractive)
if ((EUID != 0)); then
    command -v sudo >/dev/null || fail "neither root nor sudo; install by hand: ${missing[*]}"
    as_root=(sudo "${as_root[@]}")
fi

echo "installing ${missing[*]}"
log=$(mktemp)
# A failed update may concern a source that is not needed here; what counts is the installation.
"${as_root[@]}" apt-get update >"$log" 2>&1 || true
"${as_root[@]}" apt-get install -y --no-install-recommends "${missing[@]}" >>"$log" 2>&1 </dev/null || {
    tail -n 20 "$log" >&2
    fail "apt-get could not install ${missing[*]}, see $log"
}
rm -f "$log"
