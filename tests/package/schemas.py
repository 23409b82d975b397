"""What the program writes for other programs, against the schemas in docs/schema, by a validator that is not ours.

    python3 schemas.py PATH/TO/epure FOLDER_OF_SCHEMAS

The schemas let later versions add fields. Here each of their objects is closed, so that what is written and not
described is found too. Then documents broken on purpose: the schemas as they are published must refuse each.
"""

import copy
import glob
import json
import os
import subprocess
import sys
import tempfile
from fractions import Fraction

import yaml
from jsonschema import Draft202012Validator

program, folder = sys.argv[1], sys.argv[2]
failures = 0


def fail(sentence):
    global failures
    failures += 1
    print("FAILED:", sentence)


def output(*arguments):
    """What the program prints; checks may fail and sheets stay undrawn, which reports tell too."""
    ran = subprocess.run([program, *arguments], capture_output=True, text=True, encoding="utf-8")
    if ran.returncode not in (0, 1, 2, 4) or not ran.stdout:
        fail(f"epure {' '.join(arguments)}: exit {ran.returncode}, {ran.stderr.strip()}")
        return "{}"
    return ran.stdout


def closed(schema):
    """The same, where an object holds nothing but what is described."""
    if isinstance(schema, list):
        return [closed(each) for each in schema]
    if not isinstance(schema, dict):
        return schema
    tight = {key: closed(value) for key, value in schema.items()}
    if tight.get("type") == "object" and "properties" in tight:
        tight["additionalProperties"] = False
    return tight


def read(name):
    with open(f"{folder}/{name}.json", encoding="utf-8") as file:
        schema = json.load(file)
    Draft202012Validator.check_schema(schema)
    return schema


schemas = {name: read(name) for name in ("bench", "check", "list", "sweep")}
seen = set()  # fields met anywhere, by schema


def note_fields(name, document):
    if isinstance(document, dict):
        for key, value in document.items():
            seen.add((name, key))
            note_fields(name, value)
    elif isinstance(document, list):
        for each in document:
            note_fields(name, each)


def holds(name, document, what):
    note_fields(name, document)
    for error in list(Draft202012Validator(closed(schemas[name])).iter_errors(document))[:3]:
        fail(f"{what}: {'/'.join(map(str, error.absolute_path))}: {error.message[:200]}")


def refused(name, document, path, change, what):
    """The document with a change at the place that the path leads to."""
    broken = copy.deepcopy(document)
    place = broken
    for step in path:
        place = place[step]
    change(place)
    if Draft202012Validator(schemas[name]).is_valid(broken):
        fail(f"{name}: a document is let through {what}")


# Everything there is; a check with numbers measured; one at other givens; what is not drawn, or has no value.
list_all = json.loads(output("list", "--json"))
holds("list", list_all, "list --json")
list_one = json.loads(output("list", "slider-crank-velocity", "--json"))
holds("list", list_one, "list ID --json")
for mechanism in ("quick-return", "excavator-arm"):  # whose charts and ranges are named after quantities
    holds("list", json.loads(output("list", mechanism, "--json")), f"list {mechanism} --json")
check_all = json.loads(output("check", "all", "--json"))
holds("check", check_all, "check all --json")
measured = json.loads(output("check", "slider-crank-velocity", "--json", "--measured", "v_B=5", "--set", "r=1/7"))
holds("check", measured, "check --measured --json")
for givens in (["four-bar-analytic", "--set", "branch=right"], ["slider-crank-velocity", "--set", "phi=90deg"]):
    holds("check", json.loads(output("check", *givens, "--json")), " ".join(givens))
with tempfile.NamedTemporaryFile("w", suffix=".csv") as table:
    table.write("number,name,r\n17,Anna,25cm\n18,,\n")
    table.flush()
    rows = json.loads(output("check", "slider-crank-velocity", "--givens", table.name, "--json"))
holds("check", rows, "check --givens --json")
if [each["row"] for each in rows["exercises"]] != [{"number": "17", "name": "Anna"}, {"number": "18"}]:
    fail("check tells other rows than its table has")
sweeps = []
for arguments in (
    ["slider-crank-velocity", "--over", "phi=0deg..360deg/9", "--quantity", "v_B,P0_x"],
    ["four-bar-analytic", "--over", "branch=left|right", "--over", "A0A=0.1..2/5", "--quantity", "omega_4"],
):
    for line in output("sweep", *arguments, "--format", "json").splitlines():
        sweeps.append(json.loads(line))
        holds("sweep", sweeps[-1], " ".join(arguments))

# The bench is a program of its own; where it was not built, documents broken on purpose are tried on one typed here.
bench = {"schema": "epure.bench/1", "results": [{"family": "f", "number": "fast", "ns_per_result": 1.5,
         "max_relative_error": 1e-16, "max_relative_bound": None, "handed_over": 0}]}
