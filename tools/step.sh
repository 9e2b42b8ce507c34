# For scripts that source it, with `build` set to the folder of build trees:
#   step NAME COMMAND...   runs the command with its output in a log; prints the name, the outcome, the duration, and
#                          ctest's closing lines or, on failure, the end of the log. Status 77 counts as skipped.

step() {
    local name=$1 log=$build/${1// /_}.log start=$SECONDS status=0
    shift
    mkdir -p "$build"
    printf '%-32s' "$name"
    "$@" >"$log" 2>&1 </dev/null || status=$?
    case $status in
        0) printf 'ok      %4d s\n' $((SECONDS - start)) ;;
        77) printf 'SKIPPED: %s\n' "$(tail -n 1 "$log")" ;;
        *) printf 'FAILED  %4d s\n' $((SECONDS - start)) ;;
    esac
    if ((status == 0 || status == 77)); then
        sed -n '/% tests passed/,$p' "$log"
        return 0
    fi
    grep -E 'error:|: Failure|\*\*\*Failed' "$log" | cut -c 1-200 | head -n 20 || true
    echo ...
    tail -n 15 "$log" | cut -c 1-200
    echo "${0##*/}: $name failed, see $log"
    return 1
}
