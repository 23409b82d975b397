#!/usr/bin/env python3
"""Writes landing.txt: reference values of the landing wheel, independent of the C++ code.

  make_landing.py > landing.txt

The speed v of the aircraft is the variable, which falls: time, ways, angle and works are integrals over it, by
Gauss-Legendre quadrature, of the rates divided by the deceleration; the angular velocity is an integral within them. The
speed at which slip ends is the zero of R ω - v. Euler's scheme is run as it stands, with 60 digits.
"""
from fractions import Fraction

from mpmath import findroot, mp, mpc, mpf, nstr, quad

mp.dps = 45
STATED = dict(v_0="250", m_a="9000", m_r="60", R="2/5", J_r="49/10", c_x="2", c_y="2", f_r="1", f_a="6/5",
              f_v="1/1000", g="981/100", Delta_t="1/10", rim_0="0")
OF_A_CASE = ("N_0 F_0 a_0 omega_dot_0 t_s v_s omega_s N_s a_s omega_dot_s ground_path_s rolled_path_s slip_path_s "
             "wheel_angle_s friction_work_s wheel_energy_s a_after F_after F_after_over_N adheres t_s_tangents "
             "v_s_tangents").split()


def number(rational):
    q = Fraction(rational)
    return mpf(q.numerator) / q.denominator


class Landing:
    def __init__(self, given):
        self.__dict__.update({k: number(v) for k, v in given.items()})
        self.v_0 = self.v_0 / mpf("3.6")

    def normal(self, v):
        return (self.m_a + self.m_r) * self.g + self.c_y * v * v

    def deceleration(self, v):
        return (self.f_r * self.normal(v) + self.c_x * v * v) / (self.m_a + self.m_r)

    def spin(self, v):
        return self.R * self.normal(v) * (self.f_r - self.f_v) / self.J_r

    # Of a rate, from v_0 down to v.
    def gained(self, rate, v):
        return quad(lambda x: rate(x) / self.deceleration(x), [v, (v + self.v_0) / 2, self.v_0])

    def omega(self, v):
        return self.rim_0 / self.R + self.gained(self.spin, v)

    def values(self):
        M, v_0, R, J = self.m_a + self.m_r, self.v_0, self.R, self.J_r
        N_0 = self.normal(v_0)
        if N_0 <= 0:
            return {name: None for name in OF_A_CASE}
        found = dict(v_0=v_0, omega_rolling_0=v_0 / R, u=self.f_v * R, F_x_0=self.c_x * v_0 ** 2,
                     F_y_0=self.c_y * v_0 ** 2, N_0=N_0, F_0=self.f_r * N_0, a_0=-self.deceleration(v_0),
                     omega_dot_0=self.spin(v_0))
        behind = lambda v: R * self.omega(v) - v
        low, high = mpf(0), v_0
        for _ in range(12):
            middle = (low + high) / 2
            low, high = (middle, high) if behind(middle) > 0 else (low, middle)
        v_s = findroot(behind, (low, high), solver="anderson", tol=mpf(10) ** -80, verify=False)
        omega_s, N_s = self.omega(v_s), self.normal(v_s)
        t_s = self.gained(lambda v: mpf(1), v_s)
        turned = self.gained(self.omega, v_s)
        rest = lambda v: (v - R * self.omega(v)) * self.f_r * self.normal(v)
        found.update(t_s=t_s, v_s=v_s, omega_s=omega_s, N_s=N_s, a_s=-self.deceleration(v_s),
                     omega_dot_s=self.spin(v_s), ground_path_s=self.gained(lambda v: v, v_s), wheel_angle_s=turned,
                     rolled_path_s=R * turned, wheel_energy_s=J * omega_s ** 2 / 2,
                     friction_work_s=self.gained(rest, v_s),
                     drag_work_s=self.gained(lambda v: self.c_x * v ** 3, v_s),
                     rolling_work_s=self.gained(lambda v: self.normal(v) * self.f_v * R * self.omega(v), v_s))
        found["slip_path_s"] = found["ground_path_s"] - found["rolled_path_s"]
        found["polygon_off_at_most"] = self.chords_off(v_s, t_s)
        found.update(v_10ms=None, omega_10ms=None)
        if t_s > mpf("0.01"):
            late = lambda v: self.gained(lambda x: mpf(1), v) - mpf("0.01")
            v = findroot(late, (v_s, v_0), solver="anderson", tol=mpf(10) ** -80, verify=False)
            found.update(v_10ms=v, omega_10ms=self.omega(v))
        # Rolling: the couple on the wheel is -F R - N u, and its share of the inertia force J a/R².
        a = -(self.c_x * v_s ** 2 + self.f_v * N_s) / (M + J / R ** 2)
        F = -(M * a + self.c_x * v_s ** 2)
        found.update(a_after=a, F_after=F, F_after_over_N=F / N_s, adheres=mpf(1 if abs(F) <= self.f_a * N_s else 0))
        # What turns the wheel's momentum, but for its weight and the ground.
        found["wheel_weight"] = self.m_r * self.g
        for when, (N, force, rate) in dict(zero=(N_0, self.f_r * N_0, -self.deceleration(v_0)), after=(N_s, F, a)).items():
            hub, when = mpc(self.m_r * rate + force, self.m_r * self.g - N), when.replace("zero", "0")
            found.update({f"hub_force_{when}": abs(hub), f"hub_force_{when}_x": hub.real, f"hub_force_{when}_y": hub.imag,
                          f"wheel_inertia_{when}": -self.m_r * rate})
        crossing = (v_0 - self.rim_0) / (R * self.spin(v_0) + self.deceleration(v_0))
        found.update(t_s_tangents=crossing, v_s_tangents=v_0 - self.deceleration(v_0) * crossing)
        return found

    # Bound on what chords of the time are off in sixths of the time of slip: width squared over 8, times the greatest
    # slope of 1/deceleration, which is sought among many speeds and then where its own slope is zero.
    def chords_off(self, v_s, t_s):
        speeds = [self.v_0]
        for i in range(1, 6):
            late = lambda v: self.gained(lambda x: mpf(1), v) - t_s * i / 6
            speeds.append(findroot(late, (v_s, speeds[-1]), solver="anderson", tol=mpf(10) ** -80, verify=False))
        speeds.append(v_s)
        c = (self.f_r * self.c_y + self.c_x) / (self.m_a + self.m_r)
        slope = lambda v: abs(2 * c * v / self.deceleration(v) ** 2)
        most = mpf(0)
        for fast, slow in zip(speeds, speeds[1:]):
            tried = [slow + (fast - slow) * k / 64 for k in range(65)]
            k = max(range(65), key=lambda j: slope(tried[j]))
            steepest = slope(tried[k])
            if 0 < k < 64:  # 1/v + d/dv of the rest
                turn = findroot(lambda v: self.deceleration(v) - 4 * c * v * v, (tried[k - 1], tried[k + 1]),
                                solver="anderson", tol=mpf(10) ** -80, verify=False)
                steepest = slope(turn)
            most = max(most, (fast - slow) ** 2 / 8 * steepest)
        return most

    # Speeds after each step, as far as the first after which the rim is not slower.
    def euler(self, h):
        v, omega, all_ = self.v_0, self.rim_0 / self.R, [(self.v_0, self.rim_0 / self.R)]
        while self.R * omega < v:
            v, omega = v - h * self.deceleration(v), omega + h * self.spin(v)
            all_.append((v, omega))
        return all_

    def euler_values(self, h, after):
        run = self.euler(h)
        found = {}
        for k in after:
            v, omega = run[k] if k < len(run) else (None, None)
            found[f"v_{k}"], found[f"omega_{k}"] = v, omega
        if after == [1]:
            return {**found, "rim_speed_over_speed_1": self.R * run[1][1] / run[1][0]}
        slip = [v - self.R * omega for v, omega in run[-2:]]
        n = len(run) - 1
        return {**found, "steps": mpf(n), "t_s": h * (n - 1 + slip[0] / (slip[0] - slip[1]))}


