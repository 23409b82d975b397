#!/usr/bin/env python3
"""Writes carried_bar.txt: reference values for a bar hinged on a translating body, independent of the C++ code.

  make_carried_bar.py > carried_bar.txt

Only positions are written down, as functions of time: O on the line it translates along, A turned about it.
Velocities and accelerations are high-precision numerical derivatives of these paths. The field of velocities of a
rigid bar is v(z) = v_O + c (z - O) with a complex c that O and A fix; P0 is its zero. K likewise of accelerations.
"""
from fractions import Fraction

from mpmath import atan2, conj, cos, diff, exp, fabs, im, mp, mpc, mpf, nstr, pi, re

mp.dps = 200
ZERO = mpf(10) ** -80  # what numerical differentiation leaves of a zero is smaller, everything else is larger

STATED = dict(L="4/5", angle="45", omega="3", omega_dot="-3", V="12", a="9/2")
CASES = [
    ("stated", "the exercise as it is stated", {}),
    ("steady", "steady angular velocity", dict(omega_dot="0")),
    ("clockwise", "turning clockwise: the centre below", dict(omega="-3")),
    ("to_the_left", "the body moving to the left", dict(V="-12", a="-9/2")),
    ("not_turning", "no angular velocity: the centre at infinity", dict(omega="0")),
    ("translating", "neither angular velocity nor acceleration: K at infinity too", dict(omega="0", omega_dot="0")),
    ("hinge_at_rest", "O rests and is the centre", dict(V="0")),
    ("at_rest", "nothing moves yet", dict(V="0", omega="0")),
    ("nothing_at_all", "nothing moves, nothing will", dict(V="0", omega="0", omega_dot="0", a="0")),
    ("upright", "bar upright: one line is normal to both velocities", dict(angle="90")),
    ("rolling", "bar upright, A at rest for an instant", dict(angle="90", omega="15")),
    ("hanging", "bar downwards", dict(angle="270")),
    ("hanging_at_rest", "bar downwards, O at rest", dict(angle="-90", V="0")),
    ("level", "bar along the guide", dict(angle="0")),
    ("backwards", "bar backwards along the guide", dict(angle="180")),
    ("third_quadrant", "bar at 200 degrees, more than a turn ago", dict(angle="-520")),
    ("unaccelerated", "the body not accelerated: O is K", dict(a="0")),
    ("slow", "turning slowly: the centre 12 km away", dict(omega="1/1000")),
    ("long", "a bar of kilometres", dict(L="4000", angle="20")),
    ("odd", "no round number anywhere",
     dict(L="41/83", angle="1234/19", omega="-13/9", omega_dot="23/17", V="-29/7", a="31/11")),
]


def number(rational):
    q = Fraction(rational)
    return mpf(q.numerator) / q.denominator


def text(x, size):
    return "0" if fabs(x) <= ZERO * size else nstr(x, 40, strip_zeros=True, min_fixed=-30, max_fixed=30)


def zero_of_field(at_O, at_A, OA):
    """Of v(z) = at_O + c z; None when c is zero."""
    c = (at_A - at_O) / OA
    return None if fabs(c) <= ZERO else -at_O / c


def values(given):
    L, angle, omega, omega_dot, V, a = (number(given[k]) for k in ("L", "angle", "omega", "omega_dot", "V", "a"))

    def path_of_O(t):
        return mpc(V * t + a * t * t / 2)

    def path_of_A(t):
        return path_of_O(t) + L * exp(mpc(0, 1) * (angle * pi / 180 + omega * t + omega_dot * t * t / 2))

    OA = path_of_A(0)
    along, square = OA / L, mpc(0, 1) * OA / L
    v_O, v_A, a_O, a_A = (diff(path, 0, order) for order in (1, 2) for path in (path_of_O, path_of_A))
    P0, K = zero_of_field(v_O, v_A, OA), zero_of_field(a_O, a_A, OA)

    def part(v, u):  # of v along the unit vector u
        return re(v * conj(u))

    one = mpf(1)
    found = [("A_x", re(OA), L), ("A_y", im(OA), L), ("v_O", fabs(v_O), one), ("v_AO", fabs(v_A - v_O), one),
             ("v_A_x", re(v_A), one), ("v_A_y", im(v_A), one), ("v_A", fabs(v_A), one)]
    level = fabs(im(v_A)) <= ZERO
    found.append(("normal_slope", None if level else -re(v_A) / im(v_A), one))
    for name, Z, of_O, of_A in (("P0", P0, "P0O", "P0A"), ("K", K, "KO", "KA")):
        found += [(name + "_x", None if Z is None else re(Z), one), (name + "_y", None if Z is None else im(Z), one),
                  (of_O, None if Z is None else fabs(Z), one), (of_A, None if Z is None else fabs(Z - OA), one)]
    found += [("a_O", fabs(a_O), one), ("a_AO_n", fabs(part(a_A - a_O, along)), one),
              ("a_AO_t", fabs(part(a_A - a_O, square)), one), ("a_A_x", re(a_A), one), ("a_A_y", im(a_A), one),
              ("a_A", fabs(a_A), one)]
    towards_O, across = (0 if fabs(x) <= ZERO else x for x in (-part(a_A - a_O, along), part(a_A - a_O, square)))
    found.append(("gamma_deg", None if towards_O == across == 0 else atan2(across, towards_O) * 180 / pi, one))
    return found


print("""# Reference values of a bar hinged on a translating body, 40 digits. Written by make_carried_bar.py with mpmath,
# 200 working digits; do not edit by hand. Positions are the only formulas; all else are their derivatives, and the
# zeros P0 and K of the fields that O and A fix.
# O origin, the body along x; angle in degrees from x, counter-clockwise positive. Components and the slope are
# signed, the rest are magnitudes. SI units. `infinite`: no such point or slope.""")
for name, why, changed in CASES:
    given = {**STATED, **changed}
    print(f"\ncase {name}\nwhy {why}")
    for symbol, value in given.items():
        print(f"given {symbol} {value}")
    for quantity, value, size in values(given):
        print(quantity, "infinite" if value is None else text(value, size))
