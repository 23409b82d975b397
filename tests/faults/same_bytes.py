"""The same bytes whatever is around: processors, clock, locale, time zone, home, fonts of the system, folder.

    python3 same_bytes.py PATH/TO/epure PATH/TO/libother_machine.so FOLDER_OF_SCENES

What is drawn, told and swept once is so again in each of these, and each run ends by itself.
"""

import hashlib
import os
import shutil
import subprocess
import sys
import tempfile

epure, library, scenes = (os.path.abspath(each) for each in sys.argv[1:4])
JOBS = [
    ["draw", "velocity-centre", "point-mass/table", "gear-pair/wheels", "--out", "o"],
    ["draw", "slider-crank-velocity/polodes", "--lang", "it", "--format", "eps", "--out", "o"],
    ["draw", scenes + "/trammel.yaml/velocities", "--format", "html", "--out", "o"],
    ["check", "slider-crank-velocity", "pin-in-slot", "truss", "--json"],
    ["class", "velocity-centre/velocities", "--count", "3", "--seed", "7", "--out", "o"],
    ["sweep", "slider-crank-velocity", "--over", "phi=0..360/721", "--quantity", "v_B,P0_x", "-o", "o/v_B.csv"],
    ["report", "velocity-centre", "-o", "o/report.tex"],
    ["mark", "slider-crank-velocity", "--answers", "answers.csv"],
]
LOCALES = ["it_IT", "de_DE", "tr_TR", "fa_IR"]
failures = 0


def run(environment, program=None, before=None):
    """By name, a digest of each file, and of what each job said."""
    shutil.rmtree("o", ignore_errors=True)
    with open("answers.csv", "w", encoding="utf-8") as file:
        file.write("number,v_B,r\n" + "".join(f"{n},{4 + n / 40},0.{20 + n % 5}\n" for n in range(40)))
    found = {}
    for job in JOBS:
        done = subprocess.run([program or epure] + job, env={**os.environ, **environment}, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, timeout=300, preexec_fn=before)
        found[" ".join(job[:2])] = (done.returncode, hashlib.sha1(done.stdout + done.stderr).hexdigest())
    for folder, _, names in os.walk("o"):
        for name in names:
            with open(os.path.join(folder, name), "rb") as file:
                found[os.path.join(folder, name)] = hashlib.sha1(file.read()).hexdigest()
    return found


def surroundings():
    """Words for each, its environment, and how else it is run."""
    for processors in range(1, 9):
        yield f"{processors} processors", {"LD_PRELOAD": library, "MACHINE_PROCESSORS": str(processors)}, {}
    yield "a clock that jumps", {"LD_PRELOAD": library, "MACHINE_CLOCK": "jumps"}, {}
    there = os.path.abspath("locales")
    os.mkdir(there)
    made = 0
    for locale in LOCALES:
        # 1: it was made, and something is to be warned of.
        if shutil.which("localedef") and subprocess.run(["localedef", "-i", locale, "-f", "UTF-8",
                                                         os.path.join(there, locale)], capture_output=True).returncode < 2:
            made += 1
            yield locale, {"LOCPATH": there, "LC_ALL": locale, "LANG": locale, "LANGUAGE": locale[:2]}, {}
    print(f"{made} of {len(LOCALES)} foreign locales could be made here")
    yield "a locale that is not there", {"LC_ALL": "xx_YY.UTF-8"}, {}
    yield "no locale, home or time zone", {"LC_ALL": "", "LANG": "", "HOME": "", "TZ": ""}, {}
    yield "another home, time zone and user", {"HOME": "/nonexistent", "TZ": "Pacific/Kiritimati", "USER": "x"}, {}
    with open("fonts.conf", "w", encoding="utf-8") as file:
        file.write("<?xml version='1.0'?><!DOCTYPE fontconfig SYSTEM 'fonts.dtd'><fontconfig></fontconfig>")
    yield "no fonts of the system", {"FONTCONFIG_FILE": os.path.abspath("fonts.conf")}, {}
    yield "no settings of fonts", {"FONTCONFIG_FILE": "/nonexistent", "FONTCONFIG_PATH": "/nonexistent"}, {}
    yield "settings of the libraries", {"HB_SHAPER_LIST": "fallback", "G_DEBUG": "", "SOURCE_DATE_EPOCH": "0",
                                       "FREETYPE_PROPERTIES": "cff:no-stem-darkening=0", "MALLOC_PERTURB_": "85"}, {}
    yield "a strict umask", {}, {"before": lambda: os.umask(0o077)}
    os.symlink(epure, "è un link")
    yield "by another name", {}, {"program": os.path.abspath("è un link")}
    os.mkdir("un'altra cartella")
    os.chdir("un'altra cartella")
    yield "in another folder", {}, {}


place = tempfile.mkdtemp()
os.chdir(place)
try:
    once = run({})
    for words, (code, _) in ((job, told) for job, told in once.items() if isinstance(told, tuple)):
        if code not in (0, 1):
            sys.exit(f"FAILED: {words} does not run by itself: exit {code}")
    count = 0
    for words, environment, how in surroundings():
        again = run(environment, **how)
        count += 1
        for name in sorted(set(once) | set(again)):
            if once.get(name) != again.get(name):
                failures += 1
                print(f"FAILED: {words}: {name} is another")
    print(f"{len(once)} files and outputs, the same in {count} surroundings")
finally:
    shutil.rmtree(place, ignore_errors=True)
sys.exit(1 if failures else 0)
