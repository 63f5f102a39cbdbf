#!/usr/bin/env bash
# Prints the table of sizes in docs/architecture.md: lines of files, lines of functions from head to closing brace.
# usage: docs/sizes.sh            the table
#        docs/sizes.sh FOLDER [N] the N (20) longest functions below a folder and its longest files
#        docs/sizes.sh modules    each layer's modules over 12 % of its lines
# needs universal-ctags
set -euo pipefail
cd "$(dirname "$0")/.."
sources() { git ls-files --cached --others --exclude-standard "$1/*.cpp" "$1/*.h"; }
functions() { # lines, file:line, name
    sources "$1" | ctags -L - --languages=C++ --kinds-C++=f --fields=+ne -f - 2>/dev/null |
        awk -F'\t' '{ line = end = 0
            for (i = 4; i <= NF; ++i) { if ($i ~ /^line:/) line = substr($i, 6); if ($i ~ /^end:/) end = substr($i, 5) }
            if (end) print end - line + 1 "\t" $2 ":" line "\t" $1 }'
}
files() { sources "$1" | tr '\n' '\0' | xargs -0 wc -l | awk '$2 != "total" { print $1 "\t" $2 }'; }
spread() { # median, nine of ten, longest of the first column
    sort -n | awk '{ v[NR] = $1 } END { printf "%d / %d / %d", v[int((NR + 1) / 2)], v[int(NR * 0.9 + 0.999)], v[NR] }'
}
comments() { # share of lines in sources that are comments
    sources "$1" | grep '\.cpp$' | tr '\n' '\0' | xargs -0 cat |
        awk '{ ++n } /^[ \t]*\/\// { ++c } END { printf "%.1f %%", n ? 100 * c / n : 0 }'
}
modules() { # floor: lines of a module, share of the floor; a room of sema counts as a module, since it has its own folder
    local floor=$1
    sources "$floor" | while read -r file; do echo "$(dirname "$file") $(wc -l <"$file")"; done |
        awk -v floor="$floor" '{ lines[$1] += $2; all += $2; } END { for (m in lines) print lines[m] "\t" m "\t" 100 * lines[m] / all; }' |
        sort -rn | awk -F'\t' '{ ++n; all += $1 } $3 > 12 { big = big sprintf("%s`%s` %.0f %%", big ? ", " : "", $2, $3) }
            END { printf "%d | %d | %s |\n", n, all, big ? big : "none" }'
}
if [ "${1:-}" = modules ]; then
    echo '| layer | folders | lines | modules over 12 % of them |'
    echo '|---|---|---|---|'
    for floor in runtime projects editor hmi app; do echo "| \`$floor\` | $(modules $floor)"; done
    exit 0
fi
if [ $# -gt 0 ]; then
    functions "$1" | sort -rn | head -n "${2:-20}"
    echo
    files "$1" | sort -rn | head -n "${2:-20}"
    exit 0
fi
echo '| folder | files | lines per file | functions | lines per function | comment lines in sources |'
echo '|---|---|---|---|---|---|'
for folder in runtime/compiler/parse runtime/compiler/sema runtime/compiler/codegen runtime projects editor hmi app; do
    echo "| \`$folder\` | $(sources $folder | wc -l) | $(files $folder | spread) | $(functions $folder | wc -l) | $(functions $folder | spread) | $(comments $folder) |"
done
