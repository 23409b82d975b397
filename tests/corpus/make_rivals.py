#!/usr/bin/env python3
"""Writes rivals.txt: reference values for Rivals' theorem on the slider-crank, independent of the C++ code.

  make_rivals.py > rivals.txt

Only positions are written down, as functions of time: A on its circle, B on the guide by Pythagoras, G on the line
AB. Velocities and accelerations are high-precision numerical derivatives of these paths, ω₃ and α₃ of the direction
of AB; normal and tangential parts are the projections on AB and on the crank. a_B_as_printed solves the source's
equation (1), with a_A besides a_A^n + a_A^t, for the two unknown magnitudes.
"""
from fractions import Fraction

from mpmath import arg, conj, cos, diff, exp, fabs, im, lu_solve, matrix, mp, mpc, mpf, nstr, pi, re, sin, sqrt

mp.dps = 200
ZERO = mpf(10) ** -80  # what numerical differentiation leaves of a zero is smaller, everything else is larger

STATED = dict(r="1/5", l="1/2", AG="1/4", n="360", alpha_2="0", phi="30")
CASES = [
    ("stated", "the mechanism of the quantities' conventions", {}),
    ("outer_dead_centre", "all collinear, B rests", dict(phi="0")),
    ("inner_dead_centre", "all collinear, B rests", dict(phi="180")),
    ("upright", "crank square to the guide: the coupler translates", dict(phi="90")),
    ("upright_speeding_up", "the same while the crank speeds up", dict(phi="90", alpha_2="500")),
    ("downwards", "crank downwards, turning clockwise", dict(phi="270", n="-360")),
    ("obtuse", "crank at 135 degrees", dict(phi="135")),
    ("below", "crank at 200 degrees, clockwise and slow", dict(phi="200", n="-100")),
    ("fourth_quadrant", "crank at 300 degrees", dict(phi="300")),
    ("braking", "a tangential acceleration of A", dict(alpha_2="-900")),
    ("G_is_A", "G on A: nothing to add", dict(AG="0")),
    ("G_is_B", "G on B: the same as B", dict(AG="1/2")),
    ("G_before_A", "G beyond A", dict(AG="-1/5", phi="20")),
    ("G_after_B", "G beyond B", dict(AG="4/5", phi="-77")),
    ("equal_links", "r = l", dict(l="1/5", AG="1/10", phi="40")),
    ("folded", "r = l beyond the square position: B stays on A0", dict(l="1/5", AG="1/10", phi="120")),
    ("long_crank", "r > l", dict(r="2/5", l="1/5", AG="1/10", phi="17")),
    ("nearly_upright", "the pole far away", dict(phi="89999/1000")),
    ("micrometres", "micrometres", dict(r="1/500000", l="1/200000", AG="1/1000000")),
    ("odd", "no round number anywhere",
     dict(r="19/97", l="41/83", AG="29/71", n="-1017/13", alpha_2="231/17", phi="1234/19")),
]


def number(rational):
    q = Fraction(rational)
    return mpf(q.numerator) / q.denominator


def text(x, size):
    return "0" if fabs(x) <= ZERO * size else nstr(x, 40, strip_zeros=True, min_fixed=-30, max_fixed=30)


def values(given):
    r, l, AG, n, alpha, phi = (number(given[k]) for k in ("r", "l", "AG", "n", "alpha_2", "phi"))
    omega = 2 * pi * n / 60

    def path_of_A(t):
        return r * exp(mpc(0, 1) * (phi * pi / 180 + omega * t + alpha * t * t / 2))

    def path_of_B(t):
        A = path_of_A(t)
        return re(A) + sqrt(l * l - im(A) ** 2)

    def path_of_G(t):
        A = path_of_A(t)
        return A + AG / l * (path_of_B(t) - A)

    A, B = path_of_A(0), path_of_B(0)
    along = (B - A) / l
    v_A, v_B, v_G = (diff(path, 0) for path in (path_of_A, path_of_B, path_of_G))
    a_A, a_B, a_G = (diff(path, 0, 2) for path in (path_of_A, path_of_B, path_of_G))

    def turned(t):  # of AB since now: never near the cut of arg
        return arg((path_of_B(t) - path_of_A(t)) / along)

    def part(v, u):  # of v along the unit vector u
        return re(v * conj(u))

    square = mpc(0, 1) * along
    # 2 a_A + a_BA^n + x (square to AB) = y (along the guide)
    known = 2 * a_A + part(a_B - a_A, along) * along
    x, y = lu_solve(matrix([[-re(square), 1], [-im(square), 0]]), matrix([re(known), im(known)]))
    speed, acceleration = fabs(v_A), fabs(a_A)
    return [
        ("omega_2", im(v_A * conj(A)) / r**2, speed / r),
        ("v_A", fabs(v_A), speed),
        ("v_BA", fabs(v_B - v_A), speed),
        ("v_B_x", re(v_B), speed),
        ("v_B", fabs(v_B), speed),
        ("omega_3", diff(turned, 0), speed / l),
        ("v_GA", fabs(v_G - v_A), speed),
        ("v_G_x", re(v_G), speed),
        ("v_G_y", im(v_G), speed),
        ("v_G", fabs(v_G), speed),
        ("a_A_n", fabs(part(a_A, A / r)), acceleration),
        ("a_A_t", fabs(part(a_A, mpc(0, 1) * A / r)), acceleration),
        ("a_A", fabs(a_A), acceleration),
        ("a_BA_n", fabs(part(a_B - a_A, along)), acceleration),
        ("a_BA_t", fabs(part(a_B - a_A, square)), acceleration),
        ("a_B_x", re(a_B), acceleration),
        ("a_B", fabs(a_B), acceleration),
        ("alpha_3", diff(turned, 0, 2), acceleration / l),
        ("a_GA_n", fabs(part(a_G - a_A, along)), acceleration),
        ("a_GA_t", fabs(part(a_G - a_A, square)), acceleration),
        ("a_G_x", re(a_G), acceleration),
        ("a_G_y", im(a_G), acceleration),
        ("a_G", fabs(a_G), acceleration),
        ("a_B_as_printed", fabs(y), acceleration),
    ]


print("""# Reference values for Rivals' theorem on the centred slider-crank, 40 digits. Written by make_rivals.py with
# mpmath, 200 working digits; do not edit by hand. Positions are the only formulas; all else are their derivatives.
# A0 origin, guide = x axis, phi in degrees from the position with B at r + l, n in rpm, counter-clockwise positive.
# omega_2, omega_3, alpha_3 and components are signed, the rest are magnitudes. SI units.""")
for name, why, changed in CASES:
    given = {**STATED, **changed}
    print(f"\ncase {name}\nwhy {why}")
    for symbol, value in given.items():
        print(f"given {symbol} {value}")
    for quantity, value, size in values(given):
        print(quantity, text(value, size))
