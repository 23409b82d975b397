#!/usr/bin/env python3
"""Writes scene_forces.txt: reactions and driving efforts of scenes under loads that the test puts on
them, independent of the C++ code: places by formulas of their own, then the equilibrium of components (equilibrium.py).
With friction the sense of sliding is that in which a coordinate along the line grows, and all senses of what presses
are tried. No file of docs/scenes is read. Usage: make_scene_forces.py > scene_forces.txt
"""
from mpmath import arg, conj, expj, im, mp, mpc, mpf, nstr, pi, re, sqrt, tan

from equilibrium import Equilibrium, with_circles, with_friction, with_teeth

mp.dps = 80
ZERO = mpf(10) ** -50
I = mpc(0, 1)


def deg(x):
    return expj(pi * mpf(x) / 180)


def left_joint(P, Q, a, b):
    d = abs(Q - P)
    x = (a ** 2 - b ** 2 + d ** 2) / (2 * d)
    return P + (Q - P) / d * (x + I * sqrt(a ** 2 - x ** 2))


def right_joint(P, Q, a, b):
    return conj(left_joint(conj(P), conj(Q), a, b))


def q(x):
    return mpf(x)


def four_bar(equilibrium=Equilibrium):
    A, B0 = q("0.12") * deg(60), mpc("0.4")
    B = left_joint(A, B0, q("0.35"), q("0.28"))
    e = equilibrium([2, 3, 4])
    e.hinge(1, 2, 0), e.hinge(2, 3, A), e.hinge(3, 4, B), e.hinge(1, 4, B0), e.couple("M_2", 1, 2)
    e.load(3, A + (B - A) / q("0.35") * mpc("0.175", "0.1"), 200 * deg(-100), "Q_P")
    e.load_couple(4, -20, "T_4")
    e.rod("R_23", A, B), e.rod("R_14", B0, B)
    return e


def slider_crank(equilibrium=Equilibrium):
    A = q("0.12") * deg(75)
    B = mpc(re(A) + sqrt(q("0.4") ** 2 - (im(A) + q("0.05")) ** 2), "-0.05")
    e = equilibrium([2, 3, 4])
    e.hinge(1, 2, 0), e.hinge(2, 3, A), e.hinge(3, 4, B), e.couple("M_2", 1, 2)
    e.unknown("N_b", 1, 4, B, I), e.couple("M_b", 1, 4)
    e.load(4, B, -1000, "Q_B"), e.load_couple(4, 3, "T_4")
    e.load(3, A + (B - A) / q("0.4") * mpc(q("0.4") / 3, "0.04"), mpc(0, -50), "Q_G")
    e.rod("R_23", A, B)
    return e


def scotch_yoke(equilibrium=Equilibrium):
    A = q("0.1") * deg(35)
    O3 = mpc(re(A), 0)
    e = equilibrium([2, 3])
    e.hinge(1, 2, 0), e.couple("M_2", 1, 2)
    e.unknown("N_A", 3, 2, A, -1), e.unknown("N_b", 1, 3, O3, I), e.couple("M_b", 1, 3)
    e.load(3, O3 + q("0.25"), mpc(-200, 30), "Q_C")
    return e


def oldham(equilibrium=Equilibrium):
    u, d = deg(25), q("0.03")
    C = re(d * conj(u)) * u
    e = equilibrium([2, 3, 4])
    e.hinge(1, 2, 0), e.hinge(1, 4, d), e.couple("M_2", 1, 2)
    # q of 3 in p of 2; s of 3 in t of 4: at C, the origin of both lines of 3.
    e.unknown("N_q", 2, 3, C, I * u), e.couple("M_q", 2, 3)
    e.unknown("N_s", 4, 3, C, -u), e.couple("M_s", 4, 3)
    e.load(3, C, mpc(10, -20), "Q_C"), e.load_couple(4, -25, "T_4")
    return e


def trammel(equilibrium=Equilibrium):
    A = mpc("0.6")
    B = I * sqrt(1 - q("0.6") ** 2)
    e = equilibrium([2])
    e.unknown("N_A", 1, 2, A, I), e.unknown("N_B", 1, 2, B, -1), e.unknown("F_A", 1, 2, A, 1)
    e.load(2, A + (B - A) / 3, mpc(0, -700), "Q_P")
    e.sum("R_A", [("F_A", 1), ("N_A", I)]), e.rod("R_A", A, B)
    return e


