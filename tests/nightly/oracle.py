"""Random mechanisms and gear pairs against mpmath: `epure sweep` finds each quantity by two routes and bounds it, and
the bounds must hold what is calculated here, from closure equations of its own, with 110 digits. A third of the crank's
places are special ones, hit or missed by 1e-3 to 1e-40 degrees.

    python3 oracle.py PATH/TO/epure [--machines N] [--seed S] [--one-in N]

Of every row the routes must agree within bounds of four units in the last place; one row in so many is calculated here
too. A night of a million:

    seq 100 | parallel -j2 python3 tests/nightly/oracle.py build/bin/epure --machines 10000 --seed {} --one-in 10

Prints how many machines there were, how many numbers had two routes, how many of them were held against what is
calculated here, and the causes of what could not be decided. Exits with 1 where a number
lies outside its bounds, routes contradict each other, bounds are wider than four units in the last place, or more than
one number in 100,000 is undecided.
"""

import argparse
import json
import random
import subprocess
import sys
from collections import Counter

from mpmath import acos, cos, fabs, findroot, mp, mpf, pi, sin, sqrt, tan

mp.dps = 110

parser = argparse.ArgumentParser()
parser.add_argument("epure")
parser.add_argument("--machines", type=int, default=1000)
parser.add_argument("--seed", type=int, default=1)
parser.add_argument("--one-in", type=int, default=1)
told = parser.parse_args()
chance = random.Random(told.seed)


def number(text):
    """As epure reads it: a decimal or a fraction."""
    above, _, below = text.partition("/")
    return mpf(above) / mpf(below) if below else mpf(above)


def decimal(low, high, places):
    return f"{chance.uniform(low, high):.{places}f}"


def crank_angles(count):
    """In degrees, as text."""
    angles = []
    for _ in range(count):
        if chance.random() < 1 / 3:
            power = chance.randint(3, 40)
            missed = chance.choice(["", "0." + "0" * (power - 1) + "1"])
            special = chance.choice(["0", "90", "180", "270"])
            if special == "0" and power > 12:  # smaller angles than that are refused
                missed = ""
            angles.append(special + missed[1:] if missed else special)
        else:
            angles.append(decimal(-360, 360, chance.randint(0, 9)))
    return sorted(set(angles))


class SliderCrank:
    exercise = "slider-crank-velocity"
    quantities = ["B_x", "omega_3", "v_B_x", "P0_x", "P0_y"]
    units = {"r": "m", "l": "m", "e": "m", "n": "rpm", "phi": "deg", "BC": "m", "AC": "m"}

    def families(self):
        r = sorted({decimal(0.05, 0.5, chance.randint(1, 6)) for _ in range(5)})
        return {"r": r, "l": sorted({decimal(0.3, 2, chance.randint(1, 6)) for _ in range(5)}),
                "e": sorted({decimal(-0.1, 0.1, 4) for _ in range(2)}), "n": ["360"], "phi": crank_angles(20),
                "BC": ["2"], "AC": ["2"]}  # a plate on any coupler

    def at(self, given):
        r, l, e = given["r"], given["l"], given["e"]
        omega, phi = given["n"] * pi / 30, given["phi"] * pi / 180
        height = e - r * sin(phi)
        if l < fabs(height):
            return None
        along = sqrt(l * l - height * height)
        if along == 0:
            return {}
        found = {"B_x": r * cos(phi) + along, "omega_3": -omega * r * cos(phi) / along}
        found["v_B_x"] = -omega * r * sin(phi) - found["omega_3"] * height
        if given["phi"] % 180 != 90:
            found["P0_x"] = found["B_x"]
            found["P0_y"] = found["B_x"] * tan(phi)
        return found


class FourBar:
    exercise = "four-bar-analytic"
    quantities = ["B_x", "B_y", "omega_3", "omega_4", "v_B"]
    units = {"A0A": "m", "AB": "m", "B0B": "m", "A0B0": "m", "n": "rpm", "phi": "deg"}

    def families(self):
        return {"A0A": sorted({decimal(0.1, 0.4, chance.randint(1, 6)) for _ in range(4)}),
                "AB": sorted({decimal(0.3, 1.2, chance.randint(1, 6)) for _ in range(4)}),
                "B0B": sorted({decimal(0.3, 1.2, chance.randint(1, 6)) for _ in range(4)}),
                "A0B0": [decimal(0.5, 1, 3)], "n": ["400"], "phi": crank_angles(15)}

    def at(self, given):
        r, l, c, d = given["A0A"], given["AB"], given["B0B"], given["A0B0"]
        omega, phi = given["n"] * pi / 30, given["phi"] * pi / 180
        A = mp.mpc(r * cos(phi), r * sin(phi))
        diagonal = fabs(d - A)
        cosine = (l * l + diagonal * diagonal - c * c) / (2 * l * diagonal)
        if fabs(cosine) > 1:
            return None
        # B left of AB0: AB turned counter-clockwise from AB0.
        B = A + l * (d - A) / diagonal * mp.expj(acos(cosine))
        AB, B0B = B - A, B - d
        across = AB.real * B0B.imag - AB.imag * B0B.real
        if fabs(across) < mpf(10) ** -50:  # in line; the root of what 110 digits leave of zero has 55
            return {}
        v_A = 1j * omega * A
        omega_4 = -(v_A.real * AB.real + v_A.imag * AB.imag) / across
        v_B = 1j * omega_4 * B0B
        return {"B_x": B.real, "B_y": B.imag, "omega_4": omega_4, "omega_3": ((v_B - v_A) / (1j * AB)).real,
                "v_B": fabs(v_B)}


