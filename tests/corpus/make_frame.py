#!/usr/bin/env python3
"""Writes frame.txt: reference values of the frame loaded across its plane, independent of the C++ code.

  make_frame.py > frame.txt

The torsion constant is found without a series of tanh: the Dirichlet problem of the stress function is the time
integral of a plate that cools, J_t = 4 * integral of its heat, and the heat of a rectangle is the product of those of
two strips. The integral is taken numerically; the strips by images while they are hot, by harmonics later.
Moments are cross products of vectors in space, integrated numerically along the bars to the elastic energy;
displacements and rotations are its derivatives by loads (Castigliano), those of dummy ones where there is none.
"""
from fractions import Fraction

from mpmath import erfc, exp, fabs, findroot, mp, mpf, nint, nstr, pi, quad, sqrt, tanh, zeta

mp.dps = 90
STATED = dict(L_1="1200", L_2="800", phi="50", s_r="10", H_r="50", P="300", E="210000", nu="3/10")


def number(rational):
    q = Fraction(rational)
    return mpf(q.numerator) / q.denominator


# Of a strip 0 < x < a at 1 whose edges are kept at 0.
def heat_of_strip(a, t):
    total, k = mpf(0), 1
    if 16 * t < a * a:
        while True:
            x = k * a / (2 * sqrt(t))
            term = (-1) ** k * (exp(-x * x) / sqrt(pi) - x * erfc(x))
            total += term
            if fabs(term) < mpf(10) ** -95:
                return a - 4 * sqrt(t) * (1 / sqrt(pi) + 2 * total)
            k += 1
    while True:
        term = exp(-(k * pi / a) ** 2 * t) / k ** 2
        total += term
        if term < mpf(10) ** -95:
            return 8 * a / pi ** 2 * total
        k += 2


def torsion_constant(width, thickness):
    a, b = max(width, thickness), min(width, thickness)
    heat = lambda s: 2 * s * heat_of_strip(a / b, s * s) * heat_of_strip(mpf(1), s * s)
    # Hot as far as e^{-pi^2 t} is above 1e-95.
    last = sqrt(230 / pi ** 2)
    points = [mpf(0), mpf("0.02"), mpf("0.05"), mpf("0.1"), mpf("0.18"), mpf("0.25"), mpf("0.4"), mpf("0.7"), mpf(1),
              mpf("1.5"), mpf(2), mpf(3), mpf(4), last]
    return 4 * b ** 4 * quad(heat, points, maxdegree=9)


def by_series(width, thickness):
    a, b = width, thickness
    x = pi * a / (2 * b)
    total = mpf(31) / 32 * zeta(5)
    k = 1
    while 2 * k * x < 240:
        total -= 2 / (k ** 5 * (exp(2 * k * x) + 1))
        k += 2
    return a * b ** 3 * (mpf(1) / 3 - 64 / pi ** 5 * b / a * total)


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def dot(u, v):
    return sum(p * q for p, q in zip(u, v))


class Frame:
    def __init__(self, given, J_t1=None):
        mm, MPa = mpf(1) / 1000, mpf(10) ** 6
        g = {name: number(value) for name, value in given.items()}
        self.L1, self.L2, phi, s, H = [g[n] * mm for n in ("L_1", "L_2", "phi", "s_r", "H_r")]
        self.P, E, nu = g["P"], g["E"] * MPa, g["nu"]
        G = E / (2 * (1 + nu))
        r = phi / 2
        J_x1, J_y1 = quad(lambda y: s * y * y, [-H / 2, H / 2]), quad(lambda x: H * x * x, [-s / 2, s / 2])
        self.J_t1 = J_t1 if J_t1 is not None else torsion_constant(H, s)
        assert fabs(self.J_t1 / by_series(H, s) - 1) < mpf(10) ** -70, nstr(self.J_t1 / by_series(H, s) - 1, 5)
        J_p2 = quad(lambda x: 2 * pi * x ** 3, [0, r])
        self.section = dict(G=G, J_x1=J_x1, J_y1=J_y1, J_p1=J_x1 + J_y1, J_t1=self.J_t1, J_x2=J_p2 / 2, J_p2=J_p2)
        self.stiffness = [(E * J_x1, G * self.J_t1), (E * J_p2 / 2, G * J_p2), (E * J_x1, G * self.J_t1)]
        self.nodes = [[0, 0, 0], [self.L2, 0, 0], [self.L2, self.L1, 0], [0, self.L1, 0]]
        self.tangents = [[1, 0, 0], [0, 1, 0], [-1, 0, 0]]
        self.lengths = [self.L2, self.L1, self.L2]

    def at(self, bar, x):
        return [p + x * t for p, t in zip(self.nodes[bar], self.tangents[bar])]

    # On the face towards the clamp, of the load and of a dummy force and couple in a node.
    def moment(self, bar, x, P, dummy=None):
        here = self.at(bar, x)
        M = cross([p - q for p, q in zip(self.nodes[3], here)], [0, 0, -P])
        if dummy and dummy[0] > bar:
            node, force, couple = dummy
            M = [m + c + d for m, c, d in zip(M, couple, cross([p - q for p, q in zip(self.nodes[node], here)], force))]
        return M

    # Bending and torsion as the source counts them.
    def components(self, bar, x, P, dummy=None):
        M, t = self.moment(bar, x, P, dummy), self.tangents[bar]
        across = cross([0, 0, 1], t)
        return -dot(M, across), -dot(M, t)

    def energy_of_bar(self, bar, P, dummy=None):
        bending, torsion = self.stiffness[bar]

        def density(x):
            M_x, M_z = self.components(bar, x, P, dummy)
            return M_x ** 2 / (2 * bending) + M_z ** 2 / (2 * torsion)

        return quad(density, [0, self.lengths[bar]], maxdegree=4)

    # The derivative of a quadratic function.
    def moved(self, node, force, couple):
        scale = self.P
        unit = lambda sign: (node, [sign * scale * f for f in force], [sign * scale * c for c in couple])
        energy = lambda dummy: sum(self.energy_of_bar(i, self.P, dummy) for i in range(3))
        return (energy(unit(1)) - energy(unit(-1))) / (2 * scale)

    def values(self):
        P, found = self.P, dict(self.section)
        on_clamp = self.moment(0, 0, P)
        found.update(R_O_z=P, M_O_x=-on_clamp[0], M_O_y=-on_clamp[1], T_y=P)
        letters = "OBCA"
        for i in range(3):
            for where, x in ((letters[i], 0), ("mid", self.lengths[i] / 2), (letters[i + 1], self.lengths[i])):
                M_x, M_z = self.components(i, x, P)
                found["M_x_" + where if where in "OA" else f"M_x_{where}_bar_{i + 1}"] = M_x
            found[f"M_z_bar_{i + 1}"] = M_z
        for i in range(1, 4):
            found[f"theta_{letters[i]}_x"] = self.moved(i, [0, 0, 0], [1, 0, 0])
            found[f"theta_{letters[i]}_y"] = self.moved(i, [0, 0, 0], [0, 1, 0])
            found[f"w_{letters[i]}"] = self.moved(i, [0, 0, 1], [0, 0, 0])
            found[f"U_{i}"] = self.energy_of_bar(i - 1, P)
            bending, torsion = self.stiffness[i - 1]
            squares = [quad(lambda x: self.components(i - 1, x, P)[k] ** 2, [0, self.lengths[i - 1]], maxdegree=4)
                       for k in (0, 1)]
            found[f"delta_bending_{i}"] = squares[0] / bending / P
            if i < 3:
                found[f"delta_torsion_{i}"] = squares[1] / torsion / P
        found["U"] = found["U_1"] + found["U_2"] + found["U_3"]
        found["delta_A"] = -found["w_A"]
        return found


