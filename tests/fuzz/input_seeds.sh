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
# What no example has as a file: a recording and a retain file, made by the program of preset dev, and a few by hand.
seed() { # kind, name: the file comes from the standard input
    { printf "\\x$(printf %02x "$1")"; cat; } >"$2"
}
if [ -x build/dev/bin/stepwise ]; then
    made=$(mktemp -d)
    printf 'PROGRAM Main\nVAR RETAIN n : DINT; END_VAR\nVAR x : INT; END_VAR\nx := x + 1; n := n + 1;\nEND_PROGRAM\n' >"$made/main.st"
    build/dev/bin/stepwise run "$made/main.st" --for 100ms --record "$made/a.rec" --retain "$made/a.retain" >"$made/log"
    seed 5 "$1/seed_5_0" <"$made/a.rec"
    seed 6 "$1/seed_6_0" <"$made/a.retain"
    number=1 # a byte for the name that an import goes by, then the file: here PLCopen XML
    for example in traffic_light motor agv gravel item_counter light_tower pwm; do
        build/dev/bin/stepwise export "projects/examples/$example" --to "$made/a.xml" >"$made/log"
        { printf '\x00'; cat "$made/a.xml"; } | seed 12 "$1/seed_12_$number"
        number=$((number + 1))
    done
    rm -r "$made"
fi
seed 8 "$1/seed_8_0" <<<'{"timeout": 60, "roles": [{"name": "operator"}], "users": [{"name": "anna", "roles": ["operator"], "language": "de"}]}'
seed 9 "$1/seed_9_0" <<<'<xliff version="2.0" xmlns="urn:oasis:names:tc:xliff:document:2.0" srcLang="en" trgLang="de"><file id="f"><unit id="a"><segment><source>Start</source><target>Anfang</target></segment></unit></file></xliff>'
seed 11 "$1/seed_11_0" <<<$'time,level,pump\n0.0,1.5,TRUE\n0.1,1.6,FALSE'
seed 12 "$1/seed_12_0" <<<$'\x01<TcPlcObject Version="1.1.0.1"><POU Name="Main"><Declaration><![CDATA[PROGRAM Main\nVAR x : INT; END_VAR]]></Declaration><Implementation><ST><![CDATA[x := x + 1;]]></ST></Implementation></POU></TcPlcObject>'
{ printf '\x00'; cat tests/fuzz/foreign/standard.xml; } | seed 12 "$1/seed_12_standard" # IEC 61131-10
for file in tests/fuzz/foreign/*.TcPOU; do # bodies that are drawn, as TwinCAT stores them
    { printf '\x01'; cat "$file"; } | seed 12 "$1/seed_12_$(basename "$file" .TcPOU)"
done
for file in tests/fuzz/foreign/*.EXP; do # text exports of CODESYS 2.3
    { printf '\x02'; cat "$file"; } | seed 12 "$1/seed_12_$(basename "$file" .EXP)"
done
# A channel of a trace with all it can have: the examples leave most of it as it is.
seed 3 "$1/seed_3_all" <<<'{"version": 1, "title": "t", "span": 60, "charts": [{"title": "c", "weight": 2}], "channels": [{"expression": "Main.x", "label": "X", "unit": "mm", "color": "#1f5fbf", "width": 2, "style": "line", "scale": 10, "offset": 1.5, "recording": "a.rec", "visible": false, "chart": 0}], "axes": [{"mode": "fixed", "min": 0, "max": 100}]}'
# The words of the files, which no random change would guess.
grep -ohE '"[A-Za-z][A-Za-z0-9-]{2,24}"' editor/trace/setup/*.cpp hmi/model/*.def hmi/model/*.cpp hmi/alarms/*.cpp hmi/recipes/*.cpp \
    hmi/people/*.cpp projects/devices/configuration/*.cpp projects/storage/*.cpp projects/exchange/*/*.cpp | sort -u >"$1.dict"
