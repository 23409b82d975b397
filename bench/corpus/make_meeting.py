#!/usr/bin/env python3
"""Writes circles that touch, nearly touch, nest or coincide, and lines that are nearly parallel: two corpora.

  make_meeting.py circles > circles.txt
  make_meeting.py lines > vector_polygon.txt
"""
import sys
from fractions import Fraction as F

from mpmath import acos, cos, fabs, mpc, mpf, sin, sqrt

from hard import Writer, clean, miss, number

CIRCLES = """
Two circles, 120 digits. Written by make_meeting.py circles with mpmath, 600 working digits; do not edit by hand. The
meeting point by the law of cosines, as an angle at the first centre. Nothing here is taken from the C++ code.

Givens: centres and radii. Choice: side of the line from the first centre to the second. Question: overlap, the sign of
(d² - (r_1 - r_2)²) ((r_1 + r_2)² - d²). `circles impossible`: they do not meet, or are concentric.
"""

LINES = """
Polygons of two unknown sides, and lines that meet far away, 120 digits. Written by make_meeting.py lines with mpmath;
do not edit by hand. By Cramer's rule on rationals. Nothing here is taken from the C++ code.

Givens: known + of_first u = of_second w; S is where the line through P along u meets the line through Q along w.
Question: turns_to, the sign of u x w. `vector-polygon impossible`: u and w are parallel.
"""


def circles():
    w = Writer(CIRCLES)

    def write(name, why, c1, r1, c2, r2, side="left"):
        z1, z2 = (mpc(number(c[0]), number(c[1])) for c in (c1, c2))
        dx, dy = F(c2[0]) - F(c1[0]), F(c2[1]) - F(c1[1])
        d2 = dx * dx + dy * dy
        overlap = (d2 - (F(r1) - F(r2)) ** 2) * ((F(r1) + F(r2)) ** 2 - d2)
        references = {"overlap": "zero" if overlap == 0 else "positive" if overlap > 0 else "negative"}
        if overlap < 0 or d2 == 0:
            references["circles"] = "impossible"
        else:
            d = z2 - z1
            cosine = (number(F(r1) ** 2 + d2 - F(r2) ** 2)) / (2 * number(r1) * abs(d))
            angle = mpf(0) if overlap == 0 and cosine > 0 else acos(cosine) if overlap else mpf(0)
            turned = mpc(cos(angle), sin(angle) if side == "left" else -sin(angle))
            if overlap == 0:
                turned = mpc(1 if cosine > 0 else -1, 0)
            P = z1 + number(r1) * d / abs(d) * turned
            size = number(F(r1))
            references["x"], references["y"] = clean(P.real, size), clean(P.imag, size)
        w.case(name, why, dict(x_1=c1[0], y_1=c1[1], r_1=r1, x_2=c2[0], y_2=c2[1], r_2=r2), {"side": side},
               references)

    O, C = (F(0), F(0)), (F(3), F(4))
    write("ordinary", "two circles that cross well", O, F(3), C, F(4))
    write("binary", "doubles hold the givens exactly, so that every error is one of rounding", O, F(3), (F(2), F(5)),
          F(7, 2))
    for name, what, r1, r2 in (("outside", "circles that touch from outside", F(2), F(3)),
                               ("inside", "one circle touches the other from inside", F(7), F(2))):
        write(f"touch-{name}-hit", f"{what}, exactly", O, r1, C, r2)
        for k in (3, 8, 15, 22, 30):
            for sign, word in ((1, "longer"), (-1, "shorter")):
                write(f"touch-{name}-{word}-1e-{k}", f"{what}, the second radius {word} by 1e-{k}", O, r1, C,
                      r2 + sign * miss(k), "left" if k % 2 else "right")
    tenths = (F(1, 10), F(2, 10), F(3, 10))
    write("tenths", "radii 0.1 and 0.2 at distance 0.3: in binary they overlap", O, tenths[0], (tenths[2], F(0)),
          tenths[1])
    write("nested", "one circle well inside the other", O, F(10), C, F(1))
    write("apart", "circles that lie apart", O, F(1), C, F(1))
    write("concentric", "one centre, two radii", C, F(2), C, F(3))
    write("same", "one and the same circle", C, F(2), C, F(2))
    write("same-almost", "centres 1e-30 apart, the same radius: they cross square to that", O, F(2),
          (miss(30), F(0)), F(2))
    write("concentric-almost", "centres 1e-30 apart, another radius", O, F(2), (miss(30), F(0)), F(3))
    for ten in (8, 15):
        far = (F(10 ** ten), -F(10 ** ten))
        near = (far[0] + 3, far[1] + 4)
        write(f"far-1e{ten}", f"the crossing circles 1e{ten} away from the origin", far, F(3), near, F(4))
        write(f"far-touch-1e{ten}", f"touching circles 1e{ten} away from the origin", far, F(2), near, F(3))
    write("nanometre", "circles of 1e-9 m", O, 3 * miss(9), tuple(x * miss(9) for x in C), 4 * miss(9))
    write("unequal", "radii 1e8 and 1, centres 1e8 apart", O, F(10 ** 8), (F(10 ** 8), F(0)), F(1))
    w.print()


