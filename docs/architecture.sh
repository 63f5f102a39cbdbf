#!/usr/bin/env bash
# Draws docs/pictures/architecture.svg: the modules on their floors, an arrow for each use that no longer way implies, and the three
# flows of docs/architecture.md in colour. The arrows come from the build (module_uses.txt), which a test holds against every #include.
# usage: docs/architecture.sh [PRESET]      needs graphviz (dot, tred)
set -euo pipefail
cd "$(dirname "$0")/.."
uses=build/${1:-dev}/module_uses.txt
[ -f "$uses" ] || { echo "$uses is missing: cmake --preset ${1:-dev} first" >&2; exit 1; }
arrows() { awk -F': ?' '{ n = split($2, used, " "); for (i = 1; i <= n; ++i) printf "\"%s\" -> \"%s\";\n", $1, used[i] }' "$uses"; }
flow() { # colour module…   one arrow from each to the next
    local colour=$1 from=$2 to
    shift 2
    for to in "$@"; do
        if grep -q "^$from:" "$uses" && grep -q "^$to:" "$uses"; then
            echo "\"$from\" -> \"$to\" [color=\"$colour\", penwidth=2.4, constraint=false];"
        else
            echo "the flow names $from or $to, which is no module" >&2
            return 1
        fi
        from=$to
    done
}
{
    echo 'digraph stepwise { rankdir=TB; nodesep=0.18; ranksep=0.45; fontname="Noto Sans";'
    echo 'node [shape=box, style="rounded,filled", fillcolor=white, color="#7a8794", fontname="Noto Sans", fontsize=11, margin="0.09,0.04"];'
    echo 'edge [color="#b4bcc4", arrowsize=0.6];'
    for floor in app hmi editor projects runtime; do
        echo "subgraph cluster_$floor { label=\"$floor\"; labeljust=l; style=filled; color=\"#eef1f4\"; fontsize=14;"
        sed -n "s#^\($floor[^:]*\):.*#\1#p" "$uses" | while read -r module; do
            label=${module#"$floor"/}
            echo "\"$module\" [label=\"$label\"];"
        done
        echo '}'
    done
    { echo 'digraph uses {'; arrows; echo '}'; } | tred | grep -e '->'
    flow '#c2571a' editor/text editor/workspace projects/analysis runtime/compiler/driver runtime/compiler/sema runtime/compiler/parse runtime/compiler/lex
    flow '#1a73c2' runtime/controller runtime/history projects/session editor/trace/recording editor/trace/curves editor/plot/painting
    flow '#2a8a4a' hmi/view/scene hmi/player hmi/station projects/session runtime/controller
    echo '}'
} | dot -Tsvg >docs/pictures/architecture.svg
