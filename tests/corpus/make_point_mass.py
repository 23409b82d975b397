#!/usr/bin/env python3
"""Writes point_mass.txt: reference values of the body under a force that depends on time, independent of the C++ code.

  make_point_mass.py > point_mass.txt

Integrals are Romberg's: trapezoids on halved strips, extrapolated until they are exact for these degrees. Extremes and
zeros are bracketed on a grid and bisected. Tables and polygons are summed strip by strip, with the tables' own words.
"""
from fractions import Fraction as Q

from mpmath import mp, mpf, nint, nstr

mp.dps = 260
STATED = dict(m="50", A="8/25", B="-52/5", C="80", t_1="5", t_2="14", t_3="20", dt="1/10", strip="1", cm_t="1",
              cm_a="1/2", cm_v="5", cm_s="50")
SECONDS = [i for i in range(1, 20) if i not in (5, 14)]


def real(q):
    return mpf(q.numerator) / q.denominator if isinstance(q, Q) else q


# Exact for polynomials up to degree nine, over fractions as over floating numbers.
def romberg(f, a, b, steps=5):
    table = []
    for k in range(steps):
        n = 2 ** k
        h = (b - a) / n
        row = [h * ((f(a) + f(b)) / 2 + sum((f(a + i * h) for i in range(1, n)), 0 * a))]
        for j in range(1, k + 1):
            row.append(row[j - 1] + (row[j - 1] - table[-1][j - 1]) / (4 ** j - 1))
        table.append(row)
    return table[-1][-1]


def crossings(f, end, points):
    """Where f changes its sign between 0 and end, and whether it falls."""
    found = []
    places = sorted({mpf(0), end, *[p for p in points if 0 < p < end]})
    for a, b in zip(places, places[1:]):
        inner = a + (b - a) * mpf(10) ** -200 if a == 0 else a
        fa, fb = f(inner), f(b)
        if fa == 0 or fb == 0 or (fa > 0) == (fb > 0):
            continue
        falls, lo, hi = fa > 0, inner, b
        for _ in range(1000):
            mid = (lo + hi) / 2
            if (f(mid) > 0) == falls:
                lo = mid
            else:
                hi = mid
        found.append((lo, falls))
    return found


def solve(given):
    g = {k: Q(v) for k, v in given.items()}
    m, end, dt = g["m"], g["t_3"], g["dt"]
    force = lambda t: (g["A"] * t * t + g["B"] * t + g["C"]) * t if isinstance(t, Q) else \
        (real(g["A"]) * t * t + real(g["B"]) * t + real(g["C"])) * t
    out = {}

    def motion(t):
        zero, mass = 0 * t, m if isinstance(t, Q) else real(m)
        q = romberg(force, zero, t)
        s = romberg(lambda x: (t - x) * force(x), zero, t) / mass
        return dict(F=force(t), a=force(t) / mass, v=q / mass, q=q, E=q * q / mass / 2, s=s)

    rows = int(end / dt)
    a = [force(i * dt) / m for i in range(rows + 1)]

    def bezout(y):
        Y = [Q(0)]
        for i in range(rows):
            Y.append(Y[i] + dt * (y[i] + y[i + 1]) / 2)
        return Y

    def simpson(y):
        Y = [Q(0)] * (rows + 1)
        Y[1] = dt * (5 * y[0] + 8 * y[1] - y[2]) / 12
        for i in range(rows - 1):
            Y[i + 2] = Y[i] + 2 * dt * (y[i] + 4 * y[i + 1] + y[i + 2]) / 6
        return Y

    tables = {}
    for name, rule in (("bezout", bezout), ("simpson", simpson)):
        v = rule(a)
        tables[name] = (v, rule(v))

    def columns(method, t):
        i = t / dt
        if t > end or i.denominator != 1:
            return None
        v, s = (column[int(i)] for column in tables[method])
        return dict(v=v, q=m * v, E=m * v * v / 2, s=s)

    for k in "123":
        t = g["t_" + k]
        at = motion(t)
        for name, value in at.items():
            out[f"{name}_{k}"] = value
        for method in tables:
            row = columns(method, t)
            for name in "vqEs":
                out[f"{name}_{method}_{k}"] = row and row[name]
                out[f"err_{name}_{method}_{k}"] = row and at[name] and (row[name] - at[name]) / at[name] if at[name] \
                    else None
        moment = romberg(lambda x: x * force(x), Q(0), t)
        out[f"t_centroid_{k}"] = moment / at["q"] if at["q"] else None

    T = real(end)
    slope = lambda t: 3 * real(g["A"]) * t * t + 2 * real(g["B"]) * t + real(g["C"])
    over_t = lambda t: real(g["A"]) * t * t + real(g["B"]) * t + real(g["C"])
    # Vertices of the parabolas part their zeros.
    vertex = lambda a2, a1: [real(-a1 / (2 * a2))] if a2 else []
    extremes = crossings(slope, T, vertex(3 * g["A"], 2 * g["B"]))
    zeros = crossings(over_t, T, vertex(g["A"], g["B"]))
    for name, falls in (("max", True), ("min", False)):
        here = [t for t, f in extremes if f == falls]
        out["t_F_" + name] = here[0] if here else None
        out["F_" + name] = force(here[0]) if here else None
        if here and abs(out["F_" + name]) < mpf(10) ** -150:
            out["F_" + name] = mpf(0)
    top = [t for t, f in zeros if f]
    at = motion(top[0]) if top else {}
    out["t_v_max"] = top[0] if top else None
    for name in "vqE":
        out[name + "_max"] = at.get(name)
    out["s_at_v_max"] = at.get("s")
    edges = [mpf(0)] + [t for t, _ in zeros] + [T]
    out["impulse_positive"] = out["impulse_negative"] = mpf(0)
    for lo, hi in zip(edges, edges[1:]):
        area = romberg(force, lo, hi)
        out["impulse_positive" if area > 0 else "impulse_negative"] += area

    for second in SECONDS:
        t = Q(second)
        at = motion(t) if t <= end else {}
        for name in "Fvs":
            out[f"table.{name}_at_{second}"] = at.get(name)
        for method in tables:
            row = columns(method, t)
            for name in "vs":
                out[f"table.{name}_{method}_at_{second}"] = row and row[name]

    cm = Q(1, 100)
    out["graphical.pole_distance_v"] = cm * g["cm_v"] / (g["cm_t"] * g["cm_a"])
    out["graphical.pole_distance_s"] = cm * g["cm_s"] / (g["cm_t"] * g["cm_v"])
    ends = [Q(0)]
    while ends[-1] < end:
        ends.append(min(ends[-1] + g["strip"], end))

    def polygon(means):
        corners = [Q(0)]
        for i, mean in enumerate(means):
            corners.append(corners[-1] + (ends[i + 1] - ends[i]) * mean)
        return corners

    def on(corners, t):
        i = max(k for k in range(len(ends) - 1) if ends[k] < t)
        return corners[i] + (corners[i + 1] - corners[i]) * (t - ends[i]) / (ends[i + 1] - ends[i])

    v = polygon([force((x + y) / 2) / m for x, y in zip(ends, ends[1:])])
    s = polygon([(x + y) / 2 for x, y in zip(v, v[1:])])
    for k in "123":
        out["graphical.v_" + k], out["graphical.s_" + k] = on(v, g["t_" + k]), on(s, g["t_" + k])
    return out


