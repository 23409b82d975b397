// What the constructions answer for a case of the slider-crank corpus, under the corpus' names, route by route. Every
// answer is asked for on its own, so that an undecided one does not hide the others.
#pragma once

#include "geometry/mechanisms/slider_crank.h"
#include "tests/support/corpus.h"

#include <functional>
#include <map>
#include <string>

namespace epure::tests {

using namespace geometry;

// A number; asking throws Impossible for what is at infinity or does not exist, and Undecided.
template <class T>
using Constructed = std::map<std::string, std::function<T()>>;

inline SliderCrankLengths lengths_of(const CorpusCase& c) {
  return {c.givens.at("r"), c.givens.at("l"), c.givens.at("AC"), c.givens.at("BC"), c.givens.at("e")};
}

template <class T>
SliderCrank<T> constructed_position(const CorpusCase& c) {
  const Turn crank{c.givens.at("n") * c.givens.at("t1") / 60}, guide{c.givens.at("delta") / 360};
  return slider_crank<T>(lengths_of(c), {cosine<T>(crank), sine<T>(crank)}, {cosine<T>(guide), sine<T>(guide)});
}

template <class T>
T crank_speed(const CorpusCase& c) {
  return from_rational<T>(c.givens.at("n") / 30) * pi<T>();
}

// a/b, which does not exist where b is proved zero.
template <class T>
T over(const T& a, const T& b) {
  if (sign(b) == Sign::zero) throw Impossible("at infinity, or undefined");
  return quotient(a, b);
}

template <class T>
void add(Constructed<T>& answers, const std::string& name, const Vector<T>& v) {
  answers[name + "_x"] = [v] { return v.x; };
  answers[name + "_y"] = [v] { return v.y; };
  answers[name] = [v] { return length(v); };
}

template <class T>
void add(Constructed<T>& answers, const std::string& name, const ProjectivePoint<T>& P) {
  answers[name + "_x"] = [P] { return over(P.x, P.w); };
  answers[name + "_y"] = [P] { return over(P.y, P.w); };
}

template <class T>
T distance_to(const ProjectivePoint<T>& P, const Point<T>& X) {
  return over<T>(length(Vector<T>{X.x * P.w - P.x, X.y * P.w - P.y}), absolute(P.w));
}

template <class T>
std::map<std::string, Point<T>> coupler_points(const SliderCrank<T>& at) {
  return {{"A", at.A}, {"B", at.B}, {"C", at.C}, {"M", at.M}};
}

template <class T>
Constructed<T> positions_and_pole(const SliderCrank<T>& at) {
  Constructed<T> answers;
  const ProjectivePoint<T> P0 = at.pole();
  add(answers, "P0", P0);
  for (const auto& [name, X] : coupler_points(at)) {
    add(answers, name, projective(X));
    answers["P0" + name] = [P0, at_X = X] { return distance_to(P0, at_X); };
  }
  answers["coupler_angle"] = [AB = at.B - at.A, s = at.guide.direction()] {
    return arc_tangent(cross(s, AB), dot(s, AB));
  };
  return answers;
}

template <class T>
void add_velocities(Constructed<T>& answers, const SliderCrank<T>& at, const std::function<Vector<T>(Point<T>)>& of) {
  for (const auto& [name, X] : coupler_points(at)) {
    add(answers, "v_" + name, of(X));
    if (name != "A") answers["v_" + name + "A"] = [v = of(X) - of(at.A)] { return length(v); };
  }
}

template <class T>
Constructed<T> velocities_by_polar_diagram(const SliderCrank<T>& at, const SliderCrankMotion<T>& motion) {
  Constructed<T> answers;
  add_velocities<T>(answers, at, [&](const Point<T>& X) { return motion.coupler.velocity(X); });
  add(answers, "v_B", motion.v_B());
  answers["v_BA"] = [v = motion.velocity.first.closing] { return length(v); };
  answers["omega_3"] = [w = motion.velocity.first_rate] { return w; };
  return answers;
}

template <class T>
Constructed<T> velocities_by_poles(const SliderCrank<T>& at, const T& omega_2) {
  Constructed<T> answers;
  const Vector<T> v_A = omega_2 * quarter_turn(at.A - at.A0);
  const RotationAboutPole<T> coupler(at.pole(), at.A, v_A);
  add_velocities<T>(answers, at, [&](const Point<T>& X) { return coupler.velocity(X); });
  answers["omega_3"] = [w = coupler.omega()] { return w; };
  return answers;
}

template <class T>
Constructed<T> accelerations_by_polar_diagram(const SliderCrank<T>& at, const SliderCrankMotion<T>& motion) {
  Constructed<T> answers;
  const AccelerationTerms<T>& terms = motion.acceleration.first;
  for (const auto& [name, X] : coupler_points(at)) {
    const Vector<T> a = motion.coupler.acceleration(X);
    add(answers, "a_" + name, a);
    if (name != "A") answers["a_" + name + "A"] = [v = a - terms.known] { return length(v); };
  }
  add(answers, "a_B", motion.a_B());
  answers["a_BA_n"] = [v = terms.normal] { return length(v); };
  answers["a_BA_t"] = [v = terms.closing] { return length(v); };
  answers["a_A"] = [v = terms.known] { return length(v); };
  const Vector<T> A0A = at.A - at.A0;
  answers["a_A_n"] = [v = terms.known, A0A] { return over<T>(root(square(dot(v, A0A))), length(A0A)); };
  answers["a_A_t"] = [v = terms.known, A0A] { return over<T>(root(square(cross(v, A0A))), length(A0A)); };
  answers["alpha_3"] = [a = motion.acceleration.first_rate] { return a; };
  return answers;
}

template <class T>
void add_circle(Constructed<T>& answers, const std::string& name, const Cycle<T>& cycle) {
  add(answers, name + "_centre", cycle.centre());
  answers[name + "_diameter"] = [cycle] {
    return over<T>(root(square(cycle.l) + square(cycle.m) - T(4) * cycle.k * cycle.n), absolute(cycle.k));
  };
  // The line it has become, normalised as in the corpus: a² + b² = 1, the first of a, b that is not zero positive.
  const auto coefficient = [cycle](T Line<T>::*which) {
    return [cycle, which] {
      if (sign(cycle.k) == Sign::undecided) throw Undecided("whether it is a line");
      if (sign(cycle.k) != Sign::zero) throw Impossible("it is a circle");
      const Line<T> l = cycle.straight();
      const Sign a = sign(l.a);
      if (a == Sign::undecided) throw Undecided("sense of a line");
      const bool turn = a == Sign::negative || (a == Sign::zero && sign(l.b) == Sign::negative);
      const T value = over(l.*which, length(l.direction()));
      return turn ? T(-value) : value;
    };
  };
  answers[name + "_line_a"] = coefficient(&Line<T>::a);
  answers[name + "_line_b"] = coefficient(&Line<T>::b);
  answers[name + "_line_c"] = coefficient(&Line<T>::c);
}

// What follows from the state of the coupler, whoever found it.
template <class T>
Constructed<T> second_order(const SliderCrank<T>& at, const PlaneMotion<T>& coupler) {
  Constructed<T> answers;
  const ProjectivePoint<T> K = coupler.acceleration_pole();
  add(answers, "P0", coupler.pole());
  add(answers, "K", K);
  for (const auto& [name, X] : coupler_points(at)) {
    add(answers, "v_" + name, coupler.velocity(X));
    add(answers, "a_" + name, coupler.acceleration(X));
    answers["K" + name] = [K, at_X = X] { return distance_to(K, at_X); };
  }
  answers["omega_3"] = [coupler] { return coupler.omega; };
  answers["alpha_3"] = [coupler] { return coupler.alpha; };
  const auto gamma = [coupler] { return arc_tangent(coupler.alpha, square(coupler.omega)); };
  answers["gamma"] = gamma;
  answers["gamma_deg"] = [gamma] { return over<T>(from_rational<T>(180) * gamma(), pi<T>()); };
  add_circle(answers, "inflection", coupler.inflection_circle());
  add_circle(answers, "stationarity", coupler.stationarity_circle());
  add(answers, "inflection_pole", coupler.inflection_pole());
  for (const auto& [name, X] : {std::pair<std::string, Point<T>>{"C", at.C}, {"M", at.M}}) {
    const ProjectivePoint<T> prime = coupler.on_inflection_circle(X), centre = coupler.centre_of_curvature(X);
    add(answers, name + "prime", prime);
    add(answers, "curvature_centre_" + name, centre);
    answers[name + "prime_" + name] = [prime, at_X = X] { return distance_to(prime, at_X); };
    answers["rho_" + name] = [centre, at_X = X] { return distance_to(centre, at_X); };
  }
  return answers;
}

}  // namespace epure::tests
