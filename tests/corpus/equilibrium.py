"""Equilibrium of rigid links by components, for the scripts that write references: every joint's force as unknown
components at its place, every link's three sums, one linear system. Places are complex numbers, forces too."""
from itertools import product

from mpmath import diff, findroot, im, lu_solve, matrix, mpc, mpf, pi, re, sqrt, tan


def moment(at, force):
    return re(at) * im(force) - im(at) * re(force)


class Equilibrium:
    """Links by their numbers; 1, the frame, has no equations."""
    senses = {}  # of the teeth: with_teeth

    def __init__(self, links):
        self.rows = {(link, k): i for i, (link, k) in enumerate((l, k) for l in links for k in range(3))}
        self.columns, self.loads = [], [mpf(0)] * len(self.rows)
        self.told, self.rods, self.arms, self.sums = [], [], [], []

    def _act(self, column, link, at, force, couple=0):
        for k, part in enumerate((re(force), im(force), moment(at, force) + couple)):
            if (link, k) in self.rows:
                column[self.rows[link, k]] += part

    def unknown(self, name, by, on, at, along, couple=0):
        """A force along the unit `along` (or a couple) of one link on another."""
        column = [mpf(0)] * len(self.rows)
        self._act(column, on, at, along, couple)
        self._act(column, by, at, -along, -couple)
        self.columns.append((name, column))

    def hinge(self, by, on, at):
        self.unknown(f"R_{by}{on}_x", by, on, at, 1)
        self.unknown(f"R_{by}{on}_y", by, on, at, 1j)

    def couple(self, name, by, on):
        self.unknown(name, by, on, 0, 0, 1)

    def teeth(self, i, j, P, centre, alpha=20, is_ring=False):
        """The teeth of wheel i press those of wheel j in P, towards the centre of j, or away from it where j is a
        ring."""
        inwards = (centre - P) / abs(centre - P) * (-1 if is_ring else 1)
        along = 1j * inwards + self.senses[f"{i}{j}"] * tan(pi * mpf(alpha) / 180) * inwards
        self.unknown(f"t_{i}{j}", i, j, P, along)
        self.sum(f"R_{i}{j}", [(f"t_{i}{j}", along)])

    def load(self, on, at, force, name=None):
        """Under a name it is among the values too."""
        self._act(self.loads, on, at, force)
        if name:
            self.told += [(name + "_x", re(force)), (name + "_y", im(force)), (name, abs(force))]

    def load_couple(self, on, couple, name=None):
        self._act(self.loads, on, 0, 0, couple)
        if name:
            self.told.append((name, couple))

    def rod(self, name, P, X):
        """The parts of a force across the line PX and along it are among the values too."""
        self.rods.append((name, X - P))

    def arm(self, name, force, at, about):
        """So is how far the line of a force passes by a point: of a hinge by its name, or along a unit."""
        self.arms.append((name, force, at - about))

    def sum(self, name, of):
        """So is the sum of forces along these units, by the names of their sizes."""
        self.sums.append((name, of))

    def values(self):
        n = len(self.rows)
        assert n == len(self.columns)
        found = lu_solve(matrix(n, n) + matrix([[self.columns[j][1][i] for j in range(n)] for i in range(n)]),
                         -matrix(self.loads))
        by_name = {name: found[j] for j, (name, _) in enumerate(self.columns)}
        yield from self.told
        for name, of in self.sums:
            whole = sum(by_name[size] * along for size, along in of)
            by_name[name + "_x"], by_name[name + "_y"] = re(whole), im(whole)
        for name, force, r in self.arms:
            if isinstance(force, str):
                force = mpc(by_name[force + "_x"], by_name[force + "_y"])
            yield name, abs(moment(r, force)) / abs(force)
        for name, rod in self.rods:
            x, y = by_name[name + "_x"], by_name[name + "_y"]
            yield name + "_t", abs(re(rod) * y - im(rod) * x) / abs(rod)
            yield name + "_n", abs(re(rod) * x + im(rod) * y) / abs(rod)
        for name, value in by_name.items():
            yield name, value
            if name.startswith("R_") and name.endswith("_y"):
                yield name[:-2], (by_name[name[:-2] + "_x"] ** 2 + value ** 2) ** mpf("0.5")


