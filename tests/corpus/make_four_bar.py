#!/usr/bin/env python3
"""Writes reference values of the four-bar linkage, independent of the C++ code: two corpora.

  make_four_bar.py motion > four_bar.txt                  positions, velocities, accelerations, circles, curvature
  make_four_bar.py special > four_bar_special.txt         dead centres, limits of the crank, parallel links, swing

Motion: only positions are written down here, as functions of time: A on its circle, B where the circles about A and
B0 meet, C where the circle over the diameter AB meets that about A. Everything else is measured on the paths as in
make_slider_crank.py, whose tools are used: velocities and accelerations by high-precision numerical differentiation,
P0 and K as zeros of the affine fields that three moving points show, circles as fitted conics, curvature from the
path's own derivatives.

Special positions: the crank is turned through the whole range in which the linkage closes, and the condition itself
(three hinges in line, two links parallel) is followed along the way; its changes of sign are refined to 60 digits.
"""
import sys
from fractions import Fraction

from mpmath import atan2, cos, diff, fabs, findroot, mp, mpf, pi, sin, sqrt

from make_slider_crank import ZERO, affine, conic, curvature, describe, distance, number, beside, text, zero_of


def cross(p, q):
    return p[0] * q[1] - p[1] * q[0]


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1]


def minus(p, q):
    return (p[0] - q[0], p[1] - q[1])


def angle(p, size):
    """In (-pi, pi]; what is noise against the size counts as zero."""
    x, y = (mpf(0) if fabs(c) <= ZERO * size else c for c in p)
    return atan2(y, x)


class FourBar:
    def __init__(self, A0A, AB, B0B, B0):
        self.A0A, self.AB, self.B0B = (Fraction(x) for x in (A0A, AB, B0B))
        self.B0 = tuple(Fraction(x) for x in B0)

    def numbers(self):
        return number(self.A0A), number(self.AB), number(self.B0B), tuple(number(x) for x in self.B0)

    def scaled(self, s):
        return FourBar(*(x * s for x in (self.A0A, self.AB, self.B0B)), tuple(x * s for x in self.B0))


def gap(linkage, A):
    """By how much A is too far from B0 or too near; negative when the linkage closes."""
    _, AB, B0B, B0 = linkage.numbers()
    d = distance(A, B0)
    return max(d - (AB + B0B), fabs(AB - B0B) - d)


def hinge_B(linkage, A, branch):
    """Where the circles about A and B0 meet, on the named side of A -> B0."""
    _, AB, B0B, B0 = linkage.numbers()
    d = distance(A, B0)
    e = ((B0[0] - A[0]) / d, (B0[1] - A[1]) / d)
    along = (d ** 2 + AB ** 2 - B0B ** 2) / (2 * d)
    aside2 = AB ** 2 - along ** 2
    if fabs(aside2) <= ZERO * AB ** 2:
        aside2 = mpf(0)
    aside = sqrt(aside2) if branch == "left" else -sqrt(aside2)
    return (A[0] + along * e[0] - aside * e[1], A[1] + along * e[1] + aside * e[0])


# ------------------------------------------------------------------------------------------------------- special

KINDS = ("dead_centre_extended", "dead_centre_folded", "parallel_same_sense", "parallel_opposite_sense")


def on_crank(linkage, phi):
    a = number(linkage.A0A)
    return (a * cos(phi), a * sin(phi))


def condition(kind, linkage, branch):
    """The function of the crank angle that is zero there, and whether a zero of it is of this kind."""
    a, b, c, B0 = linkage.numbers()
    size = a + b + c

    def place(phi):
        A = on_crank(linkage, phi)
        return A, hinge_B(linkage, A, branch)

    if kind.startswith("dead_centre"):
        def in_line(phi):
            A, B = place(phi)
            return cross(A, B) / size ** 2

        def of_kind(phi):  # extended: the coupler continues the crank
            A, B = place(phi)
            return (dot(A, minus(B, A)) > 0) == kind.endswith("extended")
        return in_line, of_kind

    def parallel(phi):
        A, B = place(phi)
        return cross(A, minus(B, B0)) / size ** 2

    def of_sense(phi):
        A, B = place(phi)
        return (dot(A, minus(B, B0)) > 0) == kind.endswith("same_sense")
    return parallel, of_sense