class Gears:
    exercise = "gear-pair"
    quantities = ["contact_ratio", "centre_distance", "working_pressure_angle_deg"]
    units = {"z1": "", "z2": "", "x1": "", "x2": "", "alpha": "deg", "m": "mm"}

    def families(self):
        return {"z1": sorted({str(chance.randint(8, 40)) for _ in range(4)}),
                "z2": sorted({str(chance.randint(20, 120)) for _ in range(4)}),
                "x1": sorted({decimal(-0.2, 0.6, 3) for _ in range(3)} | {"0"}),
                "x2": sorted({decimal(-0.2, 0.4, 3) for _ in range(2)} | {"0"}),
                "alpha": sorted({decimal(15, 28, chance.randint(0, 4)) for _ in range(3)}), "m": [decimal(1, 12, 1)]}

    def at(self, given):
        z1, z2, x1, x2 = (given[name] for name in ("z1", "z2", "x1", "x2"))
        m, alpha = given["m"] / 1000, given["alpha"] * pi / 180
        involute = tan(alpha) - alpha + 2 * tan(alpha) * (x1 + x2) / (z1 + z2)
        if involute <= 0:
            return {}
        working = alpha if x1 + x2 == 0 else findroot(lambda a: tan(a) - a - involute, alpha)
        base = [m * z * cos(alpha) / 2 for z in (z1, z2)]
        tip = [m * (z / 2 + 1 + x) for z, x in ((z1, x1), (z2, x2))]
        if any(t < b for t, b in zip(tip, base)):
            return {}
        contact = sum(sqrt(t * t - b * b) - b * tan(working) for t, b in zip(tip, base))
        return {"contact_ratio": contact / (pi * m * cos(alpha)),
                "centre_distance": m * (z1 + z2) / 2 * cos(alpha) / cos(working),
                "working_pressure_angle_deg": working * 180 / pi}


counted = Counter()
undecided = Counter()
failures = 0


def fail(kind, row, sentence):
    global failures
    failures += 1
    print(f"FAILED: {kind.exercise} {row['givens']}: {sentence}")


def agree(kind, row, name, told_of):
    """Whether there is a number: both routes found it, within narrow bounds."""
    if "disagreement" in told_of:
        fail(kind, row, f"{name}: {told_of['disagreement']}")
    elif "undecided" in told_of:
        undecided[told_of["undecided"]] += 1
    elif told_of["value"] is not None:
        lower, value, upper = (float(told_of[each]) for each in ("lower", "value", "upper"))
        if not lower <= value <= upper or upper - lower > 4 * abs(value) * 2 ** -52:
            fail(kind, row, f"{name}: [{lower}, {upper}] is too wide")
        counted["numbers"] += 1
        return True
    return False


def hold(kind, row, name, told_of, mine):
    if told_of.get("value", 0) is None:
        if mine and name in mine:
            fail(kind, row, f"{name} has a value, {mp.nstr(mine[name], 20)}")
    elif mine is None:
        fail(kind, row, f"{name} has none: it does not close")
    elif name in mine:
        lower, upper = mpf(told_of["lower"]), mpf(told_of["upper"])
        rounded = fabs(mine[name]) * mpf(10) ** -90 + mpf(10) ** -95
        if not lower - rounded <= mine[name] <= upper + rounded:
            fail(kind, row, f"{name} = {mp.nstr(mine[name], 25)} is not in [{lower}, {upper}]")
        counted["held"] += 1


def sweep(kind):
    """As many machines as the lists give together; `phi` makes no machine of its own."""
    families = kind.families()
    command = [told.epure, "sweep", kind.exercise, "--quantity", ",".join(kind.quantities), "--format", "json"]
    machines = 1
    for name, values in families.items():
        unit = kind.units[name]
        if len(values) == 1:
            command += ["--set", f"{name}={values[0]}{unit}"]
        else:
            command += ["--over", f"{name}=" + "|".join(value + unit for value in values)]
        if name != "phi":
            machines *= len(values)
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 2, 4):
        fail(kind, {"givens": command}, f"exit {done.returncode}: {done.stderr}")
    fixed = {name: number(values[0]) for name, values in families.items() if len(values) == 1}
    for line in done.stdout.splitlines():
        row = json.loads(line)
        is_held = chance.randrange(told.one_in) == 0
        if is_held:
            mine = kind.at({**fixed, **{name: number(each["value"]) for name, each in row["givens"].items()}})
        for name, told_of in row["quantities"].items():
            has_number = agree(kind, row, name, told_of)
            if is_held and (has_number or told_of.get("value", 0) is None):
                hold(kind, row, name, told_of, mine)
    return machines


while counted["machines"] < told.machines:
    counted["machines"] += sweep(chance.choice([SliderCrank(), FourBar(), Gears()]))
print(f"{counted['machines']} machines, {counted['numbers']} numbers by two routes, {counted['held']} held, "
      f"{sum(undecided.values())} undecided")
for cause, count in undecided.most_common(20):
    print(f"{count:8} {cause}")
sys.exit(1 if failures or sum(undecided.values()) * 100_000 > counted["numbers"] else 0)
