#!/usr/bin/env python3
"""Writes oscillator_pendulum.txt: reference values of the oscillator and the pendulum, independent of the C++ code.

  make_oscillator_pendulum.py > oscillator_pendulum.txt

The oscillator is a sum of complex exponentials of the roots (the double root by its own formula), its special
instants are zeros found by secants. The pendulum is integrated by Taylor series of its equation, step after step,
whose energy is held against the start; its instants are zeros of that. Greatest reactions are searched for on the
circle. Tables are run as they are printed, with the decimals of Python's numbers.
"""
from fractions import Fraction

from mpmath import cos, exp, fabs, findroot, mp, mpf, mpc, nstr, pi, sin, sqrt

mp.dps = 110
STATED = dict(zeta="3/2", m="5", omega_n="1/5", v_0="3/200", dt="1/2", m_p="5", I_G="1/20", r="1/20", g="981/100",
              theta_0="90", dt_p="1/100")
TENTHS = ["0p1", "0p2", "0p3", "0p4", "0p5", "0p6", "0p7", "0p8", "0p9", "1"]
TO_20 = [str(i) for i in range(1, 21)]
FEW = ["1", "2", "5", "10", "20"]


def number(rational):
    q = Fraction(rational)
    return mpf(q.numerator) / q.denominator


def instant(name):
    return Fraction(name.replace("p", "."))


def oscillator(given):
    zeta, m, w, v0 = [number(given[n]) for n in ("zeta", "m", "omega_n", "v_0")]
    ratio, found = Fraction(given["zeta"]), {}
    alpha, discriminant = zeta * w, number(ratio * ratio - 1)
    found["alpha"] = alpha
    found["c"], found["k"], found["c_critical"] = 2 * zeta * m * w, m * w * w, 2 * m * w
    if ratio == 1:
        law = [lambda t: v0 * t * exp(-w * t), lambda t: v0 * (1 - w * t) * exp(-w * t),
               lambda t: v0 * w * (w * t - 2) * exp(-w * t)]
    else:
        d = sqrt(mpc(discriminant)) * w
        one, two = -alpha + d, -alpha - d
        law = [lambda t, n=n: (v0 / (one - two) * (one ** n * exp(one * t) - two ** n * exp(two * t))).real
               for n in range(3)]
    if ratio >= 1:
        beta = w * sqrt(discriminant)
        found.update(beta=beta, two_beta=2 * beta, lambda_1=-alpha + beta, lambda_2=-alpha - beta)
    else:
        found.update({n: None for n in ("beta", "two_beta", "lambda_1", "lambda_2")})
    found["C_1"] = v0 / (2 * beta) if ratio > 1 else None
    found["C_2"] = -v0 / (2 * beta) if ratio > 1 else None

    # Steps of a hundredth of the shortest time until the sign changes.
    def first_zero(f, after):
        step = min(1 / w, 1 / (zeta * w) if zeta > 1 else 1 / w) / 50
        t = after + step
        while f(t) * f(after + step / 100) > 0:
            t += step
        return findroot(f, (t - step, t), solver="anderson", tol=mpf(10) ** -200, maxsteps=300)

    t_max = first_zero(law[1], mpf(0))
    t_inflection = first_zero(law[2], t_max)
    found.update(t_x_max=t_max, x_max=law[0](t_max), t_inflection=t_inflection, x_inflection=law[0](t_inflection),
                 x_dot_min=law[1](t_inflection), E_0=m * v0 ** 2 / 2, E_at_x_max=m * w * w * law[0](t_max) ** 2 / 2)
    for name, order, at in (("x", 0, ["0p5"] + TO_20 + ["25", "30", "35", "40"]), ("x_dot", 1, FEW),
                            ("x_ddot", 2, ["0"] + FEW)):
        for each in at:
            found[f"{name}_at_{each}"] = law[order](number(instant(each)))
    # Exact table.
    z, wf, dt = Fraction(given["zeta"]), Fraction(given["omega_n"]), Fraction(given["dt"])
    x, v, rows = Fraction(0), Fraction(given["v_0"]), []
    for _ in range(int(20 / dt) + 1):
        a = -2 * z * wf * v - wf * wf * x
        rows.append((x, v, a))
        x, v = x + v * dt, v + a * dt
    for name, column, at in (("x_euler", 0, ["0p5"] + TO_20), ("x_dot_euler", 1, ["0p5"] + FEW),
                             ("x_ddot_euler", 2, ["0", "0p5"] + FEW)):
        for each in at:
            i = instant(each) / dt
            found[f"{name}_at_{each}"] = number(rows[int(i)][column]) if i.denominator == 1 else None
    for each in ["0p5"] + FEW:
        there = found[f"x_euler_at_{each}"]
        true = found[f"x_at_{each}"]
        found[f"err_euler_at_{each}"] = None if there is None else (there - true) / true
    return {f"oscillator.{name}": value for name, value in found.items()}


