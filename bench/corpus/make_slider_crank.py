#!/usr/bin/env python3
"""Writes slider-cranks at, and missed by little, their special positions: two corpora.

  make_slider_crank.py motion > slider_crank.txt
  make_slider_crank.py polodes > polodes.txt
"""
import sys
from fractions import Fraction as F

from mpmath import cos, mpc, mpf, pi, sin, sqrt

from hard import (Series, Writer, acceleration_pole, affine_motion, centre_of_curvature, clean, miss, number, pole,
                  rotated, turning)

GIVENS = """
Givens: crank r, coupler l, plate sides AC and BC (C on the left of A -> B), the guide's distance e from A0 (positive
when it lies on the left of A0) and its direction (x_guide, y_guide); the crank's direction, `turn` from +x or the
vector (x_crank, y_crank); omega_2, alpha_2 (rad/s, rad/s²). B lies ahead of the foot of A on the guide.
`absent`: at infinity. `FAMILY impossible`: the linkage does not close, or has no velocities there."""

MOTION = """
Slider-cranks at and beside their special positions, 120 digits. Written by make_slider_crank.py motion with mpmath,
600 working digits; do not edit by hand. Positions are the only formulas; velocities and accelerations are coefficients
of their power series in time. Nothing here is taken from the C++ code.
""" + GIVENS + """
P0 pole, K acceleration pole of the coupler; centre: of curvature of the path of C; v_B, a_B along the guide.
Questions: signs of alpha_3 (coupler_accelerates), of the crank's component along the guide (crank_ahead, zero where the pole is at infinity) and to its
left (crank_beside, zero at a dead centre when e = 0); room_to_guide: l² less A's distance from the guide squared.
"""

POLODES = """
Points of both polodes of the slider-crank, 120 digits. Written by make_slider_crank.py polodes with mpmath, 600
working digits; do not edit by hand. The pole is where the normals of two paths meet, their tangents being the rates of
power series in time; the moving polode's point is that point seen from the coupler (complex division by AB) and drawn
on the coupler of the position with the crank along +x. Nothing here is taken from the C++ code.
""" + GIVENS


class SliderCrank:
    def __init__(self, r=F(1, 5), l=F(1, 2), AC=F(3, 10), BC=F(2, 5), e=0, guide=(1, 0), crank=None, turn=None,
                 omega_2=10, alpha_2=3):
        self.values = dict(r=F(r), l=F(l), AC=F(AC), BC=F(BC), e=F(e), guide=tuple(F(x) for x in guide), crank=crank,
                           turn=turn, omega_2=F(omega_2), alpha_2=F(alpha_2))
        self.__dict__.update(self.values)

    def but(self, **changes):
        return SliderCrank(**{**self.values, **changes})

    def missed(self, half_tangent):
        return self.but(crank=rotated(self.crank, half_tangent))

    def scaled(self, s):
        return self.but(**{k: self.values[k] * s for k in ("r", "l", "AC", "BC", "e")})

    def givens(self):
        v = self.values
        result = {k: v[k] for k in ("r", "l", "AC", "BC", "e")}
        result.update(x_guide=self.guide[0], y_guide=self.guide[1])
        if self.turn is not None:
            result["turn"] = self.turn
        else:
            result.update(x_crank=self.crank[0], y_crank=self.crank[1])
        result.update(omega_2=self.omega_2, alpha_2=self.alpha_2)
        return result

    def direction(self):
        if self.turn is not None:
            angle = 2 * pi * number(self.turn)
            return mpc(cos(angle), sin(angle))
        return mpc(number(self.crank[0]), number(self.crank[1]))

    def closed(self, direction=None):
        """A, B as series; B None when it does not close, and not a series where the coupler is square to the guide."""
        r, l, e = number(self.r), number(self.l), number(self.e)
        g = mpc(*(number(x) for x in self.guide))
        g /= abs(g)
        u = turning(self.direction() if direction is None else direction, number(self.omega_2), number(self.alpha_2))
        A = r * u
        seen = A * g.conjugate()
        room = l * l - (seen.imag() - e) * (seen.imag() - e)
        now = clean(room.value(), l * l)
        if now <= 0:
            return A, None, now, seen
        return A, g * (seen.real() + room.sqrt() + Series(mpc(0, e))), now, seen

    def signs(self, room):
        g = mpc(*(number(x) for x in self.guide))
        seen = self.direction() * g.conjugate() / abs(self.direction()) / abs(g)

        def word(x):
            x = clean(x)
            return "zero" if x == 0 else "positive" if x > 0 else "negative"

        return {"crank_ahead": word(seen.real), "crank_beside": word(seen.imag), "room_to_guide": word(room)}

    def motion(self):
        A, B, room, _ = self.closed()
        signs = self.signs(room)
        if B is None:
            return {"slider-crank-second-order": "impossible", "coupler_accelerates": "impossible", **signs}
        size = number(self.l)
        l, AC, BC = number(self.l), number(self.AC), number(self.BC)
        along = (AC * AC + l * l - BC * BC) / (2 * l)
        C = A + (B - A) * (mpc(along, sqrt(clean(AC * AC - along * along, l * l))) / l)
        omega, alpha, v_A, a_A = affine_motion(A, B)
        omega, alpha = clean(omega), clean(alpha)
        g = mpc(*(number(x) for x in self.guide))
        g /= abs(g)
        v, a = mpc(C.rate()), mpc(C.second())
        curved = clean((v.conjugate() * a).imag, abs(v) * abs(a))
        points = dict(B=B.value(), C=C.value(), P0=pole(A.value(), v_A, omega),
                      K=acceleration_pole(A.value(), a_A, omega, alpha),
                      centre=centre_of_curvature(C) if curved != 0 else None)
        result = dict(omega_3=omega, alpha_3=alpha, v_B=clean((B.rate() / g).real), a_B=clean((B.second() / g).real))
        for name, point in points.items():
            result["x_" + name] = None if point is None else clean(point.real, size)
            result["y_" + name] = None if point is None else clean(point.imag, size)
        accelerates = "zero" if alpha == 0 else "positive" if alpha > 0 else "negative"
        return {**result, "coupler_accelerates": accelerates, **signs}

    def polodes(self):
        A, B, room, seen = self.closed()
        if B is None and room < 0:
            return {"polode-point": "impossible"}
        A_ref, B_ref, _, _ = self.closed(mpc(1, 0))
        absent = dict(x_fixed=None, y_fixed=None, x_moving=None, y_moving=None)
        if B is None:  # the coupler stands on the guide: its line is the normal at B, and meets the crank in A
            if clean(seen.value().real) == 0:
                return absent
            P0, moving = A.value(), A_ref.value()
        else:
            omega, _, v_A, _ = affine_motion(A, B)
            if clean(omega) == 0:
                return absent
            P0 = pole(A.value(), v_A, omega)
            on_coupler = (P0 - A.value()) / (B.value() - A.value())
            moving = A_ref.value() + on_coupler * (B_ref.value() - A_ref.value())
        size = number(self.l)
        return dict(x_fixed=clean(P0.real, size), y_fixed=clean(P0.imag, size), x_moving=clean(moving.real, size),
                    y_moving=clean(moving.imag, size))