STEPS = 1000


def changes_of_sign(f, places):
    values = [f(x) for x in places]
    return [findroot(f, (x, y), solver="anderson", tol=mpf(10) ** -110)
            for x, y, p, q in zip(places, places[1:], values, values[1:]) if p * q < 0]


def limits(linkage):
    """Crank angles at which the linkage just closes, within one turn, by kind."""
    A0A, AB, B0B, B0 = linkage.numbers()
    size = A0A + AB + B0B
    start = atan2(B0[1], B0[0])
    places = [start, start + pi, start + 2 * pi]  # A nearest to B0 and farthest: between them its distance is monotone
    reach = {"extended": AB + B0B, "folded": fabs(AB - B0B)}
    return {kind: changes_of_sign(lambda phi, r=r: (distance(on_crank(linkage, phi), B0) ** 2 - r ** 2) / size ** 2,
                                   places)
            for kind, r in reach.items()}


def closing_ranges(linkage, ends):
    """Intervals of the crank angle in which the linkage closes, cut into steps."""
    full = [2 * pi * (k + mpf(1) / 7) / STEPS for k in range(STEPS + 1)]
    if not ends:
        return [full] if gap(linkage, on_crank(linkage, mpf(1))) < 0 else []
    ends = sorted(ends)
    ranges = []
    for start, stop in zip(ends, ends[1:] + [ends[0] + 2 * pi]):
        if gap(linkage, on_crank(linkage, (start + stop) / 2)) < 0:
            inset = (stop - start) * mpf(10) ** -12
            ranges.append([start + inset + (stop - start - 2 * inset) * (1 - cos(pi * k / STEPS)) / 2
                           for k in range(STEPS + 1)])
    return ranges


def around(phi):
    """The same angle in (-pi, pi]; roots are refined to 55 digits, and what is below counts as zero."""
    x, y = cos(phi), sin(phi)
    return atan2(mpf(0) if fabs(y) < mpf(10) ** -50 else y, x)


def special_positions(linkage):
    out = {}
    B0 = linkage.numbers()[3]
    ends = limits(linkage)
    for kind, found in ends.items():
        for side in ("left", "right"):
            here = [phi for phi in found if (cross(B0, on_crank(linkage, phi)) > 0) == (side == "left")]
            assert len(here) <= 1
            out[f"crank_limit_{kind}_{side}.crank_angle"] = around(here[0]) if here else "absent"
    ranges = closing_ranges(linkage, ends["extended"] + ends["folded"])
    at = {}
    for kind in KINDS:
        for branch in ("left", "right"):
            f, of_kind = condition(kind, linkage, branch)
            found = [phi for places in ranges for phi in changes_of_sign(f, places) if of_kind(phi)]
            assert len(found) <= 1, (kind, branch, found)
            name = f"{kind}_{branch}"
            out[name + ".crank_angle"] = around(found[0]) if found else "absent"
            out[name + ".rocker_angle"] = "absent"
            if found:
                at[name] = found[0]
                rocker = minus(hinge_B(linkage, on_crank(linkage, found[0]), branch), B0)
                out[name + ".rocker_angle"] = around(atan2(rocker[1], rocker[0]))
    for branch in ("left", "right"):
        names = [f"dead_centre_{kind}_{branch}" for kind in ("extended", "folded")]
        if mobility(linkage) != "crank_rocker":
            out.update({f"{what}_{branch}": "absent" for what in ("rocker_swing", "crank_rotation", "time_ratio")})
            continue
        extended, folded = (at[name] for name in names)
        swing = around(out[names[1] + ".rocker_angle"] - out[names[0] + ".rocker_angle"])
        rotation = (folded - extended) % (2 * pi)
        out[f"rocker_swing_{branch}"] = fabs(swing)
        out[f"crank_rotation_{branch}"] = rotation
        out[f"time_ratio_{branch}"] = max(rotation, 2 * pi - rotation) / min(rotation, 2 * pi - rotation)
    return out


