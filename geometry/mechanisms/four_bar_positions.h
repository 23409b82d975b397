// Special positions of the four-bar linkage: the dead centres of the rocker, the limit positions of the crank, and
// crank and rocker parallel.
//
// Each is a triangle on the frame with sides known beforehand, so compasses construct it. Whether the triangle
// closes, or is flat, is decided on the rational lengths: no number type leaves it open, and nothing here throws
// Undecided.
//
// A branch is the side of A -> B₀ on which B lies, as in four_bar. Where B comes to lie on that line both branches
// meet, and a position asked for either is the same one.
#pragma once

#include "geometry/mechanisms/grashof.h"

#include <optional>
#include <vector>

namespace epure::geometry {

// Two bars in line: one goes on where the other ends, or goes back over it.
enum class Reach { extended, folded };
// Two parallel bars: A₀A and B₀B in the same direction or against each other.
enum class Sense { same, opposite };

template <class T>
struct FourBarPosition {
  Vector<T> crank;  // unit vector, A₀ towards A
  FourBar<T> at;
  std::optional<Side> branch;  // none when B lies on the line A B₀
};

// The triangle on the frame whose third corner lies |leg| from A₀ and `other` from B₀. The direction wanted is that
// of the corner from A₀, or the opposite one when leg < 0.
struct FrameTriangle {
  Rational along, across_squared;  // of that direction, in parts of the vector A₀B₀
  bool is_flat() const { return across_squared == 0; }