MISSES = (3, 8, 15, 22, 30)


def cases(kind):
    def write(name, why, linkage):
        w.case(name, why, linkage.givens(), {}, getattr(linkage, kind)())

    def missed_and_hit(name, why, linkage):
        write(f"{name}-hit", f"{why}, exactly", linkage)
        for k in MISSES:
            write(f"{name}-beyond-1e-{k}", f"{why}, missed by 1e-{k} rad", linkage.missed(miss(k) / 2))
        write(f"{name}-before-1e-30", f"{why}, missed by -1e-30 rad", linkage.missed(-miss(30) / 2))

    w = Writer(MOTION if kind == "motion" else POLODES)
    plain = SliderCrank(turn=F(1, 12))
    at = plain.but(turn=None)
    write("ordinary", "an ordinary position, for comparison: exercise N.1", plain)
    write("binary", "doubles hold the givens exactly, so that every error is one of rounding",
          at.but(r=F(3, 2), l=F(7, 2), AC=F(3), BC=F(2), crank=(F(1), F(3))))
    missed_and_hit("square", "crank square to the guide: the pole is at infinity", at.but(crank=(F(0), F(1))))
    missed_and_hit("square-offset", "the same with the guide beside A0", at.but(crank=(F(0), F(-1)), e=F(1, 20)))
    # A at the height l over the guide: (3/5) r = l
    limit = at.but(r=F(5, 6), crank=(F(-4), F(3)))
    missed_and_hit("limit", "coupler square to the guide: the crank turns back", limit)
    missed_and_hit("equal-links", "equal links, crank square to the guide: B on A0 and any coupler direction",
                   at.but(r=F(1, 2), crank=(F(0), F(1))))
    if kind == "motion":
        missed_and_hit("dead-centre-outer", "crank and coupler in line along the guide", at.but(crank=(F(1), F(0))))
        missed_and_hit("dead-centre-inner", "crank folded onto the coupler", at.but(crank=(F(-1), F(0))))
        # (r + l) 3/5 = e
        missed_and_hit("dead-centre-offset", "crank and coupler in line, the guide beside A0",
                       at.but(e=F(21, 50), crank=(F(4), F(3))))
        write("flat-plate", "C on AB: its own circles touch", plain.but(AC=F(1, 5), BC=F(3, 10)))
        for turn in (F(6, 13), F(1, 13), F(5, 17), F(17, 97)):
            write(f"equal-links-{turn.numerator}-{turn.denominator}", "equal links: the coupler mirrors the crank, "
                  "alpha_3 is zero at constant speed, and the root of a square hides it from exact numbers",
                  plain.but(r=F(1, 2), turn=turn, alpha_2=0))
        write("nanometre", "a slider-crank of 1e-9 m", plain.scaled(miss(9)))
        write("hundred-million", "a slider-crank of 1e8 m", plain.scaled(F(10 ** 8)))
        write("long-coupler", "a coupler of 1e8 m on a crank of 0.2 m", plain.but(l=10 ** 8, AC=10 ** 8 - F(1, 10),
                                                                                 BC=F(2, 5)))
        t = miss(12) / 2
        write("turned-by-1e-12", "the guide turned by 1e-12 rad, the crank not: almost a dead centre",
              at.but(guide=rotated((F(1), F(0)), t), crank=(F(1), F(0))))
        write("turned-together-by-1e-12", "guide and crank turned by 1e-12 rad: still a dead centre",
              at.but(guide=rotated((F(1), F(0)), t), crank=rotated((F(1), F(0)), t)))
        write("K-on-inclined-guide", "a guide inclined by a Pythagorean angle, the crank along it",
              at.but(guide=(F(3), F(4)), crank=(F(3), F(4)), alpha_2=0))
    w.print()


if __name__ == "__main__":
    cases(sys.argv[1])
