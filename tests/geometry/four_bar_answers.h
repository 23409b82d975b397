// What the analytic route answers for a case of the four-bar corpus, under the corpus' names.
#pragma once

#include "geometry/analytic/four_bar_formulas.h"
#include "geometry/analytic/four_bar_special.h"
#include "tests/geometry/answers.h"
#include "tests/support/corpus.h"

#include <stdexcept>
#include <string>

namespace epure::tests::four_bar {

inline const std::vector<CorpusCase>& corpus() {
  static const std::vector<CorpusCase> cases = read_corpus(EPURE_CORPUS "/four_bar.txt");
  return cases;
}

inline analytic::FourBar linkage_of(const CorpusCase& c) {
  const auto& given = c.givens;
  return {given.at("A0A"), given.at("AB"), given.at("B0B"), given.at("x_B0"), given.at("y_B0")};
}

inline analytic::Branch branch_of(const CorpusCase& c) {
  return c.choices.at("branch") == "left" ? analytic::Branch::left : analytic::Branch::right;
}

inline analytic::Side C_side_of(const CorpusCase& c) {
  return c.choices.at("C_side") == "left" ? analytic::Side::left : analytic::Side::right;
}

// The direction of the crank: of the given turn, or of the special position that the case names.
template <class T>
Complex<T> crank_of(const CorpusCase& c) {
  using namespace analytic;
  const std::string& at = c.choices.at("crank_at");
  if (at == "turn") {
    const Turn turn{c.givens.at("turn")};
    return {cosine<T>(turn), sine<T>(turn)};
  }
  const FourBar g = linkage_of(c);
  const Branch branch = branch_of(c);
  if (at == "dead_centre_extended") return crank_at_dead_centre<T>(g, DeadCentre::extended, branch);
  if (at == "dead_centre_folded") return crank_at_dead_centre<T>(g, DeadCentre::folded, branch);
  if (at == "parallel_same_sense") return crank_parallel_to_rocker<T>(g, Parallel::same_sense, branch);
  if (at == "parallel_opposite_sense") return crank_parallel_to_rocker<T>(g, Parallel::opposite_sense, branch);
  throw std::runtime_error("no such position: " + at);
}

// The crank speed of the case, 2 π n/60.
template <class T>
T speed_of(const CorpusCase& c) {
  return from_rational<T>(c.givens.at("n") / 30) * pi<T>();
}

template <class T>
struct Scene {
  analytic::FourBar linkage;
  analytic::CrankState<T> crank;
  analytic::FourBarPosition<T> place;
  Complex<T> C_in_link;

  analytic::FourBarMotion<T> motion() const { return analytic::motion(linkage, crank, place); }
  analytic::PlaneMotion<T> coupler() const { return analytic::coupler(place, motion()); }
  analytic::PlaneMotion<T> rocker() const { return analytic::rocker(linkage, motion()); }
  analytic::PlaneMotion<T> crank_plane() const { return analytic::crank(crank); }

