#!/usr/bin/env python3
"""Writes roulettes at and beside their cusps, and gear flanks at their limits: two corpora.

  make_rolling.py roulettes > roulettes.txt
  make_rolling.py gears > gears.txt
"""
import sys
from fractions import Fraction as F

from mpmath import acos, cos, exp, findroot, floor, mp, mpc, mpf, pi, sin, sqrt, tan

from hard import Series, Writer, clean, miss, number

ROULETTES = """
Points of roulettes, 120 digits. Written by make_rolling.py roulettes with mpmath, 600 working digits; do not edit by
hand. The position of M as a sum of exponentials; velocity, acceleration and curvature from its power series in time.
Nothing here is taken from the C++ code.

Givens: r rolling, R fixed circle, d the distance of M (rolling.h); the angle turned, 2 pi turns + radians; omega, alpha.
Choice: rolls. radius of curvature, 0 at a cusp, `absent` at an inflection. Question: is_at_cusp.
"""

GEARS = """
Gear pairs, 120 digits. Written by make_rolling.py gears with mpmath, 600 working digits; do not edit by hand. The
textbook's formulas for involute gears, in angles. Nothing here is taken from the C++ code.

Givens: z1, z2, m, pressure angle alpha in turns, profile shifts x1, x2; radius of a point on wheel 1's flank.
r_b base circle of wheel 1; xi_A, xi_E: where contact begins and ends on the line of action, from the pitch point;
tip_thickness of wheel 1 along the arc; flank: that point of the right flank, the middle of the tooth along y.
Questions: room_above_undercut, the sign of z1 sin² alpha/2 + x1 - 1; tip_is, the sign of tip_thickness;
room_in_approach, of the way that is left from A to T1.
"""


def sign_word(x):
    return "zero" if x == 0 else "positive" if x > 0 else "negative"


