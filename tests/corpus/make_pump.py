#!/usr/bin/env python3
"""Writes pump.txt: reference values of the pump's flywheel, independent of the C++ code.

  make_pump.py > pump.txt

The turn is sampled, and extremes of the energy found among all samples and refined by the derivative's zero: nothing is
assumed of where they lie. Energies are integrals of the torque by quadrature, harmonics Fourier integrals; that the
constant inertia of Wittenbauer's diagram gives the greatest and the least speed is asserted.
"""
from fractions import Fraction

from mpmath import cos, findroot, fabs, mp, mpf, nstr, pi, quad, sin

mp.dps = 40
STATED = dict(Q="2000", p_m="5", p_a="1/2", D="210", c="280", W_t="37/2", n_m="2910", n_0="3000", J_m="69/4000",
              m="50", i="1/20", kgf="196133/20000")


def number(rational):
    q = Fraction(rational)
    return mpf(q.numerator) / q.denominator


class Pump:
    def __init__(self, given):
        self.__dict__.update({k: number(v) for k, v in given.items()})
        self.Q /= 60000
        self.p_m, self.p_a = [p * self.kgf * 10000 for p in (self.p_m, self.p_a)]
        self.D, self.c, self.W_t = self.D / 1000, self.c / 1000, self.W_t * 1000
        self.A = pi * self.D ** 2 / 4
        self.r = self.c / 2
        self.omega = 2 * pi * self.Q / (self.A * self.c)
        self.mean = self.torque_work() / (2 * pi)

    def torque(self, alpha):
        return (self.p_a if alpha < pi else -self.p_m) * self.A * self.r * sin(alpha)

    def torque_work(self):
        return quad(self.torque, [0, pi]) + quad(self.torque, [pi, 2 * pi])

    # W - slope m r² sin²
    def left(self, alpha, slope):
        return self.mean - self.torque(alpha) - slope * self.m * self.r ** 2 * sin(2 * alpha)

    def energy(self, alpha, slope):
        ends = [mpf(0), alpha] if alpha <= pi else [mpf(0), pi, alpha]
        return quad(lambda x: self.left(x, slope), ends)

    def extreme(self, slope, sign, only_delivery=False):
        # Where both half turns are alike, the second one counts.
        late = only_delivery or self.p_a == self.p_m
        samples = [2 * pi * k / 720 for k in range(360 if late else 0, 721)]
        C = lambda x: (self.p_a if x <= pi else self.p_m) * self.A * self.r
        K = slope * self.m * self.r ** 2

        def rough(x):
            turned = x if x <= pi else x - pi
            start = 0 if x <= pi else self.mean * pi - 2 * self.p_a * self.A * self.r
            return start + self.mean * turned - C(x) * (1 - cos(turned)) - K * sin(x) ** 2

        best = max(samples, key=lambda x: sign * rough(x))
        step = pi / 360
        zero = findroot(lambda x: self.left(x, slope), (best - step, best + step), solver="anderson",
                        tol=mpf(10) ** -70, verify=False)
        return zero, self.energy(zero, slope)

    # Bound on what chords of the energy are off: width squared over 8, times the greatest slope of the torque over the
    # strip, sought among many angles and then where its own slope is zero.
    def chords_off(self, first, second, slope):
        quarter = (second - first) / 4
        ends = [pi * i / 6 for i in range(7)]
        ends += [pi + x for x in (first, first + quarter, first + 2 * quarter, second - quarter, second, pi)]
        K = self.m * self.r ** 2 * slope
        most = mpf(0)
        for i, (low, high) in enumerate(zip(ends, ends[1:])):
            C, x_0 = (self.p_a * self.A * self.r, 0) if i < 6 else (self.p_m * self.A * self.r, pi)
            steep = lambda x: fabs(C * cos(x - x_0) + 2 * K * cos(2 * (x - x_0)))
            tried = [low + (high - low) * k / 64 for k in range(65)]
            k = max(range(65), key=lambda j: steep(tried[j]))
            steepest = steep(tried[k])
            if 0 < k < 64:
                turn = findroot(lambda x: C * sin(x - x_0) + 4 * K * sin(2 * (x - x_0)), (tried[k - 1], tried[k + 1]),
                                solver="anderson", tol=mpf(10) ** -70, verify=False)
                steepest = steep(turn)
            most = max(most, (high - low) ** 2 / 8 * steepest)
        return most

    def values(self):
        A, c, r, omega = self.A, self.c, self.r, self.omega
        F_a, F_m = self.p_a * A, self.p_m * A
        n = 60 * self.Q / (A * c)
        omega_m, omega_0 = 2 * pi * self.n_m / 60, 2 * pi * self.n_0 / 60
        tau = n / self.n_m
        k_m = self.W_t / (omega_m * (omega_0 - omega_m))
        harmonic = lambda k: (quad(lambda x: self.torque(x) * cos(k * x), [0, pi]) +
                              quad(lambda x: self.torque(x) * cos(k * x), [pi, 2 * pi])) / pi
        first = (quad(lambda x: self.torque(x) * sin(x), [0, pi]) +
                 quad(lambda x: self.torque(x) * sin(x), [pi, 2 * pi])) / pi
        found = dict(A_p=A, V=A * c, n_rpm=n, omega=omega, f=n / 60, r=r, F_a=F_a, F_m=F_m, L_suction=F_a * c,
                     L_delivery=F_m * c, L_r=(F_a + F_m) * c, M_r_mean=self.mean, W_r=self.mean * omega, tau=tau,
                     M_r_suction_coefficient=F_a * r, M_r_delivery_coefficient=-F_m * r,
                     M_r_harmonic_1=fabs(first) if self.p_a != self.p_m else mpf(0),
                     M_r_harmonic_2=fabs(harmonic(2)), M_r_harmonic_30=fabs(harmonic(30)),
                     omega_m=omega_m, omega_sync=omega_0, M_t=self.W_t / omega_m, k_m=k_m,
                     n_t=k_m / (self.J_m * omega_m), n_1=tau, n_30=30 * tau)
        found["motor_alone_suffices"] = mpf(1 if found["n_t"] < tau else 0)
        found.update(M_inertia_max=self.m * r ** 2 * omega ** 2 / 2, J_s_max=self.m * r ** 2)

        def flywheel(prefix, change):
            J = change / (self.i * omega ** 2)
            found.update({prefix + "J_crank": J, prefix + "J_motor_shaft": J * tau ** 2,
                          prefix + "J_flywheel": J * tau ** 2 - self.J_m,
                          prefix + "n_t_flywheel": k_m / (J * tau ** 2 * omega_m)})
            return J

        high, peak = self.extreme(0, 1, True)
        low, trough = self.extreme(0, -1, True)
        degrees = lambda x: x * 180 / pi
        found.update(alpha_1=high - pi, alpha_2=low - pi, alpha_1_deg=degrees(high - pi),
                     alpha_2_deg=degrees(low - pi),
                     Delta_T_suction_end=self.energy(pi, 0) if self.p_a != self.p_m else mpf(0), Delta_T_peak=peak,
                     Delta_T_trough=trough, Delta_T_max=peak - trough)
        found["polygon_off_at_most"] = self.chords_off(high - pi, low - pi, 0)
        J = flywheel("", peak - trough)
        found["stiffness_negligible_with_flywheel"] = mpf(1 if found["n_t_flywheel"] < tau else 0)
        found.update(omega_max=omega * (1 + self.i / 2), omega_min=omega * (1 - self.i / 2))
        found["J_s_max_over_J_crank"] = self.m * r ** 2 / J
        slope = omega ** 2 / 2
        name = "reciprocating_mass."
        alpha_1, alpha_2 = self.extreme(slope, 1, True)[0] - pi, self.extreme(slope, -1, True)[0] - pi
        change = self.extreme(slope, 1)[1] - self.extreme(slope, -1)[1]
        found.update({name + "alpha_1": alpha_1, name + "alpha_2": alpha_2, name + "alpha_1_deg": degrees(alpha_1),
                      name + "alpha_2_deg": degrees(alpha_2), name + "Delta_T_max": change})
        found[name + "polygon_off_at_most"] = self.chords_off(alpha_1, alpha_2, slope)
        flywheel(name, change)
        name = "wittenbauer."
        steep, slight = found["omega_max"] ** 2 / 2, found["omega_min"] ** 2 / 2
        (high, upper), (low, lower) = self.extreme(steep, 1), self.extreme(slight, -1)
        found.update({name + "slope_max": steep, name + "slope_min": slight, name + "alpha_1": high - pi,
                      name + "alpha_2": low - pi, name + "intercept_max": upper, name + "intercept_min": lower})
        # The tangents meet at (-J, -E_0): there ω² has its greatest and least value.
        J = flywheel(name, upper - lower)
        E_0 = J * steep - upper
        for x, half in ((high, steep), (low, slight)):
            at = (E_0 + self.energy(x, 0)) / (J + self.m * r ** 2 * sin(x) ** 2)
            assert fabs(at - half) < mpf(10) ** -25 * half, (at, half)
        D = mpf("2.010")
        found["text_diameter.V"] = pi * D ** 2 / 4 * c
        found["text_diameter.n_rpm"] = 60 * self.Q / found["text_diameter.V"]
        return found


