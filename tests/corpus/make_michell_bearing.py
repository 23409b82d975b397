#!/usr/bin/env python3
"""Writes michell_bearing.txt: reference values of the lubricated slider and of the bearing of tilting pads.

  make_michell_bearing.py > michell_bearing.txt

Of the film only Reynolds' equation is written down: p' = 6 mu V (1/h^2 - h_bar/h^3) with h_bar so that the integral of
p' over the slider is zero. The integrals are taken over ln h, where the integrands are powers of e (Gauss-Legendre,
to 60 digits more than are kept); pressures are integrals of p', the load one of the pressures. Velocities are the
parabola with u'' = p'/mu through 0 and V, shears its slopes. The ratio of films of a pivot is a zero found by
secants; film and friction follow from the integrals.
"""
from fractions import Fraction

from mpmath import exp, fabs, findroot, log, mp, mpf, nstr, pi, quad, sqrt

mp.dps = 120
ZERO = mpf(10) ** -60

STATED = dict(l="2/5", V="12/5", h_1="2/5", h_2="4/25", mu="1/25", dx="1/100", x_1="3/20", x_3="7/20", P="80000",
              speed="800", pads="8", r_m="1/10", l_pad="147/2000", b="3/50", x_N="9/200", mu_pad="7/200", h_ref="30")
CASES = [
    ("stated", "the exercise as it is stated", {}),
    ("twice", "n = 2: the shear is zero just at the ends", dict(h_1="8/25")),
    ("short_of_twice", "n a little less than 2: the shear is zero nowhere", dict(h_1="31999999999/100000000000")),
    ("nearly_parallel", "n = 1 + 1e-15; the pivot 1e-15 l beyond the middle",
     dict(h_1="1000000000000001/6250000000000000", x_N="147000000000000294/4000000000000000000")),
    ("steep", "n = 1000, n of the pad near it", dict(h_1="160", x_N="1323/20000", V="1/10")),
    ("x_bar_on_grid", "n = 3: the gradient is zero at 0.30, a station of the table", dict(h_1="12/25")),
    ("odd", "no round number anywhere",
     dict(l="37/100", V="29/7", h_1="41/83", h_2="17/97", mu="13/119", x_1="13/71", x_3="29/83", P="71234/3",
          speed="12345/7", pads="7", r_m="13/97", l_pad="11/131", b="7/113", x_N="6/119", mu_pad="3/71", h_ref="19/3")),
    ("thin", "a film that is not enough", dict(P="800000")),
]
STATIONS = ["0p00", "0p05", "0p10", "0p15", "0p20", "0p25", "0p29", "0p30", "0p35", "0p40"]
DEPTHS = ["0p05mm", "0p10mm", "0p15mm", "0p20mm", "0p25mm", "0p30mm"]


def number(rational):
    q = Fraction(rational)
    return mpf(q.numerator) / q.denominator


def text(x):
    if x is None:
        return "infinite"
    return "0" if fabs(x) <= ZERO else nstr(x, 40, strip_zeros=True, min_fixed=-30, max_fixed=30)


