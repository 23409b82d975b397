#!/usr/bin/env python3
"""Writes sweep.txt: full turns of cranks in equal steps, special positions among the steps.

  make_sweep.py > sweep.txt

The special positions are put where they are by the law of cosines with an angle of 60 degrees, or a sine of 1/2.
"""
from fractions import Fraction as F

from mpmath import mpc

from hard import Writer, clean, number
from make_four_bar import Linkage
from make_slider_crank import SliderCrank

HEAD = """
Sweeps of four-bars (given A0A) and slider-cranks (given r): every position of a full turn of the crank in equal steps,
special ones among them, 120 digits. Written by make_sweep.py with mpmath, 600 working digits; do not edit by hand.
Givens, choice and references as in four_bar.txt and slider_crank.txt, and A, and C, and the number of positions of
the turn; the guide lies along +x.
"""


def print_sweep(w, name, why, linkage, steps):
    for k in range(steps):
        givens, choices, references = answers(linkage.but(turn=F(k, steps)))
        w.case(f"{name}-{k}-of-{steps}", why, {**givens, "positions": steps}, choices, references)


def answers(at):
    if isinstance(at, SliderCrank):
        givens, choices, references, r = at.givens(), {}, at.motion(), at.r
        del givens["x_guide"], givens["y_guide"]
    else:
        givens, choices, references, r = at.givens(), {"branch": at.branch}, at.references(), at.A0A
    wanted = {k: v for k, v in references.items() if k[:2] in ("x_", "y_", "v_", "a_") or k[:5] in ("omega", "alpha")
              or k.endswith("-order")}
    A = number(r) * at.direction()
    wanted.update(x_A=clean(A.real), y_A=clean(A.imag))
    if "x_B" in wanted and not isinstance(at, SliderCrank):
        B = mpc(wanted["x_B"], wanted["y_B"])
        C = A + (B - A) * mpc(*(number(x) for x in at.C))
        wanted.update(x_C=clean(C.real), y_C=clean(C.imag))
    return givens, choices, wanted


def main():
    w = Writer(HEAD)
    # Crank and coupler 8 m long in line at 60 degrees:  8² + 5² - 8·5 = 7²
    print_sweep(w, "dead-centre", "crank-rocker, crank and coupler in line at 60 degrees",
                Linkage(2, 6, 7, (5, 0), branch="left"), 24)
    # B from A is (5, 0) and 3 m at 60 degrees:  5² + 3² + 5·3 = 7²
    print_sweep(w, "parallel", "crank-rocker, crank and rocker parallel at 60 degrees: pole at infinity",
                Linkage(2, 7, 5, (5, 0), branch="left"), 12)
    print_sweep(w, "limit", "the crank cannot pass 60 degrees, where coupler and rocker are in line",
                Linkage(1, F(1, 2), F(1, 2), (1, 0), branch="left"), 12)
    print_sweep(w, "parallelogram", "B on the right: a parallelogram in one half of the turn, crossed in the other",
                Linkage(2, 5, 2, (5, 0), branch="right"), 12)
    print_sweep(w, "slider", "dead centres at 0 and 180 degrees, pole at infinity at 90 and 270", SliderCrank(), 24)
    # (1 + 3)/2 = 2
    print_sweep(w, "slider-dead-centre", "offset guide, crank and coupler in line at 30 degrees",
                SliderCrank(r=1, l=3, AC=2, BC=2, e=2), 12)
    print_sweep(w, "slider-limit", "coupler square to the guide at 30 degrees: the crank turns back",
                SliderCrank(r=2, l=1, AC=1, BC=1), 12)
    print_sweep(w, "slider-equal", "equal links: B stays on A0 where the crank points back",
                SliderCrank(r=F(1, 2)), 12)
    w.print()


if __name__ == "__main__":
    main()
