#!/usr/bin/env bash
# Builds the release and opens the studio on an example; without a display runs that example on the command line.
# usage: ./run.sh [PROJECT]
source "$(dirname "$0")/.ci/setup.sh"
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
