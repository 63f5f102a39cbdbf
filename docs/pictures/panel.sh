#!/usr/bin/env bash
# Draws the pictures of panels: docs/pictures/panel.sh [PROGRAM] [TESTS]   (default: build/dev/bin). Needs no display.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
stepwise=${1:-build/dev/bin/stepwise}
tests=${2:-$(dirname "$stepwise")}
out=docs/pictures
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for theme in light dark; do
    "$stepwise" panel tests/hmi/languages --pictures "$work" --at 50s --set Panel.Start=TRUE --set Panel.Start=FALSE@1s --theme $theme >/dev/null
    for language in en de da ar zh-CN; do mv "$work/tank.$language.png" "$out/panel_${language}_$theme.png"; done
done
"$stepwise" panel projects/examples/alarm_texts --pictures "$work" --language de --at 8s --set Panel.Start=TRUE --set Panel.Start=FALSE@1s --set Plant.Load=130@2s >/dev/null
mv "$work/motor.de.png" "$out/panel_alarm_texts_de.png"
export QT_QPA_PLATFORM=offscreen STEPWISE_PICTURES=$work
"$tests/test_hmi_view" --gtest_filter='EveryKind.IsDrawn*' >/dev/null
"$tests/test_hmi" --gtest_filter='Pictures.*' >/dev/null
for theme in light dark contrast; do mv "$work/elements_$theme.png" "$out/panel_elements_$theme.png"; done
mv "$work/designer.png" "$out/panel_designer.png"
mv "$work/check.png" "$out/panel_check.png"
