"""Nothing that fails harms a file: every n-th call of a kind fails in turn, runs are killed at random moments and kept
short of room, memory, descriptors and rights.

    python3 faults.py PATH/TO/epure PATH/TO/libfails_nth.so FOLDER_OF_SCENES [--stride N] [--kills N] [--seed S]

Before each run some files of the same names lie in the folder already. After it each file there is whole and new, or
the one that lay there, untouched; nothing else lies there but what a class that was interrupted takes up again, and,
of a run that was killed, drafts, which the next run takes away. Nothing is left where temporary files go. Exit 0 tells
that all is there. What could not be written is exit 3; a failed allocation inside of a library may end the process
by a signal.

--stride 1 walks over every call; a test takes larger steps.
"""

import argparse
import errno
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
    "eps": ["draw", "velocity-centre/velocities", "--format", "eps", "--out", "o"],
    "import": ["import", "M[J[R, P[0, 0], L[ground, L1]], J[R, P[3, 4], L[L1, L2]], J[R, P[9, 5], L[L2, L3]], "
                         "J[R, P[9, 0], L[ground, L3]]]", "-o", "o/mine.yaml"],
}
OWN = b"a file of somebody's own\n"
UNFINISHED = "unfinished.jsonl"  # where a class goes on
DRAFT = ".epure-"
TEMPORARY = "t"
# A bad disk, no memory, no right, no room, a quota that is used up.
ERRORS = [errno.EIO, errno.ENOMEM, errno.EACCES, errno.ENOSPC, errno.EDQUOT]
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
    return subprocess.run([epure] + JOBS[job], env={**os.environ, "TMPDIR": TEMPORARY, **(environment or {})},
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=120, **options)


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
    for name in os.listdir(TEMPORARY):
        os.remove(os.path.join(TEMPORARY, name))
        if not killed:
            fail(what, job, f"{name} is left in the folder of temporary files")
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
    chosen = set(range(1 + chance.randrange(stride), calls + 1, stride))
    if job == "import":  # whose last ones are those of writing a file
        chosen |= set(range(max(calls - 200, 1), calls + 1))
    for n in sorted(chosen):
        lay_there = some(whole, job)
        lay(lay_there)
        code = chance.choice(ERRORS)
        done = run(job, {**with_library, "FAILS_AT": str(n), "FAILS_ERRNO": str(code)})
        what = f"{kind} {n} of {calls} fails with {errno.errorcode[code]}"
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


def two_at_once(job, whole):
    lay([])
    two = [subprocess.Popen([epure] + JOBS[job], stdout=subprocess.DEVNULL) for _ in range(2)]
    codes = [each.wait() for each in two]
    ended["two into one folder", tuple(codes)] += 1
    judge("two at once", job, whole, [], 0)
    if codes != [0, 0]:
        fail("two at once", job, f"exits {codes}")


def full_device(job):
    if not os.path.exists("/dev/full"):
        return
    with open("/dev/full", "wb") as full:
        done = subprocess.run([epure] + JOBS[job], stdout=full, stderr=subprocess.PIPE)
    ended["/dev/full", done.returncode] += 1
    if done.returncode != 3:
        fail("/dev/full", job, f"exit {done.returncode}")


def sizes(low, high, count):
    """From one to the other, each as many times the one before."""
    return [round(low * (high / low) ** (k / (count - 1))) for k in range(count)]


def main():
    solutions = {job: whole_of(job) for job in JOBS}
    for job, (whole, output) in solutions.items():
        for kind in ("write", "fsync", "rename", "close"):
            fail_each(kind, job, whole, output, min(told.stride, 3))
        fail_each("open", job, whole, output, min(told.stride, 7))
        fail_each("mmap", job, whole, output, min(told.stride, 7))
        fail_each("malloc", job, whole, output, told.stride * 97)
    for k in range(4 * told.kills):  # some come too late
        if ended["kill", "killed"] >= told.kills:
            break
        job = list(JOBS)[k % len(JOBS)]
        kill(job, solutions[job][0])
    many = 4 if told.stride > 1 else 40
    for job in ("draw", "sweep", "page"):
        whole = solutions[job][0]
        short_of("bytes of a file", resource.RLIMIT_FSIZE, [0, 1] + sizes(10, 100_000, many), job, whole, (0, 3))
        short_of("open files", resource.RLIMIT_NOFILE, [4, 8, 16, 64] if many == 4 else range(3, 43), job, whole,
                 (0, 3, 127))
        short_of("bytes of memory", resource.RLIMIT_AS, sizes(32 << 20, 1 << 30, many), job, whole, (0, 3, 127))
        short_of("bytes of data", resource.RLIMIT_DATA, sizes(1 << 20, 1 << 28, many), job, whole, (0, 3, 127))
        not_to_be_written(job, whole)
    two_at_once("draw", solutions["draw"][0])
    full_device("check")
    for (what, how), count in sorted(ended.items(), key=str):
        print(f"{what:32} {str(how):10} {count:6}")


place = tempfile.mkdtemp()
os.chdir(place)
os.mkdir(TEMPORARY)
os.chmod(TEMPORARY, 0o777)
try:
    main()
finally:
    shutil.rmtree(place, ignore_errors=True)
sys.exit(1 if failures else 0)
