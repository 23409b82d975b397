#include "geometry/statics/truss.h"

#include <algorithm>
#include <string>

namespace epure::geometry {
namespace {

using Joint = std::size_t;
using HalfEdge = std::size_t;  // of bar b: 2b from its first joint to its second, 2b + 1 back
constexpr std::size_t none = static_cast<std::size_t>(-1);

Words told_joint(const Truss& truss, Joint joint) {
  return Words{} + (truss.names.empty() ? std::to_string(joint + 1) : truss.names[joint]);
}
// "3", or "3 (A C)".
Words told_bar(const Truss& truss, std::size_t bar) {
  const std::string count = std::to_string(bar + 1);
  if (truss.names.empty()) return Words{} + count;
  return Words{} + (count + " (" + truss.names[truss.bars[bar].from] + " " + truss.names[truss.bars[bar].to] + ")");
}

int turn(const Vector<Rational>& u, const Vector<Rational>& v) { return CGAL::sign(cross(u, v)); }
int turn(const Point<Rational>& P, const Point<Rational>& Q, const Point<Rational>& R) { return turn(Q - P, R - P); }

bool coincide(const Point<Rational>& P, const Point<Rational>& Q) { return P.x == Q.x && P.y == Q.y; }

// X, in line with PQ, lies between P and Q or on one of them.
bool is_between(const Point<Rational>& X, const Point<Rational>& P, const Point<Rational>& Q) {
  return dot(P - X, Q - X) <= 0;
}

// Bars without a common joint.
bool meet_anywhere(const Truss& truss, const TrussBar& one, const TrussBar& other) {
  const auto &A = truss.joints[one.from], &B = truss.joints[one.to];
  const auto &C = truss.joints[other.from], &D = truss.joints[other.to];
  const int c = turn(A, B, C), d = turn(A, B, D), a = turn(C, D, A), b = turn(C, D, B);
  if (c * d < 0 && a * b < 0) return true;
  return (c == 0 && is_between(C, A, B)) || (d == 0 && is_between(D, A, B)) || (a == 0 && is_between(A, C, D)) ||
         (b == 0 && is_between(B, C, D));
}

// Bars with a common joint: they leave it one way.
bool lie_on_each_other(const Truss& truss, std::size_t one, std::size_t other) {
  const TrussBar &a = truss.bars[one], &b = truss.bars[other];
  const Vector<Rational> u = along(truss, one);
  const Vector<Rational> v = a.from == b.from || a.to == b.to ? along(truss, other) : -along(truss, other);
  return turn(u, v) == 0 && dot(u, v) > 0;
}

bool have_common_joint(const TrussBar& a, const TrussBar& b) {
  return a.from == b.from || a.from == b.to || a.to == b.from || a.to == b.to;
}

void demand_flat(const Truss& truss) {
  for (Joint i = 0; i < truss.joints.size(); ++i)
    for (Joint k = 0; k < i; ++k)
      if (coincide(truss.joints[i], truss.joints[k]))
        throw Impossible(Words{"joints ", "i nodi "} + told_joint(truss, k) + Words{" and ", " e "} +
                         told_joint(truss, i) + Words{" are in one place", " sono nello stesso punto"});
  for (std::size_t i = 0; i < truss.bars.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const TrussBar &a = truss.bars[k], &b = truss.bars[i];
      if (have_common_joint(a, b) ? lie_on_each_other(truss, k, i) : meet_anywhere(truss, a, b))
        throw Impossible(
            Words{"bars ", "le aste "} + told_bar(truss, k) + Words{" and ", " e "} + told_bar(truss, i) +
            Words{" cross or touch: the truss is not flat, and has no regions between its bars",
                  " si incrociano o si toccano: la travatura non è piana, e non ha regioni tra le aste"});
    }
}

void demand_enough_bars(const Truss& truss) {
  const std::size_t unknowns = truss.bars.size() + 3, equations = 2 * truss.joints.size();
  if (unknowns == equations) return;
  const Words count =
      std::to_string(truss.bars.size()) +
      Words{" bars and 3 components of reaction, against ", " aste e 3 componenti di reazione, contro "} +
      std::to_string(equations) + Words{" equations of its joints", " equazioni dei nodi"};
  throw Impossible((unknowns < equations ? Words{"the truss is unstable: ", "la travatura è labile: "}
                                         : Words{"the truss is statically undetermined: ",
                                                 "la travatura è staticamente indeterminata: "}) +
                   count);
}

// The faces of the truss as a plane graph, each on the left of its half-edges.
class Faces {
 public:
  explicit Faces(const Truss& truss) : truss_(truss), face_of_(2 * truss.bars.size(), none) {
    sort_round_joints();
    for (HalfEdge h = 0; h < face_of_.size(); ++h) {
      if (face_of_[h] != none) continue;
      cycles_.emplace_back();
      for (HalfEdge at = h; face_of_[at] == none; at = next(at)) {
        face_of_[at] = cycles_.size() - 1;
        cycles_.back().push_back(at);
      }
    }
    // Of each part that is apart from the others one face lies outside.
    for (std::size_t f = 0; f < cycles_.size(); ++f) {
      if (twice_area(f) > 0) continue;
      if (outer_ != none)
        throw Impossible("the truss is in parts that no bar joins",
                         "la travatura è in parti che nessuna asta unisce");
      outer_ = f;
    }
    for (Joint i = 0; i < truss.joints.size(); ++i)
      if (round_[i].empty())
        throw Impossible(Words{"no bar ends in joint ", "nessuna asta arriva al nodo "} + told_joint(truss, i));
  }

