// Bodies cut free, and their equilibrium found one after the other with ruler and triangle: what a course in
// graphical statics does with the bodies of a mechanism, in the order in which they can be solved.
//
// Body 1 is the frame. What acts from body i on body j (R_ij) acts on i reversed. Of each body the forces that are
// known are summed to one; what is unknown decides the construction:
//   two points, no load          a bar: both forces on the line of the points
//   a line and a guide           force triangle: two directions are known (a guide takes any couple)
//   a line and a point           three forces meet in H; the third line runs from the point to H, then the triangle
//   three lines                  Culmann: two of them meet in K, and their sum runs from H to K; two triangles
//   a couple and a point         the point answers with the sum reversed, the couple is force times arm
// Parallel forces have no triangle: they are shared out with a funicular polygon. What is unstable or statically
// undetermined is said so, never divided by.
//
// A force is its line of action with the weight of the force: line(P, f). The sum of two such lines is the line of
// their resultant, also of parallel forces; a couple is the line at infinity, (0, 0, moment).
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "geometry/constructions/vector_polygon.h"
#include "geometry/numbers/parallel_angles.h"

namespace epure::geometry {

// ---------------------------------------------------------------------------------------------------------------------
// One body.

template <class T>
Line<T> operator+(const Line<T>& F, const Line<T>& G) {
  return {F.a + G.a, F.b + G.b, F.c + G.c};
}
template <class T>
Line<T> operator-(const Line<T>& F) {
  return {-F.a, -F.b, -F.c};
}
template <class T>
Line<T> operator*(const T& s, const Line<T>& F) {
  return {s * F.a, s * F.b, s * F.c};
}

// Of a force, times w: its moment about P, counter-clockwise positive.
template <class T>
T moment_about(const ProjectivePoint<T>& P, const Line<T>& F) {
  return F.a * P.x + F.b * P.y + F.c * P.w;
}

// A direction with a point of its line, along which a force of unknown size acts.
template <class T>
struct LineOfAction {
  Point<T> at;
  Vector<T> along;
  Line<T> unit() const { return line(at, along); }
};

namespace statics {

template <class T>
bool is_zero(const T& x, const Phrase& question) {
  const Sign decided = sign(x);
  if (decided == Sign::undecided) throw Undecided(question);
  return decided == Sign::zero;
}
inline constexpr Phrase parallel_question{"whether two forces are parallel", "se due forze siano parallele"};
inline constexpr Phrase through_question{"whether a line of action passes through a hinge",
                                         "se una retta d'azione passi per una cerniera"};

}  // namespace statics

// F shared out between two lines parallel to it, by a funicular polygon: its pole stands off the middle of F by
// the length of F.
template <class T>
struct SharedLoad {
  Line<T> first, second;               // the parts, on b and on c
  Point<T> on_first, on_F, on_second;  // corners of the funicular polygon
  Vector<T> pole, between;             // of the force polygon, from where F starts: between the two parts
};
template <class T>
SharedLoad<T> share_between_parallels(const Line<T>& F, const LineOfAction<T>& b, const LineOfAction<T>& c) {
  const Vector<T> f = F.direction();
  const Point<T> start{T(0), T(0)}, end{f.x, f.y};
  const Point<T> pole = midpoint(start, end) + quarter_turn(f);
  const Point<T> on_F = finite(meet(line(b.at, start - pole), F));
  const Point<T> on_c = finite(meet(line(on_F, end - pole), line(c.at, f)));
  const Point<T> between = finite(meet(line(pole, on_c - b.at), line(start, f)));
  return {line(b.at, between - start), line(c.at, end - between), b.at, on_F, on_c, pole - start, between - start};
}

// What balances F along two lines of action.
template <class T>
struct Balance {
  Line<T> first, second;
};

// Force triangle: F, then along u, then along w; w of any place. Throws Impossible when u and w are parallel.
template <class T>
Balance<T> force_triangle(const Line<T>& F, const LineOfAction<T>& u, const LineOfAction<T>& w) {
  const auto [of_u, minus_w] = close_polygon(F.direction(), u.along, w.along);
  return {of_u * u.unit(), -(minus_w * w.unit())};
}

// Three forces meet in H: F, one along u, one through O, which may be at infinity (a direction). H is at infinity for
// parallel forces. `is_parallel`: F and u are known to be; `passes`: F is known to pass through O; else it is asked.
// Throws Impossible when u passes through O.
template <class T>
struct ThreeForces {
  ProjectivePoint<T> H;
  Line<T> on_line, through_point;
};
template <class T>
ThreeForces<T> three_forces(const Line<T>& F, const LineOfAction<T>& u, const ProjectivePoint<T>& O,
                            bool is_parallel = false, bool passes = false) {
  if (statics::is_zero(moment_about(O, u.unit()), statics::through_question)) {
    if (statics::is_zero(moment_about(O, F), statics::through_question))
      throw Impossible(
          "its forces all pass through one point: how they share the load is statically undetermined",
          "le sue forze passano tutte per un punto: come si dividano il carico è staticamente indeterminato");
    throw Impossible(
        "it is unstable: the line of the force that should hold it passes through its support, and has no arm",
        "è labile: la retta della forza che dovrebbe reggerlo passa per il suo appoggio, e non ha braccio");
  }
  if (passes || statics::is_zero(moment_about(O, F), statics::through_question))
    return {meet(F, u.unit()), T(0) * u.unit(), -F};
  if (!is_parallel && !statics::is_zero(cross(F.direction(), u.along), statics::parallel_question)) {
    const ProjectivePoint<T> H = meet(F, u.unit());
    const Line<T> third = line(O, H);
    const auto [of_u, minus_third] = close_polygon(F.direction(), u.along, third.direction());
    return {H, of_u * u.unit(), -(minus_third * third)};
  }
  const ProjectivePoint<T> H{u.along.x, u.along.y, T(0)};
  if (statics::is_zero(O.w, statics::parallel_question)) {
    // The line alone balances F, and the guide answers with a couple where the two are not in one line.
    const Line<T> on_u = quotient(-dot(F.direction(), u.along), length_squared(u.along)) * u.unit();
    return {H, on_u, -(F + on_u)};
  }
  const SharedLoad<T> shared = share_between_parallels(F, u, {finite(O), u.along});
  return {H, -shared.first, -shared.second};
}

// Culmann: F and a meet in H, b and c in K; the sum of the forces on b and c runs along HK.
template <class T>
struct Culmann {
  ProjectivePoint<T> H, K;
  Line<T> resultant;  // of b and c
  Line<T> a, b, c;
  std::optional<SharedLoad<T>> shared = {};  // where b and c are parallel
};
template <class T>
Culmann<T> culmann(const Line<T>& F, const LineOfAction<T>& a, const LineOfAction<T>& b, const LineOfAction<T>& c,
                   bool is_parallel = false) {
  const ProjectivePoint<T> K = meet(b.unit(), c.unit());
  const ThreeForces<T> three = three_forces(F, a, K, is_parallel);
  const Line<T>& R = three.through_point;
  if (statics::is_zero(K.w, statics::parallel_question)) {
    const SharedLoad<T> shared = share_between_parallels(R, b, c);
    return {three.H, K, R, three.on_line, shared.first, shared.second, shared};
  }
  const Balance<T> parts = force_triangle(-R, b, c);
  return {three.H, K, R, three.on_line, parts.first, parts.second};
}

// ---------------------------------------------------------------------------------------------------------------------
// A mechanism.

template <class T>
class FreeBodies {
 public:
  explicit FreeBodies(int bodies) : bodies_(bodies) {}

