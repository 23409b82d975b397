// What the analytic route answers for a case of the slider-crank corpus, under the corpus' names. Every answer is
// asked for on its own, so that an undecided one does not hide the others.
#pragma once

#include "geometry/analytic/polodes.h"
#include "geometry/analytic/slider_crank.h"
#include "tests/geometry/corpus.h"

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace epure::tests {

using namespace geometry;
using analytic::Complex;

// A value, or empty for one that is infinite. Asking may throw Impossible (the corpus says undefined) or Undecided.
template <class T>
using Answers = std::map<std::string, std::function<std::optional<T>()>>;

template <class T>
struct Scene {
  analytic::SliderCrank linkage;
  analytic::CrankState<T> crank;
  analytic::SliderCrankPosition<T> place;

  analytic::SliderCrankMotion<T> motion() const { return analytic::motion(linkage, crank, place); }
  analytic::PlaneMotion<T> coupler() const { return analytic::coupler(place, motion()); }
};

inline analytic::SliderCrank linkage_of(const CorpusCase& c) {
  return {c.givens.at("r"), c.givens.at("l"), c.givens.at("AC"), c.givens.at("BC")};
}

inline Turn turn_of(const CorpusCase& c) { return {c.givens.at("n") * c.givens.at("t1") / 60}; }

template <class T>
Scene<T> scene_of(const CorpusCase& c, const T& omega_2) {
  const auto crank = analytic::crank_at<T>(turn_of(c), omega_2, from_rational<T>(c.givens.at("alpha_2")));
  return {linkage_of(c), crank, analytic::position(linkage_of(c), crank)};
}

// The crank speed of the case, 2 π n/60.
template <class T>
T speed_of(const CorpusCase& c) {
  return from_rational<T>(c.givens.at("n") / 30) * pi<T>();
}

// `name`_x and `name`_y of a point that may be at infinity.
template <class T, class Ask>
void add_point(Answers<T>& answers, const std::string& name, const Ask& ask) {
  answers[name + "_x"] = [ask]() -> std::optional<T> {
    const std::optional<Complex<T>> z = ask();
    return z ? std::optional<T>(z->re) : std::nullopt;
  };
  answers[name + "_y"] = [ask]() -> std::optional<T> {
    const std::optional<Complex<T>> z = ask();
    return z ? std::optional<T>(z->im) : std::nullopt;
  };
}

// A distance from a point that may be at infinity.
template <class T, class Ask>
void add_distance(Answers<T>& answers, const std::string& name, const Ask& ask, const Complex<T>& to) {
  answers[name] = [ask, to]() -> std::optional<T> {
    const std::optional<Complex<T>> z = ask();
    return z ? std::optional<T>(modulus(*z - to)) : std::nullopt;
  };
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
  answers["v_A"] = [s] { return std::optional<T>(root(square(s.crank.omega)) * from_rational<T>(s.linkage.r)); };
  answers["a_A"] = [s] {
    return std::optional<T>(from_rational<T>(s.linkage.r) *
                            root(square(square(s.crank.omega)) + square(s.crank.alpha)));
  };
  answers["omega_2"] = [s] { return std::optional<T>(s.crank.omega); };
}

// Both coefficients that a line normalised as in the corpus has: a² + b² = 1, the first that is not zero positive.
template <class T>
void add_line(Answers<T>& answers, const std::string& name,
              const std::function<std::optional<analytic::Line<T>>()>& ask) {
  const auto scaled = [ask](auto part) {
    return [ask, part]() -> std::optional<T> {
      const auto line = ask();
      if (!line) throw Impossible("there is no such line");
      const Sign re = sign(line->normal.re);
      if (re == Sign::undecided) throw Undecided("sense of the normal");
      const bool turn = re == Sign::negative || (re == Sign::zero && sign(line->normal.im) == Sign::negative);
      const T value = quotient(part(*line), modulus(line->normal));
      return turn ? -value : value;
    };
  };
  answers[name + "_a"] = scaled([](const analytic::Line<T>& l) { return l.normal.re; });
  answers[name + "_b"] = scaled([](const analytic::Line<T>& l) { return l.normal.im; });
  answers[name + "_c"] = scaled([](const analytic::Line<T>& l) { return l.offset; });
}

template <class T>
void add_circle(Answers<T>& answers, const std::string& name,
                const std::function<std::optional<analytic::Circle<T>>()>& circle,
                const std::function<std::optional<analytic::Line<T>>()>& line) {
  const auto ask = [circle, line] {
    const auto found = circle();
    if (!found && !line()) throw Impossible("neither circle nor line: every point");
    return found;
  };
  add_point(answers, name + "_centre", [ask]() -> std::optional<Complex<T>> {
    const auto found = ask();
    return found ? std::optional(found->centre) : std::nullopt;
  });
  answers[name + "_diameter"] = [ask]() -> std::optional<T> {
    const auto found = ask();
    return found ? std::optional<T>(found->diameter) : std::nullopt;
  };
  add_line<T>(answers, name + "_line", line);
}

template <class T>
void add_poles_and_circles(Answers<T>& answers, const Scene<T>& s) {
  const auto pole = [s] { return s.coupler().pole(); };
  const auto K = [s] { return s.coupler().acceleration_pole(); };
  add_point(answers, "P0", pole);
  add_point(answers, "K", K);
  for (const auto& [name, point] :
       {std::pair<std::string, Complex<T>>{"A", s.place.A}, {"B", s.place.B}, {"C", s.place.C}, {"M", s.place.M}}) {
    add_distance(answers, "P0" + name, pole, point);
    add_distance(answers, "K" + name, K, point);
  }
  add_point(answers, "inflection_pole", [s] { return s.coupler().inflection_pole(); });
  add_circle<T>(
      answers, "inflection", [s] { return s.coupler().inflection_circle(); },
      [s] { return s.coupler().inflection_line(); });
  add_circle<T>(
      answers, "stationarity", [s] { return s.coupler().stationarity_circle(); },
      [s] { return s.coupler().stationarity_line(); });
  for (const auto& [name, point] : {std::pair<std::string, Complex<T>>{"C", s.place.C}, {"M", s.place.M}}) {
    const auto prime = [s, z = point] { return s.coupler().on_inflection_circle(z); };
    add_point(answers, name + "prime", prime);
    add_distance(answers, name + "prime_" + name, prime, point);
    answers["rho_" + name] = [s, z = point] { return s.coupler().radius_of_curvature(z); };
    add_point(answers, "curvature_centre_" + name, [s, z = point] { return s.coupler().centre_of_curvature(z); });
  }
}

template <class T>
void add_angles(Answers<T>& answers, const Scene<T>& s) {
  answers["coupler_angle"] = [s] { return std::optional<T>(arc_tangent(s.place.sin_theta, s.place.cos_theta)); };
  answers["gamma"] = [s] {
    const auto m = s.motion();
    return std::optional<T>(arc_tangent(m.alpha_3, square(m.omega_3)));
  };
}

// Everything but the angles, which Exact does not have. Throws Impossible when the linkage does not close.
template <class T>
Answers<T> answers_without_angles(const CorpusCase& c, const T& omega_2) {
  Answers<T> answers;
  const Scene<T> s = scene_of<T>(c, omega_2);
  add_positions(answers, s);
  add_velocities_and_accelerations(answers, s);
  add_poles_and_circles(answers, s);
  return answers;
}

template <class T>
Answers<T> answers_of(const CorpusCase& c) {
  const T omega_2 = speed_of<T>(c);
  Answers<T> answers = answers_without_angles<T>(c, omega_2);
  const Scene<T> s = scene_of<T>(c, omega_2);
  add_angles(answers, s);
  const Rational turn = turn_of(c).fraction;
  answers["crank_angle_phi"] = [turn] { return std::optional<T>(from_rational<T>(2 * turn) * pi<T>()); };
  answers["crank_angle_phi_deg"] = [turn] { return std::optional<T>(from_rational<T>(360 * turn)); };
  return answers;
}

}  // namespace epure::tests
