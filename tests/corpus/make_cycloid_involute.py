#!/usr/bin/env python3
"""Writes cycloid_involute.txt: reference values for cycloid and involute, independent of the C++ code.

  make_cycloid_involute.py > cycloid_involute.txt

Only positions are written down, as functions of time: two points of the wheel and two of the line. Velocities and
accelerations are high-precision numerical derivatives of these paths; P0 and K are the zeros of the fields that two
points fix; arcs are integrals of the speed. The angle that belongs to an arc is the only other formula. What differs
on the two sides of a cusp is taken 1e-70 before and after it.
"""
from fractions import Fraction

from mpmath import acos, conj, cos, diff, exp, fabs, im, mp, mpc, mpf, nstr, pi, quad, re, sin

mp.dps = 220
ZERO = mpf(10) ** -100  # what numerical derivatives leave of a zero is smaller, everything else is larger
ASIDE = mpf(10) ** -70  # s: from a cusp to its two sides
I = mpc(0, 1)

STATED = dict(d="1", omega_1="30", phi="135", s="4", d_0="3/5", omega_2="50", t1="7/50", t2="7/25")


def beside(whole, digits, sign):
    return str(Fraction(whole) + sign * Fraction(1, 10**digits))


CASES = [
    ("stated", "the exercise as it is stated: s is a cusp", {}),
    ("quarter_turn", "the wheel as the source drew it", dict(phi="90")),
    ("top", "M at the top of its arch by the angle and by the arc", dict(phi="180", s="2")),
    ("three_quarters", "M comes down", dict(phi="270", s="3")),
    ("full_turn", "the angle is a cusp too", dict(phi="360")),
    ("start", "nothing has moved yet: all three paths at their cusps", dict(phi="0", s="0", t1="0")),
    ("cusp_missed_by_1e-9", "just past, and the angle just short", dict(s=beside(4, 9, 1), phi=beside(360, 9, -1))),
    ("cusp_missed_by_1e-12", "just short, and the angle just past", dict(s=beside(4, 12, -1), phi=beside(360, 12, 1))),
    ("cusp_missed_by_1e-15", "just past, beyond doubles", dict(s=beside(4, 15, 1), phi=beside(720, 15, -1))),
    ("cusp_missed_by_1e-15_before", "just short, beyond doubles", dict(s=beside(4, 15, -1))),
    ("cusp_missed_by_1e-30", "just past, far beyond doubles", dict(s=beside(4, 30, 1), phi=beside(360, 30, 1))),
    ("cusp_missed_by_1e-30_before", "just short, far beyond doubles",
     dict(s=beside(4, 30, -1), phi=beside(360, 30, -1))),
    ("fifth_cusp", "the arcs of all arches are counted", dict(s="20", phi="1800")),
    ("top_missed_by_1e-20", "the tangential part all but gone", dict(s=beside(2, 20, 1), phi=beside(180, 20, 1))),
    ("many_arches", "a thousand metres and a hundred turns", dict(s="10007/10", phi="37217", t1="3", t2="31")),
    ("just_begun", "hardly any way at all", dict(s="1/1000000000", phi="1/1000000", t1="1/1000000000")),
    ("another_wheel_s_is_no_cusp", "4 m on a wheel of 0.7 m", dict(d="7/10", phi="200")),
    ("another_wheel_s_is_a_cusp", "third of a metre: cusp after 4/3 m, so after 4 m", dict(d="1/3", phi="20")),
    ("small_and_quick", "a coin", dict(d="1/40", omega_1="500", s="1/7", d_0="1/50", omega_2="1000")),
    ("odd", "no round number anywhere",
     dict(d="41/83", omega_1="13/9", phi="1234/19", s="31/11", d_0="29/7", omega_2="17/23", t1="5/3", t2="22/7")),
]


def number(rational):
    q = Fraction(rational)
    return mpf(q.numerator) / q.denominator


def text(x, size):
    return "0" if fabs(x) <= ZERO * size else nstr(x, 40, strip_zeros=True, min_fixed=-30, max_fixed=30)


def zero_of_field(X, at_X, Y, at_Y):
    """Of v(z) = at_X + c (z - X), and |c|."""
    c = (at_Y - at_X) / (Y - X)
    return X - at_X / c, fabs(c)


def part(v, along):
    return re(v * conj(along)) / fabs(along)


class Instant:
    """Of a point M and another point of its body, both functions of time."""

    def __init__(self, path_of_M, path_of_other, t, is_cusp):
        self.path, self.t, self.is_cusp = path_of_M, t, is_cusp
        self.M, other = path_of_M(t), path_of_other(t)
        self.v, self.a = diff(path_of_M, t), diff(path_of_M, t, 2)
        v_other, a_other = diff(path_of_other, t), diff(path_of_other, t, 2)
        self.P0, _ = zero_of_field(other, v_other, self.M, self.v)
        self.K, _ = zero_of_field(other, a_other, self.M, self.a)
        if is_cusp:
            self.rho, self.normal, self.centre = mpf(0), mpf(0), self.M
        else:
            bend = im(conj(self.v) * self.a)
            self.rho = fabs(self.v) ** 3 / fabs(bend)
            self.normal = fabs(bend) / fabs(self.v)
            self.centre = self.M + I * self.v * fabs(self.v) ** 2 / bend

    def along(self, side):
        at = self.t + side * ASIDE if self.is_cusp else self.t
        return part(diff(self.path, at, 2), diff(self.path, at))

    def values(self, before, after, length):
        speed, pull = mpf(1), mpf(1)
        names = [("x_M", re(self.M), length), ("y_M", im(self.M), length), ("P0M", fabs(self.M - self.P0), length),
                 ("v_M", fabs(self.v), speed), ("v_M_x", re(self.v), speed), ("v_M_y", im(self.v), speed),
                 ("a_M", fabs(self.a), pull), ("a_M_x", re(self.a), pull), ("a_M_y", im(self.a), pull),
                 ("a_n", self.normal, pull), ("rho_M", self.rho, length),
                 ("curvature_centre_x", re(self.centre), length), ("curvature_centre_y", im(self.centre), length)]
        return [(before + name + after, value, size) for name, value, size in names]


