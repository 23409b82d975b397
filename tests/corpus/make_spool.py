#!/usr/bin/env python3
"""Writes spool.txt: reference values of the spool drawn by a counterweight, independent of the C++ code.

  make_spool.py > spool.txt

No regime is decided beforehand: for every counterweight each of rest, rolling and slipping (turning forwards, turning
backwards, carried along without turning) is solved in rationals as a system of equations of the two bodies, and the one
whose inequalities hold is taken.
"""
from fractions import Fraction as Q

from mpmath import asin, atan, mp, mpf, nstr, sqrt

mp.dps = 60
STATED = dict(m_a="20", m_b="30", m_b_heavy="60", m_b_light="3/10", R="1/2", r="1/4", f_a="1", f_r="4/5", f_v="1/100",
              g="981/100")


def solve(rows):
    """Gauss-Jordan on rows of coefficients, the right-hand side last."""
    rows = [list(map(Q, row)) for row in rows]
    n = len(rows)
    for i in range(n):
        pivot = next(k for k in range(i, n) if rows[k][i] != 0)
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [x / rows[i][i] for x in rows[i]]
        for k in range(n):
            if k != i:
                rows[k] = [x - rows[k][i] * y for x, y in zip(rows[k], rows[i])]
    return [row[-1] for row in rows]


class Spool:
    def __init__(self, given):
        for name, value in given.items():
            setattr(self, name, Q(value))
        self.J = self.m_a * self.R ** 2 / 4
        self.N = self.m_a * self.g
        self.most = self.f_v * self.R

    # Unknown: x'', phi'', T, F, offset*N. The counterweight goes down with x'' - r phi''.
    def balances(self, m):
        return [[self.m_a, 0, -1, 1, 0, 0],
                [0, self.J, self.r, -self.R, 1, 0],
                [m, -m * self.r, 1, 0, 0, m * self.g]]

    def motion(self, m, extra):
        x, phi, T, F, couple = solve(self.balances(m) + extra)
        return dict(a_G=x, alpha=phi, T=T, F=F, offset=couple / self.N, a=x - self.r * phi)

    def rest(self, m):
        return self.motion(m, [[1, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0]])

    def rolling(self, m):
        return self.motion(m, [[1, -self.R, 0, 0, 0, 0], [0, 0, 0, 0, 1, self.most * self.N]])

    def held(self, m):
        at = self.rest(m)
        return at if at["offset"] <= self.most else self.rolling(m)

    def real(self, m):
        found = []
        at = self.rest(m)
        if at["offset"] <= self.most and at["F"] <= self.f_a * self.N:
            found.append(("rest", at))
        at = self.rolling(m)
        if at["a_G"] > 0 and at["F"] <= self.f_a * self.N:
            found.append(("rolling", at))
        if not found:
            F = self.f_r * self.N
            for sense in (1, -1):
                at = self.motion(m, [[0, 0, 0, 1, 0, F], [0, 0, 0, 0, 1, sense * self.most * self.N]])
                if sense * at["alpha"] > 0:
                    found.append(("slipping", at))
            at = self.motion(m, [[0, 0, 0, 1, 0, F], [0, 1, 0, 0, 0, 0]])
            if abs(at["offset"]) <= self.most and not found:
                found.append(("slipping", at))
            for _, at in found:
                assert at["a_G"] - self.R * at["alpha"] > 0
        assert len(found) == 1, found
        return found[0]

    # Where F = f_a N in rolling: F/N of the motion is (p + q m)/(s + t m), known at three masses.
    def slip(self):
        start = self.most * self.N / ((self.R - self.r) * self.g)
        f = lambda m: self.rolling(m)["F"] / self.N
        m1, m2, m3 = start + self.m_a, start + 2 * self.m_a, start + 4 * self.m_a
        p, q, t = solve([[1, m, -m * f(m), f(m)] for m in (m1, m2, m3)])
        if (self.R - self.r) * self.f_a < self.most:
            return None
        if q - self.f_a * t <= 0:
            return None
        return (self.f_a - p) / (q - self.f_a * t)

    def values(self):
        v = {}
        number = lambda q: mpf(q.numerator) / q.denominator
        v["J"], v["u"], v["N"], v["weight_b"] = self.J, self.most, self.N, self.m_b * self.g
        v["F_max"] = self.f_a * self.N
        v["friction_cone_half_angle"] = atan(number(self.f_a))
        v["rope_to_centre_velocity_ratio"] = 1 - self.r / self.R
        v["inertia_force_height"] = self.R + self.J / (self.m_a * self.R)
        slip, start = self.slip(), self.most * self.m_a / (self.R - self.r)
        v["m_b_slip"], v["mass_ratio_slip"] = slip, slip and slip / self.m_a if slip is None or slip else slip
        v["m_b_start"], v["mass_ratio_start"] = start, start / self.m_a

        def write(prefix, at):
            for name in ("a", "a_G", "alpha", "T", "F"):
                v[prefix + name] = at[name]
            S = sqrt(number(self.N ** 2 + at["F"] ** 2))
            v[prefix + "ground_reaction"] = S
            v[prefix + "ground_reaction_inclination"] = asin(number(at["F"]) / S)
            v[prefix + "inertia_force"] = self.m_a * at["a_G"]
            v[prefix + "inertia_couple"] = abs(self.J * at["alpha"])

        def judged(prefix, m, at):
            write(prefix, at)
            needed = self.held(m)["F"]
            if not prefix:
                v["F_required"] = needed
            v[prefix + "F_over_N"] = needed / self.N
            v[prefix + "slip_margin"] = self.f_a * self.N - needed
            v[prefix + "resultant_height"] = self.N * at["offset"] / at["F"] if at["F"] else None
            v[prefix + "slips"] = Q(self.real(m)[0] == "slipping")

        judged("", self.m_b, self.real(self.m_b)[1])
        v["starts"] = Q(self.real(self.m_b)[0] != "rest")
        judged("heavy_if_rolling.", self.m_b_heavy, self.held(self.m_b_heavy))
        regime, at = self.real(self.m_b_heavy)
        write("heavy.", at)
        v["heavy.slip_acceleration"] = at["a_G"] - self.R * at["alpha"]
        v["heavy.slips"] = Q(regime == "slipping")
        regime, at = self.real(self.m_b_light)
        v.update({"light.T": at["T"], "light.F": at["F"], "light.u_required": at["offset"], "light.a": at["a"],
                  "light.starts": Q(regime != "rest")})
        return v


