"""How long and how much memory commands take that are known to be slow, and files of a megabyte.

    python3 measure.py PATH/TO/epure FOLDER_OF_SCENES [--limit SECONDS] [--megabytes] [--most MEGABYTES]

Processor time of commands.txt, or with --megabytes of files that megabyte.py makes; each is held to the limit (10 s) by
the kernel (RLIMIT_CPU), and to so much memory (RLIMIT_AS). A table of what they took; exit 1 tells that one took more,
or ended otherwise than with a code of the contract.
"""

import argparse
import os
import resource
import shlex
import shutil
import sys
import tempfile

import megabyte

parser = argparse.ArgumentParser()
parser.add_argument("epure")
parser.add_argument("scenes")
parser.add_argument("--limit", type=int, default=10)
parser.add_argument("--most", type=int, default=4096)
parser.add_argument("--megabytes", action="store_true")
told = parser.parse_args()
epure, scenes = os.path.abspath(told.epure), os.path.abspath(told.scenes)
here = os.path.dirname(os.path.abspath(__file__))


def known():
    with open(os.path.join(here, "commands.txt"), encoding="utf-8") as file:
        for line in file:
            words = shlex.split(line, comments=True)
            if words:
                yield [word.replace("docs:", scenes + "/") for word in words]


def limit():
    resource.setrlimit(resource.RLIMIT_CPU, (told.limit, told.limit))
    resource.setrlimit(resource.RLIMIT_AS, (told.most << 20, told.most << 20))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run(words):
    """Exit code, negative for a signal; seconds of processor time; MB at their most."""
    child = os.fork()
    if child == 0:
        limit()
        with open(os.devnull, "wb") as nothing:
            os.dup2(nothing.fileno(), 1)
            os.dup2(nothing.fileno(), 2)
        os.execv(epure, [epure] + words)
    _, status, used = os.wait4(child, 0)
    return os.waitstatus_to_exitcode(status), used.ru_utime + used.ru_stime, used.ru_maxrss / 1024


def main():
    failures = 0
    commands = list(megabyte.commands() if told.megabytes else known())
    print(f"{'s':>6} {'MB':>6} {'exit':>4}")
    for words in commands:
        code, seconds, megabytes = run(words)
        failed = code not in (0, 1, 2, 4)
        failures += failed
        print(f"{seconds:6.2f} {megabytes:6.0f} {code:4} {'FAILED ' if failed else ''}{shlex.join(words)[:150]}", flush=True)
        shutil.rmtree("o", ignore_errors=True)
    print(f"{len(commands)} commands, {failures} beyond the limit")
    return 1 if failures else 0


place = tempfile.mkdtemp()
os.chdir(place)
os.symlink(os.path.join(here, "scenes"), "scenes")
try:
    code = main()
finally:
    shutil.rmtree(place, ignore_errors=True)
sys.exit(code)
