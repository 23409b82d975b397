"""What the scripts of the hard corpora share: exact givens, truncated power series in time, and the writing.

Velocities and accelerations are the coefficients of such a series, which follow from the formulas of the positions
alone; nothing here is taken from the C++ code.
"""
from fractions import Fraction

from mpmath import cos, fabs, mp, mpc, mpf, nstr, pi, sin, sqrt

mp.dps = 600                # the hardest case loses 1e-30 to the sixth power
DIGITS = 120
ZERO = mpf(10) ** -350      # relative: far below the smallest value, far above the noise


def number(q):
    q = Fraction(q)
    return mpf(q.numerator) / q.denominator


def miss(k):
    """10^-k, exactly."""
    return Fraction(1, 10 ** k)


def rotated(p, half_tangent):
    """p turned by the angle whose half has this tangent, of the length times 1 + t^2: rational."""
    t = Fraction(half_tangent)
    return (p[0] * (1 - t * t) - p[1] * 2 * t, p[0] * 2 * t + p[1] * (1 - t * t))


class Series:
    """c0 + c1 t + c2 t^2 of real or complex coefficients."""

    def __init__(self, *c):
        self.c = [mpc(x) if isinstance(x, (complex, mpc)) else mpf(x) for x in c] + [mpf(0)] * (3 - len(c))

    @staticmethod
    def of(x):
        return x if isinstance(x, Series) else Series(x)

    def __add__(self, other):
        return Series(*(a + b for a, b in zip(self.c, Series.of(other).c)))

    __radd__ = __add__

    def __neg__(self):
        return Series(*(-a for a in self.c))

    def __sub__(self, other):
        return self + (-Series.of(other))

    def __rsub__(self, other):
        return Series.of(other) - self

    def __mul__(self, other):
        a, b = self.c, Series.of(other).c
        return Series(a[0] * b[0], a[0] * b[1] + a[1] * b[0], a[0] * b[2] + a[1] * b[1] + a[2] * b[0])

    __rmul__ = __mul__

    def inverse(self):
        a = self.c
        r0 = 1 / a[0]
        r1 = -a[1] * r0 * r0
        return Series(r0, r1, -(a[1] * r1 + a[2] * r0) * r0)

    def __truediv__(self, other):
        return self * Series.of(other).inverse()

    def __rtruediv__(self, other):
        return Series.of(other) * self.inverse()

    def sqrt(self):
        a = self.c
        r0 = sqrt(a[0])
        r1 = a[1] / (2 * r0)
        return Series(r0, r1, (a[2] - r1 * r1) / (2 * r0))

    def conjugate(self):
        return Series(*(mpc(a).conjugate() for a in self.c))

    def real(self):
        return Series(*(mpc(a).real for a in self.c))

    def imag(self):
        return Series(*(mpc(a).imag for a in self.c))

    def value(self):
        return self.c[0]

    def rate(self):
        return self.c[1]

    def second(self):
        return 2 * self.c[2]


def turning(direction, omega, alpha):
    """The unit vector along `direction` as a complex series: e^{i(omega t + alpha t²/2)} times it."""
    i = mpc(0, 1)
    d = direction / abs(direction)
    return Series(d, d * i * omega, d * (i * alpha / 2 - omega * omega / 2))


def clean(x, size=1):
    """What is noise against the size is zero."""
    return mpf(0) if fabs(x) <= ZERO * size else x


def text(x):
    if x is None:
        return "absent"
    return "0" if x == 0 else nstr(x, DIGITS, min_fixed=0, max_fixed=0, strip_zeros=False)


def affine_motion(series_A, series_B):
    """(omega, alpha, v_A, a_A) of the plane that carries A and B at a constant distance."""
    AB = series_B - series_A
    # AB = |AB| e^{i theta}:  AB'/AB = i omega,  AB''/AB = i alpha - omega²
    first, second = AB.rate() / AB.value(), AB.second() / AB.value()
    return first.imag, second.imag, mpc(series_A.rate()), mpc(series_A.second())


def pole(A, v_A, omega):
    return None if omega == 0 else A + mpc(0, 1) * v_A / omega


def acceleration_pole(A, a_A, omega, alpha):
    factor = mpc(-omega * omega, alpha)
    return None if factor == 0 else A - a_A / factor


def centre_of_curvature(point):
    """Of the path that the complex series runs; None at infinity, the point itself at a cusp."""
    z, v, a = (mpc(x) for x in (point.value(), point.rate(), point.second()))
    turn = (v.conjugate() * a).imag
    if turn == 0:
        return None
    return z + mpc(0, 1) * v * abs(v) ** 2 / turn


class Writer:
    def __init__(self, head):
        self.lines = ["# " + line if line else "#" for line in head.strip().splitlines()]

    def case(self, name, why, givens, choices, references):
        self.lines += ["", f"case {name}", f"why {why}"]
        self.lines += [f"given {k} {Fraction(v)}" for k, v in givens.items()]
        self.lines += [f"choice {k} {v}" for k, v in choices.items()]
        self.lines += [f"{k} {v if isinstance(v, str) else text(v)}" for k, v in references.items()]

    def print(self):
        print("\n".join(self.lines))
