#!/usr/bin/env python3
"""Writes rolling.txt: wheels that roll on lines, independent of the C++ code: places by formulas of their own, rates by
numerical differences of many digits. Usage: make_rolling.py > rolling.txt
"""
from mpmath import arg, diff, expj, im, mp, mpc, mpf, nstr, pi, re, sqrt

mp.dps = 60
I = mpc(0, 1)


def q(x):
    return mpf(x)


def told(x):
    return nstr(x if abs(x) > mpf(10) ** -40 else mpf(0), 30)


def degrees(x):
    """In (-180, 180]."""
    return arg(expj(x)) * 180 / pi


def rack_and_pinion(t):
    """Crank 60 at 60 degrees and 60 rpm, rod 200; the pinion, 40, above the rack."""
    A = q("0.06") * expj(pi / 3 + 2 * pi * t)
    B = re(A) + sqrt(q("0.2") ** 2 - im(A) ** 2)
    # The pinion's centre goes backwards along the rack as the rack goes ahead.
    return {"theta_5": -(q("0.33") - B) / q("0.04"), "B": B}


def on_the_ground(t):
    s = q("0.07") + q("0.3") * t + q("0.25") * t ** 2
    theta = -s / q("0.05")
    C = s + I * q("0.05")
    return {"theta_2": theta, "P": C + q("0.03") * expj(theta), "C": C}


def with_a_rod(t):
    s = q("0.07") + q("0.3") * t
    theta = -s / q("0.05")
    P = s + I * q("0.05") + q("0.03") * expj(theta)
    Q = re(P) + sqrt(q("0.2") ** 2 - im(P) ** 2)
    return {"theta_2": theta, "P": P, "Q": Q + 0 * I, "theta_3": arg(Q - P)}


def on_a_lever(t):
    """C on a crank about Q; 20 right of the lever's line g, which so touches a circle of 20 about C."""
    C = q("0.3") * I + q("0.12") * expj(2 * pi / 9 + pi * t)
    d = abs(C)
    ahead = sqrt(d ** 2 - q("0.02") ** 2)
    lever = arg(C) + arg(mpc(ahead, q("0.02")))
    return {"theta_2": lever, "theta_4": lever + pi / 12 + (ahead - q("0.1")) / q("0.02"), "C": C}


CASES = [
    ("rack-and-pinion", rack_and_pinion, ["theta_5"], ["B"]),
    ("on-the-ground", on_the_ground, ["theta_2"], ["P"]),
    ("with-a-rod", with_a_rod, ["theta_2", "theta_3"], ["P", "Q"]),
    ("on-a-lever", on_a_lever, ["theta_2", "theta_4"], []),
]
print("# Wheels that roll on lines, 30 digits. Written by make_rolling.py with mpmath; do not edit by hand. Nothing here")
print("# is taken from the C++ code.")
for case, of, angles, points in CASES:
    print(f"\ncase {case}\nwhy the mechanism of this name, as the test has it\ngiven rolling 1")
    for name in angles:
        number = name[6:]
        at = lambda t: of(t)[name]
        print(f"{name} {told(degrees(at(q(0))))}")
        print(f"omega_{number} {told(diff(at, 0))}")
        print(f"alpha_{number} {told(diff(at, 0, 2))}")
    for name in points:
        for axis, part in (("x", re), ("y", im)):
            at = lambda t: part(of(t)[name])
            if name != "P" and axis == "y":
                continue
            print(f"{name}_{axis} {told(at(q(0)))}")
            print(f"v_{name}_{axis} {told(diff(at, 0))}")
            print(f"a_{name}_{axis} {told(diff(at, 0, 2))}")
