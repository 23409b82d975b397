#include "tests/exercises/special-linkages/families.h"

#include "geometry/numbers/given.h"
#include "geometry/numbers/numbers.h"

#include <array>
#include <cmath>
#include <set>

namespace epure::tests {

namespace {

int from_to(Random& random, int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); }
bool toss(Random& random) { return from_to(random, 0, 1) == 1; }

Rational power_of_ten(int n) {
  Rational power = 1;
  for (int i = 0; i < n; ++i) power *= 10;
  return power;
}

Rational length(Random& random) { return Rational(from_to(random, 100, 999), 1000); }

// In degrees.
Rational angle(Random& random) {
  if (from_to(random, 0, 3) == 0) {
    const int parts = from_to(random, 5, 40);
    return Rational(360 * from_to(random, 1, parts - 1), parts);
  }
  const int decimals = from_to(random, 0, 5);
  const Rational steps = power_of_ten(decimals);
  return Rational(from_to(random, 1, 359)) + Rational(from_to(random, 0, 99999)) / 100000 * (decimals > 0 ? 1 : 0) -
         (decimals > 0 && decimals < 5 ? Rational(from_to(random, 0, 9)) / steps / 10 : Rational(0));
}

// By how much a length misses: half of the time not at all.
Rational miss(Random& random) {
  if (toss(random)) return 0;
  const Rational size = Rational(1) / power_of_ten(from_to(random, 3, 40));
  return toss(random) ? size : -size;
}

struct Bars {
  std::string family;
  Rational frame, crank, coupler, rocker;
};

// One bar down to 1e-10 of the others, of which two or all are equal.
Bars with_one_tiny(Random& random) {
  const Rational tiny = Rational(1) / power_of_ten(from_to(random, 2, 10)), a = length(random);
  Bars of{"one bar tiny", a, a, a, a};
  std::array<Rational*, 4> bars{&of.frame, &of.crank, &of.coupler, &of.rocker};
  const std::size_t which = static_cast<std::size_t>(from_to(random, 0, 3));
  *bars.at(which) = a * tiny;
  if (toss(random)) *bars.at((which + 1) % 4) = a * Rational(3, 2);
  return of;
}

Bars special_bars(Random& random) {
  const Rational a = length(random), b = length(random), c = length(random);
  switch (from_to(random, 0, 10)) {
    case 0:
      return {"parallelogram", a, b, a, b};
    case 1:
      return {"kite on A0", a, b, b, a};
    case 2:
      return {"kite on B0", a, a, b, b};
    case 3:
      return {"rhombus", a, a, a, a};
    case 4:
      return {"change point: frame and crank", b + c - a > 0 ? b + c - a : a + b + c, a, b, c};
    case 5:
      return {"change point: frame and coupler", a + c - b > 0 ? a + c - b : a + b + c, a, b, c};
    case 6:
      return {"change point: frame and rocker", a + b - c > 0 ? a + b - c : a + b + c, a, b, c};
    case 7:
      return {"crank as long as rocker", a, b, c, b};
    case 8:
      return with_one_tiny(random);
    default:
      return {"any", Rational(8, 10) + a / 10, Rational(2, 10) + b / 20, Rational(5, 10) + c / 10, Rational(7, 10)};
  }
}

// What turns by `of_a_turn` a turn is asked in radians, at about the same place.
void in_radians(SpecialCase& of, const std::string& symbol, int of_a_turn) {
  for (auto& [name, value] : of.numbers)
    if (name == symbol) value *= Rational(44, 7) / of_a_turn;
  of.units[symbol] = "rad";
}

SpecialCase four_bar_analytic(Random& random) {
  Bars of = special_bars(random);
  SpecialCase found{of.family, "four-bar-analytic", {}, {toss(random) ? "branch=left" : "branch=right"}};
  const std::array<Rational*, 4> bars{&of.frame, &of.crank, &of.coupler, &of.rocker};
  *bars.at(static_cast<std::size_t>(from_to(random, 0, 3))) += miss(random);
  const Rational coupler = of.coupler;
  Rational along = Rational(25, 100), across = Rational(1, 10);
  switch (from_to(random, 0, 3)) {
    case 0:
      along = across = 0;
      found.family += ", P on A";
      break;
    case 1:
      along = coupler;
      across = 0;
      found.family += ", P on B";
      break;
    default:
      break;
  }
  found.numbers = {{"A0B0", of.frame},         {"A0A", of.crank},   {"AB", coupler},      {"B0B", of.rocker},
                   {"theta_2", angle(random)}, {"AP_along", along}, {"AP_across", across}};
  if (from_to(random, 0, 3) == 0) in_radians(found, "theta_2", 360);
  return found;
}

// The instant of a crank that turns a turn a second becomes one of a crank that turns a radian a second.
void at_a_radian_a_second(SpecialCase& of, const std::string& instant) {
  in_radians(of, instant, 1);
  of.units[instant] = "s";
  for (auto& [name, value] : of.numbers)
    if (name == "n") value = 1;
  of.units["n"] = "rad/s";
}

// A unit vector of the 3-4-5 kind, or one at a whole number of degrees to 15 decimals.
std::array<Rational, 2> direction_of_frame(Random& random, std::string& family) {
  if (from_to(random, 0, 4) == 0) {
    const auto decimals = [](double x) { return Rational(std::round(x * 1e15)) / power_of_ten(15); };
    const double angle = from_to(random, 0, 359) * geometry::pi<geometry::Fast>() / 180;
    family += ", frame at whole degrees to 15 decimals";
    return {decimals(std::cos(angle)), decimals(std::sin(angle))};
  }
  const int p = from_to(random, 1, 9), q = from_to(random, 0, 9), sum = p * p + q * q;
  const Rational x(p * p - q * q, sum), y(2 * p * q, sum);
  return {toss(random) ? x : -x, toss(random) ? y : -y};
}

// n = 60 rpm: a turn a second.
SpecialCase four_bar(Random& random) {
  Bars of = special_bars(random);
  const auto [x, y] = direction_of_frame(random, of.family);
  Rational x_B0 = of.frame * x, y_B0 = of.frame * y;
  SpecialCase found{of.family, "four-bar", {}, {toss(random) ? "branch=left" : "branch=right"}};
  if (from_to(random, 0, 4) == 0) {  // a frame of irrational length
    y_B0 += Rational(1, 100);
    found.family += ", frame of no rational length";
  }
  const Rational AC = from_to(random, 0, 3) == 0 ? of.coupler : of.coupler * Rational(from_to(random, 3, 9), 10);
  found.numbers = {
      {"A0A", of.crank}, {"AB", of.coupler}, {"B0B", of.rocker + miss(random)}, {"x_B0", x_B0}, {"y_B0", y_B0},
      {"AC", AC},        {"n", 60},          {"t", angle(random) / 360}};
  if (from_to(random, 0, 3) == 0) at_a_radian_a_second(found, "t");
  return found;
}

SpecialCase slider_crank(Random& random) {
  const Rational r = length(random), longer = r + length(random);
  const int shape = from_to(random, 0, 3);
  const Rational l = (shape < 2 ? r : longer) + miss(random), AC = l * Rational(from_to(random, 3, 6), 10);
  const Rational e = shape == 3 ? (longer - r) * Rational(from_to(random, 1, 9), 10) : Rational(0);
  const bool on_AB = toss(random);
  SpecialCase found{shape < 2    ? "crank as long as coupler"
                    : shape == 2 ? "centred"
                                 : "offset",
                    toss(random) ? "slider-crank-acceleration" : "slider-crank-velocity",
                    {{"r", r},
                     {"l", l},
                     {"AC", AC},
                     {"BC", on_AB ? Rational(l - AC) : Rational(l * Rational(9, 10))},
                     {"n", 60},
                     {"t1", angle(random) / 360},
                     {"e", e},
                     {"delta", toss(random) ? Rational(0) : angle(random)}},
                    {}};
  if (from_to(random, 0, 3) == 0) at_a_radian_a_second(found, "t1");
  if (from_to(random, 0, 3) == 0) in_radians(found, "delta", 360);
  return found;
}

SpecialCase roulette(Random& random) {
  const Rational r = length(random);
  const int kind = from_to(random, 0, 3);
  SpecialCase found{"", "roulette", {}, {}};
  constexpr std::array hows{"circle_on_line", "circle_outside_circle", "circle_inside_circle", "line_on_circle"};
  found.words = {std::string("how=") + hows[static_cast<std::size_t>(kind)]};
  const bool is_cardan = kind == 2 && toss(random), is_centre = !is_cardan && toss(random);
  found.family = is_cardan ? "Cardan's circles" : is_centre ? "centre of the wheel" : "point of the rim";
  found.numbers = {{"r", r},
                   {"R", is_cardan ? Rational(2 * r) : Rational(r + length(random))},
                   {"d", is_centre ? Rational(0) : r},
                   {"phi", toss(random) ? Rational(0) : angle(random)},
                   {"phi_rad", toss(random) ? Rational(0) : angle(random) / 100}};
  return found;
}

bool is_length(const std::string& symbol) {
  static const std::set<std::string> lengths{"A0B0", "A0A", "AB", "B0B", "AP_along", "AP_across", "x_B0", "y_B0",
                                             "AC",   "BC",  "r",  "l",   "e",        "R",         "d"};
  return lengths.contains(symbol);
}

}  // namespace

