#!/usr/bin/env python3
"""Writes linkages.txt: reference values of the scenes in docs/scenes, independent of the C++ code.

Only positions are written down here, each mechanism by formulas of its own (complex numbers, the law of cosines), as
functions of time. Velocities, accelerations and angular velocities are high-precision numerical derivatives of them
(mpmath.diff): no polygon, no system of equations, and no file of docs/scenes is read.
Usage: make_linkages.py > linkages.txt
"""
from equilibrium import Equilibrium, with_circles, with_teeth
from mpmath import conj, diff, expj, im, log, mp, mpc, mpf, nstr, pi, re, sqrt, tan

mp.dps = 120
DIGITS = 40
ZERO = mpf(10) ** -60
I = mpc(0, 1)


def q(text):
    a, _, b = text.partition("/")
    return mpf(a) / mpf(b or 1)


def deg(x):
    return pi * q(x) / 180


def rpm(x):
    return 2 * pi * q(x) / 60


def crank(angle, omega, alpha=mpf(0)):
    return lambda t: expj(angle + omega * t + alpha * t ** 2 / 2)


def left_joint(P, Q, a, b):
    """The point at a from P and b from Q, on the left of P -> Q."""
    d = abs(Q - P)
    x = (a ** 2 - b ** 2 + d ** 2) / (2 * d)
    return P + (Q - P) / d * (x + I * sqrt(a ** 2 - x ** 2))


def right_joint(P, Q, a, b):
    return conj(left_joint(conj(P), conj(Q), a, b))


def loaded_four_bar():
    scene = four_bar()
    scene.paths = []
    A, B, P, B0 = (scene.point(X)(mpf(0)) for X in ("A", "B", "P", q("0.4")))
    e = Equilibrium([2, 3, 4])
    e.hinge(1, 2, 0), e.hinge(2, 3, A), e.hinge(3, 4, B), e.hinge(1, 4, B0), e.couple("M_2", 1, 2)
    e.load(3, P, 200 * expj(deg("-100"))), e.load_couple(4, mpf(-20))
    e.rod("R_23", A, B), e.rod("R_14", B0, B)
    e.arm("h_F", expj(deg("-100")), P, B), e.arm("h_R_23", "R_23", A, 0)
    scene.forces = e
    return scene


def cutting_stroke():
    scene = quick_return("75")
    A, B, C = (scene.point(X)(mpf(0)) for X in "ABC")
    e = Equilibrium([2, 4, 5])
    e.hinge(1, 2, I * q("0.3")), e.hinge(1, 4, 0), e.hinge(4, 5, B), e.couple("M_2", 1, 2)
    e.unknown("N_A", 4, 2, A, I * A / abs(A)), e.unknown("N_C", 1, 5, C, I)
    e.load(5, C, mpf(1500))
    e.arm("h_R_45", "R_45", B, 0), e.arm("h_N_A", I * A, A, 0), e.arm("h_N_A_on_2", I * A, A, I * q("0.3"))
    scene.forces = e
    return scene