def roulettes():
    w = Writer(ROULETTES)
    i = mpc(0, 1)

    def write(name, why, rolls, r, R, d, turns, radians=0, omega=10, alpha=3):
        phi0 = 2 * pi * number(turns) + number(radians)
        phi = Series(phi0, number(omega), number(alpha) / 2)
        r_, R_, d_ = (number(x) for x in (r, R, d))

        def turned(share):
            e, k = exp(i * number(share) * phi0), i * number(share)
            return Series(e, e * k * number(omega), e * (k * number(alpha) / 2 + (k * number(omega)) ** 2 / 2))

        one = F(1)
        if rolls == "circle_on_line":
            M = r_ * phi + i * r_ - i * d_ * turned(-one)
        elif rolls == "circle_outside_circle":
            M = (R_ + r_) * turned(F(r) / (F(R) + F(r))) - d_ * turned(one)
        elif rolls == "circle_inside_circle":
            M = (R_ - r_) * turned(F(r) / (F(R) - F(r))) + d_ * turned(-one)
        else:
            M = ((R_ - d_) - i * R_ * phi) * turned(one)
        v, a = (mpc(clean(mpc(x).real), clean(mpc(x).imag)) for x in (M.rate(), M.second()))
        bend = clean((v.conjugate() * a).imag)
        at_cusp = v == 0
        radius = mpf(0) if at_cusp else None if bend == 0 else abs(v) ** 3 / abs(bend)
        z = M.value()
        w.case(name, why, dict(r=r, R=R, d=d, turns=turns, radians=radians, omega=omega, alpha=alpha),
               {"rolls": rolls},
               {"x_M": clean(z.real), "y_M": clean(z.imag), "v_x": v.real, "v_y": v.imag, "a_x": a.real,
                "a_y": a.imag, "radius": radius, "is_at_cusp": "yes" if at_cusp else "no"})

    kinds = (("cycloid", "circle_on_line", F(1, 10), F(0), F(1, 10), F(1)),
             ("epicycloid", "circle_outside_circle", F(1, 10), F(3, 10), F(1, 10), F(4, 3)),
             ("hypocycloid", "circle_inside_circle", F(1, 10), F(4, 10), F(1, 10), F(3, 4)),
             ("involute", "line_on_circle", F(0), F(3, 10), F(0), F(0)))
    for name, rolls, r, R, d, cusp in kinds:
        write(f"{name}-ordinary", f"an ordinary point of the {name}", rolls, r, R, d, F(1, 5))
        write(f"{name}-cusp-hit", f"a cusp of the {name}, exactly", rolls, r, R, d, cusp)
        for k in (3, 8, 15, 22, 30):
            write(f"{name}-cusp-missed-1e-{k}", f"a cusp of the {name}, missed by 1e-{k} rad", rolls, r, R, d, cusp,
                  miss(k))
        write(f"{name}-cusp-missed-back-1e-30", f"a cusp of the {name}, missed by -1e-30 rad", rolls, r, R, d, cusp,
              -miss(30))
    write("cycloid-far", "the cusp after ten million turns, missed by 1e-8 rad", "circle_on_line", F(1, 10), F(0),
          F(1, 10), F(10 ** 7), miss(8))
    write("cycloid-far-hit", "the cusp after ten million turns", "circle_on_line", F(1, 10), F(0), F(1, 10),
          F(10 ** 7))
    # curtate: y_M' = 0 where cos phi = d/r
    write("curtate-inflection-hit", "a curtate cycloid's inflection, exactly", "circle_on_line", F(1, 5), F(0),
          F(1, 10), F(1, 6))
    for k in (3, 15, 30):
        write(f"curtate-inflection-missed-1e-{k}", f"a curtate cycloid's inflection, missed by 1e-{k} rad",
              "circle_on_line", F(1, 5), F(0), F(1, 10), F(1, 6), miss(k))
    write("curtate-almost-a-cusp", "M 1e-20 inside the rim, where the rim has its cusp", "circle_on_line", F(1, 5),
          F(0), F(1, 5) - miss(20), F(1))
    write("prolate-almost-a-cusp", "M 1e-20 outside the rim, where the rim has its cusp", "circle_on_line", F(1, 5),
          F(0), F(1, 5) + miss(20), F(1))
    write("nanometre", "a cycloid of 1e-9 m", "circle_on_line", miss(9), F(0), miss(9), F(1, 7))
    write("almost-as-large", "a wheel in a ring larger by 1e-8: its centre hardly moves", "circle_inside_circle",
          F(1), 1 + miss(8), F(1), F(1, 7))
    w.print()