def text(value):
    if value is None:
        return "infinite"
    value = real(value) if isinstance(value, Q) else value
    if value == 0:
        return "0"
    if value == nint(value) and abs(value) < 10 ** 30:
        return str(int(value))
    return nstr(value, 40, min_fixed=-12, max_fixed=30, strip_zeros=True)


CASES = [
    ("stated", "the exercise as it is stated", {}),
    ("surds", "zeros and extremes that are no fractions; instants that are rows; strips that do not fill the interval",
     dict(A="3/10", B="-71/10", C="31", m="7", t_1="3/2", t_2="7", t_3="16", dt="1/4", strip="3")),
    ("no-zero", "the force only grows: nothing passes through zero and there are no extremes",
     dict(A="1/10", B="1", C="5", dt="1/2")),
    ("no-force", "nothing moves: no relative errors, no centroids", dict(A="0", B="0", C="0")),
    ("falling-line", "no cubic and no square term but one: the greatest velocity by a linear equation",
     dict(A="0", B="-4", C="30", t_1="1", t_2="5/2", t_3="12", dt="1/2", strip="1/2")),
    ("from-rest", "no linear term: the force begins with its square", dict(A="-1/2", B="5", C="0", t_3="19", dt="1")),
    ("against", "first backwards, then forwards: the velocity is least where the force is zero",
     dict(A="0", B="2", C="-14", t_1="1/3", t_2="8", t_3="25/2", dt="1/6", strip="5")),
    ("touching", "the force touches zero and stays positive: no greatest velocity, and a least force of zero",
     dict(A="1", B="-10", C="25", t_1="2", t_2="5", t_3="9")),
    ("nearly-touching", "the same missed by 1e-9, downwards",
     dict(A="1", B="-10", C="24999999999/1000000000", t_1="2", t_2="5", t_3="9")),
    ("hardly-touching", "the same missed by 1e-30, downwards",
     dict(A="1", B="-10", C=str(Q(25) - Q(1, 10 ** 30)), t_1="2", t_2="5", t_3="9")),
    ("not-touching", "the same missed by 1e-30, upwards",
     dict(A="1", B="-10", C=str(Q(25) + Q(1, 10 ** 30)), t_1="2", t_2="5", t_3="9")),
    ("there-and-back", "first backwards, then forwards, then braked: the zero that rises comes first",
     dict(A="-1/20", B="2", C="-10", t_1="9", t_2="20", t_3="36", dt="1/2", strip="2")),
    ("back-at-rest", "the body stands still at the second instant: no centroid, no relative error of the velocity",
     dict(A="0", B="-3", C="20", t_1="1", t_2="10", t_3="11", dt="1/2")),
]

print("""# Reference values of the body under a force that depends on time, 40 digits. Written by make_point_mass.py with exact
# fractions and mpmath, 260 working digits; do not edit by hand. Integrals by Romberg's extrapolation, zeros by
# bisection, tables and polygons strip by strip. Nothing here is taken from the C++ code.
#
# Givens in the exercise's units; values in SI units; infinite: what does not exist.""")
for name, why, changed in CASES:
    given = dict(STATED, **changed)
    print(f"\ncase {name}\nwhy {why}")
    for symbol, value in given.items():
        print(f"given {symbol} {value}")
    for quantity, value in solve(given).items():
        print(quantity, text(value))