def engine():
    """Inertia forces from the derivatives of places."""
    e, r, l = crank(deg("150"), rpm("1500")), q("0.06"), q("0.22")
    A, S = lambda t: r * e(t), lambda t: r / 4 * e(t)
    B = lambda t: mpc(0, im(A(t)) + sqrt(l ** 2 - re(A(t)) ** 2))
    G = lambda t: A(t) + (B(t) - A(t)) / 3
    scene = Scene(dict(A=A, S=S, B=B, G=G), {2: (e, A), 3: (lambda t: B(t) - A(t), A), 4: (still, B)},
                  rods=[("A", 0), ("B", "A")], floating=[3, 4])
    g, m, J_3 = q("9.81"), {2: mpf(2), 3: q("1.2"), 4: q("0.9")}, q("0.0085")
    alpha_3 = diff(lambda t: im(log(B(t) - A(t))), 0, 2)
    a, s, b, c = (P(mpf(0)) for P in (A, S, B, G))
    f = Equilibrium([2, 3, 4])
    f.hinge(1, 2, 0), f.hinge(2, 3, a), f.hinge(3, 4, b), f.couple("M_2", 1, 2)
    f.unknown("N_b", 1, 4, b, -1), f.couple("M_b", 1, 4)
    f.load(4, b, mpc(0, -3000))
    for link, X in ((2, S), (3, G), (4, B)):
        f.load(link, X(mpf(0)), mpc(0, -m[link] * g), f"W_{link}")
        f.load(link, X(mpf(0)), -m[link] * derivative(X, 2), f"F_{link}")
    f.load_couple(3, -J_3 * alpha_3, "C_3")
    f.rod("R_23", a, b)
    f.arm("h_W_3", I, c, b), f.arm("h_F_3", derivative(G, 2), c, b)
    f.arm("h_W_2", I, s, 0), f.arm("h_R_23", "R_23", a, 0)
    scene.forces = f
    return scene


def still(t):
    return mpc(1)


def on_plate(P, X, reach, own):
    """The point of a plate that has P in its origin and X at `reach` on its x axis."""
    return P + (X - P) / reach * own


def four_bar():
    e = crank(deg("60"), rpm("60"))
    A = lambda t: q("0.12") * e(t)
    B = lambda t: left_joint(A(t), q("0.4"), q("0.35"), q("0.28"))
    return Scene(dict(A=A, B=B, P=lambda t: on_plate(A(t), B(t), q("0.35"), mpc(q("0.175"), q("0.1")))),
                 {2: (e, A), 3: (lambda t: B(t) - A(t), A), 4: (lambda t: B(t) - q("0.4"), B)},
                 rods=[("A", 0), ("B", "A"), ("B", q("0.4"))], floating=[3], paths=["P"])


def quick_return(angle="-75"):
    e = crank(deg(angle), rpm("60"))
    A = lambda t: I * q("0.3") + q("0.175") * e(t)
    B = lambda t: A(t) / abs(A(t)) * q("0.7")
    C = lambda t: mpc(re(B(t)) + sqrt(q("0.8") ** 2 - (q("0.65") - im(B(t))) ** 2), q("0.65"))
    return Scene(dict(A=A, B=B, C=C), {2: (e, A), 4: (A, B), 5: (lambda t: C(t) - B(t), B)},
                 rods=[("A", I * q("0.3")), ("A", 4, 0), ("C", "B")], slides=[("A", 4, True, False)],
                 floating=[5])


def slider_crank():
    e = crank(deg("75"), rpm("300"), mpf(20))
    A = lambda t: q("0.12") * e(t)
    B = lambda t: mpc(re(A(t)) + sqrt(q("0.4") ** 2 - (im(A(t)) + q("0.05")) ** 2), -q("0.05"))
    return Scene(dict(A=A, B=B, G=lambda t: on_plate(A(t), B(t), q("0.4"), mpc(q("0.4") / 3, q("0.04")))),
                 {2: (e, A), 3: (lambda t: B(t) - A(t), A), 4: (still, B)}, rods=[("A", 0), ("B", "A")],
                 floating=[3, 4])


def scotch_yoke():
    e = crank(deg("35"), rpm("90"))
    A = lambda t: q("0.1") * e(t)
    C = lambda t: mpc(re(A(t)) + q("0.25"), 0)
    return Scene(dict(A=A, C=C), {2: (e, A), 3: (still, C)}, rods=[("A", 0)], slides=[("A", 3, False, True)],
                 floating=[3])


