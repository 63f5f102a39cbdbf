#!/usr/bin/env bash
# usage: input_seeds.sh FOLDER   writes the examples' files there as seeds of fuzz_inputs: a byte for the kind (the order of kInputs
# in inputs.h), then the file.
set -euo pipefail
cd "$(dirname "$0")/../.."
mkdir -p "$1"
kind=0
for pattern in 'projects/examples/*/hmi/*.panel.json' 'projects/examples/*/hmi/texts.csv' 'projects/examples/*/hmi/alarms.json' \
    'projects/examples/*/traces/*.trace.json' 'projects/examples/*/project.json' '' '' 'projects/examples/*/hmi/recipes.json' \
    'projects/examples/*/hmi/people.json' '' 'projects/examples/*/devices.json'; do
    number=0
    for file in $pattern; do
        if [ -f "$file" ] && [ "$(stat -c %s "$file")" -lt 8000 ]; then
            { printf "\\x$(printf %02x $kind)"; cat "$file"; } >"$1/seed_${kind}_$number"
            number=$((number + 1))
        fi
    done
    kind=$((kind + 1))
done
