#!/usr/bin/env python3
"""Writes ideal_statics.txt: reference values for five mechanisms in equilibrium, independent of the C++ code.

  make_ideal_statics.py > ideal_statics.txt

The driving force or couple is that of virtual work with finite positions: the position of the load is written down as
a function of that of the driver, and differentiated numerically at high precision. The reactions follow by one moment
and two components of one body after the other. Meeting points of forces are those of the given lines.
"""
from fractions import Fraction

from mpmath import atan2, cos, diff, exp, fabs, im, mp, mpc, mpf, nstr, pi, re, sin, sqrt

mp.dps = 120
ZERO = mpf(10) ** -50  # what numerical differentiation leaves of a zero is smaller, everything else is larger

LEVERS = dict(Q="230", A0B0="7/20")
STATED = {
    "wedge_collar": dict(Q="200", theta="41", w="1/40", y_lower="7/200", y_upper="3/25"),
    "double_slider": dict(Q="150", theta="69", l="3/10"),
    "sliding_levers": dict(LEVERS, x_Q="61/500", direction_Q="-90", x_C="191/1000", y_C="21/500", nu="73",
                           direction_P="23/2", arm_P="14/125", r_2="3/50", r_3="1/20"),
    "sliding_levers_Q_on_2": dict(LEVERS, x_Q="73/200", direction_Q="-120", x_C="1/8", y_C="41/1000", nu="217/2",
                                  direction_P="195/2", arm_P="-57/250", r_2="1/20", r_3="3/50"),
    "fairbairn": dict(F="50", AB="1/5", AC="449/1000", theta="23", CD="19/20"),
    "fairbairn_short_lever": dict(F="50", AB="1/5", AC="423/1000", theta="47/2", CD="357/500"),
}
CASES = [
    ("stated", "the exercise as it is stated", {"wedge_collar.Q": "200"}),
    ("half_right_angles", "wedge and link at 45 degrees", {"wedge_collar.theta": "45", "double_slider.theta": "45"}),
    ("steep_and_flat", "a steep wedge, a flat link", {"wedge_collar.theta": "88", "double_slider.theta": "1/3"}),
    ("below_the_contact", "the collar's lower end below the contact", {"wedge_collar.y_lower": "-1/50"}),
    ("in_the_contact", "the collar's lower end level with the contact: it carries all",
     {"wedge_collar.y_lower": "0"}),
    ("P_along_the_normal", "P parallel to the contact's normal: the forces on its lever are parallel",
     {"sliding_levers.direction_P": "73", "sliding_levers_Q_on_2.direction_P": "577/2"}),
    ("P_near_the_normal", "the same missed by 1e-9 and 1e-30 degrees",
     {"sliding_levers.direction_P": "73000000001/1000000000",
      "sliding_levers_Q_on_2.direction_P": str(Fraction(577, 2) + Fraction(1, 10 ** 30))}),
    ("Q_along_the_normal", "Q parallel to the contact's normal", {"sliding_levers.direction_Q": "-107"}),
    ("normal_upright", "the contact's normal upright", {"sliding_levers.nu": "90", "sliding_levers_Q_on_2.nu": "90"}),
    ("contact_on_the_hinges", "the contact on the line of hinges: it is the relative pole",
     {"sliding_levers.y_C": "0"}),
    ("pushed_back", "P and its arm reversed", {"sliding_levers.arm_P": "-14/125", "sliding_levers.direction_P": "383/2"}),
    ("lever_upright", "Fairbairn's lever upright: no couple, H at infinity", {"fairbairn.theta": "0"}),
    ("lever_to_the_left", "Fairbairn's lever to the left of CA", {"fairbairn.theta": "-23"}),
    ("crank_longer", "a crank longer than AC: it turns all round", {"fairbairn.AB": "1/2"}),
    ("touching", "Fairbairn's crank square to the lever, which it just reaches: no couple, both at rest",
     {"fairbairn.theta": "30", "fairbairn.AC": "2/5"}),
    ("short_ram", "the ram's block nearer to C than the crank's", {"fairbairn.CD": "2/5"}),
    ("odd", "no round number anywhere",
     {"wedge_collar.Q": "1234/7", "wedge_collar.theta": "311/13", "double_slider.theta": "517/11",
      "double_slider.l": "19/23", "sliding_levers.x_C": "173/1000", "sliding_levers.r_2": "1/7",
      "sliding_levers_Q_on_2.x_Q": "41/100", "fairbairn.AC": "31/71", "fairbairn.theta": "207/10",
      "fairbairn_short_lever.F": "997/9"}),
]


