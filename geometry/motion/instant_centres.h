// The instant centres of a whole mechanism: the joints give some, and by the theorem of Aronhold and Kennedy (the
// centres of three bodies lie in line) each of the others is where two lines meet:
//
//   P_ij  on  P_ik P_kj  and on  P_il P_lj
//
// Bodies are numbered from 1, the frame. A four-bar: instant_centres<T>(4, {hinge(1, 2, A0), hinge(2, 3, A),
// hinge(3, 4, B), hinge(1, 4, B0)}).
#pragma once

#include "geometry/constructions/plane.h"

#include <optional>
#include <string>
#include <vector>

namespace epure::geometry {

// Two bodies whose centre is known from the start.
template <class T>
struct Joint {
  int i, j;
  ProjectivePoint<T> centre;
};

template <class T>
Joint<T> hinge(int i, int j, const Point<T>& P) {
  return {i, j, projective(P)};
}
// Body j slides on body i, or i on j: their centre lies infinitely far away, square to the guide.
template <class T>
Joint<T> slider(int i, int j, const Vector<T>& along_guide) {
  const Vector<T> n = quarter_turn(along_guide);
  return {i, j, {n.x, n.y, T(0)}};
}

// How a centre P_ij was found: on the line of P_ik and P_kj, and on that of P_il and P_lj.
template <class T>
struct KennedyLines {
  int k, l;
  Line<T> through_k, through_l;
};

// A joint has a centre and no lines; an undetermined centre has neither.
template <class T>
struct InstantCentre {
  int i, j;  // i < j
  std::optional<ProjectivePoint<T>> at = {};
  std::optional<KennedyLines<T>> lines = {};
};

template <class T>
class InstantCentres {
 public:
  // The centre of bodies i and j, in either order. Two different bodies of the mechanism: else a caller's mistake
  // (std::out_of_range).
  const InstantCentre<T>& of(int i, int j) const {
    for (const InstantCentre<T>& centre : in_order_)
      if ((centre.i == i && centre.j == j) || (centre.i == j && centre.j == i)) return centre;
    throw std::out_of_range("no two bodies " + std::to_string(i) + " and " + std::to_string(j));
  }
  // The centre itself. Throws Impossible when no two lines determine it.
  const ProjectivePoint<T>& at(int i, int j) const {
    const InstantCentre<T>& centre = of(i, j);
    if (!centre.at)
      throw Impossible(Words{"the instant centre of bodies ", "il centro d'istantanea rotazione dei corpi "} +
                       std::to_string(i) + Words{" and ", " e "} + std::to_string(j) +
                       Words{" is not determined in this position", " non è determinato in questa posizione"});
    return *centre.at;
  }
  // All n (n - 1)/2: the joints as given, the others as they were found, last the undetermined ones.
  const std::vector<InstantCentre<T>>& in_order() const { return in_order_; }

  explicit InstantCentres(std::vector<InstantCentre<T>> in_order) : in_order_(std::move(in_order)) {}

 private:
  std::vector<InstantCentre<T>> in_order_;
};

namespace kennedy {

// Whether coordinates known up to a factor say anything: not all of them are zero.
template <class T>
Truth is_determined(const T& a, const T& b, const T& c) {
  Truth truth = Truth::no;
  for (const T& x : {a, b, c}) {
    const Sign decided = sign(x);
    if (decided == Sign::undecided)
      truth = Truth::undecided;
    else if (decided != Sign::zero)
      return Truth::yes;
  }
  return truth;
}
template <class T>
Truth is_determined(const Line<T>& l) {
  return is_determined(l.a, l.b, l.c);
}
template <class T>
Truth is_determined(const ProjectivePoint<T>& P) {
  return is_determined(P.x, P.y, P.w);
}

// The search: a round looks at every centre that is still unknown, and what it finds serves the centres after it.
template <class T>
class Search {
 public:
  Search(int bodies, const std::vector<Joint<T>>& joints) : bodies_(bodies) {
    for (const Joint<T>& joint : joints)
      found_.push_back({std::min(joint.i, joint.j), std::max(joint.i, joint.j), joint.centre});
  }

  InstantCentres<T> run() {
    while (round()) {
    }
    if (!open_.empty()) throw Undecided(open_);
    for_unknown([&](int i, int j) { found_.push_back({i, j}); });
    return InstantCentres<T>(found_);
  }

 private:
  template <class Visit>
  void for_unknown(const Visit& visit) {
    for (int i = 1; i <= bodies_; ++i)
      for (int j = i + 1; j <= bodies_; ++j)
        if (!known(i, j)) visit(i, j);
  }