  Joint origin(HalfEdge h) const { return h % 2 == 0 ? truss_.bars[h / 2].from : truss_.bars[h / 2].to; }
  Joint end(HalfEdge h) const { return origin(h ^ 1U); }
  std::size_t outer() const { return outer_; }
  std::size_t face_of(HalfEdge h) const { return face_of_[h]; }
  const std::vector<std::vector<HalfEdge>>& cycles() const { return cycles_; }

 private:
  Vector<Rational> direction(HalfEdge h) const { return truss_.joints[end(h)] - truss_.joints[origin(h)]; }

  // What leaves each joint, counter-clockwise from +x.
  void sort_round_joints() {
    round_.resize(truss_.joints.size());
    for (HalfEdge h = 0; h < face_of_.size(); ++h) round_[origin(h)].push_back(h);
    const auto is_in_lower_half = [](const Vector<Rational>& v) { return v.y < 0 || (v.y == 0 && v.x < 0); };
    for (auto& leaving : round_)
      std::sort(leaving.begin(), leaving.end(), [&](HalfEdge a, HalfEdge b) {
        const Vector<Rational> u = direction(a), v = direction(b);
        if (is_in_lower_half(u) != is_in_lower_half(v)) return is_in_lower_half(v);
        return turn(u, v) > 0;
      });
  }

  // The half-edge that keeps the face on the left: at its end the first one clockwise from the way back.
  HalfEdge next(HalfEdge h) const {
    const auto& leaving = round_[end(h)];
    const auto back = std::find(leaving.begin(), leaving.end(), h ^ 1U);
    return back == leaving.begin() ? leaving.back() : *(back - 1);
  }

  Rational twice_area(std::size_t face) const {
    Rational sum(0);
    for (const HalfEdge h : cycles_[face]) {
      const auto &P = truss_.joints[origin(h)], &Q = truss_.joints[end(h)];
      sum += P.x * Q.y - P.y * Q.x;
    }
    return sum;
  }

