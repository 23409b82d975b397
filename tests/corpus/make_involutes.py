#!/usr/bin/env python3
"""Writes involutes.txt: tangents of pressure angles whose involute function is given.

  make_involutes.py > involutes.txt

The root is bracketed and halved over the angle itself, tan a - a = inv with 400 working digits; no series and no
Newton step. The same angle in radians and its involute function at a given tangent are written beside.
"""
from fractions import Fraction

from mpmath import atan, mp, mpf, nstr, pi, tan

mp.dps = 400

CASES = [
    ("tiny", "far below where doubles lose tan a - a", "1e-40"),
    ("small", "two thirds of the digits of tan a - a cancel", "1e-15"),
    ("thousandth", "about 8 degrees", "1/1000"),
    ("twenty", "close to 20 degrees", "149/10000"),
    ("series_ends", "close to the tangent 1/4, where the series gives way", "5025/1000000"),
    ("forty_five", "close to 45 degrees", "2146/10000"),
    ("one", "about 65 degrees", "1"),
    ("ten", "beyond 84 degrees", "10"),
    ("steep", "nearly a right angle", "1e9"),
]


def number(text):
    q = Fraction(text)
    return mpf(q.numerator) / q.denominator


def root(y):
    low, high = mpf(0), pi / 2
    for _ in range(1300):
        middle = (low + high) / 2
        if tan(middle) - middle < y:
            low = middle
        else:
            high = middle
    return low


print("# The involute function inverted, 40 digits. Written by make_involutes.py with mpmath; do not edit by hand.")
for name, why, given in CASES:
    y = number(given)
    angle = root(y)
    print(f"\ncase {name}\nwhy {why}\ngiven involute {Fraction(given)}")
    print("tangent", nstr(tan(angle), 40, min_fixed=-60, max_fixed=60))
    print("angle", nstr(angle, 40, min_fixed=-60, max_fixed=60))
    print("involute_of_it", nstr(y - atan(y), 40, min_fixed=-130, max_fixed=60))
