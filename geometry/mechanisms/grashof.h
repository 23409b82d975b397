// Which links of a four-bar linkage turn fully: Grashof's rule, decided exactly on the lengths as given.
//
// The frame A₀B₀ = √(x² + y²) need not be rational. Every comparison is of a sum  rational + rational A₀B₀  with
// zero, and that is one of squares: so each question here has an answer, never "undecided", and no number type is
// needed.
#pragma once

#include "geometry/mechanisms/four_bar.h"

#include <algorithm>
#include <array>
#include <vector>

namespace epure::geometry {

inline Sign sign_of(const Rational& x) { return static_cast<Sign>(static_cast<int>(CGAL::sign(x))); }

// A₀B₀².
inline Rational frame_squared(const FourBarLengths& of) { return of.x_B0 * of.x_B0 + of.y_B0 * of.y_B0; }

// rational + frames · A₀B₀.
struct LinkSum {
  Rational rational, frames;
};
inline LinkSum operator+(const LinkSum& a, const LinkSum& b) {
  return {a.rational + b.rational, a.frames + b.frames};
}
inline LinkSum operator-(const LinkSum& a, const LinkSum& b) {
  return {a.rational - b.rational, a.frames - b.frames};
}

// Exact: where the two parts pull against each other, the one with the larger square wins.
inline Sign sign_of(const LinkSum& sum, const FourBarLengths& of) {
  const Sign rational = sign_of(sum.rational), frames = sign_of(Rational(sum.frames * frame_squared(of)));
  if (rational == frames) return rational;
  switch (sign_of(Rational(sum.rational * sum.rational - sum.frames * sum.frames * frame_squared(of)))) {
    case Sign::positive:
      return rational;
    case Sign::negative:
      return frames;
    default:
      return Sign::zero;
  }
}

enum class FourBarLink { frame, crank, coupler, rocker };  // A₀B₀, A₀A, AB, B₀B

inline LinkSum length_of(FourBarLink link, const FourBarLengths& of) {
  switch (link) {
    case FourBarLink::crank:
      return {of.A0A, 0};
    case FourBarLink::coupler:
      return {of.AB, 0};
    case FourBarLink::rocker:
      return {of.B0B, 0};
    default:
      return {0, 1};
  }
}

// The link that turns fully is the shortest or a neighbour of it, when shortest + longest < the other two together.
enum class LinkageClass {
  crank_rocker,   // crank shortest: it turns fully, the rocker swings
  rocker_crank,   // rocker shortest: it turns fully, the crank swings
  double_crank,   // frame shortest: both turn fully (drag link)
  double_rocker,  // coupler shortest: it turns fully against the others, crank and rocker swing
  change_point,   // shortest + longest = the other two: all hinges come in line, and two motions leave that position
  triple_rocker,  // shortest + longest > the other two: no link turns fully
  immovable       // longest = the other three together: one position, stretched
};

struct Grashof {
  LinkageClass is;
  // More than one when they are equally short (then never one of the first four classes).
  std::vector<FourBarLink> shortest;
  LinkSum excess;  // shortest + longest - the other two: its sign decides
};

// Throws Impossible when a link has no length, or the longest is longer than the other three together.
inline Grashof grashof(const FourBarLengths& of) {
  std::array<FourBarLink, 4> links{FourBarLink::frame, FourBarLink::crank, FourBarLink::coupler, FourBarLink::rocker};
  const auto length = [&](FourBarLink link) { return length_of(link, of); };
  const auto is_shorter = [&](FourBarLink a, FourBarLink b) {
    return sign_of(length(a) - length(b), of) == Sign::negative;
  };
  std::stable_sort(links.begin(), links.end(), is_shorter);
  const auto [s, p, q, l] = links;
  if (sign_of(length(s), of) != Sign::positive)
    throw Impossible("a link of the four-bar has no length", "un membro del quadrilatero non ha lunghezza");
  const Sign beyond_all = sign_of(length(l) - length(s) - length(p) - length(q), of);
  if (beyond_all == Sign::positive)
    throw Impossible("the four-bar does not close: its longest link is longer than the other three together",
                     "il quadrilatero non si chiude: il membro più lungo supera gli altri tre insieme");

  Grashof result{LinkageClass::triple_rocker, {}, length(s) + length(l) - length(p) - length(q)};
  for (const FourBarLink link : links)
    if (!is_shorter(s, link)) result.shortest.push_back(link);
  const Sign excess = sign_of(result.excess, of);
  if (beyond_all == Sign::zero) {
    result.is = LinkageClass::immovable;
  } else if (excess == Sign::zero) {
    result.is = LinkageClass::change_point;
  } else if (excess == Sign::negative) {
    // frame, crank, coupler, rocker
    constexpr std::array by_shortest{LinkageClass::double_crank, LinkageClass::crank_rocker,
                                     LinkageClass::double_rocker, LinkageClass::rocker_crank};
    result.is = by_shortest[static_cast<std::size_t>(s)];
  }
  return result;
}

// The same linkage with the roles of crank and rocker exchanged: the origin in B₀, A and B swapped.
inline FourBarLengths seen_from_rocker(const FourBarLengths& of) {
  return {of.B0B, of.AB, of.A0A, -of.x_B0, -of.y_B0};
}

// How AB₀, when A stands on the line A₀B₀, compares with what coupler and rocker can span: between |AB - B₀B| and
// AB + B₀B. A on the side of B₀ is nearest to it, A on the far side of A₀ farthest.
//   AB₀² = A₀A² + A₀B₀² ∓ 2 A₀A A₀B₀
struct Span {
  Sign nearest_to_least, nearest_to_most;    // sign of AB₀ nearest - |AB - B₀B|, of AB₀ nearest - (AB + B₀B)
  Sign farthest_to_least, farthest_to_most;  // the same of AB₀ farthest
};
inline Span span(const FourBarLengths& of) {
  const auto compare = [&](int towards, const Rational& reach) {
    const Rational squares = of.A0A * of.A0A + frame_squared(of) - reach * reach;
    return sign_of(LinkSum{squares, towards * Rational(2) * of.A0A}, of);
  };
  const Rational least = of.AB - of.B0B, most = of.AB + of.B0B;
  return {compare(-1, least), compare(-1, most), compare(1, least), compare(1, most)};
}

// The crank can be turned through all directions; it may pass change points on the way.
inline bool crank_turns_fully(const FourBarLengths& of) {
  const Span AB0 = span(of);
  return AB0.nearest_to_least != Sign::negative && AB0.farthest_to_most != Sign::positive;
}
inline bool rocker_turns_fully(const FourBarLengths& of) { return crank_turns_fully(seen_from_rocker(of)); }

}  // namespace epure::geometry
