#!/usr/bin/env bash
# Builds and runs every test. --long also takes the sanitizer presets, every token of the broken programs, and five minutes of each
# fuzz target (CONTRIBUTING.md says what that is and how long it takes), and ends with a table of what ran and how long each part took.
# FUZZ_SECONDS=300 and FUZZERS (how many at once, at most one per core) steer the fuzzers.
source "$(dirname "$0")/.ci/setup.sh"
# Memory in large pages, as for the compiler (.ci/setup.sh): a test with images of 120 MB takes 4 s, not 25, on such a machine.
export GLIBC_TUNABLES=glibc.malloc.hugetlb=1
long=0
for word in "$@"; do
    case "$word" in
    --long) long=1 ;;
    *) echo "usage: ./test.sh [--long]" >&2; exit 2 ;;
    esac
done

parts=()  # "title<tab>seconds" of what is done
failed=() # titles
current=
begun=0
# Runs a command and keeps how long it took. A failure ends a short run at once; a long one goes on, says so at its end, and fails then.
part() { # title command…
    current=$1
    begun=$SECONDS
    local code=0
    set +e
    (set -e; "${@:2}")
    code=$?
    set -e
    [ "$code" = 0 ] || { failed+=("$1"); current="$1: FAILED"; }
    parts+=("$current"$'\t'"$((SECONDS - begun))")
    current=
    [ "$code" = 0 ] || [ "$long" = 1 ] || exit "$code"
    return 0
}
is_built() { # preset   and so it can be tested
    local title
    for title in "${failed[@]}"; do [[ "$title" != "$1: build"* ]] || return 1; done
}
at_end() {
    local code=$? line
    local left
    left=$(jobs -p)
    [ -z "$left" ] || kill $left 2>/dev/null || true
    [ -z "$current" ] || parts+=("$current: not finished"$'\t'"$((SECONDS - begun))")
    if [ "$long" = 1 ] && [ ${#parts[@]} -gt 0 ]; then
        say "what ran"
        for line in "${parts[@]}" "all"$'\t'"$SECONDS"; do
            printf '%-58s %4d min %02d s\n' "${line%$'\t'*}" "$((${line##*$'\t'} / 60))" "$((${line##*$'\t'} % 60))"
        done
    fi
    return "$code"
}
trap at_end EXIT

run_tests() { # preset
    say "tests: preset $1"
    ctest --preset "$1" -j "$(($(nproc) + 1))" # a third of the time of many is waiting
}
run_examples() {
    say "tests: the shipped examples"
    build/dev/bin/stepwise test projects/examples
}

# Runs FUNCTION NAME for each name, some side by side, each into a log of its own. All run to their end; then one failure fails the whole.
side_by_side() { # how many at once, folder of the logs, function, names…
    local most=$1 logs=$2 run=$3 name pid failed=()
    local -A running=()
    shift 3
    reap() { # waits for one of them
        local code=0
        wait -n -p pid "${!running[@]}" || code=$?
        name=${running[$pid]}
        unset "running[$pid]"
        if [ "$code" = 0 ]; then
            say "$name: done"
        else
            failed+=("$name")
            echo "$name failed ($code); the end of $logs/$name.log:" >&2
            tail -n 40 "$logs/$name.log" >&2
        fi
        grep -a -E '^Done [0-9]|^\[ *PASSED' "$logs/$name.log" || true
    }
    mkdir -p "$logs"
    local next
    for next in "$@"; do
        [ ${#running[@]} -lt "$most" ] || reap
        say "$next (log: $logs/$next.log)"
        "$run" "$next" >"$logs/$next.log" 2>&1 &
        running[$!]=$next
    done
    while [ ${#running[@]} -gt 0 ]; do reap; done
    [ ${#failed[@]} -eq 0 ] || { echo "Failed: ${failed[*]}" >&2; exit 1; }
}

at_length() { # name of a long test
    export STEPWISE_LONG=1 QT_QPA_PLATFORM=offscreen
    case "$1" in
    broken_goldens) exec build/dev/bin/test_golden --gtest_brief=1 --gtest_filter='Broken.Goldens' ;;
    broken_corpus) exec build/dev/bin/test_golden --gtest_brief=1 --gtest_filter='Broken.Corpus' ;;
    random_values) exec build/dev/bin/test_golden --gtest_filter='Random.*-Random.ManyProgramsFault*' ;;
    random_faults) exec build/dev/bin/test_golden --gtest_filter='Random.ManyProgramsFault*' ;;
    random_events)
        local seed events
        for seed in {1..40}; do
            echo "seed $seed"
            events='RandomEvents.*'
            [ "$seed" -gt 10 ] || events+=':ShortRecording.*'
            STEPWISE_RANDOM_SEED=$seed STEPWISE_RANDOM_EVENTS=4000 \
                build/dev/bin/test_app --gtest_brief=1 --gtest_filter="$events" || exit 1
        done
        ;;
    damaged_files) exec build/dev/bin/test_loaders --gtest_brief=1 ;;
    esac
}

# The targets that check and run whole programs do so without sanitizers (preset fuzz), so that they see many; what they kept is run
# once with them afterwards. The others have sanitizers from the start.
of_programs=(fuzz_check fuzz_run fuzz_change fuzz_inside)
of_bytes=(fuzz_lexer fuzz_parser fuzz_messages fuzz_inputs fuzz_peers fuzz_panels)

with_sanitizers() {
    export ASAN_OPTIONS=detect_leaks=1:malloc_context_size=4:quarantine_size_mb=32 UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1
    export LSAN_OPTIONS=suppressions=$PWD/tests/sanitizers/leaks.supp:print_suppressions=0 QT_QPA_PLATFORM=offscreen
}
# Leaks are looked for once, at the end: a cache that grows would be searched for in each of the first thousand inputs.
fuzz_options=(-timeout=20 -rss_limit_mb=4096 -detect_leaks=0 -entropic=0 -print_final_stats=1)

fuzz() { # fuzz target
    local seeds=(tests/fuzz/seeds tests/fuzz/findings tests/golden) preset=asan longest=8192 words=()
    mkdir -p "build/fuzz_corpus/$1" build/fuzz_findings
    case "$1" in
    fuzz_inputs) # its seeds are the files of the examples
        tests/fuzz/input_seeds.sh "build/fuzz_corpus/$1"
        seeds=()
        longest=65536 # a recording holds the libraries' text
        words=("-dict=build/fuzz_corpus/$1.dict")
        ;;
    fuzz_messages) seeds=(tests/projects/language_server/scripts tests/projects/debug_adapter/scripts) ;; # whole sessions with other editors
    fuzz_peers) seeds=(tests/fuzz/peers) ;;
    fuzz_panels) seeds=(tests/fuzz/panels) ;;
    fuzz_check | fuzz_run | fuzz_change | fuzz_inside)
        preset=fuzz
        words=(-use_counters=0) # how often a place was passed makes most texts new, and the corpus long
        ;;
    esac
    with_sanitizers
    exec "build/$preset/bin/$1" "${fuzz_options[@]}" -max_total_time="${FUZZ_SECONDS:-300}" -max_len="$longest" "${words[@]}" \
        "-artifact_prefix=build/fuzz_findings/${1}_" "build/fuzz_corpus/$1" "${seeds[@]}"
}

