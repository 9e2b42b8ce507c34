#!/usr/bin/env bash
# Builds swivel and runs its tests. Installs what is missing on Debian 12, as root or with sudo.
#
# usage: tools/test.sh [CTEST-OPTION...]   with g++, optimised, warnings are errors
#        tools/test.sh --matrix [STEP]     with all other compilers, checkers, processors and releases of xsimd (or the
#                                          steps whose name contains STEP), after the tests with g++; lists at the end
#                                          what failed
#        tools/test.sh --nightly [STEP]    what takes hours: sanitizers in the kernels, whole suites under emulation,
#                                          long fuzzing; after the tests with g++ too
#
# What each step covers, and how long it takes: docs/testing.md.
#
#        tools/test.sh --help
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tools/step.sh

configure() { cmake -S . -B build/test -G Ninja -DCMAKE_BUILD_TYPE=Release -DSWIVEL_WERROR=ON; }

run_tests() {
    build=build/test
    tools/install_packages.sh build test || { echo "test.sh: packages are missing"; exit 1; }
    step configure configure
    step build cmake --build build/test --parallel
    step test ctest --test-dir build/test --parallel "$(nproc)" --output-on-failure --no-tests=error "$@"
}

case ${1-} in
    --help | -h) sed -n '2,/^set/{/^set/!s/^# \{0,1\}//p}' tools/test.sh ;;
    --matrix) exec tools/test_matrix.sh gate "${@:2}" ;;
    --nightly) exec tools/test_matrix.sh nightly "${@:2}" ;;
    *) run_tests "$@" ;;
esac
