"""Deliberate mistakes, chosen at random over all rooms: which are caught, and by what?

    python3 mutate.py [--count N] [--seed S] [--under FOLDER] [--jobs N] [--results FILE]
    python3 mutate.py --list sheets.tsv

From the top of the checkout, which stays as it is. Each mistake changes one place of one line of a .cpp file: a
comparison, a sign, a product, a condition, a number. A folder of its own (build-mutants/) is built once, with shared
libraries, and its programs look every function up in libmutant.so first, which is empty. A mistake is one file compiled
into that library: nothing else is compiled or linked. (What a header defines is compiled into everybody's code, so
no mistakes are made there; nor in what is in a program itself.) Then, until something fails: `epure check all`,
`epure check scenes`, whether a sheet has changed (golden), the tests named like the file or its folder, all other tests,
the quick ones first. What takes far longer than it does without the mistake is caught too.

What does not compile, or compiles to the very same code, is drawn again. With --list the mistakes of a file are made
instead, a line each: the source, the text that stands there once, the wrong text, parted by tabs. Those of sheets.tsv
are in what sheets, pages and reports tell; `epure check` sees none of them.

Prints a line for each: seed, number in the seed's order, verdict, place, change; with --results they are kept in a file,
and those that stand in it are not tried again. ALIVE is a test that is wanting, or a change of nothing that can be seen.
Exits with 1 if fewer than 95 of 100 are caught.
"""

import argparse
import json
import os
import pathlib
import random
import re
import resource
import shlex
import signal
import subprocess
import sys
import threading
import time

parser = argparse.ArgumentParser()
parser.add_argument("--count", type=int, default=100)
parser.add_argument("--seed", type=int, default=1)
parser.add_argument("--under", type=pathlib.Path, default=pathlib.Path("."))
parser.add_argument("--jobs", type=int, default=1)
parser.add_argument("--results", type=pathlib.Path)
parser.add_argument("--list", type=pathlib.Path)
parser.add_argument("--build", type=pathlib.Path, default=pathlib.Path("build-mutants"))
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
ALONE = "without the rest of its folder the file does not compile"  # lacks an #include
NO_CHANGE = (ALONE, "does not compile", "same code")

top, build = pathlib.Path.cwd(), told.build.resolve()
QUICK = {"epure check all": [build / "bin/epure", "check", "all"],
         "epure check scenes": [build / "bin/epure", "check", "scenes"]}


def build_programs():
    folder = build / "mutant"
    empty = folder / "libmutant.so"
    if not empty.exists():
        folder.mkdir(parents=True, exist_ok=True)
        subprocess.run(["c++", "-shared", "-fPIC", "-Wl,-soname,libmutant.so", "-x", "c++", "-", "-o", empty], input=b"",
                       check=True)
    first = f"-Wl,--push-state,--no-as-needed {empty} -Wl,--pop-state -Wl,--enable-new-dtags,-rpath,{folder} -Wl,--copy-dt-needed-entries"
    subprocess.run(["cmake", "-S", ".", "-B", build, "-DBUILD_SHARED_LIBS=ON", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
                    f"-DCMAKE_EXE_LINKER_FLAGS={first}"], stdout=subprocess.DEVNULL, check=True)
    subprocess.run(["cmake", "--build", build], stdout=subprocess.DEVNULL, check=True)


def compilers():
    """For each source of a library: how it (or its folder as one) is compiled, and the library."""
    libraries = {path.stem: path for path in build.rglob("libepure_*.so")}
    found = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        target = re.search(r"/([\w-]+)\.dir/", entry["command"])[1]
        if "lib" + target not in libraries:
            continue
        compiled = pathlib.Path(entry["file"])
        sources = re.findall(r'^#include "(.*)"', compiled.read_text(), re.M) if "/Unity/" in entry["file"] else [compiled]
        words = shlex.split(entry["command"])
        command = words[:words.index("-o")]
        for source in sources:
            found[pathlib.Path(source).relative_to(top) if pathlib.Path(source).is_relative_to(top) else source] = (
                command, libraries["lib" + target])
    return found


def run(command, folder, seconds):
    """Whether it passes in this time, with the mistake that is in the folder."""
    started = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL,
                               cwd=folder, env={**os.environ, "LD_LIBRARY_PATH": str(folder)}, start_new_session=True)
    try:
        return started.wait(seconds) == 0
    except subprocess.TimeoutExpired:
        return False
    finally:
        try:
            os.killpg(started.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        started.wait()


def tests_that_pass():
    """Without a mistake: each test's command and the seconds it takes. Measured when the tests were built anew."""
    listing = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], capture_output=True, check=True)
    commands = QUICK | {test["name"]: test["command"] for test in json.loads(listing.stdout)["tests"]}
    kept = build / "mutant/seconds.json"
    if not kept.exists() or any(path.stat().st_mtime > kept.stat().st_mtime for path in (build / "bin").rglob("*")):
        seconds = {}
        for name, command in commands.items():
            begin = time.monotonic()
            if run(command, build / "mutant", 1800):
                seconds[name] = time.monotonic() - begin
            else:
                print(f"left out, as it fails without a mistake: {name}", flush=True)
        kept.write_text(json.dumps(seconds))
    return {name: (commands[name], seconds) for name, seconds in json.loads(kept.read_text()).items()}


