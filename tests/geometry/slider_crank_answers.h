// What the analytic route answers for a case of the slider-crank corpus, under the corpus' names. Every answer is
// asked for on its own, so that an undecided one does not hide the others.
#pragma once

#include "geometry/analytic/polode_formulas.h"
#include "geometry/analytic/slider_crank_formulas.h"
#include "tests/geometry/answers.h"
#include "tests/support/corpus.h"

#include <string>

namespace epure::tests {

template <class T>
struct Scene {
  analytic::SliderCrank linkage;
  analytic::GuidedCrank<T> crank;
  analytic::SliderCrankPosition<T> place;

  analytic::SliderCrankMotion<T> motion() const { return analytic::motion(linkage, crank, place); }
  analytic::PlaneMotion<T> coupler() const { return analytic::coupler(place, motion()); }
};

inline analytic::SliderCrank linkage_of(const CorpusCase& c) {
  return {c.givens.at("r"),  c.givens.at("l"), c.givens.at("AC"),
          c.givens.at("BC"), c.givens.at("e"), {c.givens.at("delta") / 360}};
}

inline Angle turn_of(const CorpusCase& c) { return {c.givens.at("n") * c.givens.at("t1") / 60}; }

template <class T>
Scene<T> scene_of(const CorpusCase& c, const T& omega_2) {
  const analytic::SliderCrank g = linkage_of(c);
  const auto crank = analytic::guided_crank<T>(g, turn_of(c), omega_2, from_rational<T>(c.givens.at("alpha_2")));
  return {g, crank, analytic::position(g, crank)};
}

// The crank speed of the case, 2 π n/60.
template <class T>
T speed_of(const CorpusCase& c) {
  return from_rational<T>(c.givens.at("n") / 30) * pi<T>();
}

template <class T>
void add_positions(Answers<T>& answers, const Scene<T>& s) {
  for (const auto& [name, point] :
       {std::pair<std::string, Complex<T>>{"A", s.place.A}, {"B", s.place.B}, {"C", s.place.C}, {"M", s.place.M}})
    add_point(answers, name, [z = point] { return std::optional(z); });
}

template <class T>
void add_velocities_and_accelerations(Answers<T>& answers, const Scene<T>& s) {
  using Motion = analytic::SliderCrankMotion<T>;
  using Field = Complex<T> Motion::*;
  const auto add = [&](const std::string& name, Field field) {
    add_point(answers, name, [s, field] { return std::optional(s.motion().*field); });
    answers[name] = [s, field] { return std::optional<T>(modulus(s.motion().*field)); };
  };
  const auto add_relative = [&](const std::string& name, Field field, Field to) {
    answers[name] = [s, field, to] { return std::optional<T>(modulus(s.motion().*field - s.motion().*to)); };
  };
  add("v_B", &Motion::v_B);
  add("v_C", &Motion::v_C);
  add("v_M", &Motion::v_M);
  add("a_B", &Motion::a_B);
  add("a_C", &Motion::a_C);
  add("a_M", &Motion::a_M);
  add_relative("v_BA", &Motion::v_B, &Motion::v_A);
  add_relative("v_CA", &Motion::v_C, &Motion::v_A);
  add_relative("v_MA", &Motion::v_M, &Motion::v_A);
  add_relative("a_BA", &Motion::a_B, &Motion::a_A);
  add_relative("a_CA", &Motion::a_C, &Motion::a_A);
  add_relative("a_MA", &Motion::a_M, &Motion::a_A);
  answers["omega_3"] = [s] { return std::optional<T>(s.motion().omega_3); };
  answers["alpha_3"] = [s] { return std::optional<T>(s.motion().alpha_3); };
  answers["a_BA_n"] = [s] { return std::optional<T>(square(s.motion().omega_3) * from_rational<T>(s.linkage.l)); };
  answers["a_BA_t"] = [s] {
    return std::optional<T>(root(square(s.motion().alpha_3)) * from_rational<T>(s.linkage.l));
  };
  // v_A and a_A belong to the crank: they exist where the coupler's motion does not.
  answers["v_A"] = [s] {
    return std::optional<T>(root(square(s.crank.from_x.omega)) * from_rational<T>(s.linkage.r));
  };
  answers["a_A"] = [s] {
    return std::optional<T>(from_rational<T>(s.linkage.r) *
                            root(square(square(s.crank.from_x.omega)) + square(s.crank.from_x.alpha)));
  };
  answers["a_A_n"] = [s] { return std::optional<T>(from_rational<T>(s.linkage.r) * square(s.crank.from_x.omega)); };
  answers["a_A_t"] = [s] {
    return std::optional<T>(from_rational<T>(s.linkage.r) * root(square(s.crank.from_x.alpha)));
  };
  answers["omega_2"] = [s] { return std::optional<T>(s.crank.from_x.omega); };
}

template <class T>
void add_angles(Answers<T>& answers, const Scene<T>& s) {
  answers["coupler_angle"] = [s] { return std::optional<T>(arc_tangent(s.place.eta.im, s.place.eta.re)); };
  const auto gamma = [s] {
    const auto m = s.motion();
    return arc_tangent(m.alpha_3, square(m.omega_3));
  };
  answers["gamma"] = [gamma] { return std::optional<T>(gamma()); };
  answers["gamma_deg"] = [gamma] { return std::optional<T>(quotient(from_rational<T>(180) * gamma(), pi<T>())); };
}

// Everything but the angles, which Exact does not have. Throws Impossible when the linkage does not close.
template <class T>
Answers<T> answers_without_angles(const CorpusCase& c, const T& omega_2) {
  Answers<T> answers;
  const Scene<T> s = scene_of<T>(c, omega_2);
  add_positions(answers, s);
  add_velocities_and_accelerations(answers, s);
  add_poles_and_circles<T>(answers, [s] { return s.coupler(); },
                           {{"A", s.place.A}, {"B", s.place.B}, {"C", s.place.C}, {"M", s.place.M}}, {"C", "M"});
  return answers;
}

template <class T>
Answers<T> answers_of(const CorpusCase& c) {
  const T omega_2 = speed_of<T>(c);
  Answers<T> answers = answers_without_angles<T>(c, omega_2);
  const Scene<T> s = scene_of<T>(c, omega_2);
  add_angles(answers, s);
  const Rational turn = turn_of(c).turns;
  answers["crank_angle_phi"] = [turn] { return std::optional<T>(from_rational<T>(2 * turn) * pi<T>()); };
  answers["crank_angle_phi_deg"] = [turn] { return std::optional<T>(from_rational<T>(360 * turn)); };
  return answers;
}

}  // namespace epure::tests
