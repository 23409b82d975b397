#!/usr/bin/env python3
"""Writes boat_crane.txt: reference values of the boat crane, independent of the C++ code.

  make_boat_crane.py > boat_crane.txt

Sections are polygons, and their moments come by Green's theorem from the corners. The beam is two finite elements
(Hermite cubics, exact for loads in the nodes) with the column as a spring, so that reactions, rotations and deflections
are one linear system; the rigid column is that of infinite stiffness. Bending moments and areas are quadratures of the
element's curvature. Principal stresses are eigenvalues by Jacobi's rotation; Jourawsky's shear is what a slice of the
upper half needs for its balance. The critical load is the first load at which the equation of the column with both ends
hinged, shot from one end, meets the other. Soderberg's range solves the two equations of a line.
"""
from fractions import Fraction

from mpmath import atan2, cos, findroot, inf, lu_solve, matrix, mp, mpf, nstr, polyroots, quad, sin, sqrt

mp.dps = 90

STATED = dict(L="3", H_0="5", W_b="300", s_1="5", H_1="300", b_1="200", s_2="2", H_2="180", b_2="100", E="210000",
              g="980665/100000", sigma_S="300", Delta_sigma_L="200", Psi="3/2")


def mean_stress_of_beam(given):
    """In MPa, exactly: where Soderberg's diagram ends. (Only to place the cases.)"""
    q = {k: Fraction(v) for k, v in given.items()}
    H, b, s = q["H_1"], q["b_1"], q["s_1"]
    J = (b * H**3 - (b - s) * (H - 2 * s) ** 3) / 12
    return 2 * q["W_b"] * q["g"] * q["L"] * 1000 * H / 2 / J / 2


def yielding_at_mean(beside):
    return dict(sigma_S=str(mean_stress_of_beam(STATED) * (1 + beside)))


CASES = [
    ("stated", "the exercise as it is stated", {}),
    ("computed", "the mass that the source computes with", dict(W_b="600")),
    ("odd", "no round number anywhere", dict(L="31/11", H_0="47/13", W_b="419/3", s_1="37/7", H_1="2311/10", b_1="1493/9",
                                             s_2="23/9", H_2="1213/7", b_2="917/8", E="206813", g="981/100",
                                             sigma_S="2351/7", Delta_sigma_L="1613/9", Psi="17/11")),
    ("weak_about_x", "flat and wide: the column is weaker about the axis of its web's depth",
     dict(H_2="60", b_2="240", s_2="6")),
    ("bars", "no flange beyond the web: rectangles", dict(b_1="5", b_2="2")),
    ("thick", "almost no web", dict(s_1="149", s_2="89")),
    ("short", "a short column, below the slenderness at which Euler's load holds", dict(H_0="1/2")),
    ("heavy", "far beyond what the crane bears", dict(W_b="1000000")),
    ("light", "a gram", dict(W_b="1/1000")),
    ("small", "micrometres", dict(L="3/1000000", H_0="5/1000000", s_1="1/100000", H_1="6/10000", b_1="4/10000",
                                  s_2="1/100000", H_2="4/10000", b_2="2/10000", W_b="1/1000000")),
    ("mean_yields", "half of the greatest stress is the yield stress: Soderberg's diagram ends", yielding_at_mean(0)),
    ("nearly_above", "missed by 1e-9", yielding_at_mean(Fraction(1, 10**9))),
    ("nearly_below", "missed by 1e-9, on the other side", yielding_at_mean(-Fraction(1, 10**9))),
    ("hardly_above", "missed by 1e-30", yielding_at_mean(Fraction(1, 10**30))),
    ("hardly_below", "missed by 1e-30, on the other side", yielding_at_mean(-Fraction(1, 10**30))),
]
NOT_OF_LOAD = {"A_1", "J_x1", "J_y1", "W_x1", "S_x1_max", "A_2", "J_x2", "J_y2", "sigma_amm", "Delta_sigma_Lamm", "J_min",
               "i_min", "slenderness", "slenderness_limit", "P_cr", "P_cr_strong_axis", "P_cr_over_Psi", "xi_v_max_BC"}


def number(rational):
    q = Fraction(rational)
    return mpf(q.numerator) / q.denominator


def outline(H, b, s):
    """Counter-clockwise from the lower left corner."""
    h = H / 2 - s
    right = [(b / 2, -H / 2), (b / 2, -h), (s / 2, -h), (s / 2, h), (b / 2, h), (b / 2, H / 2)]
    return right + [(-x, y) for x, y in reversed(right)]


def green(corners, of):
    total = mpf(0)
    for (x, y), (u, v) in zip(corners, corners[1:] + corners[:1]):
        total += of(x, y, u, v) * (x * v - u * y)
    return total


