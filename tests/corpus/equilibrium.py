"""Equilibrium of rigid links by components, for the scripts that write references: every joint's force as unknown
components at its place, every link's three sums, one linear system. Places are complex numbers, forces too."""
from mpmath import im, lu_solve, matrix, mpf, re


def moment(at, force):
    return re(at) * im(force) - im(at) * re(force)


class Equilibrium:
    """Links by their numbers; 1, the frame, has no equations."""

    def __init__(self, links):
        self.rows = {(link, k): i for i, (link, k) in enumerate((l, k) for l in links for k in range(3))}
        self.columns, self.loads = [], [mpf(0)] * len(self.rows)

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

    def load(self, on, at, force):
        self._act(self.loads, on, at, force)

    def load_couple(self, on, couple):
        self._act(self.loads, on, 0, 0, couple)

    def values(self):
        n = len(self.rows)
        assert n == len(self.columns)
        found = lu_solve(matrix(n, n) + matrix([[self.columns[j][1][i] for j in range(n)] for i in range(n)]),
                         -matrix(self.loads))
        by_name = {name: found[j] for j, (name, _) in enumerate(self.columns)}
        for name, value in by_name.items():
            yield name, value
            if name.startswith("R_") and name.endswith("_y"):
                yield name[:-2], (by_name[name[:-2] + "_x"] ** 2 + value ** 2) ** mpf("0.5")
