#include "geometry/linkages/stationary.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace epure::geometry {
namespace {

constexpr double turn_in_doubles = 2 * std::numbers::pi;
double middle_of(const Bounded& x) { return midpoint(x).inf(); }

bool is_proved(Sign sign) { return sign == Sign::positive || sign == Sign::negative; }

// A zero of the derivative is at `middle` less this, for one of the second derivatives over where it lies.
template <class T>
T newton_step(const OverAngle<T>& middle, const OverAngle<T>& within) {
  return quotient(middle.first, within.second);
}

// By the middle of where the zero of the derivative lies, and the second derivative over all of it.
template <class T>
T value_there(const OverAngle<T>& middle, const OverAngle<T>& within, const T& away) {
  return middle.value + middle.first * away + quotient(within.second * square(away), T(2));
}

// A whole turn, as well as it is known, is none.
template <class T>
Stationary<T> within_a_turn(const T& angle, const T& value) {
  const T turn = T(2) * pi<T>();
  return {sign(angle - turn) == Sign::negative ? angle : angle - turn, value};
}

class SearchOverTurn {
 public:
  explicit SearchOverTurn(const NumberOverAngle& number) : number_(number) {}

  std::vector<StationaryPlace> operator()() {
    look(beginning, beginning + a_turn_and_a_little);
    if (is_open_)
      throw Undecided("where it is greatest and least: it hardly changes, or the motion is not determined somewhere",
                      "dove sia massima e minima: varia appena, o da qualche parte il moto non è determinato");
    return std::move(found_);
  }

 private:
  // At an angle where mechanisms have a limit position (0, a part of a turn) the derivative's sign at the end of an
  // interval cannot be told: intervals begin and are parted elsewhere.
  static constexpr double beginning = 0.3711, part = 0.47;
  static constexpr double a_turn_and_a_little = 2 * std::numbers::pi * (1 + 0x1p-50);
  // Beyond such a crumb the mechanism may be proved not to close.
  static constexpr double crumb = 0x1p-36;
  static constexpr int most_looks = 20000;

  void look(double low, double high) {
    if (++looks_ > most_looks || high - low < crumb) {
      is_open_ = true;
      return;
    }
    const double between = low + part * (high - low);
    if (const auto within = known(Bounded(low, high))) {
      if (sign(within->first) == Sign::zero)
        throw Impossible("it is the same in all positions", "è la stessa in tutte le posizioni");
      if (is_proved(sign(within->first)) || is_proved(sign(first_by_its_slope(Bounded(low, high), *within)))) return;
      if (is_proved(sign(within->second))) {
        const Sign before = sign(number_.bounded(Bounded(low)).first),
                   after = sign(number_.bounded(Bounded(high)).first);
        if (is_proved(before) && is_proved(after)) {
          if (before != after) found_.push_back(closed_in(Bounded(low, high)));
          return;
        }
      }
    }
    look(low, between);
    look(between, high);
  }

  // From the middle on it changes by no more than the second derivative lets it: of short intervals far narrower.
  Bounded first_by_its_slope(const Bounded& angles, const OverAngle<Bounded>& within) const {
    const Bounded middle = midpoint(angles);
    return number_.bounded(middle).first + within.second * (angles - middle);
  }

  // Over so many angles at once; none where that cannot be told.
  std::optional<OverAngle<Bounded>> known(const Bounded& angles) {
    try {
      return number_.bounded(angles);
    } catch (const Undecided&) {
      return {};
    } catch (const Impossible& none) {
      throw NotEverywhere(none.words(), middle_of(angles));
    }
  }

  StationaryPlace closed_in(Bounded angles) const {
    OverAngle<Bounded> within = number_.bounded(angles);
    const bool is_greatest = sign(within.second) == Sign::negative;
    for (;;) {
      const Bounded middle = midpoint(angles), next = middle - newton_step(number_.bounded(middle), within);
      const double low = std::max(next.inf(), angles.inf()), high = std::min(next.sup(), angles.sup());
      constexpr double worth_a_step = 0.9;
      if (!(high - low < worth_a_step * (angles.sup() - angles.inf()))) break;
      angles = Bounded(low, high);
      within = number_.bounded(angles);
    }
    const Bounded middle = midpoint(angles);
    return {within_a_turn(angles, value_there<Bounded>(number_.bounded(middle), within, angles - middle)),
            is_greatest};
  }

  const NumberOverAngle& number_;
  std::vector<StationaryPlace> found_;
  int looks_ = 0;
  bool is_open_ = false;
};

void add_turns(StationaryPlace& place, double turns) { place.at.value += Bounded(2 * turns) * pi<Bounded>(); }

// Between two of them an angle grows, or falls, by less than a turn.
void without_jumps(std::vector<StationaryPlace>& all) {
  for (std::size_t i = 1; i < all.size(); ++i) {
    const double change = middle_of(all[i].at.value - all[i - 1].at.value) / turn_in_doubles;
    add_turns(all[i], std::ceil((all[i].is_greatest ? 0 : -1) - change));
  }
  double least = middle_of(all.front().at.value);
  for (const StationaryPlace& each : all) least = std::min(least, middle_of(each.at.value));
  for (StationaryPlace& each : all) add_turns(each, -std::ceil((least - std::numbers::pi) / turn_in_doubles));
}

}  // namespace

std::vector<StationaryPlace> stationary_places(const NumberOverAngle& number) {
  std::vector<StationaryPlace> all = SearchOverTurn(number)();
  if (all.empty())
    throw Impossible("it grows or falls without end, turn after turn", "cresce o cala senza fine, giro dopo giro");
  if (number.is_angle) without_jumps(all);
  return all;
}

std::vector<StationaryPlace> foremost(const std::vector<StationaryPlace>& all, bool is_greatest) {
  const auto leads = [is_greatest](const StationaryPlace& a, const StationaryPlace& b) {
    return a.is_greatest == is_greatest &&
           sign(a.at.value - b.at.value) == (is_greatest ? Sign::positive : Sign::negative);
  };
  std::vector<StationaryPlace> left;
  for (const StationaryPlace& each : all)
    if (each.is_greatest == is_greatest &&
        std::none_of(all.begin(), all.end(), [&](const StationaryPlace& other) { return leads(other, each); }))
      left.push_back(each);
  return left;
}

Stationary<Deep> closed_in(const NumberOverAngle& number, const StationaryPlace& place) {
  Deep angle = Deep::from_bounded(place.at.angle);
  OverAngle<Deep> within = number.deep(angle);
  constexpr int steps = 7;  // each doubles the digits, from some ten to a thousand
  for (int k = 0; k < steps; ++k) {
    const Deep middle = midpoint(angle);
    angle = middle - newton_step(number.deep(middle), within);
    within = number.deep(angle);
  }
  const Deep middle = midpoint(angle);
  Deep value = value_there<Deep>(number.deep(middle), within, angle - middle);
  if (number.is_angle) {
    const double turns = std::round((middle_of(place.at.value) - enclosure(value).value) / turn_in_doubles);
    value += Deep(static_cast<int>(2 * turns)) * pi<Deep>();
  }
  return within_a_turn<Deep>(angle, value);
}

}  // namespace epure::geometry
