#!/usr/bin/env python3
"""Writes slotted_lever.txt: reference values of the slotted lever and rolling disc, independent of the C++ code.

  make_slotted_lever.py > slotted_lever.txt

Only positions are written down, as functions of time: the lever's angle (given, with its first two derivatives), B
where the slot meets the level y = R, A beyond O, and the disc's angle from the length of guide it has rolled on.
Velocities and accelerations are high-precision numerical derivatives of these; the kinetic energy is differentiated
as a whole; the relative pole is where the points of lever and disc on the guide move alike. The reactions and the
couple C come out of the six equations of Newton and Euler of the two bodies, solved as one linear system; C is then
held against the energies: C ω = d(E_k + E_p)/dt.
"""
from fractions import Fraction

from mpmath import asin, cos, cot, diff, fabs, lu_solve, matrix, mp, mpf, nstr, sin, sqrt

mp.dps = 200
ZERO = mpf(10) ** -80  # what numerical differentiation leaves of a zero is smaller, everything else is larger

STATED = dict(M1="30", M2="20", J2="1", R="1/5", OB="2/5", AO="3/10", omega="1", omega_dot="2/5", g="981/100")
CASES = [
    ("stated", "the exercise as it is stated", {}),
    ("braking", "braking, but the sliding pin still pushes the disc on", dict(omega_dot="-2/5")),
    ("backwards", "turning the other way", dict(omega="-1")),
    ("backwards_speeding_up", "turning the other way, faster and faster", dict(omega="-3/2", omega_dot="-2")),
    ("steady", "steady speed", dict(omega_dot="0")),
    ("starting", "just starting: nothing moves yet", dict(omega="0")),
    ("at_rest", "at rest", dict(omega="0", omega_dot="0")),
    ("upright", "lever upright: the pin does not slide", dict(OB="1/5")),
    ("upright_steady", "lever upright at steady speed: B is not accelerated", dict(OB="1/5", omega_dot="0")),
    ("nearly_upright", "lever nearly upright: the relative pole far away", dict(OB="200001/1000000")),
    ("rational", "sides 3, 4, 5: all is rational", dict(R="3/10", OB="1/2")),
    ("no_acceleration", "sides 3, 4, 5, braking so that B is not accelerated", dict(R="3/10", OB="1/2", omega_dot="-8/3")),
    ("weightless", "no gravity and no acceleration of B: no force on the disc at all",
     dict(R="3/10", OB="1/2", omega_dot="-8/3", g="0")),
    ("lifting_off", "braking so hard that the guide would have to hold the disc down", dict(omega_dot="-20")),
    ("flat", "lever nearly flat", dict(OB="5")),
    ("fast", "fast", dict(omega="100", omega_dot="-30")),
    ("no_mass_at_A", "no mass at A", dict(M1="0")),
    ("no_inertia", "a disc without moment of inertia needs no friction", dict(J2="0")),
    ("micrometres", "micrometres", dict(R="1/500000", OB="1/250000", AO="3/1000000")),
    ("odd", "no round number anywhere", dict(M1="17/7", M2="31/11", J2="5/13", R="19/97", OB="41/83", AO="29/71",
                                             omega="-13/9", omega_dot="23/17", g="979/100")),
]


def number(rational):
    q = Fraction(rational)
    return mpf(q.numerator) / q.denominator


def text(x, size):
    return "0" if fabs(x) <= ZERO * size else nstr(x, 40, strip_zeros=True, min_fixed=-30, max_fixed=30)


class Motion:
    def __init__(self, given):
        for name, value in given.items():
            setattr(self, name, number(value))
        self.start = asin(self.R / self.OB)

    def angle(self, t):
        return self.start - self.omega * t - self.omega_dot * t * t / 2

    def B_x(self, t):
        return self.R * cot(self.angle(t))

    def OB_at(self, t):
        return self.R / sin(self.angle(t))

    def A(self, t):
        return -self.AO * cos(self.angle(t)), -self.AO * sin(self.angle(t))

    def disc_angle(self, t):
        return -(self.B_x(t) - self.B_x(0)) / self.R

    def kinetic_energy(self, t):
        v_A = [diff(lambda s, i=i: self.A(s)[i], t) for i in (0, 1)]
        return (self.M1 * (v_A[0] ** 2 + v_A[1] ** 2) + self.M2 * diff(self.B_x, t) ** 2
                + self.J2 * diff(self.disc_angle, t) ** 2) / 2

    def potential_energy(self, t):
        return self.M1 * self.g * self.A(t)[1]

    def reactions(self):
        """T and N of the guide, S of the slot along (sin, -cos), the frame's force at O, and C clockwise."""
        s, c = sin(self.start), cos(self.start)
        A = self.A(0)
        a_A = [diff(lambda t, i=i: self.A(t)[i], 0, 2) for i in (0, 1)]
        a_B = diff(self.B_x, 0, 2)
        system = matrix([[1, 0, s, 0, 0, 0],        # disc, along x
                         [0, 1, -c, 0, 0, 0],       # disc, upwards
                         [self.R, 0, 0, 0, 0, 0],   # disc, about B
                         [0, 0, -s, 1, 0, 0],       # lever, along x
                         [0, 0, c, 0, 1, 0],        # lever, upwards
                         [0, 0, self.OB, 0, 0, -1]])  # lever, about O: the pin pushes it back
        right = matrix([self.M2 * a_B, self.M2 * self.g, self.J2 * diff(self.disc_angle, 0, 2), self.M1 * a_A[0],
                        self.M1 * (a_A[1] + self.g),
                        self.M1 * (A[0] * (a_A[1] + self.g) - A[1] * a_A[0])])
        return list(lu_solve(system, right))

    def relative_pole(self):
        """The abscissa where lever and disc move alike, from the velocities of two points of the guide's line."""
        moving = Motion.__new__(Motion)
        moving.__dict__.update(self.__dict__, omega=mpf(1), omega_dot=mpf(0))

        def apart(x):
            def lever(t):
                turn = moving.angle(t) - moving.start
                return x * sin(turn)

            def disc(t):
                turn, r = moving.disc_angle(t), x - moving.B_x(0)
                return moving.R + r * sin(turn) - moving.R * cos(turn)
            return diff(lever, 0) - diff(disc, 0)
        at_0, at_1 = apart(mpf(0)), apart(moving.R)
        slope = (at_1 - at_0) / moving.R
        return None if fabs(slope) <= ZERO else -at_0 / slope


