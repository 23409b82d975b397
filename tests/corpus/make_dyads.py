#!/usr/bin/env python3
"""Writes dyads.txt: reference values of the dyads RRP, PRP and RPR on moving bodies, independent of the C++ code.

Only positions are written down here, as functions of time, with complex numbers. Rates, velocities and accelerations
are high-precision numerical derivatives of them (mpmath.diff): no formula of relative motion is used, so that no
Coriolis term can be forgotten in the same way twice.
Usage: make_dyads.py > dyads.txt
"""
from fractions import Fraction

from mpmath import arg, asin, conj, diff, expj, im, mp, mpc, mpf, nstr, pi, re, sqrt

mp.dps = 120            # differentiation costs digits
DIGITS = 40
ZERO = mpf(10) ** -60   # far above the noise of differentiation, far below any value here

BODY = dict(x="0", y="0", turn="0", omega="0", alpha="0", arm="0", offset="0")


def number(q):
    q = Fraction(q)
    return mpf(q.numerator) / q.denominator


class Body:
    """Turns about a fixed pivot; carries a point at the distance `arm` and a guide at `offset` to the left of the
    pivot, both in the direction `turn` at t = 0."""

    def __init__(self, **given):
        self.given = {**BODY, **given}
        q = {k: number(v) for k, v in self.given.items()}
        self.pivot = mpc(q["x"], q["y"])
        self.direction = lambda t: expj(2 * pi * q["turn"] + q["omega"] * t + q["alpha"] * t ** 2 / 2)
        self.point = lambda t: self.pivot + q["arm"] * self.direction(t)
        self.guide = lambda t: self.pivot + q["offset"] * mpc(0, 1) * self.direction(t)


def real_diff(f, n):
    return mpc(diff(lambda t: re(f(t)), 0, n), diff(lambda t: im(f(t)), 0, n))


def angle_from_start(z):
    """The angle of z(t) against z(0): no cut of the logarithm is near."""
    return lambda t: arg(z(t) / z(mpf(0)))


def RRP(one, other, length, along):
    """A bar about the point of `one`, and the guide of `other`. Rates: of the bar, and along the guide."""
    def reached(t):
        s, P = other.direction(t), one.point(t)
        local = conj(s) * (P - other.guide(t))
        return re(local) + along * sqrt(length ** 2 - im(local) ** 2)

    X = lambda t: other.guide(t) + reached(t) * other.direction(t)
    return X, angle_from_start(lambda t: X(t) - one.point(t)), reached


def PRP(one, other):
    """Two guides. Rates: along each."""
    def reached(guided, by):  # along the guide of `guided`, where the guide of `by` crosses it
        def f(t):
            n = mpc(0, 1) * by.direction(t)
            dot = lambda a, b: re(conj(a) * b)
            return dot(n, by.guide(t) - guided.guide(t)) / dot(n, guided.direction(t))
        return f

    first, second = reached(one, other), reached(other, one)
    return lambda t: one.guide(t) + first(t) * one.direction(t), first, second


def RPR(one, other, offset):
    """A body hinged to the point of `other`, in whose slot the point of `one` runs. Rates: of the body, and of the
    pin along the slot. X is the point of the slotted body under the pin."""
    QP = lambda t: one.point(t) - other.point(t)
    reached = lambda t: sqrt(abs(QP(t)) ** 2 - offset ** 2)
    slot = lambda t: QP(t) / mpc(reached(t), offset)  # |QP| in every sense: a unit vector
    here = QP(mpf(0)) / slot(mpf(0))
    return lambda t: other.point(t) + here * slot(t), angle_from_start(slot), reached, slot


def values(kind, one, other, length=None, along=None, offset=None):
    out = {}
    if kind == "RRP":
        X, first, second = RRP(one, other, number(length), 1 if along == "ahead" else -1)
    elif kind == "PRP":
        X, first, second = PRP(one, other)
    else:
        X, first, second, slot = RPR(one, other, number(offset))
        out["slot_x"], out["slot_y"] = re(slot(mpf(0))), im(slot(mpf(0)))
    for name, z in (("X", X(mpf(0))), ("v_X", real_diff(X, 1)), ("a_X", real_diff(X, 2))):
        out[name + "_x"], out[name + "_y"] = re(z), im(z)
    for name, f in (("first", first), ("second", second)):
        out[name + "_rate"], out[name + "_rate_dot"] = diff(f, 0), diff(f, 0, 2)
    return out


