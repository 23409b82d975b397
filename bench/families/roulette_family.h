// Points of roulettes at and beside their cusps, near the start and after ten million turns.
#pragma once

#include "bench/family.h"
#include "geometry/motion/rolling.h"

namespace epure::bench {

struct RouletteGivens {
  Rolling rolling;
  Angle phi;
  Rational omega, alpha;
};

struct RoulettePoint {
  static constexpr const char* name = "roulette-point";
  static constexpr const char* corpus = "roulettes.txt";
  using Givens = RouletteGivens;
  static Givens givens(const CorpusCase& c) {
    const auto given = [&](const char* name) { return c.givens.at(name); };
    return {.rolling = {how(c.choices.at("rolls")), given("r"), given("R"), given("d")},
            .phi = {given("turns"), given("radians")},
            .omega = given("omega"),
            .alpha = given("alpha")};
  }

  // Rolling is computed from its exact data: that is part of every result.
  template <class T>
  using On = Unread<Givens, T>;

  template <class T, class Report>
  static void results(const On<T>& unread, Report& report) {
    const Givens& of = unread.givens;
    const Point<T> M = tracing_point<T>(of.rolling, of.phi);
    report("x_M", [&] { return M.x; });
    report("y_M", [&] { return M.y; });
    const auto instant =
        rolling_instant<T>(of.rolling, of.phi, from_rational<T>(of.omega), from_rational<T>(of.alpha));
    const Vector<T> v = instant.velocity(), a = instant.acceleration();
    report("v_x", [&] { return v.x; });
    report("v_y", [&] { return v.y; });
    report("a_x", [&] { return a.x; });
    report("a_y", [&] { return a.y; });
    report("radius", [&] { return instant.radius_of_curvature(); });
  }

  static std::vector<Question> questions(const Givens& of) {
    return {{"is_at_cusp", [of] { return Decided{is_at_cusp(of.rolling, of.phi) ? "yes" : "no", "rational", {}}; }}};
  }

 private:
  static Rolls how(const std::string& word) {
    if (word == "circle_on_line") return Rolls::circle_on_line;
    if (word == "circle_outside_circle") return Rolls::circle_outside_circle;
    if (word == "circle_inside_circle") return Rolls::circle_inside_circle;
    if (word == "line_on_circle") return Rolls::line_on_circle;
    throw std::runtime_error("no way to roll: " + word);
  }
};

}  // namespace epure::bench