def turns_fully(turning, carrier, other, opposite):
    """Whether the first of four links turns through all angles against the second, its neighbour."""
    return turning + carrier <= other + opposite and fabs(turning - carrier) >= fabs(other - opposite)


def mobility(linkage):
    a, b, c, B0 = linkage.numbers()
    f = distance(B0, (0, 0))
    if max(a, b, c, f) > a + b + c + f - max(a, b, c, f):
        return "open"
    if any(fabs(a + s * b + t * c - s * t * f) <= ZERO * f for s in (1, -1) for t in (1, -1)):
        return "change_point"
    crank, rocker = turns_fully(a, f, b, c), turns_fully(c, f, a, b)
    if crank and rocker:
        return "double_crank"
    if crank or rocker:
        return "crank_rocker" if crank else "rocker_crank"
    return "double_rocker" if turns_fully(b, a, c, f) else "triple_rocker"


# -------------------------------------------------------------------------------------------------------- motion

class Case:
    """`at` is the crank's angle as a fraction of a turn, or the name of a special position on the case's branch."""

    def __init__(self, name, why, linkage, at, branch="left", AC=None, C_side="left", n="50", alpha_2="0"):
        self.name, self.why, self.linkage, self.at, self.branch = name, why, linkage, at, branch
        self.AC = Fraction(AC) if AC is not None else linkage.AB * Fraction(3, 5)
        self.C_side, self.n, self.alpha_2 = C_side, Fraction(n), Fraction(alpha_2)

    def crank_angle(self):
        if self.at in KINDS:
            return special_root(self.linkage, self.at, self.branch)
        return 2 * pi * number(self.at)


def special_root(linkage, kind, branch):
    """The crank angle of a special position in full working precision, from the 50-digit one."""
    with mp.workdps(60):
        start = special_positions(linkage)[f"{kind}_{branch}.crank_angle"]
    f, _ = condition(kind, linkage, branch)
    return findroot(f, (start, start + mpf(10) ** -40), solver="secant", tol=mpf(10) ** -(2 * mp.dps - 40))


POINTS = ("A", "B", "C", "G3")