def cases():
    crank = Body(turn="1/12", omega="3", alpha="-2", arm="1/5")
    idle = Body(x="1/2", y="1/10")
    guide = Body(x="1/2", y="1/10", turn="1/8", omega="-2", alpha="5", offset="1/20")
    rocker = Body(x="3/5", y="-1/10", turn="3/8", omega="1", alpha="4", arm="1/10", offset="-1/10")
    yield ("rrp_fixed_guide", "offset slider-crank: no Coriolis term", "RRP", crank, idle,
           dict(length="1/2", along="ahead"))
    for along in ("ahead", "behind"):
        yield (f"rrp_turning_guide_{along}", "the guide turns: Coriolis term of the sliding joint", "RRP", crank, guide,
               dict(length="1/2", along=along))
    yield ("rrp_seventh", "directions that no field holds", "RRP", Body(turn="1/7", omega="-1", alpha="1", arm="3/10"),
           Body(x="2/5", turn="2/9", omega="7/3", alpha="-1/3", offset="-1/30"), dict(length="2/5", along="ahead"))
    yield ("rrp_bar_at_rest", "only the guide moves", "RRP", Body(turn="1/12", arm="1/5"), guide,
           dict(length="1/2", along="behind"))
    yield ("prp_two_turning_guides", "Coriolis terms on both sides", "PRP", rocker, guide, {})
    yield ("prp_one_fixed", "a pin between a turning slot and a fixed guide", "PRP", rocker,
           Body(y="1/5"), {})
    yield ("prp_equal_speeds", "both guides turn alike: they keep their angle", "PRP",
           Body(turn="1/12", omega="2", offset="1/10"), Body(x="1", turn="1/3", omega="2"), {})
    yield ("rpr_centred", "slotted rocker, the slot through its pivot", "RPR", crank, Body(x="-1/2", y="-1/5"),
           dict(offset="0"))
    yield ("rpr_offset", "the slot passes the pivot on its left", "RPR", crank, Body(x="-1/2", y="-1/5"),
           dict(offset="1/10"))
    yield ("rpr_offset_right", "and on its right", "RPR", crank, Body(x="-1/2", y="-1/5"), dict(offset="-1/10"))
    yield ("rpr_moving_pivot", "the slotted body is carried by a moving hinge", "RPR", crank, rocker,
           dict(offset="1/25"))
    yield ("rpr_seventh", "directions that no field holds", "RPR", Body(turn="1/7", omega="-4", alpha="9", arm="3/10"),
           Body(x="2/5", turn="2/9", omega="7/3", alpha="-1/3", arm="1/8"), dict(offset="1/10"))


HEADER = """\
# Reference values of dyads on moving bodies, 40 digits. Written by make_dyads.py with mpmath, 120 working digits; do
# not edit by hand. Positions are the only formulas; rates, velocities and accelerations are numerical derivatives.
# Nothing here is taken from the C++ code.
#
# Two bodies, one and other: each turns about the fixed pivot (x, y) with omega, alpha, carries a point at the distance
# arm from it in the direction turn (a fraction of a turn from +x), and a guide in that direction that passes the pivot
# at offset, positive when it passes on its left.
# RRP: a bar of `length` about the point of one, and the guide of other; X ahead of or behind the foot. Rates: angular
#      velocity of the bar, sliding along the guide of other.
# PRP: X where the guide of one crosses that of other. Rates: sliding along each.
# RPR: a body hinged to the point of other, in whose slot, at `offset` to the left of the hinge, the point of one runs,
#      ahead. X is the slotted body's own point under the pin. Rates: its angular velocity, sliding of the pin along the
#      slot (slot_x, slot_y).
# SI units; counter-clockwise positive; *_dot: derivative of the rate.
"""


def text(value):
    return "0" if abs(value) < ZERO else nstr(value, DIGITS, min_fixed=-3, max_fixed=3)


def main():
    print(HEADER, end="")
    for name, why, kind, one, other, more in cases():
        print(f"\ncase {name}\nwhy {why}")
        for body, label in ((one, "one"), (other, "other")):
            for k, v in body.given.items():
                print(f"given {label}.{k} {v}")
        print(f"choice kind {kind}")
        for k, v in more.items():
            print(f"{'choice' if k == 'along' else 'given'} {k} {v}")
        for k, v in values(kind, one, other, **more).items():
            print(k, text(v))


if __name__ == "__main__":
    main()