def with_friction(case, contacts):
    """The values of what `case` makes of a kind of Equilibrium, under the only senses that agree with what they give.
    Of each contact: its coefficient, the line and what slides on it, its coordinate along the line as its drive goes
    on."""
    slopes = {name: mu * (1 if diff(along, 0) > 0 else -1) for name, (mu, _, along) in contacts.items()}
    agreeing = []
    for senses in product((1, -1), repeat=len(contacts)):
        tried = {f"N_{name}": sense * slopes[name] for name, sense in zip(contacts, senses)}

        class Rubbing(Equilibrium):
            def turned(self, name, along):
                return along + tried[name] * 1j * along if name in tried else along  # n - slope s, s = -i n

            def unknown(self, name, by, on, at, along, couple=0):
                super().unknown(name, by, on, at, self.turned(name, along), couple)

            def sum(self, name, of):
                super().sum(name, [(size, self.turned(size, along)) for size, along in of])

        values = dict(case(Rubbing).values())
        if all(sense * values[f"N_{name}"] > 0 for name, sense in zip(contacts, senses)):
            agreeing.append((values, tried))
    (values, tried), = agreeing
    for name, (_, called, _) in contacts.items():
        N = values[f"N_{name}"]
        values[f"T_{name}"], values[f"R_{called}"] = -tried[f"N_{name}"] * N, abs(N) * sqrt(1 + slopes[name] ** 2)
    for name, value in case().values():
        if name == "M_2" or name.startswith("F_"):
            values[name + "_0"] = value
    return values.items()


def with_circles(case, contacts, circles):
    """The same with friction in hinges: of each its two links, how they turn as the drive goes on (angles), and the
    radius of its friction circle. The sizes of their forces by Newton's iteration, from wherever it begins."""
    turning = {ij: 1 if diff(lambda t: on(t) - by(t), 0) > 0 else -1 for ij, (by, on, _) in circles.items()}

    def values_of(sizes):
        couples = {ij: -turning[ij] * circles[ij][2] * size for ij, size in zip(circles, sizes)}

        def with_couples(kind=Equilibrium):
            e = case(kind)
            for (i, j), couple in couples.items():
                e._act(e.loads, j, 0, 0, couple)
                e._act(e.loads, i, 0, 0, -couple)
            return e
        return couples, dict(with_friction(with_couples, contacts) if contacts else with_couples().values())

    def left_over(*sizes):
        _, values = values_of(sizes)
        return [size - values[f"R_{i}{j}"] for (i, j), size in zip(circles, sizes)]
    found = []
    for start in ([mpf(10) ** (k + up * i) for i in range(len(circles))] for k in range(5) for up in (-1, 0, 1)):
        try:
            sizes = list(findroot(left_over, start, tol=mpf(10) ** -140, maxsteps=60))
        except (ValueError, ZeroDivisionError):
            continue
        if not any(all(abs(a - b) < mpf(10) ** -50 for a, b in zip(sizes, other)) for other in found):
            found.append(sizes)
    sizes, = found
    assert all(size > 0 for size in sizes)
    couples, values = values_of(sizes)
    for (i, j), couple in couples.items():
        values[f"M_{i}{j}"] = couple
    for name, value in case().values():
        if name == "M_2":
            values["M_2_0"] = value
    return values.items()


def with_teeth(case, gears, contacts=None):
    """The values under the only senses of the teeth that agree with what they give, and of friction beside. Of each
    pair of wheels: its pressure angle."""
    agreeing = []
    for signs in product((1, -1), repeat=len(gears)):
        senses = dict(zip(gears, signs))

        def sensed(kind=Equilibrium):
            return case(type("Meshing", (kind,), {"senses": senses}))
        values = dict(with_friction(sensed, contacts) if contacts else sensed().values())
        if all(sense * values[f"t_{ij}"] > 0 for ij, sense in senses.items()):
            agreeing.append(values)
    values, = agreeing
    for ij, alpha in gears.items():
        values[f"R_{ij}_t"] = abs(values.pop(f"t_{ij}"))
        values[f"R_{ij}_r"] = values[f"R_{ij}_t"] * tan(pi * mpf(alpha) / 180)
    return values.items()
