#!/usr/bin/env python3
"""Writes ranges.txt: how far drives of mechanisms that do not go round can go, independent of the C++ code: by the cosine
rule where links lie in one line, and where a second group stops the drive by a root found with many digits. Usage:
make_ranges.py > ranges.txt
"""
from mpmath import acos, asin, expj, findroot, mp, mpc, mpf, nstr, pi, sqrt

mp.dps = 60
I = mpc(0, 1)


def q(x):
    return mpf(x)


def angle_opposite(a, b, c):
    """Of a triangle, opposite the side a, in degrees."""
    return acos((b ** 2 + c ** 2 - a ** 2) / (2 * b * c)) * 180 / pi


def left_joint(P, Q, a, b):
    d = abs(Q - P)
    x = (a ** 2 - b ** 2 + d ** 2) / (2 * d)
    return P + (Q - P) / d * (x + I * sqrt(a ** 2 - x ** 2))


def six_bar(phi):
    """By how much P E and D E are longer than P D."""
    A, B0, D = q("0.12") * expj(phi), mpc("0.4"), mpc("0.1", "0.6")
    B = left_joint(A, B0, q("0.35"), q("0.28"))
    P = A + (B - A) / q("0.35") * mpc("0.175", "0.1")
    return q("0.23") + q("0.18") - abs(D - P)


def six_bar_of_rockers(phi):
    """The same where the four bars alone would stop at 55.293 degrees."""
    A, B0, D = q("0.2") * expj(phi), mpc("0.4"), mpc("0.45", "0.35")
    B = left_joint(A, B0, q("0.15"), q("0.18"))
    P = A + (B - A) / q("0.15") * mpc("0.075", "0.05")
    return q("0.16") + q("0.144") - abs(D - P)


def six_bar_that_stops_early(phi):
    """Of the same, by how much P D is longer than E D less E P, where the four bars would stop later."""
    A, B0, D = q("0.355") * expj(phi), mpc("0.169"), mpc("-0.031", "-0.288")
    B = left_joint(A, B0, q("0.141"), q("0.205"))
    P = A + (B - A) / q("0.141") * mpc("0.018", "0.105")
    return abs(D - P) - (q("0.472") - q("0.405"))


def end_of(six_bar, low, high):
    at = findroot(six_bar, (q(low) * pi / 180, q(high) * pi / 180), solver="anderson", tol=mpf(10) ** -100)
    return at * 180 / pi


stretched = angle_opposite(q("0.33"), q("0.2"), q("0.4"))
folded = angle_opposite(q("0.05"), q("0.3"), q("0.33"))
far = angle_opposite(q("0.61"), q("0.3"), q("0.33"))
AP, AQ = sqrt(q("0.5") ** 2 + q("0.2") ** 2), sqrt(4 + q("0.3") ** 2)
BQ, BR = sqrt(4 + q("0.3") ** 2), sqrt(1 + q("0.25") ** 2)
rocker_far = 180 - angle_opposite(q("0.47"), q("0.28"), q("0.4"))
rocker_near = 180 - angle_opposite(q("0.23"), q("0.28"), q("0.4"))
at_slot = angle_opposite(q("0.06"), q("0.26"), q("0.3"))
CASES = [
    ("triple-rocker", {"theta_2_max": stretched, "theta_2_min": -stretched}),
    # The frame is 330, the crank 300; coupler and rocker are 330 and 280.
    ("folded-and-stretched", {"theta_2_max": far, "theta_2_min": folded}),
    ("rocker", {"theta_4_max": max(rocker_far, rocker_near), "theta_4_min": min(rocker_far, rocker_near)}),
    ("crank-on-a-guide", {"theta_2_max": asin(q("0.12") / q("0.3")) * 180 / pi,
                          "theta_2_min": -asin(q("0.18") / q("0.3")) * 180 / pi}),
    ("piston", {"s_B_max": sqrt(q("0.34") ** 2 - q("0.03") ** 2), "s_B_min": sqrt(q("0.18") ** 2 - q("0.03") ** 2)}),
    # The pin, 260 from O2, is 60 from O4 (300 below O2) where the slot lets it come no nearer.
    ("slot", {"theta_2_max": 270 - at_slot, "theta_2_min": -90 + at_slot}),
    ("excavator", {"l_PQ_max": AQ + AP, "l_PQ_min": AQ - AP, "l_QR_max": BQ + BR, "l_QR_min": BQ - BR}),
    ("six-bar", {"theta_2_max": end_of(six_bar, 162, 164), "theta_2_min": end_of(six_bar, -4, -3)}),
    ("six-bar-of-rockers", {"theta_2_max": end_of(six_bar_of_rockers, 55, "55.29"),
                            "theta_2_min": end_of(six_bar_of_rockers, 19, 21)}),
    ("six-bar-folded", {"theta_2_max": angle_opposite(q("0.346"), q("0.355"), q("0.169")),
                        "theta_2_min": end_of(six_bar_that_stops_early, "-69.32", "-69.3")}),
    ("geared", {"theta_2_max": 2 * stretched, "theta_2_min": -2 * stretched}),
]
print("# How far drives can go, 30 digits. Written by make_ranges.py with mpmath; do not edit by hand. Nothing here is")
print("# taken from the C++ code.")
for case, values in CASES:
    print(f"\ncase {case}\nwhy the mechanism of this name, as the test has it\ngiven ranges 1")
    for name, value in values.items():
        print(f"{name} {nstr(value, 30)}")