# theta, theta' after the time h, by the series of theta, sin theta and cos theta together.
def stepped(theta, rate, square, h):
    terms = 90
    a, s, c = [theta, rate], [sin(theta)], [cos(theta)]
    for n in range(terms):
        if n > 0:
            s.append(sum(j * a[j] * c[n - j] for j in range(1, n + 1)) / n)
            c.append(-sum(j * a[j] * s[n - j] for j in range(1, n + 1)) / n)
        a.append(-square * s[n] / ((n + 1) * (n + 2)))
    position = velocity = mpf(0)
    for n in reversed(range(len(a))):
        position = position * h + a[n]
    for n in reversed(range(1, len(a))):
        velocity = velocity * h + n * a[n]
    return position, velocity


class Swing:
    def __init__(self, theta_0, square):
        self.square, self.h = square, mpf(1) / 16 / sqrt(square)
        self.states = [(theta_0, mpf(0))]

    def at(self, t):
        i = int(t / self.h)
        while len(self.states) <= i:
            self.states.append(stepped(*self.states[-1], self.square, self.h))
        return stepped(*self.states[i], self.square, t - i * self.h)

    def first_zero(self, f, after=0):
        i = int(after / self.h) + 1
        begin = after + (self.h / 100 if after > 0 else 0)
        sign = f(self.at(begin))
        while f(self.at(i * self.h)) * sign > 0:
            i += 1
        t = findroot(lambda t: f(self.at(t)), (max((i - 1) * self.h, begin), i * self.h), solver="anderson",
                     tol=mpf(10) ** -190, maxsteps=200)
        return t


def pendulum(given):
    m, I_G, r, g = [number(given[n]) for n in ("m_p", "I_G", "r", "g")]
    degrees = Fraction(given["theta_0"])
    theta_0 = number(degrees) * pi / 180
    I = I_G + m * r * r
    square = m * g * r / I
    Omega, k = sqrt(square), sin(fabs(theta_0) / 2)
    found = dict(I_A0=I, Omega_squared=square, Omega=Omega, equivalent_length=I / (m * r), weight=m * g, k=k,
                 period_small=2 * pi / Omega)
    swing = Swing(theta_0, square)
    bottom = swing.first_zero(lambda state: state[0])
    found.update(K=bottom * Omega, period=4 * bottom, period_ratio=4 * bottom / found["period_small"],
                 t_first_bottom=bottom, theta_dot_max=fabs(swing.at(bottom)[1]))
    exact_cosine = mpf(0) if degrees in (90, -90) else cos(theta_0)

    def reaction(theta, rate):
        s, c = sin(theta), cos(theta)
        a = -square * s
        return m * r * (a * c - rate ** 2 * s), m * g + m * r * (a * s + rate ** 2 * c)

    # dR_x/dθ, with the derivatives of the motion.
    def growth_of_x(state):
        return -3 * cos(2 * state[0]) + 2 * exact_cosine * cos(state[0])

    if fabs(degrees) <= 30:
        found["t_R_12_x_max"], greatest = mpf(0), reaction(theta_0, mpf(0))[0]
    else:
        # From high up the reaction has a lesser extreme before the greatest.
        t = swing.first_zero(growth_of_x)
        if cos(swing.at(t)[0]) < 0:
            t = swing.first_zero(growth_of_x, t)
        found["t_R_12_x_max"], greatest = t, reaction(*swing.at(t))[0]
    found["R_12_x_max"] = fabs(greatest)
    found["R_12_y_at_bottom"] = found["R_12_y_max"] = reaction(*swing.at(bottom))[1]
    if fabs(degrees) <= 90:
        found["R_12_y_min"] = m * g + m * r * -square * sin(theta_0) ** 2
    else:
        at = swing.first_zero(lambda state: cos(state[0]) - exact_cosine / 3)
        found["R_12_y_min"] = reaction(*swing.at(at))[1]
    for each in ["0"] + TENTHS:
        theta, rate = swing.at(number(instant(each))) if each != "0" else (theta_0, mpf(0))
        x, y = reaction(theta, rate)
        if each == "0":
            x = -m * r * square * sin(theta_0) * exact_cosine
        found.update({f"theta_at_{each}": theta, f"theta_dot_at_{each}": rate,
                      f"theta_ddot_at_{each}": -square * sin(theta), f"R_12_x_at_{each}": x, f"R_12_y_at_{each}": y})
        assert fabs(rate ** 2 / 2 - square * (cos(theta) - cos(theta_0))) < mpf(10) ** -85 * square
    found["theta_at_0p01"] = swing.at(number("1/100"))[0]
    for each in ("0p5", "1"):
        found[f"theta_small_at_{each}"] = theta_0 * cos(Omega * number(instant(each)))
    # The table as it is printed.
    step = Fraction(given["dt_p"])
    dt, table = number(step), [theta_0, theta_0]
    for i in range(int(1 / step) + 2):
        table.append(-(m * r * sin(table[i]) * g * dt ** 2 - 2 * I_G * table[i + 1] + I_G * table[i]
                       - 2 * r * r * m * table[i + 1] + r * r * m * table[i]) / (I_G + r * r * m))
    for each in TENTHS:
        i = instant(each) / step
        names = ["theta_numeric"] + (["theta_dot_numeric", "theta_ddot_numeric", "R_12_x_numeric", "R_12_y_numeric"]
                                     if each in ("0p5", "1") else [])
        if i.denominator != 1:
            found.update({f"{name}_at_{each}": None for name in names})
            if each == "1":
                found["energy_ratio_numeric_at_1"] = None
            continue
        i = int(i)
        theta, rate = table[i], (table[i + 1] - table[i]) / dt
        a = (table[i + 2] + table[i] - 2 * table[i + 1]) / dt ** 2
        s, c = sin(theta), cos(theta)
        values = [theta, rate, a, m * (-rate ** 2 * r * s + a * r * c), m * g + m * (rate ** 2 * r * c + a * r * s)]
        for name, value in zip(names, values):
            found[f"{name}_at_{each}"] = value
        if each == "1":
            found["energy_ratio_numeric_at_1"] = (I * rate ** 2 / 2 + m * g * r * (1 - c)) / (
                m * g * r * (1 - cos(theta_0)))
    # Once more with the velocities kept, which loses no digits, until it turns the second time.
    theta, gained, turns, found["period_numeric"] = theta_0, mpf(0), 0, None
    for i in range(1, 2000):
        before, gained = gained, gained - m * r * g * dt ** 2 * sin(theta) / I
        theta += before
        turns += before * gained < 0
        if fabs(theta) > pi or turns == 2:
            found["period_numeric"] = None if fabs(theta) > pi else i * dt
            break
    return {f"pendulum.{name}": value for name, value in found.items()}


