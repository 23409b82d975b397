// Friction in hinges: the couple of each is the radius of its friction circle times its force, which is not known
// before the couple is. Equilibrium is linear, so every force is R + sum of y_k D_k, with the sizes y of the forces
// in the hinges that rub: R without these couples, D_k by the couple of hinge k where its force is 1 N. Sought are
// the sizes with y_h = |R_h + sum of y_k D_hk|.
//
// Hinges that others do not act on go first. Of one that is a quadratic equation. Of more together, where every
// change of the sizes comes back smaller, one set of them holds and no other (Banach); else all there are are sought
// by subdivision, in doubles, and each is proved to be the only one in its box, or none (Krawczyk). Both routes read
// this, each with its own equilibrium.
#pragma once

#include <algorithm>
#include <optional>
#include <type_traits>
#include <vector>

#include "geometry/linkages/friction.h"

namespace epure::geometry {

template <class T>
using Sizes = std::vector<T>;

template <class T>
struct RubbingHinges {
  struct Force {
    T x, y;
    Force operator+(const Force& other) const { return {x + other.x, y + other.y}; }
    friend Force operator*(const T& factor, const Force& force) { return {factor * force.x, factor * force.y}; }
    friend T dot(const Force& a, const Force& b) { return a.x * b.x + a.y * b.y; }
    bool is_zero() const { return sign(x) == Sign::zero && sign(y) == Sign::zero; }
    T size() const { return root(square(x) + square(y)); }
  };
  std::vector<Force> without;          // R
  std::vector<std::vector<Force>> by;  // D: in hinge h, of hinge k

  std::size_t count() const { return without.size(); }
  // `loaded` times all loads.
  Force force(std::size_t h, const Sizes<T>& sizes, const T& loaded = T(1)) const {
    Force sum = loaded * without[h];
    for (std::size_t k = 0; k < count(); ++k) sum = sum + sizes[k] * by[h][k];
    return sum;
  }
  // Of these hinges, with none in the others.
  RubbingHinges only(const std::vector<std::size_t>& these) const {
    RubbingHinges some;
    for (const std::size_t h : these) {
      some.without.push_back(without[h]);
      some.by.emplace_back();
      for (const std::size_t k : these) some.by.back().push_back(by[h][k]);
    }
    return some;
  }
};

template <class T>
bool bear_nothing(const RubbingHinges<T>& hinges) {
  return std::all_of(hinges.without.begin(), hinges.without.end(), [](const auto& force) { return force.is_zero(); });
}

// Of a number that encloses or is a double: that one as an enclosure in doubles, and back from doubles.
inline Bounded in_doubles(Fast x) { return x; }
inline Bounded in_doubles(const Bounded& x) { return x; }
inline Bounded in_doubles(const Deep& x) { return to_bounded(x); }
template <class T>
T of_double(double x) {
  if constexpr (std::is_same_v<T, Deep>)
    return Deep::from_double(x);
  else
    return T(x);
}
template <class T>
RubbingHinges<Bounded> in_doubles(const RubbingHinges<T>& hinges) {
  const auto of = [](const auto& force) {
    return RubbingHinges<Bounded>::Force{in_doubles(force.x), in_doubles(force.y)};
  };
  RubbingHinges<Bounded> all;
  for (std::size_t h = 0; h < hinges.count(); ++h) {
    all.without.push_back(of(hinges.without[h]));
    all.by.emplace_back();
    for (const auto& force : hinges.by[h]) all.by.back().push_back(of(force));
  }
  return all;
}

// --- Newton ---
using Matrix = std::vector<std::vector<double>>;
// Near the inverse; none where the matrix has none.
std::optional<Matrix> near_inverse(const Matrix& matrix);

// How y_h - |force h| grows with the sizes, anywhere in the box: |F| grows by F/|F|, of which at least is known that
// it is no longer than 1.
template <class T>
std::vector<Sizes<T>> slopes(const RubbingHinges<T>& hinges, const Sizes<T>& box) {
  std::vector<Sizes<T>> all;
  for (std::size_t h = 0; h < hinges.count(); ++h) {
    const auto force = hinges.force(h, box);
    const T size = force.size();
    const bool has_direction = sign(size) == Sign::positive;
    const auto along = [&](const T& part) { return has_direction ? quotient(part, size) : widened(T(0), T(1)); };
    const typename RubbingHinges<T>::Force u{along(force.x), along(force.y)};
    all.emplace_back();
    for (std::size_t k = 0; k < hinges.count(); ++k) all[h].push_back(T(h == k ? 1 : 0) - dot(u, hinges.by[h][k]));
  }
  return all;
}

// Krawczyk: a solution in m ± radius lies no farther than `spread` from m - step.
// (Neumaier, Interval Methods for Systems of Equations, section 5.1.)
template <class T>
class NewtonStep {
 public:
  NewtonStep(const RubbingHinges<T>& hinges, const Sizes<T>& m) : hinges_(hinges), m_(m) {
    Matrix at_m;
    for (const Sizes<T>& row : slopes(hinges, m)) {
      at_m.emplace_back();
      for (const T& slope : row) at_m.back().push_back(enclosure(slope).value);
    }
    inverse_ = near_inverse(at_m);
    if (!inverse_) return;
    for (std::size_t h = 0; h < m.size(); ++h) left_.push_back(m[h] - hinges.force(h, m).size());
    for (std::size_t h = 0; h < m.size(); ++h) {
      step_.emplace_back(0);
      for (std::size_t k = 0; k < m.size(); ++k) step_[h] += inverse(h, k) * left_[k];
    }
  }
  bool exists() const { return inverse_.has_value(); }
  bool is_at_solution() const {
    return std::all_of(left_.begin(), left_.end(), [](const T& left) { return sign(left) == Sign::zero; });
  }
  const Sizes<T>& step() const { return step_; }
  Sizes<T> spread(const Sizes<T>& radius) const {
    Sizes<T> box, all;
    for (std::size_t k = 0; k < m_.size(); ++k) box.push_back(widened(m_[k], radius[k]));
    const std::vector<Sizes<T>> J = slopes(hinges_, box);
    for (std::size_t h = 0; h < m_.size(); ++h) {
      all.emplace_back(0);
      for (std::size_t k = 0; k < m_.size(); ++k) {
        T off(h == k ? 1 : 0);
        for (std::size_t i = 0; i < m_.size(); ++i) off -= inverse(h, i) * J[i][k];
        all[h] += root(square(off)) * radius[k];
      }
    }
    return all;
  }
  // Where it is proved that in m ± radius there is one solution, and no other: a box that holds it.
  std::optional<Sizes<T>> only_one(const Sizes<T>& radius) const {
    const Sizes<T> around = spread(radius);
    Sizes<T> box;
    for (std::size_t k = 0; k < m_.size(); ++k) {
      if (sign(radius[k] - root(square(step_[k])) - around[k]) != Sign::positive) return {};
      box.push_back(widened(m_[k] - step_[k], around[k]));
    }
    return box;
  }