def lines():
    w = Writer(LINES)

    def write(name, why, known, u, v, P, Q):
        known, u, v, P, Q = (tuple(F(x) for x in p) for p in (known, u, v, P, Q))
        cross = lambda a, b: a[0] * b[1] - a[1] * b[0]
        D = cross(u, v)
        references = {"turns_to": "zero" if D == 0 else "positive" if D > 0 else "negative"}
        if D == 0:
            references["vector-polygon"] = "impossible"
        else:
            # known + x u = y v: crossed with v and with u
            references["of_first"] = number(-cross(known, v) / D)
            references["of_second"] = number(-cross(known, u) / D)
            t = cross((Q[0] - P[0], Q[1] - P[1]), v) / D
            references["x_S"], references["y_S"] = number(P[0] + t * u[0]), number(P[1] + t * u[1])
        names = ("known", known), ("u", u), ("w", v), ("P", P), ("Q", Q)
        w.case(name, why, {f"{axis}_{n}": p[k] for n, p in names for k, axis in enumerate("xy")}, {}, references)

    known, P, Q = (F(7, 10), F(-1, 3)), (F(0), F(1)), (F(2), F(-1))
    write("ordinary", "two sides at a good angle", known, (1, 0), (1, 1), P, Q)
    write("binary", "doubles hold the givens exactly, so that every error is one of rounding", (F(5), F(7)), (1, 2),
          (5, 3), (F(1), F(1)), (F(2), F(-1)))
    u = (F(3, 10), F(4, 10))
    for k in (3, 8, 15, 22, 30):
        for sign in (1, -1):
            t = sign * miss(k)
            turned = (u[0] - t * u[1], u[1] + t * u[0])
            write(f"parallel-missed-{'left' if sign > 0 else 'right'}-1e-{k}", f"sides and lines of action 1e-{k} rad "
                  "from parallel", known, u, turned, P, Q)
    write("parallel-hit", "parallel sides, whose tenths are not parallel in binary", known, u, (F(9, 10), F(12, 10)),
          P, Q)
    write("antiparallel-hit", "opposite sides", known, u, (F(-6, 10), F(-8, 10)), P, Q)
    far = tuple(x + 10 ** 8 for x in P), tuple(x + 10 ** 8 for x in Q)
    write("far", "lines 1e8 away from the origin", known, u, (F(1), F(1)), *far)
    t = miss(8)
    write("far-and-parallel", "lines 1e8 away, 1e-8 rad from parallel", known, u, (u[0] - t * u[1], u[1] + t * u[0]),
          *far)
    write("tiny", "forces of 1e-9 N on lines 1e-9 m apart", tuple(x * miss(9) for x in known), u, (F(1), F(1)),
          tuple(x * miss(9) for x in P), tuple(x * miss(9) for x in Q))
    write("one-short-side", "one direction vector 1e-20 long", known, tuple(x * miss(20) for x in u), (F(1), F(1)), P, Q)
    w.print()


if __name__ == "__main__":
    {"circles": circles, "lines": lines}[sys.argv[1]]()
