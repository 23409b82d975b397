"""Deliberate mistakes, chosen at random over all rooms: which are caught, and by what?

    python3 mutate.py [--count N] [--seed S] [--under FOLDER] [--headers]

From the top of a clean checkout that was built (build/, with tests). Each mistake changes one place of one line: a
comparison, a sign, a product, a condition, a number. The program is built with it and `epure check all` asked; if that
passes, all tests are built and run until one fails. What does not compile is drawn again. A mistake in a header may
compile half of the program anew: without --headers only those in .cpp files are made.

Prints a line for each: caught by what, or ALIVE; what is alive is a test that is wanting, or changes nothing that can
be seen. Exits with 1 if fewer than 95 of 100 are caught.
"""

import argparse
import pathlib
import random
import re
import subprocess
import sys

parser = argparse.ArgumentParser()
parser.add_argument("--count", type=int, default=100)
parser.add_argument("--seed", type=int, default=1)
parser.add_argument("--under", default=".")
parser.add_argument("--headers", action="store_true")
told = parser.parse_args()
chance = random.Random(told.seed)

ROOMS = ("geometry", "drawings", "exercises")
CHANGES = [
    (r" < ", " <= "), (r" <= ", " < "), (r" > ", " >= "), (r" >= ", " > "), (r" == ", " != "), (r" != ", " == "),
    (r" \+ ", " - "), (r" - ", " + "), (r" \* ", " / "), (r" && ", " || "), (r" \|\| ", " && "),
    (r"\btrue\b", "false"), (r"\bfalse\b", "true"), (r"\bsine\b", "cosine"), (r"\bcosine\b", "sine"),
    (r"Sign::positive", "Sign::negative"), (r"Sign::negative", "Sign::positive"), (r"\.x\b", ".y"), (r"\.y\b", ".x"),
    (r"quarter_turn\(", "-quarter_turn("), (r"(?<![\w.])2(?![\w.])", "3"), (r"(?<![\w.])1(?![\w.])", "2"),
]
NO_CODE = re.compile(r'^\s*(//|#|using |template|static_assert|assert\()|"')  # sentences are for the eye


def places():
    """Every change that could be made: file, line, where in it, the change."""
    found = []
    for room in ROOMS:
        for path in sorted(pathlib.Path(room).rglob("*.*")):
            if path.suffix not in ((".cpp", ".h") if told.headers else (".cpp",)):
                continue
            if pathlib.Path(told.under) not in (pathlib.Path("."), *path.parents):
                continue
            for number, line in enumerate(path.read_text().splitlines()):
                code = line.split("//")[0]
                if NO_CODE.search(line):
                    continue
                found += [(path, number, match.span(), new) for old, new in CHANGES
                          for match in re.finditer(old, code)]
    return found


def passes(command, seconds):
    try:
        return subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                              timeout=seconds, check=False).returncode == 0
    except subprocess.TimeoutExpired:
        return False


def caught_by():
    """None: it does not compile."""
    build = ["cmake", "--build", "build", "--target"]
    if not passes(build + ["epure"], 3600):
        return None
    if not passes(["build/bin/epure", "check", "all"], 300):
        return "epure check all"
    if not passes(build + ["all"], 3600):
        return None
    tests = subprocess.run(["ctest", "--test-dir", "build", "--stop-on-failure", "--timeout", "900"],
                           capture_output=True, text=True, check=False)
    failed = re.findall(r"^\s*\d+ - (\S+) \((?:Failed|Timeout|SEGFAULT|Subprocess.*)\)", tests.stdout, re.M)
    return ", ".join(failed) if failed else "ALIVE" if tests.returncode == 0 else "ctest"


def main():
    if subprocess.run(["git", "status", "--porcelain", *ROOMS], capture_output=True, text=True, check=True).stdout:
        sys.exit("there are changes in the checkout that are not committed")
    all_places = places()
    made = alive = 0
    while made < told.count:
        path, number, (begin, end), new = chance.choice(all_places)
        text = path.read_text()
        lines = text.splitlines(keepends=True)
        before = lines[number]
        lines[number] = before[:begin] + new + before[end:]
        path.write_text("".join(lines))
        try:
            how = caught_by()
        finally:
            path.write_text(text)
        if how is None:
            continue
        made += 1
        alive += how == "ALIVE"
        print(f"{how:24} {path}:{number + 1}: {before.strip()}  =>  {lines[number].strip()}", flush=True)
    print(f"{made - alive} of {made} caught")
    return 1 if (made - alive) * 100 < 95 * made else 0


sys.exit(main())
