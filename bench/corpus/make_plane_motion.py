#!/usr/bin/env python3
"""Writes plane_motion.txt: a moving plane by the motion of one point A, its omega and alpha, all of them rational.

  make_plane_motion.py > plane_motion.txt

All by complex numbers: with q = i alpha - omega², v = v_A + i omega (z - A) and a = a_A + q (z - A). Circles as loci:
v x a and v . a are of the form k |z|² + Re(conj(c) z) + n, and that form is found from the values at four points.
"""
from fractions import Fraction as F

from mpmath import lu_solve, matrix, mpc, mpf, sqrt

from hard import Writer, clean, miss, number

HEAD = """
Moving planes, 120 digits: pole near, far and at infinity, far from the origin and tiny. Written by make_plane_motion.py
with mpmath, 600 working digits; do not edit by hand. Circles are fitted to the loci v x a = 0 and v . a = 0 at four
points; poles are zeros of complex linear functions. Nothing here is taken from the C++ code.

Givens: the point A, its velocity and acceleration, omega and alpha of the plane, and a point X.
P0 pole, K acceleration pole, J inflection pole; inflection, stationarity: centre and radius r of those circles; centre,
radius: of curvature of the path of X; prime: where the ray from P0 to X meets the inflection circle again.
`absent`: at infinity, or a circle that has become a line, or the centre at a cusp.
Questions: K_on_inflection_circle, the sign of K's power (zero, as a is zero there; impossible where K has left the
plane); bends_to, the sign of v x a at X.
"""


class Plane:
    def __init__(self, A=(F(1, 10), F(1, 5)), v=(F(3, 2), F(-1, 2)), a=(F(-20), F(7)), omega=F(10), alpha=F(3),
                 X=(F(3, 10), F(1, 4))):
        self.values = dict(A=tuple(F(x) for x in A), v=tuple(F(x) for x in v), a=tuple(F(x) for x in a),
                           omega=F(omega), alpha=F(alpha), X=tuple(F(x) for x in X))
        self.__dict__.update(self.values)

    def but(self, **changes):
        return Plane(**{**self.values, **changes})

    def moved(self, dx, dy):
        return self.but(A=(self.A[0] + dx, self.A[1] + dy), X=(self.X[0] + dx, self.X[1] + dy))

    def scaled(self, s):
        return self.but(**{k: tuple(x * s for x in self.values[k]) for k in ("A", "v", "a", "X")})

    def givens(self):
        return dict(x_A=self.A[0], y_A=self.A[1], vx_A=self.v[0], vy_A=self.v[1], ax_A=self.a[0], ay_A=self.a[1],
                    omega=self.omega, alpha=self.alpha, x_X=self.X[0], y_X=self.X[1])

    # Exactly, as pairs of rationals.
    def velocity(self, X):
        x, y = X[0] - self.A[0], X[1] - self.A[1]
        return (self.v[0] - self.omega * y, self.v[1] + self.omega * x)

    def acceleration(self, X):
        x, y, w2 = X[0] - self.A[0], X[1] - self.A[1], self.omega ** 2
        return (self.a[0] - self.alpha * y - w2 * x, self.a[1] + self.alpha * x - w2 * y)

    def pole(self):
        return (self.A[0] - self.v[1] / self.omega, self.A[1] + self.v[0] / self.omega)

    def on_inflection_circle(self, ray):
        """Where the ray from the pole meets the circle again, rational."""
        P = self.pole()
        # v x a along the ray P + t ray is t² k + t m:  zero at t = -m/k
        def bend(t):
            X = (P[0] + t * ray[0], P[1] + t * ray[1])
            v, a = self.velocity(X), self.acceleration(X)
            return v[0] * a[1] - v[1] * a[0]
        k, m = (bend(F(1)) + bend(F(-1))) / 2, (bend(F(1)) - bend(F(-1))) / 2
        return (P[0] - m / k * ray[0], P[1] - m / k * ray[1])

    def references(self):
        def z(p):
            return mpc(number(p[0]), number(p[1]))

        i, A, v_A, a_A, X = mpc(0, 1), z(self.A), z(self.v), z(self.a), z(self.X)
        w, q = number(self.omega), mpc(-number(self.omega) ** 2, number(self.alpha))
        velocity = lambda p: v_A + i * w * (p - A)
        acceleration = lambda p: a_A + q * (p - A)
        P0 = A + i * v_A / w if w != 0 else None
        K = A - a_A / q if q != 0 else None
        J = P0 + acceleration(P0) / (w * w) if w != 0 else None
        result = {}

        def report(name, point):
            result["x_" + name] = None if point is None else clean(point.real)
            result["y_" + name] = None if point is None else clean(point.imag)

        report("P0", P0)
        report("K", K)
        report("J", J)
        for name, form in (("inflection", lambda p: (velocity(p).conjugate() * acceleration(p)).imag),
                           ("stationarity", lambda p: (velocity(p).conjugate() * acceleration(p)).real)):
            centre, radius = self.circle(form, A)
            report(name, centre)
            result["r_" + name] = radius
        v, a = velocity(X), acceleration(X)
        v = mpc(clean(v.real), clean(v.imag))
        turn = clean((v.conjugate() * a).imag)
        centre = X + i * v * abs(v) ** 2 / turn if turn != 0 else None
        report("centre", centre)
        result["radius"] = None if centre is None else abs(v) ** 3 / abs(turn)
        # seen from the pole, X' is the foot of the perpendicular from J on the ray
        if P0 is None or v == 0:
            prime = None
        else:
            ray = (X - P0) / abs(X - P0)
            prime = P0 + ray * ((J - P0) * ray.conjugate()).real
        result["x_prime"] = None if prime is None else clean(prime.real)
        result["y_prime"] = None if prime is None else clean(prime.imag)
        sign = lambda x: "zero" if x == 0 else "positive" if x > 0 else "negative"
        result["bends_to"] = sign(turn)
        # K has no acceleration: v x a is zero there
        result["K_on_inflection_circle"] = "impossible" if K is None else "zero"
        return result

    @staticmethod
    def circle(form, A):
        """Centre and radius of the locus form = 0, or None, None when it is a line (or nothing)."""
        at = [A, A + 1, A + mpc(0, 1), A - mpc(2, 1)]
        rows = matrix([[abs(p - A) ** 2, (p - A).real, (p - A).imag, 1] for p in at])
        k, m, n, c = lu_solve(rows, matrix([form(p) for p in at]))
        if clean(k) == 0:
            return None, None
        centre = mpc(-m, -n) / (2 * k)
        return A + centre, sqrt(clean(abs(centre) ** 2 - c / k, abs(centre) ** 2))