  // A, B, C, G2, G3, G4 and the link each belongs to.
  Complex<T> point(const std::string& name) const {
    const auto halfway = [](const Rational& length) { return Complex<T>{from_rational<T>(length / 2), T(0)}; };
    if (name == "A") return place.A;
    if (name == "B") return place.B;
    if (name == "C") return analytic::coupler_point(place, C_in_link);
    if (name == "G2") return analytic::crank_point(place, halfway(linkage.A0A));
    if (name == "G3") return analytic::coupler_point(place, halfway(linkage.AB));
    return analytic::rocker_point(linkage, place, halfway(linkage.B0B));
  }
  analytic::PlaneMotion<T> link(const std::string& name) const {
    if (name == "A" || name == "G2") return crank_plane();
    return name == "G4" || name == "B" ? rocker() : coupler();
  }
};

template <class T>
Scene<T> scene_of(const CorpusCase& c, const T& omega_2) {
  const analytic::FourBar g = linkage_of(c);
  const auto crank = analytic::crank_along<T>(crank_of<T>(c), omega_2, from_rational<T>(c.givens.at("alpha_2")));
  return {g, crank, analytic::position(g, crank, branch_of(c)),
          analytic::right_angled_plate_point<T>(g, c.givens.at("AC"), C_side_of(c))};
}

template <class T>
void add_velocities_and_accelerations(Answers<T>& answers, const Scene<T>& s) {
  using Maybe = std::optional<T>;
  const auto magnitude = [](const T& x) { return root(square(x)); };
  const auto v = [s](const std::string& name) { return s.link(name).velocity(s.point(name)); };
  const auto a = [s](const std::string& name) { return s.link(name).acceleration(s.point(name)); };
  const auto add = [&](const std::string& name, auto field) {
    add_point(answers, name, [field] { return std::optional(field()); });
    answers[name] = [field] { return Maybe(modulus(field())); };
  };
  for (const std::string name : {"A", "B", "C", "G2", "G3", "G4"}) {
    add("v_" + name, [v, name] { return v(name); });
    add("a_" + name, [a, name] { return a(name); });
  }
  for (const std::string name : {"B", "C", "G3"}) {
    const auto distance = [s, name] { return modulus(s.point(name) - s.point("A")); };
    answers["v_" + name + "A"] = [v, name] { return Maybe(modulus(v(name) - v("A"))); };
    answers["a_" + name + "A"] = [a, name] { return Maybe(modulus(a(name) - a("A"))); };
    answers["a_" + name + "A_n"] = [s, distance] { return Maybe(square(s.motion().omega_3) * distance()); };
    answers["a_" + name + "A_t"] = [s, distance, magnitude] {
      return Maybe(magnitude(s.motion().alpha_3) * distance());
    };
  }
  for (const std::string name : {"C", "G3"}) {
    const auto over_speed = [v, name](const T& x) {
      const T speed = modulus(v(name));
      if (sign(speed) == Sign::zero) throw Impossible("the point is at rest");
      return Maybe(quotient(root(square(x)), speed));
    };
    answers["a_" + name + "_n"] = [=] { return over_speed(cross(v(name), a(name))); };
    answers["a_" + name + "_t"] = [=] { return over_speed(dot(v(name), a(name))); };
  }
  const T c = from_rational<T>(s.linkage.B0B);
  answers["a_B_n"] = [s, c] { return Maybe(square(s.motion().omega_4) * c); };
  answers["a_B_t"] = [s, c, magnitude] { return Maybe(magnitude(s.motion().alpha_4) * c); };
  answers["omega_2"] = [s] { return Maybe(s.crank.omega); };
  answers["omega_3"] = [s] { return Maybe(s.motion().omega_3); };
  answers["omega_4"] = [s] { return Maybe(s.motion().omega_4); };
  answers["alpha_3"] = [s] { return Maybe(s.motion().alpha_3); };
  answers["alpha_4"] = [s] { return Maybe(s.motion().alpha_4); };
}

template <class T>
void add_angles(Answers<T>& answers, const Scene<T>& s) {
  using Maybe = std::optional<T>;
  const auto add = [&](const std::string& name, const Complex<T>& u) {
    answers[name] = [u] { return Maybe(arc_tangent(u.im, u.re)); };
  };
  const Complex<T> to_frame = conjugate(s.linkage.template B0<T>());
  add("coupler_angle", s.place.coupler);
  add("rocker_angle", s.place.rocker);
  add("theta_2", to_frame * s.place.crank);
  add("theta_3", to_frame * s.place.coupler);
  add("theta_4", -(to_frame * s.place.rocker));
  answers["gamma"] = [s] {
    const auto m = s.motion();
    return Maybe(arc_tangent(m.alpha_3, square(m.omega_3)));
  };
}

// Everything but the angles, which Exact does not have. Throws Impossible when the linkage does not close.
template <class T>
Answers<T> answers_without_angles(const CorpusCase& c, const T& omega_2) {
  Answers<T> answers;
  const Scene<T> s = scene_of<T>(c, omega_2);
  for (const std::string name : {"A", "B", "C", "G2", "G3", "G4"})
    add_point(answers, name, [s, name] { return std::optional(s.point(name)); });
  answers["psi_y_determinant"] = [s] { return std::optional<T>(-s.place.coupler_cross_rocker); };
  add_velocities_and_accelerations(answers, s);
  add_poles_and_circles<T>(answers, [s] { return s.coupler(); },
                           {{"A", s.point("A")}, {"B", s.point("B")}, {"C", s.point("C")}, {"G3", s.point("G3")}},
                           {"C", "G3"});
  return answers;
}

template <class T>
Answers<T> answers_of(const CorpusCase& c) {
  const T omega_2 = speed_of<T>(c);
  Answers<T> answers = answers_without_angles<T>(c, omega_2);
  add_angles(answers, scene_of<T>(c, omega_2));
  const Complex<T> u = crank_of<T>(c);
  const auto turn = c.givens.find("turn");
  answers["crank_angle_phi"] = [u, turn, &c]() -> std::optional<T> {
    if (turn == c.givens.end()) return arc_tangent(u.im, u.re);
    return from_rational<T>(2 * turn->second) * pi<T>();
  };
  return answers;
}

}  // namespace epure::tests::four_bar
