"""Nothing that fails harms a file: every n-th call of a kind fails in turn, runs are killed at random moments and kept
short of room, memory, descriptors and rights.

    python3 faults.py PATH/TO/epure PATH/TO/libfails_nth.so FOLDER_OF_SCENES [--stride N] [--kills N] [--seed S]

Before each run some files of the same names lie in the folder already. After it each file there is whole and new, or
the one that lay there, untouched; nothing else lies there but what a class that was interrupted takes up again, and,
of a run that was killed, drafts, which the next run takes away. Exit 0 tells that all is there. What could not be
written is exit 3; a failed allocation inside of GLib or Pango may end the process by a signal.

--stride 1 walks over every call; a test takes larger steps.
"""

import argparse
import hashlib
import os
import random
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter

parser = argparse.ArgumentParser()
parser.add_argument("epure")
parser.add_argument("library")
parser.add_argument("scenes")
parser.add_argument("--stride", type=int, default=1)
parser.add_argument("--kills", type=int, default=1000)
parser.add_argument("--seed", type=int, default=1)
told = parser.parse_args()
chance = random.Random(told.seed)
epure, library, scenes = (os.path.abspath(each) for each in (told.epure, told.library, told.scenes))

JOBS = {
    "draw": ["draw", "velocity-centre", "--out", "o"],
    "draw a scene": ["draw", scenes + "/trammel.yaml", "--out", "o"],
    "check": ["check", "velocity-centre", "--json"],
    "class": ["class", "velocity-centre/velocities", "--count", "2", "--out", "o"],
    "sweep": ["sweep", "slider-crank-velocity", "--over", "phi=0..360/37", "--quantity", "v_B", "-o", "o/v_B.csv"],
    "page": ["report", "velocity-centre", "-o", "o/report.html"],
}
OWN = b"a file of somebody's own\n"
UNFINISHED = "unfinished.jsonl"  # where a class goes on
DRAFT = ".epure-"
failures = 0
ended = Counter()
takes = {}  # seconds


def fail(what, job, sentence):
    global failures
    failures += 1
    print(f"FAILED: {what}, {job}: {sentence}")


def files():
    found = {}
    for folder, _, names in os.walk("o"):
        for name in names:
            path = os.path.join(folder, name)
            with open(path, "rb") as file:
                found[os.path.relpath(path, "o")] = hashlib.sha1(file.read()).hexdigest()
    return found


def lay(names):
    shutil.rmtree("o", ignore_errors=True)
    os.mkdir("o")
    for name in names:
        with open(os.path.join("o", name), "wb") as file:
            file.write(OWN)


def run(job, environment=None, **options):
    return subprocess.run([epure] + JOBS[job], env={**os.environ, **(environment or {})}, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, timeout=120, **options)


def whole_of(job):
    lay([])
    began = time.time()
    done = run(job)
    takes[job] = time.time() - began
    if done.returncode != 0:
        sys.exit(f"{job} does not run by itself: {done.stderr.decode()}")
    return files(), done.stdout


def judge(what, job, whole, lay_there, code, killed=False):
    own = hashlib.sha1(OWN).hexdigest()
    found = files()
    for name, content in found.items():
        if content == whole.get(name) or (content == own and name in lay_there):
            continue
        if code != 0 and os.path.basename(name) == UNFINISHED:
            continue
        if killed and os.path.basename(name).startswith(DRAFT):
            continue
        fail(what, job, f"{name} is neither whole nor untouched")
    for name in lay_there:
        if name not in found:
            fail(what, job, f"{name} is lost")
    if code == 0 and any(found.get(name) != content for name, content in whole.items()):
        fail(what, job, "exit 0, and not all is there")


def some(names, job):
    return [] if job == "class" else [name for name in names if chance.random() < 0.5]


def fail_each(kind, job, whole, output, stride):
    with_library = {"LD_PRELOAD": library, "FAILS_WHAT": kind}
    lay([])
    run(job, {**with_library, "FAILS_COUNT": "count"})
    with open("count") as file:
        calls = int(file.read())
    for n in range(1 + chance.randrange(stride), calls + 1, stride):
        lay_there = some(whole, job)
        lay(lay_there)
        code = chance.choice([5, 12, 13, 28])
        done = run(job, {**with_library, "FAILS_AT": str(n), "FAILS_ERRNO": str(code)})
        what = f"{kind} {n} of {calls} fails with errno {code}"
        by_signal = kind in ("malloc", "mmap") and done.returncode < 0
        judge(what, job, whole, lay_there, done.returncode, killed=by_signal)
        ended[kind, "a signal" if by_signal else done.returncode] += 1
        # A font file or a setting that cannot be opened is done without, or is none to be had.
        if done.returncode not in (0, 3) and not by_signal:
            fail(what, job, f"exit {done.returncode}: {done.stderr.decode()}")
        if job == "check" and done.returncode == 0 and done.stdout != output:
            fail(what, job, "exit 0, and it says something else")