def plunger_pump():
    e, r, l = crank(deg("50"), -rpm("90")), q("0.08"), q("0.26")
    A = lambda t: r * e(t)
    B = lambda t: mpc(re(A(t)) + sqrt(l ** 2 - im(A(t)) ** 2), 0)
    scene = Scene(dict(A=A, B=B), {2: (e, A), 3: (lambda t: B(t) - A(t), A), 4: (still, B)},
                  rods=[("A", 0), ("B", "A")], floating=[3, 4])

    def forces(equilibrium=Equilibrium):
        a, b = A(mpf(0)), B(mpf(0))
        f = equilibrium([2, 3, 4])
        f.hinge(1, 2, 0), f.hinge(2, 3, a), f.hinge(3, 4, b), f.couple("M_2", 1, 2)
        f.unknown("N_b", 1, 4, b, 1j), f.couple("M_b", 1, 4)
        f.load(4, b, mpc(-600, 0))
        f.rod("R_23", a, b)
        f.arm("h_R_23", "R_23", a, 0)
        return f

    class Rubbing:
        def values(self):
            at_rest = lambda t: mpf(0)
            of_crank, of_rod = lambda t: im(log(A(t))), lambda t: im(log(B(t) - A(t)))
            return with_circles(forces, {"b": (tan(pi * 8 / 180), "gb", lambda t: re(B(t)))}, {
                (1, 2): (at_rest, of_crank, q("0.003")), (2, 3): (of_crank, of_rod, q("0.004")),
                (3, 4): (of_rod, at_rest, q("0.003"))})
    scene.forces = Rubbing()
    return scene


def watt():
    # Shapes from the drawing: A stands there at t = 0, and turns with 10 rad/s about A0.
    drawn = dict(A0=0, B0=q("0.4"), A=mpc(q("0.06"), q("0.104")), B=mpc(q("0.33"), q("0.28")),
                 C=mpc(q("0.18"), q("0.3")), D=mpc(q("0.48"), q("0.25")), E=mpc(q("0.42"), q("0.48")))
    d = {k: mpc(v) for k, v in drawn.items()}
    far = lambda x, y: abs(d[x] - d[y])
    e = crank(mpf(0), mpf(10))
    A = lambda t: d["A"] * e(t)
    B = lambda t: left_joint(A(t), d["B0"], far("A", "B"), far("B", "B0"))
    C = lambda t: A(t) + (B(t) - A(t)) * (d["C"] - d["A"]) / (d["B"] - d["A"])
    D = lambda t: d["B0"] + (B(t) - d["B0"]) * (d["D"] - d["B0"]) / (d["B"] - d["B0"])
    E = lambda t: left_joint(C(t), D(t), far("C", "E"), far("E", "D"))
    scene = Scene(dict(A=A, B=B, C=C, D=D, E=E),
                  {2: (e, A), 3: (lambda t: B(t) - A(t), A), 4: (lambda t: B(t) - d["B0"], B),
                   5: (lambda t: E(t) - C(t), C), 6: (lambda t: E(t) - D(t), D)},
                  rods=[("A", 0), ("B", "A"), ("B", d["B0"]), ("E", "C"), ("E", "D")], floating=[3, 5, 6])
    scene.is_from_drawing = True
    return scene


def jansen():
    mm = mpf(1) / 1000
    e = crank(deg("100"), rpm("30"))
    Q = mpc(-38, "-7.8") * mm
    A = lambda t: 15 * mm * e(t)
    B = lambda t: right_joint(A(t), Q, 50 * mm, q("41.5") * mm)
    D = lambda t: left_joint(A(t), Q, q("61.9") * mm, q("39.3") * mm)
    C = lambda t: on_plate(Q, B(t), q("41.5") * mm, mpc("2.61", "40.015") * mm)
    E = lambda t: right_joint(C(t), D(t), q("39.4") * mm, q("36.7") * mm)
    F = lambda t: on_plate(D(t), E(t), q("36.7") * mm, mpc("44.447", "48.383") * mm)
    return Scene(dict(A=A, B=B, C=C, D=D, E=E, F=F),
                 {2: (e, A), 3: (lambda t: B(t) - A(t), A), 4: (lambda t: B(t) - Q, B), 5: (lambda t: D(t) - A(t), A),
                  6: (lambda t: D(t) - Q, D), 7: (lambda t: E(t) - C(t), C), 8: (lambda t: E(t) - D(t), D)},
                 rods=[("A", 0), ("B", "A"), ("B", Q), ("D", "A"), ("D", Q), ("E", "C"), ("E", "D")],
                 floating=[3, 5, 7, 8], paths=["F"])


