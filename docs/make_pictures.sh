#!/usr/bin/env bash
# Makes the pictures of docs/pictures from the real studio under Xvfb, and those of the examples' READMEs.
# usage: docs/make_pictures.sh [PRESET]
set -euo pipefail
cd "$(dirname "$0")/.."
preset=${1:-dev}
ninja -C "build/$preset" stepwise studio_pictures >/dev/null
xvfb-run -a -s "-screen 0 1600x1000x24" "build/$preset/bin/studio_pictures" docs/pictures
export QT_QPA_PLATFORM=offscreen
for project in projects/examples/*/; do
    name=$(basename "$project")
    setup=$(ls "$project"traces/*.trace.json 2>/dev/null | head -1 || true)
    if [ -n "$setup" ]; then
        mkdir -p "${project}docs"
        "build/$preset/bin/stepwise" trace "$project" --setup "$(basename "$setup" .trace.json)" --for 20s --picture "${project}docs/trace.png" >/dev/null || echo "no trace picture of $name" >&2
    fi
    if ls "$project"hmi/*.panel.json >/dev/null 2>&1; then
        folder=$(mktemp -d)
        if "build/$preset/bin/stepwise" panel "$project" --pictures "$folder" --language en --at 10s >/dev/null; then
            mkdir -p "${project}docs"
            cp "$(ls "$folder"/*.png | head -1)" "${project}docs/panel.png"
        else
            echo "no panel picture of $name" >&2
        fi
        rm -r "$folder"
    fi
done
