#!/usr/bin/env bash
# Builds and runs every test. --long also takes the sanitizer presets, every token of the broken programs, and ten minutes of each
# fuzz target (CONTRIBUTING.md says what that is and how long it takes).
source "$(dirname "$0")/.ci/setup.sh"
long=0
for word in "$@"; do
    case "$word" in
    --long) long=1 ;;
    *) echo "usage: ./test.sh [--long]" >&2; exit 2 ;;
    esac
done
if [ "$long" = 1 ]; then install_missing clang-19 libclang-rt-19-dev; else install_missing; fi

run_tests() { # preset
    say "tests: preset $1"
    ctest --preset "$1" -j "$(nproc)"
}
configure dev
build dev
run_tests dev
say "tests: the shipped examples"
build/dev/bin/stepwise test projects/examples
if [ "$long" = 1 ]; then
    say "tests: broken programs at each token, damaged files at length"
    STEPWISE_LONG=1 build/dev/bin/test_golden --gtest_brief=1 --gtest_filter='Broken.*'
    STEPWISE_LONG=1 build/dev/bin/test_loaders --gtest_brief=1
    for preset in asan tsan; do
        configure $preset
        build $preset
        run_tests $preset
    done
    configure fuzz
    build fuzz fuzz_targets
    export ASAN_OPTIONS=detect_leaks=1 UBSAN_OPTIONS=print_stacktrace=1:halt_on_error=1 QT_QPA_PLATFORM=offscreen
    export LSAN_OPTIONS=suppressions=$PWD/tests/sanitizers/leaks.supp:print_suppressions=0
    for name in fuzz_lexer fuzz_parser fuzz_run fuzz_inputs; do
        say "fuzz: $name for ten minutes"
        mkdir -p "build/fuzz/corpus/$name" build/fuzz/findings
        seeds=(tests/fuzz/seeds tests/fuzz/findings)
        [ "$name" != fuzz_inputs ] || seeds=() # its seeds are the files of the examples
        [ "$name" != fuzz_inputs ] || tests/fuzz/input_seeds.sh "build/fuzz/corpus/$name"
        "build/fuzz/bin/$name" -max_total_time=600 -timeout=20 -rss_limit_mb=4096 -max_len=8192 -print_final_stats=1 \
            "-artifact_prefix=build/fuzz/findings/${name}_" "build/fuzz/corpus/$name" "${seeds[@]}" >"build/fuzz/$name.log" 2>&1 ||
            { tail -40 "build/fuzz/$name.log" >&2; echo "A finding lies in build/fuzz/findings" >&2; exit 1; }
        grep -a -E '^Done|average_exec' "build/fuzz/$name.log"
    done
fi
say "all tests passed"