def values(case):
    out = {}
    g = case.linkage
    a, b, c, B0 = g.numbers()
    omega_2, alpha_2 = 2 * pi * number(case.n) / 60, number(case.alpha_2)
    size = a + b + c
    phi1 = case.crank_angle()
    out["omega_2"], out["crank_angle_phi"] = omega_2, phi1

    def A_of(t):
        phi = phi1 + omega_2 * t + alpha_2 * t ** 2 / 2
        return (a * cos(phi), a * sin(phi))

    def B_of(t):
        return hinge_B(g, A_of(t), case.branch)

    A = A_of(mpf(0))
    open_by = gap(g, A)
    if open_by > ZERO * size:
        return {"closure_gap": open_by}, (a, b + c, omega_2)
    touching = fabs(open_by) <= ZERO * size
    B = B_of(mpf(0))
    assert fabs(distance(A, B) - b) + fabs(distance(B, B0) - c) < mpf(10) ** -300 * size
    side = cross(minus(B0, A), minus(B, A))
    assert touching or (side > 0) == (case.branch == "left")

    AC = number(case.AC)
    foot = AC ** 2 / b  # of C on AB: Thales
    height = sqrt(number(case.AC ** 2 - (case.AC ** 2 / g.AB) ** 2))
    plate = {"A": (mpf(0), mpf(0)), "B": (b, mpf(0)), "C": (foot, height if case.C_side == "left" else -height),
             "G3": (b / 2, mpf(0))}

    def coupler_path(w):
        def point(t):
            A_t, B_t = A_of(t), B_of(t)
            e = ((B_t[0] - A_t[0]) / b, (B_t[1] - A_t[1]) / b)
            return (A_t[0] + w[0] * e[0] - w[1] * e[1], A_t[1] + w[0] * e[1] + w[1] * e[0])
        return point

    paths = {k: coupler_path(w) for k, w in plate.items()}
    paths["G2"] = lambda t: tuple(x / 2 for x in A_of(t))
    paths["G4"] = lambda t: tuple((x + y) / 2 for x, y in zip(B0, B_of(t)))
    place = {k: path(mpf(0)) for k, path in paths.items()}
    for k, z in place.items():
        out[k + "_x"], out[k + "_y"] = z
    along, rocker = minus(B, A), minus(B, B0)
    out["coupler_angle"], out["rocker_angle"] = angle(along, size), angle(rocker, size)
    # Against the frame, theta_4 from B to B0: the closure r2 + r3 + r4 = r1.
    for k, link in (("theta_2", A), ("theta_3", along), ("theta_4", minus(B0, B))):
        out[k] = angle((dot(B0, link), cross(B0, link)), size ** 2)
    out["psi_y_determinant"] = cross(along, minus(B0, B))

    def derivative(path, order):
        return tuple(diff(lambda t, i=i: path(t)[i], 0, order) for i in (0, 1))

    def write_field(k, order, value):
        name = f"{'va'[order - 1]}_{k}"
        out[name] = distance(value, (0, 0))
        out[name + "_x"], out[name + "_y"] = value

    paths["A"] = A_of
    if touching:  # only the crank's own motion is defined
        for k in ("A", "G2"):
            for order in (1, 2):
                write_field(k, order, derivative(paths[k], order))
        out.update({k: "undefined" for k in MOTION_NAMES if k not in out})
        return out, (a, b + c, omega_2)

    v = {k: derivative(path, 1) for k, path in paths.items()}
    acc = {k: derivative(path, 2) for k, path in paths.items()}

    def turning(link, now, order):
        # The angle against its own value at t = 0, so that no cut of the arc tangent is near.
        value = diff(lambda t: (lambda z: atan2(cross(now, z), dot(now, z)))(link(t)), 0, order)
        return mpf(0) if fabs(value) < ZERO * fabs(omega_2) ** order else value

    links = {"3": (lambda t: minus(B_of(t), A_of(t)), along), "4": (lambda t: minus(B_of(t), B0), rocker)}
    for k, (link, now) in links.items():
        out["omega_" + k] = turning(link, now, 1)
    for k, (link, now) in links.items():
        out["alpha_" + k] = turning(link, now, 2)
    for k in ("A", "B", "C", "G2", "G3", "G4"):
        write_field(k, 1, v[k])
        write_field(k, 2, acc[k])
    for k in ("B", "C", "G3"):
        out[f"v_{k}A"], out[f"a_{k}A"] = (distance(field[k], field["A"]) for field in (v, acc))
        e = minus(place[k], A)
        d = minus(acc[k], acc["A"])
        out[f"a_{k}A_n"], out[f"a_{k}A_t"] = (fabs(h(e, d)) / distance(e, (0, 0)) for h in (dot, cross))
    out["a_B_n"], out["a_B_t"] = fabs(dot(rocker, acc["B"])) / c, fabs(cross(rocker, acc["B"])) / c
    for k in ("C", "G3"):
        speed = distance(v[k], (0, 0))
        rest = speed <= ZERO * size * fabs(omega_2)
        out[f"a_{k}_n"], out[f"a_{k}_t"] = (
            "undefined" if rest else fabs(h(v[k], acc[k])) / speed for h in (cross, dot))
    omega, alpha = out["omega_3"], out["alpha_3"]
    out["gamma"] = atan2(alpha, omega ** 2) if (alpha or omega) else "undefined"

    frame = [coupler_path(w) for w in ((mpf(0), mpf(0)), (b, mpf(0)), (mpf(0), b))]
    spots = [path(mpf(0)) for path in frame]
    v_rows, v_at = affine(spots, [derivative(path, 1) for path in frame])
    a_rows, a_at = affine(spots, [derivative(path, 2) for path in frame])
    P, K = zero_of(v_rows, omega_2), zero_of(a_rows, omega_2 ** 2)
    for name, Q in (("P0", P), ("K", K)):
        out[name + "_x"], out[name + "_y"] = Q if Q else ("infinite", "infinite")
        for k in POINTS:
            out[name + k] = distance(Q, place[k]) if Q else "infinite"

    forms = fabs(omega_2) ** 3 * size ** 2
    flexes = conic(lambda X, Y: cross(v_at(X, Y), a_at(X, Y)), b, forms * SPREAD)
    centre = describe("inflection", flexes, forms, b, out)
    steady = conic(lambda X, Y: dot(v_at(X, Y), a_at(X, Y)), b, forms * SPREAD)
    describe("stationarity", steady, forms, b, out)
    J = (2 * centre[0] - P[0], 2 * centre[1] - P[1]) if centre and P else ("infinite", "infinite")
    out["inflection_pole_x"], out["inflection_pole_y"] = J
    for k in ("C", "G3"):
        curvature(k, place[k], v[k], acc[k], P, flexes, forms, b, out)
    return out, (a, b + c, omega_2)


