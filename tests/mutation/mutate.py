"""Deliberate mistakes, chosen at random over all rooms: which are caught, and by what?

    python3 mutate.py [--count N] [--seed S] [--under FOLDER] [--headers]
    python3 mutate.py --list sheets.tsv

From the top of a clean checkout that was built (build/, with tests). Each mistake changes one place of one line: a
comparison, a sign, a product, a condition, a number. The program is built with it and `epure check all` asked; if that
passes, whether a sheet has changed (tests/golden); then all tests are built and run until one fails. What does not compile is drawn again. A mistake in a header may
compile half of the program anew: without --headers only those in .cpp files are made.

With --list the mistakes of a file are made instead, a line each: the source, the text that stands there once, the wrong
text, parted by tabs. Those of sheets.tsv are in what sheets, pages and reports tell; `epure check` sees none of them.

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
parser.add_argument("--list", type=pathlib.Path)
told = parser.parse_args()

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
    if not passes(build + ["golden"], 3600):
        return None
    if not passes(["ctest", "--test-dir", "build", "-R", "^golden$"], 300):
        return "golden"
    if not passes(build + ["all"], 3600):
        return None
    tests = subprocess.run(["ctest", "--test-dir", "build", "--stop-on-failure", "--timeout", "900"],
                           capture_output=True, text=True, check=False)
    failed = re.findall(r"^\s*\d+ - (\S+) \((?:Failed|Timeout|SEGFAULT|Subprocess.*)\)", tests.stdout, re.M)
    return ", ".join(failed) if failed else "ALIVE" if tests.returncode == 0 else "ctest"


def drawn_at_random():
    """Without end: a file and what it becomes, and the mistake in words."""
    chance, all_places = random.Random(told.seed), places()
    while True:
        path, number, (begin, end), new = chance.choice(all_places)
        lines = path.read_text().splitlines(keepends=True)
        before = lines[number]
        lines[number] = before[:begin] + new + before[end:]
        yield path, "".join(lines), f"{path}:{number + 1}: {before.strip()}  =>  {lines[number].strip()}"


def listed():
    for line in told.list.read_text().splitlines():
        name, right, wrong = line.split("\t")
        path = pathlib.Path(name)
        text = path.read_text()
        if text.count(right) != 1:
            sys.exit(f"{path} has {text.count(right)} times: {right}")
        yield path, text.replace(right, wrong), f"{path}: {right}  =>  {wrong}"


def main():
    if subprocess.run(["git", "status", "--porcelain", *ROOMS], capture_output=True, text=True, check=True).stdout:
        sys.exit("there are changes in the checkout that are not committed")
    made = alive = 0
    for path, wrong, in_words in listed() if told.list else drawn_at_random():
        text = path.read_text()
        path.write_text(wrong)
        try:
            how = caught_by()
        finally:
            path.write_text(text)
        if how is None:
            if told.list:
                print(f"{'does not compile':24} {in_words}", flush=True)
            continue
        made += 1
        alive += how == "ALIVE"
        print(f"{how:24} {in_words}", flush=True)
        if not told.list and made == told.count:
            break
    print(f"{made - alive} of {made} caught")
    return 1 if (made - alive) * 100 < 95 * made else 0


sys.exit(main())
