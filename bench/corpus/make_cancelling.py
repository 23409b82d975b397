#!/usr/bin/env python3
"""Writes cancelling.txt: functions whose terms nearly cancel.   make_cancelling.py > cancelling.txt"""
from fractions import Fraction as F

from mpmath import exp, log, mp, tan

from hard import Writer, miss, number

HEAD = """
Functions whose terms nearly cancel, 120 digits. Written by make_cancelling.py with mpmath, 600 working digits, the
formulas as they stand; do not edit by hand. Nothing here is taken from the C++ code.

involute = tan alpha - alpha (radians); logarithms = (n + 1) ln n - 2 (n - 1);
exponentials = (e^(beta t) - e^(-beta t))/(2 beta), t when beta = 0.
"""


def main():
    w = Writer(HEAD)

    def write(name, why, alpha, n, beta, t=F(7, 10)):
        a, x, b, s = (number(q) for q in (alpha, n, beta, t))
        w.case(name, why, dict(alpha=alpha, n=n, beta=beta, t=t), {},
               {"involute": tan(a) - a, "logarithms": (x + 1) * log(x) - 2 * (x - 1),
                "exponentials": s if b == 0 else (exp(b * s) - exp(-b * s)) / (2 * b)})

    write("ordinary", "far from where anything cancels", F(7, 20), F(5, 2), F(3, 2))
    for k in (1, 2, 3, 5, 8, 12, 15, 20, 22, 30):
        write(f"above-1e-{k}", f"alpha = n - 1 = beta = 1e-{k}", miss(k), 1 + miss(k), miss(k))
        write(f"below-1e-{k}", f"alpha = n - 1 = beta = -1e-{k}", -miss(k), 1 - miss(k), -miss(k))
    write("binary", "1/1024: the doubles of the arguments are exact", F(1, 1024), 1 + F(1, 1024), F(1, 1024))
    write("hit", "where all terms cancel", F(0), F(1), F(0))
    write("large", "near a right angle, a large n and a large exponent", F(157, 100), F(10 ** 8), F(100), F(3))
    w.print()


if __name__ == "__main__":
    main()