SPREAD = mpf(10) ** 100  # beside a limit of the crank accelerations reach 1e45, and 1e90 where lengths differ widely
MOTION_NAMES = []        # filled from the first case

N3 = FourBar("0.15", "0.37", "0.45", ("-0.18", "-0.16"))
N10 = FourBar("0.20", "0.50", "0.70", ("0.80", "0"))
N10_TILTED = FourBar("0.20", "0.50", "0.70", ("0.48", "0.64"))
# Crank 0.15, coupler 0.37, rocker 0.45 with B0 placed so that the crank meets the special position at turn 0 exactly.
DEAD_EXTENDED = FourBar("0.15", "0.37", "0.45", ("0.25", "-0.36"))
DEAD_FOLDED = FourBar("0.15", "0.37", "0.45", ("0.05", "-0.36"))
PARALLEL_SAME = FourBar("0.15", "0.37", "0.45", ("-0.078", "0.296"))
PARALLEL_OPPOSITE = FourBar("0.15", "0.37", "0.45", ("0.822", "0.296"))
LIMIT_EXTENDED = FourBar("0.15", "0.37", "0.45", ("0.642", "0.656"))
LIMIT_FOLDED = FourBar("0.15", "0.37", "0.45", ("0.198", "0.064"))
DRAG_LINK = FourBar("0.30", "0.35", "0.32", ("0.10", "0.05"))
DOUBLE_ROCKER = FourBar("0.50", "0.20", "0.60", ("0.70", "0"))
TRIPLE_ROCKER = FourBar("0.50", "0.30", "0.40", ("0.90", "0"))
ROCKER_CRANK = FourBar("0.45", "0.37", "0.15", ("0.30", "0"))
LONG_CRANK = FourBar("0.45", "0.15", "0.37", ("0.40", "-0.10"))
PARALLELOGRAM = FourBar("0.20", "0.50", "0.20", ("0.30", "0.40"))
EQUAL_CRANKS = FourBar("0.20", "0.50", "0.20", ("0.40", "0.10"))
NEAR_CHANGE = FourBar("0.20", "0.50", "0.20", (beside("0.5", 9), "0"))
THETA_4_PI = FourBar("0.24", "0.74", "0.40", ("0.30", "0"))
TINY_CRANK = FourBar("1e-9", "0.37", "0.45", ("-0.18", "-0.16"))
LONG_COUPLER = FourBar("1", "1e8", "1.5", ("1e8", "0"))
SMALL, LARGE = Fraction(1, 10 ** 9), Fraction(10 ** 8)


