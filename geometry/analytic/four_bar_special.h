// Special positions of the four-bar linkage in closed form: dead centres of the rocker, limits of the crank, crank
// and rocker parallel; and which links can turn fully.
//
// In each of them the crank's line, of some signed length s from A0, makes a triangle with the frame whose third side
// r is known:  |s u - z_B0| = r.  The law of cosines gives Re(conj(z_B0) u) as a rational number, also where the
// frame's length is irrational; so whether the position exists is always decided, and u takes one square root.
// The two triangles are mirror images in the frame.
#pragma once

#include "geometry/analytic/four_bar_formulas.h"

#include <algorithm>
#include <string>

namespace epure::geometry::analytic {

// Unit directions of the crank on either side of the directed line A0 -> B0; equal when they lie on it.
template <class T>
struct MirroredCranks {
  Complex<T> left, right;
};

// The two u with |s u - z_B0| = r. Throws Impossible, with `position` (a phrase) as its subject, when there are none
// or s = 0 leaves u open.
template <class T>
MirroredCranks<T> triangles_on_frame(const FourBar& g, const Rational& s, const Rational& r, const Phrase& position) {
  require_frame(g);
  if (s == 0)
    throw Impossible(position + Words{" fixes no crank: two links are equally long",
                                      " non fissa alcuna manovella: due membri sono ugualmente lunghi"});
  const Rational f2 = g.squared_frame(), along = (s * s + f2 - r * r) / (2 * s), across2 = f2 - along * along;
  if (across2 < 0) {
    const auto show = [](const Rational& length) { return digits(from_rational<T>(length)) + " m"; };
    throw Impossible(position + Words{" does not exist: sides of ", " non esiste: lati di "} + show(abs(s)) +
                     Words{" and ", " e "} + show(r) +
                     Words{" close no triangle with the frame of ", " non chiudono un triangolo con il telaio di "} +
                     digits(root(from_rational<T>(f2))) + " m");
  }
  const T across = root(from_rational<T>(across2));
  const Complex<T> frame = divided(g.B0<T>(), from_rational<T>(f2));
  return {frame * Complex<T>{from_rational<T>(along), across}, frame * Complex<T>{from_rational<T>(along), -across}};
}

template <class T>
const Complex<T>& of_branch(const MirroredCranks<T>& cranks, Branch branch) {
  return branch == Branch::left ? cranks.left : cranks.right;
}

inline Branch opposite(Branch branch) { return branch == Branch::left ? Branch::right : Branch::left; }

// Dead centres of the rocker: A0, A, B in line, ω₄ = 0. Extended: B at distance A0A + AB from A0; folded: at the
// difference of both.
enum class DeadCentre { extended, folded };

// Direction of the crank at the dead centre of this branch. Throws Impossible when there is none.
template <class T>
Complex<T> crank_at_dead_centre(const FourBar& g, DeadCentre which, Branch branch) {
  // With z_B = s u the side of B is that of u, or the opposite where the coupler points back from A.
  if (which == DeadCentre::extended)
    return of_branch(
        triangles_on_frame<T>(g, g.A0A + g.AB, g.B0B, {"the extended dead centre", "il punto morto esteso"}), branch);
  return of_branch(
      triangles_on_frame<T>(g, g.A0A - g.AB, g.B0B, {"the folded dead centre", "il punto morto ripiegato"}),
      opposite(branch));
}

// Limits of the crank: A, B, B0 in line, both branches meet, and ω₃ and ω₄ are not defined. Extended: B between A
// and B0; folded: not.
enum class CrankLimit { extended, folded };

// Directions of the crank at its limits. Throws Impossible when there are none: the crank passes there.
template <class T>
MirroredCranks<T> crank_limits(const FourBar& g, CrankLimit which) {
  if (which == CrankLimit::extended)
    return triangles_on_frame<T>(
        g, g.A0A, g.AB + g.B0B,
        {"the limit of the crank with AB and B0B extended", "il limite della manovella con AB e B0B distesi"});
  return triangles_on_frame<T>(
      g, g.A0A, abs(g.AB - g.B0B),
      {"the limit of the crank with AB and B0B folded", "il limite della manovella con AB e B0B ripiegati"});
}

// Crank and rocker parallel: ω₃ = 0 and ω₄ = ± ω₂ A0A/B0B, the pole at infinity.
enum class Parallel { same_sense, opposite_sense };

// Direction of the crank when the rocker is parallel to it on this branch. Throws Impossible when there is none, and
// for crank and rocker of one length in the same sense (always parallel, or never).
template <class T>
Complex<T> crank_parallel_to_rocker(const FourBar& g, Parallel sense, Branch branch) {
  // AB v = z_B0 - s u with s = A0A -+ B0B; the side of B is that of B0B w, and w = ± u.
  if (sense == Parallel::same_sense)
    return of_branch(triangles_on_frame<T>(g, g.A0A - g.B0B, g.AB,
                                           {"crank and rocker parallel in the same sense",
                                            "la posizione con manovella e bilanciere paralleli e concordi"}),
                     branch);
  return of_branch(triangles_on_frame<T>(g, g.A0A + g.B0B, g.AB,
                                         {"crank and rocker parallel in opposite senses",
                                          "la posizione con manovella e bilanciere paralleli e discordi"}),
                   opposite(branch));
}

// By Grashof's condition, which links turn fully against the frame: of crank and rocker the first named; both;
// neither but the coupler; none. change_point: all hinges can come in line, and the linkage may pass from branch to
// branch.
enum class Mobility { crank_rocker, rocker_crank, double_crank, double_rocker, triple_rocker, change_point };

// The sign of |A0B0| - length, by comparing squares.
inline Sign compare_frame(const FourBar& g, const Rational& length) {
  const Rational difference = g.squared_frame() - length * length;
  if (length < 0 || difference > 0) return Sign::positive;
  return difference < 0 ? Sign::negative : Sign::zero;
}

// Decided on rationals, whatever the frame. Throws Impossible when the longest link is not shorter than the other
// three together (the linkage does not close, or cannot move) or the frame has no length. Source: McCarthy and Soh,
// Geometric Design of Linkages, section 4.1: the signs of f - a + b - c, f - a - b + c and b + c - f - a (frame f,
// crank a, coupler b, rocker c).
inline Mobility mobility(const FourBar& g) {
  require_frame(g);
  const Rational &a = g.A0A, &b = g.AB, &c = g.B0B;
  const Sign longer = compare_frame(g, a + b + c);
  const Rational longest = std::max(a, std::max(b, c));
  if (longer != Sign::negative || compare_frame(g, 2 * longest - a - b - c) != Sign::positive)
    throw Impossible("the four-bar cannot move: one link is as long as the other three together, or longer",
                     "il quadrilatero non può muoversi: un membro è lungo quanto gli altri tre insieme, o di più");
  const Sign first = compare_frame(g, a + c - b), second = compare_frame(g, a + b - c);
  const Sign minus_third = compare_frame(g, b + c - a);
  for (const Sign s : {first, second, minus_third})
    if (s == Sign::zero) return Mobility::change_point;
  const bool one = first == Sign::positive, two = second == Sign::positive, three = minus_third == Sign::negative;
  if (one && two && three) return Mobility::crank_rocker;
  if (one && !two && !three) return Mobility::rocker_crank;
  if (!one && !two && three) return Mobility::double_crank;
  return !one && two && !three ? Mobility::double_rocker : Mobility::triple_rocker;
}

// What the rocker of a crank-rocker does between its dead centres, in radians.
template <class T>
struct RockerStroke {
  T swing;           // of the rocker, in (0, π)
  T crank_rotation;  // counter-clockwise from the extended to the folded dead centre, in (0, 2π)
  T time_ratio;      // of the slower stroke to the quicker at constant crank speed, at least 1
};

// For the numbers that have arc_tangent. Throws Impossible when the linkage is no crank-rocker (only then does the
// rocker swing between its dead centres while the crank turns).
template <class T>
RockerStroke<T> rocker_stroke(const FourBar& g, Branch branch) {
  if (mobility(g) != Mobility::crank_rocker)
    throw Impossible("the rocker does not swing between two dead centres: the linkage is no crank-rocker",
                     "il bilanciere non oscilla tra due punti morti: il meccanismo non è un manovella-bilanciere");
  const Complex<T> extended = crank_at_dead_centre<T>(g, DeadCentre::extended, branch);
  const Complex<T> folded = crank_at_dead_centre<T>(g, DeadCentre::folded, branch);
  const Complex<T> B0 = g.B0<T>();
  const Complex<T> from = from_rational<T>(g.A0A + g.AB) * extended - B0;
  const Complex<T> to = from_rational<T>(g.A0A - g.AB) * folded - B0;
  // The cranks lie on different sides of the frame, so their angle is never 0: measured from the half turn, it is far
  // from the cut of the arc tangent, and a rotation of just π needs no decision.
  const T beyond_half_turn = arc_tangent(-cross(extended, folded), -dot(extended, folded));
  const T deviation = root(square(beyond_half_turn)), half_turn = pi<T>();
  return {arc_tangent(root(square(cross(from, to))), dot(from, to)), half_turn + beyond_half_turn,
          quotient(half_turn + deviation, half_turn - deviation)};
}

}  // namespace epure::geometry::analytic
