#!/usr/bin/env python3
"""Changes the programs of the examples in one place at a time and counts how many of the changes their TESTs notice.

  tests/examples/mutate.py build/dev/bin/stepwise projects/examples/motor projects/examples/agv
  tests/examples/mutate.py --count 40 --log survivors.txt build/dev/bin/stepwise projects/examples/*

Changed are comparisons, constants, NOT, AND and OR, TRUE and FALSE; plants only with --plants. A change that does not
compile is not counted. Works on a copy, in one process at low priority. Ends with 1 when a project is below --least.
"""
import argparse
import os
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

OPERATORS = [
    (r"<>", ["="]),
    (r">=", [">", "<"]),
    (r"<=", ["<", ">"]),
    (r"(?<![<:>=])=(?!>)", ["<>"]),
    (r"(?<![<=])>(?!=)", [">=", "<"]),
    (r"(?<!<)<(?![>=])", ["<=", ">"]),
    (r"\bAND NOT\b", ["AND"]),
    (r"\bAND\b", ["OR"]),
    (r"\bOR\b", ["AND"]),
    (r"\bNOT ", [""]),
    (r"\bTRUE\b", ["FALSE"]),
    (r"\bFALSE\b", ["TRUE"]),
]
NUMBER = r"(?<![\w#.%\[$])\d[\d_]*(\.\d[\d_]*)?(?![\w#.])"
DURATION = r"(?i)(?<=\bT#)\d+(\.\d+)?"
SILENT = r"//[^\n]*|\(\*.*?\*\)|'[^'\n]*'|\{[^}]*\}"  # comments, texts, attributes
HEADS = r"^[ \t]*(TYPE|PROGRAM|FUNCTION|FUNCTION_BLOCK|ACTION|STEP|CONFIGURATION|RESOURCE|TASK)\b[^\n]*"
DECLARATION = r"^[ \t]*VAR.*?END_VAR|^[ \t]*TYPE\b.*?END_TYPE"
WITHOUT_LOGIC = r"^CONFIGURATION.*?^END_CONFIGURATION"
PLANT = r"\{attribute 'simulation'\}.*?^END_(PROGRAM|FUNCTION_BLOCK|FUNCTION)"


def spans(pattern, text):
    return [m.span() for m in re.finditer(pattern, text, re.S | re.M)]


def larger(number):
    if "." in number:
        return str(round(float(number.replace("_", "")) * 1.1 + 0.3, 6))
    return str(int(number.replace("_", "")) + 1)


def longer(number):
    return larger(number) if "." in number else str(int(number) + max(1, int(number) // 4))


def declared_values(text):
    """In declarations only what follows := up to the end of its line is logic; types, addresses and bounds are not."""
    found = []
    for begin, end in spans(DECLARATION, text):
        found.append((begin, end, [(begin + m.start(), begin + m.end())
                                   for m in re.finditer(r":=[^;\n]*", text[begin:end])]))
    return found


def changes(text, with_plants):
    silent = spans(SILENT, text) + spans(HEADS, text) + spans(WITHOUT_LOGIC, text)
    if not with_plants:
        silent += spans(PLANT, text)
    declarations = declared_values(text)

    def counts(at):
        if any(a <= at < b for a, b in silent):
            return False
        return all(any(a <= at < b for a, b in values) for begin, end, values in declarations if begin <= at < end)

    for pattern, replacements in OPERATORS:
        for m in re.finditer(pattern, text):
            if counts(m.start()):
                yield from ((m.start(), m.end(), r) for r in replacements)
    for pattern, change in ((NUMBER, larger), (DURATION, longer)):
        for m in re.finditer(pattern, text):
            if counts(m.start()):
                yield m.start(), m.end(), change(m.group())


def limited(seconds):  # of processor time: on a busy machine the clock says nothing
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
    return limit


def caught(stepwise, project, seconds):  # recordings of what failed go beside the copy
    """True: a TEST failed, or it did not end; False: all passed; None: the change does not compile."""
    run = subprocess.run([stepwise, "test", project], capture_output=True, text=True, cwd=os.path.dirname(project),
                         preexec_fn=limited(seconds))
    if run.returncode == 0:
        return False
    return True if run.returncode < 0 or re.search(r"\d+ passed", run.stdout + run.stderr) else None


def describe(path, text, begin, end, replacement):
    line = text.count("\n", 0, begin)
    return f"{path}:{line + 1}: {text[begin:end]!r} -> {replacement!r}: {text.splitlines()[line].strip()}"


def measure(options, project, log):
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / project.name
        shutil.copytree(project, copy)
        found = []
        for path in sorted(copy.glob("src/**/*.st")):
            if path.name == "plant.st" and not options.plants:
                continue
            text = path.read_text()
            found += [(path, text, *change) for change in changes(text, options.plants)]
        random.Random(options.seed).shuffle(found)
        tried = noticed = 0
        for path, text, begin, end, replacement in found:
            if options.count and tried == options.count:
                break
            path.write_text(text[:begin] + replacement + text[end:])
            result = caught(os.path.abspath(options.stepwise), str(copy), options.seconds)
            path.write_text(text)
            if result is None:
                continue
            tried += 1
            noticed += result
            if not result:
                log.write(describe(f"{project.name}/{path.name}", text, begin, end, replacement) + "\n")
                log.flush()
    share = 100.0 * noticed / tried if tried else 100.0
    print(f"{project.name:20} {noticed:4} of {tried:4} noticed, {share:5.1f} %   ({len(found)} possible)", flush=True)
    return share


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("stepwise")
    parser.add_argument("projects", nargs="+", type=Path)
    parser.add_argument("--count", type=int, default=0, help="so many changes of each project, chosen at random; 0: all")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seconds", type=int, default=8, help="a change that takes more processor time counts as noticed")
    parser.add_argument("--least", type=float, default=85.0, help="percent")
    parser.add_argument("--log", default="-", help="file for the changes that nothing noticed")
    parser.add_argument("--plants", action="store_true", help="change the plants, too")
    options = parser.parse_args()
    os.nice(10)
    log = sys.stdout if options.log == "-" else open(options.log, "w")
    shares = [measure(options, project, log) for project in options.projects if (project / "src").is_dir()]
    sys.exit(1 if min(shares) < options.least else 0)


main()