def number(rational):
    q = Fraction(rational)
    return mpf(q.numerator) / q.denominator


def unit(degrees):
    """e^{iφ}, exactly on the axes."""
    exact = {0: mpc(1), 90: mpc(0, 1), 180: mpc(-1), 270: mpc(0, -1)}.get(Fraction(degrees) % 360)
    return exact if exact is not None else exp(mpc(0, 1) * number(degrees) * pi / 180)


def text(x):
    return "infinite" if x is None else "0" if fabs(x) <= ZERO else nstr(x, 40, strip_zeros=True, min_fixed=-30, max_fixed=30)


def cross(a, b):
    return re(a) * im(b) - im(a) * re(b)


def meet(P, u, Q, v):
    """Of the lines through P along u and through Q along v; None when they are parallel."""
    turn = cross(u, v)
    return None if fabs(turn) <= ZERO else P + cross(Q - P, v) / turn * u


def vector(found, name, v):
    found.update({name + "_x": re(v), name + "_y": im(v), name: abs(v)})


def point(found, name, P):
    found.update({name + "_x": P if P is None else re(P), name + "_y": P if P is None else im(P)})


def wedge(given):
    Q, y_l, y_u = (number(given[k]) for k in ("Q", "y_lower", "y_upper"))
    e = unit(given["theta"])
    slope = im(e) / re(e)
    ratio = diff(lambda X: (X + 1) * slope, mpf(0))  # the face's height under the rod
    P = Q * ratio
    one, two = {}, {}
    for found in (one, two):
        found["P"] = P
        vector(found, "R_12", mpc(0, Q))
        vector(found, "R_23", mpc(P, Q))
    vector(one, "R_13", mpc(-P, 0))
    one.update(v_Q_over_v_P=ratio, P_virtual_work=P)
    vector(two, "R_13_upper", mpc(P * y_l / (y_u - y_l), 0))
    vector(two, "R_13_lower", mpc(-P * y_u / (y_u - y_l), 0))
    two["R_13_resultant_x"] = -P
    return one, two


def double_slider(given):
    Q, l = number(given["Q"]), number(given["l"])
    e = unit(given["theta"])
    x, y = -l * re(e), l * im(e)
    ratio = diff(lambda X: sqrt(l * l - X * X), x)
    P = Q * ratio
    found = dict(A_y=y, B_x=x, P=P, v_Q_over_v_P=ratio, P_virtual_work=P)
    vector(found, "R_12", mpc(-P, 0))
    vector(found, "R_14", mpc(0, Q))
    vector(found, "R_32", mpc(P, Q))
    vector(found, "R_43", mpc(P, Q))
    point(found, "P31", mpc(x, y))
    return found


def four_bar(A0, A, B0, B):
    """B and the coupler's direction after the crank has turned by t."""
    coupler, rocker = abs(B - A), abs(B - B0)
    left = cross(B0 - A, B - A) > 0

    def moved(t):
        X = A0 + (A - A0) * exp(mpc(0, 1) * t)
        d = B0 - X
        along = (abs(d) ** 2 + coupler ** 2 - rocker ** 2) / (2 * abs(d))
        across = sqrt(coupler ** 2 - along ** 2)
        Y = X + d / abs(d) * mpc(along, across if left else -across)
        return X, Y

    return moved


