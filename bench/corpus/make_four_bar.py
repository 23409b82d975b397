#!/usr/bin/env python3
"""Writes four_bar.txt: four-bar linkages at, and missed by little, their special positions.

  make_four_bar.py > four_bar.txt

Where a position is to be hit, the linkage is put together from Pythagorean directions, so that every point of it is
rational and the position is exact; a miss turns the crank by an angle whose half has the rational tangent 10^-k / 2.
"""
from fractions import Fraction as F

from mpmath import mpc, mpf, pi, sqrt

from hard import (Series, Writer, acceleration_pole, affine_motion, centre_of_curvature, clean, miss, number, pole,
                  rotated, turning)

HEAD = """
Four-bar linkages at and beside their special positions, 120 digits. Written by make_four_bar.py with mpmath, 600
working digits; do not edit by hand. Positions are the only formulas (A on its circle, B where two circles meet);
velocities and accelerations are coefficients of their power series in time. Nothing here is taken from the C++ code.

Givens: A0A, AB, B0B, the hinge B0 = (x_B0, y_B0) with A0 the origin; the crank's direction, `turn` from +x or the
vector (x_crank, y_crank) of any length; omega_2, alpha_2 (rad/s, rad/s²); C lies `along` AB from A and `across` to
its left, both in parts of AB. Choice: branch, the side of A -> B0 on which B lies.
transmission = AB x B0B / (AB B0B); P0 pole, K acceleration pole of the coupler; centre: of curvature of the path of C.
`absent`: at infinity. `FAMILY impossible`: the linkage does not close, or has no velocities there.
The questions is_... are of four-bar-position; coupler_turns and rocker_turns, the signs of omega_3 and omega_4, of
four-bar-second-order.
"""


def unit(x, y):
    """Of a Pythagorean pair."""
    h = F(x * x + y * y)
    root = F(int(sqrt(mpf(h.numerator))), int(sqrt(mpf(h.denominator))))
    assert root * root == h
    return (x / root, y / root)


