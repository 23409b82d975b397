#!/usr/bin/env python3
"""Writes spin_up.txt: reference values of a wheel set turning on the ground, independent of the C++ code.

  make_spin_up.py > spin_up.txt

Everything as a quadrature over the speed, which falls as v' = -(A + B v^2): neither the law in time nor its series is
used. Slip ends at the root of R omega = v, sought with 50 digits.
"""
from fractions import Fraction

from mpmath import findroot, mp, mpf, nstr, quad

mp.dps = 50


def number(rational):
    q = Fraction(rational)
    return mpf(q.numerator) / q.denominator


def end_of_slip(given):
    A, B, C, D, v_0, omega_0, R = [number(given[n]) for n in ("A", "B", "C", "D", "v_0", "omega_0", "R")]

    def since_touch_down(f, v):
        speeds = [v]
        while speeds[-1] < v_0:
            speeds.append(min(4 * speeds[-1], v_0))
        return quad(lambda u: f(u) / (A + B * u * u), speeds, method="gauss-legendre")

    def omega(v):
        return omega_0 + since_touch_down(lambda u: C + D * u * u, v)

    behind = lambda u: R * omega(u) - u
    low, high = v_0, v_0
    while behind(low) < 0:
        low, high = low / 2, low
    v = findroot(behind, (low, high), solver="anderson", tol=mpf(10) ** -90, verify=False)
    assert abs(behind(v)) < mpf(10) ** -45 * v
    return dict(t=since_touch_down(lambda u: mpf(1), v), v=v, omega=omega(v), path=since_touch_down(lambda u: u, v),
                angle=since_touch_down(omega, v), cubes=since_touch_down(lambda u: u ** 3, v),
                of_wheel=since_touch_down(lambda u: (C + D * u * u) * omega(u), v),
                of_load=since_touch_down(lambda u: (C + D * u * u) * u, v))


CASES = [
    ("landing", "as the source has it", ("981/100", "1/2265", "999/12250*9060*981/100", "999/6125", "625/9", "0", "2/5")),
    ("no_flaps", "B and D are zero: the law is a polynomial", ("981/100", "0", "7000", "0", "70", "0", "2/5")),
    ("beside", "B missed by 1e-30: the closed form cancels", ("981/100", "1/10^30", "7000", "1/10^30", "70", "0", "2/5")),
    ("lift", "B and D below zero: tanh", ("981/100", "-1/1000", "7000", "-1/5", "70", "10", "2/5")),
    ("last", "slip lasts almost until the load stands still, beside the pole of tan",
     ("1/1000", "1/40", "1/10^6", "1/10^7", "60", "0", "1/2")),
    ("slow", "a wheel that needs most of the landing", ("10", "1/900", "3", "1/50", "60", "0", "1/2")),
]
NAMES = ("A", "B", "C", "D", "v_0", "omega_0", "R")


def fraction(text):
    value = Fraction(1)
    for factor in text.split("*"):
        over = factor.split("/")
        top, bottom = over[0], over[1] if len(over) > 1 else "1"
        power = lambda t: Fraction(t.split("^")[0]) ** int(t.split("^")[1]) if "^" in t else Fraction(t)
        value *= power(top) / power(bottom)
    return value


print("""# Reference values of a wheel set turning by the ground it slides on, when slip ends, 40 digits. Written by
# make_spin_up.py with mpmath, 50 working digits; do not edit by hand.""")
for name, why, texts in CASES:
    given = {n: fraction(t) for n, t in zip(NAMES, texts)}
    print(f"\ncase {name}\nwhy {why}")
    for n in NAMES:
        print("given", n, given[n])
    for quantity, value in end_of_slip(given).items():
        print(quantity, nstr(value, 40))