  // A known force on body j, as x, y of a point of its line and its components.
  void load(const std::string& name, int j, const T& x, const T& y, const T& fx, const T& fy) {
    known_.insert_or_assign(name, line(Point<T>{x, y}, Vector<T>{fx, fy}));
    actions_.push_back({name, 0, j, Kind::line, {{x, y}, {fx, fy}}});
  }
  // A force of unknown size: of the outside on body j, or of body i on body j where these touch.
  void effort(const std::string& name, int j, const T& x, const T& y, const T& ux, const T& uy) {
    contact(name, 0, j, x, y, ux, uy);
  }
  void contact(const std::string& name, int i, int j, const T& x, const T& y, const T& ux, const T& uy) {
    actions_.push_back({name, i, j, Kind::line, {{x, y}, {ux, uy}}});
  }
  // Of body i on body j through a hinge.
  void hinge(const std::string& name, int i, int j, const T& x, const T& y) {
    actions_.push_back({name, i, j, Kind::point, {{x, y}, {T(0), T(0)}}});
  }
  // Of a guide of body i on body j, or the other way round: its direction is known, its place is not.
  void guide(const std::string& name, int i, int j, const T& ux, const T& uy) {
    actions_.push_back({name, i, j, Kind::guide, {{T(0), T(0)}, {ux, uy}}});
  }
  void couple(const std::string& name, int j) { actions_.push_back({name, 0, j, Kind::couple, {}}); }