def compiles(path, text, folder):
    source = folder / path.name
    source.write_text(text)
    command, _ = COMPILERS[path]
    return subprocess.run([*command, "-o", folder / "mutant.o", "-c", source], capture_output=True,
                          check=False).returncode == 0


def verdict(path, text, folder):
    if not compiles(path, text, folder):
        return "does not compile" if compiles(path, path.read_text(), folder) else ALONE
    wrong = (folder / "mutant.o").read_bytes()
    library = COMPILERS[path][1]
    subprocess.run(["c++", "-shared", folder / "mutant.o", library, f"-Wl,-soname,libmutant.so,-rpath,{library.parent}",
                    "-o", folder / "libmutant.so"], check=True)
    quick = [*QUICK, "golden"]
    near = sorted((name for name in TESTS if name not in quick),
                  key=lambda name: (name not in str(path), TESTS[name][1]))
    for name in quick + near:
        command, seconds = TESTS[name]
        if name == near[0]:
            compiles(path, path.read_text(), folder)
            if (folder / "mutant.o").read_bytes() == wrong:
                return "same code"
        if not run(command, folder, 60 + 5 * seconds):
            return name
    return "ALIVE"


def drawn_at_random():
    """In the order of the seed: a file, what it becomes, and the mistake in words."""
    places = []
    for room in ROOMS:
        for path in sorted(pathlib.Path(room).rglob("*.cpp")):
            if path not in COMPILERS or told.under not in (pathlib.Path("."), *path.parents):
                continue
            for number, line in enumerate(path.read_text().splitlines()):
                if not NO_CODE.search(line):
                    places += [(path, number, match.span(), new) for old, new in CHANGES
                               for match in re.finditer(old, line.split("//")[0])]
    random.Random(told.seed).shuffle(places)
    for path, number, (begin, end), new in places:
        lines = path.read_text().splitlines(keepends=True)
        before = lines[number]
        lines[number] = before[:begin] + new + before[end:]
        yield path, "".join(lines), f"{path}:{number + 1}\t{before.strip()}  =>  {lines[number].strip()}"


def listed():
    for line in told.list.read_text().splitlines():
        name, right, wrong = line.split("\t")
        path = pathlib.Path(name)
        text = path.read_text()
        if text.count(right) != 1:
            sys.exit(f"{path} has {text.count(right)} times: {right}")
        yield path, text.replace(right, wrong), f"{path}\t{right}  =>  {wrong}"


def followed(mistakes):
    """The verdict and the words of each, in order."""
    seed = str(told.list.name if told.list else told.seed)
    done = {}
    if told.results and told.results.exists():
        for line in told.results.read_text().splitlines():
            of, number, *rest = line.split("\t")
            if of == seed:
                done[int(number)] = rest
    lock, numbered = threading.Lock(), enumerate(mistakes)

    def follow(folder):
        folder.mkdir(exist_ok=True)
        while True:
            with lock:
                made = sum(how not in NO_CHANGE for how, *_ in done.values())
                number, (path, text, in_words) = next(numbered, (None, (None,) * 3))
            if number is None or (not told.list and made >= told.count):
                return
            if number in done and done[number][1:] == in_words.split("\t"):
                continue
            how = verdict(path, text, folder)
            with lock:
                done[number] = [how, *in_words.split("\t")]
                line = "\t".join([seed, str(number), how, in_words])
                print(line, flush=True)
                if told.results:
                    with told.results.open("a") as kept:
                        print(line, file=kept)

    threads = [threading.Thread(target=follow, args=(build / f"mutant/{job}",)) for job in range(told.jobs)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return [done[number] for number in sorted(done)]


resource.setrlimit(resource.RLIMIT_DATA, (4 << 30, 4 << 30))  # a mistake may ask for memory without end
build_programs()
COMPILERS = compilers()
TESTS = tests_that_pass()
hows = [how for how, *_ in followed(listed() if told.list else drawn_at_random()) if how not in NO_CHANGE]
if not told.list:
    hows = hows[:told.count]
alive = hows.count("ALIVE")
print(f"{len(hows) - alive} of {len(hows)} caught")
sys.exit(1 if alive * 100 > 5 * len(hows) else 0)
