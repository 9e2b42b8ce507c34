#!/usr/bin/env bash
# What a program pays for swivel: the text (code and constants, as `size` counts it) of the library and of two programs
# that call one operation each, with and without --gc-sections; the files that name an operation. All ISAs of this
# processor, g++ -O2.
#
# usage: tools/size_report.sh [OPERATION]    default: angle_between
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=build/size
cmake -S . -B $build -G Ninja -DCMAKE_BUILD_TYPE=Release -DSWIVEL_BUILD_TESTS=OFF -DSWIVEL_BUILD_TOOLS=OFF >/dev/null
cmake --build $build --target swivel >/dev/null

text() { size "$1" | awk 'NR == 2 { printf "%d", $1 }'; }

program() { # NAME CALL
    printf '#include <swivel/%s.hpp>\nint main() {\n    float q[4] = {0, 0, 0, 1}, s[4], t[4];\n%s\n}\n' "$1" "$2" \
        >$build/"$1".cpp
    for flags in "" "-Wl,--gc-sections"; do
        # shellcheck disable=SC2086
        g++ -std=c++20 -O2 -Iinclude $build/"$1".cpp $build/libswivel.a $flags -o $build/"$1"
        printf '%-24s %-18s %9d bytes of text\n' "$1" "${flags#-Wl,}" "$(text $build/"$1")"
    done
}

# shellcheck disable=SC2016
printf '%-24s %-18s %9d bytes of text\n' libswivel.a "" "$(size -t $build/libswivel.a | awk 'END { print $1 }')"
view() { printf 'swivel::aos_xyzw(%s, 1)' "$1"; }
program decompose "    return swivel::decompose($(view q), swivel::axis::x, $(view s), $(view t)) != swivel::status::ok;"
program slerp "    return swivel::slerp($(view q), $(view q), 0.5f, $(view s)) != swivel::status::ok;"
echo "files that name ${1:-angle_between}:"
grep -rlw --include='*.[ch]pp' --include='*.md' --include='*.txt' --include='*.py' --include='*.cmake' "${1:-angle_between}" \
    include kernels src operations tests bench README.md CHANGELOG.md | sed 's/^/  /'
