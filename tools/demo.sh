#!/usr/bin/env bash
# Builds the command `swivel` and shows it at work on a clip that the build generates: twist and swing of each joint.
# Installs what is missing on Debian 12, as root or with sudo.
#
# usage: tools/demo.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=build/demo
source tools/step.sh

# That of this machine, and the baseline.
best_isa() {
    if grep -qm 1 avx512bw /proc/cpuinfo; then
        echo avx512
    elif grep -qm 1 avx2 /proc/cpuinfo; then
        echo avx2
    fi
}

compile() {
    cmake -S . -B $build -G Ninja -DCMAKE_BUILD_TYPE=Release -DSWIVEL_BUILD_TESTS=OFF -DSWIVEL_ISAS="$isa" &&
        cmake --build $build --parallel --target swivel_command make_sample_clip
}

isa=$(best_isa)
tools/install_packages.sh build || { echo "demo.sh: packages are missing"; exit 1; }
step build compile
step sample $build/tools/sample_clip/make_sample_clip $build/sample.bvh
echo
$build/tools/swivel/swivel decompose $build/sample.bvh
