#!/usr/bin/env python3
"""Writes roulettes.txt: reference values for points carried by a rolling circle or line, independent of the C++ code.

  make_roulettes.py > roulettes.txt     (three minutes)

Only positions are written down: of the tracing point and of one more point of the rolling plane, which together fix
its motion. Velocities, accelerations and the inflection pole are high-precision numerical derivatives of these, the
arc length is a numerical integral of the speed found so, in pieces that grow tenfold away from a cusp.
"""
from fractions import Fraction
from sys import argv

from mpmath import diff, exp, fabs, floor, im, mp, mpc, mpf, nstr, pi, quad, re

mp.dps = 150
ZERO = mpf(10) ** -110  # what numerical differentiation leaves of a zero is smaller, everything else is larger
I = mpc(0, 1)


def number(rational):
    q = Fraction(rational)
    return mpf(q.numerator) / q.denominator


LINE, OUTSIDE, INSIDE, UNWOUND = "circle_on_line", "circle_outside_circle", "circle_inside_circle", "line_on_circle"
BASE = {
    LINE: dict(r="1/5", d="1/5"),
    OUTSIDE: dict(r="5/11", R="7/3", d="5/11"),
    INSIDE: dict(r="5/11", R="7/3", d="5/11"),
    UNWOUND: dict(R="7/3", d="0"),
}
OFF = [("nine", "1e-9"), ("fifteen", "1e-15"), ("thirty", "1e-30")]


def ground_per_turned(how, given):
    """dpsi/dphi, as a fraction."""
    r, R = Fraction(given.get("r", "0")), Fraction(given.get("R", "0"))
    return {LINE: Fraction(1), UNWOUND: Fraction(1), OUTSIDE: R / (R + r) if R + r else 0,
            INSIDE: R / (R - r) if R - r else 0}[how]


def cases():
    for how, base in BASE.items():
        def case(name, why, how=how, base=base, **changes):
            return how + "." + name, why, how, {**dict(turns="0", radians="0", omega="5/2", alpha="-3/4"), **base,
                                                **changes}
        cusp = "0" if how == UNWOUND else str(2 / ground_per_turned(how, base))
        yield case("plain", "30 degrees", turns="1/12")
        yield case("backwards", "rolled the other way, faster and faster", turns="-2/9", omega="-3", alpha="-1")
        yield case("radians", "an angle of 2 rad", radians="2")
        yield case("both", "many turns and a rest in radians", turns="37/5", radians="-1/3", alpha="0")
        yield case("cusp", "at a cusp", turns=cusp)
        for name, off in OFF:
            yield case("past_cusp_" + name, "past a cusp by " + off + " rad", turns=cusp, radians=off)
            yield case("before_cusp_" + name, "short of a cusp by " + off + " rad", turns=cusp, radians="-" + off)
        if how == UNWOUND:
            yield case("curtate", "the point on the near side of the line", d="4/7", turns="3/10")
            yield case("prolate", "the point beyond the line", d="-4/7", turns="3/10")
            yield case("archimedean", "d = R: the spiral of Archimedes, through the centre", d="7/3", turns="3/10")
            for name, off in OFF:
                yield case("misses_cusp_" + name, "misses a cusp by " + off, d=off)
        else:
            r = Fraction(base["r"])
            yield case("curtate", "inside the rim", d=str(r / 3), turns="3/10")
            yield case("prolate", "outside the rim", d=str(r * 9 / 4), turns="-3/10")
            yield case("middle", "past the middle of the third arch, prolate", d=str(r * 9 / 4), radians="19")
            yield case("centre", "the centre itself", d="0", turns="1/7")
            yield case("half_an_arch", "curtate, at the exact middle of an arch", d=str(r / 3),
                       turns=str(Fraction(1, 2) / ground_per_turned(how, base)))
            for name, off in OFF:
                yield case("curtate_by_" + name, "misses the cusp it is at by " + off, turns=cusp,
                           d=str(r * (1 - Fraction(off))))
                yield case("prolate_by_" + name, "turns in a loop of " + off, turns=cusp,
                           d=str(r * (1 + Fraction(off))))
    more = dict(omega="5/2", alpha="-3/4", radians="0")
    yield "cardioid", "R = r", OUTSIDE, dict(more, r="1", R="1", d="1", turns="2/5")
    yield "nephroid_cusp", "R = 2 r, at the second cusp", OUTSIDE, dict(more, r="1", R="2", d="1", turns="3")
    yield "large_outside", "R = r/3: more than a turn between cusps", OUTSIDE, dict(more, r="3", R="1", d="3", turns="5")
    yield "wheel_in_ring", "nearly as large as its ring", INSIDE, dict(more, r="99", R="100", d="99", turns="3/1000")
    yield "pebble_on_planet", "R = 1e6 r", OUTSIDE, dict(more, r="1", R="1000000", d="1", turns="1/8")
    yield "deltoid", "R = 3 r", INSIDE, dict(more, r="1", R="3", d="1", turns="5/12")
    yield "astroid_cusp", "R = 4 r, at a cusp", INSIDE, dict(more, r="1", R="4", d="1", turns="3/4")
    yield "la_hire", "R = 2 r: a straight line", INSIDE, dict(more, r="1", R="2", d="1", turns="1/7")
    yield "la_hire_turning", "R = 2 r, where the point turns back", INSIDE, dict(more, r="1", R="2", d="1", turns="1/2")
    yield "ellipse", "R = 2 r, off the rim", INSIDE, dict(more, r="1", R="2", d="3/5", turns="1/7")
    yield "inflection", "curtate cycloid at its inflection, cos phi = d/r", LINE, dict(more, r="1", d="1/2", turns="1/6")
    yield "at_rest", "neither speed nor acceleration", LINE, dict(r="1", d="1", omega="0", alpha="0", turns="1/3",
                                                                  radians="0")


