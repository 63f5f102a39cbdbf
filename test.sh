#!/usr/bin/env bash
# Builds and runs every test. --long also runs the fuzzers and the sanitizer presets.
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
    QT_QPA_PLATFORM=offscreen ctest --test-dir "build/$1" --output-on-failure -j "$(nproc)" --timeout 300
}
configure dev
build dev
run_tests dev
say "tests: the shipped examples"
build/dev/bin/stepwise test projects/examples
if [ "$long" = 1 ]; then
    for preset in asan tsan; do
        configure $preset
        build $preset
        run_tests $preset
    done
    configure fuzz
    build fuzz fuzz_targets
    for target in build/fuzz/bin/fuzz_*; do
        name=$(basename "$target")
        say "fuzz: $name for ten minutes"
        mkdir -p "build/fuzz/corpus/$name" build/fuzz/findings
        "$target" -max_total_time=600 -timeout=20 -rss_limit_mb=4096 -artifact_prefix=build/fuzz/findings/ "build/fuzz/corpus/$name" tests/fuzz/seeds >"build/fuzz/$name.log" 2>&1 ||
            { tail -40 "build/fuzz/$name.log" >&2; exit 1; }
    done
fi
say "all tests passed"