def excavator(equilibrium=Equilibrium):
    P, own_Q, own_R = mpc("0.5", "-0.2"), mpc(2, "0.3"), mpc(-1, "0.25")
    Q = left_joint(mpc(0), P, abs(own_Q), q("1.8"))
    boom = Q / own_Q
    B = 4 * boom
    R = right_joint(B, Q, abs(own_R), q("1.4"))
    stick = (R - B) / own_R
    e = equilibrium([2, 3])
    e.hinge(1, 2, 0), e.hinge(2, 3, B)
    e.unknown("F_PQ", 1, 2, Q, (Q - P) / abs(Q - P)), e.unknown("F_QR", 2, 3, R, (R - Q) / abs(R - Q))
    e.load(3, B + 2 * stick, mpc(0, -20000), "Q_T"), e.load(2, mpc(2, "0.5") * boom, 3000 * deg(-60), "Q_2")
    e.rod("R_23", B, R), e.rod("R_12", mpc(0), Q)
    return e


def oscillating_cylinder(equilibrium=Equilibrium):
    A, C = q("0.08") * deg(70), mpc("0.32")
    u = (A - C) / abs(A - C)
    K = A - q("0.24") * u
    e = equilibrium([2, 3, 4])
    e.hinge(1, 2, 0), e.hinge(2, 4, A), e.hinge(1, 3, C), e.couple("M_2", 1, 2)
    e.unknown("N_p", 3, 4, K, I * u), e.couple("M_p", 3, 4)
    e.load(4, K, 900 * deg(20), "Q_K"), e.load(3, C + u / 10, mpc(0, -40), "Q_3")
    return e


def cardan_circles(equilibrium=Equilibrium):
    M, r = q("0.15") * deg(35), q("0.15")
    A = mpc(2 * re(M), 0)
    e = equilibrium([2, 3])
    e.hinge(1, 2, 0), e.hinge(2, 3, M), e.couple("M_2", 1, 2), e.unknown("N_A", 1, 3, A, I)
    e.load(3, M + r / 2 * I * conj(deg(35)), 80 * deg(-30), "Q_P")
    e.rod("R_23", M, A)
    return e


def geneva(equilibrium=Equilibrium):
    A, O3 = q("0.1") * deg(150), mpc("-0.2")
    u = (A - O3) / abs(A - O3)
    e = equilibrium([2, 3])
    e.hinge(1, 2, 0), e.hinge(1, 3, O3), e.couple("M_2", 1, 2), e.unknown("N_A", 3, 2, A, I * u)
    e.load_couple(3, 12, "T_3")
    return e


def jansen(equilibrium=Equilibrium):
    mm = mpf(1) / 1000
    Qp, A = mpc(-38, "-7.8") * mm, 15 * mm * deg(100)
    B = right_joint(A, Qp, 50 * mm, q("41.5") * mm)
    D = left_joint(A, Qp, q("61.9") * mm, q("39.3") * mm)
    C = Qp + (B - Qp) / q("41.5") * mpc("2.61", "40.015")
    E = right_joint(C, D, q("39.4") * mm, q("36.7") * mm)
    F = D + (E - D) / q("36.7") * mpc("44.447", "48.383")
    e = equilibrium(range(2, 9))
    e.hinge(1, 2, 0), e.couple("M_2", 1, 2), e.hinge(2, 3, A), e.hinge(2, 5, A), e.hinge(1, 4, Qp), e.hinge(1, 6, Qp)
    e.hinge(3, 4, B), e.hinge(5, 6, D), e.hinge(5, 8, D), e.hinge(4, 7, C), e.hinge(7, 8, E)
    e.load(8, F, mpc(30, 200), "Q_F")
    e.rod("R_58", D, E), e.rod("R_14", Qp, B)
    return e


def driven_piston(equilibrium=Equilibrium):
    B = mpc("0.45", 0)
    A = left_joint(mpc(0), B, q("0.12"), q("0.4"))
    e = equilibrium([2, 3, 4])
    e.hinge(1, 2, 0), e.hinge(2, 3, A), e.hinge(3, 4, B)
    e.unknown("F_B", 1, 4, B, 1)  # on the pin, which is of 4, the block that the drive places
    # b is given through a point 30 mm ahead of B.
    e.unknown("N_b", 1, 4, B + q("0.03"), I), e.couple("M_b", 1, 4)
    e.load_couple(2, 15, "T_2"), e.load(4, B + mpc("0.1", "0.02"), mpc(3, -8), "Q_D")
    e.rod("R_12", mpc(0), A)
    return e


def two_blocks(equilibrium=Equilibrium):
    u = deg(50)
    X = mpc(q("0.2") / im(u) * re(u), "0.2")
    e = equilibrium([2, 3, 4])
    e.hinge(1, 2, 0), e.hinge(3, 4, X), e.couple("M_2", 1, 2)
    e.unknown("N_p", 2, 3, X, I * u), e.couple("M_p", 2, 3)
    e.unknown("N_q", 1, 4, X, I), e.couple("M_q", 1, 4)
    e.load(4, X + mpc("0.05", "0.01"), mpc(-60, 25), "Q_D"), e.load_couple(3, 2, "T_3")
    return e