def gears():
    w = Writer(GEARS)

    def quantities(z1, z2, m, alpha, x1, x2):
        a0 = 2 * pi * number(alpha)
        inv = lambda a: tan(a) - a
        m_ = number(m)
        r = [m_ * z / 2 for z in (z1, z2)]
        r_b = [x * cos(a0) for x in r]
        r_a = [q + m_ * (1 + number(x)) for q, x in zip(r, (x1, x2))]
        inv_w = inv(a0) + 2 * tan(a0) * number(F(x1) + F(x2)) / (z1 + z2)
        a_w = a0 if F(x1) + F(x2) == 0 else findroot(lambda a: inv(a) - inv_w, a0)
        return a0, inv, m_, r, r_b, r_a, a_w

    def tip(z1, m, alpha, x1):
        a0 = 2 * pi * number(alpha)
        inv = lambda a: tan(a) - a
        r = number(m) * z1 / 2
        r_b, r_a = r * cos(a0), r + number(m) * (1 + number(x1) if isinstance(x1, (int, F)) else 1 + x1)
        x = number(x1) if isinstance(x1, (int, F)) else x1
        return 2 * r_a * ((pi / 2 + 2 * x * tan(a0)) / z1 + inv(a0) - inv(acos(r_b / r_a)))

    def write(name, why, z1, z2, m, alpha, x1=F(0), x2=F(0), radius=None):
        a0, inv, m_, r, r_b, r_a, a_w = quantities(z1, z2, m, alpha, x1, x2)
        tooth = (pi / 2 + 2 * number(x1) * tan(a0)) / z1      # half the tooth's angle on the reference circle
        if radius is None:
            radius = F(m) * z1 / 2 + F(m) / 2
        rho = number(radius)
        half = tooth + inv(a0) - inv(acos(r_b[0] / rho))
        # the way along the line of action from P0 to where the tip circles meet it
        reach = [sqrt(q * q - b * b) - b * tan(a_w) for q, b in zip(r_a, r_b)]
        approach = clean(r_b[0] * tan(a_w) - reach[1], r[0])
        # exactly: sin² of the angle is rational or not
        room = clean(z1 * sin(a0) ** 2 / 2 + number(x1) - 1)
        thickness = tip(z1, m, alpha, x1)
        w.case(name, why, dict(z1=z1, z2=z2, m=m, alpha=alpha, x1=x1, x2=x2, radius=radius), {},
               {"r_b": r_b[0], "centre_distance": (r_b[0] + r_b[1]) / cos(a_w), "xi_A": -reach[1], "xi_E": reach[0],
                "tip_thickness": thickness, "x_flank": rho * sin(half), "y_flank": rho * cos(half),
                "room_above_undercut": sign_word(room), "tip_is": sign_word(thickness),
                "room_in_approach": sign_word(approach)})

    m, d20, d30 = F(1, 100), F(1, 18), F(1, 12)
    write("ordinary", "an ordinary pair", 21, 34, m, d20)
    write("shifted", "a pair with profile shifts", 21, 34, m, d20, F(1, 4), F(1, 3))
    write("undercut-hit", "8 teeth at 30 degrees: exactly the undercut limit", 8, 34, m, d30)
    for k in (3, 8, 15, 22, 30):
        write(f"undercut-missed-1e-{k}", f"8 teeth at 30 degrees, shifted by 1e-{k} modules", 8, 34, m, d30, miss(k),
              -miss(k))
        write(f"undercut-undercut-1e-{k}", f"8 teeth at 30 degrees, shifted by -1e-{k} modules", 8, 34, m, d30,
              -miss(k), miss(k))
        write(f"shifted-by-1e-{k}", f"the working pressure angle beside that of the rack: shifts add to 1e-{k}", 21,
              34, m, d20, miss(k))
    write("undercut-17", "17 teeth at 20 degrees", 17, 34, m, d20)
    write("undercut-18", "18 teeth at 20 degrees", 18, 34, m, d20)
    write("interference-hit", "10 and 16 teeth at 30 degrees, shifted by half a module: the tip of wheel 2 meets the "
          "line of action exactly in T1", 10, 16, m, d30, F(-1, 2), F(1, 2), F(1, 20))
    for k in (8, 15, 30):
        for s, word in ((1, "more"), (-1, "less")):
            x = F(1, 2) + s * miss(k)
            write(f"interference-{word}-1e-{k}", f"the same, shifted by 1e-{k} {word}", 10, 16, m, d30, -x, x, F(1, 20))
    pointed = findroot(lambda x: tip(12, m, d20, x), mpf("0.6"))
    for k in (3, 8, 15, 22, 30):
        for s, word in ((1, "beyond"), (-1, "before")):
            x = F(int(floor((pointed + s * mpf(10) ** -k) * 10 ** 40)), 10 ** 40)
            write(f"pointed-{word}-1e-{k}", f"a tooth pointed at its tip, the shift 1e-{k} {word} that", 12, 34, m, d20,
                  x, F(0))
    million = 10 ** 6
    write("million-teeth", "two wheels with a million teeth", million, million, m, d20)
    write("million-and-twenty", "twenty teeth against a million", 20, million, m, d20)
    write("million-and-twenty-shifted", "a million teeth, and shifts that add to a hundredth", million, 20, m, d20,
          F(1, 100), F(0))
    write("base-circle", "a point of the flank 1e-12 m above the base circle: the involute begins", 21, 34, m, d30,
          radius=F(int(floor(m * 21 / 2 * 10 ** 30 * F(866025403784438646763723170752, 10 ** 30))), 10 ** 30) + miss(12))
    write("nanometre", "a module of 1e-9 m", 21, 34, miss(9), d20)
    w.print()


if __name__ == "__main__":
    {"roulettes": roulettes, "gears": gears}[sys.argv[1]]()