def motion_cases():
    n3 = dict(branch="right", AC="0.33", C_side="right")
    yield Case("n3", "exercise N.3: 50 rpm, 0.1 s, so 30 degrees", N3, "1/12", **n3)
    yield Case("n3_other_branch", "its other assembly branch", N3, "1/12", AC="0.33", C_side="right")
    yield Case("n3_other_side", "C on the other side", N3, "1/12", branch="right", AC="0.33")
    yield Case("n3_speeding_up", "a crank acceleration", N3, "1/12", alpha_2="7", **n3)
    yield Case("n3_braking", "the other sign of alpha_2", N3, "1/12", alpha_2="-30", **n3)
    yield Case("n3_backwards", "a crank turning clockwise", N3, "1/12", n="-50", **n3)
    for k in range(1, 8):
        yield Case(f"n3_turned_{k}_eighths", "round the turn", N3, Fraction(k, 8), **n3)
    for branch in ("left", "right"):
        for kind in KINDS:
            yield Case(f"n3_{kind}_{branch}", "a special position whose crank angle is no rational turn", N3, kind,
                       branch=branch, AC="0.33", C_side="right")
    yield Case("n3_dead_centre_speeding_up", "a dead centre with a crank acceleration", N3, "dead_centre_folded",
               alpha_2="7", **n3)
    n10 = dict(n="400", AC="0.30")
    yield Case("n10", "exercise N.10 and N.11: 400 rpm, 20 degrees, B above the frame", N10, "1/18", **n10)
    yield Case("n10_other_branch", "its other configuration", N10, "1/18", branch="right", **n10)
    yield Case("n10_in_line_with_frame", "crank on the frame: A between the hinges", N10, "0", **n10)
    yield Case("n10_away_from_frame", "crank on the frame: theta_2 = pi, where tan(theta_2/2) fails", N10, "1/2", **n10)
    yield Case("n10_60_degrees", "one root for the crank", N10, "1/6", branch="right", **n10)
    yield Case("n10_200_degrees", "third quadrant", N10, "5/9", **n10)
    yield Case("n10_second_turn", "a crank angle beyond a full turn", N10, "19/18", **n10)
    yield Case("n10_tilted", "the same lengths, the frame along (3, 4)", N10_TILTED, "1/18", **n10)
    yield Case("n10_upright", "the same lengths, the frame upwards", FourBar("0.20", "0.50", "0.70", ("0", "0.8")), "1/18",
               **n10)
    yield Case("n10_reversed", "the same lengths, B0 to the left", FourBar("0.20", "0.50", "0.70", ("-0.8", "0")), "1/18",
               branch="right", **n10)
    yield Case("theta_4_pi", "the rocker from B to B0 points along -x: tan(theta_4/2) fails", THETA_4_PI, "1/4")
    yield Case("rocker_along_x", "and the other branch of it", THETA_4_PI, "1/4", branch="right")
    hits = (("dead_centre_extended", DEAD_EXTENDED, "left", "omega_4 = 0: crank and coupler in line"),
            ("dead_centre_folded", DEAD_FOLDED, "right", "omega_4 = 0: coupler folded over the crank"),
            ("parallel_same_sense", PARALLEL_SAME, "right", "omega_3 = 0, pole at infinity: circles are lines"),
            ("parallel_opposite_sense", PARALLEL_OPPOSITE, "left", "omega_3 = 0 with rocker and crank opposed"))
    for name, linkage, branch, why in hits:
        yield Case(name, why, linkage, "0", branch=branch)
        yield Case(name + "_braking", why + ", alpha_2", linkage, "0", branch=branch, alpha_2="-30")
        for e in (3, 9, 15, 30):
            yield Case(f"{name}_past_1e-{e}", "just past it, as a part of a turn", linkage, beside("0", e),
                       branch=branch)
            yield Case(f"{name}_before_1e-{e}", "just before it", linkage, beside("1", e, -1), branch=branch)
    for name, linkage, closing in (("limit_extended", LIMIT_EXTENDED, 1), ("limit_folded", LIMIT_FOLDED, -1)):
        yield Case(name, "coupler and rocker in line: velocities undefined", linkage, "0")
        for e in (3, 9, 15, 30):
            for branch in ("left", "right"):
                yield Case(f"{name}_closes_1e-{e}_{branch}", "the worst transmission angle", linkage,
                           beside("1", e, closing), branch=branch)
            yield Case(f"{name}_open_1e-{e}", "open by a little", linkage, beside("1", e, -closing))
    yield Case("open_far", "A too far from B0", TRIPLE_ROCKER, "1/2")
    yield Case("open_near", "A too near to B0", DOUBLE_ROCKER, "0")
    for branch in ("left", "right"):
        yield Case(f"drag_link_{branch}", "frame shortest: crank and rocker turn fully", DRAG_LINK, "1/7", branch=branch)
        yield Case(f"double_rocker_{branch}", "coupler shortest", DOUBLE_ROCKER, "1/6", branch=branch)
        yield Case(f"triple_rocker_{branch}", "Grashof's condition fails", TRIPLE_ROCKER, "1/18", branch=branch)
        yield Case(f"rocker_crank_{branch}", "rocker shortest: it turns fully, the crank does not", ROCKER_CRANK, "1/6",
                   branch=branch)
        yield Case(f"long_crank_{branch}", "crank longer than the coupler", LONG_CRANK, "1/12", branch=branch)
    yield Case("parallelogram", "the coupler only translates: omega_3 = alpha_3 = 0", PARALLELOGRAM, "1/4")
    yield Case("antiparallelogram", "the other branch of it", PARALLELOGRAM, "1/4", branch="right")
    yield Case("change_point", "parallelogram stretched: all hinges in line, two motions possible",
               FourBar("0.20", "0.50", "0.20", ("0.5", "0")), "0")
    yield Case("near_change_point", "frame 1e-9 too long for it", NEAR_CHANGE, "0")
    yield Case("near_change_point_right", "the other branch", NEAR_CHANGE, "0", branch="right")
    yield Case("near_change_point_turned", "and a little further", NEAR_CHANGE, beside("0", 9))
    yield Case("near_change_point_open", "the other stretched position, open by 1e-9 m", NEAR_CHANGE, "1/2")
    for name, s in (("tiny", SMALL), ("huge", LARGE)):
        yield Case(f"n3_{name}", "the linkage of N.3, scaled", N3.scaled(s), "1/12", branch="right",
                   AC=Fraction("0.33") * s, C_side="right")
        yield Case(f"n10_{name}", "the linkage of N.10, scaled", N10.scaled(s), "1/18", n="400", AC=Fraction("0.3") * s)
    yield Case("tiny_crank", "a crank of 1e-9 m on links of 0.4 m", TINY_CRANK, "1/12", branch="right")
    yield Case("long_coupler", "a coupler and a frame of 1e8 m between cranks of 1 m", LONG_COUPLER, "1/7")