CASES = [
    ("stated", "the exercise as it is stated", {}),
    ("underdamped", "swings; from beyond the horizontal", dict(zeta="3/10", theta_0="150", omega_n="2")),
    ("undamped", "no damping at all; small swings to the other side", dict(zeta="0", theta_0="-20")),
    ("critical", "critical damping, x' = 0 at an instant of the table; the horizontal reaction is greatest at the start",
     dict(zeta="1", theta_0="30")),
    ("critical_plus_1e-15", "nearly critical, from above; just beyond 30 deg",
     dict(zeta="1000000000000001/1000000000000000", theta_0="30000000001/1000000000")),
    ("critical_minus_1e-15", "nearly critical, from below; nearly upright",
     dict(zeta="999999999999999/1000000000000000", theta_0="17999/100")),
    ("critical_plus_1e-30", "nearly critical, to 30 digits; just less than a right angle",
     dict(zeta="1000000000000000000000000000001/1000000000000000000000000000000",
          theta_0="89999999999999999999999999999999/1000000000000000000000000000000")),
    ("strong", "strong damping, pushed back; a simple pendulum", dict(zeta="40", v_0="-1/3", I_G="0", r="1/2", theta_0="-100")),
    ("odd", "no round number anywhere", dict(zeta="17/13", m="37/11", omega_n="3/7", v_0="-5/9", m_p="29/7", I_G="3/31",
                                             r="2/17", g="1003/103", theta_0="777/7", dt="1/4", dt_p="1/250")),
    ("steps_that_miss", "steps that divide few of the instants", dict(dt="2/5", dt_p="3/100")),
]


def main():
    print("""# Reference values of the oscillator and the pendulum, 40 digits. Written by make_oscillator_pendulum.py with mpmath,
# 110 working digits; do not edit by hand. Complex exponentials, Taylor series of the pendulum's equation, zeros by
# bracketing; tables as printed. Nothing here is taken from the C++ code.
#
# Givens in SI units, theta_0 in degrees; "infinite": there is no such value.""")
    for name, why, changed in CASES:
        given = {**STATED, **changed}
        print(f"\ncase {name}\nwhy {why}")
        for symbol, value in given.items():
            print(f"given {symbol} {value}")
        for quantity, value in {**oscillator(given), **pendulum(given)}.items():
            text = "infinite" if value is None else "0" if fabs(value) < mpf(10) ** -70 else nstr(value, 40, min_fixed=-30, max_fixed=30)
            print(quantity, text)


main()