 private:
  T inverse(std::size_t h, std::size_t k) const { return of_double<T>((*inverse_)[h][k]); }

  const RubbingHinges<T>& hinges_;
  Sizes<T> m_, left_ = {}, step_ = {};
  std::optional<Matrix> inverse_;
};

// From near a solution to where no more is to be gained; none where the way ends.
template <class T>
std::optional<Sizes<T>> iterated(const RubbingHinges<T>& hinges, Sizes<T> sizes, int most_steps) {
  for (int i = 0; i < most_steps; ++i) {
    const NewtonStep<T> newton(hinges, sizes);
    if (!newton.exists()) return {};
    bool goes_on = false;
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      const Sign step = sign(newton.step()[k]);
      goes_on = goes_on || step == Sign::positive || step == Sign::negative;
      sizes[k] = midpoint(sizes[k] - newton.step()[k]);
    }
    if (!goes_on) break;
  }
  return sizes;
}

// A narrow box that holds a solution, about where iteration has led.
template <class T>
std::optional<Sizes<T>> narrow_box(const RubbingHinges<T>& hinges, const Sizes<T>& m) {
  const NewtonStep<T> newton(hinges, m);
  if (!newton.exists()) return {};
  if (newton.is_at_solution()) return m;
  const auto twice = [](const T& x) { return midpoint(T(4) * root(square(x))); };
  Sizes<T> radius;
  for (const T& x : newton.step()) radius.push_back(twice(x));
  constexpr int most_boxes = 12;
  for (int boxes = 0; boxes < most_boxes; ++boxes) {
    if (const auto box = newton.only_one(radius)) return box;
    const Sizes<T> around = newton.spread(radius);
    for (std::size_t k = 0; k < m.size(); ++k) radius[k] = twice(root(square(newton.step()[k])) + around[k]);
  }
  return {};
}

// --- all solutions ---
// One, and no other in `around`.
struct OneSet {
  Sizes<Bounded> sizes, around;
};
// All there are. Throws Undecided.
std::vector<OneSet> all_sets(const RubbingHinges<Bounded>& hinges);
bool is_within(const Sizes<Bounded>& inner, const Sizes<Bounded>& outer);

