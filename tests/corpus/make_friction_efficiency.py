#!/usr/bin/env python3
"""Writes friction_efficiency.txt: reference values for mechanisms with friction, independent of the C++ code.

  make_friction_efficiency.py > friction_efficiency.txt

The driving forces are closed formulas where the mechanism has one, derived by hand body after body, or quotients of
moments; efficiencies are their quotients. Limits are roots found by bisection of what vanishes there.
"""
from fractions import Fraction

from mpmath import asin, atan, atan2, cos, degrees, exp, fabs, findroot, im, mp, mpc, mpf, nstr, pi, radians, re, sign, sin, sqrt, tan

from make_ideal_statics import STATED, ZERO, cross, meet, number, text, unit

mp.dps = 80

CASES = [
    ("stated", "the exercise as it is stated", {"phi": "5"}),
    ("smooth", "hardly any friction", {"phi": "1/1000000000"}),
    ("rough", "much friction", {"phi": "18"}),
    ("locking", "a flat wedge and a steep link: self-locking", {"phi": "7", "wedge_collar.theta": "12", "double_slider.theta": "86"}),
    ("nearly_locking", "the limit of self-locking missed by 1e-9 degrees",
     {"phi": "5", "wedge_collar.theta": "10000000001/1000000000", "double_slider.theta": "84999999999/1000000000"}),
    ("odd", "no round number anywhere",
     {"phi": "311/37", "wedge_collar.theta": "311/13", "double_slider.theta": "517/11", "double_slider.l": "19/23",
      "sliding_levers.x_C": "173/1000", "sliding_levers_Q_on_2.x_Q": "41/100", "fairbairn.AC": "31/71",
      "fairbairn.theta": "207/10", "fairbairn_short_lever.F": "997/9"}),
    ("Q_along_the_normal", "Q parallel to the contact's normal, which its force is not",
     {"sliding_levers.nu": "90", "sliding_levers_Q_on_2.nu": "60"}),
    ("P_along_the_normal", "P parallel to the contact's normal, which its force is not",
     {"sliding_levers.direction_P": "73", "sliding_levers_Q_on_2.direction_P": "577/2"}),
    ("Q_along_the_force", "Q parallel to the contact's force in one motion",
     {"sliding_levers.direction_Q": "-102", "sliding_levers_Q_on_2.direction_Q": "-133/2"}),
    ("Q_along_the_other_force", "Q parallel to the contact's force in the other motion",
     {"sliding_levers.direction_Q": "-112", "sliding_levers_Q_on_2.direction_Q": "-153/2"}),
    ("P_along_the_force", "P parallel to the contact's force in one motion",
     {"sliding_levers.direction_P": "78", "sliding_levers_Q_on_2.direction_P": "207/2"}),
    ("P_near_the_force", "the same missed by 1e-9 and 1e-30 degrees",
     {"sliding_levers.direction_P": "78000000001/1000000000",
      "sliding_levers_Q_on_2.direction_P": str(Fraction(207, 2) + Fraction(1, 10 ** 30))}),
    ("P_along_the_other_force", "P parallel to the contact's force in the other motion",
     {"sliding_levers.direction_P": "68", "sliding_levers_Q_on_2.direction_P": "227/2"}),
    ("on_the_cones", "the load on the edge of the friction cone: the wedge's force upright, the collar without load; "
     "Fairbairn's forces on the lever parallel; a link on both friction circles as wide as itself",
     {"wedge_collar.theta": "5", "fairbairn.theta": "10", "fairbairn_short_lever.theta": "-10",
      "double_slider.theta": "80", "double_slider_pins.r": "3/20"}),
    ("upright_link", "the link's force upright, on friction circles as wide as the link",
     {"double_slider.theta": "85", "double_slider_pins.r": "3/20"}),
    ("levers_at_the_limit", "the contact's force passes through the hinge of the lever of P",
     {"sliding_levers.x_C": "19/100", "sliding_levers.y_C": "19/100", "sliding_levers.nu": "50"}),
]


def turn(angle):
    return exp(mpc(0, 1) * angle)


def vector(found, name, v):
    found.update({name + "_x": re(v), name + "_y": im(v), name: abs(v)})


def point(found, name, P):
    found.update({name + "_x": P if P is None else re(P), name + "_y": P if P is None else im(P)})


def efforts(found, letter, ideal, direct, retrograde):
    found.update({letter + "_i": ideal, letter + "_direct": direct, letter + "_retrograde": retrograde,
                  "eta_direct": ideal / direct, "eta_retrograde": retrograde / ideal,
                  "self_locking": mpf(1 if retrograde <= ZERO else 0)})