  // The unit vector on the named side of A₀ -> B₀.
  template <class T>
  Vector<T> direction(const FourBarLengths& of, Side side) const {
    const Vector<T> d{from_rational<T>(of.x_B0), from_rational<T>(of.y_B0)};
    const T across = root(from_rational<T>(across_squared));
    return from_rational<T>(along) * d + (side == Side::left ? across : -across) * quarter_turn(d);
  }
};

// leg is not zero. Throws Impossible with `why_not` when the triangle does not close, or B₀ lies on A₀.
inline FrameTriangle frame_triangle(const FourBarLengths& of, const Rational& leg, const Rational& other,
                                    const Phrase& why_not) {
  const Rational d2 = frame_squared(of), leg2 = leg * leg;
  if (d2 == 0) throw Impossible("the hinge B0 lies on A0", "la cerniera B0 sta su A0");
  const Rational twice_along = d2 + leg2 - other * other;
  const Rational sixteen_areas_squared = 4 * d2 * leg2 - twice_along * twice_along;
  if (sixteen_areas_squared < 0) throw Impossible(why_not);
  return {twice_along / (2 * d2 * leg), sixteen_areas_squared / (4 * d2 * d2 * leg2)};
}

namespace positions {

inline std::optional<Side> unless_flat(const FrameTriangle& triangle, Side branch) {
  return triangle.is_flat() ? std::nullopt : std::optional(branch);
}

template <class T>
FourBarPosition<T> with_crank(const FourBarLengths& of, const Vector<T>& crank, std::optional<Side> branch) {
  const Point<T> A0{T(0), T(0)}, A = A0 + from_rational<T>(of.A0A) * crank;
  return {crank, {A0, A, A, rocker_hinge<T>(of)}, branch};  // B is to follow
}

}  // namespace positions

// The rocker turns back: A₀, A, B in line, A₀B = A₀A + AB (extended) or |A₀A - AB| (folded).
// Throws Impossible when A₀B and B₀B then do not reach each other (the rocker has no such dead centre), or when B
// folds onto A₀ (AB = A₀A: no one crank direction is named).
template <class T>
FourBarPosition<T> dead_centre(const FourBarLengths& of, Reach reach, Side branch) {
  const Rational A0B = reach == Reach::extended ? Rational(of.A0A + of.AB) : Rational(of.A0A - of.AB);
  if (A0B == 0)
    throw Impossible(
        frame_squared(of) == of.B0B * of.B0B
            ? Phrase{"crank and coupler fold onto each other in every direction: B then rests on A0",
                     "manovella e biella si ripiegano l'una sull'altra in ogni direzione: B resta allora su A0"}
            : Phrase{"crank and coupler are equally long, and B cannot fold onto A0",
                     "manovella e biella sono ugualmente lunghe, e B non può ripiegarsi su A0"});
  const FrameTriangle A0B0B = frame_triangle(
      of, A0B, of.B0B, {"the rocker has no such dead centre", "il bilanciere non ha questo punto morto"});
  // Folded, AB runs against the crank: B is on the other side of A -> B₀ than the crank is of A₀ -> B₀.
  const Vector<T> u = A0B0B.direction<T>(of, reach == Reach::extended ? branch : opposite(branch));
  FourBarPosition<T> found = positions::with_crank(of, u, positions::unless_flat(A0B0B, branch));
  found.at.B = found.at.A0 + from_rational<T>(A0B) * u;
  return found;
}

// The crank turns back: A, B, B₀ in line, AB₀ = AB + B₀B (extended) or |AB - B₀B| (folded). Both branches meet here,
// so the position is named by the side of A₀ -> B₀ on which the crank lies.
// Throws Impossible when A₀A and AB₀ then do not reach each other (the crank has no such limit), or when A folds onto
// B₀ (AB = B₀B: B is not determined).
template <class T>
FourBarPosition<T> crank_limit(const FourBarLengths& of, Reach reach, Side crank_side) {
  const Rational AB0 = reach == Reach::extended ? Rational(of.AB + of.B0B) : Rational(of.AB - of.B0B);
  if (AB0 == 0)
    throw Impossible(frame_squared(of) == of.A0A * of.A0A
                         ? Phrase{"A folds onto B0, and coupler and rocker turn there together in every direction",
                                  "A si ripiega su B0, e lì biella e bilanciere ruotano insieme in ogni direzione"}
                         : Phrase{"coupler and rocker are equally long, and A cannot fold onto B0",
                                  "biella e bilanciere sono ugualmente lunghi, e A non può ripiegarsi su B0"});
  const FrameTriangle A0B0A = frame_triangle(
      of, of.A0A, AB0, {"the crank has no such limit position", "la manovella non ha questa posizione limite"});
  FourBarPosition<T> found = positions::with_crank(of, A0B0A.direction<T>(of, crank_side), std::nullopt);
  found.at.B = found.at.A + from_rational<T>(of.AB / AB0) * (found.at.B0 - found.at.A);
  return found;
}

// Crank and rocker parallel: the coupler's pole is at infinity. The coupler, shifted along until B falls on B₀, has
// its other end on the crank's line, A₀A - B₀B (same sense) or A₀A + B₀B (opposite) from A₀. Throws Impossible when
// that triangle does not close. When A₀A = B₀B in the same sense it has no such corner: the coupler then has to be as
// long as the frame, and the parallelogram is parallel in every position of one branch.
template <class T>
FourBarPosition<T> parallel_position(const FourBarLengths& of, Sense sense, Side branch) {
  const Rational shifted = sense == Sense::same ? Rational(of.A0A - of.B0B) : Rational(of.A0A + of.B0B);
  if (shifted == 0)
    throw Impossible(
        frame_squared(of) == of.AB * of.AB
            ? Phrase{"the linkage is a parallelogram: crank and rocker are parallel in every position of a branch",
                     "il meccanismo è un parallelogramma: manovella e bilanciere sono paralleli in ogni posizione di "
                     "un ramo"}
            : Phrase{"crank and rocker are equally long and the coupler is no parallel to the frame",
                     "manovella e bilanciere sono ugualmente lunghi e la biella non è parallela al telaio"});
  const FrameTriangle triangle = frame_triangle(of, shifted, of.AB,
                                                {"crank and rocker are never parallel in this sense",
                                                 "manovella e bilanciere non sono mai paralleli in questo verso"});
  const Vector<T> u = triangle.direction<T>(of, sense == Sense::same ? branch : opposite(branch));
  FourBarPosition<T> found = positions::with_crank(of, u, positions::unless_flat(triangle, branch));
  found.at.B = found.at.B0 + from_rational<T>(sense == Sense::same ? of.B0B : -of.B0B) * u;
  return found;
}

// Where the crank can be: the arcs of directions in which the linkage closes, each from one limit position
// counter-clockwise to another. None when the crank turns fully, one or two when it does not.
template <class T>
struct CrankLimit {
  Reach reach;
  Side crank_side;
  FourBarPosition<T> position;
};
template <class T>
struct CrankArc {
  CrankLimit<T> from, to;
};
template <class T>
struct CrankArcs {
  bool is_full_turn;
  std::vector<CrankArc<T>> arcs;
};

// AB₀ grows as the crank turns away from A₀ -> B₀, the same on both sides: too near the one way, too far the other.
// Throws Impossible when the linkage does not close for any direction of the crank.
template <class T>
CrankArcs<T> crank_range(const FourBarLengths& of) {
  const Span AB0 = span(of);
  if (AB0.nearest_to_most == Sign::positive)
    throw Impossible("the four-bar does not close: A is always too far from B0",
                     "il quadrilatero non si chiude: A è sempre troppo lontano da B0");
  if (AB0.farthest_to_least == Sign::negative)
    throw Impossible("the four-bar does not close: A is always too near to B0",
                     "il quadrilatero non si chiude: A è sempre troppo vicino a B0");
  const bool is_too_near = AB0.nearest_to_least == Sign::negative,
             is_too_far = AB0.farthest_to_most == Sign::positive;
  const auto limit = [&](Reach reach, Side side) {
    return CrankLimit<T>{reach, side, crank_limit<T>(of, reach, side)};
  };
  const auto extended = [&](Side side) { return limit(Reach::extended, side); };
  const auto folded = [&](Side side) { return limit(Reach::folded, side); };
  if (is_too_near && is_too_far)
    return {false, {{folded(Side::left), extended(Side::left)}, {extended(Side::right), folded(Side::right)}}};
  if (is_too_far) return {false, {{extended(Side::right), extended(Side::left)}}};
  if (is_too_near) return {false, {{folded(Side::left), folded(Side::right)}}};
  return {true, {}};
}

}  // namespace epure::geometry
