#!/usr/bin/env bash
# Pictures of every window, dialog and menu in every language, light, dark and in high contrast, on a small screen and with texts of 200 %, to be
# looked at; they are not part of the project. Says what is cut.
# usage: docs/pictures/languages.sh OUT [FOLDER OF PROGRAMS [LANGUAGE]]      (default: build/dev/bin, every language)
set -uo pipefail
out=$(realpath -m "${1:?where the pictures go}")
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
programs=${2:-build/dev/bin}
export QT_QPA_PLATFORM=offscreen
take() { # NAME WINDOW THEME [VARIABLE=VALUE…]
    local name=$1 window=$2 theme=$3
    shift 3
    env STEPWISE_PICTURES="$out/$name" STEPWISE_WINDOW="$window" STEPWISE_THEME="$theme" "$@" \
        "$programs/window_pictures" --gtest_filter="Languages/FitTest.*${language:+/$language}" >"$out/$name.txt" 2>&1 || result=1
    grep -A1 "Failure" "$out/$name.txt" | grep -E "^[a-z]{2}(_CN)?, |“" || true
}
languages=(en de da fr es zh_CN) # the order of the test's values
language=
for i in "${!languages[@]}"; do if [ "${languages[$i]}" = "${3:-}" ]; then language=$i; fi; done
result=0
if [ "$programs" = build/dev/bin ]; then ninja -C build/dev window_pictures >/dev/null; fi
mkdir -p "$out"
take light 1440x900 light
take dark 1440x900 dark
take contrast 1440x900 contrast
take small 1024x700 light
take double 1440x900 light QT_FONT_DPI=192
exit $result