class Linkage:
    """Put together from rational points and bars."""

    def __init__(self, A0A, AB, B0B, B0, crank=None, turn=None, branch="left", C=(F(1, 2), F(1, 5)),
                 omega_2=F(10), alpha_2=F(3)):
        self.A0A, self.AB, self.B0B, self.B0 = F(A0A), F(AB), F(B0B), tuple(F(x) for x in B0)
        self.crank, self.turn, self.branch = crank, turn, branch
        self.C, self.omega_2, self.alpha_2 = tuple(F(x) for x in C), F(omega_2), F(alpha_2)

    def but(self, **changes):
        values = dict(A0A=self.A0A, AB=self.AB, B0B=self.B0B, B0=self.B0, crank=self.crank, turn=self.turn,
                      branch=self.branch, C=self.C, omega_2=self.omega_2, alpha_2=self.alpha_2)
        values.update(changes)
        return Linkage(**values)

    def missed(self, half_tangent):
        return self.but(crank=rotated(self.crank, half_tangent))

    def scaled(self, s):
        return self.but(A0A=self.A0A * s, AB=self.AB * s, B0B=self.B0B * s, B0=tuple(x * s for x in self.B0))

    def turned_about_A0(self, half_tangent):
        t = F(half_tangent)
        B0 = tuple(x / (1 + t * t) for x in rotated(self.B0, t))
        return self.but(B0=B0, crank=rotated(self.crank, t))

    def givens(self):
        result = dict(A0A=self.A0A, AB=self.AB, B0B=self.B0B, x_B0=self.B0[0], y_B0=self.B0[1])
        if self.turn is not None:
            result["turn"] = self.turn
        else:
            result.update(x_crank=self.crank[0], y_crank=self.crank[1])
        result.update(omega_2=self.omega_2, alpha_2=self.alpha_2, along=self.C[0], across=self.C[1])
        return result

    def direction(self):
        if self.turn is not None:
            from mpmath import cos, sin
            angle = 2 * pi * number(self.turn)
            return mpc(cos(angle), sin(angle))
        return mpc(number(self.crank[0]), number(self.crank[1]))

    # ------------------------------------------------------------------------------------------------------------

    def references(self):
        size = number(max(self.A0A, self.AB, self.B0B))
        crank, l, s = number(self.A0A), number(self.AB), number(self.B0B)
        B0 = mpc(*(number(x) for x in self.B0))
        u = turning(self.direction(), number(self.omega_2), number(self.alpha_2))
        A = crank * u
        answers = {**self.special(u.value(), B0), "coupler_turns": "impossible", "rocker_turns": "impossible"}
        d = Series(B0) - A                    # A -> B0
        d2 = (d * d.conjugate()).real()
        if clean(d2.value(), size ** 2) == 0:
            return {"four-bar-position": "impossible", "four-bar-second-order": "impossible", **answers}
        # B = A + d (p + i q),  |AB| = l, |B0B| = s
        p = (d2 + l * l - s * s) / (2 * d2)
        q2 = l * l / d2 - p * p
        q2_now = clean(q2.value())
        if q2_now < 0:
            return {"four-bar-position": "impossible", "four-bar-second-order": "impossible", **answers}
        if q2_now == 0:
            B = A.value() + d.value() * p.value()
            return {"x_B": clean(B.real, size), "y_B": clean(B.imag, size), "transmission": mpf(0),
                    "four-bar-second-order": "impossible", **answers}
        q = q2.sqrt()
        B = A + d * (p + (1 if self.branch == "left" else -1) * mpc(0, 1) * q)
        return {**answers, **self.position(A, B, B0, l, s, size), **self.second_order(A, B, B0, size)}

    def position(self, A, B, B0, l, s, size):
        AB, B0B = B.value() - A.value(), B.value() - B0
        return {"x_B": clean(B.value().real, size), "y_B": clean(B.value().imag, size),
                "transmission": clean((AB.conjugate() * B0B).imag / (l * s))}

    def second_order(self, A, B, B0, size):
        omega_3, alpha_3, v_A, a_A = affine_motion(A, B)
        omega_4, alpha_4, _, _ = affine_motion(Series(B0), B)
        omega_3, omega_4, alpha_3, alpha_4 = (clean(x) for x in (omega_3, omega_4, alpha_3, alpha_4))
        C = A + (B - A) * mpc(number(self.C[0]), number(self.C[1]))
        v, a = mpc(C.rate()), mpc(C.second())
        curved = clean((v.conjugate() * a).imag, abs(v) * abs(a))
        P0, K = pole(A.value(), v_A, omega_3), acceleration_pole(A.value(), a_A, omega_3, alpha_3)
        centre = centre_of_curvature(C) if curved != 0 else None
        result = dict(omega_3=omega_3, omega_4=omega_4, alpha_3=alpha_3, alpha_4=alpha_4)
        for name, omega in (("coupler_turns", omega_3), ("rocker_turns", omega_4)):
            result[name] = "zero" if omega == 0 else "positive" if omega > 0 else "negative"
        for name, point in (("P0", P0), ("K", K), ("centre", centre)):
            result["x_" + name] = None if point is None else clean(point.real, size)
            result["y_" + name] = None if point is None else clean(point.imag, size)
        return result

    def special(self, u, B0):
        """What the position is, tried on the points themselves: is there a B that is what it would have to be?"""
        r, l, s = number(self.A0A), number(self.AB), number(self.B0B)
        size = max(r, l, s)
        A = r * u

        def is_zero(x):
            return clean(x, size) == 0

        def on_branch(B):
            side = clean(((B0 - A).conjugate() * (B - A)).imag, size ** 2)
            return side == 0 or (side > 0) == (self.branch == "left")

        def closed(B):
            return is_zero(abs(B - A) - l) and is_zero(abs(B - B0) - s) and on_branch(B)

        def word(truth):
            return "yes" if truth else "no"

        in_line = clean((B0.conjugate() * u).imag, size) == 0
        d = abs(B0 - A)
        extended, folded = is_zero(d - (l + s)), is_zero(d - abs(l - s))
        is_change = in_line and (extended or folded) and self.has_change_point(abs(B0))
        return {"is_dead_centre_extended": word(closed((r + l) * u)),
                "is_dead_centre_folded": word(closed((r - l) * u)),
                "is_parallel_same": word(closed(B0 + s * u)), "is_parallel_opposite": word(closed(B0 - s * u)),
                "is_limit_extended": word(extended), "is_limit_folded": word(folded),
                "is_change_point": word(is_change)}

    def has_change_point(self, frame):
        links = sorted([number(self.A0A), number(self.AB), number(self.B0B), frame])
        return clean(links[0] + links[3] - links[1] - links[2], links[3]) == 0


