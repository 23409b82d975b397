#!/usr/bin/env python3
"""Writes crane_welds.txt: reference values of the crane's welds, independent of the C++ code.

  make_crane_welds.py > crane_welds.txt

The beam is that of make_boat_crane.py: finite elements, sections by Green's theorem. The joint's stress is the strain of
the elements there; the shear flow is the derivative of the flange's force, which is a quadrature of stress over the
flange; the throat is the least distance of the face from the corner; Mohr's circle comes of the stresses on faces turned
through all angles: the greatest and least normal stress, found where their derivative is nought.
"""
from mpmath import cos, diff, findroot, mpf, pi, quad, sin, sqrt

from make_boat_crane import STATED as OF_CRANE, Section, cubic, displaced, number, write

STATED = {**OF_CRANE, "b": "4", "sigma_amm": "500", "f": "4/5", "f_1": "4/5", "f_2": "7/10"}
CASES = [
    ("stated", "the exercise as it is stated", {}),
    ("computed", "the mass that the source computes with", dict(W_b="600")),
    ("odd", "no round number anywhere", dict(L="31/11", W_b="419/3", s_1="37/7", H_1="2311/10", b_1="1493/9",
                                             g="981/100", b="29/7", sigma_amm="4713/11", f="13/17", f_1="19/23",
                                             f_2="11/17")),
    ("wide", "fillets as wide as the flange has room for", dict(b="195/2")),
    ("deep", "a short and deep beam, where the shear is as large as the bending", dict(L="1/10", H_1="900")),
    ("heavy", "far beyond what the welds bear", dict(W_b="1000000")),
    ("light", "a gram", dict(W_b="1/1000")),
    ("not_truncated", "the cut does not reach the sphere", dict(f_1="1/2", f_2="9/10")),
]
NOT_OF_LOAD = {"A_1", "A_v1", "J_x1", "S_x1", "a", "sigma_amm_W", "fillet_stress_2", "fillet_allowable_1",
               "fillet_allowable_2"}


def of_load(q, beam, fixed, mass):
    EJ, L = q["E"] * beam.J_x, q["L"]
    rigid, _ = displaced(EJ, L, mass * q["g"], None)
    v = cubic(rigid[:4], L)
    curvature = lambda x: 2 * v[2] + 6 * v[3] * x
    stress = lambda x, y: -q["E"] * curvature(x) * y  # tension positive, y upwards
    T, h = 6 * v[3] * EJ, q["H_1"] / 2 - q["s_1"]
    sigma, mean = stress(L, h), T / fixed["A_v1"]
    pull = lambda x: q["b_1"] * quad(lambda y: stress(x, y), [h, q["H_1"] / 2])
    flow = abs(diff(pull, L / 2))
    jourawsky = -flow / q["s_1"]

    def normal(angle, tau):  # on the face turned by `angle`
        return sigma * cos(angle) ** 2 + 2 * abs(tau) * sin(angle) * cos(angle)

    def principal(tau):
        slope = lambda angle: -sigma * sin(2 * angle) + 2 * abs(tau) * cos(2 * angle)
        # Between 0 and 45°, where it changes sign.
        angle = findroot(slope, (mpf(0), pi / 4), solver="anderson", tol=mpf(10) ** -170)
        return angle, normal(angle, tau), normal(angle + pi / 2, tau)

    def von_mises(tau):
        _, one, other = principal(tau)
        return sqrt(one * one - one * other + other * other)

    angle, one, other = principal(mean)
    on_throats = flow / (2 * fixed["a"])
    return {
        "T_1": T, "M_C": EJ * curvature(L), "sigma_par_M": sigma, "tau_par_T": mean, "tau_par_Jour": jourawsky,
        "sigma_eq": von_mises(mean), "sigma_eq_Jour": von_mises(jourawsky),
        "full_penetration_utilisation": von_mises(mean) / fixed["sigma_amm_W"],
        "Mohr_centre": (one + other) / 2, "Mohr_radius": (one - other) / 2, "sigma_I": one, "sigma_II": other,
        "principal_direction": angle, "q": flow, "tau_fillet": on_throats, "fillet_stress_1": abs(mean),
        "fillet_stress_2": mpf(0),
        "fillet_utilisation": abs(mean) / fixed["fillet_allowable_1"],
        "fillet_throat_utilisation": on_throats / fixed["fillet_allowable_1"],
    }


def values(given):
    q = {k: number(v) for k, v in given.items()}
    for name in ("s_1", "H_1", "b_1", "b"):
        q[name] /= 1000
    for name in ("E", "sigma_amm"):
        q[name] *= 10**6
    beam = Section(q["H_1"], q["b_1"], q["s_1"])
    h = q["H_1"] / 2 - q["s_1"]
    # From the corner to the face, which runs from one leg's end to the other's.
    nearest = findroot(lambda t: diff(lambda u: (u * q["b"]) ** 2 + ((1 - u) * q["b"]) ** 2, t), mpf("0.4"))
    fixed = {
        "A_1": beam.A, "A_v1": quad(lambda y: q["s_1"], [-h, h]), "J_x1": beam.J_x,
        "S_x1": quad(lambda y: q["b_1"] * y, [h, q["H_1"] / 2]),
        "a": sqrt((nearest * q["b"]) ** 2 + ((1 - nearest) * q["b"]) ** 2),
        "sigma_amm_W": q["f"] * q["sigma_amm"], "fillet_allowable_1": q["f_1"] * q["sigma_amm"],
        "fillet_allowable_2": q["f_2"] * q["sigma_amm"],
    }
    found = {**fixed, **of_load(q, beam, fixed, q["W_b"])}
    found.update({"mass_600kg." + k: v for k, v in of_load(q, beam, fixed, mpf(600)).items() if k not in NOT_OF_LOAD})
    return found


HEADING = """# Reference values of the crane's welds, 40 digits. Written by make_crane_welds.py with mpmath, 90 working digits; do not
# edit by hand. The beam as finite elements, the flange's force by quadrature and its derivative, principal stresses as
# the extremes over all faces. Nothing here is taken from the C++ code.
#
# Givens in m, mm, kg, MPa as the exercise states them; quantities in SI."""

if __name__ == "__main__":
    write(HEADING, STATED, CASES, values)
