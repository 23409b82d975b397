// Where a construction writes down what it found: quantity by quantity, each under the route that found it.
//
// What is reported goes to every number. What only a drawing needs beside it (the components of a vector of which the
// length is reported, a point that only helps to construct another) is written with `draws...` and looked at on the
// number that drawings are made with. So is what a sheet tells on the way (an iterate, a coefficient): `tells`.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "exercises/kit/proof/asked.h"
#include "exercises/kit/proof/exercise.h"
#include "exercises/kit/proof/zero_for_drawing.h"
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

// |x| without deciding its sign, which an enclosure of zero does not tell; for signs, x².
template <class T>
T magnitude_of(const T& x) {
  return size(geometry::Vector<T>{x, T(0)});
}

// A given.
template <class T>
T number(const Rational& q) {
  return geometry::from_rational<T>(q);
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

struct LedgerEntry {
  std::string quantity, route;
  std::optional<Quantity> described = {};
};

template <class T>
class Ledger {
 public:
  explicit Ledger(std::string route) : route_(std::move(route)) {}

  void route(std::string name) { route_ = std::move(name); }

  // What is written next belongs to a case of the exercise: "dead_centre_folded." comes before every name, and
  // `words`
  // (", folded") after every meaning.
  void begin_case(std::string prefix, Words words = {}) {
    case_ = std::move(prefix);
    words_of_case_ = std::move(words);
  }

  // The axes in which the vectors and points to come are given: x along this unit vector. Their components are
  // written down along the usual axes, to which they return with usual_axes.
  void axes_along(const geometry::Vector<T>& x_axis) { x_axis_ = x_axis; }
  void usual_axes() { x_axis_.reset(); }

  // Writes down what `find` returns, if the quantity is asked for. What it cannot decide stays undecided; what does
  // not exist is absent.
  void put(const std::string& quantity, const std::function<T()>& find) {
    if (is_asked(quantity)) write({case_ + quantity, route_}, find);
  }
  void put(const std::string& quantity, const T& value) {
    put(quantity, [&] { return value; });
  }
  void put(const Quantity& quantity, const std::function<T()>& find) {
    if (is_asked(quantity.name)) write({case_ + quantity.name, route_, quantity}, find);
  }
  void put(const Quantity& quantity, const T& value) {
    put(quantity, [&] { return value; });
  }
  void put(const VectorQuantity& quantity, const geometry::Vector<T>& v) {
    const geometry::Vector<T> seen = in_usual_axes(v);
    put_x(quantity, [&] { return seen.x; });
    put_y(quantity, [&] { return seen.y; });
    put_size(quantity, [&] { return size(v); });
  }
  void put(const PointQuantity& quantity, const geometry::Point<T>& P) {
    const geometry::Vector<T> seen = in_usual_axes({P.x, P.y});
    put_x(quantity, [&] { return seen.x; });
    put_y(quantity, [&] { return seen.y; });
  }
  void put(const PointQuantity& quantity, const geometry::ProjectivePoint<T>& P, const Phrase& at_infinity) {
    const geometry::Vector<T> seen = in_usual_axes({P.x, P.y});
    put_x(quantity, [&] { return ratio(seen.x, P.w, at_infinity); });
    put_y(quantity, [&] { return ratio(seen.y, P.w, at_infinity); });
  }
  // A vector of which the length alone is reported; it is drawn all the same.
  void put_length(const VectorQuantity& quantity, const geometry::Vector<T>& v) {
    put_size(quantity, [&] { return size(v); });
    draws_vector(quantity.name, v);
  }
  // Components of a vector or a point, and the length of a vector, which `find` gives along the usual axes. What is
  // said of a component is put together only where it is asked for: often that takes longer than to find it.
  template <class Located>
  void put_x(const Located& quantity, const std::function<T()>& find) {
    if (is_asked(quantity.name + "_x")) put(quantity.x(), find);
  }
  template <class Located>
  void put_y(const Located& quantity, const std::function<T()>& find) {
    if (is_asked(quantity.name + "_y")) put(quantity.y(), find);
  }
  void put_size(const VectorQuantity& quantity, const std::function<T()>& find) {
    if (is_asked(quantity.name)) put(quantity.length(), find);
  }
  // What only drawings show, and sheets may print.
  void draws(const Quantity& quantity, const std::function<T()>& find) { draws(quantity.name, find, quantity); }
  // A point that helps to construct others.
  void draws_point(const std::string& name, const geometry::Point<T>& P) { draws_vector(name, {P.x, P.y}); }
  // One that may not exist: each coordinate looks for it anew.
  void draws_point(const std::string& name, const std::function<geometry::Point<T>()>& find) {
    draws(name + "_x", [&] { return in_usual_axes(find() - geometry::Point<T>{T(0), T(0)}).x; });
    draws(name + "_y", [&] { return in_usual_axes(find() - geometry::Point<T>{T(0), T(0)}).y; });
  }
  void draws_vector(const std::string& name, const geometry::Vector<T>& v) {
    const geometry::Vector<T> seen = in_usual_axes(v);
    draws(name + "_x", [&] { return seen.x; });
    draws(name + "_y", [&] { return seen.y; });
  }
  void draws_point(const std::string& name, const geometry::ProjectivePoint<T>& P, const Phrase& at_infinity) {
    const geometry::Vector<T> seen = in_usual_axes({P.x, P.y});
    draws(name + "_x", [&] { return ratio(seen.x, P.w, at_infinity); });
    draws(name + "_y", [&] { return ratio(seen.y, P.w, at_infinity); });
  }
  // A number of the drawing, or of its text, that is not reported.
  template <class Find>
  void tells(const Quantity& quantity, const Find& find) {
    draws(quantity.name, find, quantity);
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
  // The distance from P, which may be at infinity, to X. `name`: a text or a Quantity.
  template <class Name>
  void distance(const Name& name, const geometry::ProjectivePoint<T>& P, const geometry::Point<T>& X,
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

  // Of some quantities, each by the first route that knows it: no further route is asked.
  bool knows_all_asked() const {
    return FirstRouteOnly::holds() && !Asked::for_all() && known_.size() == Asked::count();
  }

  std::vector<LedgerEntry>& entries() { return entries_; }
  std::vector<geometry::Reading<T>>& readings() { return readings_; }
  // What only drawings need; empty but on their number.
  std::vector<LedgerEntry>& drawn_entries() { return drawn_entries_; }
  std::vector<geometry::Reading<T>>& drawn_readings() { return drawn_readings_; }

 private:
  // A list of all that would be found is one of all, whatever is asked.
  bool is_asked(const std::string& quantity) const {
    const std::string name = case_ + quantity;
    if (FirstRouteOnly::holds() && known_.contains(name)) return false;
    return NamesOnly::holds() || Asked::for_quantity(name);
  }
  void write(LedgerEntry entry, const std::function<T()>& find) {
    const bool is_wanted = !NamesOnly::holds() && geometry::climbing::Wanted::is(entries_.size());
    if (entry.described) {
      entry.described->name = entry.quantity;
      entry.described->meaning = entry.described->meaning + words_of_case_;
    }
    entries_.push_back(std::move(entry));
    readings_.push_back(is_wanted ? geometry::Reading<T>::from(find) : geometry::Reading<T>::undecided({}));
    if (FirstRouteOnly::holds() &&
        geometry::climbing::finding_of(readings_.back()).kind == geometry::climbing::Finding::Kind::value)
      known_.insert(entries_.back().quantity);
  }
  template <class Find>
  void draws(const std::string& name, const Find& find, const std::optional<Quantity>& described = {}) {
    if constexpr (std::is_same_v<T, geometry::Deep>) {
      if (!ForDrawings::holds() || !Asked::for_all()) return;
      drawn_entries_.push_back({case_ + name, route_, described});
      drawn_readings_.push_back(geometry::Reading<T>::from(find));
    }
  }
  geometry::Vector<T> in_usual_axes(const geometry::Vector<T>& v) const {
    return x_axis_ ? v.x * *x_axis_ + v.y * geometry::quarter_turn(*x_axis_) : v;
  }

  std::optional<geometry::Vector<T>> x_axis_;
  std::string route_, case_;
  Words words_of_case_;
  std::set<std::string> known_;  // with FirstRouteOnly
  std::vector<LedgerEntry> entries_, drawn_entries_;
  std::vector<geometry::Reading<T>> readings_, drawn_readings_;
};

// With 256 bits, and up to 2048 while these leave the scene undecided, do not tell a value from zero, or tell less of
// it than sheets print.
template <class Scene>
std::vector<geometry::Settled> settled_for_drawing(const Scene& scene) {
  constexpr long most_bits = 2048;
  const auto is_known = [](const geometry::Settled& value, long bits) {
    constexpr double printed = 1e-7;
    const auto& [lower, middle, upper] = value.enclosure;
    return value.kind != geometry::Settled::Kind::enclosed ||
           (!may_be_zero(value.enclosure) && upper - lower <= printed * std::abs(middle)) ||
           is_zero_for_drawing(value.enclosure, bits);
  };
  for (long bits = 256;; bits *= 2) {
    try {
      std::vector<geometry::Settled> settled = geometry::only_deep(scene, bits);
      if (bits == most_bits || std::all_of(settled.begin(), settled.end(),
                                           [&](const geometry::Settled& value) { return is_known(value, bits); }))
        return settled;
    } catch (const geometry::Undecided&) {
      if (bits == most_bits) throw;
    }
  }
}

// By how many routes a drawing wants a quantity: most show it once.
enum class Drawn { by_first_route, by_every_route };

// Runs `write<T>()`, which returns a Ledger<T> with the same keys for every T, up the numbers as `rung` says.
template <class Write>
std::vector<RouteValue> settle(const Write& write, Rung rung, Drawn drawn = Drawn::by_first_route) {
  const FirstRouteOnly once(FirstRouteOnly::holds() || (rung == Rung::drawing && drawn == Drawn::by_first_route));
  const NamesOnly nothing(rung == Rung::names);
  const ForDrawings with_drawings(rung == Rung::drawing);
  std::vector<LedgerEntry> entries;
  const auto scene = [&]<class T>() {
    Ledger<T> ledger = write.template operator()<T>();
    entries = std::move(ledger.entries());
    std::vector<geometry::Reading<T>> readings = std::move(ledger.readings());
    if (ForDrawings::holds()) {
      std::move(ledger.drawn_entries().begin(), ledger.drawn_entries().end(), std::back_inserter(entries));
      std::move(ledger.drawn_readings().begin(), ledger.drawn_readings().end(), std::back_inserter(readings));
    }
    return readings;
  };
  // What one route has settled needs no proof by the others: their enclosures are compared with it.
  const auto is_open = [&](std::size_t i, const std::vector<geometry::Settled>& so_far) {
    for (std::size_t k = 0; k < entries.size(); ++k)
      if (entries[k].quantity == entries[i].quantity && so_far[k].kind == geometry::Settled::Kind::certain)
        return false;
    return true;
  };
  std::vector<geometry::Settled> settled = rung == Rung::names || rung == Rung::fast ? geometry::only_fast(scene)
                                           : rung == Rung::bounded                   ? geometry::only_bounded(scene)
                                           : rung == Rung::drawing                   ? settled_for_drawing(scene)
                                                                   : geometry::climb(scene, is_open);
  std::vector<RouteValue> values;
  values.reserve(settled.size());
  for (std::size_t i = 0; i < settled.size(); ++i) {
    LedgerEntry& entry = entries[i];
    values.push_back(
        {std::move(entry.quantity), std::move(entry.route), std::move(settled[i]), std::move(entry.described)});
  }
  return values;
}

}  // namespace epure
