#!/usr/bin/env bash
# The steps of `tools/test.sh --matrix [STEP]`: all, or those whose name contains STEP. Every step is run; the failed
# ones are listed at the end.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=build/matrix
source tools/step.sh
start=$SECONDS
only=${1-}
ran=0
failed=()

left_out() { [[ $1 != *"$only"* ]] || ! ((++ran)); }
check() { left_out "$1" || step "$@" || failed+=("$1"); }

compile() { # FOLDER CMAKE-OPTION...
    cmake -S . -B "$build/$1" -G Ninja -DSWIVEL_WERROR=ON -DCMAKE_EXPORT_COMPILE_COMMANDS=ON "${@:2}" &&
        cmake --build "$build/$1" --parallel
}

compile_and_test() { # FOLDER CMAKE-OPTION...
    compile "$@" &&
        ctest --test-dir "$build/$1" --parallel "$(nproc)" --output-on-failure --no-tests=error
}

format() { find include src kernels tests bench tools -name '*.[ch]pp' -exec clang-format --dry-run -Werror {} +; }

# Kernels once, as the source files of one ISA.
tidy() {
    run-clang-tidy -quiet -p $build/clang -j "$(nproc)" "$PWD/(src|tools)/.*" "$PWD/$build/clang/kernels/.*avx512.*"
}

# An old processor: no illegal instruction, and the ISA that it can run is chosen. What does not depend on the ISA,
# the files of clips, is left out.
processor() { # CPU ISA [TESTS-LEFT-OUT [TESTS]]
    local run="qemu-x86_64 -cpu $1" shards shard pids=() status=0
    $run build/test/tools/swivel/swivel info >$build/info.txt || return
    cat $build/info.txt
    grep -qE "^isa in use: +$2\$" $build/info.txt || { echo "the ISA in use is not $2" && return 1; }
    shards=$(nproc)
    for ((shard = 0; shard < shards; shard++)); do
        GTEST_TOTAL_SHARDS=$shards GTEST_SHARD_INDEX=$shard \
            $run build/test/tests/swivel_tests --gtest_brief=1 --gtest_filter="${4-*}-Bvh*:Clip*:${3-}" &
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
        cmake --build $build/with_xsimd_"$1" --parallel --target swivel_tests &&
        $build/with_xsimd_"$1"/tests/swivel_tests --gtest_brief=1 --gtest_filter='*EveryOperation*:*Golden*' &&
        grep -hE '#define XSIMD_VERSION_M' $build/xsimd_"$1"/usr/include/xsimd/config/xsimd_config.hpp
}

fuzz() {
    mkdir -p $build/corpus &&
        $build/sanitizers/tests/fuzz/bvh_fuzz -max_total_time=60 -timeout=10 -print_final_stats=1 \
            -artifact_prefix=$build/ $build/corpus tests/fuzz/corpus
}

tools/install_packages.sh build test matrix bench || { echo "test.sh: packages are missing"; exit 1; }

sanitize="-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer"
check "format" format
# Its tests are those that tools/test.sh runs.
check "g++ with the bench" compile ../test -DCMAKE_BUILD_TYPE=Release -DSWIVEL_BUILD_BENCH=ON
check "every float" build/test/tests/swivel_exhaustive_tests
check "clang" compile_and_test clang -DCMAKE_CXX_COMPILER=clang++
check "clang-tidy" tidy
check "debug with sanitizers" compile_and_test sanitizers -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=Debug \
    -DCMAKE_CXX_FLAGS_DEBUG="-gline-tables-only -O1" -DCMAKE_CXX_FLAGS="$sanitize" -DSWIVEL_BUILD_FUZZ=ON \
    -DSWIVEL_ISAS="$(grep -qm 1 avx512bw /proc/cpuinfo && echo avx512 || echo avx2)"
check "fuzz BVH files for 60 s" fuzz
# One test of every operation suffices where the kernels are those of another step.
brief="*EveryOperation*:*Golden*:Isa.*"
check "x86-64 Conroe" processor Conroe sse2 "" "$brief"
check "x86-64 Nehalem" processor Nehalem sse2 "" "$brief"
# AVX2 is emulated at a hundredth of its speed. Left out: repetition in the large, the older ISAs once more, and guard pages
# after masked loads, where this emulator (7.2) wrongly reads the lanes that are masked off.
large="*ManyBlocks*:*AtEveryLanePosition*"
check "x86-64 Haswell" processor Haswell avx2 "$large:*/sse2:*TouchesNothingPastTheEnd*"
check "x86-64 Haswell without XSAVE" processor Haswell,-xsave sse2 "$large" "$brief"
check "aarch64" compile_and_test aarch64 -DCMAKE_TOOLCHAIN_FILE=tools/cmake/aarch64.cmake -DSWIVEL_BUILD_TOOLS=OFF \
    -DSWIVEL_GTEST_SOURCE_DIR=/usr/src/googletest
check "xsimd of Debian 13" newer_xsimd trixie

((ran)) || { echo "test.sh: no step of that name"; exit 2; }
printf '\n%d min %02d s\n' $(((SECONDS - start) / 60)) $(((SECONDS - start) % 60))
if ((${#failed[@]})); then
    printf 'test.sh: failed: %s\n' "${failed[@]}"
    exit 1
fi
echo "all steps passed"
