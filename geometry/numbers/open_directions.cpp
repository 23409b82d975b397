#include "geometry/numbers/open_directions.h"

#include "geometry/numbers/turn.h"

#include <algorithm>
#include <cstdlib>

namespace epure::geometry {

namespace {

using Element = OpenDirections::Element;

Element constant(const Rational& value) { return Element(RationalFunction(value)); }

// How many times 15° the angle is, from 0 to 23, if it is.
std::optional<int> fifteens_of(const Angle& angle) {
  if (angle.radians != 0) return std::nullopt;
  const Rational fifteens = Rational(24) * within_one_turn(Turn{angle.turns}).fraction;
  if (fifteens.denominator() != 1) return std::nullopt;
  return static_cast<int>(fifteens.to_double());
}

Rational fineness(const Angle& angle) {
  return std::max(Rational(angle.turns.denominator()), Rational(angle.radians.denominator()));
}

}  // namespace

OpenDirections::OpenDirections() : tower_([](const Element&) { return false; }) {}

OpenDirections::Unit OpenDirections::turned(const Unit& a, const Unit& b) const {
  return {tower_.add(tower_.multiply(a.x, b.x), -tower_.multiply(a.y, b.y)),
          tower_.add(tower_.multiply(a.x, b.y), tower_.multiply(a.y, b.x))};
}

OpenDirections::Unit OpenDirections::power(const Unit& a, int n) const {
  Unit result{constant(1), constant(0)};
  const Unit factor = n < 0 ? Unit{a.x, -a.y} : a;
  for (int i = 0; i < std::abs(n); ++i) result = turned(result, factor);
  return result;
}

OpenDirections::Unit OpenDirections::of_fifteens(int fifteens) {
  if (fifteens % 6 == 0) return power({constant(0), constant(1)}, fifteens / 6);
  const auto times = [&](const Element& x, const Rational& factor) { return tower_.multiply(x, constant(factor)); };
  if (fifteens % 2 == 0)
    return power({times(root(constant(3)), Rational(1, 2)), constant(Rational(1, 2))}, fifteens / 2);
  const Element half_root_2 = times(root(constant(2)), Rational(1, 2));
  if (fifteens % 3 == 0) return power({half_root_2, half_root_2}, fifteens / 3);
  return turned(of_fifteens((fifteens + 21) % 24), of_fifteens(3));
}

void OpenDirections::lay_out_expected() {
  std::vector<Angle> angles;
  angles.swap(expected_);
  const auto is_finer = [](const Angle& a, const Angle& b) { return fineness(a) > fineness(b); };
  std::stable_sort(angles.begin(), angles.end(), is_finer);
  try {
    for (const Angle& angle : angles) direction(angle);
  } catch (const Undecided&) {
    // More than there are indeterminates: whether one too many is needed, the question will tell.
  }
}

OpenDirections::Unit OpenDirections::direction(const Angle& angle) {
  if (!expected_.empty()) lay_out_expected();
  for (const Known& known : seen_)
    if (known.angle.turns == angle.turns && known.angle.radians == angle.radians) return known.unit;
  const Unit unit = found(angle);
  seen_.push_back({angle, unit});
  return unit;
}

// The angle as a sum of small multiples of those that are independent and of 15°: the shortest sum there is.
OpenDirections::Unit OpenDirections::found(const Angle& angle) {
  struct Sum {
    std::vector<int> multiples;
    Angle rest;
    int length = 0;
  };
  constexpr int most = 4;
  std::vector<Sum> sums{{{}, angle}};
  for (const Known& known : independent_) {
    std::vector<Sum> longer;
    for (const Sum& sum : sums)
      for (int n = -most; n <= most; ++n) {
        Sum next = sum;
        next.multiples.push_back(n);
        next.rest = sum.rest - Rational(n) * known.angle;
        next.length += std::abs(n);
        longer.push_back(next);
      }
    sums = longer;
  }
  const Sum* shortest = nullptr;
  for (const Sum& sum : sums)
    if (fifteens_of(sum.rest) && (!shortest || sum.length < shortest->length)) shortest = &sum;
  if (!shortest) return adjoin(angle);
  Unit unit = of_fifteens(*fifteens_of(shortest->rest));
  for (std::size_t i = 0; i < independent_.size(); ++i)
    unit = turned(unit, power(independent_[i].unit, shortest->multiples[i]));
  return unit;
}

RationalFunction OpenDirections::next_indeterminate(std::optional<Angle> of) {
  const std::size_t number = indeterminates_.size();
  if (number == RationalFunction::variables)
    throw Undecided("more independent directions than a proof leaves open",
                    "più direzioni indipendenti di quante una dimostrazione ne lasci aperte");
  indeterminates_.push_back(std::move(of));
  return RationalFunction::variable(static_cast<int>(number));
}

// With t = tan θ/2: cos θ = (1 - t²)/(1 + t²), sin θ = 2t/(1 + t²). θ is no half turn, which is a multiple of 15°.
OpenDirections::Unit OpenDirections::adjoin(const Angle& angle) {
  const RationalFunction t = next_indeterminate(angle), t2 = t * t,
                         share = RationalFunction(1) / (RationalFunction(1) + t2);
  const Unit unit{Element((RationalFunction(1) + -t2) * share), Element(RationalFunction(2) * t * share)};
  independent_.push_back({angle, unit});
  return unit;
}

Element OpenDirections::pi() {
  if (!pi_) pi_ = Element(next_indeterminate(std::nullopt));
  return *pi_;
}

Deep OpenDirections::ball_around(const Element& x) const {
  std::array<Deep, RationalFunction::variables> values;
  for (std::size_t i = 0; i < indeterminates_.size(); ++i) {
    const auto& angle = indeterminates_[i];
    values[i] =
        angle ? quotient(geometry::sine<Deep>(*angle), 1 + geometry::cosine<Deep>(*angle)) : geometry::pi<Deep>();
  }
  return tower_.to_deep(x, [&](const RationalFunction& f) { return f.at(values); });
}

Element OpenDirections::root(const Element& x) {
  if (x.is_zero()) return x;
  if (const auto within = tower_.root_within(x)) {
    for (const long bits : {128L, 512L, 2048L}) {
      const Arithmetic<Deep> scope(bits);
      try {
        if (const Sign found = sign(ball_around(*within)); found != Sign::undecided)
          return found == Sign::negative ? -*within : *within;
      } catch (const Undecided&) {
        // a denominator that may vanish: more bits may part it from zero
      }
    }
    throw Undecided("the sign of a root that was found for every direction",
                    "il segno di una radice trovata per ogni direzione");
  }
  constexpr int highest_storey = 5;
  if (tower_.storeys() == highest_storey)
    throw Undecided("more than five independent roots", "più di cinque radici indipendenti");
  return tower_.adjoin(x);
}

}  // namespace epure::geometry
