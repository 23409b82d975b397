// What the analytic route answers for a case of a corpus, under the corpus' names. Every answer is asked for on its
// own, so that an undecided one does not hide the others.
#pragma once

#include "geometry/analytic/plane_motion_formulas.h"
#include "tests/support/catch.h"
#include "tests/support/corpus.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace epure::tests {

using namespace geometry;
using analytic::Complex;

// A value, or empty for one that is infinite. Asking may throw Impossible (the corpus says undefined) or Undecided.
template <class T>
using Answers = std::map<std::string, std::function<std::optional<T>()>>;

enum class Kind { value, infinite, undefined, undecided };

template <class T>
struct Outcome {
  Kind kind;
  std::optional<T> value;
};

template <class T>
Outcome<T> ask(const Answers<T>& answers, const std::string& name) {
  INFO(name);
  REQUIRE(answers.count(name) == 1);
  try {
    const std::optional<T> value = answers.at(name)();
    return {value ? Kind::value : Kind::infinite, value};
  } catch (const Impossible&) {
    return {Kind::undefined, {}};
  } catch (const Undecided&) {
    return {Kind::undecided, {}};
  }
}

inline Kind expected_kind(const std::string& reference) {
  if (reference == "infinite") return Kind::infinite;
  return reference == "undefined" ? Kind::undefined : Kind::value;
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

// Poles, circles, and the curvature of the paths of some points, for a plane that may not move (then asking throws).
// Distances P0X and KX for all points by name, curvature for the named ones.
template <class T>
void add_poles_and_circles(Answers<T>& answers, const std::function<analytic::PlaneMotion<T>()>& plane,
                           const std::map<std::string, Complex<T>>& points,
                           const std::vector<std::string>& with_curvature) {
  const auto pole = [plane] { return plane().pole(); };
  const auto K = [plane] { return plane().acceleration_pole(); };
  add_point(answers, "P0", pole);
  add_point(answers, "K", K);
  for (const auto& [name, point] : points) {
    add_distance(answers, "P0" + name, pole, point);
    add_distance(answers, "K" + name, K, point);
  }
  add_point(answers, "inflection_pole", [plane] { return plane().inflection_pole(); });
  add_circle<T>(
      answers, "inflection", [plane] { return plane().inflection_circle(); },
      [plane] { return plane().inflection_line(); });
  add_circle<T>(
      answers, "stationarity", [plane] { return plane().stationarity_circle(); },
      [plane] { return plane().stationarity_line(); });
  for (const std::string& name : with_curvature) {
    const Complex<T> z = points.at(name);
    const auto prime = [plane, z] { return plane().on_inflection_circle(z); };
    add_point(answers, name + "prime", prime);
    add_distance(answers, name + "prime_" + name, prime, z);
    answers["rho_" + name] = [plane, z] { return plane().radius_of_curvature(z); };
    add_point(answers, "curvature_centre_" + name, [plane, z] { return plane().centre_of_curvature(z); });
  }
}

}  // namespace epure::tests
