#!/usr/bin/env python3
"""Writes slider_crank.txt: reference values of the slider-crank, independent of the C++ code.

Only positions are written down here, as functions of time. Everything else is measured on them:
  velocities and accelerations   by high-precision numerical differentiation (mpmath.diff) of the paths;
  the velocity and acceleration field   as the affine map that three points of the moving plane show, so that
                                 rigidity is not assumed; P0 and K are the points these maps send to zero;
  inflection and stationarity circle   as the conics v x a = 0 and v . a = 0 sampled at four points, and checked
                                 to be circles at two more;
  radius and centre of curvature from the derivatives of the point's own path, and then checked against
                                 Euler-Savary with the circle above.
Usage: make_slider_crank.py > slider_crank.txt
"""
from fractions import Fraction

from mpmath import asin, atan2, cos, diff, fabs, lu_solve, matrix, mp, mpf, nstr, pi, sin, sqrt

mp.dps = 400         # the hardest case cubes a velocity of 1e-30, and differentiation costs digits on top
ZERO = mpf(10) ** -200  # relative: far above the noise of differentiation, far below the smallest value, 1e-90
DIGITS = 40


def number(q):
    q = Fraction(q)
    return mpf(q.numerator) / q.denominator


class Case:
    def __init__(self, name, why, r="1/5", l="1/2", AC="3/10", BC="2/5", n="360", turn="1/12", alpha_2="0",
                 e="0", delta="0"):
        self.name, self.why = name, why
        self.r, self.l, self.AC, self.BC = (Fraction(x) for x in (r, l, AC, BC))
        self.n, self.alpha_2 = Fraction(n), Fraction(alpha_2)
        self.e, self.delta = Fraction(e), Fraction(delta)  # delta in degrees
        self.turn = Fraction(turn)
        self.t1 = self.turn * 60 / self.n


def paths(case):
    """z(w)(t): path of the point with coordinate w in the coupler frame (origin A, real axis along AB)."""
    r, l, e, delta = number(case.r), number(case.l), number(case.e), number(case.delta) * pi / 180
    t1, speed = number(case.t1), 2 * pi * number(case.n) / 60

    def crank(t):
        return speed * t + number(case.alpha_2) * (t - t1) ** 2 / 2

    def coupler(t):
        return delta + asin((e - r * sin(crank(t) - delta)) / l)  # within a right angle of the guide: B ahead of A

    def x(w):
        return lambda t: r * cos(crank(t)) + w[0] * cos(coupler(t)) - w[1] * sin(coupler(t))

    def y(w):
        return lambda t: r * sin(crank(t)) + w[0] * sin(coupler(t)) + w[1] * cos(coupler(t))

    return crank, coupler, x, y


def affine(points, values):
    """The affine map taking the three points to the three values, as f(x, y)."""
    system = matrix([[p[0], p[1], 1] for p in points])
    rows = [lu_solve(system, matrix([v[k] for v in values])) for k in (0, 1)]
    return rows, lambda x, y: tuple(row[0] * x + row[1] * y + row[2] for row in rows)


def zero_of(rows, size):
    """Where the affine map vanishes, or None when that is at infinity."""
    (a, b, e), (c, d, f) = rows
    D = a * d - b * c
    if fabs(D) <= ZERO * size ** 2:
        return None
    return ((b * f - d * e) / D, (c * e - a * f) / D)


def conic(form, l, size):
    """Coefficients q, m, n, k of q (x² + y²) + m x + n y + k, which `form` is."""
    at = [(mpf(0), mpf(0)), (l, mpf(0)), (mpf(0), l), (-l, 2 * l)]  # not on one circle
    system = matrix([[x * x + y * y, x, y, 1] for x, y in at])
    q, m, n, k = lu_solve(system, matrix([form(x, y) for x, y in at]))
    for x, y in [(2 * l, -l), (-3 * l, 5 * l)]:
        assert fabs(form(x, y) - (q * (x * x + y * y) + m * x + n * y + k)) <= mpf(10) ** -250 * size
    return q, m, n, k