def excavator():
    P = mpc("0.5", "-0.2")
    own_Q, own_R = mpc(2, "0.3"), mpc(-1, "0.25")
    Q = lambda t: left_joint(mpc(0), P, abs(own_Q), q("1.8") + q("0.2") * t)
    boom = lambda t: Q(t) / own_Q
    B = lambda t: 4 * boom(t)
    R = lambda t: right_joint(B(t), Q(t), abs(own_R), q("1.4") - q("0.1") * t)
    stick = lambda t: (R(t) - B(t)) / own_R
    return Scene(dict(Q=Q, B=B, R=R, T=lambda t: B(t) + 2 * stick(t)), {2: (boom, B), 3: (stick, B)},
                 rods=[("Q", 0), ("R", "B")], cylinders=[("Q", P, "P"), ("R", "Q", "Q")], floating=[3])


def oldham():
    # The cross lies where the line of one shaft, along e, and that of the other, across it, meet.
    e = crank(deg("25"), rpm("120"))
    d = q("0.03")
    C = lambda t: re(d * conj(e(t))) * e(t)
    return Scene(dict(C=C), {2: (e, lambda t: mpc(0)), 3: (e, C), 4: (e, lambda t: mpc(d))},
                 rods=[("C", 2, 0), ("C", 4, d)], slides=[("C", 2, True, False), ("C", 4, True, False)],
                 floating=[3])


def trammel():
    A = lambda t: mpc(q("0.6") + q("0.5") * t, 0)
    B = lambda t: I * sqrt(1 - re(A(t)) ** 2)
    return Scene(dict(A=A, B=B, P=lambda t: A(t) + (B(t) - A(t)) / 3), {2: (lambda t: B(t) - A(t), A)},
                 rods=[("B", "A")], floating=[2], paths=["P"])


def parallelogram():
    e = crank(deg("50"), rpm("30"))
    A = lambda t: q("0.2") * e(t)
    B = lambda t: A(t) + q("0.5")
    C = lambda t: A(t) + mpc(q("0.25"), q("0.15"))
    return Scene(dict(A=A, B=B, C=C), {2: (e, A), 3: (still, A), 4: (e, B)},
                 rods=[("A", 0), ("B", "A"), ("B", q("0.5"))], floating=[3])


def stephenson():
    e = crank(deg("50"), rpm("120"))
    E0 = mpc("0.21", "0.18")
    A = lambda t: q("0.06") * e(t)
    B = lambda t: left_joint(A(t), q("0.18"), q("0.15"), q("0.14"))
    C = lambda t: on_plate(A(t), B(t), q("0.15"), mpc("0.09", "0.1"))
    E = lambda t: left_joint(C(t), E0, q("0.19"), q("0.12"))
    return Scene(dict(A=A, B=B, C=C, E=E),
                 {2: (e, A), 3: (lambda t: B(t) - A(t), A), 4: (lambda t: B(t) - q("0.18"), B),
                  5: (lambda t: E(t) - C(t), C), 6: (lambda t: E(t) - E0, E)},
                 rods=[("A", 0), ("B", "A"), ("B", q("0.18")), ("E", "C"), ("E", E0)], floating=[3, 5])