def at(A0A, crank, AB, coupler, B0B, rocker, **more):
    """The linkage whose bars lie along these Pythagorean directions: A, B and B0 are rational."""
    u, w, r = unit(*crank), unit(*coupler), unit(*rocker)
    A = tuple(F(A0A) * x for x in u)
    B = tuple(p + F(AB) * x for p, x in zip(A, w))
    B0 = tuple(p - F(B0B) * x for p, x in zip(B, r))
    d, AB_vector = (B0[0] - A[0], B0[1] - A[1]), (B[0] - A[0], B[1] - A[1])
    side = d[0] * AB_vector[1] - d[1] * AB_vector[0]
    return Linkage(A0A, AB, B0B, B0, crank=u, branch="left" if side >= 0 else "right", **more)


MISSES = (3, 8, 15, 22, 30)


def missed_and_hit(writer, name, why, linkage):
    writer.case(f"{name}-hit", f"{why}, exactly", linkage.givens(), {"branch": linkage.branch},
                linkage.references())
    for k in MISSES:
        for sign, side in ((1, "beyond"), (-1, "before")):
            if side == "before" and k not in (3, 30):
                continue
            near = linkage.missed(sign * miss(k) / 2)
            writer.case(f"{name}-{side}-1e-{k}", f"{why}, missed by {'' if sign > 0 else '-'}1e-{k} rad",
                        near.givens(), {"branch": near.branch}, near.references())


def write(writer, name, why, linkage):
    writer.case(name, why, linkage.givens(), {"branch": linkage.branch}, linkage.references())


