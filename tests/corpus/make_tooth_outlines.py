#!/usr/bin/env python3
"""Writes reference points of tooth outlines, independent of the C++ code.

  make_tooth_outlines.py > tooth_outlines.txt

A wheel is cut by its rack, whose tooth ends in a rounding: the centre's path in the turning wheel is written down, its
normals come from numerical differentiation, and the root curve lies the rounding's radius along them. The first place
where it comes out of the tooth is looked for in 2000 steps and bisected; that its point lies on the involute, written
as a string that unwinds, is checked to 45 digits, for the common tangent too. A ring's rounding is the circle that touches flank and root circle, found by solving for its centre and both contacts.
"""
from fractions import Fraction

from mpmath import acos, cos, diff, e, exp, fabs, findroot, im, mp, mpc, mpf, nstr, pi, re, sin, sqrt, tan, atan2, j as I

mp.dps = 60

HEAD = """# Reference points of tooth outlines, 40 digits. Written by make_tooth_outlines.py with mpmath, 60 working digits; do not
# edit by hand. Nothing here is taken from the C++ code.
#
# Givens: z, m (metres), alpha (fraction of a turn), x, hf, ha and rho over m, j (backlash in metres on the reference
# circle, the working pitch circle of these pairs). Choices: body wheel or ring; root tangent or undercut.
# The tooth's middle lies on +y, its right half is meant; a ring's tooth points to the centre.
# half_angle: from +y to the start of the right flank's involute on the base circle. form_radius: where root and flank
# meet. fillet_N_x, _y, flank_N_x, _y: points of the outline, of the whole fillet and flank, ends included. Metres.
"""


def number(value):
    return nstr(value, 40, strip_zeros=False)


def inv(angle):
    return tan(angle) - angle


def unwound(r_b, start, roll, sense):
    """The end of a string unwound by `roll` from the base circle at the angle `start`."""
    at = start + sense * roll
    return r_b * exp(I * at) - sense * I * r_b * roll * exp(I * at)


def rooted(f, guess):
    return findroot(f, guess, tol=mpf(10) ** -100, maxsteps=100, verify=False)


def point(name, value):
    return [f"{name}_x {number(re(value))}", f"{name}_y {number(im(value))}"]


def wheel(z, alpha, x, hf, rho, ha, j, m):
    a, r = 2 * pi * mpf(alpha.numerator) / alpha.denominator, m * z / 2
    r_b = r * cos(a)
    half = (m * (pi / 2 + 2 * x * tan(a)) - j / 2) / (2 * r) + inv(a)
    start = pi / 2 - half
    # The centre of the rounding beside the middle of the rack's tooth: edge less the way the edge leans in, less the
    # rounding itself.
    c = pi * m / 4 + j / 4 - (hf - rho) * m * tan(a) - rho * m / cos(a)
    d = (hf - rho - x) * m
    assert c > 0

    def centre(phi):  # in the wheel, the space's middle turned to the right of the tooth
        return exp(I * phi) * mpc(c + r * phi, r - d)

    # The side that points to the wheel's centre on the root circle, and the same side all along.
    first_normal = I * diff(centre, -c / r)
    side = -1 if re(first_normal / centre(-c / r)) > 0 else 1

    def root(phi):
        normal = side * I * diff(centre, phi)
        left = (centre(phi) + rho * m * normal / fabs(normal)) * exp(I * pi / z)
        return mpc(-re(left), im(left))

    def flank(roll):
        return unwound(r_b, start, roll, 1)

    # The edge's end touches its flank where the rounding's normal leans by alpha.
    last = (d / tan(a) - c) / r
    roll = (r * sin(a) - d / sin(a) - rho * m) / r_b
    undercut = roll < 0
    if undercut:
        # The first place, from the root circle, at which the curve comes out of the tooth.
        first = -c / r
        def out(phi):
            P = root(phi)
            over = fabs(P) ** 2 - r_b ** 2
            if over < 0:
                return mpf(-1)
            t = sqrt(over) / r_b
            return atan2(re(P), im(P)) + t - atan2(t, 1) - half
        steps = 2000
        k = next(k for k in range(1, steps + 1) if out(first + (last - first) * k / steps) > 0)
        low, high = first + (last - first) * (k - 1) / steps, first + (last - first) * k / steps
        for _ in range(200):
            middle = (low + high) / 2
            low, high = (low, middle) if out(middle) > 0 else (middle, high)
        last, roll = high, sqrt(fabs(root(high)) ** 2 - r_b ** 2) / r_b
    assert fabs(root(last) - flank(roll)) < mpf(10) ** -45
    tip = r + (ha + x) * m
    to_tip = sqrt((tip / r_b) ** 2 - 1)
    lines = [f"half_angle {number(half)}", f"form_radius {number(r_b * sqrt(1 + roll ** 2))}"]
    for k in range(7):
        lines += point(f"fillet_{k}", root(-c / r + (last + c / r) * k / 6))
    for k in range(7):
        lines += point(f"flank_{k}", flank(roll + (to_tip - roll) * k / 6))
    return "undercut" if undercut else "tangent", lines


