#!/usr/bin/env python3
"""Writes reference values for exercise N.3 (four-bar) under the exercise's own names, independent of the C++ code.

  make_four_bar_exercise.py > four_bar_exercise.txt

The measuring is that of make_four_bar.py: positions are the only formulas, velocities and accelerations are numerical
derivatives of the paths, P31 and K zeros of the affine fields, circles fitted conics, special positions changes of sign
followed round the turn. The slider-crank of the second sub-exercise is measured by make_slider_crank.py.
"""
from fractions import Fraction

from mpmath import degrees, mp, pi

import make_slider_crank
from make_four_bar import (DEAD_EXTENDED, DEAD_FOLDED, DOUBLE_ROCKER, DRAG_LINK, LARGE, LONG_CRANK, N3, NEAR_CHANGE,
                           PARALLEL_OPPOSITE, PARALLEL_SAME, ROCKER_CRANK, SMALL, TRIPLE_ROCKER, Case, special_positions,
                           values)
from make_slider_crank import text

OTHER = {"left": "right", "right": "left"}
CIRCLES = ("inflection_diameter inflection_centre_x inflection_centre_y inflection_pole_x inflection_pole_y "
           "stationarity_diameter stationarity_centre_x stationarity_centre_y").split()
MOTION = ("A_x A_y B_x B_y C_x C_y coupler_angle rocker_angle v_A omega_3 omega_4 v_BA v_B_x v_B_y v_B v_C_x v_C_y v_C "
          "P0_x P0_y P0A P0B P0C alpha_3 alpha_4 a_A a_B_n a_B_t a_BA_n a_BA_t a_CA_n a_CA_t a_C_n a_C_t a_B_x a_B_y "
          "a_B a_C_x a_C_y a_C K_x K_y KA KB KC Cprime_C rho_C curvature_centre_C_x curvature_centre_C_y Cprime_x "
          "Cprime_y").split() + CIRCLES
# What a position without a pole has: no distance from it, no circles, no centre of curvature.
OF_LINKS = [name for name in MOTION if name not in CIRCLES and name not in ("coupler_angle", "rocker_angle", "rho_C")
            and not name.startswith(("P0", "K", "Cprime", "curvature"))]


class Given:
    def __init__(self, name, why, linkage=N3, t="0.1", n="50", branch="right", AC="0.33", C_side="right", alpha_2="0",
                 lam="3"):
        self.name, self.why, self.linkage, self.branch, self.C_side = name, why, linkage, branch, C_side
        self.t, self.n, self.alpha_2, self.lam = (Fraction(x) for x in (t, n, alpha_2, lam))
        self.AC = Fraction(AC) if AC is not None else linkage.AB * Fraction(3, 5)

    def case(self, at, branch=None, C_side=None):
        return Case(self.name, self.why, self.linkage, at, branch or self.branch, self.AC, C_side or self.C_side, self.n,
                    self.alpha_2)


def put(name, value, sizes, kind="gamma"):
    """`kind`: a name that tells text() the dimension; gamma is a pure number."""
    print(name, text(kind, value, sizes))


def put_motion(prefix, v, sizes):
    for name in MOTION:
        put(prefix + name.replace("P0", "P31"), v[name], sizes, name)
    omega, alpha = v["omega_3"], v["alpha_3"]
    put(prefix + "tan_gamma", alpha / omega ** 2 if omega else "infinite" if alpha else "undefined", sizes)
    put(prefix + "gamma_deg", v["gamma"] if isinstance(v["gamma"], str) else degrees(v["gamma"]), sizes)


def put_instant(given, at):
    v, sizes = values(at)
    phi = v["omega_2"] * given.t.numerator / given.t.denominator
    put("omega_2", v["omega_2"], sizes, "omega_2")
    put("crank_angle_phi", phi, sizes)
    put("crank_angle_phi_deg", degrees(phi), sizes)
    put("AC", make_slider_crank.number(given.AC), sizes, "AC")
    put("BC", mp.sqrt(make_slider_crank.number(given.linkage.AB ** 2 - given.AC ** 2)), sizes, "BC")
    put_motion("", v, sizes)
    mirrored, _ = values(given.case(at.at, C_side=OTHER[given.C_side]))
    for name in ("C_x", "C_y", "a_C", "KC", "rho_C", "P0C"):
        put("mirror_side_" + name.replace("P0", "P31"), mirrored[name], sizes, name)


def put_crank(prefix, angle, sizes):
    within = angle % (2 * pi)
    if 2 * pi - within < make_slider_crank.ZERO:
        within = 0 * within
    put(prefix + "crank_angle", within, sizes)
    put(prefix + "crank_angle_deg", degrees(within), sizes)


def put_special(given):
    found = special_positions(given.linkage)
    for which in ("extended", "folded"):
        prefix, kind = f"dead_centre_{which}.", f"dead_centre_{which}"
        if found[f"{kind}_{given.branch}.crank_angle"] == "absent":
            print(f"{prefix}* absent")
            continue
        v, sizes = values(given.case(kind))
        put_crank(prefix, v["crank_angle_phi"], sizes)
        put_motion(prefix, v, sizes)
        put(prefix + "rocker_angle_deg", degrees(v["rocker_angle"]), sizes)
    for sense in ("same", "opposite"):
        for which, branch in (("main", given.branch), ("other", OTHER[given.branch])):
            prefix, kind = f"parallel_links.{sense}_sense_{which}_branch_", f"parallel_{sense}_sense"
            if found[f"{kind}_{branch}.crank_angle"] == "absent":
                print(f"{prefix}* absent")
                continue
            v, sizes = values(given.case(kind, branch))
            put_crank(prefix, v["crank_angle_phi"], sizes)
            for name in OF_LINKS:
                put(prefix + name, v[name], sizes, name)
    for name, source in (("rocker_swing", "rocker_swing"), ("time_ratio", "time_ratio"),
                         ("crank_rotation_extended_to_folded", "crank_rotation")):
        put(name, found[f"{source}_{given.branch}"], (1, 1, 1))