def kill(job, whole):
    lay_there = some(whole, job)
    lay(lay_there)
    process = subprocess.Popen([epure] + JOBS[job], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(chance.uniform(0, takes[job]))
    process.kill()
    code = process.wait()
    ended["kill", "too late" if code == 0 else "killed"] += 1
    judge("kill -9", job, whole, lay_there, code, killed=code != 0)
    if run(job).returncode != 0:
        fail("after kill -9", job, "it does not run again")
    judge("after kill -9", job, whole, [], 0)
    if any(os.path.basename(name).startswith(DRAFT) for name in files()):
        fail("after kill -9", job, "a draft stays")


def short_of(what, which, limits, job, whole, allowed):
    for limit in limits:
        lay_there = some(whole, job)
        lay(lay_there)
        done = run(job, preexec_fn=lambda: resource.setrlimit(which, (limit, limit)))
        judge(f"{what} {limit}", job, whole, lay_there, done.returncode, killed=done.returncode < 0)
        ended[what, done.returncode] += 1
        if done.returncode not in allowed:
            fail(f"{what} {limit}", job, f"exit {done.returncode}: {done.stderr.decode()}")


def as_nobody():
    if os.getuid() == 0:  # whom no rights keep out
        os.setgroups([])
        os.setgid(65534)
        os.setuid(65534)


def not_to_be_written(job, whole):
    lay(whole)
    os.chmod(".", 0o755)
    os.chmod("o", 0o555)
    done = run(job, preexec_fn=as_nobody)
    os.chmod("o", 0o755)
    ended["a folder that cannot be written", done.returncode] += 1
    judge("a folder that cannot be written", job, whole, list(whole), done.returncode)
    if done.returncode != 3:
        fail("a folder that cannot be written", job, f"exit {done.returncode}: {done.stderr.decode()}")


def surroundings(whole):
    """No home, no locale or another one, two runs into one folder at once, a full device."""
    for name, change in {"no HOME": {"HOME": ""}, "a foreign locale": {"LC_ALL": "de_DE.UTF-8"},
                         "a locale that is not there": {"LC_ALL": "xx_YY"}, "no TZ": {"TZ": ""}}.items():
        lay([])
        done = run("draw", change)
        ended[name, done.returncode] += 1
        judge(name, "draw", whole, [], done.returncode)
        if done.returncode != 0:
            fail(name, "draw", f"exit {done.returncode}")
    lay([])
    two = [subprocess.Popen([epure] + JOBS["draw"], stdout=subprocess.DEVNULL) for _ in range(2)]
    codes = [each.wait() for each in two]
    ended["two at once", tuple(codes)] += 1
    judge("two at once", "draw", whole, [], 0)
    if codes != [0, 0]:
        fail("two at once", "draw", f"exits {codes}")
    if os.path.exists("/dev/full"):
        with open("/dev/full", "wb") as full:
            done = subprocess.run([epure] + JOBS["check"], stdout=full, stderr=subprocess.PIPE)
        ended["/dev/full", done.returncode] += 1
        if done.returncode != 3:
            fail("/dev/full", "check", f"exit {done.returncode}")


def main():
    solutions = {job: whole_of(job) for job in JOBS}
    for job, (whole, output) in solutions.items():
        for kind in ("write", "fsync", "rename", "close"):
            fail_each(kind, job, whole, output, min(told.stride, 3))
        fail_each("open", job, whole, output, min(told.stride, 7))
        fail_each("mmap", job, whole, output, min(told.stride, 7))
        fail_each("malloc", job, whole, output, told.stride * 97)
    for k in range(told.kills):
        job = list(JOBS)[k % len(JOBS)]
        kill(job, solutions[job][0])
    draw = solutions["draw"][0]
    short_of("bytes of a file", resource.RLIMIT_FSIZE, [0, 1, 1000, 20_000, 60_000], "draw", draw, (0, 3))
    short_of("open files", resource.RLIMIT_NOFILE, [4, 8, 16, 64], "draw", draw, (0, 3, 127))
    short_of("bytes of memory", resource.RLIMIT_AS, [2**k for k in range(25, 31)], "draw", draw,
             (0, 3, 127))
    surroundings(draw)
    for job in ("draw", "sweep", "page"):
        not_to_be_written(job, solutions[job][0])
    for (what, how), count in sorted(ended.items(), key=str):
        print(f"{what:32} {str(how):10} {count:6}")


place = tempfile.mkdtemp()
os.chdir(place)
try:
    main()
finally:
    shutil.rmtree(place, ignore_errors=True)
sys.exit(1 if failures else 0)
