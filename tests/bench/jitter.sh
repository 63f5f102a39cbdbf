#!/usr/bin/env bash
# How late `stepwise serve` starts its scans of 1 ms, beside cyclictest (package rt-tests) in the same minute: each on a core of its
# own, both under SCHED_FIFO at priority 60 with locked memory. As root. Prints both tables.
# usage: tests/bench/jitter.sh [STEPWISE] [SECONDS]
set -euo pipefail
stepwise=$(realpath "${1:-build/release/bin/stepwise}")
seconds=${2:-60}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cat >"$folder/main.st" <<'ST'
PROGRAM Main
VAR n : DINT; level : REAL; END_VAR
n := n + 1;
level := level * 0.99 + DINT_TO_REAL(n MOD 100);
END_PROGRAM
CONFIGURATION C RESOURCE R ON PLC
    TASK T(INTERVAL := T#1ms, PRIORITY := 1);
    PROGRAM Main WITH T : Main;
END_RESOURCE END_CONFIGURATION
ST
uptime
"$stepwise" serve "$folder/main.st" --state "$folder/state" --port 0 --real-time --core 1 --stats >"$folder/serve.txt" 2>&1 &
serve=$!
until grep -q serving "$folder/serve.txt"; do sleep 0.1; done
cyclictest -q -m -a 0 -t 1 -p 60 -i 1000 -D "$seconds"
kill -TERM $serve
wait $serve
cat "$folder/serve.txt"