def integral_of_speed(path, end, is_smooth_from):
    """The speed of these paths is analytic on [is_smooth_from, end]: a few digits more than 40 are enough."""
    with_digits = mp.dps
    mp.dps = 60
    length = quad(lambda t: fabs(diff(path, t)), [is_smooth_from, (is_smooth_from + end) / 2, end])
    mp.dps = with_digits
    return length


def cycloid(given):
    r, omega, degrees, s = number(given["d"]) / 2, number(given["omega_1"]), Fraction(given["phi"]), Fraction(given["s"])

    def centre(t):
        return r * omega * t + I * r

    def path(t):
        return centre(t) - I * r * exp(-I * omega * t)

    found = []
    turn = 2 * pi / omega
    phi = number(degrees) * pi / 180
    at_phi = Instant(path, centre, phi / omega, degrees % 360 == 0)
    found += [("cycloid.time_at_phi", phi / omega, 1)] + at_phi.values("cycloid.", "", r)
    sides = at_phi.along(-1), at_phi.along(1)
    found += [("cycloid.a_t", None if at_phi.is_cusp else sides[1], 1), ("cycloid.a_t_before_cusp", sides[0], 1),
              ("cycloid.a_t_after_cusp", sides[1], 1)]
    Mprime_M = mpf(0) if at_phi.is_cusp else fabs(at_phi.M - at_phi.P0) ** 2 / at_phi.rho
    found += [("cycloid.Mprime_M", Mprime_M, r), ("cycloid.K_x", re(at_phi.K), r), ("cycloid.K_y", im(at_phi.K), r),
              ("cycloid.KM", fabs(at_phi.K - at_phi.M), r),
              ("cycloid.inflection_diameter", fabs(at_phi.K - at_phi.P0), r), ("cycloid.arch_base", re(path(turn)), r)]

    # The speed is analytic within an arch: whole ones, then the rest of the last.
    arches = degrees // 360
    arch = 2 * integral_of_speed(path, turn / 2, mpf(0))
    rest = number(degrees - 360 * arches) * pi / 180 / omega
    found += [("cycloid.arch_length", arch, r),
              ("cycloid.arc_length_at_phi", arches * arch + (integral_of_speed(path, rest, mpf(0)) if rest else 0), 1)]

    arch_exactly = 4 * Fraction(given["d"])
    behind = s // arch_exactly
    phi_at_s = 2 * pi * behind + 2 * acos(1 - number(s - behind * arch_exactly) / (4 * r))
    at_s = Instant(path, centre, phi_at_s / omega, s % arch_exactly == 0)
    found += [("cycloid.phi_at_s4", phi_at_s, 1), ("cycloid.t_at_s4", phi_at_s / omega, 1)]
    found += at_s.values("cycloid.", "_at_s4", r)
    sides = at_s.along(-1), at_s.along(1)
    found += [("cycloid.a_t_at_s4", None if at_s.is_cusp else sides[1], 1),
              ("cycloid.a_t_at_s4_before_cusp", sides[0], 1), ("cycloid.a_t_at_s4_after_cusp", sides[1], 1)]
    return found


def involute(given, t_name):
    R, omega, t = number(given["d_0"]) / 2, number(given["omega_2"]), number(given[t_name])

    def path(t):
        return R * exp(I * omega * t) * (1 - I * omega * t)

    def further_along(t):
        return path(t) + I * R * exp(I * omega * t)

    at = Instant(path, further_along, t, t == 0)
    after = "_" + t_name
    arc = mpf(0) if t == 0 else integral_of_speed(path, t, mpf(0))
    return ([("involute.phi" + after, omega * t, 1), ("involute.arc_length" + after, arc, 1),
             ("involute.a_t" + after, at.along(1), 1)] + at.values("involute.", after, R))


print("""# Reference values of cycloid and involute, 40 digits. Written by make_cycloid_involute.py with mpmath, 220 working
# digits; do not edit by hand. Positions are the only formulas; all else are their derivatives and integrals.
# phi in degrees; SI units. `infinite`: has no single value, at a cusp.""")
for name, why, changed in CASES:
    given = {**STATED, **changed}
    print(f"\ncase {name}\nwhy {why}")
    for symbol, value in given.items():
        print(f"given {symbol} {value}")
    for quantity, value, size in cycloid(given) + involute(given, "t1") + involute(given, "t2"):
        print(quantity, "infinite" if value is None else text(value, size))