# The length of bars 1 and 3 at which C stays on its level, to so many digits of a millimetre's fraction.
def level_C(digits):
    L1, phi, s, H, E, nu = [number(STATED[n]) for n in ("L_1", "phi", "s_r", "H_r", "E", "nu")]
    J_t, J_x1, J_x2 = torsion_constant(H, s), s * H ** 3 / 12, pi * phi ** 4 / 64
    w_C = lambda L2: L2 ** 3 / (6 * J_x1) - 2 * (1 + nu) * L1 ** 2 * L2 / J_t - L1 ** 3 / (3 * J_x2)
    root = findroot(w_C, mpf(12600))
    return str(Fraction(int(nint(root * mpf(10) ** digits)), 10 ** digits))


CASES = [
    ("stated", "the exercise as it is stated", {}),
    ("square", "a square section", dict(s_r="30", H_r="30")),
    ("lying", "the rectangle lies: wider than high", dict(s_r="60", H_r="12")),
    ("strip", "a strip 100 times as high as wide", dict(s_r="2", H_r="200")),
    ("nearly_square", "nearly a square", dict(s_r="1000001/50000", H_r="20")),
    ("stiff", "hardly any bar 2", dict(L_1="1")),
    ("short", "short bars 1 and 3", dict(L_2="7")),
    ("thin", "a thin bar 2", dict(phi="3/2")),
    ("incompressible", "as Poisson's ratio can be at most", dict(nu="1/2")),
    ("auxetic", "a negative Poisson's ratio", dict(nu="-9/10")),
    ("level_C_by_1e-9", "C nearly stays on its level, to 9 digits", dict(L_2=level_C(5))),
    ("level_C_by_1e-30", "C nearly stays on its level, to 30 digits", dict(L_2=level_C(26))),
    ("odd", "no round number anywhere", dict(L_1="9871/7", L_2="3571/11", phi="283/9", s_r="97/13", H_r="479/17",
                                             P="1009/3", E="70123", nu="1/3")),
    ("micrometres", "micrometres", dict(L_1="12/1000", L_2="8/1000", phi="1/2000", s_r="1/10000", H_r="1/2000",
                                        P="1/1000000")),
]

print("""# Reference values of the frame loaded across its plane, 40 digits. Written by make_frame.py with mpmath, 90 working
# digits; do not edit by hand. The torsion constant is an integral over time of a cooling plate, moments are cross
# products in space, displacements derivatives of the elastic energy. Nothing here is taken from the C++ code.
#
# Givens in mm, N, MPa; values in SI units.""")
for name, why, changed in CASES:
    given = {**STATED, **changed}
    print(f"\ncase {name}\nwhy {why}")
    for symbol, value in given.items():
        print(f"given {symbol} {value}")
    values = Frame(given).values()
    size = max(fabs(v) for v in values.values())
    for quantity, value in values.items():
        print(quantity, "0" if fabs(value) < mpf(10) ** -75 else nstr(value, 40, min_fixed=-30, max_fixed=30))
