#!/usr/bin/env bash
# Builds the release and opens the studio on an example; without a display runs that example on the command line.
# usage: ./run.sh [PROJECT]
#        ./run.sh --package [PRESET]   makes the Debian package and the tarball in out/ (default: of the release)
source "$(dirname "$0")/.ci/setup.sh"
if [ "${1:-}" = --package ]; then
    preset=${2:-release}
    install_missing dpkg-dev file lintian
    configure "$preset"
    build "$preset" stepwise stepwise_pages
    say "package"
    mkdir -p out
    rm -rf "build/$preset/package" out/stepwise_*.deb out/stepwise-*.tar.gz # of versions before
    cpack --config "build/$preset/CPackConfig.cmake" >"build/package-$preset.log" 2>&1 ||
        { tail -20 "build/package-$preset.log" >&2; echo "The package failed; see build/package-$preset.log" >&2; exit 1; }
    cp "build/$preset"/package/stepwise_*.deb "build/$preset"/package/stepwise-*.tar.gz out/
    lintian --allow-root --fail-on error out/stepwise_*.deb >build/lintian.log 2>&1 || { cat build/lintian.log >&2; exit 1; }
    ls -sh out/stepwise_*.deb out/stepwise-*.tar.gz
    say "to install: apt install ./$(ls out/stepwise_*.deb)"
    exit
fi
install_missing
configure release
build release stepwise
project=${1:-projects/examples/pid_pt1}
if [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ]; then
    say "studio: $project"
    exec build/release/bin/stepwise "$project"
fi
say "no display: running $project for 10 s of plant time"
mkdir -p out
build/release/bin/stepwise run "$project" --for 10s --csv "out/$(basename "$project").csv"
say "values of every scan: out/$(basename "$project").csv"