def peaucellier():
    # The inverse of A in the circle of radius sqrt(l^2 - s^2) about O, and the rhombus about the middle of A and P.
    e = crank(deg("60"), rpm("30"))
    A = lambda t: q("0.1") + q("0.1") * e(t)
    P = lambda t: (q("0.26") ** 2 - q("0.1") ** 2) / conj(A(t))
    half = lambda t: I * A(t) / abs(A(t)) * sqrt(q("0.1") ** 2 - abs(P(t) - A(t)) ** 2 / 4)
    B = lambda t: (A(t) + P(t)) / 2 + half(t)
    D = lambda t: (A(t) + P(t)) / 2 - half(t)
    x = (q("0.26") ** 2 - q("0.1") ** 2) / q("0.2")
    return Scene(dict(A=A, B=B, D=D, P=P),
                 {2: (e, A), 3: (B, B), 4: (D, D), 5: (lambda t: B(t) - A(t), A), 6: (lambda t: D(t) - A(t), A),
                  7: (lambda t: P(t) - B(t), B), 8: (lambda t: P(t) - D(t), D)},
                 rods=[("A", q("0.1")), ("B", 0), ("B", "A"), ("D", 0), ("D", "A"), ("P", "B"), ("P", "D")],
                 offsets=[("e", "P", x, I)], floating=[5, 6, 7, 8], paths=["P"])


def chebyshev():
    # A and B are 0.1 apart, and as far from the pivots: of the two places the one where the cranks cross.
    e = crank(deg("45"), rpm("30"))
    A = lambda t: q("0.25") * e(t)
    B = lambda t: right_joint(A(t), q("0.2"), q("0.1"), q("0.25"))
    P = lambda t: (A(t) + B(t)) / 2
    return Scene(dict(A=A, B=B, P=P),
                 {2: (e, A), 3: (lambda t: B(t) - A(t), A), 4: (lambda t: B(t) - q("0.2"), B)},
                 rods=[("A", 0), ("B", "A"), ("B", q("0.2"))], offsets=[("e", "P", mpc(0, "0.2"), 1)],
                 floating=[3], paths=["P"])


def roberts():
    e = crank(deg("75"), rpm("20"))
    A = lambda t: q("0.26") * e(t)
    B = lambda t: left_joint(A(t), q("0.4"), q("0.2"), q("0.26"))
    P = lambda t: on_plate(A(t), B(t), q("0.2"), mpc("0.1", "-0.24"))
    return Scene(dict(A=A, B=B, P=P),
                 {2: (e, A), 3: (lambda t: B(t) - A(t), A), 4: (lambda t: B(t) - q("0.4"), B)},
                 rods=[("A", 0), ("B", "A"), ("B", q("0.4"))], offsets=[("e", "P", mpc(0), 1)],
                 floating=[3], paths=["P"])


def cardan():
    # The rod turns as fast as the crank, the other way.
    e = crank(deg("35"), rpm("60"))
    r = q("0.15")
    M = lambda t: r * e(t)
    A = lambda t: mpc(2 * r * re(e(t)), 0)
    B = lambda t: mpc(0, 2 * r * im(e(t)))
    P = lambda t: M(t) + r / 2 * I * conj(e(t))
    return Scene(dict(M=M, A=A, B=B, P=P), {2: (e, M), 3: (lambda t: conj(e(t)), M)}, rods=[("M", 0), ("A", "M")],
                 offsets=[("e", "B", mpc(0), I)], floating=[3], paths=["P"])


def oscillating_cylinder():
    e = crank(deg("70"), rpm("150"))
    C = q("0.32")
    A = lambda t: q("0.08") * e(t)
    K = lambda t: A(t) - (A(t) - C) / abs(A(t) - C) * q("0.24")
    swing = lambda t: A(t) - C
    return Scene(dict(A=A, K=K), {2: (e, A), 3: (swing, lambda t: C), 4: (swing, A)},
                 rods=[("A", 0), ("A", 3, C)], slides=[("A", 3, True, False)], floating=[4])


def geneva():
    e = crank(deg("150"), rpm("60"))
    A = lambda t: q("0.1") * e(t)
    wheel = lambda t: A(t) + q("0.2")
    return Scene(dict(A=A), {2: (e, A), 3: (wheel, lambda t: mpc("-0.2"))}, rods=[("A", 0), ("A", 3, mpc("-0.2"))],
                 slides=[("A", 3, True, False)])