def special_cases():
    for name, linkage in (
            ("n3", N3), ("n10", N10), ("n10_tilted", N10_TILTED), ("drag_link", DRAG_LINK),
            ("double_rocker", DOUBLE_ROCKER), ("triple_rocker", TRIPLE_ROCKER), ("rocker_crank", ROCKER_CRANK),
            ("long_crank", LONG_CRANK), ("equal_cranks", EQUAL_CRANKS), ("near_change_point", NEAR_CHANGE),
            ("dead_centre_extended", DEAD_EXTENDED), ("dead_centre_folded", DEAD_FOLDED),
            ("parallel_same_sense", PARALLEL_SAME), ("parallel_opposite_sense", PARALLEL_OPPOSITE),
            ("limit_extended", LIMIT_EXTENDED), ("limit_folded", LIMIT_FOLDED), ("n3_tiny", N3.scaled(SMALL)),
            ("n10_huge", N10.scaled(LARGE))):
        yield name, linkage


MOTION_HEADER = """\
# Reference values of the four-bar linkage, 40 digits. Written by make_four_bar.py motion with mpmath, 400 working
# digits; do not edit by hand. Positions are the only formulas (A on its circle, B where circles about A and B0 meet);
# velocities and accelerations are high-precision numerical derivatives of the paths, P0 and K the zeros of the affine
# fields fitted to three moving points, the circles are fitted conics, curvature is that of the paths.
# Nothing here is taken from the C++ code.
#
# Givens: A0A, AB, B0B, the hinge B0 = (x_B0, y_B0) with A0 the origin, AC (the plate has its right angle at C), n in
# rpm and alpha_2 of the crank; turn: the crank's angle from +x as a fraction of a turn.
# Choices: branch, the side of A -> B0 on which B lies; C_side, the side of A -> B on which C lies; crank_at: `turn`,
# or the special position (of this branch) in which the crank stands, and then no turn is given.
# Counter-clockwise positive. crank_angle_phi, coupler_angle (A -> B), rocker_angle (B0 -> B) are measured from +x;
# theta_2, theta_3, theta_4 (B -> B0) from A0 -> B0; psi_y_determinant = AB B0B sin(theta_4 - theta_3), m². G2, G3, G4
# halve A0A, AB, B0B. gamma = atan(alpha_3/omega_3^2). Components, angles, omega and alpha are signed, the rest are
# magnitudes. a_BA_n, a_CA_n along AB, AC; a_B_n along B0B; a_C_n, a_G3_n normal to the point's own path; _t across.
# P0: pole of the coupler (P31); K: acceleration pole; P0X, KX: its distance from X; inflection_pole: opposite P0 on
# the inflection circle; Cprime: second meeting of the ray P0 C with it. *_line_a, _b, _c: the line a x + b y + c = 0
# that a circle has become; a^2 + b^2 = 1, the first of a, b that is not zero is positive. SI units, radians.
#
# case NAME, why TEXT, givens (rationals), choices (words), then NAME VALUE; VALUE may be `infinite` or `undefined`.
# closure_gap: the linkage does not close, A is too far from B0 or too near by this much, and nothing else exists.
"""

