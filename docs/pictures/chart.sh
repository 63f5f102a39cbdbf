#!/usr/bin/env bash
# Draws the charts of the examples, idle and running: docs/pictures/chart.sh [FOLDER OF PROGRAMS]   (default: build/dev/bin). Needs no display.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
programs=${1:-build/dev/bin}
export QT_QPA_PLATFORM=offscreen
for theme in light dark; do "$programs/chart_pictures" docs/pictures $theme >/dev/null; done