inline Undecided not_settled() {
  return {"which forces friction in the hinges settles at", "a quali forze conduca l'attrito nelle cerniere"};
}

// Whether every change of the sizes comes back smaller, some measured in other units than others.
template <class T>
bool is_contraction(const RubbingHinges<T>& hinges) {
  const auto size_at_most = [](const auto& force) {
    if constexpr (NumberWithAngles<T>) {
      return force.size();
    } else {  // without roots
      const auto magnitude = [](const T& x) { return sign(x) == Sign::negative ? -x : x; };
      return magnitude(force.x) + magnitude(force.y);
    }
  };
  const std::size_t n = hinges.count();
  std::vector<Sizes<T>> sizes(n);
  for (std::size_t h = 0; h < n; ++h)
    for (const auto& force : hinges.by[h]) sizes[h].push_back(size_at_most(force));
  const auto come_back = [&](const Sizes<T>& units) {
    Sizes<T> all(n, T(0));
    for (std::size_t h = 0; h < n; ++h)
      for (std::size_t k = 0; k < n; ++k) all[h] += sizes[h][k] * units[k];
    return all;
  };
  Sizes<T> units(n, T(1));
  if constexpr (NumberWithAngles<T>) {
    constexpr int trials = 40;
    for (int i = 0; i < trials; ++i) {
      Sizes<T> next = come_back(units);
      for (T& unit : next) unit = midpoint(T(1) + unit);
      units = std::move(next);
    }
  }
  const Sizes<T> back = come_back(units);
  for (std::size_t h = 0; h < n; ++h)
    if (sign(units[h] - back[h]) != Sign::positive) return false;
  return true;
}

// y = |R + y D|: (1 - D²) y² - 2 R·D y - R² = 0, and y not below zero.
template <class T>
std::vector<Sizes<T>> sizes_of_one(const RubbingHinges<T>& hinge) {
  const auto &R = hinge.without[0], &D = hinge.by[0][0];
  if (R.is_zero() && D.is_zero()) return {{T(0)}};
  const auto decided = [](const T& x) {
    const Sign is = sign(x);
    if (is == Sign::undecided) throw not_settled();
    return is;
  };
  const T a = T(1) - dot(D, D), b = dot(R, D), c = dot(R, R);
  const Sign of_a = decided(a);
  const T quarter = square(b) + a * c;
  if (of_a == Sign::positive) return {{quotient(b + root(quarter), a)}};
  if (decided(c) == Sign::zero) {
    if (of_a == Sign::zero) throw not_settled();
    return {{T(0)}};
  }
  if (decided(b) != Sign::negative) return {};
  if (of_a == Sign::zero) return {{quotient(-c, T(2) * b)}};
  const Sign of_quarter = decided(quarter);
  if (of_quarter == Sign::negative) return {};
  if (of_quarter == Sign::zero) return {{quotient(b, a)}};
  return {{quotient(b + root(quarter), a)}, {quotient(b - root(quarter), a)}};
}

// That set, on the number at hand.
template <class T>
Sizes<T> refined(const RubbingHinges<T>& hinges, const OneSet& set) {
  Sizes<T> sizes;
  for (const Bounded& size : set.sizes)
    if constexpr (std::is_same_v<T, Bounded>)
      sizes.push_back(size);
    else
      sizes.push_back(of_double<T>(enclosure(size).value));
  if constexpr (std::is_same_v<T, Deep>) {
    constexpr int most_steps = 200;
    const auto near = iterated(hinges, sizes, most_steps);
    const auto box = near ? narrow_box(hinges, *near) : near;
    if (!box) throw not_settled();
    sizes = *box;
    Sizes<Bounded> rounded;
    for (const T& size : sizes) rounded.push_back(in_doubles(size));
    if (!is_within(rounded, set.around)) throw not_settled();
  }
  return sizes;
}

// Of hinges each of which acts on all of them.
template <class T>
std::vector<Sizes<T>> sizes_together(const RubbingHinges<T>& hinges) {
  if (hinges.count() == 1) return sizes_of_one(hinges);
  const Sizes<T> none(hinges.count(), T(0));
  if constexpr (!NumberWithAngles<T>) {
    if (bear_nothing(hinges) && is_contraction(hinges)) return {none};
    throw Undecided("forces with friction circles on exact numbers", "forze con cerchi d'attrito su numeri esatti");
  } else {
    const std::vector<OneSet> sets = all_sets(in_doubles(hinges));
    if (bear_nothing(hinges) && sets.size() == 1) return {none};
    std::vector<Sizes<T>> all;
    for (const OneSet& set : sets) all.push_back(refined(hinges, set));
    return all;
  }
}

