#!/usr/bin/env bash
# Draws the pictures of the trace: docs/pictures/trace.sh [PROGRAM]   (default: build/dev/bin/stepwise). Needs no display.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
stepwise=${1:-build/dev/bin/stepwise}
out=docs/pictures
draw() { # name project options…
    local name=$1 project=$2
    shift 2
    "$stepwise" trace "projects/examples/$project" --picture "$out/$name.png" "$@" >/dev/null
}
draw trace_pid_rectangle pid_pt1 --for 4s
draw trace_pid_rectangle_dark pid_pt1 --for 4s --dark
draw trace_pid_sine pid_pt1 --for 4s --set 'Main.Sine=TRUE'
draw trace_pid_narrow pid_pt1 --for 4s --size 800x560
draw trace_pid_wide pid_pt1 --for 4s --size 2500x900
draw trace_pid_cursors pid_pt1 --for 4s --from 1400ms --to 2200ms --cursors 1500ms,1950ms --size 1200x760
draw trace_pid_trigger pid_pt1 --for 10s --trigger 'Main.SetPoint > 50.0 AND IO.Measured > 99.0' --before 300ms --after 600ms
draw trace_filter_100ms pt1_filter --for 10s
draw trace_filter_500ms pt1_filter --for 10s --set 'Main.FilterTime=T#500ms'
draw trace_pwm pwm --for 5s
draw trace_lanes traffic_light --for 60s --channels 'IO.Red,IO.Yellow,IO.Green,Main.State,Main.SecCount' --size 1200x360