def wedge(given, phi):
    Q, w, y_l, y_u = (number(given[k]) for k in ("Q", "w", "y_lower", "y_upper"))
    theta = radians(number(given["theta"]))
    found = dict(self_locking_friction_angle_deg=degrees(theta) / 2,
                 jamming_friction_angle_deg=45 - degrees(theta) / 2)
    efforts(found, "P", Q * tan(theta), Q * tan(theta + 2 * phi), Q * tan(theta - 2 * phi))
    for name, f in (("_direct", phi), ("_retrograde", -phi)):
        N = Q * cos(f) / cos(theta + 2 * f)
        e = mpc(sin(theta + f), cos(theta + f))
        vector(found, "R_23" + name, N * e)
        vector(found, "R_13" + name, mpc(0, Q) - N * e)
        vector(found, "R_12" + name, mpc(-Q * tan(theta + 2 * f), 0) + N * e)
    two = {}

    def forces(f):
        """R_23, upper and lower: the rod's components and its moment about O, by elimination."""
        m = tan(f)
        # lower = k upper by the moment about O: of (1, -m) in (-w/2, y_u), of (-1, -m) in (w/2, y_l).
        k = (y_u - m * w / 2) / (y_l - m * w / 2)
        # R_23 (s, c) with s N = (k - 1) u and c N = Q + m (1 + k) u.
        s, c = sin(theta + f), cos(theta + f)
        part = Q / ((k - 1) * c - m * (1 + k) * s)
        return (k - 1) * part, s * part, k * s * part, m

    P = []
    for name, f in (("", mpf(0)), ("_direct", phi), ("_retrograde", -phi)):
        N, u, l, m = forces(f)
        e = mpc(sin(theta + f), cos(theta + f))
        floor = N * cos(theta + f) * mpc(-m, 1)
        P.append(re(N * e - floor))
        if not name:
            continue
        vector(two, "R_23" + name, N * e)
        vector(two, "R_13_upper" + name, mpc(u, -m * u))
        vector(two, "R_13_lower" + name, mpc(-l, -m * l))
        vector(two, "R_12" + name, floor)
        K = meet(mpc(-w / 2, y_u), mpc(1, -m), mpc(w / 2, y_l), mpc(1, m))
        point(two, "K" + name, K)
        two[f"culmann_angle{name}_deg"] = degrees(atan(im(K) / re(K)))
    efforts(two, "P", *P)
    two["self_locking_friction_angle_deg"] = degrees(theta) / 2

    def room(f):
        K = meet(mpc(-w / 2, y_u), mpc(1, -tan(f)), mpc(w / 2, y_l), mpc(1, tan(f)))
        return -cross(mpc(sin(theta + f), cos(theta + f)), K) * tan(f)

    low, high = mpf(1) / 10 ** 6, mpf(1) / 100
    while room(high) * room(low) > 0:
        low, high = high, high + mpf(1) / 100
    two["jamming_friction_angle_deg"] = degrees(findroot(room, (low, high), solver="anderson", tol=mpf(10) ** -140))
    return found, two


def root(rising, most):
    low, high = mpf(0), most
    while high - low > mpf(10) ** -60:
        middle = (low + high) / 2
        low, high = (middle, high) if rising(middle) < 0 else (low, middle)
    return low


def double_slider(given, phi, r):
    Q, l = number(given["Q"]), number(given["l"])
    theta = radians(number(given["theta"]))
    rho = r * sin(phi)
    delta = asin(2 * rho / l)
    plain = dict(self_locking_friction_angle_deg=90 - degrees(theta), jamming_friction_angle_deg=degrees(theta))
    pins = dict(friction_circle_radius=rho, link_line_tilt_angle_deg=degrees(delta),
                link_line_angle_direct_deg=degrees(theta - delta), link_line_angle_retrograde_deg=degrees(theta + delta))
    # Where P vanishes, and where it is infinite: the link's force upright on the cone of slider 4, and in it.
    tilt = lambda f: asin(2 * r * sin(f) / l)
    pins["self_locking_friction_angle_deg"] = degrees(root(lambda f: theta + tilt(f) + f - pi / 2, pi / 2 - theta))
    pins["jamming_friction_angle_deg"] = degrees(root(lambda f: tilt(f) + f - theta, theta))
    for found, d in ((plain, mpf(0)), (pins, delta)):
        P = lambda f, psi: Q / tan(psi - f)
        efforts(found, "P", P(0, theta), P(phi, theta - d), P(-phi, theta + d))
        for name, f, psi in (("_direct", phi, theta - d), ("_retrograde", -phi, theta + d)):
            N = Q * cos(f) / sin(psi - f)
            R = N * turn(psi)
            vector(found, "R_32" + name, R)
            vector(found, "R_12" + name, mpc(0, Q) - R)
            vector(found, "R_14" + name, R - P(f, psi))
    return plain, pins


