#!/usr/bin/env python3
"""Writes extremes.txt: the greatest and least that quantities of mechanisms become over a turn of their crank, and where,
independent of the C++ code: places by formulas of their own, rates and their zeros by numerical differences of many
digits. No file of docs/scenes is read. Usage: make_extremes.py > extremes.txt
"""
from mpmath import arg, diff, expj, findroot, im, mp, mpc, mpf, nstr, pi, re, sign, sqrt

mp.dps = 60
I = mpc(0, 1)


def left_joint(P, Q, a, b):
    d = abs(Q - P)
    x = (a ** 2 - b ** 2 + d ** 2) / (2 * d)
    return P + (Q - P) / d * (x + I * sqrt(a ** 2 - x ** 2))


def q(x):
    return mpf(x)


def four_bar(phi):
    A, B0 = q("0.12") * expj(phi), mpc("0.4")
    B = left_joint(A, B0, q("0.35"), q("0.28"))
    along = (B - A) / q("0.35")
    return {"P": A + along * mpc("0.175", "0.1"), "theta_3": arg(along), "theta_4": arg(B - B0)}


def six_bar(phi):
    at = four_bar(phi)
    D = mpc("0.1", "0.45")
    E = left_joint(at["P"], D, q("0.3"), q("0.25"))
    return {"E": E, "theta_6": pi + arg(D - E)}  # about 180 degrees


def slider_crank(phi):
    A = q("0.08") * expj(phi)
    B = re(A) + sqrt(q("0.26") ** 2 - (im(A) + q("0.03")) ** 2) - I * q("0.03")
    return {"B": B, "theta_3": arg(B - A)}


def quick_return(phi):
    A = I * q("0.3") + q("0.175") * expj(phi)
    B = q("0.7") * A / abs(A)
    C = re(B) + sqrt(q("0.8") ** 2 - (q("0.65") - im(B)) ** 2) + I * q("0.65")
    return {"C": C, "theta_4": arg(A)}


def planet(phi):
    """A wheel of 20 teeth rolls about one of 30: all is as it was after two turns of the arm."""
    return {"P": q("0.05") * expj(phi) + mpc("0.024", "0.018") * expj(phi * q("2.5"))}


CASES = [
    ("four-bar", four_bar, 1, ["theta_4", "P_x", "P_y", "omega_3", "v_P_y"]),
    ("six-bar", six_bar, 1, ["theta_6", "E_y", "v_E_x", "omega_6"]),
    ("slider-crank", slider_crank, 1, ["B_x", "v_B_x", "theta_3", "omega_3"]),
    ("quick-return", quick_return, 1, ["C_x", "v_C_x", "theta_4", "omega_4"]),
    ("planet", planet, 2, ["P_x", "P_y", "v_P_x"]),
]
SPEED = 2 * pi  # 60 rpm


def coordinate(of, name):
    def at(phi):
        if name.startswith("theta"):
            return of(phi)[name]
        return (re if name.endswith("x") else im)(of(phi)[name[0]])
    return at


def number(of, name):
    if name.startswith("v_"):
        below = coordinate(of, name[2:])
    elif name.startswith("omega"):
        below = coordinate(of, "theta" + name[5:])
    else:
        return coordinate(of, name)
    return lambda phi: SPEED * diff(below, phi)


def extremes(of, turns):
    """Each zero of the derivative between two of very many places, closed in by halving."""
    step = 2 * pi / 360
    places = [step * (k + q("0.31")) for k in range(360 * turns + 1)]
    slopes = [diff(of, at) for at in places]
    zeros = []
    for low, high, before, after in zip(places, places[1:], slopes, slopes[1:]):
        if sign(before) != sign(after):
            zeros.append(findroot(lambda at: diff(of, at), (low, high), solver="anderson", tol=mpf(10) ** -80))
    assert zeros
    return max(zeros, key=of), min(zeros, key=of)


print(f"# Greatest and least values over a turn of the drive, 30 digits. Written by make_extremes.py with")
print("# mpmath; do not edit by hand. Nothing here is taken from the C++ code.")
for case, of, turns, names in CASES:
    print(f"\ncase {case}\nwhy the mechanism of this name, as the test has it\ngiven extremes 1")
    for name in names:
        f = number(of, name)
        for which, at in zip(("max", "min"), extremes(f, turns)):
            is_angle = name.startswith("theta")
            print(f"{name}_{which} {nstr(f(at) * (180 / pi if is_angle else 1), 30)}")
            print(f"{name}_{which}_at {nstr((at % (2 * pi * turns)) * 180 / pi, 30)}")