if os.path.exists(os.path.join(os.path.dirname(os.path.realpath(program)), "epure-bench")):
    with tempfile.TemporaryDirectory() as drawn:
        bench = json.loads(output("bench", "--json", "--seconds", "0.001", "--out", drawn))
holds("bench", bench, "bench --json")

# What is told agrees with itself.
if [each["id"] for each in list_all["exercises"]] != [each["id"] for each in check_all["exercises"]]:
    fail("list and check tell other exercises")
if list_one["exercises"] != [each for each in list_all["exercises"] if each["id"] == "slider-crank-velocity"]:
    fail("list ID tells another exercise than list")
if list_all["epure"] != check_all["epure"]:
    fail("list and check tell other versions")
for exercise in list_all["exercises"] + check_all["exercises"] + measured["exercises"]:
    for given in exercise["givens"]:
        if "number" in given and float(Fraction(given["value"])) != given["number"]:
            fail(f"{exercise['id']}: {given['symbol']} = {given['value']} is not {given['number']}")
        if "choices" in given and given["value"] not in [choice["word"] for choice in given["choices"]]:
            fail(f"{exercise['id']}: {given['symbol']} is none of its words")
if not any(given.get("value") == "1/7" for given in measured["exercises"][0]["givens"]):
    fail("check tells another value than was set")

# Fields that would be described and never tried. Not here: what only an undecided or failing check has.
for field in (
    ("check", "audit"), ("check", "mistake"), ("check", "explanation"), ("check", "absent"), ("check", "measured"),
    ("check", "printed"), ("check", "on_sheet"), ("check", "also"), ("check", "row"), ("list", "choices"), ("list", "or"),
    ("sweep", "absent"), ("sweep", "impossible"), ("sweep", "number"),
):
    if field not in seen:
        fail(f"{field[1]} of {field[0]} was not met")

quantity = ["exercises", 0, "quantities", 0]
given = ["exercises", 0, "givens", 0]
for name, document, path, change, what in (
    ("check", check_all, [], lambda all: all.update(schema="epure.check/2"), "of another schema"),
    ("check", check_all, [], lambda all: all.pop("epure"), "without the version"),
    ("check", check_all, ["epure"], lambda it: it.update(version=1), "with a number for a version"),
    ("check", check_all, ["exercises"], lambda all: all.clear(), "without exercises"),
    ("check", check_all, quantity, lambda it: it.update(value="5.2"), "with a value that is text"),
    ("check", check_all, quantity, lambda it: it.pop("lower"), "without a bound"),
    ("check", check_all, quantity, lambda it: it.update(name="ω₃"), "with a name that is not ASCII"),
    ("check", check_all, given, lambda it: it.update(value=0.2), "with a given that is not exact"),
    ("check", check_all, given, lambda it: it.update(value="1/0"), "with a fraction of zero"),
    ("check", check_all, given, lambda it: it.update(number="0.2"), "with a given's number that is text"),
    ("check", measured, quantity, lambda it: it["routes"].append({"route": "mine"}), "with a route without value"),
    ("check", check_all, ["exercises", 0], lambda it: it.update(passed="yes"), "with passed that is text"),
    ("check", check_all, ["exercises", 0], lambda it: it.update(failures=[]), "with failures that are none"),
    ("list", list_all, [], lambda all: all.pop("exercises"), "without exercises"),
    ("list", list_all, ["exercises", 0], lambda it: it.update(id="Slider Crank"), "with an id that is none"),
    ("list", list_all, given, lambda it: it.pop("meaning"), "with a given without meaning"),
    ("list", list_all, given, lambda it: it.update(range="negative"), "with a range that is none"),
    ("list", list_all, quantity, lambda it: it.pop("unit"), "with a quantity without unit"),
    ("sweep", sweeps[0], [], lambda it: it.update(row=-1), "with a row before the first"),
    ("bench", bench, ["results"], lambda all: all.clear(), "without results"),
    ("bench", bench, ["results", 0], lambda it: it.update(number="slow"), "with a number that is none"),
    ("bench", bench, ["results", 0], lambda it: it.update(handed_over=-1), "with fewer than no cases"),
    ("bench", bench, ["results", 0], lambda it: it.pop("max_relative_bound"), "without a bound or null"),
    ("sweep", sweeps[0], ["quantities", "v_B"], lambda it: it.update(value=None), "with no value and no reason"),
    ("sweep", sweeps[0], ["givens", "phi"], lambda it: it.update(value=0), "with a given that is not exact"),
):
    refused(name, document, path, change, what)

# Scenes, which people write: an editor takes numbers for numbers, and keys for texts. What the schema refuses the program
# refuses too.
class AsEditorsRead(yaml.SafeLoader):
    """YAML 1.2: `on` is a word."""

    yaml_implicit_resolvers = {
        first: [(tag, found) for tag, found in resolvers if tag.endswith((":int", ":float", ":null"))]
        for first, resolvers in yaml.SafeLoader.yaml_implicit_resolvers.items()
    }