def levers(given, phi, loaded):
    Q, x_Q, b, x_C, y_C, arm_P = (number(given[k]) for k in ("Q", "x_Q", "A0B0", "x_C", "y_C", "arm_P"))
    n, q, p = (unit(given[k]) for k in ("nu", "direction_Q", "direction_P"))
    driven = 5 - loaded
    hinge = {2: mpc(0), 3: mpc(b)}
    C, X_Q = mpc(x_C, y_C), mpc(x_Q)
    foot = hinge[driven] + arm_P * mpc(im(p), -re(p))
    # Sliding of the loaded lever on the other along the left of n, when P turns its lever.
    omega = {driven: sign(arm_P)}
    omega[loaded] = omega[driven] * cross(C - hinge[driven], n) / cross(C - hinge[loaded], n)
    s = sign(re((mpc(0, 1) * omega[loaded] * (C - hinge[loaded]) - mpc(0, 1) * omega[driven] * (C - hinge[driven])) / (mpc(0, 1) * n)))
    found = {}

    def forces(f):
        e = n * turn(-s * f)
        N = -Q * cross(X_Q - hinge[loaded], q) / cross(C - hinge[loaded], e)
        return e, N, N * cross(C - hinge[driven], e) / arm_P

    P = [forces(f)[2] for f in (mpf(0), phi, -phi)]
    efforts(found, "P", *P)
    for name, f in (("_direct", phi), ("_retrograde", -phi)):
        e, N, effort = forces(f)
        vector(found, f"R_{driven}{loaded}" + name, N * e)
        vector(found, f"R_1{loaded}" + name, -(Q * q + N * e))
        vector(found, f"R_1{driven}" + name, -(effort * p - N * e))
        found[f"contact_force_angle{name}_deg"] = degrees(atan2(im(e), re(e)))
        point(found, f"H_{loaded}" + name, meet(X_Q, q, C, e))
        point(found, f"H_{driven}" + name, meet(foot, p, C, e))
    # e = n turned by s f passes through the driven lever's hinge.
    w = C - hinge[driven]
    tangent = -s * cross(w, n) / re(w * n.conjugate())
    found["self_locking_friction_angle_deg"] = degrees(atan(tangent)) if tangent > 0 else None
    return found


def fairbairn(given, phi):
    F, AB, AC, CD = (number(given[k]) for k in ("F", "AB", "AC", "CD"))
    theta = radians(number(given["theta"]))
    c, s = cos(theta), sin(theta)
    along = sqrt(AB ** 2 - (AC * s) ** 2)
    CB = AC * c + along
    lever = mpc(s, c)
    A, B, D, n = mpc(0, AC), CB * lever, CD * lever, mpc(-c, s)
    # The lever slides on block 3 along itself, inwards when it lags behind the crank's pin.
    side = sign(re((CB * n * along / CB - mpc(0, 1) * (B - A)) * lever.conjugate()))  # v_B4 - v_B2 along the lever
    turning = -side  # its left is -lever
    found = {}

    def forces(f):
        R_56 = F * cos(f) / (cos(2 * f) if f > 0 else 1) * mpc(-cos(f), sign(s) * sin(f))  # block 5 rises with D
        R_16 = -F - R_56
        e = n * turn(-turning * f)
        N = -cross(D, -R_56) / cross(B, e)
        return R_56, R_16, N * e, N * cross(B - A, e)

    efforts(found, "M", *[forces(f)[3] for f in (mpf(0), phi, -phi)])
    for name, f in (("_direct", phi), ("_retrograde", -phi)):
        R_56, R_16, R_34, M = forces(f)
        vector(found, "R_56" + name, R_56)
        vector(found, "R_16" + name, R_16)
        vector(found, "R_34" + name, R_34)
        vector(found, "R_14" + name, R_56 - R_34)
        found.update({"F_23" + name: abs(R_34), "d" + name: fabs(M) / abs(R_34)})
        point(found, "H" + name, meet(D, R_56, B, R_34))
    w = B - A
    tangent = -turning * cross(w, n) / re(w * n.conjugate())
    found["self_locking_friction_angle_deg"] = degrees(atan(tangent)) if tangent > 0 else None
    found["jamming_friction_angle_deg"] = mpf(45)
    return found


def values(given, phi, r):
    wedges, sliders = wedge(given["wedge_collar"], phi), double_slider(given["double_slider"], phi, r)
    return {"wedge_collar": wedges[0], "wedge_collar_two_point": wedges[1], "double_slider": sliders[0],
            "double_slider_pins": sliders[1], "sliding_levers": levers(given["sliding_levers"], phi, 3),
            "sliding_levers_Q_on_2": levers(given["sliding_levers_Q_on_2"], phi, 2),
            "fairbairn": fairbairn(given["fairbairn"], phi),
            "fairbairn_short_lever": fairbairn(given["fairbairn_short_lever"], phi)}


def main():
    print("""# Reference values of mechanisms with friction, 40 digits. Written by make_friction_efficiency.py with mpmath, 80
# working digits; do not edit by hand. SI units, angles in degrees. `infinite`: no such angle.
""")
    for name, why, changes in CASES:
        given = {mechanism: dict(symbols) for mechanism, symbols in STATED.items()}
        own = {"phi": "5", "double_slider_pins.r": "1/100"}
        for symbol, stated in changes.items():
            if symbol in own:
                own[symbol] = stated
                continue
            mechanism, letter = symbol.split(".")
            given[mechanism][letter] = stated
        print(f"case {name}\nwhy {why}")
        for symbol, stated in changes.items():
            print(f"given {symbol} {stated}")
        phi = radians(number(own["phi"]))
        print(f"friction_coefficient {text(tan(phi))}")
        for mechanism, found in values(given, phi, number(own["double_slider_pins.r"])).items():
            for quantity, x in found.items():
                print(f"{mechanism}.{quantity} {text(x)}")
        print()


if __name__ == "__main__":
    main()