def put_slider_crank(lam):
    """Crank 1 at 60 rpm, so its speed is 2 pi; values for speed 1."""
    v, sizes = make_slider_crank.values(make_slider_crank.Case("", "", r=1, l=lam, AC=lam * Fraction(3, 5),
                                                               BC=lam * Fraction(4, 5), n=60, turn="1/4"))
    speed, prefix = v["omega_2"], "slider_crank_ratio_3."
    assert v["inflection_line_b"] == 0 or abs(v["inflection_line_b"]) < make_slider_crank.ZERO
    assert abs(v["stationarity_line_a"]) < make_slider_crank.ZERO
    for name, value in (("B_x_over_r", v["B_x"]), ("coupler_angle", v["coupler_angle"]),
                        ("omega_3_over_omega_2", v["omega_3"] / speed),
                        ("alpha_3_over_omega_2_squared", v["alpha_3"] / speed ** 2),
                        ("v_B_over_omega_2_r", v["v_B"] / speed), ("a_B_over_omega_2_squared_r", v["a_B"] / speed ** 2),
                        ("K_x_over_r", v["K_x"]), ("K_y_over_r", v["K_y"]),
                        ("inflection_line_x_over_r", -v["inflection_line_c"] / v["inflection_line_a"]),
                        ("stationarity_line_y_over_r", -v["stationarity_line_c"] / v["stationarity_line_b"])):
        put(prefix + name, value, sizes)


def givens():
    yield Given("n3", "as stated: 50 rpm, 0.1 s, so 30 degrees")
    yield Given("other_branch", "B on the other side of A -> B0", branch="left")
    yield Given("other_side", "C on the other side of A -> B", C_side="left")
    yield Given("other_branch_and_side", "both", branch="left", C_side="left")
    yield Given("clockwise", "the crank turns the other way and stands at -30 degrees", n="-50")
    yield Given("speeding_up", "a crank acceleration", alpha_2="3")
    yield Given("braking", "the other sign", alpha_2="-30")
    yield Given("crank_on_x", "the instant from which t counts", t="0")
    yield Given("before", "an instant before it", t="-0.35")
    yield Given("second_turn", "the crank angle is beyond a full turn", t="1.3")
    yield Given("crank_20_degrees", "an angle that is not constructible", t=Fraction(1, 15))
    yield Given("dead_centre_extended", "lengths that put the instant on a dead centre", DEAD_EXTENDED, t="0",
                branch="left")
    yield Given("dead_centre_folded_braking", "the other dead centre, with alpha_2", DEAD_FOLDED, t="0", alpha_2="-30")
    yield Given("parallel_same_sense", "crank and rocker parallel: pole at infinity", PARALLEL_SAME, t="0")
    yield Given("parallel_opposite_sense", "and opposed, with alpha_2", PARALLEL_OPPOSITE, t="0", branch="left",
                alpha_2="5")
    yield Given("drag_link", "the rocker turns fully: no dead centre", DRAG_LINK, AC=None)
    yield Given("double_rocker", "the coupler is shortest", DOUBLE_ROCKER, t="0.2", AC=None, branch="left")
    yield Given("triple_rocker", "no link turns fully", TRIPLE_ROCKER, t=Fraction(1, 15), AC=None)
    yield Given("rocker_crank", "the rocker is shortest", ROCKER_CRANK, t="0.2", AC=None)
    yield Given("long_crank", "the crank is longer than the coupler", LONG_CRANK, AC=None)
    yield Given("near_change_point", "the frame is 1e-9 m too long for a change point", NEAR_CHANGE, AC=None)
    yield Given("flat_plate", "AC = AB: C falls on B", AC="0.37")
    yield Given("nearly_flat_plate", "C beside B", AC="0.3699")
    yield Given("needle", "C beside A", AC="1e-6")
    yield Given("short_slider_crank", "a coupler hardly longer than the crank", lam="1.0001")
    yield Given("tiny", "all lengths a billionth", N3.scaled(SMALL), AC=Fraction("0.33") * SMALL)
    yield Given("huge", "all lengths a hundred million times", N3.scaled(LARGE), AC=Fraction("0.33") * LARGE)


HEADER = """\
# Reference values for exercise N.3, four-bar, 40 digits, under the names and conventions of the exercise. Written by
# make_four_bar_exercise.py with mpmath, 400 working digits; do not edit by hand. Positions are the only formulas; the
# rest is measured on the paths, as four_bar.txt and slider_crank.txt say. Nothing here is taken from the C++ code.
#
# Givens and choices as --set takes them. A value is a number, or `infinite` or `undefined` when there is none;
# `PREFIX* absent`: there is no such position, nor any quantity whose name begins so.
"""


def main():
    print(HEADER, end="")
    for given in givens():
        print(f"\ncase {given.name}\nwhy {given.why}")
        for name in ("A0A", "AB", "B0B"):
            print(f"given {name} {getattr(given.linkage, name)}")
        print(f"given x_B0 {given.linkage.B0[0]}\ngiven y_B0 {given.linkage.B0[1]}")
        for name, value in (("AC", given.AC), ("n", given.n), ("t", given.t), ("alpha_2", given.alpha_2),
                            ("lambda", given.lam)):
            print(f"given {name} {value}")
        print(f"choice branch {given.branch}\nchoice C_side {given.C_side}")
        put_instant(given, given.case(given.n * given.t / 60))
        put_special(given)
        put_slider_crank(given.lam)


if __name__ == "__main__":
    main()