CASES = [
    ("stated", "the exercise as it is stated", {}),
    ("no_suction", "no depression in suction", dict(p_a="0")),
    ("both_alike", "both half turns alike: the fundamental is nought", dict(p_a="5", m="0")),
    ("no_mass", "no reciprocating mass", dict(m="0")),
    ("heavy", "the torque reaches its mean in suction too", dict(m="300")),
    ("very_heavy", "the mass alone counts", dict(m="20000")),
    ("motor_alone", "a rotor so large that no flywheel is needed", dict(J_m="1")),
    ("irregular", "nearly standing still once a turn", dict(i="3/2")),
    ("odd", "no round number anywhere", dict(Q="12347/9", p_m="61/7", p_a="11/13", D="1789/11", c="3571/9",
                                            W_t="131/9", n_m="10007/7", n_0="1499", J_m="3/71", m="277/3", i="1/37",
                                            kgf="981/100")),
]

print("""# Reference values of the pump's flywheel, 28 digits. Written by make_pump.py with mpmath, 40 working digits; do not edit
# by hand. Extremes among samples of the whole turn, energies by quadrature; nothing here is taken from the C++ code.
#
# Givens in l/min, kgf/cm², mm, kW, rpm, kg m², kg, N; values in SI units.""")
for name, why, changed in CASES:
    given = {**STATED, **changed}
    print(f"\ncase {name}\nwhy {why}")
    for symbol, value in given.items():
        print(f"given {symbol} {value}")
    for quantity, value in Pump(given).values().items():
        print(quantity, nstr(value, 28, min_fixed=-30, max_fixed=30))
