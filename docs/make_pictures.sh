#!/usr/bin/env bash
# Makes the pictures of docs/pictures from the real studio under Xvfb, and those of the examples' READMEs.
# usage: docs/make_pictures.sh [PRESET [EXAMPLE|all]]      with an EXAMPLE only its pictures, with "all" those of every example
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-dev}
if [ -z "${2:-}" ]; then
    ninja -C "build/$preset" stepwise studio_pictures chart_pictures ladder_pictures >/dev/null
    xvfb-run -a -s "-screen 0 1600x1000x24" "build/$preset/bin/studio_pictures" docs/pictures
    export QT_QPA_PLATFORM=offscreen
    docs/pictures/chart.sh "build/$preset/bin"
    docs/pictures/ladder.sh "build/$preset/bin"
fi
export QT_QPA_PLATFORM=offscreen
# What a project's pictures are of, where it is worth more than the first seconds at rest: docs/pictures.txt in the project has a
# line `panel OPTIONS` and a line `trace OPTIONS`, with the options of those commands (--at, --set PATH=VALUE@TIME, --for …).
options_of() { # PROJECT panel|trace DEFAULTS…
    local file="$1docs/pictures.txt" kind=$2 line
    shift 2
    line=$(sed -n "s/^$kind //p" "$file" 2>/dev/null || true)
    echo "${line:-$*}"
}
# What the pictures were made from: docs/pictures.sum in the project, which test_examples compares with what is there.
sum_of() { # PROJECT
    (cd "$1" && find project.json src hmi traces docs/pictures.txt -type f | LC_ALL=C sort | while read -r file; do
        printf '%s\n' "$file"
        cat "$file"
    done | sha256sum | cut -d' ' -f1)
}
# The panels that a README shows: the start panel as docs/panel.png, another one under its own name.
panels_of() { # PROJECT START
    local file name
    echo "$2"
    for file in "$1"docs/*.png; do
        name=$(basename "$file" .png)
        if [ -f "$1hmi/$name.panel.json" ] && [ "$name" != "$2" ]; then echo "$name"; fi
    done
}
only=${2:-all}
for project in projects/examples/*/; do
    name=$(basename "$project")
    if [ "$only" != all ] && [ "$only" != "$name" ]; then continue; fi
    mkdir -p "${project}docs"
    setup=$(ls "$project"traces/*.trace.json 2>/dev/null | head -1 || true)
    if [ -n "$setup" ]; then
        read -ra options <<<"$(options_of "$project" trace --for 20s)"
        "build/$preset/bin/stepwise" trace "$project" --setup "$(basename "$setup" .trace.json)" "${options[@]}" --picture "${project}docs/trace.png" >/dev/null || echo "no trace picture of $name" >&2
    fi
    start=$(sed -n 's/.*"startPanel": *"\([^"]*\)".*/\1/p' "${project}project.json")
    if [ -n "$start" ] && [ -f "${project}hmi/$start.panel.json" ]; then
        folder=$(mktemp -d)
        read -ra options <<<"$(options_of "$project" panel --at 10s)"
        for panel in $(panels_of "$project" "$start"); do
            if "build/$preset/bin/stepwise" panel "$project" --panel "$panel" --pictures "$folder" --language en "${options[@]}" >/dev/null; then
                if [ "$panel" = "$start" ]; then picture=panel; else picture=$panel; fi
                cp "$folder/$panel".en*.png "${project}docs/$picture.png"
            else
                echo "no picture of the panel $panel of $name" >&2
            fi
        done
        rm -r "$folder"
    fi
    sum_of "$project" >"${project}docs/pictures.sum"
done