def paths(how, given):
    """Of the tracing point and of the rolling circle's centre (of a line: its point that was first touched)."""
    r, R, d = (number(given.get(k, "0")) for k in ("r", "R", "d"))
    if how == LINE:
        return (lambda p: mpc(r * p, r) - I * d * exp(-I * p), lambda p: mpc(r * p, r), -1)
    if how == OUTSIDE:
        c = lambda p: (R + r) * exp(I * p * r / (R + r))
        return (lambda p: c(p) - d * exp(I * p), c, 1)
    if how == INSIDE:
        c = lambda p: (R - r) * exp(I * p * r / (R - r))
        return (lambda p: c(p) + d * exp(-I * p), c, -1)
    line = lambda p: R * exp(I * p) * (1 - I * p)
    return (lambda p: line(p) - d * exp(I * p), line, 1)


def text(x):
    return "0" if fabs(x) <= ZERO else nstr(x, 40, strip_zeros=True, min_fixed=-30, max_fixed=30)


def length(path, phi, period):
    """Of the path from 0 to phi; cusps and near misses are at whole periods."""
    if phi < 0:
        return -length(lambda p: path(-p), -phi, period)
    mp.dps = 110 if phi < mpf(10) ** -5 else 60  # the speed may be as small as the angle
    speed = lambda p: fabs(diff(path, p))
    marks = [mpf(k) * period for k in range(int(floor(phi / period)) + 2)] if period else [mpf(0), phi + 1]
    total = mpf(0)
    for start, end in zip(marks, marks[1:]):
        half = min((start + end) / 2, phi)
        cuts = [start] + [start + (half - start) / mpf(10) ** k for k in range(36, -1, -1)]
        total += quad(speed, cuts)
        if phi > half:
            stop = min(end, phi)
            cuts = [half] + [end - (end - half) / mpf(10) ** k for k in range(1, 37) if
                             end - (end - half) / mpf(10) ** k < stop] + [stop]
            total += quad(speed, cuts)
        if phi <= end:
            break
    mp.dps = 150
    return total


def values(how, given):
    omega, alpha = number(given["omega"]), number(given["alpha"])
    phi = 2 * pi * number(given["turns"]) + number(given["radians"])
    path, carrier, sense = paths(how, given)
    z, c = path(phi), carrier(phi)
    z1, z2, c1, c2 = (diff(f, phi, n) for f in (path, carrier) for n in (1, 2))
    v, a = omega * z1, omega**2 * z2 + alpha * z1
    J = c + c2  # the acceleration of the pole P = c + i c'/sense is c'' - (P - c), for omega = 1
    P = c + I * c1 / sense
    found = [("x", re(z)), ("y", im(z)), ("P0_x", re(P)), ("P0_y", im(P)), ("J_x", re(J)), ("J_y", im(J)),
             ("v_x", re(v)), ("v_y", im(v)), ("a_x", re(a)), ("a_y", im(a)), ("v", fabs(v)), ("a", fabs(a))]
    is_cusp = fabs(z1) <= ZERO
    speed = fabs(z1)
    bend = im(z1.conjugate() * z2)
    straight = fabs(bend) <= ZERO * (1 if is_cusp else speed**3)
    if not is_cusp:
        if straight:
            found += [("rho", None)]
        else:
            centre = z + I * z1 * speed**2 / bend
            found += [("rho", speed**3 / fabs(bend)), ("Omega_x", re(centre)), ("Omega_y", im(centre))]
        if omega != 0:
            direction = z1 / speed * (1 if omega > 0 else -1)
            component = re(direction.conjugate() * a)
            found += [("a_n", fabs(im(direction.conjugate() * a))), ("a_t_before", component),
                      ("a_t_after", component)]
    else:
        # Beside the cusp, by the values at small steps to both sides: their limit is that of the first-order terms.
        third = diff(path, phi, 3)
        small = fabs(im(z2.conjugate() * third))  # curvature near the cusp is this/(2 |z2|^3 |step|)... or none
        found += [("rho", None if small <= ZERO else mpf(0)), ("a_n", mpf(0)), ("a_t_before", -omega**2 * fabs(z2)),
                  ("a_t_after", omega**2 * fabs(z2))]
    ratio = ground_per_turned(how, given)
    period = 0 if how == UNWOUND else 2 * pi / number(ratio)
    found.append(("s", length(path, phi, period)))
    return found


def main():
    print("""# Reference values of roulettes, 40 digits. Written by make_roulettes.py with mpmath, 150 working digits; do not edit
# by hand. Positions are the only formulas: all else are their derivatives, and integrals of these.
# Axes and the sense of phi as in geometry/motion/rolling.h; angle = 2 pi turns + radians; omega = dphi/dt, alpha its
# derivative. P0 contact, J inflection pole, Omega centre of curvature, s arc length from phi = 0, signed. a_t on both
# sides, which differ at a cusp. `infinite`: a straight path. SI units.""")
    for name, why, how, given in cases():
        if len(argv) > 1 and name not in argv[1:]:  # only some of them, to try them
            continue
        print("\ncase", name)
        print("why", why)
        print("choice how", how)
        for key, value in given.items():
            print("given", key, Fraction(value))
        for key, value in values(how, given):
            print(key, "infinite" if value is None else text(value))


main()