SPECIAL_HEADER = """\
# Special positions of four-bar linkages, 40 digits. Written by make_four_bar.py special with mpmath; do not edit by
# hand. The crank is turned through all positions that close, and where three hinges come in line or two links become
# parallel the change of sign is refined. Nothing here is taken from the C++ code.
#
# Givens as in four_bar.txt. Choice mobility: by which links turn fully against the frame (crank_rocker, rocker_crank,
# double_crank), only the coupler (double_rocker), none (triple_rocker); change_point: all four can come in line.
# *_left, *_right: the assembly branch, but for crank_limit (coupler and rocker in line: both branches meet) the side
# of A0 -> B0 on which the crank lies. Angles in radians from +x, in (-pi, pi]. rocker_swing in [0, pi] between the dead
# centres of a branch; crank_rotation in [0, 2 pi) counter-clockwise from extended to folded; time_ratio: the longer of
# both rotations of the crank to the shorter; these three only when the crank turns fully and the rocker does not.
# `absent`: there is no such position.
"""


def write_linkage(linkage):
    for name in ("A0A", "AB", "B0B"):
        print(f"given {name} {getattr(linkage, name)}")
    print(f"given x_B0 {linkage.B0[0]}\ngiven y_B0 {linkage.B0[1]}")


def write_motion():
    print(MOTION_HEADER, end="")
    for case in motion_cases():
        print(f"\ncase {case.name}\nwhy {case.why}")
        write_linkage(case.linkage)
        print(f"given AC {case.AC}\ngiven n {case.n}\ngiven alpha_2 {case.alpha_2}")
        special = case.at in KINDS
        if not special:
            print(f"given turn {Fraction(case.at)}")
        print(f"choice crank_at {case.at if special else 'turn'}")
        print(f"choice branch {case.branch}\nchoice C_side {case.C_side}")
        out, sizes = values(case)
        if not MOTION_NAMES:
            MOTION_NAMES.extend(out)
        for name, value in out.items():
            print(name, text(name, value, sizes))
        sys.stdout.flush()


def write_special():
    print(SPECIAL_HEADER, end="")
    with mp.workdps(60):
        for name, linkage in special_cases():
            print(f"\ncase {name}\nwhy special positions")
            write_linkage(linkage)
            print(f"choice mobility {mobility(linkage)}")
            for key, value in special_positions(linkage).items():
                print(key, text(key, value, (mpf(1), mpf(1), mpf(1))))
            sys.stdout.flush()


if __name__ == "__main__":
    {"motion": write_motion, "special": write_special}[sys.argv[1]]()
