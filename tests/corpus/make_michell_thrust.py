#!/usr/bin/env python3
"""Writes michell_thrust.txt: reference values of the Michell thrust bearing.

  make_michell_thrust.py > michell_thrust.txt

Of the film only integrals of Reynolds' equation are used (make_michell_bearing.py); the coefficients of the printed
table are taken from it by the two-point formula.
"""
from mpmath import atan, exp, findroot, log, mp, mpf, pi, sqrt

from make_michell_bearing import Wedge, centre, number, text

KGF = mpf("9.80665")
TABLE = [("1.6", ".141", ".548", "2.20"), ("1.8", ".153", ".559", "2.03"), ("2.0", ".159", ".571", "1.94"),
         ("2.2", ".160", ".577", "1.88"), ("2.4", ".159", ".586", "1.85"), ("2.6", ".156", ".594", "1.83"),
         ("2.8", ".152", ".601", "1.82"), ("3.0", ".148", ".608", "1.81")]
STATED = dict(Q="700", n_g="75", D_e="11/5", D_i="11/10", d="50", x_N_over_l="113/200", mu="7/2000", z="10")
CASES = [("stated", "the exercise as it is stated", {}),
         ("first_row", "the pivot on a row of the table, its first", dict(x_N_over_l="137/250")),
         ("last_row", "the pivot on the last row", dict(x_N_over_l="76/125")),
         ("on_a_row", "the pivot on a row within", dict(x_N_over_l="577/1000")),
         ("parallel", "n = 1 + 1e-15: walls that hardly narrow; the pivot is off the table",
          dict(x_N_over_l="5000000000000001/10000000000000000")),
         ("narrow", "n is about a thousand; the pivot is off the table", dict(x_N_over_l="9/10")),
         ("odd", "no round number anywhere", dict(Q="1234/7", n_g="1000/13", D_e="29/17", D_i="31/41", d="191/7",
                                                  x_N_over_l="463/791", mu="3/1117", z="7"))]


def coefficients(w, n):
    """A and k of a wedge of length, speed and viscosity 1 with films n and 1."""
    A = w.moments()[0]
    return A, w.drag(1) / sqrt(A)


def values(g):
    out = {}
    R = (g["D_e"] + g["D_i"]) / 4
    omega = g["n_g"] * 2 * pi / 60
    v, b, z = omega * R, (g["D_e"] - g["D_i"]) / 2, g["z"]
    l = 2 * pi * R / z - g["d"] / 1000
    N_p, mu = g["Q"] * 1000 * KGF / z, g["mu"] * KGF
    c, c_prime = b / (b + l), sqrt((4 * l + b) / b)
    xi = g["x_N_over_l"]
    rows = [tuple(mpf(x) for x in row) for row in TABLE]
    is_off_table = not rows[0][2] <= xi <= rows[-1][2]
    i = 0 if is_off_table else max(k for k in range(len(rows) - 1) if rows[k][2] <= xi)
    share = (xi - rows[i][2]) / (rows[i + 1][2] - rows[i][2])
    n, A, k = (rows[i][j] + share * (rows[i + 1][j] - rows[i][j]) for j in (0, 1, 3))

    def films(prefix, n, A, N):
        h2 = l * sqrt(A * mu * v / N)
        alpha = atan((n - 1) * h2 / l)
        out.update({prefix + "h_2": h2, prefix + "h_1": n * h2, prefix + "alpha": alpha,
                    prefix + "alpha_deg": alpha * 180 / pi})
        return h2

    def friction(prefix, k, factor, width):
        N = N_p / width
        f = k * factor * sqrt(mu * v / N)
        out.update({prefix + "f_m": f, prefix + "T": f * N, prefix + "T_p": f * N_p, prefix + "M": z * f * N_p * R,
                    prefix + "dissipated_power": z * f * N_p * v})

    out.update({"R_m": R, "omega": omega, "v": v, "b": b, "l": l, "N_p": N_p, "p_m": N_p / (b * l), "c": c,
                "b_eff": c * b, "N": N_p / (c * b), "mu": mu, "n": n, "A": A, "A_n_minus_1_squared": A * (n - 1) ** 2,
                "k": k, "x_N": xi * l, "c_prime": c_prime})
    before = set(out) - {"n", "A", "A_n_minus_1_squared", "k"}
    films("", n, A, N_p / (c * b))
    friction("", k, c_prime, c * b)
    films("no_side_leakage.", n, A, N_p / b)
    friction("no_side_leakage.", k, mpf(1), b)
    friction("nominal_load.", k, c_prime, b)
    if is_off_table:  # then there is no chord
        out.update({name: None for name in set(out) - before})
    for m in ("1.6", "1.8", "1.9", "2.0", "2.2", "2.4", "2.6", "2.8", "3.0"):
        prefix, m = "table_n_%s." % m.replace(".", "_"), mpf(m)
        A_m, k_m = coefficients(Wedge(mpf(1), mpf(1), mpf(1), m, mpf(1)), m)
        out.update({prefix + "A": A_m, prefix + "A_n_minus_1_squared": A_m * (m - 1) ** 2,
                    prefix + "x_N_over_l": centre(m), prefix + "k": k_m})
    start = 10 * (xi - mpf(1) / 2) if xi < mpf("0.65") else exp(2 + mpf(1) / 2 / (1 - xi)) * mpf("0.3")
    y = findroot(lambda y: centre(1 + exp(y)) - xi, (log(start), log(start) + mpf("0.01")), tol=mpf(10) ** -150)
    n = 1 + exp(y)
    A, k = coefficients(Wedge(mpf(1), mpf(1), mpf(1), n, mpf(1)), n)
    out.update({"theory.n": n, "theory.A": A, "theory.k": k})
    h2 = films("theory.", n, A, N_p / (c * b))
    friction("theory.", k, c_prime, c * b)
    w = Wedge(l, v, mu, n * h2, h2)
    x_bar = (w.h1 - w.h_bar) / w.slope
    out.update({"theory.h_p_max": w.h_bar, "theory.x_p_max": x_bar, "theory.p_max": w.pressure(x_bar),
                "theory.p_1_4": w.pressure(l / 4), "theory.p_1_2": w.pressure(l / 2),
                "theory.p_3_4": w.pressure(3 * l / 4)})
    return out


def main():
    print("# Reference values of the Michell thrust bearing, 40 digits. Written by make_michell_thrust.py with mpmath; do")
    print("# not edit by hand. Integrals of Reynolds' equation over ln h. Q in tonnes-force, n_g in rpm, d in mm, mu in")
    print("# kgf s/m^2; values in SI units.")
    for name, why, changed in CASES:
        given = {**STATED, **changed}
        print("\ncase %s\nwhy %s" % (name, why))
        for k, v in given.items():
            print("given %s %s" % (k, v))
        for k, v in values({k: number(v) for k, v in given.items()}).items():
            print(k, text(v))


if __name__ == "__main__":
    main()
