#!/usr/bin/env python3
"""Writes cam.txt: reference values of the eccentric cam with its roller follower, independent of the C++ code.

  make_cam.py > cam.txt

B is where a circle about A meets the follower's axis; all velocities and accelerations are derivatives by time, taken
numerically with many digits: of B in fixed axes, of B in axes that turn with the cam (relative motion), and Coriolis'
is what the theorem leaves. Forces are the solution of the six equations of the two bodies; the torque by virtual work
is the derivative of the potential and kinetic energy by the angle. The least acceleration of the turn is sought on a
fine grid and refined as a zero of the third derivative of the lift.
"""
from fractions import Fraction

from mpmath import (acos, asin, atan2, cos, degrees, diff, exp, fabs, findroot, floor, lu_solve, matrix, mp, mpc, mpf,
                    nstr, pi, sin, sqrt)

mp.dps = 70
STATED = dict(r="1/10", r_r="1/20", A0A="3/100", phi="21", e="243/5000", m_2="11/5", m_3="19/10", P="50", g="981/100",
              n="50", n_lift="350")


def number(text):
    q = Fraction(text)
    return mpf(q.numerator) / q.denominator


class Cam:
    def __init__(self, given):
        g = {name: number(value) for name, value in given.items()}
        self.r, self.rho, self.k, self.e = g["r"], g["r_r"], g["A0A"], g["e"]
        self.l = self.r + self.rho
        self.m_2, self.m_3, self.P, self.g = g["m_2"], g["m_3"], g["P"], g["g"]
        self.phi, self.omega, self.fast = g["phi"] * pi / 180, g["n"] * pi / 30, g["n_lift"] * pi / 30
        self.given = given

    def A(self, theta):
        return self.k * exp(mpc(0, 1) * theta)

    # The upper of the two places on the axis at the distance l from A.
    def B(self, theta):
        A = self.A(theta)
        return mpc(self.e, A.imag + self.l * cos(asin((self.e - A.real) / self.l)))

    def y(self, theta):
        return self.B(theta).imag

    def motion(self, theta, w):
        at = lambda f, n: diff(lambda t: f(theta + w * t), 0, n) if w else mpc(0)
        v3, a3 = at(self.B, 1), at(self.B, 2)
        B = self.B(theta)
        # B as seen from the cam, turned back into the fixed axes.
        seen = lambda t: self.B(theta + w * t) * exp(-mpc(0, 1) * w * t)
        v32, a32 = (diff(seen, 0, 1), diff(seen, 0, 2)) if w else (mpc(0), mpc(0))
        v2, a2 = mpc(0, 1) * w * B, -w * w * B
        n = (self.A(theta) - B) / self.l
        along = (a32 * n.conjugate()).real
        return dict(v_B3=v3, v_B2=v2, v_B32=v32, v_A=at(self.A, 1), a_B3=a3, a_B2=a2, a_B32_n=along * n,
                    a_B32_t=a32 - along * n, a_coriolis=a3 - a2 - a32, a_G2=at(self.A, 2))

    def pressure(self, theta):
        AB = self.B(theta) - self.A(theta)
        return degrees(atan2(AB.real, AB.imag))

    def drawn(self, v):
        th, w = self.phi, self.omega
        A, B, m = self.A(th), self.B(th), self.motion(self.phi, self.omega)
        v["omega_2"], v["A_x"], v["A_y"], v["B_y"], v["A0B"] = w, A.real, A.imag, B.imag, fabs(B)
        v["pressure_angle_deg"] = self.pressure(th)
        C = A + self.r * (B - A) / self.l
        v["contact_x"], v["contact_y"] = C.real, C.imag
        v["P23_x"] = diff(self.y, th, 1)
        for name, z in m.items():
            v[name] = fabs(z)
        for name in ("v_B2", "v_B32", "a_B2", "a_B32_t", "a_coriolis"):
            v[name + "_x"], v[name + "_y"] = m[name].real, m[name].imag
        v["v_A_y"], v["a_B3_y"] = m["v_A"].imag, m["a_B3"].imag
        W2, W3 = self.m_2 * self.g, self.m_3 * self.g
        F2, F3 = -self.m_2 * m["a_G2"], -self.m_3 * m["a_B3"]
        v["P_2"], v["P_3"], v["F_2_in"], v["F_3_in"] = W2, W3, fabs(F2), fabs(F3)
        v["F_2_in_x"], v["F_2_in_y"], v["F_3_in_y"] = F2.real, F2.imag, F3.imag
        d = B - A
        v["d_2"], v["d_32"] = fabs(A.real), fabs((A.conjugate() * d).imag) / self.l
        # Unknown: R_13x, size of R_23 along AB, R_12x, R_12y, M.
        t = d / self.l
        M = matrix([[1, t.real, 0, 0, 0], [0, t.imag, 0, 0, 0], [0, -t.real, 1, 0, 0], [0, -t.imag, 0, 1, 0],
                    [0, -(A.conjugate() * t).imag, 0, 0, 1]])
        x = lu_solve(M, matrix([0, self.P + W3 - F3.imag, -F2.real, W2 - F2.imag, W2 * A.real]))
        presses = self.P + W3 - F3.imag
        lost = presses < -mpf(10) ** -60
        put = lambda name, value: v.__setitem__(name, None if lost else value)
        R13, R23, R12 = x[0], x[1] * t, mpc(x[2], x[3])
        put("R_13", fabs(R13)), put("R_13_x", R13)
        put("R_23", fabs(R23)), put("R_23_x", R23.real), put("R_23_y", R23.imag)
        put("R_12", fabs(R12)), put("R_12_x", R12.real), put("R_12_y", R12.imag)
        put("M_m", x[4])
        # The energy's derivative by the angle; w is constant.
        energy = lambda q: W2 * self.A(q).imag + (W3 + self.P) * self.y(q) + self.m_3 * (w * diff(self.y, q, 1)) ** 2 / 2
        put("M_m_virtual_work", diff(energy, th, 1))

    def lifted(self, v):
        p, w = "maximum_lift.", self.fast
        B = mpc(self.e, sqrt((self.k + self.l) ** 2 - self.e ** 2))
        th = acos(self.e / (self.k + self.l))
        m = self.motion(th, w)
        v[p + "omega_2"], v[p + "angle_of_A0A_deg"], v[p + "A0B"] = w, degrees(th), fabs(B)
        A = self.k * B / fabs(B)
        v[p + "A_x"], v[p + "A_y"], v[p + "B_y"] = A.real, A.imag, B.imag
        v[p + "pressure_angle_deg"] = degrees(asin(self.e / (self.k + self.l)))
        v[p + "v_B3"] = mpf(0)
        for name in ("v_B2", "v_B32", "a_B3", "a_B2", "a_B32_n", "a_B32_t", "a_coriolis"):
            v[p + name] = fabs(m[name])
        v[p + "a_B3_y"] = m["a_B3"].imag
        v[p + "P_3"], v[p + "F_3_in"] = self.m_3 * self.g, self.m_3 * fabs(m["a_B3"])
        v[p + "P_min"] = -self.m_3 * (self.g + m["a_B3"].imag)
        curving = -diff(self.y, th, 2)
        closing = self.P + self.m_3 * self.g
        v[p + "omega_2_contact_loss"] = sqrt(closing / (self.m_3 * curving)) if self.m_3 and closing >= 0 else None

    def cycle(self, v):
        p = "cycle."
        high, low = acos(self.e / (self.l + self.k)), pi + acos(self.e / (self.l - self.k))
        y_max, y_min = self.y(high), self.y(low)
        v[p + "y_B_max"], v[p + "y_B_min"], v[p + "lift"] = y_max, y_min, y_max - y_min
        v[p + "angle_at_max_lift_deg"], v[p + "angle_at_min_lift_deg"] = degrees(high), degrees(low)
        v[p + "rise_angle_deg"] = degrees(2 * pi + high - low)
        v[p + "pressure_angle_max_deg"], v[p + "pressure_angle_min_deg"] = self.pressure(pi), self.pressure(mpf(0))
        for n in range(0, 360, 30):
            v[p + f"lift_at_{n}"] = self.y(n * pi / 180) - y_min
        # On a grid with few digits, the closed derivatives of y by the angle of AB: y = k sin + l cos δ.
        def second(t):
            s = (self.e - self.k * cos(t)) / self.l
            c = sqrt(1 - s * s)
            s1, s2 = self.k * sin(t) / self.l, self.k * cos(t) / self.l
            return -self.k * sin(t) - self.l * (s1 * s1 + s * s2) / c - self.l * s * s * s1 * s1 / c ** 3

        mp.dps = 20
        grid = [2 * pi * i / 4000 for i in range(4000)]
        near = min(grid, key=second)
        mp.dps = 70
        at = findroot(lambda t: diff(second, t, 1), (near, near + mpf("0.0001")), tol=mpf(10) ** -110)
        assert fabs(at - near) < 0.01
        w = self.fast
        least = w * w * second(at)
        v[p + "angle_at_P_min_deg"] = degrees(at - 2 * pi * floor(at / (2 * pi))) if w else None
        v[p + "a_B3_y_min"] = least
        v[p + "P_min"] = -self.m_3 * (least + self.g)
        closing = self.P + self.m_3 * self.g
        v[p + "omega_2_first_loss"] = sqrt(closing / (self.m_3 * -second(at))) if self.m_3 and closing >= 0 else None

    def values(self):
        v = {}
        self.drawn(v), self.lifted(v), self.cycle(v)
        return v