def main():
    w = Writer(HEAD)

    def write(name, why, plane):
        w.case(name, why, plane.givens(), {}, plane.references())

    plain = Plane()
    write("ordinary", "an ordinary motion, for comparison", plain)
    write("binary", "doubles hold the givens exactly, so that every error is one of rounding",
          Plane(A=(1, 2), v=(3, 5), a=(7, -3), omega=3, alpha=5, X=(4, 1)))
    for k in (3, 8, 15, 22, 30):
        write(f"omega-1e-{k}", f"omega = 1e-{k}: the pole is far away", plain.but(omega=miss(k)))
        write(f"omega-alpha-1e-{k}", f"omega and alpha are 1e-{k}: K leaves the plane", plain.but(omega=miss(k),
                                                                                                alpha=miss(k)))
        write(f"alpha-1e-{k}", f"alpha = 1e-{k}: the stationarity circle is almost a line", plain.but(alpha=miss(k)))
    write("omega-zero", "translation: pole at infinity, the circles are lines", plain.but(omega=0))
    write("alpha-zero", "no angular acceleration: the stationarity circle is a line", plain.but(alpha=0))
    write("translation", "neither omega nor alpha: K has left the plane", plain.but(omega=0, alpha=0))
    for ten in (4, 8, 12):
        write(f"moved-1e{ten}", f"the whole motion 1e{ten} away from the origin", plain.moved(10 ** ten, -10 ** ten))
    write("nanometre", "a motion of 1e-9 m", plain.scaled(miss(9)))
    write("nanometre-moved", "a motion of 1e-9 m, a metre away from the origin", plain.scaled(miss(9)).moved(1, 1))
    P, X = plain.pole(), plain.on_inflection_circle((F(2), F(1)))
    for name, what, point in (("cusp", "X is the pole: a cusp of its path", P),
                              ("inflection", "X on the inflection circle", X)):
        write(f"{name}-hit", f"{what}, exactly", plain.but(X=point))
        for k in (3, 8, 15, 22, 30):
            write(f"{name}-beyond-1e-{k}", f"{what}, missed by 1e-{k} m", plain.but(X=(point[0] + miss(k), point[1])))
        write(f"{name}-before-1e-30", f"{what}, missed by -1e-30 m", plain.but(X=(point[0] - miss(30), point[1])))
        write(f"{name}-moved", f"{what}, 1e8 away from the origin", plain.but(X=point).moved(10 ** 8, 10 ** 8))
    w.print()


if __name__ == "__main__":
    main()
