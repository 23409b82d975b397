#!/usr/bin/env python3
"""Writes vibration.txt: reference values of the free oscillator and the pendulum, independent of the C++ code.

  make_vibration.py > vibration.txt

The oscillator is the sum of complex exponentials of its roots, worked with 160 digits so that nearly equal roots may
cancel (the double root by its own formula); its special instants from the logarithm of the roots' quotient. The
pendulum by mpmath's elliptic functions. Tables row by row as their recursion says.
"""
from fractions import Fraction

from mpmath import acos, asin, atan2, cos, ellipf, ellipfun, ellipk, exp, fabs, log, mp, mpf, mpc, nstr, pi, sin, sqrt

mp.dps = 160
INSTANTS = ["0", "1/7", "5/3", "20"]


def number(rational):
    q = Fraction(rational)
    return mpf(q.numerator) / q.denominator


def oscillator(given):
    zeta, w, v0 = [number(given[n]) for n in ("zeta", "omega", "v_0")]
    if Fraction(given["zeta"]) == 1:
        law = [lambda t: v0 * t * exp(-w * t), lambda t: v0 * (1 - w * t) * exp(-w * t),
               lambda t: v0 * w * (w * t - 2) * exp(-w * t)]
        extreme, inflection = 1 / w, 2 / w
    else:
        d = sqrt(mpc(zeta * zeta - 1)) * w
        one, two = -zeta * w + d, -zeta * w - d
        law = [lambda t, n=n: (v0 / (one - two) * (one ** n * exp(one * t) - two ** n * exp(two * t))).real
               for n in range(3)]
        # one^n e^(one t) = two^n e^(two t), for the first time after the start
        extreme = (log(two / one) / (one - two)).real
        inflection = (2 * log(two / one) / (one - two)).real
        if zeta < 1:
            turn = 2 * pi / fabs(d.imag)
            extreme, inflection = [t + turn if t <= 0 else t - turn if t > turn else t for t in (extreme, inflection)]
            inflection = inflection if inflection > extreme else inflection + turn / 2
    found = dict(time_of_extreme=extreme, time_of_inflection=inflection, extreme=law[0](extreme),
                 position_of_inflection=law[0](inflection), velocity_of_inflection=law[1](inflection))
    assert fabs(law[1](extreme)) < mpf(10) ** -60 and fabs(law[2](inflection)) < mpf(10) ** -60
    for i, t in enumerate(INSTANTS):
        for name, f in zip(("position", "velocity", "acceleration"), law):
            found[f"{name}_{i}"] = f(number(t))
    return found


def pendulum(given):
    theta_0, square, dt = number(given["degrees"]) * pi / 180, number(given["Omega_squared"]), number(given["dt"])
    side, Omega, k = (1 if theta_0 > 0 else -1), sqrt(square), sin(fabs(theta_0) / 2)
    K = ellipk(k * k)
    found = dict(modulus=k, K=K)
    for i, t in enumerate(INSTANTS):
        u = K - Omega * number(t)
        s, c, d = [ellipfun(kind, u, m=k * k) for kind in ("sn", "cn", "dn")]
        found.update({f"sine_of_half_{i}": side * k * s, f"cosine_of_half_{i}": d, f"rate_{i}": -2 * side * k * Omega * c})
    for i, phi in enumerate((mpf(0), pi / 7, pi / 2 - mpf(1) / 10 ** 9)):
        found[f"time_until_{i}"] = (K - ellipf(phi, k * k)) / Omega
    table = [theta_0, theta_0]
    for i in range(200):
        table.append(2 * table[i + 1] - table[i] - square * dt * dt * sin(table[i]))
    found.update({f"row_{i}": table[i] for i in (2, 3, 50, 200)})
    return found


NEAR = "1000000000000001/1000000000000000", "999999999999999/1000000000000000"
NEARER = "1000000000000000000000000000001/1000000000000000000000000000000"
OSCILLATORS = [("critical", "critical damping", "1"), ("just_over", "missed by 1e-15, from above", NEAR[0]),
               ("just_under", "missed by 1e-15, from below", NEAR[1]), ("nearer", "missed by 1e-30", NEARER),
               ("over", "overdamped, as the exercise has it", "3/2"), ("far_over", "strong damping", "40"),
               ("under", "underdamped", "3/10"), ("hardly", "hardly damped", "1/1000000"), ("none", "undamped", "0")]
PENDULUMS = [("level", "let go level", "90"), ("small", "a tiny swing", "1/1000000000"), ("left", "to the other side", "-20"),
             ("high", "from beyond the horizontal", "777/7"), ("nearly_up", "nearly upright", "17999/100"),
             ("nearest_up", "as nearly upright as doubles tell", "179999999999999/1000000000000")]


def main():
    print("# Reference values of the free oscillator and the pendulum, 40 digits. Written by make_vibration.py with mpmath,\n"
          "# 160 working digits; do not edit by hand. Instants 0 to 3: 0, 1/7, 5/3, 20 s.")
    for name, why, zeta in OSCILLATORS:
        write(name, why, dict(zeta=zeta, omega="3/7", v_0="-5/9"), oscillator)
    for name, why, degrees in PENDULUMS:
        write(name, why, dict(degrees=degrees, Omega_squared="981/25", dt="1/100"), pendulum)


def write(name, why, given, find):
    print(f"\ncase {name}\nwhy {why}")
    for symbol, value in given.items():
        print(f"given {symbol} {value}")
    for quantity, value in find(given).items():
        print(quantity, "0" if fabs(value) < mpf(10) ** -100 else nstr(value.real, 40, min_fixed=-30, max_fixed=30))


main()
