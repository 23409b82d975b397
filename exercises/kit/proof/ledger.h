// Where a construction writes down what it found: quantity by quantity, each under the route that found it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "exercises/kit/statement/exercise.h"
#include "geometry/constructions/cycle.h"
#include "geometry/numbers/climb.h"

namespace epure {

// The exact numbers are asked for signs only, so they need no roots and no angles.
template <class T>
inline constexpr bool signs_only = std::is_same_v<T, geometry::Exact> || std::is_same_v<T, geometry::Generic> ||
                                   std::is_same_v<T, geometry::Calcium>;

// |v|; for signs, its square, which is zero when the length is.
template <class T>
T size(const geometry::Vector<T>& v) {
  if constexpr (signs_only<T>) {
    return geometry::length_squared(v);
  } else {
    return geometry::length(v);
  }
}

// The angle of the direction v in [-pi/2, pi/2], for v.x >= 0; for signs, v.y, which has the sign of the angle.
// Throws Impossible when v is proved to have no direction.
template <class T>
T slope_angle(const geometry::Vector<T>& v) {
  if (geometry::sign(v.y) == geometry::Sign::zero && geometry::sign(v.x) == geometry::Sign::zero)
    throw geometry::Impossible("both sides of the angle are zero: it has no value",
                               "i due lati dell'angolo sono nulli: non ha valore");
  if constexpr (signs_only<T>) {
    return v.y;
  } else {
    return geometry::arc_tangent(v.y, v.x);
  }
}

template <class T>
class Ledger {
 public:
  explicit Ledger(std::string route) : route_(std::move(route)) {}

  void route(std::string name) { route_ = std::move(name); }

  // What is written next belongs to a case of the exercise: "dead_centre_folded." comes before every name.
  void begin_case(std::string prefix) { case_ = std::move(prefix); }

  // The axes in which the vectors and points to come are given: x along this unit vector. Their components are
  // written down along the usual axes, to which they return with usual_axes.
  void axes_along(const geometry::Vector<T>& x_axis) { x_axis_ = x_axis; }
  void usual_axes() { x_axis_.reset(); }

  // Writes down what `find` returns. What it cannot decide stays undecided; what does not exist is absent.
  void put(const std::string& quantity, const std::function<T()>& find) {
    const bool is_wanted = geometry::climbing::Wanted::is(keys_.size());
    keys_.push_back({case_ + quantity, route_});
    readings_.push_back(is_wanted ? geometry::Reading<T>::from(find) : geometry::Reading<T>::undecided({}));
  }
  void put(const std::string& quantity, const T& value) {
    put(quantity, [&] { return value; });
  }
  void vector(const std::string& name, const geometry::Vector<T>& v) {
    const geometry::Vector<T> seen = in_usual_axes(v);
    put(name + "_x", seen.x);
    put(name + "_y", seen.y);
    put(name, [&] { return size(v); });
  }
  void point(const std::string& name, const geometry::Point<T>& P) {
    const geometry::Vector<T> seen = in_usual_axes({P.x, P.y});
    put(name + "_x", seen.x);
    put(name + "_y", seen.y);
  }
  // Coordinates of a point that may be at infinity, which `at_infinity` then says.
  void point(const std::string& name, const geometry::ProjectivePoint<T>& P, const Phrase& at_infinity) {
    const geometry::Vector<T> seen = in_usual_axes({P.x, P.y});
    put(name + "_x", [&] { return ratio(seen.x, P.w, at_infinity); });
    put(name + "_y", [&] { return ratio(seen.y, P.w, at_infinity); });
  }
  // The distance from P, which may be at infinity, to X.
  void distance(const std::string& name, const geometry::ProjectivePoint<T>& P, const geometry::Point<T>& X,
                const Phrase& at_infinity) {
    put(name, [&] {
      const geometry::Vector<T> d{X.x * P.w - P.x, X.y * P.w - P.y};
      if constexpr (signs_only<T>) {
        return ratio(size(d), geometry::square(P.w), at_infinity);
      } else {
        return ratio(size(d), geometry::absolute(P.w), at_infinity);
      }
    });
  }

  // numerator / denominator; absent, for the reason given, when the denominator is proved zero.
  static T ratio(const T& numerator, const T& denominator, const Phrase& when_zero) {
    switch (geometry::sign(denominator)) {
      case geometry::Sign::zero:
        throw geometry::Impossible(when_zero);
      case geometry::Sign::undecided:
        throw geometry::Undecided(Words{"whether ", "se "} + when_zero);
      default:
        return geometry::quotient(numerator, denominator);
    }
  }

  const std::vector<std::pair<std::string, std::string>>& keys() const { return keys_; }
  const std::vector<geometry::Reading<T>>& readings() const { return readings_; }

 private:
  geometry::Vector<T> in_usual_axes(const geometry::Vector<T>& v) const {
    return x_axis_ ? v.x * *x_axis_ + v.y * geometry::quarter_turn(*x_axis_) : v;
  }

  std::optional<geometry::Vector<T>> x_axis_;
  std::string route_, case_;
  std::vector<std::pair<std::string, std::string>> keys_;
  std::vector<geometry::Reading<T>> readings_;
};

// Runs `write<T>()`, which returns a Ledger<T> with the same keys for every T, up the numbers as `rung` says.
template <class Write>
std::vector<RouteValue> settle(const Write& write, Rung rung) {
  std::vector<std::pair<std::string, std::string>> keys;
  const auto scene = [&]<class T>() {
    const Ledger<T> ledger = write.template operator()<T>();
    keys = ledger.keys();
    return ledger.readings();
  };
  // What one route has settled needs no proof by the others: their enclosures are compared with it.
  const auto is_open = [&](std::size_t i, const std::vector<geometry::Settled>& so_far) {
    for (std::size_t k = 0; k < keys.size(); ++k)
      if (keys[k].first == keys[i].first && so_far[k].kind == geometry::Settled::Kind::certain) return false;
    return true;
  };
  const std::vector<geometry::Settled> settled = rung == Rung::fast      ? geometry::only_fast(scene)
                                                 : rung == Rung::bounded ? geometry::only_bounded(scene)
                                                                         : geometry::climb(scene, is_open);
  std::vector<RouteValue> values;
  for (std::size_t i = 0; i < settled.size(); ++i) values.push_back({keys[i].first, keys[i].second, settled[i]});
  return values;
}

}  // namespace epure
