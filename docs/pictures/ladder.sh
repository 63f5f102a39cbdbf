#!/usr/bin/env bash
# Draws the ladder and function block diagrams of docs/ladder.md, idle and running: docs/pictures/ladder.sh [FOLDER OF PROGRAMS]
# (default: build/dev/bin). Needs no display.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
programs=${1:-build/dev/bin}
export QT_QPA_PLATFORM=offscreen
for theme in light dark; do "$programs/ladder_pictures" docs/pictures $theme >/dev/null; done