class Section:
    def __init__(self, H, b, s):
        corners = outline(H, b, s)
        self.A = green(corners, lambda x, y, u, v: mpf(1) / 2)
        self.J_x = green(corners, lambda x, y, u, v: (y * y + y * v + v * v) / 12)
        self.J_y = green(corners, lambda x, y, u, v: (x * x + x * u + u * u) / 12)
        h = H / 2 - s
        upper = [(s / 2, mpf(0)), (s / 2, h), (b / 2, h), (b / 2, H / 2)]
        upper += [(-x, y) for x, y in reversed(upper)]
        self.S = green(upper, lambda x, y, u, v: (y + v) / 6)


def element(EJ, l):
    return [[12 * EJ / l**3, 6 * EJ / l**2, -12 * EJ / l**3, 6 * EJ / l**2],
            [6 * EJ / l**2, 4 * EJ / l, -6 * EJ / l**2, 2 * EJ / l],
            [-12 * EJ / l**3, -6 * EJ / l**2, 12 * EJ / l**3, -6 * EJ / l**2],
            [6 * EJ / l**2, 2 * EJ / l, -6 * EJ / l**2, 4 * EJ / l]]


def displaced(EJ, L, P, spring):
    """v and θ of B, C, D, with v_B = 0; `spring` under C, None: rigid."""
    K = matrix(6, 6)
    for first, l in ((0, L), (2, 2 * L)):
        k = element(EJ, l)
        for i in range(4):
            for j in range(4):
                K[first + i, first + j] += k[i][j]
    if spring is not None:
        K[2, 2] += spring
    held = [0] if spring is not None else [0, 2]
    free = [i for i in range(6) if i not in held]
    load = matrix(len(free), 1)
    load[free.index(4)] = -P
    reduced = matrix(len(free), len(free))
    for a, i in enumerate(free):
        for c, j in enumerate(free):
            reduced[a, c] = K[i, j]
    found = lu_solve(reduced, load)
    d = [mpf(0)] * 6
    for a, i in enumerate(free):
        d[i] = found[a]
    forces = [sum(K[i, j] * d[j] for j in range(6)) for i in range(6)]
    return d, forces


def cubic(d, l):
    """Coefficients of v over x of an element, from those of its ends."""
    v, t, w, u = d
    return [v, t, (-3 * v - 2 * t * l + 3 * w - u * l) / l**2, (2 * v + t * l - 2 * w + u * l) / l**3]


def eigenvalues(sigma, tau):
    """Of (σ τ; τ 0), by the rotation that makes it diagonal."""
    angle = atan2(2 * tau, sigma) / 2
    c, s = cos(angle), sin(angle)
    return c * c * sigma + 2 * c * s * tau, s * s * sigma - 2 * c * s * tau


def von_mises(sigma, tau):
    one, other = eigenvalues(sigma, tau)
    return sqrt(((one - other) ** 2 + one**2 + other**2) / 2)


def soderberg(mean, reach, yielding):
    """Where the line through (mean, reach) and (yielding, 0) crosses mean = 0."""
    if mean > yielding * (1 - mpf(10) ** -60):  # equal, but for rounding, or beyond
        return inf
    slope, height = lu_solve(matrix([[mean, 1], [yielding, 1]]), matrix([reach, 0]))
    return height


def euler(EJ, l):
    """v'' = −F/(EJ) v from v = 0: the first F at which v(l) = 0 again."""
    about = mpf("9.87") * EJ / l**2
    scaled = findroot(lambda f: sin(sqrt(f * about / EJ) * l), mpf(1))
    return scaled * about