def levers(given, loaded):
    Q, x_Q, b, x_C, y_C, arm_P, r_2, r_3 = (number(given[k]) for k in ("Q", "x_Q", "A0B0", "x_C", "y_C", "arm_P", "r_2", "r_3"))
    n, q, p = (unit(given[k]) for k in ("nu", "direction_Q", "direction_P"))
    driven = 5 - loaded
    hinge = {2: mpc(0), 3: mpc(b)}
    C, X_Q = mpc(x_C, y_C), mpc(x_Q)
    ahead = {2: r_2, 3: r_3}
    centre = {i: C + (ahead[i] if i == loaded else -ahead[i]) * n for i in (2, 3)}
    A, B = centre[2], centre[3]
    moved = four_bar(hinge[2], A, hinge[3], B)
    v_B = diff(lambda t: moved(t)[1], mpf(0))
    v_A = diff(lambda t: moved(t)[0], mpf(0))
    omega = {2: mpf(1), 3: re(v_B / (mpc(0, 1) * (B - hinge[3]))), 4: re((v_B - v_A) / (mpc(0, 1) * (B - A)))}
    arm_Q = cross(X_Q - hinge[loaded], q)
    ratio = arm_Q * omega[loaded] / (arm_P * omega[driven])
    P = -Q * ratio
    found = dict(P=P, P_virtual_work=P, v_Q_over_v_P=fabs(ratio), arm_Q=fabs(arm_Q))
    foot = hinge[driven] + arm_P * mpc(im(p), -re(p))
    N = -arm_P * P / cross(C - hinge[driven], -n)  # of the driven lever's moments
    R = {loaded: -(Q * q + N * n), driven: -(P * p - N * n)}
    vector(found, f"R_{driven}{loaded}", N * n)
    for i in (2, 3):
        vector(found, f"R_1{i}", R[i])
        point(found, f"H_{i}", meet(X_Q, q, C, n) if i == loaded else meet(foot, p, C, n))
    point(found, "A", A)
    point(found, "B", B)
    found.update(A0A=abs(A - hinge[2]), B0B=abs(B - hinge[3]))
    found.update(arm_normal_A0=fabs(cross(C - hinge[2], n)), arm_normal_B0=fabs(cross(C - hinge[3], n)))
    found.update(omega_3_over_omega_2=omega[3], omega_4_over_omega_2=omega[4])
    found["P23_x"] = None if fabs(im(n)) <= ZERO else x_C - y_C * re(n) / im(n)
    pole = None if fabs(omega[4]) <= ZERO else A + mpc(0, 1) * v_A / omega[4]
    point(found, "P41", pole)
    found.update(P41A=None if pole is None else abs(pole - A), P41B=None if pole is None else abs(pole - B))
    return found


def fairbairn(given):
    F, AB, AC, CD = (number(given[k]) for k in ("F", "AB", "AC", "CD"))
    e = unit(given["theta"])
    c, s = re(e), im(e)
    half_chord = AB * AB - (AC * s) ** 2
    CB = AC * c + (sqrt(half_chord) if fabs(half_chord) > ZERO else 0)
    lever, A = mpc(s, c), mpc(0, AC)
    B, D = CB * lever, CD * lever
    crank = B - A
    turned = lambda t: A + crank * exp(mpc(0, 1) * t)
    x_D = lambda t: CD * re(turned(t)) / abs(turned(t))
    v_D = diff(x_D, mpf(0))
    omega_4 = diff(lambda t: im(turned(t) / abs(turned(t)) / lever), mpf(0))
    M = -F * v_D
    N = F * CD * c / CB
    R_34 = N * mpc(-c, s)
    found = dict(CB=CB, M=M, M_virtual_work=M, F_23=N, d=fabs(M / N), omega_4_over_omega_2=omega_4,
                 v_D6_over_omega_2=fabs(v_D), crank_angle_deg=atan2(im(crank), re(crank)) * 180 / pi,
                 P24C=CB / c, P24A=fabs(CB / c - AC))
    point(found, "B", B)
    point(found, "D", D)
    vector(found, "R_34", R_34)
    vector(found, "R_14", -(F + R_34))
    vector(found, "R_12", R_34)
    vector(found, "R_56", mpc(-F, 0))
    point(found, "H", meet(mpc(0, CD * c), mpc(1), B, mpc(-c, s)))
    return found


def values(given):
    one, two = wedge(given["wedge_collar"])
    return {"wedge_collar": one, "wedge_collar_two_point": two, "double_slider": double_slider(given["double_slider"]),
            "sliding_levers": levers(given["sliding_levers"], 3),
            "sliding_levers_Q_on_2": levers(given["sliding_levers_Q_on_2"], 2),
            "fairbairn": fairbairn(given["fairbairn"]),
            "fairbairn_short_lever": fairbairn(given["fairbairn_short_lever"])}


def main():
    print("""# Reference values of five mechanisms in equilibrium, 40 digits. Written by make_ideal_statics.py with mpmath, 120
# working digits; do not edit by hand. Virtual work with finite positions, then moments body after body.
# SI units, angles in degrees. `infinite`: no such point.
""")
    for name, why, changes in CASES:
        given = {mechanism: dict(symbols) for mechanism, symbols in STATED.items()}
        for symbol, stated in changes.items():
            mechanism, letter = symbol.split(".")
            given[mechanism][letter] = stated
        print(f"case {name}\nwhy {why}")
        for symbol, stated in changes.items():
            print(f"given {symbol} {stated}")
        for mechanism, found in values(given).items():
            for quantity, x in found.items():
                print(f"{mechanism}.{quantity} {text(x)}")
        print()


if __name__ == "__main__":
    main()
