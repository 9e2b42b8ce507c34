#!/usr/bin/env bash
# The steps of `tools/test.sh --matrix [STEP]` and `--nightly [STEP]`: all, or those whose name contains STEP. Every
# step is run; the failed ones are listed at the end. What each covers: docs/testing.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=build/matrix
source tools/step.sh
start=$SECONDS
which=$1
only=${2-}
passed=0
failed=()

check() { # NAME COMMAND...
    [[ $1 == *"$only"* ]] || return 0
    if step "$@"; then ((++passed)); else failed+=("$1"); fi
}

compile() { # FOLDER CMAKE-OPTION...
    cmake -S . -B "$build/$1" -G Ninja -DSWIVEL_WERROR=ON -DCMAKE_EXPORT_COMPILE_COMMANDS=ON "${@:2}" &&
        cmake --build "$build/$1" --parallel
}

# Repetition in the large: the g++ build runs it on the same kernels.
large="ManyBlocks|AtEveryLanePosition"
# What runs no kernel, and so the same code on every processor.
no_kernel="^Bvh|^Clip|^ComposeArcs|^Reflect"

compile_and_test() { # FOLDER TESTS-LEFT-OUT CMAKE-OPTION...
    compile "$1" "${@:3}" &&
        ctest --test-dir "$build/$1" --parallel "$(nproc)" --output-on-failure --no-tests=error --exclude-regex "$2"
}

format() { find include src kernels operations tests bench tools -name '*.[ch]pp' -exec clang-format --dry-run -Werror {} +; }

# Kernels once, as the source files of one ISA.
tidy() {
    run-clang-tidy -quiet -p $build/clang -j "$(nproc)" "$PWD/(src|tools|operations)/.*" "$PWD/$build/clang/kernels/.*avx512.*"
}

# An old processor: no illegal instruction, and the ISA that it can run is chosen. What does not depend on the ISA,
# the files of clips, is left out.
processor() { # CPU ISA TESTS
    local run="qemu-x86_64 -cpu $1" shards shard pids=() status=0
    $run build/test/tools/swivel/swivel info >$build/info.txt || return
    cat $build/info.txt
    grep -qE "^isa in use: +$2\$" $build/info.txt || { echo "the ISA in use is not $2" && return 1; }
    shards=$(nproc)
    for ((shard = 0; shard < shards; shard++)); do
        GTEST_TOTAL_SHARDS=$shards GTEST_SHARD_INDEX=$shard \
            $run build/test/tests/swivel_tests --gtest_brief=1 --gtest_filter="$3" &
        pids+=($!)
    done
    for shard in "${pids[@]}"; do wait "$shard" || status=1; done
    return $status
}

newer_xsimd() { # SUITE
    tools/newer_xsimd.sh "$1" $build/xsimd_"$1" &&
        cmake -S . -B $build/with_xsimd_"$1" -G Ninja -DCMAKE_BUILD_TYPE=Release -DSWIVEL_WERROR=ON \
            -DSWIVEL_BUILD_TOOLS=OFF -DSWIVEL_ISAS="avx2;avx512" \
            -DSWIVEL_XSIMD_INCLUDE_DIR="$PWD/$build/xsimd_$1/usr/include" &&
        cmake --build $build/with_xsimd_"$1" --parallel --target swivel_kernel_tests &&
        $build/with_xsimd_"$1"/tests/swivel_kernel_tests --gtest_brief=1 &&
        grep -hE '#define XSIMD_VERSION_M' $build/xsimd_"$1"/usr/include/xsimd/config/xsimd_config.hpp
}

fuzz() { # SECONDS
    mkdir -p $build/corpus &&
        $build/clang/tests/fuzz/bvh_fuzz -max_total_time="$1" -timeout=10 -print_final_stats=1 \
            -artifact_prefix=$build/ $build/corpus tests/fuzz/corpus
}

clang_options=(-DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Release -DSWIVEL_BUILD_FUZZ=ON
    -DCMAKE_CXX_FLAGS_RELEASE="-gline-tables-only -O1 -fno-omit-frame-pointer")
sanitizers="address,undefined"
best_isa() { grep -qm 1 avx512bw /proc/cpuinfo && echo avx512 || echo avx2; }
aarch64_options=(-DCMAKE_TOOLCHAIN_FILE=tools/cmake/aarch64.cmake -DSWIVEL_BUILD_TOOLS=OFF
    -DSWIVEL_GTEST_SOURCE_DIR=/usr/src/googletest)
# One test of every operation suffices where the kernels are those of another step.
brief="*EveryOperation.ReproducibleHasTheBitsOfReferenceFloat*:*EveryOperation.ReproducibleHasTheBitsOfReferenceDouble*"
brief+=":*Golden*:Isa.*"
# An emulator of guard pages it is not: qemu 7.2 wrongly reads the lanes that a masked load leaves out.
guard_pages="*TouchesNothingPastTheEnd*"

gate() {
    check "format" format
    # Its tests are those that tools/test.sh runs.
    check "g++ with the bench" compile ../test -DCMAKE_BUILD_TYPE=Release -DSWIVEL_BUILD_BENCH=ON
    check "every float" build/test/tests/swivel_exhaustive_tests
    # The kernels as they are shipped; sanitizers in everything else.
    check "clang and sanitizers" compile_and_test clang "$large" "${clang_options[@]}" -DSWIVEL_SANITIZE=$sanitizers
    check "clang-tidy" tidy
    check "fuzz BVH files for 60 s" fuzz 60
    check "x86-64 Conroe" processor Conroe sse2 "$brief"
    check "x86-64 Haswell" processor Haswell avx2 "$brief-*/sse2"
    check "x86-64 Haswell without XSAVE" processor Haswell,-xsave sse2 "Isa.*:*Golden*"
    check "aarch64" compile_and_test aarch64 "$large|$no_kernel|Consumer|FromManyThreads" "${aarch64_options[@]}"
    check "xsimd of Debian 13" newer_xsimd trixie
}

# What the gate has no time for.
nightly() {
    check "kernels with sanitizers" compile_and_test kernels_with_sanitizers "^$" "${clang_options[@]}" \
        -DCMAKE_CXX_FLAGS="-fsanitize=$sanitizers -fno-sanitize-recover=all" -DSWIVEL_ISAS="$(best_isa)"
    check "clang" compile_and_test clang_release "^$" -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Release
    check "x86-64 Nehalem, all tests" processor Nehalem sse2 "*-Bvh*:Clip*:$guard_pages"
    check "x86-64 Haswell, all tests" processor Haswell avx2 "*-Bvh*:Clip*:*/sse2:$guard_pages"
    check "aarch64, all tests" compile_and_test aarch64 "^$" "${aarch64_options[@]}"
    check "clang and sanitizers" compile_and_test clang "$large" "${clang_options[@]}" -DSWIVEL_SANITIZE=$sanitizers
    check "fuzz BVH files for 20 min" fuzz 1200
}

tools/install_packages.sh build test matrix bench || { echo "test.sh: packages are missing"; exit 1; }
"$which"

((passed + ${#failed[@]})) || { echo "test.sh: no step of that name"; exit 2; }
printf '\n%d min %02d s\n' $(((SECONDS - start) / 60)) $(((SECONDS - start) % 60))
((${#failed[@]} == 0)) || printf 'test.sh: failed: %s\n' "${failed[@]}"
echo "$passed passed, ${#failed[@]} failed"
((${#failed[@]} == 0))
