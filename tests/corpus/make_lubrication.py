#!/usr/bin/env python3
"""Writes lubrication.txt: reference values of the film under a flat slider, independent of the C++ code.

  make_lubrication.py > lubrication.txt

Combinations of logarithms as they stand, with 200 digits so that they may cancel; film integrals by their series in
the wedge where it is slender, else by mpmath's quadrature; the ratio of films with a given centre of pressure by
secants.
"""
from fractions import Fraction

from mpmath import findroot, fabs, ln, mp, mpf, nstr, quad

mp.dps = 200


def number(rational):
    q = Fraction(rational)
    return mpf(q.numerator) / q.denominator


def combinations(n):
    return dict(plain=ln(n), drag=2 * (n + 1) * ln(n) - 3 * (n - 1), load=(n + 1) * ln(n) - 2 * (n - 1),
                couple=(n * n + 4 * n + 1) * ln(n) - 3 * (n * n - 1))


# t^k (1 - e t)^-b from -1 to `to`: binomial series, or pieces that halve towards the pole.
def film_integral(k, b, e, to):
    if e < mpf(1) / 100:
        total, term, j = mpf(0), mpf(1), 0
        while fabs(term) > mpf(10) ** -190:
            total += term * (to ** (k + j + 1) - (-1) ** (k + j + 1)) / (k + j + 1)
            j += 1
            term = term * e * (b + j - 1) / j
        return total
    pieces, gap = [to], (1 / e - to) / 2
    while to - gap > -1:
        pieces.append(to - gap)
        gap *= 2
    pieces.append(mpf(-1))
    return quad(lambda t: t ** k / (1 - e * t) ** b, pieces[::-1])


def centre(n):
    c = combinations(n)
    return mpf(1) / 2 + c["couple"] / (2 * (n - 1) * c["load"])


def film(given):
    n = number(given["n"])
    e, c = (n - 1) / (n + 1), combinations(n)
    found = {f"logarithms_{name}": value for name, value in c.items()}
    for k, b in ((0, 1), (0, 2), (1, 2), (0, 3), (1, 3), (2, 3), (3, 3)):
        for name, to in (("end", mpf(1)), ("third", mpf(1) / 3)):
            found[f"integral_{k}_{b}_{name}"] = film_integral(k, b, e, to)
    A, k = 6 * c["load"] / ((n + 1) * (n - 1) ** 2), 2 * c["drag"] / (n * n - 1)
    found.update(load=A, centre=centre(n), drag=k, friction=k / A ** mpf(0.5))
    return found


def pivot(given):
    x = number(given["centre"])
    beyond = x - mpf(1) / 2
    guess = 10 * beyond if beyond < mpf(1) / 100 else None
    if guess is None:  # by halving the power
        low, high = mpf(0), mpf(200)
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if centre(1 + mpf(2) ** (middle - 20)) < x else (low, middle)
        guess = mpf(2) ** (low - 20)
    return dict(less_one=findroot(lambda d: (centre(1 + d) - x) / beyond, (guess, guess * (1 + mpf(10) ** -6)), tol=mpf(10) ** -150))


def write(name, why, given, find):
    print(f"\ncase {name}\nwhy {why}")
    for symbol, value in given.items():
        print(f"given {symbol} {value}")
    for quantity, value in find(given).items():
        print(quantity, nstr(value, 40, min_fixed=-30, max_fixed=30))


def main():
    print("# Reference values of the film under a flat slider, 40 digits. Written by make_lubrication.py with mpmath, 200\n"
          "# working digits; do not edit by hand.")
    for name, why, n in (("1e-15", "nearly parallel", Fraction(10 ** 15 + 1, 10 ** 15)),
                         ("1e-6", "hardly a wedge", Fraction(10 ** 6 + 1, 10 ** 6)), ("two", "an ordinary wedge", 2),
                         ("1e3", "a steep one", 1000)):
        write(name, why, dict(n=n), film)
    for name, why, x in (("middle", "nearly in the middle", "500000000000001/1000000000000000"),
                         ("source", "as the thrust bearing has it", "113/200"), ("0.9", "far out", "9/10"),
                         ("0.95", "farther out", "19/20")):
        write(f"centre_{name}", why, dict(centre=x), pivot)


main()