def ring(z, alpha, x, hf, rho, ha, j, m):
    a, r = 2 * pi * mpf(alpha.numerator) / alpha.denominator, m * z / 2
    r_b = r * cos(a)
    half = (m * (pi / 2 - 2 * x * tan(a)) - j / 2) / (2 * r) - inv(a)
    start, r_root, r_tip, radius = pi / 2 - half, r + (x + hf) * m, r + (x - ha) * m, rho * m

    def flank(roll):
        return unwound(r_b, start, roll, -1)

    # The centre at a distance from the wheel's centre that the root circle fixes, at an angle; it lies the radius away
    # from the flank's point, across the flank.
    def touch(angle, roll):
        centre = (r_root - radius) * exp(I * angle)
        across = I * diff(flank, roll) / fabs(diff(flank, roll))
        miss = flank(roll) + across * radius * side - centre
        return [re(miss), im(miss)]

    outer = sqrt((r_root / r_b) ** 2 - 1)
    here = flank(outer)
    # Into the space: away from the tooth's middle, towards smaller angles.
    side = 1 if re(I * diff(flank, outer) / (I * here)) < 0 else -1
    angle, roll = rooted(touch, (atan2(im(here), re(here)) - radius / r, outer))
    centre = (r_root - radius) * exp(I * angle)
    lines = [f"half_angle {number(half)}", f"form_radius {number(fabs(flank(roll)))}"]
    to_flank = atan2(im(flank(roll) - centre), re(flank(roll) - centre))
    for k in range(7):
        lines += point(f"fillet_{k}", centre + radius * exp(I * (angle + (to_flank - angle) * k / 6)))
    to_tip = sqrt((r_tip / r_b) ** 2 - 1)
    for k in range(7):
        lines += point(f"flank_{k}", flank(roll + (to_tip - roll) * k / 6))
    return "tangent", lines


def case(name, why, body, z, alpha, x="0", hf="5/4", rho="1/4", ha="1", j="0", m="1/100"):
    given = {"z": Fraction(z), "m": Fraction(m), "alpha": Fraction(alpha), "x": Fraction(x), "hf": Fraction(hf),
             "rho": Fraction(rho), "ha": Fraction(ha), "j": Fraction(j)}
    real = {key: mpf(value.numerator) / value.denominator for key, value in given.items()}
    root, lines = (wheel if body == "wheel" else ring)(
        z, given["alpha"], real["x"], real["hf"], real["rho"], real["ha"], real["j"], real["m"])
    print(f"\ncase {name}\nwhy {why}")
    for key, value in given.items():
        print(f"given {key} {value}")
    print(f"choice body {body}\nchoice root {root}")
    print("\n".join(lines))


print(HEAD, end="")
DEG22, DEG20, DEG30 = "11/180", "1/18", "1/12"
case("source_1", "exercise N.12, the driving wheel", "wheel", 20, DEG22)
case("source_2", "exercise N.12, the driven wheel", "wheel", 40, DEG22)
case("shifted_out", "profile shift", "wheel", 20, DEG22, x="1/2")
case("shifted_in", "profile shift towards the centre: all but undercut", "wheel", 20, DEG22, x="-3/10")
case("backlash", "thinner teeth are cut by a wider rack", "wheel", 20, DEG22, j="1/5000")
case("above_limit", "not undercut by the cutter's straight edge: the limit is 15.59 teeth", "wheel", 16, DEG22)
case("below_limit", "just undercut", "wheel", 15, DEG22)
case("undercut_14", "undercut", "wheel", 14, DEG22)
case("undercut_13", "undercut", "wheel", 13, DEG22)
case("undercut_10", "undercut", "wheel", 10, DEG22)
case("undercut_7", "a sharper cutter", "wheel", 7, DEG20, rho="1/10")
case("undercut_5", "heavy undercut", "wheel", 5, DEG22)
case("undercut_5_in", "and more of it", "wheel", 5, DEG22, x="-3/10")
case("undercut_4", "as few teeth as make sense", "wheel", 4, DEG22)
case("undercut_4_28", "a neck of 0.2 mm", "wheel", 4, "7/90", rho="1/5")
case("undercut_3_28", "a root of a quarter module", "wheel", 3, "7/90", rho="1/5", ha="4/5")
case("thirty_9", "one more tooth than the limit of 30 degrees", "wheel", 9, DEG30, hf="11/10", rho="1/5")
case("thirty_7", "one less", "wheel", 7, DEG30, hf="11/10", rho="1/5")
case("many", "nearly a rack", "wheel", 1000, DEG22)
case("beyond_pitch", "shifted so far that the rounding's centre stays outside the pitch circle", "wheel", 20, DEG22,
     x="6/5", ha="3/5")
case("ring_60", "a ring", "ring", 60, DEG22)
case("ring_50_shifted", "a ring with shift and backlash", "ring", 50, DEG22, x="2/5", j="1/5000")
