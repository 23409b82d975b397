#!/usr/bin/env python3
"""Writes coupler_curve.txt: points of a four-bar's coupler whose path has a cusp or an inflection, hit and missed.

  make_coupler_curve.py > coupler_curve.txt

The linkages of make_four_bar.py with rational points have a rational pole, where the path of a coupler point has a
cusp; and every line through it meets the inflection circle once more in a rational point.
"""
from fractions import Fraction as F

from mpmath import mpc

from hard import Series, Writer, affine_motion, clean, miss, number, turning
from make_four_bar import Linkage, at

HEAD = """
Coupler points at and beside cusps and inflections of their paths, 120 digits. Written by make_coupler_curve.py with
mpmath, 600 working digits; do not edit by hand. Velocity and acceleration are coefficients of the power series of the
position. Nothing here is taken from the C++ code.

Givens as in four_bar.txt. bend: v x a of C, m²/s³, whose sign is the question bends_to; radius: of curvature, `absent`
where bend is zero.
"""


def complex_of(p):
    return mpc(number(p[0]), number(p[1]))


class Rational2:
    """Complex numbers with rational parts."""

    def __init__(self, x, y=0):
        self.x, self.y = F(x), F(y)

    def __add__(self, o):
        return Rational2(self.x + o.x, self.y + o.y)

    def __sub__(self, o):
        return Rational2(self.x - o.x, self.y - o.y)

    def __mul__(self, o):
        return Rational2(self.x * o.x - self.y * o.y, self.x * o.y + self.y * o.x)

    def __truediv__(self, o):
        n = o.x * o.x + o.y * o.y
        return Rational2((self.x * o.x + self.y * o.y) / n, (self.y * o.x - self.x * o.y) / n)

    def dot(self, o):
        return self.x * o.x + self.y * o.y

    def cross(self, o):
        return self.x * o.y - self.y * o.x


def state(linkage, A, B):
    """Rational A, B, omega_3, alpha_3, v_A, a_A of a linkage of rational points, by solving its closure."""
    i, w2, e2 = Rational2(0, 1), linkage.omega_2, linkage.alpha_2
    B0 = Rational2(*linkage.B0)
    r2, r3, r4 = A, B - A, B - B0

    def solve(known):   # known + i x r3 = i y r4
        a, b = i * r3, i * r4
        return known.cross(b) / b.cross(a), known.cross(a) / b.cross(a)

    v_A = i * Rational2(w2) * r2
    w3, w4 = solve(v_A)
    a_A = Rational2(-w2 * w2, e2) * r2
    e3, e4 = solve(a_A - Rational2(w3 * w3) * r3 + Rational2(w4 * w4) * r4)
    return w3, e3, v_A, a_A


def special_points(linkage, A, B):
    """In parts of AB: the pole, and a point of the inflection circle on the ray along `direction` from it."""
    w, e, v_A, a_A = state(linkage, A, B)
    i, AB = Rational2(0, 1), B - A
    P0 = A + i * v_A / Rational2(w)
    a_P = a_A + Rational2(-w * w, e) * (P0 - A)
    J = P0 + a_P / Rational2(w * w)
    ray = Rational2(2, 1)
    X = P0 + ray * Rational2(ray.dot(J - P0) / ray.dot(ray))
    return [((Z - A) / AB) for Z in (P0, X, J)]


def references(linkage):
    crank, l, s = number(linkage.A0A), number(linkage.AB), number(linkage.B0B)
    B0 = complex_of(linkage.B0)
    A = crank * turning(linkage.direction(), number(linkage.omega_2), number(linkage.alpha_2))
    d = Series(B0) - A
    d2 = (d * d.conjugate()).real()
    p = (d2 + l * l - s * s) / (2 * d2)
    B = A + d * (p + (1 if linkage.branch == "left" else -1) * mpc(0, 1) * (l * l / d2 - p * p).sqrt())
    C = A + (B - A) * complex_of(linkage.C)
    v, a = mpc(C.rate()), mpc(C.second())
    v = mpc(clean(v.real), clean(v.imag))
    bend = clean((v.conjugate() * a).imag)
    sign = "zero" if bend == 0 else "positive" if bend > 0 else "negative"
    return {"x_C": clean(C.value().real), "y_C": clean(C.value().imag), "v_x": v.real, "v_y": v.imag, "bend": bend,
            "radius": None if bend == 0 else abs(v) ** 3 / abs(bend), "bends_to": sign}


def main():
    w = Writer(HEAD)

    def write(name, why, linkage):
        w.case(name, why, linkage.givens(), {"branch": linkage.branch}, references(linkage))

    for k, linkage in enumerate((at(F(3, 20), (3, 4), F(37, 100), (12, 5), F(9, 20), (-8, 15)),
                                 at(F(3, 20), (5, 12), F(37, 100), (4, -3), F(9, 20), (3, 4)))):
        A = Rational2(*(linkage.A0A * x for x in linkage.crank))
        if k == 0:
            B = A + Rational2(F(37, 100) * F(12, 13), F(37, 100) * F(5, 13))
        else:
            B = A + Rational2(F(37, 100) * F(4, 5), F(37, 100) * F(-3, 5))
        for name, what, C in zip(("cusp", "inflection", "ball"),
                                 ("C is the pole: a cusp", "C on the inflection circle",
                                  "C is the inflection pole: an inflection, square to the ray"),
                                 special_points(linkage, A, B)):
            write(f"{name}-{k + 1}-hit", f"{what}, exactly", linkage.but(C=(C.x, C.y)))
            for n in (3, 8, 15, 22, 30):
                write(f"{name}-{k + 1}-beyond-1e-{n}", f"{what}, missed by 1e-{n} AB",
                      linkage.but(C=(C.x + miss(n), C.y)))
            write(f"{name}-{k + 1}-before-1e-30", f"{what}, missed by -1e-30 AB",
                  linkage.but(C=(C.x - miss(30), C.y)))
    write("binary", "doubles hold the givens exactly, so that every error is one of rounding",
          Linkage(2, 4, F(9, 2), (F(3), F(1, 2)), crank=(F(1), F(3)), C=(F(1, 2), F(1, 4))))
    write("far", "C is 1e8 times AB away", linkage.but(C=(F(10 ** 8), F(10 ** 8) + 1)))
    w.print()


if __name__ == "__main__":
    main()