std::vector<std::string> SpecialCase::assignments() const {
  std::vector<std::string> all = words;
  for (const auto& [symbol, value] : numbers) {
    const auto unit = units.find(symbol);
    all.push_back(symbol + "=" + geometry::to_text(value) + (unit == units.end() ? "" : unit->second));
  }
  return all;
}

std::string SpecialCase::text() const {
  std::string text = family + ": check " + exercise;
  for (const std::string& assignment : assignments()) text += " --set " + assignment;
  return text;
}

SpecialCase special_case(Random& random) {
  switch (from_to(random, 0, 3)) {
    case 0:
      return four_bar(random);
    case 1:
      return slider_crank(random);
    case 2:
      return roulette(random);
    default:
      return four_bar_analytic(random);
  }
}

SpecialCase scaled(const SpecialCase& one, const Rational& times) {
  SpecialCase larger = one;
  for (auto& [symbol, value] : larger.numbers)
    if (is_length(symbol)) value *= times;
  return larger;
}

bool can_be_turned(const SpecialCase& one) {
  const bool has_frame = one.exercise == "four-bar" || one.exercise.starts_with("slider-crank");
  return has_frame && one.units.empty();
}

SpecialCase turned(const SpecialCase& one, Random& random) {
  SpecialCase other = one;
  const auto at = [&](const std::string& symbol) -> Rational& {
    for (auto& [name, value] : other.numbers)
      if (name == symbol) return value;
    throw std::logic_error(symbol);
  };
  if (one.exercise == "four-bar") {
    const Rational x = at("x_B0");
    at("x_B0") = -at("y_B0");
    at("y_B0") = x;
    at("t") += Rational(1, 4);
  } else {
    const Rational degrees = from_to(random, 1, 359);
    at("delta") += degrees;
    at("t1") += degrees / 360;
  }
  return other;
}

}  // namespace epure::tests