// Those that act on no other but through others come last, so that each is found of known ones.
std::vector<std::vector<std::size_t>> one_after_another(const std::vector<std::vector<bool>>& acts_on);

template <class T>
std::vector<Sizes<T>> all_sizes(const RubbingHinges<T>& hinges) {
  std::vector<std::vector<bool>> acts_on(hinges.count(), std::vector<bool>(hinges.count()));
  for (std::size_t h = 0; h < hinges.count(); ++h)
    for (std::size_t k = 0; k < hinges.count(); ++k) acts_on[k][h] = !hinges.by[h][k].is_zero();
  std::vector<Sizes<T>> all{Sizes<T>(hinges.count(), T(0))};
  for (const std::vector<std::size_t>& together : one_after_another(acts_on)) {
    std::vector<Sizes<T>> longer;
    for (const Sizes<T>& known : all) {
      RubbingHinges<T> next = hinges.only(together);
      for (std::size_t i = 0; i < together.size(); ++i) next.without[i] = hinges.force(together[i], known);
      for (const Sizes<T>& found : sizes_together(next)) {
        longer.push_back(known);
        for (std::size_t i = 0; i < together.size(); ++i) longer.back()[together[i]] = found[i];
      }
    }
    all = std::move(longer);
  }
  return all;
}

template <class T>
class FrictionCircles {
 public:
  using Couples = std::vector<T>;  // on the second links

  // `turning`: how fast the second link of each hinge turns on the first. Throws Impossible where one with friction
  // does not turn.
  FrictionCircles(const Linkage& linkage, const Loads& loads, const std::vector<T>& turning) {
    const JointForces<T> none(linkage);
    count_ = none.hinges.size();
    for (const HingeFriction& each : loads.hinge_frictions)
      for (std::size_t k = 0; k < count_; ++k)
        if (none.hinges[k].point == each.point && each.radius != 0)
          arms_.push_back({k, T(-sense_of_sliding(turning[k])) * from_rational<T>(each.radius)});
  }

  bool rub() const { return !arms_.empty(); }

  // All sets of forces: `find` gives the forces for these couples, with all loads or without. Throws Undecided.
  template <class Find>
  std::vector<JointForces<T>> forces(const Find& find) const {
    if (!rub()) return {find(Couples(count_, T(0)), true)};
    RubbingHinges<T> hinges{in_arms(find(couples(Sizes<T>(arms_.size(), T(0))), true)), {}};
    hinges.by.resize(arms_.size());
    for (std::size_t k = 0; k < arms_.size(); ++k) {
      Sizes<T> one(arms_.size(), T(0));
      one[k] = T(1);
      const auto brought = in_arms(find(couples(one), false));
      for (std::size_t h = 0; h < arms_.size(); ++h) hinges.by[h].push_back(brought[h]);
    }
    std::vector<JointForces<T>> all;
    for (const Sizes<T>& sizes : all_sizes(hinges)) all.push_back(find(couples(sizes), true));
    return all;
  }

  // What is zero, all of it, where the couples are those of these forces.
  std::vector<T> left_over(const JointForces<T>& forces) const {
    std::vector<T> all;
    for (const Arm& arm : arms_) {
      const auto& hinge = forces.hinges[arm.hinge];
      all.push_back(square(hinge.couple) - square(arm.length) * (square(hinge.x) + square(hinge.y)));
      const T along = hinge.couple * arm.length;
      if (sign(along) != Sign::positive) all.push_back(along);
    }
    return all;
  }

 private:
  struct Arm {
    std::size_t hinge;
    T length;  // the radius, against the turning
  };
  Couples couples(const Sizes<T>& sizes) const {
    Couples all(count_, T(0));
    for (std::size_t k = 0; k < arms_.size(); ++k) all[arms_[k].hinge] = arms_[k].length * sizes[k];
    return all;
  }
  std::vector<typename RubbingHinges<T>::Force> in_arms(const JointForces<T>& forces) const {
    std::vector<typename RubbingHinges<T>::Force> all;
    for (const Arm& arm : arms_) all.push_back({forces.hinges[arm.hinge].x, forces.hinges[arm.hinge].y});
    return all;
  }

  std::size_t count_ = 0;
  std::vector<Arm> arms_;
};

}  // namespace epure::geometry
