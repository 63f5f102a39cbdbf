#!/usr/bin/env python3
"""What the fuzz targets reach, by module: tests/fuzz/coverage.py [--missing] [--corpus FOLDER] [TARGET…]

Runs each built target (preset asan) over its seeds and what it has collected, without making new inputs, and adds up the
functions and branches (edges) it came through. A function counts as reached when any target reached it; of its branches those of
the target that came furthest count. --missing lists the functions that none of them reaches, by file.
"""
import argparse
import collections
import os
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
TARGETS = ["fuzz_lexer", "fuzz_parser", "fuzz_check", "fuzz_run", "fuzz_change", "fuzz_inside", "fuzz_messages", "fuzz_inputs", "fuzz_peers",
           "fuzz_panels"]
SEEDS = {  # of the others: texts
    "fuzz_messages": ["tests/projects/language_server/scripts", "tests/projects/debug_adapter/scripts"],
    "fuzz_peers": ["tests/fuzz/peers"],
    "fuzz_panels": ["tests/fuzz/panels"],
    "fuzz_inputs": [],  # those that test.sh makes
}
TEXTS = ["tests/fuzz/seeds", "tests/fuzz/findings", "tests/golden"]
FUNCTION = re.compile(r"^(UN)?COVERED_FUNC: hits: \d+ edges: (\d+)/(\d+) (.*?) (\S+?):(\d+)(?::\d+)?$")


def seeds_of(target: str, corpus: pathlib.Path) -> list[str]:
    folders = [str(corpus / target)] if (corpus / target).is_dir() else []
    folders += SEEDS.get(target, TEXTS)
    return folders


def reached_by(target: str, corpus: pathlib.Path) -> dict[tuple[str, str], tuple[int, int, str]]:
    """(file, line) -> edges reached, edges, name; functions of this project only."""
    environment = dict(os.environ, QT_QPA_PLATFORM="offscreen", ASAN_OPTIONS="detect_leaks=0")
    run = subprocess.run([f"build/asan/bin/{target}", "-runs=0", "-print_coverage=1", "-timeout=60", "-rss_limit_mb=6000"]
                         + seeds_of(target, corpus), cwd=ROOT, env=environment, capture_output=True, text=True, errors="replace")
    if run.returncode != 0:
        sys.exit(f"{target} ended with {run.returncode}:\n{run.stderr[-2000:]}")
    found = {}
    for line in (run.stderr + run.stdout).splitlines():
        match = FUNCTION.match(line.strip())
        if not match:
            continue
        _, reached, edges, name, path, number = match.groups()
        path = os.path.normpath(ROOT / "build/asan" / path)  # ccache makes paths relative to the build folder
        if path.startswith(f"{ROOT}/") and not path.startswith(f"{ROOT}/build/"):
            found[(path[len(f"{ROOT}/"):], number)] = (int(reached), int(edges), name)
    if not found:
        sys.exit(f"{target} printed no coverage; is llvm-symbolizer-19 in the PATH?")
    return found


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--missing", action="store_true", help="list the functions that no target reaches")
    arguments.add_argument("--corpus", type=pathlib.Path, default=ROOT / "build/fuzz_corpus")
    arguments.add_argument("targets", nargs="*", metavar="TARGET")
    asked = arguments.parse_args()
    targets = asked.targets or [each for each in TARGETS if (ROOT / "build/asan/bin" / each).exists()]
    if not targets:
        sys.exit("No fuzz target is built: cmake --preset asan && cmake --build --preset asan --target fuzz_targets")
    of_all: dict[tuple[str, str], tuple[int, int, str]] = {}
    by_target: dict[str, collections.Counter] = {}
    for target in targets:
        by_target[target] = collections.Counter()
        for place, (reached, edges, name) in reached_by(target, asked.corpus).items():
            module = str(pathlib.PurePath(place[0]).parent)
            by_target[target][module] += reached > 0
            of_all[place] = max(of_all.get(place, (0, 0, name)), (reached, edges, name))
    modules: dict[str, list[tuple[int, int]]] = collections.defaultdict(list)
    for (path, _), (reached, edges, _) in of_all.items():
        modules[str(pathlib.PurePath(path).parent)].append((reached, edges))
    print(f"{'module':44} {'functions':>13} {'branches':>15}   functions by target")
    for module, functions in sorted(modules.items()):
        hit = sum(reached > 0 for reached, _ in functions)
        taken, all_edges = sum(r for r, _ in functions), max(1, sum(e for _, e in functions))
        share = "  ".join(f"{each.removeprefix('fuzz_')} {by_target[each][module]}" for each in targets if by_target[each][module])
        print(f"{module:44} {hit:5}/{len(functions):<5}{100 * hit // len(functions):3}% {taken:6}/{all_edges:<6}{100 * taken // all_edges:3}%   {share}")
    if asked.missing:
        print("\nreached by none")
        missing = sorted((path, int(line), name) for (path, line), (reached, _, name) in of_all.items() if reached == 0)
        for path, line, name in missing:
            print(f"  {path}:{line}  {name}")


if __name__ == "__main__":
    main()