def text(value):
    if value is None:
        return "infinite"
    if isinstance(value, Q):
        value = mpf(value.numerator) / value.denominator
    return "0" if value == 0 else nstr(value, 40, min_fixed=-40, max_fixed=40)


tiny, small = Q(1, 10 ** 30), Q(1, 10 ** 9)
slip, start = Spool(STATED).slip(), Q(2, 5)
CASES = [
    ("stated", "the exercise as it is stated", {}),
    ("at_slip", "exactly as heavy as rolling allows", dict(m_b=str(slip))),
    ("beyond_slip_by_1e-9", "heavier by 1e-9 kg: it slips", dict(m_b=str(slip + small))),
    ("beyond_slip_by_1e-30", "heavier by 1e-30 kg: it slips", dict(m_b=str(slip + tiny), m_b_heavy=str(slip - tiny))),
    ("at_start", "exactly as heavy as rest allows", dict(m_b=str(start))),
    ("beyond_start_by_1e-9", "heavier by 1e-9 kg: it rolls", dict(m_b=str(start + small), m_b_light=str(start - small))),
    ("beyond_start_by_1e-30", "heavier by 1e-30 kg", dict(m_b=str(start + tiny), m_b_light=str(start - tiny))),
    ("heavy_main", "the counterweight itself slips", dict(m_b="60", m_b_light="5")),
    ("nothing_hangs", "no counterweight", dict(m_b="0", m_b_light="0")),
    ("no_rolling_friction", "f_v = 0", dict(f_v="0")),
    ("ice", "no friction at all", dict(f_a="0", f_r="0", f_v="0")),
    ("smooth_once_slipping", "f_r = 0", dict(f_r="0", m_b="100")),
    ("slips_first", "so much rolling friction that it slips before it rolls", dict(f_v="3", m_b="15", m_b_light="25")),
    ("always_rolls", "enough friction for any counterweight", dict(f_a="4", m_b="1000000")),
    ("carried", "so heavy that it is carried along without turning", dict(m_b_heavy="200")),
    ("turns_back", "so heavy that it turns backwards", dict(m_b_heavy="2000", m_b="400")),
    ("big_core", "a core nearly as big as the spool", dict(r="499999/1000000", m_b_heavy="4000")),
    ("odd", "no round number anywhere", dict(m_a="137/7", m_b="311/11", m_b_heavy="977/13", m_b_light="3/17", R="19/37",
                                             r="5/31", f_a="7/9", f_r="5/11", f_v="1/73", g="9797/1000")),
]

print("""# Reference values of the spool drawn by a counterweight, 40 digits. Written by make_spool.py with rationals and mpmath;
# do not edit by hand. Every regime is tried, and the one whose inequalities hold is taken. Nothing here is taken from
# the C++ code.""")
for name, why, changed in CASES:
    given = {**STATED, **changed}
    print(f"\ncase {name}\nwhy {why}")
    for symbol, value in given.items():
        print(f"given {symbol} {value}")
    for quantity, value in Spool(given).values().items():
        print(quantity, text(value))