# What rubs: its coefficient, the line and what slides on it, and its coordinate along the line as its drive goes on.
def crank(radius, degrees, coordinate):
    return lambda t: coordinate(radius * expj(pi * mpf(degrees) / 180 + t))


TAN_8 = tan(pi * 8 / 180)
FRICTION = {
    "slider-crank": (slider_crank, {
        "b": (q("0.15"), "gb", crank(q("0.12"), 75, lambda A: re(A) + sqrt(q("0.16") - (im(A) + q("0.05")) ** 2)))}),
    "scotch-yoke": (scotch_yoke, {
        "A": (q("0.2"), "sA", crank(q("0.1"), 35, im)), "b": (TAN_8, "gb", crank(q("0.1"), 35, re))}),
    "oldham": (oldham, {
        "q": (q("0.1"), "pq", lambda t: re(q("0.03") * conj(deg(25) * expj(t)))),
        "s": (q("0.3"), "ts", lambda t: re((re(q("0.03") * conj(deg(25) * expj(t))) * deg(25) * expj(t) - q("0.03"))
                                          * conj(I * deg(25) * expj(t))))}),
    "trammel": (trammel, {
        "A": (q("0.25"), "xA", lambda t: q("0.6") + t),
        "B": (q("0.25"), "yB", lambda t: sqrt(1 - (q("0.6") + t) ** 2))}),
    "oscillating-cylinder": (oscillating_cylinder, {
        "p": (q("0.12"), "sp", crank(q("0.08"), 70, lambda A: abs(A - mpc("0.32"))))}),
    "cardan-circles": (cardan_circles, {"A": (q("0.1"), "xA", crank(q("0.15"), 35, lambda M: 2 * re(M)))}),
    "geneva": (geneva, {"A": (q("0.15"), "sA", crank(q("0.1"), 150, lambda A: abs(A + mpc("0.2"))))}),
    "driven-piston": (driven_piston, {"b": (q("0.2"), "gb", lambda t: t)}),
    "two-blocks": (two_blocks, {
        "p": (q("0.1"), "sp", lambda t: q("0.2") / im(deg(50) * expj(t))),
        "q": (TAN_8, "gq", lambda t: q("0.2") * re(deg(50) * expj(t)) / im(deg(50) * expj(t)))}),
}


def still(t):
    return mpf(0)


def four_bar_joint(t):
    return left_joint(q("0.12") * deg(60) * expj(t), mpc("0.4"), q("0.35"), q("0.28"))


def slider(t):
    A = q("0.12") * deg(75) * expj(t)
    return re(A) + sqrt(q("0.16") - (im(A) + q("0.05")) ** 2) - q("0.05") * I


def four_bar_circles(A0, A, B, B0):
    return four_bar, {}, {
        (1, 2): (still, lambda t: t, q(A0)),
        (2, 3): (lambda t: t, lambda t: arg(four_bar_joint(t) - q("0.12") * deg(60) * expj(t)), q(A)),
        (3, 4): (lambda t: arg(four_bar_joint(t) - q("0.12") * deg(60) * expj(t)),
                 lambda t: arg(four_bar_joint(t) - q("0.4")), q(B)),
        (1, 4): (still, lambda t: arg(four_bar_joint(t) - q("0.4")), q(B0))}


CIRCLES = {
    "four-bar-with-circles": four_bar_circles("0.004", "0.005", "0.006", "0.003"),
    "four-bar-with-large-circles": four_bar_circles("0.04", "0.1", "0.12", "0.1"),
    "slider-crank-with-circles": (slider_crank, FRICTION["slider-crank"][1], {
        (1, 2): (still, lambda t: t, q("0.004")),
        (2, 3): (lambda t: t, lambda t: arg(slider(t) - q("0.12") * deg(75) * expj(t)), q("0.006")),
        (3, 4): (lambda t: arg(slider(t) - q("0.12") * deg(75) * expj(t)), still, q("0.005"))}),
}


def wheel_pair(equilibrium=Equilibrium):
    B = mpc("0.09", "0.12")
    e = equilibrium([2, 3])
    e.hinge(1, 2, 0), e.hinge(1, 3, B), e.couple("M_2", 1, 2)
    e.teeth(2, 3, B / 3, B)
    e.load_couple(3, -30, "T_3")
    return e


def ring_wheel(equilibrium=Equilibrium):
    B = mpc("-0.04")
    e = equilibrium([2, 3])
    e.hinge(1, 2, 0), e.hinge(1, 3, B), e.couple("M_2", 1, 2)
    e.teeth(2, 3, q("0.02"), B, 25, True)
    e.load(3, B + mpc("0.05", "0.01") * deg(10), mpc(-100, 40), "Q_E"), e.load_couple(3, 6, "T_3")
    return e


