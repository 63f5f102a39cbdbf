#!/usr/bin/env bash
# Makes the pictures of docs/pictures from the real studio under Xvfb, and those of the examples' READMEs.
# usage: docs/make_pictures.sh [PRESET [EXAMPLE]]      with an EXAMPLE only its two pictures
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-dev}
if [ -z "${2:-}" ]; then
    ninja -C "build/$preset" stepwise studio_pictures chart_pictures ladder_pictures >/dev/null
    xvfb-run -a -s "-screen 0 1600x1000x24" "build/$preset/bin/studio_pictures" docs/pictures
fi
export QT_QPA_PLATFORM=offscreen
docs/pictures/chart.sh "build/$preset/bin"
docs/pictures/ladder.sh "build/$preset/bin"
# What a project's pictures are of, where it is worth more than the first seconds at rest: docs/pictures.txt in the project has a
# line `panel OPTIONS` and a line `trace OPTIONS`, with the options of those commands (--at, --set PATH=VALUE@TIME, --for …).
options_of() { # PROJECT panel|trace DEFAULTS…
    local file="$1docs/pictures.txt" kind=$2 line
    shift 2
    line=$(sed -n "s/^$kind //p" "$file" 2>/dev/null || true)
    echo "${line:-$*}"
}
only=${2:-}
for project in projects/examples/*/; do
    name=$(basename "$project")
    if [ -n "$only" ] && [ "$only" != "$name" ]; then continue; fi
    setup=$(ls "$project"traces/*.trace.json 2>/dev/null | head -1 || true)
    if [ -n "$setup" ]; then
        mkdir -p "${project}docs"
        read -ra options <<<"$(options_of "$project" trace --for 20s)"
        "build/$preset/bin/stepwise" trace "$project" --setup "$(basename "$setup" .trace.json)" "${options[@]}" --picture "${project}docs/trace.png" >/dev/null || echo "no trace picture of $name" >&2
    fi
    panel=$(sed -n 's/.*"startPanel": *"\([^"]*\)".*/\1/p' "${project}project.json")
    if [ -n "$panel" ] && [ -f "${project}hmi/$panel.panel.json" ]; then
        folder=$(mktemp -d)
        read -ra options <<<"$(options_of "$project" panel --at 10s)"
        if "build/$preset/bin/stepwise" panel "$project" --panel "$panel" --pictures "$folder" --language en "${options[@]}" >/dev/null; then
            mkdir -p "${project}docs"
            cp "$folder/$panel.en.png" "${project}docs/panel.png"
        else
            echo "no panel picture of $name" >&2
        fi
        rm -r "$folder"
    fi
done