def main():
    w = Writer(HEAD)
    plain = Linkage(F(3, 20), F(37, 100), F(9, 20), (F(-9, 50), F(-4, 25)), turn=F(1, 12), branch="right")
    write(w, "ordinary", "an ordinary position, for comparison: exercise N.3", plain)
    write(w, "ordinary-20-degrees", "a crank at 20 degrees: no tower of square roots holds it",
          plain.but(turn=F(1, 18)))

    write(w, "binary", "doubles hold the givens exactly, so that every error is one of rounding",
          Linkage(2, 4, F(9, 2), (F(3), F(1, 2)), crank=(F(1), F(3))))

    extended = at(F(3, 20), (3, 4), F(37, 100), (3, 4), F(9, 20), (-5, 12))
    folded = at(F(3, 20), (3, 4), F(37, 100), (-3, -4), F(9, 20), (8, 15))
    missed_and_hit(w, "dead-centre-extended", "crank and coupler in line, extended", extended)
    missed_and_hit(w, "dead-centre-folded", "crank and coupler in line, folded", folded)
    same = at(F(3, 20), (3, 4), F(37, 100), (12, -5), F(9, 20), (3, 4))
    opposite = at(F(3, 20), (3, 4), F(37, 100), (12, 5), F(9, 20), (-3, -4))
    missed_and_hit(w, "parallel-same", "crank and rocker parallel, pole at infinity", same)
    missed_and_hit(w, "parallel-opposite", "crank and rocker parallel and opposite, pole at infinity", opposite)
    limit = at(F(9, 20), (3, 4), F(37, 100), (12, 5), F(3, 20), (-12, -5))
    missed_and_hit(w, "limit-extended", "coupler and rocker in line, extended: the crank turns back", limit)
    fold = at(F(9, 20), (3, 4), F(37, 100), (12, 5), F(3, 20), (12, 5))
    missed_and_hit(w, "limit-folded", "coupler and rocker in line, folded: the crank turns back", fold)

    change = Linkage(2, 4, 5, (F(3), F(0)), crank=(F(1), F(0)), branch="left")   # 2 + 5 = 4 + 3
    for name, direction, linkage in (("change-point", (F(1), F(0)), change),
                                     ("parallelogram", (F(1), F(0)), Linkage(1, 2, 1, (F(2), F(0)))),
                                     ("kite", (F(1), F(0)), Linkage(1, 1, 2, (F(2), F(0))))):
        missed_and_hit(w, name, "a change point: all hinges in line, two motions leave", linkage.but(crank=direction))
    write(w, "change-point-almost", "shortest and longest link exceed the other two by 1e-30",
          change.but(AB=4 - miss(30)))
    write(w, "change-point-not-quite", "shortest and longest link fall short of the other two by 1e-30",
          change.but(AB=4 + miss(30)))
    write(w, "all-equal", "a rhombus, crank and frame at a right angle: parallel in every position",
          Linkage(1, 1, 1, (F(1), F(0)), crank=(F(3), F(4))))

    tiny = at(F(3, 20), (3, 4), F(37, 100), (12, 5), F(9, 20), (8, 15))
    write(w, "nanometre", "a linkage of 1e-9 m", tiny.scaled(miss(9)))
    write(w, "hundred-million", "a linkage of 1e8 m", tiny.scaled(F(10 ** 8)))
    far = Linkage(F(3, 20), 10 ** 8, 10 ** 8, (F(1, 4), F(0)), crank=(F(3), F(4)))
    write(w, "coupler-hinge-far-away", "B is 1e8 m away, where the two bars are almost parallel", far)
    lever = Linkage(F(3, 20), 10 ** 8, F(9, 20), (F(10 ** 8), F(1, 10)), crank=(F(3), F(4)))
    write(w, "rocker-far-away", "the rocker is 1e8 m away from the crank: its digits are lost against the frame", lever)
    write(w, "turned-by-1e-12", "everything turned by 1e-12 rad", tiny.turned_about_A0(miss(12) / 2))
    write(w, "turned-by-1e-12-dead-centre", "a dead centre turned by 1e-12 rad with the frame: still one",
          extended.turned_about_A0(miss(12) / 2))

    touching = at(F(3, 20), (3, 4), F(37, 100), (12, 5), F(1, 10 ** 12), (8, 15))
    write(w, "tiny-rocker", "a rocker 1e11 times shorter than the coupler", touching)
    gone = limit.but(AB=limit.AB - miss(30))
    write(w, "not-closed-by-1e-30", "the bars are 1e-30 m too short to close", gone)
    write(w, "closed-by-1e-30", "the bars are 1e-30 m longer than needed to close", limit.but(AB=limit.AB + miss(30)))
    for turn, why in ((F(1, 3), "120 degrees"), (F(1, 24), "15 degrees"), (F(1, 7), "a seventh of a turn"),
                      (F(5, 13), "five thirteenths of a turn"), (F(17, 97), "17/97 of a turn")):
        write(w, f"turn-{turn.numerator}-{turn.denominator}", f"a crank at {why}: how dear is a decision?",
              plain.but(turn=turn))
    for turn in (F(1, 18), F(1, 7), F(5, 13), F(17, 97)):
        for branch in ("left", "right"):
            for name, links in (("parallelogram", (2, 5, 2)), ("rhombus", (5, 5, 5)), ("kite", (3, 3, 5))):
                write(w, f"{name}-{branch}-{turn.numerator}-{turn.denominator}", f"a {name}, B on the {branch}: the root "
                      "of a square hides B from exact numbers", Linkage(*links, (F(5), F(0)), turn=turn,
                                                                         branch=branch))
    dead_at = Linkage(1, 3, 3, (F(1), F(0)), turn=F(1, 6))
    write(w, "dead-centre-at-60-degrees", "equal bars: folded dead centre where the crank is at 60 degrees",
          dead_at.but(A0A=F(1), AB=F(2), B0B=F(1), B0=(F(-1), F(0)), turn=F(1, 6)))
    w.print()


if __name__ == "__main__":
    main()
