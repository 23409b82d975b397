#include "exercises/kit/rolling/rolled.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace epure {
namespace {

using geometry::Rolls;

constexpr double turn = 2 * std::numbers::pi;

double number(const Rational& q) { return geometry::from_rational<double>(q); }

constexpr double most_arches = 40, most_turns = 24;  // what a drawing can show of a path

// From the first arch to that of φ; when this is not one of the first few, it and its neighbours.
Way arches_around(double arch, double per_arch, double overhang) {
  constexpr double first_few = 3;
  const bool near_start = std::abs(arch) < first_few;
  const double from = near_start ? std::min(arch, 0.0) : arch - 1,
               to = near_start ? std::max(arch + 1, 1.0) : arch + 2;
  return {(from - arch - overhang) * per_arch, (to - arch + overhang) * per_arch, static_cast<int>(to - from) + 1};
}

Way unwound(double phi) {
  constexpr double far = 2 * turn, beyond = turn / 12;
  if (std::abs(phi) > far) return {-turn / 2, beyond};
  return {std::min(0.0, phi) - beyond - phi, std::max(turn / 4, phi) + beyond - phi};
}

}  // namespace

std::optional<Place> Rolled::O() const {
  if (given.rolls_on_line()) return {};
  return P0 + (given.rolling.how == Rolls::circle_inside_circle ? R : -R) * n;
}

Rolled rolled(const Solution& s, const RollingGivens& given, const InstantNames& names) {
  const auto place = [&](const std::string& letter) { return s.place(names("drawn_" + letter)); };
  const auto vector = [&](const std::string& letter) { return s.vector(names("drawn_" + letter)); };
  Rolled f{.given = given,
           .names = names,
           .r = number(given.rolling.r),
           .R = number(given.rolling.R),
           .d = number(given.rolling.d),
           .M = place("M"),
           .J = place("J"),
           .M_prime = place("M_prime"),
           .n = vector("n"),
           .v = vector("v"),
           .a = vector("a"),
           .a_n = vector("a_n"),
           .a_t = vector("a_t"),
           .is_at_cusp = s[names("P0M")] == 0};
  const std::string centre = names("drawn_centre");
  if (s.has(centre + "_x")) f.centre = s.point(centre);
  return f;
}

Way way_of(const RollingGivens& given, double overhang) {
  if (given.is_line()) return unwound(to_double(given.phi));
  const double per_arch = turn / number(geometry::rolled_per_turned(given.rolling));
  const Angle psi = geometry::rolled_angle(given.rolling, given.phi);
  Way way = [&]() -> Way {
    if (!given.rolls_on_line()) {
      // R/r = p/q: the path closes after p arches, in q turns of the contact.
      const Rational ratio = given.rolling.R / given.rolling.r;
      const double arches = number(Rational(ratio.numerator())), around = number(Rational(ratio.denominator()));
      if (arches <= most_arches && around <= most_turns)
        return {0, arches * per_arch, static_cast<int>(arches), true};
    }
    return arches_around(number(geometry::whole_turns(psi)), per_arch, overhang);
  }();
  const double since_arch = to_double(geometry::within_one_turn(psi)) / turn * per_arch;
  way.from -= since_arch;
  way.to -= since_arch;
  if (way.closed) return way;
  way.from = std::max(way.from, -most_turns / 2 * turn);
  way.to = std::min(way.to, most_turns / 2 * turn);
  return way;
}

Way way_around(const RollingGivens& given, double overhang) {
  constexpr double most_rounds = 6;
  Way way = way_of(given, overhang);
  if (given.is_line() || given.rolls_on_line()) return way;
  const double per_round =
      turn / number(geometry::rolled_per_turned(given.rolling)) * number(Rational(given.rolling.R / given.rolling.r));
  if (way.to - way.from <= most_rounds * per_round) return way;
  way.from = std::max(way.from, -per_round);
  way.to = std::min(way.to, per_round);
  way.closed = false;
  return way;
}

}  // namespace epure