again_with_sanitizers() { # fuzz target of programs
    with_sanitizers
    exec "build/asan/bin/$1" "${fuzz_options[@]}" -runs=0 -max_len=65536 "-artifact_prefix=build/fuzz_findings/${1}_" "build/fuzz_corpus/$1"
}

if [ "$long" = 1 ]; then
    install_missing clang-19 libclang-rt-19-dev
    export STEPWISE_TEST_GROUPS=1 # a process takes long to start
else
    install_missing
fi
configure dev
part "dev: build" build dev
part "dev: every test" run_tests dev
part "dev: tests of the shipped examples" run_examples
if [ "$long" = 1 ]; then
    # What most often finds something comes first.
    configure asan
    part "asan: build, with the fuzz targets" build asan
    ! is_built asan || part "asan: every test" run_tests asan
    configure tsan
    part "tsan: build" build tsan
    ! is_built tsan || part "tsan: every test with threads" run_tests tsan
    if is_built asan; then
        configure fuzz
        part "fuzz: build" build fuzz "${of_programs[@]}"
        at_once=${FUZZERS:-2}
        [ "$at_once" -le "$(nproc)" ] || at_once=$(nproc)
        say "fuzz: ${FUZZ_SECONDS:-300} s each, $at_once at once; a finding lies in build/fuzz_findings"
        part "fuzz: ten targets, ${FUZZ_SECONDS:-300} s each, $at_once at once" \
            side_by_side "$at_once" build/fuzz_logs fuzz "${of_programs[@]}" "${of_bytes[@]}"
        part "fuzz: what four of them kept, with sanitizers" side_by_side "$at_once" build/fuzz_logs/again again_with_sanitizers "${of_programs[@]}"
    fi
    say "tests: broken programs at each token, random programs and events and damaged files at length"
    long_tests=(random_values random_faults random_events broken_goldens damaged_files)
    [ -z "${STEPWISE_CORPUS:-}" ] || long_tests=(broken_corpus "${long_tests[@]}")
    part "dev: random programs and events, broken programs, damaged files" \
        side_by_side "$(nproc)" build/dev/long at_length "${long_tests[@]}"
    [ ${#failed[@]} -eq 0 ] || { printf 'Failed: %s\n' "${failed[@]}" >&2; exit 1; }
fi
say "all tests passed"