  // Of a force whose line stands at a known angle. Whether two such lines are parallel is decided on their angles,
  // as it cannot be asked of every number.
  void directed(const std::string& name, const Angle& direction) { directions_.insert_or_assign(name, direction); }
  // Of a force whose line is known to pass through a hinge, which cannot be asked of every number either.
  void through(const std::string& name, const std::string& hinge) { through_.insert({name, hinge}); }

  // Solves body after body. Throws Impossible, naming the body, when one cannot be in equilibrium, and when none can
  // be solved of what is left.
  void solve() {
    while (!is_solved()) {
      bool has_moved = false;
      for (int j = 2; j <= bodies_; ++j) has_moved |= solve_named(j);
      if (!has_moved)
        throw Impossible("the forces of these bodies are statically undetermined",
                         "le forze di questi corpi sono staticamente indeterminate");
    }
  }

  // After solve: the force, as it acts on the second body of its name, and its line of action.
  const Line<T>& line_of(const std::string& name) const { return known_.at(name); }
  Vector<T> force(const std::string& name) const { return line_of(name).direction(); }
  T moment(const std::string& name) const { return line_of(name).c; }
  // Signed, along the direction that its line was given.
  T along(const std::string& name) const {
    for (const Action& action : actions_)
      if (action.name == name) return quotient(dot(force(name), action.at.along), length(action.at.along));
    throw std::out_of_range("no force " + name);
  }
  // Where the three forces on body j meet.
  const ProjectivePoint<T>& H(int j) const { return meeting_.at(j); }
  // Of body j, which three lines hold: how the last two were found.
  const Culmann<T>& three_lines(int j) const { return three_lines_.at(j); }

 private:
  enum class Kind { line, point, guide, couple };
  struct Action {
    std::string name;
    int i, j;
    Kind kind;
    LineOfAction<T> at;
  };

  bool is_solved() const { return known_.size() == actions_.size(); }

  bool solve_named(int j) {
    try {
      return solve_body(j);
    } catch (const Impossible& why) {
      throw Impossible(Words{"body ", "il corpo "} + std::to_string(j) + ": " + why.words());
    }
  }