  const Truss& truss_;
  std::vector<std::vector<HalfEdge>> round_;
  std::vector<std::size_t> face_of_;
  std::vector<std::vector<HalfEdge>> cycles_;
  std::size_t outer_ = none;
};

// Clockwise round the outline, from the joint of the first force on, parted by the forces.
void part_outside(const Truss& truss, const Faces& faces, BowNotation& bow) {
  std::vector<HalfEdge> cycle = faces.cycles()[faces.outer()];
  const auto start =
      std::find_if(cycle.begin(), cycle.end(), [&](HalfEdge h) { return faces.origin(h) == truss.outside.front(); });
  std::vector<bool> is_placed(truss.outside.size(), false);
  const auto place_forces = [&](Joint at) {
    for (std::size_t k = 1; k < truss.outside.size(); ++k)
      if (truss.outside[k] == at && !is_placed[k]) {
        is_placed[k] = true;
        bow.forces.push_back(k);
      }
  };
  if (start != cycle.end()) {
    std::rotate(cycle.begin(), start, cycle.end());
    is_placed[0] = true;
    place_forces(truss.outside.front());
    for (const HalfEdge h : cycle) {
      bow.outline.push_back({h / 2, h % 2 == 0, bow.forces.size()});
      place_forces(faces.end(h));
    }
    bow.forces.push_back(0);
  }
  for (std::size_t k = 0; k < is_placed.size(); ++k)
    if (!is_placed[k])
      throw Impossible(Words{"a force acts inside of the truss, at joint ",
                             "una forza agisce all'interno della travatura, nel nodo "} +
                       told_joint(truss, truss.outside[k]) + Words{": it parts no regions", ": non separa regioni"});
}

std::optional<Joint> common_joint(const TrussBar& a, const TrussBar& b) {
  if (a.from == b.from || a.from == b.to) return a.from;
  if (a.to == b.from || a.to == b.to) return a.to;
  return {};
}

// Region by region: each that has two known neighbours beyond bars of different directions.
class Order {
 public:
  Order(const Truss& truss, const Faces& faces, BowNotation& bow)
      : truss_(truss),
        faces_(faces),
        bow_(bow),
        region_of_(2 * truss.bars.size(), none),
        is_used_(truss.bars.size()) {
    for (const BowNotation::Edge& edge : bow.outline)
      region_of_[2 * edge.bar + (edge.is_forward ? 0 : 1)] = edge.region;
  }

  void find() {
    while (bow_.steps.size() + 1 < faces_.cycles().size())
      if (!find_next())
        throw Impossible(
            "the plan of forces stops: no region that is left has two known neighbours; the truss is compound or "
            "unstable, or bars meet inside of it at a joint of two",
            "il diagramma delle forze si ferma: nessuna regione che resta ha due vicine note; la travatura è "
            "composta o labile, o al suo interno due aste sole si incontrano in un nodo");
    for (std::size_t bar = 0; bar < is_used_.size(); ++bar) {
      bow_.sides.push_back({region_of_[2 * bar], region_of_[2 * bar + 1]});
      if (!is_used_[bar]) bow_.closing_bar = bar;
    }
  }

 private:
  bool find_next() {
    for (std::size_t face = 0; face < faces_.cycles().size(); ++face)
      if (face != faces_.outer() && region_of_[faces_.cycles()[face].front()] == none && finds(face)) return true;
    return false;
  }

  bool finds(std::size_t face) {
    const std::vector<HalfEdge>& cycle = faces_.cycles()[face];
    for (auto one = cycle.begin(); one != cycle.end(); ++one) {
      if (region_of_[*one ^ 1U] == none) continue;
      for (auto other = one + 1; other != cycle.end(); ++other) {
        if (region_of_[*other ^ 1U] == none) continue;
        const std::size_t a = *one / 2, b = *other / 2;
        if (turn(along(truss_, a), along(truss_, b)) == 0) continue;
        const std::size_t region = bow_.regions();
        bow_.steps.push_back({region, {a, b}, common_joint(truss_.bars[a], truss_.bars[b])});
        is_used_[a] = is_used_[b] = true;
        bow_.corners.emplace_back();
        for (const HalfEdge h : cycle) {
          region_of_[h] = region;
          bow_.corners.back().push_back(faces_.origin(h));
        }
        return true;
      }
    }
    return false;
  }

  const Truss& truss_;
  const Faces& faces_;
  BowNotation& bow_;
  std::vector<std::size_t> region_of_;  // on the left of each half-edge
  std::vector<bool> is_used_;
};

}  // namespace

BowNotation bow_notation(const Truss& truss) {
  demand_flat(truss);
  const Faces faces(truss);
  demand_enough_bars(truss);
  BowNotation bow{};
  part_outside(truss, faces, bow);
  Order(truss, faces, bow).find();
  return bow;
}

}  // namespace epure::geometry