def all_values(given):
    landing = Landing(given)
    found = landing.values()
    h = landing.Delta_t
    for name, step, after in (("euler_100ms", h, [1]), ("euler_1ms", h / 100, [10, 20]),
                              ("euler_100us", h / 1000, [100, 200])):
        found.update({f"{name}.{k}": v for k, v in landing.euler_values(step, after).items()})
    double = {"m_r": str(2 * Fraction(given["m_r"])), "J_r": str(2 * Fraction(given["J_r"]))}
    lift = {"c_y": str(-Fraction(given["c_y"]))}
    for name, changed in (("doubled_wheel", double), ("flap_lift", lift)):
        of_case = Landing({**given, **changed}).values()
        found.update({f"{name}.{k}": of_case[k] for k in OF_A_CASE})
    return found


CASES = [
    ("stated", "the exercise as it is stated", {}),
    ("no_drag", "no drag: its work is nought", dict(c_x="0")),
    ("no_flaps", "uniformly braked in all cases", dict(c_x="0", c_y="0")),
    ("lifted", "flaps that lift: uniformly braked as it stands", dict(c_y="-2")),
    ("nearly_uniform", "B is 1e-9 of what it is stated", dict(c_y="-199999999/100000000")),
    ("heavy_wheel", "slip lasts seconds", dict(J_r="400", Delta_t="7/10")),
    ("turning", "the wheel turns at touch-down", dict(rim_0="40", v_0="180")),
    ("slow", "slip ends within 10 ms", dict(v_0="77", Delta_t="1/25")),
    ("airborne_with_lift", "flaps that would lift the aircraft off", dict(c_y="19")),
    ("odd", "no round number anywhere", dict(v_0="1999/7", m_a="70001/9", m_r="97/3", R="31/77", J_r="53/13",
                                            c_x="17/7", c_y="-29/11", f_r="7/9", f_a="1/100000", f_v="1/91",
                                            g="3217/328", Delta_t="1/13", rim_0="5/3")),
]

print("""# Reference values of the landing wheel, 30 digits. Written by make_landing.py with mpmath, 45 working digits; do not edit
# by hand. Integrals over the speed; nothing here is taken from the C++ code. "infinite": there is no such value.
#
# Givens in km/h, kg, m, N s²/m², s; values in SI units.""")
for name, why, changed in CASES:
    given = {**STATED, **changed}
    print(f"\ncase {name}\nwhy {why}")
    for symbol, value in given.items():
        print(f"given {symbol} {value}")
    for quantity, value in all_values(given).items():
        print(quantity, "infinite" if value is None else nstr(value, 30, min_fixed=-30, max_fixed=30))