  // What acts on body j: the sum of the known, and the others.
  bool solve_body(int j) {
    Line<T> sum{T(0), T(0), T(0)};
    bool is_loaded = false;
    std::string load;  // the only known force; of several, none
    std::vector<const Action*> lines, points, guides, couples;
    for (const Action& action : actions_) {
      if (action.i != j && action.j != j) continue;
      if (const auto known = known_.find(action.name); known != known_.end()) {
        sum = sum + (action.j == j ? known->second : -known->second);
        load = is_loaded ? std::string() : action.name;
        is_loaded = true;
        continue;
      }
      (action.kind == Kind::line    ? lines
       : action.kind == Kind::point ? points
       : action.kind == Kind::guide ? guides
                                    : couples)
          .push_back(&action);
    }
    const auto count = [&](std::size_t l, std::size_t p, std::size_t g, std::size_t c) {
      return lines.size() == l && points.size() == p && guides.size() == g && couples.size() == c;
    };
    if (!is_loaded) return lines.empty() && couples.empty() && make_bar(points, guides);
    if (count(1, 0, 0, 0)) {
      put(j, *lines[0], -sum);
    } else if (count(1, 0, 1, 0)) {
      const ThreeForces<T> found = three_forces(sum, lines[0]->at, direction_of(*guides[0]),
                                                are_parallel(load, *lines[0]), are_parallel(load, *guides[0]));
      meeting_.insert_or_assign(j, found.H);
      put(j, *lines[0], found.on_line);
      put(j, *guides[0], found.through_point);
    } else if (count(1, 1, 0, 0)) {
      const ThreeForces<T> found =
          three_forces(sum, lines[0]->at, projective(points[0]->at.at), are_parallel(load, *lines[0]),
                       through_.contains({load, points[0]->name}));
      meeting_.insert_or_assign(j, found.H);
      put(j, *lines[0], found.on_line);
      put(j, *points[0], found.through_point);
    } else if (count(3, 0, 0, 0)) {
      const Culmann<T> found = culmann(sum, lines[0]->at, lines[1]->at, lines[2]->at, are_parallel(load, *lines[0]));
      meeting_.insert_or_assign(j, found.H);
      three_lines_.insert_or_assign(j, found);
      put(j, *lines[0], found.a);
      put(j, *lines[1], found.b);
      put(j, *lines[2], found.c);
    } else if (count(0, 1, 0, 1)) {
      const Line<T> answer = -line(points[0]->at.at, sum.direction());
      put(j, *points[0], answer);
      put(j, *couples[0], {T(0), T(0), -(sum + answer).c});
    } else {
      return false;
    }
    return true;
  }

  // A bar without load: its two forces act along one line. They stay unknown in size, but no more in line.
  bool make_bar(const std::vector<const Action*>& points, const std::vector<const Action*>& guides) {
    LineOfAction<T> bar;
    if (points.size() == 2 && guides.empty())
      bar = {points[0]->at.at, points[0]->at.at - points[1]->at.at};
    else if (points.size() == 1 && guides.size() == 1)
      bar = {points[0]->at.at, guides[0]->at.along};
    else
      return false;
    for (const auto* ends : {&points, &guides})
      for (const Action* end : *ends) bars_.push_back({end->name, bar});
    if (!guides.empty() && directions_.contains(guides[0]->name))
      directed(points[0]->name, directions_.at(guides[0]->name));
    for (Action& action : actions_)
      for (const auto& [name, at] : bars_)
        if (action.name == name) action.kind = Kind::line, action.at = at;
    return true;
  }

  bool are_parallel(const std::string& one, const Action& other) const {
    const auto a = directions_.find(one), b = directions_.find(other.name);
    return a != directions_.end() && b != directions_.end() && geometry::are_parallel(a->second, b->second);
  }
  static ProjectivePoint<T> direction_of(const Action& guide) { return {guide.at.along.x, guide.at.along.y, T(0)}; }

  void put(int j, const Action& action, const Line<T>& on_j) {
    known_.insert_or_assign(action.name, action.j == j ? on_j : -on_j);
  }

  int bodies_;
  std::vector<Action> actions_;
  std::map<std::string, Line<T>> known_;
  std::map<int, ProjectivePoint<T>> meeting_;
  std::map<int, Culmann<T>> three_lines_;
  std::vector<std::pair<std::string, LineOfAction<T>>> bars_;
  std::map<std::string, Angle> directions_;
  std::set<std::pair<std::string, std::string>> through_;
};

}  // namespace epure::geometry