def references(given):
    m = Motion(given)
    T, N, S, R_x, R_y, C = m.reactions()
    power = diff(m.kinetic_energy, 0)
    if m.omega != 0:
        by_energies = (power + diff(m.potential_energy, 0)) / m.omega
        assert fabs(C - by_energies) <= mpf(10) ** -60 * (fabs(C) + fabs(power) + 1), (given, C, by_energies)
    lever = m.OB * sqrt(m.omega ** 4 + m.omega_dot ** 2)
    a_A = [diff(lambda t, i=i: m.A(t)[i], 0, 2) for i in (0, 1)]
    b_dot = diff(m.OB_at, 0)
    length = m.OB + m.R
    weight, speed = (m.M1 + m.M2) * m.g + fabs(S) + fabs(T), length * (fabs(m.omega) + 1)
    rate, torque = length * (m.omega ** 2 + fabs(m.omega_dot) + 1), fabs(C) + m.M1 * m.AO * m.g + fabs(power) + 1
    pole = m.relative_pole()
    values = [
        ("lever_angle", m.start, 1), ("B_x", m.B_x(0), length), ("P23_x", pole, length),
        ("v_Bstar", m.OB * fabs(m.omega), speed), ("b_dot", b_dot, speed), ("v_B", diff(m.B_x, 0), speed),
        ("omega_disc", diff(m.disc_angle, 0), speed / m.R), ("a_Bstar", lever, rate),
        ("a_cor", fabs(2 * m.omega * b_dot), rate), ("b_ddot", diff(m.OB_at, 0, 2), rate),
        ("a_B", diff(m.B_x, 0, 2), rate), ("alpha_disc", diff(m.disc_angle, 0, 2), rate / m.R),
        ("kinetic_energy", m.kinetic_energy(0), torque), ("kinetic_power", power, torque),
        ("gravity_torque", m.M1 * m.g * -m.A(0)[0], torque), ("C", C, torque),
        ("slot_force_on_pin", fabs(S), weight + 1), ("ground_normal_force", N, weight + 1),
        ("ground_friction_force", fabs(T), weight + 1),
        ("required_friction_coefficient", fabs(T) / N if N > ZERO * (weight + 1) else "undefined", 1),
        ("pivot_force_x", R_x, weight + 1), ("pivot_force_y", R_y, weight + 1),
        ("pivot_force", sqrt(R_x ** 2 + R_y ** 2), weight + 1),
        ("a_A_x", a_A[0], rate), ("a_A_y", a_A[1], rate), ("a_A", sqrt(a_A[0] ** 2 + a_A[1] ** 2), rate),
    ]
    return [(name, "infinite" if v is None else v if isinstance(v, str) else text(v, size)) for name, v, size in values]


print("""# Reference values of the slotted lever with a rolling disc, 40 digits. Written by make_slotted_lever.py with mpmath,
# 200 working digits; do not edit by hand. Positions are the only formulas; what moves is differentiated numerically,
# the reactions solve the six equations of Newton and Euler, and C agrees with the energies' derivatives.
# Nothing here is taken from the C++ code.
#
# omega, omega_dot and C are clockwise positive, omega_disc and alpha_disc counter-clockwise. SI units, radians.
# v_B, a_B, b_dot, b_ddot, ground_normal_force and components are signed, the other vectors are magnitudes.""")
for name, why, changed in CASES:
    given = {**STATED, **changed}
    print(f"\ncase {name}\nwhy {why}")
    for symbol, value in given.items():
        print(f"given {symbol} {value}")
    for quantity, value in references(given):
        print(f"{quantity} {value}")