def planetary_gear():
    # Rolling: the planet turns back by the arc of the ring over its own radius; Willis for the sun.
    e = crank(deg("50"), rpm("60"))
    C = lambda t: q("0.08") * e(t)
    planet = lambda t: conj(e(t)) ** 2
    P = lambda t: C(t) + q("0.03") * planet(t)
    return Scene(dict(C=C, P=P), {2: (e, C), 3: (planet, C), 4: (lambda t: e(t) ** 4, lambda t: mpc(0))},
                 floating=[3], paths=["P"])


def winch():
    e = crank(mpf(0), rpm("60"))
    third, twelfth = (lambda t: conj(e(t)) ** (mpf(1) / 3)), (lambda t: e(t) ** (mpf(1) / 12))
    B, C = q("0.2"), q("0.44")
    scene = Scene(dict(T=lambda t: C + q("0.1") * twelfth(t)),
                  {2: (e, lambda t: mpc(0)), 3: (third, lambda t: mpc(B)), 4: (twelfth, lambda t: mpc(C))},
                  rods=[("T", C)])

    def forces(equilibrium=Equilibrium):
        f = equilibrium([2, 3, 4])
        f.hinge(1, 2, 0), f.hinge(1, 3, B), f.hinge(1, 4, C), f.couple("M_2", 1, 2)
        f.teeth(2, 3, mpc("0.05"), B), f.teeth(3, 4, B + q("0.048"), C)
        f.load(4, C + q("0.1"), mpc(0, -1500))
        f.arm("h_R_23", "R_23", q("0.05"), B), f.arm("h_R_23_on_2", "R_23", q("0.05"), 0)
        f.arm("h_R_34", "R_34", B + q("0.048"), C), f.arm("h_R_34_on_3", "R_34", B + q("0.048"), B)
        f.arm("h_F", mpc(0, -1500), C + q("0.1"), C)
        return f

    class Meshing:
        def values(self):
            return with_teeth(forces, {"23": 20, "34": 20})
    scene.forces = Meshing()
    return scene


def cardan_gear():
    e = crank(deg("35"), rpm("120"))
    C = lambda t: q("0.06") * e(t)
    P = lambda t: mpc(q("0.12") * re(e(t)), 0)
    return Scene(dict(C=C, P=P), {2: (e, C), 3: (lambda t: conj(e(t)), C)}, offsets=[("e", "P", mpc(0), 1)],
                 floating=[3], paths=["P"])


def geared_five_bar():
    e = crank(deg("40"), rpm("60"))
    f = lambda t: expj(deg("60")) / e(t) ** 2
    A = lambda t: q("0.05") * e(t)
    D = lambda t: q("0.12") + q("0.03") * f(t)
    B = lambda t: left_joint(A(t), D(t), q("0.14"), q("0.12"))
    return Scene(dict(A=A, B=B, D=D),
                 {2: (e, A), 3: (lambda t: B(t) - A(t), A), 4: (lambda t: B(t) - D(t), D), 5: (f, D)},
                 rods=[("A", 0), ("B", "A"), ("B", "D"), ("D", q("0.12"))], floating=[3, 4], paths=["B"])


def derivative(f, n):
    if n == 0:
        return f(mpf(0))
    return mpc(diff(lambda t: re(f(t)), 0, n), diff(lambda t: im(f(t)), 0, n))


def text(x):
    return "0" if abs(x) < ZERO else nstr(x, DIGITS, strip_zeros=True)


def along(z, u):
    return abs(re(z * conj(u))) / abs(u)


def across(z, u):
    return abs(im(z * conj(u))) / abs(u)


