#!/usr/bin/env python3
"""Writes change_points.txt: how four-bar linkages leave their change points, independent of the C++ code.

Only positions are written down here: B where circles about A and B0 meet, on the left of A -> B0 after the change point
and on the right before it, or the other way round. The angles of coupler and rocker are differentiated numerically
through the change point (mpmath.diff); that they are smooth there is checked by one derivative from each side.
Usage: make_change_points.py > change_points.txt
"""
from fractions import Fraction
from itertools import product

from mpmath import arg, diff, expj, mp, mpc, mpf, nstr, sqrt, workprec

mp.dps = 200
DIGITS = 40
ZERO = mpf(10) ** -100  # relative to lengths and ratios of size 1


def number(q):
    q = Fraction(q)
    return mpf(q.numerator) / q.denominator


def flats(a, b, c, d):
    """The signs of A0A, AB, B0B along A0 -> B0 with which the chain closes on one line."""
    return [e for e in product((1, -1), repeat=3) if e[0] * a + e[1] * b - e[2] * c == d]


def motion(lengths, signs, side):
    """Angular velocities of coupler and rocker for a crank turning at 1, B leaving to `side` (1: left)."""
    a, b, c, d = (number(q) for q in lengths)
    ea, eb, ec = signs

    def place(t):
        A = ea * a * expj(t)
        gap = d - A
        along = (abs(gap) ** 2 + b ** 2 - c ** 2) / (2 * abs(gap))
        across = sqrt(max(b ** 2 - along ** 2, 0)) * (side if t > 0 else -side)
        return A, A + mpc(along, across) * gap / abs(gap)

    # The height of B over A B0 is t small, so its square is lost in the rounding of AB squared unless there are twice the
    # digits once more.
    def at_high_precision(f):
        def g(t):
            with workprec(3 * mp.prec):
                return f(*place(t))
        return g

    coupler = at_high_precision(lambda A, B: arg((B - A) / eb))
    rocker = at_high_precision(lambda A, B: arg((B - d) / ec))

    rates = []
    for angle in (coupler, rocker):
        rate = diff(angle, 0)
        for direction in (1, -1):
            assert abs(diff(angle, 0, direction=direction) - rate) < mpf(10) ** -60
        rates.append(rate)
    return rates


LINKAGES = (
    ("integer", "sides 2, 5, 4 on 7, irrational ratios", "2", "5", "4", "7", "0"),
    ("integer_tilted", "the same, the frame along (3, 4)", "2", "5", "4", "21/5", "28/5"),
    ("coupler_shortest", "2 + 7 = 4 + 5", "4", "2", "5", "7", "0"),
    ("rocker_shortest", "2 + 7 = 5 + 4", "5", "4", "2", "7", "0"),
    ("frame_shortest", "2 + 7 = 5 + 4", "5", "7", "4", "2", "0"),
    ("parallelogram", "opposite sides equal: two change points, rational ratios", "3", "5", "3", "5", "0"),
    ("parallelogram_tilted", "the frame along (-3, 4)", "3", "5", "3", "-3", "4"),
    ("kite_at_A0", "crank and coupler fold onto each other", "5", "5", "3", "0", "3"),
    ("kite_at_B0", "coupler and rocker fold onto each other: only the stretched one of its change points", "3", "5",
     "5", "3", "0"),
)

HEADER = """\
# How four-bar linkages leave their change points, 40 digits. Written by make_change_points.py with mpmath, 200 working
# digits; do not edit by hand. The angles of coupler and rocker are differentiated numerically through the position.
# Nothing here is taken from the C++ code.
#
# Givens: A0A, AB, B0B and the hinge B0 = (x_B0, y_B0), A0 the origin; crank, coupler, rocker: 1 or -1, whether A0A, AB,
# B0B run with A0 -> B0 or against it. left.omega_3, left.omega_4: angular velocities of coupler and rocker for
# omega_2 = 1 in the motion in which B leaves to the left of A -> B0, having come from the right; right.*: the other.
# Change points with A on B0 are left out: there B is not on one side of A -> B0 or the other.
"""


def text(value):
    return "0" if abs(value) < ZERO else nstr(value, DIGITS, min_fixed=-3, max_fixed=3)


def main():
    print(HEADER, end="")
    for name, why, *given in LINKAGES:
        a, b, c, x, y = (Fraction(q) for q in given)
        d2 = x * x + y * y
        d = Fraction(int(sqrt(number(d2))))
        assert d * d == d2
        for signs in flats(a, b, c, d):
            if signs[0] * a == d:
                continue
            print(f"\ncase {name}_crank_{'along' if signs[0] > 0 else 'against'}\nwhy {why}")
            for key, value in zip(("A0A", "AB", "B0B", "x_B0", "y_B0", "crank", "coupler", "rocker"),
                                  (a, b, c, x, y, *signs)):
                print(f"given {key} {value}")
            for side, label in ((1, "left"), (-1, "right")):
                for link, rate in zip((3, 4), motion((a, b, c, d), signs, side)):
                    print(f"{label}.omega_{link} {text(rate)}")


if __name__ == "__main__":
    main()