  const ProjectivePoint<T>* known(int i, int j) const {
    for (const InstantCentre<T>& centre : found_)
      if (centre.i == std::min(i, j) && centre.j == std::max(i, j) && centre.at) return &*centre.at;
    return nullptr;
  }

  bool round() {
    const auto before = found_.size();
    open_ = {};
    for_unknown([&](int i, int j) { look_for(i, j); });
    return found_.size() > before;
  }

  // The line of P_ik and P_kj, when both are known and do not coincide.
  std::optional<Line<T>> line_by(int i, int k, int j) {
    const ProjectivePoint<T>*first = known(i, k), *second = known(k, j);
    if (k == i || k == j || !first || !second) return std::nullopt;
    const Line<T> l = line(*first, *second);
    if (!holds(is_determined(l),
               {"whether two instant centres coincide", "se due centri d'istantanea rotazione coincidano"}))
      return std::nullopt;
    return l;
  }

  void look_for(int i, int j) {
    for (int k = 1; k <= bodies_; ++k)
      for (int l = k + 1; l <= bodies_; ++l) {
        const auto through_k = line_by(i, k, j), through_l = line_by(i, l, j);
        if (!through_k || !through_l) continue;
        const ProjectivePoint<T> P = meet(*through_k, *through_l);
        if (!holds(is_determined(P), {"whether two lines of instant centres are the same",
                                      "se due rette di centri d'istantanea rotazione coincidano"}))
          continue;
        found_.push_back({i, j, scaled(P), KennedyLines<T>{k, l, *through_k, *through_l}});
        return;
      }
  }

  // The same point with w = 1, unless it is or may be at infinity: else coordinates grow to the fourth power at each
  // step, and intervals overflow.
  static ProjectivePoint<T> scaled(const ProjectivePoint<T>& P) {
    const Sign w = sign(P.w);
    return w == Sign::positive || w == Sign::negative ? projective(finite(P)) : P;
  }

  // What cannot be told is passed over like what is degenerate, as another pair of lines may do; it is remembered
  // for the case that none does.
  bool holds(Truth truth, const Phrase& question) {
    if (truth == Truth::undecided) open_ = question;
    return truth == Truth::yes;
  }

  int bodies_;
  std::vector<InstantCentre<T>> found_;
  Words open_;
};

}  // namespace kennedy

// All instant centres of the mechanism. Two lines that coincide are passed over in favour of two others; a centre
// that no two different lines determine (in a dead centre, say, or for want of joints) is reported as undetermined.
// Throws Undecided when a centre is missing and the number cannot tell whether lines for it are degenerate.
template <class T>
InstantCentres<T> instant_centres(int bodies, const std::vector<Joint<T>>& joints) {
  return kennedy::Search<T>(bodies, joints).run();
}

// first : second. Neither is divided by the other, so that a body at rest, or in translation, has a ratio too.
template <class T>
struct Ratio {
  T first, second;
};

// ω_i : ω_j of two bodies against the frame, from their centres on the frame and their common centre: the point P_ij
// has one velocity, whichever body it is taken to belong to.
//   ω_i (P_1i P_ij) = ω_j (P_1j P_ij)
// Throws Impossible when all three centres are one point, or neither body turns: then nothing follows.
template <class T>
Ratio<T> angular_velocities(const ProjectivePoint<T>& P_1i, const ProjectivePoint<T>& P_1j,
                            const ProjectivePoint<T>& P_ij) {
  // The homogeneous vectors w w' (P_ij - P_1i) of one line; either may be zero, and the other then gives the line.
  const auto from = [&](const ProjectivePoint<T>& P) {
    return Vector<T>{P.w * P_ij.x - P_ij.w * P.x, P.w * P_ij.y - P_ij.w * P.y};
  };
  const Vector<T> i = from(P_1i), j = from(P_1j);
  const Vector<T> along = sign(length_squared(i)) == Sign::zero ? j : i;
  const Ratio<T> ratio{P_1i.w * dot(j, along), P_1j.w * dot(i, along)};
  const Sign first = sign(ratio.first), second = sign(ratio.second);
  if (first == Sign::zero && second == Sign::zero)
    throw Impossible("the instant centres do not fix the ratio of the two angular velocities",
                     "i centri d'istantanea rotazione non fissano il rapporto delle due velocità angolari");
  const auto may_vanish = [](Sign decided) { return decided == Sign::zero || decided == Sign::undecided; };
  if (may_vanish(first) && may_vanish(second))
    throw Undecided("whether the instant centres fix the ratio of two angular velocities",
                    "se i centri d'istantanea rotazione fissino il rapporto di due velocità angolari");
  return ratio;
}

}  // namespace epure::geometry
