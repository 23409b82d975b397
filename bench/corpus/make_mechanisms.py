#!/usr/bin/env python3
"""Writes mechanisms.txt: a four-bar and Watt's six-bar at 24 positions of a turn, independent of the C++ code.

Only positions are written down here, by complex numbers and the law of cosines, as functions of time. Velocities and
accelerations are high-precision numerical derivatives of them (mpmath.diff): no polygon, no system of equations.
Usage: make_mechanisms.py > mechanisms.txt
"""
from fractions import Fraction

from mpmath import conj, diff, expj, im, log, mp, mpf, nstr, pi, sqrt

mp.dps = 120
DIGITS = 40


def q(text):
    a, _, b = text.partition("/")
    return mpf(a) / mpf(b or 1)


def left_joint(P, Q, a, b):
    """The point at a from P and b from Q, on the left of P -> Q."""
    d = abs(Q - P)
    x = (a ** 2 - b ** 2 + d ** 2) / (2 * d)
    return P + (Q - P) / d * (x + 1j * sqrt(a ** 2 - x ** 2))


class FourBar:
    """10 rad/s and 3 rad/s^2 now; C in the middle of AB, a fifth of AB to its left."""

    def __init__(self, turn):
        self.A = lambda t: q("0.15") * expj(2 * pi * mpf(turn.numerator) / turn.denominator + 10 * t + 3 * t ** 2 / 2)
        self.B0 = q("0.4")
        self.B = lambda t: left_joint(self.A(t), self.B0, q("0.37"), q("0.45"))
        self.AB = lambda t: self.B(t) - self.A(t)
        self.B0B = lambda t: self.B(t) - self.B0
        self.C = lambda t: self.A(t) + self.AB(t) * (q("1/2") + 1j * q("1/5"))


def rates(number, line):
    yield f"omega_{number}", diff(lambda t: im(log(line(t))), 0)
    yield f"alpha_{number}", diff(lambda t: im(log(line(t))), 0, 2)


def place(name, z):
    yield f"x_{name}", z.real
    yield f"y_{name}", z.imag


def of_four_bar(turn):
    of = FourBar(turn)
    yield from place("B", of.B(0))
    yield from place("C", of.C(0))
    values = dict(list(rates(3, of.AB)) + list(rates(4, of.B0B)))
    yield from values.items()
    omega, alpha = values["omega_3"], values["alpha_3"]
    yield from place("P0", of.A(0) + 1j * diff(of.A, 0) / omega)
    yield from place("K", of.A(0) + diff(of.A, 0, 2) / (omega ** 2 - 1j * alpha))
    v, a = diff(of.C, 0), diff(of.C, 0, 2)
    yield from place("centre", of.C(0) + 1j * v * abs(v) ** 2 / im(conj(v) * a))


def of_six_bar(turn):
    """D on the rocker, 0.1 along B0B and 0.2 to its left; E at 0.3 from C and 0.35 from D, on the left of CD."""
    of = FourBar(turn)
    D = lambda t: of.B0 + of.B0B(t) / q("0.45") * (q("0.1") + 1j * q("0.2"))
    E = lambda t: left_joint(of.C(t), D(t), q("0.3"), q("0.35"))
    for name, point in dict(B=of.B, C=of.C, D=D, E=E).items():
        yield from place(name, point(0))
        yield from place("v" + name, diff(point, 0))
        yield from place("a" + name, diff(point, 0, 2))
    yield from rates(5, lambda t: E(t) - of.C(t))
    yield from rates(6, lambda t: E(t) - D(t))


print("""# A four-bar and Watt's six-bar at 24 positions of a turn, 40 digits. Written by make_mechanisms.py with mpmath; do not
# edit by hand. Nothing here is taken from the C++ code. Crank at `turn` from +x.
""")
for mechanism, values in dict(four_bar=of_four_bar, six_bar=of_six_bar).items():
    for k in range(24):
        turn = Fraction(2 * k + 1, 48)
        name = mechanism.replace("_", "-")
        print(f"case {name}-{k + 1}\nwhy {name} over a turn\nchoice mechanism {name}\ngiven turn {turn}")
        for value in values(turn):
            print(value[0], nstr(value[1], DIGITS, strip_zeros=False))
        print()