class Scene:
    """Points and links as functions of time, and what of their relative motion the polygons of the scene show."""

    def __init__(self, points, links, rods=(), slides=(), cylinders=(), offsets=(), floating=(), paths=()):
        self.points, self.links = points, {1: (still, lambda t: mpc(0)), **links}
        self.rods, self.slides, self.cylinders, self.offsets = rods, slides, cylinders, offsets
        self.forces, self.is_from_drawing = None, False
        self.floating, self.paths = floating, paths  # links without a pivot; points whose paths are asked for

    def derivatives(self, f):
        return [derivative(f, n) for n in (0, 1, 2)]

    def point(self, X):
        return self.points[X] if isinstance(X, str) else (lambda t: mpc(X))

    def own(self, X, link):
        """The link's own point that lies under X at t = 0."""
        direction, carried = self.links[link]
        unit = lambda t: direction(t) / abs(direction(t))
        place = (self.point(X)(mpf(0)) - carried(mpf(0))) / unit(mpf(0))
        return lambda t: carried(t) + place * unit(t)

    def values(self):
        yield from self.of_points()
        yield from self.of_links()
        yield from self.of_rods()
        yield from self.of_slides()
        yield from self.of_cylinders()
        yield from self.of_acceleration_centres()
        yield from self.of_paths()
        if self.forces:
            yield from self.forces.values()
        for name, X, through, along in self.offsets:  # left of a line of the frame
            yield name, im((self.point(X)(mpf(0)) - through) * conj(along))

    def of_points(self):
        for letter, z in self.points.items():
            for kind, w in zip(("", "v_", "a_"), self.derivatives(z)):
                yield f"{kind}{letter}_x", re(w)
                yield f"{kind}{letter}_y", im(w)
                if kind:
                    yield f"{kind}{letter}", abs(w)

    def of_links(self):
        turning = {}
        for number, (direction, carried) in self.links.items():
            turn = lambda t: im(log(direction(t)))
            turning[number] = diff(turn, 0, 1), derivative(carried, 1), carried(mpf(0))
            if number > 1:
                # Each direction is that of the link's x axis, but for links taken from a drawing, as they stand there.
                yield f"theta_{number}", mpf(0) if self.is_from_drawing else turn(mpf(0)) * 180 / pi
                yield f"omega_{number}", turning[number][0]
                yield f"alpha_{number}", diff(turn, 0, 2)
        # The point of two links with one velocity: c + i ω P is the same of both.
        for i in turning:
            for j in turning:
                if i >= j:
                    continue
                (w, v, O), (w2, v2, O2) = turning[i], turning[j]
                P = I * ((v - I * w * O) - (v2 - I * w2 * O2)) / (w - w2) if abs(w - w2) > ZERO else None
                apart = "_" if i > 1 and j > 9 else ""
                for axis, part in (("x", re), ("y", im)):
                    yield f"P{i}{apart}{j}_{axis}", "infinite" if P is None else part(P)

    def of_rods(self):
        """X about P, which moves, or rests and is a number; of one whose place is that of a link, (X, link, pivot)."""
        for rod in self.rods:
            X, P = rod[0], rod[-1]
            if len(rod) == 3:
                far, name = self.own(X, rod[1]), f"{X}_on_{rod[1]}"
                yield f"v_{name}", abs(derivative(far, 1))
            else:
                far, name = self.point(X), X if not isinstance(P, str) else X + P
            r, v, a = (x - y for x, y in zip(self.derivatives(far), self.derivatives(self.point(P))))
            if isinstance(P, str):
                yield f"v_{name}", abs(v)
            yield f"a_{name}_n", along(a, r)
            yield f"a_{name}_t", across(a, r)

    def of_slides(self):
        """X over a link."""
        for X, link, has_coriolis, is_whole in self.slides:
            direction = self.links[link][0]
            omega = diff(lambda t: im(log(direction(t))), 0, 1)
            _, v, a = (x - y for x, y in zip(self.derivatives(self.point(X)), self.derivatives(self.own(X, link))))
            yield f"v_{X}_rel_{link}", abs(v)
            if has_coriolis:
                yield f"a_{X}_rel_{link}_c", abs(2 * omega * v)
            yield f"a_{X}_rel_{link}", abs(a - 2 * I * omega * v)
            if is_whole:
                _, v, a = self.derivatives(self.own(X, link))
                yield f"v_{X}_on_{link}", abs(v)
                yield f"a_{X}_on_{link}", abs(a)

    def of_acceleration_centres(self):
        """Where a point of the link has no acceleration: the zero of what is linear in its place."""
        for number in self.floating:
            direction, carried = self.links[number]
            unit = lambda t: direction(t) / abs(direction(t))
            a_O, turned = derivative(carried, 2), derivative(unit, 2) / unit(mpf(0))
            K = carried(mpf(0)) - a_O / turned if abs(turned) > ZERO else None
            for axis, part in (("x", re), ("y", im)):
                yield f"K_{number}_{axis}", "infinite" if K is None else part(K)

    def of_paths(self):
        """Centre and radius of curvature."""
        for X in self.paths:
            z, v, a = self.derivatives(self.point(X))
            bend = im(conj(v) * a)
            centre = z + I * v * abs(v) ** 2 / bend if abs(bend) > ZERO else None
            yield f"rho_{X}", "infinite" if centre is None else abs(centre - z)
            for axis, part in (("x", re), ("y", im)):
                yield f"curvature_centre_{X}_{axis}", "infinite" if centre is None else part(centre)

    def of_cylinders(self):
        for X, P, letter in self.cylinders:
            r, v, a = (x - y for x, y in zip(self.derivatives(self.point(X)), self.derivatives(self.point(P))))
            name, rate = X + letter, im(v / r)
            stretch = re(v / r)
            yield f"v_{name}_s", along(v, r)
            yield f"v_{name}_t", across(v, r)
            yield f"a_{name}_n", abs(rate ** 2 * r)
            yield f"a_{name}_s", abs((re(a / r) + rate ** 2) * r)
            yield f"a_{name}_c", abs(2 * rate * stretch * r)
            yield f"a_{name}_t", abs((im(a / r) - 2 * rate * stretch) * r)