def geared_five_bar(equilibrium=Equilibrium):
    A, D0 = q("0.05") * deg(40), mpc("0.12")
    D = D0 + q("0.03") * deg(-20)
    B = left_joint(A, D, q("0.14"), q("0.12"))
    e = equilibrium([2, 3, 4, 5])
    e.hinge(1, 2, 0), e.hinge(2, 3, A), e.hinge(3, 4, B), e.hinge(4, 5, D), e.hinge(1, 5, D0), e.couple("M_2", 1, 2)
    e.teeth(2, 5, q("0.08"), D0)
    e.load(3, A + (B - A) / q("0.14") * mpc("0.07", "0.02"), mpc(30, -80), "Q_3"), e.load_couple(5, 4, "T_5")
    e.rod("R_23", A, B)
    return e


def planetary_gear(equilibrium=Equilibrium):
    u = deg(50)
    C = q("0.08") * u
    e = equilibrium([2, 3, 4])
    e.hinge(1, 2, 0), e.hinge(1, 4, 0), e.hinge(2, 3, C), e.couple("M_2", 1, 2)
    e.teeth(1, 3, q("0.12") * u, C), e.teeth(3, 4, q("0.04") * u, 0)
    e.load(3, C + q("0.03") * deg(-100), mpc(40, -25), "Q_P"), e.load_couple(4, 3, "T_4")
    return e


# A pair of wheels, and on the second a crank that pushes a block.
PRESS_AT = mpc("0.15")


def press_pin(t):
    return PRESS_AT + q("0.05") * deg(-40) * expj(-t / 2)


def press_block(t):
    A = press_pin(t)
    return mpc(re(A) + sqrt(q("0.04") - im(A) ** 2), 0)


def geared_press(equilibrium=Equilibrium):
    A, B = press_pin(0), press_block(0)
    e = equilibrium([2, 3, 4, 5])
    e.hinge(1, 2, 0), e.hinge(1, 3, PRESS_AT), e.hinge(3, 4, A), e.hinge(4, 5, B), e.couple("M_2", 1, 2)
    e.teeth(2, 3, q("0.05"), PRESS_AT)
    e.unknown("N_b", 1, 5, B, I), e.couple("M_b", 1, 5)
    e.load(5, B, mpc(-500, 0), "Q_B")
    return e


PRESS = (geared_press, {"23": 20})
TEETH = {
    "wheel-pair": (wheel_pair, {"23": 20}), "ring-wheel": (ring_wheel, {"23": 25}),
    "geared-five-bar": (geared_five_bar, {"25": 20}), "planetary-gear": (planetary_gear, {"13": 20, "34": 20}),
    "geared-press": PRESS,
}


def text(x):
    return "0" if abs(x) < ZERO else nstr(x, 40, strip_zeros=True)


print("""# Reactions and driving efforts of scenes under loads, 40 digits. Written by make_scene_forces.py with
# mpmath; do not edit by hand. Nothing here is taken from the C++ code.
""")
for name, case in (("four-bar", four_bar), ("slider-crank", slider_crank), ("scotch-yoke", scotch_yoke),
                   ("oldham", oldham), ("trammel", trammel), ("excavator", excavator),
                   ("oscillating-cylinder", oscillating_cylinder), ("cardan-circles", cardan_circles),
                   ("geneva", geneva), ("jansen", jansen), ("driven-piston", driven_piston),
                   ("two-blocks", two_blocks)):
    print(f"case {name}\nwhy the scene of this name, of docs/scenes or of the test, with the loads of the test\ngiven loaded 1")
    for quantity, value in case().values():
        print(quantity, text(value))
    print()
for name, (case, contacts) in FRICTION.items():
    print(f"case {name}-with-friction\nwhy the same with the friction of the test\ngiven loaded 1")
    for quantity, value in with_friction(case, contacts):
        print(quantity, text(value))
    print()
for name, (case, contacts, circles) in CIRCLES.items():
    print(f"case {name}\nwhy the same with the friction circles of the test\ngiven loaded 1")
    for quantity, value in with_circles(case, contacts, circles):
        print(quantity, text(value))
    print()
for name, (case, gears) in TEETH.items():
    print(f"case {name}\nwhy the scene of this name, of docs/scenes or of the test, with the loads of the test\ngiven loaded 1")
    for quantity, value in with_teeth(case, gears):
        print(quantity, text(value))
    print()
print("case geared-press-with-friction\nwhy the same with the friction of the test\ngiven loaded 1")
for quantity, value in with_teeth(*PRESS, {"b": (q("0.2"), "gb", lambda t: re(press_block(t)))}):
    print(quantity, text(value))
print()
