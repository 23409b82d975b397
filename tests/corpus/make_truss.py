#!/usr/bin/env python3
"""Writes truss.txt: reference values of the trusses, independent of the C++ code.

  make_truss.py > truss.txt

The shapes are laid out anew from their description in `epure list truss`. Every joint's two equations of equilibrium,
with the bars' forces and not their densities as unknowns, are solved with 100 digits and partial pivoting; where the
loads and the roller stand along the axes, they are solved once more in rationals, with densities, and must agree.
What is below 1e-60 of the loads is zero, and is so in rationals.
"""
from fractions import Fraction as Q

from mpmath import cos, matrix, lu_solve, mp, mpf, nstr, pi, sin, sqrt

mp.dps = 100
MOST_BARS = 31
STATED = dict(shape="roof", L="12", h="3", n="4", P="1000", W="0", beta="0", delta="0")


def mean(a, b):
    return tuple((x + y) / 2 for x, y in zip(a, b))


class Shape:
    """Joints by name, bars by the names of their ends in the order of their numbers."""

    def __init__(self, kind, L, h, n):
        self.at, self.bars, self.P, self.W = {"A": (Q(0), Q(0))}, [], [], []
        getattr(self, kind)(L, h, n)

    def join(self, *pairs):
        self.bars += [tuple(pair.split("-")) for pair in pairs]

    def posts(self, L, n, top, falls):
        name = lambda row, i: "A" if i == 0 else "B" if i == n else f"{row}{i}"
        self.at["B"] = (L, Q(0))
        for i in range(1, n):
            self.at[f"l{i}"], self.at[f"u{i}"] = (L * i / n, Q(0)), (L * i / n, top(i))
        for i in range(n):
            l0, l1, u0, u1 = name("l", i), name("l", i + 1), name("u", i), name("u", i + 1)
            self.join(f"{l0}-{l1}", f"{u0}-{u1}")
            if 0 < i < n - 1:
                self.join(f"{u0}-{l1}" if (i < n // 2) == falls else f"{l0}-{u1}")
            if i < n - 1:
                self.join(f"{l1}-{u1}")

    def roof(self, L, h, n):
        self.posts(L, n, lambda i: 2 * h * min(i, n - i) / n, True)
        self.P, self.W = [f"u{i}" for i in range(1, n)], [f"u{i}" for i in range(1, n // 2 + 1)]

    def pratt(self, L, h, n):
        self.posts(L, n, lambda i: h, True)
        self.P, self.W = [f"l{i}" for i in range(1, n)], ["u1"]

    def howe(self, L, h, n):
        self.posts(L, n, lambda i: h, False)
        self.P, self.W = [f"l{i}" for i in range(1, n)], ["u1"]

    def warren(self, L, h, n):
        low = lambda i: "A" if i == 0 else "B" if i == n else f"l{i}"
        self.at["B"] = (L, Q(0))
        for i in range(n):
            self.at[f"u{i}"] = (L * (2 * i + 1) / (2 * n), h)
            if i:
                self.at[f"l{i}"] = (L * i / n, Q(0))
        for i in range(n):
            self.join(f"{low(i)}-{low(i + 1)}", f"{low(i)}-u{i}", f"u{i}-{low(i + 1)}")
            if i < n - 1:
                self.join(f"u{i}-u{i + 1}")
        self.P, self.W = [low(i) for i in range(1, n)], ["u0"]

    def polonceau(self, L, h, n):
        A, B, T = (Q(0), Q(0)), (L, Q(0)), (L / 2, h)
        E = mean(A, T)
        # From E square to AT as far as the height h/6.
        step = (h / 6 - E[1]) / (-L / 2)
        foot = (E[0] + step * h, h / 6)
        self.at.update(B=B, T=T, E=E, G=mean(B, T), F=foot, H=(L - foot[0], h / 6))
        self.join("A-E", "E-T", "T-G", "G-B", "A-F", "E-F", "F-T", "F-H", "T-H", "H-G", "H-B")
        self.P, self.W = ["E", "T", "G"], ["E", "T"]

    def bracket(self, L, h, n):
        high = lambda i: "A" if i == 0 else f"u{i}"
        low = lambda i: "B" if i == 0 else f"u{n}" if i == n else f"l{i}"
        self.at["B"] = (Q(0), -h)
        for i in range(1, n + 1):
            self.at[f"u{i}"] = (L * i / n, Q(0))
            if i < n:
                self.at[f"l{i}"] = (L * i / n, -h + h * i / n)
        self.join("A-B")
        for i in range(n):
            self.join(f"{high(i)}-{high(i + 1)}", f"{low(i)}-{low(i + 1)}")
            if i < n - 1:
                self.join(f"{high(i)}-{low(i + 1)}", f"{high(i + 1)}-{low(i + 1)}")
        self.P, self.W = [f"u{i}" for i in range(1, n + 1)], [f"u{n}"]

    def crane(self, L, h, n):
        self.at.update(B=(-L / 2, Q(0)), C=(Q(0), h), D=(L, h + h / 3))
        self.join("A-B", "B-C", "A-C", "A-D", "C-D")
        self.P, self.W = ["D"], ["C"]


def along_axis(degrees):
    """cos and sin in rationals, where they are."""
    return {0: (1, 0), 1: (0, 1), 2: (-1, 0), 3: (0, -1)}.get(degrees / 90 % 4)


def gauss(rows):
    n = len(rows)
    for i in range(n):
        pivot = max(range(i, n), key=lambda k: abs(rows[k][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [x / rows[i][i] for x in rows[i]]
        for k in range(n):
            if k != i and rows[k][i] != 0:
                rows[k] = [x - rows[k][i] * y for x, y in zip(rows[k], rows[i])]
    return [row[-1] for row in rows]


def real(q):
    return mpf(q.numerator) / q.denominator


def values(given):
    number = {name: Q(value) for name, value in given.items() if name != "shape"}
    of = Shape(given["shape"], number["L"], number["h"], int(number["n"]))
    names = list(of.at)
    roller = number["delta"] + (0 if given["shape"] == "bracket" else 90)
    rad = lambda degrees: real(degrees) * pi / 180
    u, w = (cos(rad(roller)), sin(rad(roller))), (cos(rad(number["beta"])), sin(rad(number["beta"])))

    def system(coordinate, u, w, unit):
        """Rows of the equations, a column a bar, then A along x and y, then B, then what the loads leave."""
        rows = {(name, axis): [0] * (len(of.bars) + 4) for name in names for axis in (0, 1)}
        for column, (p, q) in enumerate(of.bars):
            d = [coordinate(of.at[q][axis]) - coordinate(of.at[p][axis]) for axis in (0, 1)]
            l = unit(d)
            for axis in (0, 1):
                rows[p, axis][column], rows[q, axis][column] = d[axis] / l, -d[axis] / l
        rows["A", 0][-4] = rows["A", 1][-3] = 1
        rows["B", 0][-2], rows["B", 1][-2] = u
        for name in of.P:
            rows[name, 1][-1] += coordinate(number["P"])
        for name in of.W:
            for axis in (0, 1):
                rows[name, axis][-1] -= coordinate(number["W"]) * w[axis]
        return list(rows.values())

    length = lambda d: sqrt(d[0] ** 2 + d[1] ** 2)
    rows = system(real, u, w, length)
    solved = lu_solve(matrix([row[:-1] for row in rows]), matrix([row[-1] for row in rows]))
    size = abs(real(number["P"])) + abs(real(number["W"]))
    found = [x if abs(x) > mpf(10) ** -60 * size else mpf(0) for x in solved]
    lengths = [length([real(of.at[q][axis] - of.at[p][axis]) for axis in (0, 1)]) for p, q in of.bars]
    exact_u, exact_w = along_axis(roller), along_axis(number["beta"])
    if number["W"] == 0:
        exact_w = (1, 0)
    if exact_u and exact_w:
        densities = gauss(system(Q, tuple(map(Q, exact_u)), tuple(map(Q, exact_w)), lambda d: Q(1)))
        for x, density, l in zip(found, densities, lengths + [1, 1, 1]):
            assert (x == 0) == (density == 0)
            assert abs(x - real(Q(density)) * l) <= mpf(10) ** -60 * size
    forces, (R_x, R_y, R_B) = found[:-3], found[-3:]
    v = {"R_A_x": R_x, "R_A_y": R_y, "R_A": sqrt(R_x ** 2 + R_y ** 2), "R_B": R_B}
    for i in range(MOST_BARS):
        v[f"N_{i + 1}"] = forces[i] if i < len(forces) else None
    v["N_max"], v["N_min"] = max(forces), min(forces)
    total = sum(N * l for N, l in zip(forces, lengths))
    v["sum_N_l"] = total if abs(total) > mpf(10) ** -60 * size * real(number["L"]) else mpf(0)
    return v


def text(value):
    if value is None:
        return "infinite"
    return "0" if value == 0 else nstr(value, 40, min_fixed=-40, max_fixed=40)


def tie_in_wind(W):
    return Q(nstr(values({**STATED, "W": str(W)})["N_1"], 50))


# The force of bar 1 is linear in the wind; the wind that makes it zero is a round number.
FREEING = Q(round(tie_in_wind(0) / (tie_in_wind(0) - tie_in_wind(1)) * 10 ** 9), 10 ** 9)
assert values({**STATED, "W": str(FREEING)})["N_1"] == 0

CASES = [
    ("stated", "the roof truss as it is stated", {}),
    ("king_post", "two panels: the king post", dict(n="2")),
    ("roof_in_wind", "wind square to the left rafter of 45°", dict(h="6", W="700", beta="-45", n="6")),
    ("roof_largest", "eight panels, the roller's plane inclined", dict(n="8", delta="20", L="17", h="22/7", P="313")),
    ("polonceau", "Polonceau's", dict(shape="polonceau", L="10", h="5/2")),
    ("polonceau_in_wind", "wind and an inclined roller", dict(shape="polonceau", W="400", beta="-60", delta="-30")),
    ("warren", "six panels", dict(shape="warren", n="6", L="18", h="2")),
    ("warren_odd", "three panels, no round number", dict(shape="warren", n="3", L="97/7", h="31/11", P="997/3", W="55",
                                                        beta="17", delta="13")),
    ("warren_largest", "eight panels: as many bars as there are", dict(shape="warren", n="8", L="24")),
    ("pratt", "six panels", dict(shape="pratt", n="6", h="2")),
    ("pratt_uplift", "the loads upwards", dict(shape="pratt", n="8", P="-250", W="100")),
    ("howe", "six panels", dict(shape="howe", n="6", h="2")),
    ("howe_inclined", "the roller's plane at 30°", dict(shape="howe", n="4", delta="30")),
    ("bracket", "four panels on a wall", dict(shape="bracket", L="3", h="2")),
    ("bracket_largest", "eight panels, side load", dict(shape="bracket", n="8", W="300", delta="-15")),
    ("crane", "derrick crane", dict(shape="crane", L="6", h="4")),
    ("crane_in_wind", "wind on its head", dict(shape="crane", W="-350", beta="3")),
    # Zero bars hit and missed. A side load on Pratt's joint u1 alone leaves its posts without force ...
    ("zero_posts", "the posts of a Pratt girder that nothing loads bear nothing", dict(shape="pratt", n="4", P="0",
                                                                                     W="100")),
    ("almost_zero_1e-9", "the same, with loads of 1e-9 N below", dict(shape="pratt", n="4", P="0.000000001", W="100")),
    # ... and this much wind takes from the first bar of the roof's tie all that the loads pull it with.
    ("wind_frees_tie", "the wind just takes the pull off the tie", dict(W=str(FREEING))),
    ("wind_misses_tie_1e-9", "wind off by 1e-9 N", dict(W=str(FREEING + Q(1, 10 ** 9)))),
    ("wind_misses_tie_1e-30", "wind off by 1e-30 N the other way", dict(W=str(FREEING - Q(1, 10 ** 30)))),
    ("almost_unstable", "the roller's line misses the hinge by 1e-9 deg", dict(n="2", delta="89.999999999")),
    ("balanced", "the wind lifts as much as the loads press: only a couple is left", dict(n="2", W="1000", beta="90",
                                                                                      shape="warren", P="1000")),
]

print("""# Reference values of the trusses, 40 digits. Written by make_truss.py with rationals and mpmath; do not edit by hand.
# Nothing here is taken from the C++ code.""")
for name, why, changed in CASES:
    given = {**STATED, **changed}
    print(f"\ncase {name}\nwhy {why}")
    print(f"choice shape {given['shape']}")
    for symbol, value in given.items():
        if symbol != "shape":
            print(f"given {symbol} {Q(value)}")
    for quantity, value in values(given).items():
        print(quantity, text(value))