def with_texts_for_keys(tree):
    if isinstance(tree, dict):
        return {str(key): with_texts_for_keys(value) for key, value in tree.items()}
    return [with_texts_for_keys(each) for each in tree] if isinstance(tree, list) else tree


scene_schema = Draft202012Validator(read("scene"))
scene_keys = set()


def scene_errors(text):
    document = with_texts_for_keys(yaml.load(text, AsEditorsRead))
    if isinstance(document, dict):
        scene_keys.update(document)
    return [f"{'/'.join(map(str, error.absolute_path))}: {error.message[:200]}" for error in scene_schema.iter_errors(document)]


def is_read(text):
    with tempfile.NamedTemporaryFile("w", suffix=".yaml", encoding="utf-8") as file:
        file.write(text)
        file.flush()
        return subprocess.run([program, "list", file.name], capture_output=True).returncode == 0


scenes = sorted(glob.glob(os.path.join(folder, "..", "scenes", "*.yaml")))
if len(scenes) < 10:
    fail(f"{len(scenes)} scenes in docs/scenes")
for name in scenes:
    with open(name, encoding="utf-8") as file:
        for error in scene_errors(file.read())[:3]:
            fail(f"{os.path.basename(name)}: {error}")

four_bar = """epure: 1
id: four-bar
title: {en: Four-bar, it: Quadrilatero}
source: A book
units: {length: mm, angle: deg}
givens: {φ: 60 deg, r: {value: 120 mm, meaning: crank}}
where: {h: r/2 + 5 mm}
points: {B0: [400, 0], B: [360, 280]}
links:
  1: {A0: [0, 0], B0: [400, 0], g: {through: [0, h], along: 20 deg}}
  2: {A0 A: r}
  3: {A: [0, 0], B: [350, 0], P: [175, 100]}
  4: B0 B
drive: {link: 2, angle: 60, speed: 60 rpm, acceleration: 2 rad/s^2}
assembly: {B: left of A B0}
offsets: {e: P from g}
sheets: [velocities, velocity-polygon]
printed: [{quantity: omega_3, value: "-1.40", unit: rad/s, place: page 57, reading: 0.02}]
"""
for error in scene_errors(four_bar)[:3]:
    fail(f"a scene that has everything: {error}")
if not is_read(four_bar):
    fail("a scene that has everything is not read")
for before, after, what in (
    ("epure: 1", "epure: 2", "of another format"),
    ("id: four-bar\n", "", "without id"),
    ("id: four-bar", "id: ../four-bar", "with an id that leads elsewhere"),
    ("{en: Four-bar,", "{de: Viergelenk,", "in a third language"),
    ("source: A book", "source: [A book]", "with a list for a source"),
    ("length: mm", "length: parsec", "in parsecs"),
    ("r: {value: 120 mm,", "r: {", "with a given without value"),
    ("meaning: crank", "means: crank", "with an unknown key of a given"),
    ("where: {h: r/2 + 5 mm}", "where: [h]", "with a list of formulas"),
    ("B: [360, 280]}", "B: [360]}", "with one coordinate"),
    ("  1: {A0", "  frame: {A0", "with a link without number"),
    ("{through: [0, h], along: 20 deg}", "{through: [0, h]}", "with a line without direction"),
    ("{through: [0, h], along: 20 deg}", "{from: [0, h], along: 20 deg}", "with an unknown key of a line"),
    ("2: {A0 A: r}", "2: {A0 A C: r}", "with a bar of three points"),
    ("3: {A: [0, 0]", "3: {P12: [0, 0]", "with a point named as a centre"),
    ("drive: {link: 2, angle: 60, speed: 60 rpm, acceleration: 2 rad/s^2}\n", "", "without a drive"),
    ("{link: 2, angle: 60", "{angle: 60", "with a drive of nothing"),
    ("acceleration: 2 rad/s^2", "jerk: 2", "with an unknown key of a drive"),
    ("left of A B0", "above A B0", "with a side that is none"),
    ("P from g", "P of g", "with an offset that is none"),
    ("[velocities, velocity-polygon]", "[velocity]", "with a sheet that is none"),
    ("[velocities, velocity-polygon]", "[velocities, velocities]", "with a sheet twice"),
    ("value: \"-1.40\"", "value: about one", "with a printed number that is none"),
    ("unit: rad/s, ", "unit: rpm, ", "with a printed number in turns"),
    (", place: page 57", "", "with a printed number of no place"),
    ("offsets:", "offset:", "with an unknown key"),
):
    wrong = four_bar.replace(before, after, 1)
    if wrong == four_bar:
        fail(f"nothing is wrong of a scene {what}")
    if not scene_errors(wrong):
        fail(f"a scene is let through by its schema {what}")
    if is_read(wrong):
        fail(f"a scene is read {what}")
if missed := set(scene_schema.schema["properties"]) - scene_keys:
    fail(f"keys of a scene were not met: {missed}")

print("every document holds its schema" if failures == 0 else f"{failures} failures")
sys.exit(failures != 0)