class Wedge:
    """Films h1 > h2 over a length l; integrals over y = ln(h/h2)."""

    def __init__(self, l, V, mu, h1, h2):
        self.l, self.V, self.mu, self.h1, self.h2 = l, V, mu, h1, h2
        self.slope = (h1 - h2) / l
        self.h_bar = self.power(-2) / self.power(-3)

    def power(self, k, x=None):
        """Integral of h^k from 0 to x."""
        low = mpf(0) if x is None else log(self.h(x) / self.h2)
        high = log(self.h1 / self.h2)
        steps = [low + (high - low) * i / 8 for i in range(9)]
        return quad(lambda y: exp((k + 1) * y), steps, method="gauss-legendre") * self.h2 ** (k + 1) / self.slope

    def h(self, x):
        return self.h1 - self.slope * x

    def gradient(self, x):
        h = self.h(x)
        return 6 * self.mu * self.V * (h - self.h_bar) / h ** 3

    def pressure(self, x):
        if fabs(x - self.l) < ZERO:
            return mpf(0)
        return 6 * self.mu * self.V * (self.power(-2, x) - self.h_bar * self.power(-3, x))

    def moments(self):
        """Of the pressures, order 0 and 1: -1/(k+1) times the moments of p' of order k + 1."""
        def moment(k):
            # x = (h1 - h)/slope
            if k == 1:
                terms = [(self.h1, 0), (-1, 1)]
            else:
                terms = [(self.h1 ** 2, 0), (-2 * self.h1, 1), (1, 2)]
            return sum(c * (self.power(p - 2) - self.h_bar * self.power(p - 3)) for c, p in terms) / self.slope ** k
        unit = 6 * self.mu * self.V
        return -unit * moment(1), -unit * moment(2) / 2

    def drag(self, side):
        return self.mu * self.V * self.power(-1) + side * 3 * self.mu * self.V * (self.power(-1)
                                                                                 - self.h_bar * self.power(-2))

    def velocity(self, x, z):
        half = self.gradient(x) / (2 * self.mu)
        h = self.h(x)
        return half * z * z + (self.V / h - half * h) * z

    def shear(self, x, z):
        half = self.gradient(x) / (2 * self.mu)
        h = self.h(x)
        return self.mu * (2 * half * z + self.V / h - half * h)


def inverse(g):
    l, h1, h2 = g["l"], g["h_1"] / 1000, g["h_2"] / 1000
    w = Wedge(l, g["V"], g["mu"], h1, h2)
    n = h1 / h2
    N, moment = w.moments()
    x_N = moment / N
    x_bar = (h1 - w.h_bar) / w.slope
    p_max = w.pressure(x_bar)
    T, T_fixed = w.drag(1), w.drag(-1)
    out = {"n": n, "h_bar": w.h_bar, "x_bar": x_bar, "p_max": p_max, "A": N * h2 ** 2 / (g["mu"] * g["V"] * l ** 2),
           "N": N, "x_N": x_N, "T": T, "T_fixed": T_fixed, "f_m": T / N, "p_mean": N / l,
           "p_max_over_p_mean": p_max * l / N,
           "flow_rate": quad(lambda z: w.velocity(mpf(0), z), [0, h1]), "power_loss": T * g["V"]}
    for name, side in (("fixed", 0), ("moving", 1)):
        shear = [w.shear(x, side * w.h(x)) * w.h(x) ** 2 for x in (mpf(0), l)]  # linear in x
        at = l * shear[0] / (shear[0] - shear[1])
        inside = -ZERO <= at <= l + ZERO
        out["x_shear_zero_" + name] = at if inside else None
    m = int(round(l / g["dx"]))
    p = [mpf(0)]
    slopes = [w.gradient(i * g["dx"]) for i in range(m + 1)]
    for i in range(m):
        p.append(p[-1] + g["dx"] * (slopes[i] + slopes[i + 1]) / 2)
    for name in STATIONS:
        x = mpf(name.replace("p", "."))
        x = mpf(round(x * 100)) / 100
        there = x <= l
        out["h_at_" + name] = w.h(x) if there else None
        out["dp_dx_at_" + name] = w.gradient(x) if there else None
        if name not in ("0p00", "0p40"):
            out["p_at_" + name] = w.pressure(x) if there else None
        if name != "0p00":
            i = x / g["dx"]
            whole = there and fabs(i - round(i)) < ZERO
            out["p_bezout_at_" + name] = p[int(round(i))] if whole else None
    out["p_max_bezout"] = max(p)
    out["N_bezout"] = g["dx"] * (sum(p) - (p[0] + p[-1]) / 2)
    xp = [i * g["dx"] * p[i] for i in range(m + 1)]
    out["x_N_bezout"] = g["dx"] * (sum(xp) - (xp[0] + xp[-1]) / 2) / out["N_bezout"]
    middles = [l * (2 * i + 1) / 16 for i in range(8)]
    strips = [w.pressure(x) * l / 8 for x in middles]
    out["N_funicular"] = sum(strips)
    out["x_N_funicular"] = sum(x * s for x, s in zip(middles, strips)) / sum(strips)
    for name, x, shown in (("x_1", g["x_1"], 6), ("x_2", x_N, 5), ("x_3", g["x_3"], 3)):
        h = w.h(x)
        out["h_at_" + name], out["dp_dx_at_" + name], out["p_at_" + name] = h, w.gradient(x), w.pressure(x)
        for i in range(shown):
            z = mpf(5 * (i + 1)) / 100000
            out["u_at_%s_z_%s" % (name, DEPTHS[i])] = w.velocity(x, z) if z <= h else None
        out["u_at_%s_mid_film" % name] = w.velocity(x, h / 2)
        out["tau_0_at_" + name], out["tau_h_at_" + name] = w.shear(x, mpf(0)), w.shear(x, h)
    return out