def write(name, file, scene):
    print(f"case {name}\nwhy docs/scenes/{file}.yaml as it stands")
    print("given as_stated 1")
    for quantity, value in scene().values():
        print(quantity, value if isinstance(value, str) else text(value))
    print()


print("""# Reference values of the scenes in docs/scenes, 40 digits. Written by make_linkages.py with mpmath; do not edit by hand.
# Nothing here is taken from the C++ code.
""")
for name, file, scene in (("four-bar", "four-bar", four_bar), ("quick-return", "quick-return", quick_return),
                          ("slider-crank", "slider-crank", slider_crank), ("scotch-yoke", "scotch-yoke", scotch_yoke),
                          ("watt", "watt", watt), ("jansen", "jansen", jansen), ("excavator", "excavator", excavator),
                          ("oldham", "oldham", oldham), ("trammel", "trammel", trammel),
                          ("parallelogram", "parallelogram", parallelogram),
                          ("stephenson", "stephenson", stephenson), ("peaucellier", "peaucellier", peaucellier),
                          ("chebyshev", "chebyshev", chebyshev), ("roberts", "roberts", roberts),
                          ("cardan-circles", "cardan-circles", cardan),
                          ("oscillating-cylinder", "oscillating-cylinder", oscillating_cylinder),
                          ("geneva", "geneva", geneva),
                          ("planetary-gear", "planetary-gear", planetary_gear),
                          ("cardan-gear", "cardan-gear", cardan_gear),
                          ("geared-five-bar", "geared-five-bar", geared_five_bar),
                          ("loaded-four-bar", "loaded-four-bar", loaded_four_bar),
                          ("cutting-stroke", "cutting-stroke", cutting_stroke), ("engine", "engine", engine),
                          ("plunger-pump", "plunger-pump", plunger_pump), ("winch", "winch", winch)):
    write(name, file, scene)