def describe(prefix, coefficients, size, l, out):
    """Centre and diameter of a circle, or the normalised line it has become. `size` is that of the form's values."""
    q, m, n, k = coefficients
    if fabs(q) * l ** 2 > ZERO * size:
        centre = (-m / (2 * q), -n / (2 * q))
        out[prefix + "_diameter"] = 2 * sqrt(fabs(centre[0] ** 2 + centre[1] ** 2 - k / q))
        out[prefix + "_centre_x"], out[prefix + "_centre_y"] = centre
        return centre
    length = sqrt(m * m + n * n)
    if length * l <= ZERO * size:  # the form vanishes everywhere
        out.update({prefix + s: "undefined" for s in ("_diameter", "_centre_x", "_centre_y")})
        return None
    out.update({prefix + s: "infinite" for s in ("_diameter", "_centre_x", "_centre_y")})
    lead = m if fabs(m) > ZERO * length else n
    length = length if lead > 0 else -length
    for s, v in (("a", m), ("b", n), ("c", k)):
        out[f"{prefix}_line_{s}"] = v / length
    return None


def distance(p, q):
    return sqrt((p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2)


VELOCITY_NAMES = ("P0_x P0_y P0A P0B P0C P0M omega_3 v_B_x v_B_y v_B v_C v_M v_C_x v_C_y v_M_x v_M_y v_BA v_CA v_MA").split()
ACCELERATION_NAMES = ("gamma_deg alpha_3 a_B_x a_B_y a_B a_C_x a_C_y a_C a_M_x a_M_y a_M a_BA_n a_BA_t "
                      "a_BA a_CA a_MA gamma K_x K_y KA KB KC KM inflection_diameter inflection_pole_x inflection_pole_y inflection_centre_x "
                      "inflection_centre_y stationarity_diameter stationarity_centre_x stationarity_centre_y Cprime_C "
                      "rho_C curvature_centre_C_x curvature_centre_C_y Cprime_x Cprime_y Mprime_M rho_M "
                      "curvature_centre_M_x curvature_centre_M_y Mprime_x Mprime_y").split()


def values(case):
    out = {}
    r, l, AC, BC, e = (number(v) for v in (case.r, case.l, case.AC, case.BC, case.e))
    delta = number(case.delta) * pi / 180
    sizes = (r, l + fabs(e), 2 * pi * number(case.n) / 60)
    t1, omega_2, alpha_2 = number(case.t1), 2 * pi * number(case.n) / 60, number(case.alpha_2)
    crank, coupler, x, y = paths(case)
    phi = crank(t1)
    out["omega_2"], out["crank_angle_phi"], out["crank_angle_phi_deg"] = omega_2, phi, number(case.turn * 360)
    out["v_A"] = fabs(omega_2) * r
    out["A_x"], out["A_y"] = r * cos(phi), r * sin(phi)
    out["a_A"] = r * sqrt(alpha_2 ** 2 + omega_2 ** 4)
    a_A = diff(lambda t: r * cos(crank(t)), t1, 2), diff(lambda t: r * sin(crank(t)), t1, 2)
    out["a_A_n"] = fabs(a_A[0] * cos(phi) + a_A[1] * sin(phi))
    out["a_A_t"] = fabs(a_A[1] * cos(phi) - a_A[0] * sin(phi))

    height = r * sin(phi - delta) - e  # of A over the guide
    gap = fabs(height) - l
    if gap > ZERO * l:
        return {"closure_gap": gap}, sizes
    touching = fabs(gap) <= ZERO * l
    theta = delta - pi / 2 * (1 if height > 0 else -1) if touching else coupler(t1)

    # C: on both circles about A and B, left of A to B.
    p = (AC ** 2 + l ** 2 - BC ** 2) / (2 * l)
    height2 = (case.AC ** 2 - ((case.AC ** 2 + case.l ** 2 - case.BC ** 2) / (2 * case.l)) ** 2)
    plate = {"A": (mpf(0), mpf(0)), "B": (l, mpf(0)), "C": (p, sqrt(number(height2))), "M": (l / 2, mpf(0))}
    place = {k: (r * cos(phi) + w[0] * cos(theta) - w[1] * sin(theta),
                 r * sin(phi) + w[0] * sin(theta) + w[1] * cos(theta)) for k, w in plate.items()}
    for k in "BCM":
        out[k + "_x"], out[k + "_y"] = place[k]
    from_guide = -place["B"][0] * sin(delta) + place["B"][1] * cos(delta) - e
    assert fabs(from_guide) <= mpf(10) ** (-250 if not touching else -190) * (r + l + fabs(e))
    out["coupler_angle"] = theta - delta
    if touching:
        out.update({k: "undefined" for k in VELOCITY_NAMES + ACCELERATION_NAMES})
        return out, sizes

    v = {k: (diff(x(w), t1), diff(y(w), t1)) for k, w in plate.items()}
    a = {k: (diff(x(w), t1, 2), diff(y(w), t1, 2)) for k, w in plate.items()}
    omega, alpha = diff(coupler, t1), diff(coupler, t1, 2)
    if fabs(omega) < ZERO * fabs(omega_2):
        omega = mpf(0)
    if fabs(alpha) < ZERO * omega_2 ** 2:
        alpha = mpf(0)
    out["omega_3"], out["alpha_3"] = omega, alpha
    for k in "BCM":
        out["v_" + k], out["a_" + k] = (distance(f[k], (0, 0)) for f in (v, a))
        out[f"v_{k}A"], out[f"a_{k}A"] = (distance(f[k], f["A"]) for f in (v, a))
    for k in "CM":
        for f, n in ((v, "v"), (a, "a")):
            out[f"{n}_{k}_x"], out[f"{n}_{k}_y"] = f[k]
    for k, f in (("v_B", v), ("a_B", a)):
        out[k + "_x"], out[k + "_y"] = f["B"]
    u = (cos(theta), sin(theta))
    d = (a["B"][0] - a["A"][0], a["B"][1] - a["A"][1])
    out["a_BA_n"], out["a_BA_t"] = fabs(d[0] * u[0] + d[1] * u[1]), fabs(d[1] * u[0] - d[0] * u[1])
    out["gamma"] = atan2(alpha, omega ** 2) if (alpha or omega) else "undefined"
    out["gamma_deg"] = out["gamma"] * 180 / pi if (alpha or omega) else "undefined"

    frame = [(mpf(0), mpf(0)), (l, mpf(0)), (mpf(0), l)]
    spots = [(x(w)(t1), y(w)(t1)) for w in frame]
    v_rows, v_at = affine(spots, [(diff(x(w), t1), diff(y(w), t1)) for w in frame])
    a_rows, a_at = affine(spots, [(diff(x(w), t1, 2), diff(y(w), t1, 2)) for w in frame])
    P, K = zero_of(v_rows, omega_2), zero_of(a_rows, omega_2 ** 2)
    for name, Q in (("P0", P), ("K", K)):
        out[name + "_x"], out[name + "_y"] = Q if Q else ("infinite", "infinite")
    for k in "ABCM":
        out["P0" + k] = distance(P, place[k]) if P else "infinite"
        out["K" + k] = distance(K, place[k]) if K else "infinite"

    def inflection(X, Y):
        (vx, vy), (ax, ay) = v_at(X, Y), a_at(X, Y)
        return vx * ay - vy * ax

    def stationarity(X, Y):
        (vx, vy), (ax, ay) = v_at(X, Y), a_at(X, Y)
        return vx * ax + vy * ay

    size = fabs(omega_2) ** 3 * (r + l) ** 2
    flexes = conic(inflection, l, size)
    centre = describe("inflection", flexes, size, l, out)
    describe("stationarity", conic(stationarity, l, size), size, l, out)
    J = (2 * centre[0] - P[0], 2 * centre[1] - P[1]) if centre and P else ("infinite", "infinite")
    out["inflection_pole_x"], out["inflection_pole_y"] = J

    for k in "CM":
        curvature(k, place[k], v[k], a[k], P, flexes, size, l, out)
    return out, sizes


def curvature(k, X, v, a, P, flexes, size, l, out):
    speed2, turn = v[0] ** 2 + v[1] ** 2, v[0] * a[1] - v[1] * a[0]
    rho_name, omega_name, prime = "rho_" + k, f"curvature_centre_{k}", k + "prime"
    at_rest = speed2 * l <= ZERO * size ** mpf(2 / 3.0)
    if at_rest:
        out.update({n: "undefined" for n in (rho_name, omega_name + "_x", omega_name + "_y", prime + "_x",
                                              prime + "_y", f"{prime}_{k}")})
        return
    if fabs(turn) <= ZERO * size:
        out.update({n: "infinite" for n in (rho_name, omega_name + "_x", omega_name + "_y")})
    else:
        out[rho_name] = speed2 * sqrt(speed2) / fabs(turn)
        out[omega_name + "_x"] = X[0] - v[1] * speed2 / turn
        out[omega_name + "_y"] = X[1] + v[0] * speed2 / turn
    if not P:
        straight = fabs(turn) <= ZERO * size
        out.update({n: "undefined" if straight else "infinite" for n in (prime + "_x", prime + "_y", f"{prime}_{k}")})
        return
    # Along the ray P + s (X - P) the form of the circle is q2 s² + q1 s (it vanishes at P, s = 0).
    q, m, n, c = flexes
    d = (X[0] - P[0], X[1] - P[1])
    s = -(2 * q * (P[0] * d[0] + P[1] * d[1]) + m * d[0] + n * d[1]) / (q * (d[0] ** 2 + d[1] ** 2))
    second = (P[0] + s * d[0], P[1] + s * d[1])
    out[prime + "_x"], out[prime + "_y"] = second
    out[f"{prime}_{k}"] = distance(second, X)
    if fabs(turn) > ZERO * size:
        euler_savary = distance(P, X) ** 2 / distance(second, X)
        assert fabs(euler_savary / out[rho_name] - 1) < mpf(10) ** -60, (k, out[rho_name], euler_savary)


DIMENSION = {"omega": (0, 1), "alpha": (0, 2), "v_": (1, 1), "a_": (1, 2)}


def text(name, value, sizes):
    if isinstance(value, str):
        return value
    r, l, omega_2 = sizes
    length, time = next((d for k, d in DIMENSION.items() if name.startswith(k)), (1, 0))
    if name in ("gamma", "gamma_deg", "coupler_angle") or name.endswith(("line_a", "line_b")):
        length = 0
    if fabs(value) <= ZERO * (r + l) ** length * fabs(omega_2) ** time:
        return "0"
    return nstr(value, DIGITS, min_fixed=-3, max_fixed=3)


def beside(base, exponent, sign=1):
    return str(Fraction(base) + sign * Fraction(1, 10 ** exponent))


def cases():
    yield Case("source", "the exercise as printed: r = 0.20, l = 0.50, 360 rpm, t1 = 1/72 s, so 30 degrees")
    yield Case("crank_speeding_up", "a crank acceleration adds a tangential part to every acceleration", alpha_2="100")
    yield Case("crank_braking", "the other sign of alpha_2", alpha_2="-250")
    yield Case("other_givens", "40 degrees: cosine and sine are not constructible", n="400", r="1/4", turn="1/9")
    yield Case("backwards", "a crank turning clockwise: signs of omega_3 and v_B_x", n="-360")
    yield Case("dead_centre_extended", "P0 falls on B, v_B is zero, alpha_3 is zero: stationarity circle a line", turn="0")
    yield Case("dead_centre_folded", "the same with the crank turned back", turn="1/2")
    yield Case("dead_centre_extended_braking", "alpha_3 is not zero at a dead centre if the crank brakes", turn="0",
               alpha_2="-250")
    yield Case("crank_upright", "pole at infinity: omega_3 is zero, both circles are lines", turn="1/4")
    yield Case("crank_downwards", "the same below the guide", turn="3/4")
    yield Case("crank_upright_speeding_up", "pole at infinity with a crank acceleration", turn="1/4", alpha_2="100")
    for e in (3, 9, 15, 30):
        yield Case(f"past_dead_centre_1e-{e}", "just past the outer dead centre, as a part of a turn", turn=beside("0", e))
        yield Case(f"before_dead_centre_1e-{e}", "just before it", turn=beside("1", e, -1))
        yield Case(f"before_upright_1e-{e}", "pole far away on the upper side", turn=beside("1/4", e, -1))
        yield Case(f"past_upright_1e-{e}", "pole far away on the lower side", turn=beside("1/4", e))
    yield Case("past_folded_1e-9", "just past the inner dead centre", turn=beside("1/2", 9))
    yield Case("past_downwards_1e-9", "pole far away, crank below", turn=beside("3/4", 9))
    short = dict(r="2/5", l="1/5", AC="3/20", BC="1/10")
    yield Case("short_coupler_closes", "l < r at 20 degrees: closes, the crank cannot turn fully", turn="1/18", **short)
    yield Case("short_coupler_left", "l < r at 170 degrees: closes again on the far side", turn="17/36", **short)
    yield Case("short_coupler_open", "l < r at 90 degrees: does not close, short by r - l", turn="1/4", **short)
    yield Case("short_coupler_open_below", "the same below the guide", turn="3/4", **short)
    yield Case("short_coupler_open_40", "l < r at 40 degrees: does not close by a little", turn="1/9", **short)
    yield Case("short_coupler_touches", "r = 2 l at 30 degrees: coupler square to the guide, velocity undefined",
               turn="1/12", **short)
    yield Case("short_coupler_touches_below", "the same at 210 degrees, on the other side", turn="7/12", **short)
    yield Case("short_coupler_nearly_touches", "30 degrees less 1e-9 turn: the worst transmission angle",
               turn=beside("1/12", 9, -1), **short)
    yield Case("short_coupler_nearly_closes", "30 degrees and 1e-9 turn: open by 2e-9 m", turn=beside("1/12", 9), **short)
    equal = dict(r="1/5", l="1/5", AC="3/20", BC="1/10")
    yield Case("equal_lengths", "l = r: elliptic motion, both polodes are circles", turn="1/7", **equal)
    yield Case("equal_lengths_touch", "l = r upright: B on A0 and two motions possible, velocity undefined", turn="1/4",
               **equal)
    yield Case("equal_lengths_locked", "l = r past upright: B stays on A0, the inflection circle is a point", turn="1/3",
               **equal)
    yield Case("flat_plate", "AC + BC = AB: C on AB, height exactly zero", AC="1/5", BC="3/10")
    yield Case("flat_plate_decimal", "the same with lengths no double holds", l="3/10", r="1/10", AC="1/10", BC="1/5")
    yield Case("plate_beyond_B", "AC = AB + BC: C on the line beyond B", AC="7/10", BC="1/5")
    yield Case("long_plate", "AC > AB", AC="7/10", BC="2/5")
    yield Case("irrational_height", "the height of C is irrational", AC="2/5", BC="3/10", l="9/20")
    yield Case("crank_20_degrees", "20 degrees: not constructible", turn="1/18")
    yield Case("crank_seventh", "a seventh of a turn: not constructible", turn="1/7")
    yield Case("crank_45_degrees", "square root of two", turn="1/8")
    yield Case("crank_150_degrees", "second quadrant", turn="5/12")
    yield Case("crank_200_degrees", "third quadrant", turn="5/9")
    yield Case("crank_310_degrees", "fourth quadrant", turn="31/36")
    yield Case("second_turn", "phi beyond a full turn: 390 degrees", turn="13/12")
    yield from offset_cases()
    yield from inclined_cases()
    small, large = Fraction(1, 10 ** 9), Fraction(10 ** 8)
    for name, s in (("tiny", small), ("huge", large)):
        yield Case(name, "the source's linkage, scaled", r=Fraction(1, 5) * s, l=Fraction(1, 2) * s,
                   AC=Fraction(3, 10) * s, BC=Fraction(2, 5) * s)


def offset_cases():
    """The guide passes A0 at the distance e."""
    yield Case("offset", "the guide above A0: no symmetry is left", e="2/25")
    yield Case("offset_below", "the guide below A0", e="-1/10", turn="1/18")
    yield Case("offset_speeding_up", "with a tangential part", e="1/20", turn="5/9", alpha_2="100")
    yield Case("offset_backwards", "clockwise", e="2/25", n="-360")
    yield Case("offset_upright", "pole at infinity: B no longer as far along as for e = -e", e="2/25", turn="1/4")
    yield Case("offset_downwards", "pole at infinity on the other side", e="2/25", turn="3/4")
    yield Case("offset_past_upright_1e-9", "pole far away", e="2/25", turn=beside("1/4", 9))
    yield Case("offset_extended", "sin phi = e/(r + l) = 1/2: A0, A, B in line, P0 on B", r="1/10", e="3/10", turn="1/12")
    yield Case("offset_extended_braking", "the same with a crank acceleration", r="1/10", e="3/10", turn="1/12",
               alpha_2="-250")
    yield Case("offset_extended_missed_1e-15", "just past it", r="1/10", e="3/10", turn=beside("1/12", 15))
    yield Case("offset_folded", "sin phi = e/(r - l) = 1/2 with the crank turned back", e="-3/20", turn="5/12")
    yield Case("offset_folded_below", "sin phi = -1/2", e="3/20", turn="7/12")
    change = dict(l="3/10", AC="1/4", BC="1/5", e="1/10")
    yield Case("offset_change_point", "r + e = l: the crank just turns fully", turn="5/18", **change)
    yield Case("offset_change_point_met", "and stands at its limit: coupler square to the guide", turn="3/4", **change)
    neither = dict(l="1/4", AC="1/5", BC="3/20", e="-3/20")
    yield Case("offset_swings", "neither crank nor coupler turns fully", turn="1/60", **neither)
    yield Case("offset_swings_touches", "r sin phi - e = l at 30 degrees: velocity undefined", turn="1/12", **neither)
    yield Case("offset_swings_nearly_touches", "less 1e-9 turn", turn=beside("1/12", 9, -1), **neither)
    yield Case("offset_swings_open", "upright it does not close, short by 0.1 m", turn="1/4", **neither)
    rocks = dict(r="2/5", l="1/5", AC="3/20", BC="1/10", e="1/10")
    yield Case("offset_short_coupler", "the coupler turns fully, the crank swings", turn="1/18", **rocks)
    yield Case("offset_short_coupler_left", "the same on the far side", turn="17/36", **rocks)
    yield Case("offset_short_coupler_open", "and where it does not close", turn="-1/18", **rocks)
    yield Case("offset_nowhere", "e > r + l: it closes nowhere, short by 0.4 m even upright", e="11/10", turn="1/4")
    yield Case("offset_equal_lengths", "l = r with an offset: no longer Cardano's circles", l="1/5", AC="3/20",
               BC="1/10", e="1/20", turn="1/7")
    small, large = Fraction(1, 10 ** 9), Fraction(10 ** 8)
    for name, s in (("tiny", small), ("huge", large)):
        yield Case("offset_" + name, "scaled", r=Fraction(1, 5) * s, l=Fraction(1, 2) * s, AC=Fraction(3, 10) * s,
                   BC=Fraction(2, 5) * s, e=Fraction(2, 25) * s, delta="20")


def inclined_cases():
    """The guide has a direction of its own; degrees. The crank angle is still counted from +x."""
    for delta in ("30", "90", "200", "-45"):
        yield Case(f"inclined_{delta}", "centred, the crank at 20 degrees", delta=delta, turn="1/18")
        yield Case(f"offset_inclined_{delta}", "with an offset, the crank at 100 degrees", delta=delta, e="-1/10",
                   turn="5/18")
    yield Case("inclined_vertical_upright", "an engine: guide upwards, crank along it: outer dead centre", delta="90",
               turn="1/4")
    yield Case("inclined_extended", "crank and guide at 20 degrees: a dead centre that is not constructible", delta="20",
               turn="1/18")
    yield Case("inclined_folded", "the inner one", delta="20", turn="5/9")
    yield Case("inclined_upright", "guide at 20 degrees, crank at 110: pole at infinity", delta="20", turn="11/36")
    yield Case("offset_inclined_upright", "the same with an offset", delta="20", turn="11/36", e="2/25")
    yield Case("offset_inclined_downwards", "crank at 290", delta="20", turn="29/36", e="2/25", alpha_2="100")
    yield Case("offset_inclined_extended", "in line at 45 degrees: guide at 15", r="1/10", e="3/10", delta="15",
               turn="1/8")
    yield Case("offset_inclined_folded", "in line, not constructible", e="-3/20", delta="20", turn="17/36")
    yield Case("offset_inclined", "offset and inclined, 30 degrees", e="2/25", delta="20")
    yield Case("offset_inclined_braking", "with a crank acceleration, clockwise", e="2/25", delta="-160", n="-90",
               alpha_2="-250")
    yield Case("inclined_equal_lengths_locked", "l = r past the square: B stays on A0", l="1/5", AC="3/20", BC="1/10",
               delta="20", turn="7/18")
    yield Case("inclined_turns", "a guide direction beyond a full turn", delta="740", e="2/25")


HEADER = """\
# Reference values of the slider-crank, 40 digits. Written by make_slider_crank.py with mpmath, 400 working
# digits; do not edit by hand. Positions are the only formulas (closure: B at the distance e from a line through A0, C
# by two circles); velocities and accelerations are high-precision numerical derivatives of the paths, P0 and K the zeros of
# the affine fields fitted to three moving points, the circles are fitted conics, curvature is that of the paths.
# Nothing here is taken from the C++ code.
#
# A0 origin; the guide has the direction delta (degrees from +x) and passes A0 at the distance e, on its left when
# e > 0. Crank at phi = 2 pi n/60 t1 from +x; alpha_2 is its angular acceleration at t1. Counter-clockwise positive;
# B ahead of A along the guide (positive root); C left of A to B; M midpoint of AB. coupler_angle: of AB, from the guide.
# omega_3, alpha_3, components, coupler_angle, gamma = atan(alpha_3 / omega_3^2) are signed, the rest magnitudes.
# K: acceleration pole. inflection_pole: opposite P0 on the inflection circle. Cprime: second meeting of the ray P0 C
# with it. *_line_a, _b, _c: the line a x + b y + c = 0 that the circle has become; a^2 + b^2 = 1, the first of a, b
# that is not zero is positive. SI units, radians (crank_angle_phi_deg: degrees).
#
# case NAME, why TEXT, givens (rationals), then NAME VALUE; VALUE may be `infinite` or `undefined`.
# closure_gap: the linkage does not close, A is farther than l from the guide by this much, and nothing else exists.
"""


def main():
    print(HEADER, end="")
    for case in cases():
        print(f"\ncase {case.name}\nwhy {case.why}")
        for name in ("r", "l", "AC", "BC", "n", "t1", "alpha_2", "e", "delta"):
            print(f"given {name} {getattr(case, name)}")
        out, sizes = values(case)
        for name, value in out.items():
            print(name, text(name, value, sizes))


if __name__ == "__main__":
    main()