def centre(n):
    N, moment = Wedge(mpf(1), mpf(1), mpf(1), n, mpf(1)).moments()
    return moment / N


def direct(g):
    l, b, z = g["l_pad"], g["b"], g["pads"]
    omega = g["speed"] * 2 * pi / 60
    V = omega * g["r_m"]
    N = g["P"] / (z * b)
    xi = g["x_N"] / l
    start = 1 + 10 * (xi - mpf(1) / 2) if xi < mpf("0.51") else exp(2 + mpf(1) / 2 / (1 - xi)) * mpf("0.3") + 1
    y = findroot(lambda y: centre(1 + exp(y)) - xi, (log(start - 1), log(start - 1) + mpf("0.01")), tol=mpf(10) ** -150)
    n = 1 + exp(y)
    one = Wedge(mpf(1), mpf(1), mpf(1), n, mpf(1))
    A, drag = one.moments()[0], one.drag(1)
    h2 = sqrt(A * g["mu_pad"] * V * l ** 2 / N)
    w = Wedge(l, V, g["mu_pad"], n * h2, h2)
    T = w.drag(1)
    f = T / N
    c, c_prime = (b + l) / b, sqrt((b + 4 * l) / b)
    side = h2 / sqrt(c)
    h_ref = g["h_ref"] / 1000000
    x_bar = (w.h1 - w.h_bar) / w.slope
    return {"omega": omega, "V": V, "N": N, "x_N_over_l": xi, "n": n, "A": A, "k": drag / sqrt(A), "h_2": h2,
            "h_1": n * h2, "tilt": w.slope, "f_m": f, "T": T, "p_mean": N / l, "p_max": w.pressure(x_bar),
            "x_bar": x_bar, "c": c, "c_prime": c_prime, "N_side_leakage": N / c, "h_2_side_leakage": side,
            "f_m_side_leakage": f * c_prime, "film_margin": h2 / h_ref, "film_margin_side_leakage": side / h_ref,
            "hydrodynamic": mpf(1 if h2 >= h_ref else 0), "hydrodynamic_side_leakage": mpf(1 if side >= h_ref else 0),
            "friction_torque": f * g["P"] * g["r_m"], "power_loss": f * g["P"] * V, "R_outer": g["r_m"] + b / 2,
            "R_inner": g["r_m"] - b / 2, "l": l, "pitch": 2 * pi * g["r_m"] / z, "gap": 2 * pi * g["r_m"] / z - l}


def main():
    print("# Reference values of the lubricated slider and of the bearing of tilting pads, 40 digits. Written by")
    print("# make_michell_bearing.py with mpmath; do not edit by hand. Integrals of Reynolds' equation over ln h.")
    print("# h_1, h_2 in mm, h_ref in um, speed in rpm; all else in SI units. `infinite`: there is none.")
    for name, why, changed in CASES:
        given = {**STATED, **changed}
        g = {k: number(v) for k, v in given.items()}
        print("\ncase %s\nwhy %s" % (name, why))
        for k, v in given.items():
            print("given %s %s" % (k, v))
        for prefix, values in (("inverse.", inverse(g)), ("direct.", direct(g))):
            for k, v in values.items():
                print(prefix + k, text(v))


if __name__ == "__main__":
    main()