# The closing force at which the cam just presses, to so many digits.
def at_loss(changed, digits, sense):
    cam = Cam({**STATED, **changed})
    exact = -cam.m_3 * (cam.g + cam.motion(cam.phi, cam.omega)["a_B3"].imag)
    whole = int(floor(exact * mpf(10) ** digits))
    return str(Fraction(whole + (1 if sense > 0 else 0), 10 ** digits))


FAST = dict(n="600")
CASES = [
    ("stated", "the exercise as it is stated", {}),
    ("zero_roller", "a pointed follower", dict(r_r="0", r="3/20")),
    ("in_line", "the axis through A0, A above it: a dead centre exactly", dict(e="0", phi="90")),
    ("below", "the axis through A0, A below it", dict(e="0", phi="-90", n="-31")),
    ("left", "the axis on the left, the cam clockwise", dict(e="-7/200", phi="200", n="-77", n_lift="-410")),
    ("at_rest", "the cam rests", dict(n="0", n_lift="0")),
    ("just_rests", "the cam rests, and P just carries the follower", dict(n="0", P="-18639/1000")),
    ("lifted", "the cam rests, and P carries the follower off by 1e-30 N",
     dict(n="0", P=str(Fraction(-18639, 1000) - Fraction(1, 10 ** 30)))),
    ("lost", "too fast for P in the drawn position", dict(n="2000", P="10")),
    ("lost_by_1e-9", "P is short by 1e-9 N", dict(P=at_loss(FAST, 9, -1), **FAST)),
    ("kept_by_1e-9", "P is enough by 1e-9 N", dict(P=at_loss(FAST, 9, 1), **FAST)),
    ("kept_by_1e-30", "P is enough by 1e-30 N", dict(P=at_loss(FAST, 30, 1), **FAST)),
    ("massless_follower", "m_3 = 0", dict(m_3="0")),
    ("massless_disc", "m_2 = 0", dict(m_2="0", g="0")),
    ("pulled", "P pulls more than the follower weighs", dict(P="-30")),
    ("steep", "the follower nearly stands across its axis", dict(A0A="1/10", e="49/1000", phi="150")),
    ("just_reaches", "the roller reaches its axis by 1e-9 m", dict(e="119999999/1000000000")),
    ("flat", "hardly any eccentricity", dict(A0A="1/1000000")),
    ("odd", "no round number anywhere", dict(r="97/1013", r_r="31/709", A0A="29/883", phi="1234/11", e="37/1741",
                                             m_2="17/7", m_3="23/13", P="311/7", g="9797/1000", n="577/11",
                                             n_lift="3571/17")),
]

print("""# Reference values of the eccentric cam with its roller follower, 40 digits. Written by make_cam.py with mpmath, 70
# working digits; do not edit by hand. Velocities and accelerations are numerical derivatives, relative ones in axes
# that turn with the cam. Nothing here is taken from the C++ code.""")
for name, why, changed in CASES:
    given = {**STATED, **changed}
    print(f"\ncase {name}\nwhy {why}")
    for symbol, value in given.items():
        print(f"given {symbol} {value}")
    values = Cam(given).values()
    for quantity, value in values.items():
        if value is None:
            print(quantity, "infinite")
            continue
        print(quantity, "0" if fabs(value) < mpf(10) ** -45 else nstr(value, 40, min_fixed=-40, max_fixed=40))