def of_load(q, beam, column, mass):
    EJ, L = q["E"] * beam.J_x, q["L"]
    P = mass * q["g"]
    rigid, forces = displaced(EJ, L, P, None)
    elastic, _ = displaced(EJ, L, P, q["E"] * column.A / q["H_0"])
    between, beyond = cubic(rigid[:4], L), cubic(rigid[2:], 2 * L)
    M_between = lambda x: EJ * (2 * between[2] + 6 * between[3] * x)
    M_beyond = lambda x: EJ * (2 * beyond[2] + 6 * beyond[3] * (x - L))
    Y_A, Y_B = forces[2], forces[0]
    M_C = M_between(L)
    sigma = -M_C * q["H_1"] / 2 / beam.J_x
    shear = 6 * between[3] * EJ  # dM/dx
    tau, web = shear / beam.A, shear / (q["s_1"] * (q["H_1"] - 2 * q["s_1"]))
    N = -Y_A
    sigma_N = N / column.A
    amm, Lamm = q["sigma_S"] / q["Psi"], q["Delta_sigma_L"] / q["Psi"]
    effective = soderberg(sigma / 2, sigma, q["sigma_S"])
    effective_2 = soderberg(sigma_N / 2, sigma_N, q["sigma_S"])
    P_cr = euler(q["E"] * min(column.J_x, column.J_y), q["H_0"])
    slope = polyroots([3 * between[3], 2 * between[2], between[1]], maxsteps=500, extraprec=400)
    xi = next(x for x in (r.real for r in slope) if 0 < x < L)
    return {
        "P": P, "Y_A": Y_A, "X_B": mpf(0), "Y_B": Y_B, "R_B": -Y_B, "T_1_BC": shear, "T_1_CD": 6 * beyond[3] * EJ,
        "M_1_mid_BC": M_between(L / 2), "M_C": M_C, "M_1_mid_CD": M_beyond(2 * L), "N_2": N,
        "sigma_z_max": sigma, "tau_zy": tau, "sigma_eq": von_mises(sigma, tau), "tau_web_mean": web,
        "tau_max_Jourawsky": shear * beam.S / beam.J_x / q["s_1"], "sigma_eq_web_shear": von_mises(sigma, web),
        "beam_static_utilisation": von_mises(sigma, tau) / amm, "Delta_sigma": sigma, "sigma_m": sigma / 2,
        "Delta_sigma_eff": effective, "beam_fatigue_utilisation": effective / Lamm,
        "sigma_zN": sigma_N, "column_static_utilisation": abs(sigma_N) / amm, "sigma_m2": sigma_N / 2,
        "Delta_sigma_eff2": effective_2,
        "Delta_sigma_eff2_conservative": soderberg(-sigma_N / 2, -sigma_N, q["sigma_S"]),
        "column_fatigue_utilisation": abs(effective_2) / Lamm,
        "buckling_utilisation": abs(N) / (P_cr / q["Psi"]), "buckling_safety_factor": P_cr / abs(N),
        "moment_area_BC": quad(M_between, [0, L]), "moment_area_CD": quad(M_beyond, [L, 3 * L]),
        "theta_B": rigid[1], "theta_C": rigid[3], "theta_D": rigid[5], "xi_v_max_BC": xi,
        "v_max_BC": sum(c * xi**i for i, c in enumerate(between)), "v_D_bending": rigid[4],
        "column_shortening": -elastic[2], "v_D": elastic[4],
    }


def values(given):
    q = {k: number(v) for k, v in given.items()}
    for name in ("s_1", "H_1", "b_1", "s_2", "H_2", "b_2"):
        q[name] /= 1000
    for name in ("E", "sigma_S", "Delta_sigma_L"):
        q[name] *= 10**6
    beam, column = Section(q["H_1"], q["b_1"], q["s_1"]), Section(q["H_2"], q["b_2"], q["s_2"])
    J_min, J_max = min(column.J_x, column.J_y), max(column.J_x, column.J_y)
    P_cr = euler(q["E"] * J_min, q["H_0"])
    i = sqrt(J_min / column.A)
    # The slenderness of a bar of this section that buckles at the yield stress: found by its length.
    limit = findroot(lambda l: euler(q["E"] * J_min, l * i) / column.A / q["sigma_S"] - 1,
                     mpf("3.14") * sqrt(q["E"] / q["sigma_S"]))
    all_values = {
        "A_1": beam.A, "J_x1": beam.J_x, "J_y1": beam.J_y, "W_x1": beam.J_x / (q["H_1"] / 2), "S_x1_max": beam.S,
        "A_2": column.A, "J_x2": column.J_x, "J_y2": column.J_y, "sigma_amm": q["sigma_S"] / q["Psi"],
        "Delta_sigma_Lamm": q["Delta_sigma_L"] / q["Psi"], "J_min": J_min, "i_min": i, "slenderness": q["H_0"] / i,
        "slenderness_limit": limit, "P_cr": P_cr, "P_cr_strong_axis": euler(q["E"] * J_max, q["H_0"]),
        "P_cr_over_Psi": P_cr / q["Psi"],
    }
    all_values.update(of_load(q, beam, column, q["W_b"]))
    computed = of_load(q, beam, column, mpf(600))
    all_values.update({"mass_600kg." + k: v for k, v in computed.items() if k not in NOT_OF_LOAD})
    return all_values


def text(x):
    if x == inf:
        return "infinite"
    return "0" if x == 0 else nstr(x, 40, strip_zeros=True, min_fixed=-30, max_fixed=30)


HEADING = """# Reference values of the boat crane, 40 digits. Written by make_boat_crane.py with mpmath, 90 working digits; do not
# edit by hand. Sections by Green's theorem, the beam as finite elements on a spring, eigenvalues by rotation, the
# critical load by shooting. Nothing here is taken from the C++ code.
#
# Givens in m, mm, kg, MPa as the exercise states them; quantities in SI. "infinite": does not exist."""


def write(heading, stated, cases, values_of):
    print(heading)
    for name, why, changed in cases:
        given = {**stated, **changed}
        print(f"\ncase {name}\nwhy {why}")
        for symbol, value in given.items():
            print("given", symbol, value)
        for quantity, value in values_of(given).items():
            print(quantity, text(value))


if __name__ == "__main__":
    write(HEADING, STATED, CASES, values)
