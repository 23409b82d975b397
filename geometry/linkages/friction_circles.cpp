#include "geometry/linkages/friction_circles.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace epure::geometry {

std::optional<Matrix> near_inverse(const Matrix& matrix) {
  const auto n = static_cast<Eigen::Index>(matrix.size());
  Eigen::MatrixXd all(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index k = 0; k < n; ++k) all(i, k) = matrix[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
  const Eigen::MatrixXd inverse = all.partialPivLu().inverse();
  Matrix found(matrix);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index k = 0; k < n; ++k) {
      if (!std::isfinite(inverse(i, k))) return {};
      found[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] = inverse(i, k);
    }
  return found;
}

std::vector<std::vector<std::size_t>> one_after_another(const std::vector<std::vector<bool>>& acts_on) {
  const std::size_t n = acts_on.size();
  std::vector<std::vector<bool>> reaches = acts_on;
  for (std::size_t via = 0; via < n; ++via)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < n; ++k) reaches[i][k] = reaches[i][k] || (reaches[i][via] && reaches[via][k]);
  std::vector<bool> is_in(n);
  std::vector<std::vector<std::size_t>> all;
  const auto is_next = [&](std::size_t i) {
    for (std::size_t k = 0; k < n; ++k)
      if (!is_in[k] && reaches[k][i] && !reaches[i][k]) return false;
    return !is_in[i];
  };
  for (std::size_t round = 0; round < n; ++round)
    for (std::size_t i = 0; i < n; ++i) {
      if (!is_next(i)) continue;
      std::vector<std::size_t>& together = all.emplace_back();
      for (std::size_t k = 0; k < n; ++k)
        if (k == i || (reaches[i][k] && reaches[k][i])) together.push_back(k);
      for (const std::size_t k : together) is_in[k] = true;
    }
  return all;
}

bool is_within(const Sizes<Bounded>& inner, const Sizes<Bounded>& outer) {
  for (std::size_t k = 0; k < inner.size(); ++k)
    if (inner[k].inf() < outer[k].inf() || inner[k].sup() > outer[k].sup()) return false;
  return true;
}

namespace {

constexpr int newton_steps = 40;

Sizes<Bounded> midpoints(const Sizes<Bounded>& box) {
  Sizes<Bounded> all;
  for (const Bounded& size : box) all.push_back(midpoint(size));
  return all;
}
// How far the box reaches from that point in it.
Sizes<Bounded> reach(const Sizes<Bounded>& box, const Sizes<Bounded>& from) {
  Sizes<Bounded> all;
  for (std::size_t k = 0; k < box.size(); ++k) {
    const Bounded off = box[k] - from[k];
    all.emplace_back(std::max(-off.inf(), off.sup()));
  }
  return all;
}

OneSet nothing_at_all(std::size_t n) {
  return {Sizes<Bounded>(n, Bounded(0)), Sizes<Bounded>(n, Bounded(-HUGE_VAL, HUGE_VAL))};
}

// All solutions, by subdivision. However large they are: the equations hold of all forces and loads at once in any
// measure, so loads and sizes are sought of which the largest is 1; sizes alone where nothing is borne.
class AllSets {
 public:
  explicit AllSets(const RubbingHinges<Bounded>& hinges) : hinges_(hinges) {
    double most = 0;
    for (const auto& force : hinges.without) most = std::max(most, force.size().sup());
    // A power of two, so that nothing is rounded.
    scale_ = most > 0 && std::isfinite(most) ? std::ldexp(1.0, std::ilogb(most) + 2) : 1.0;
  }

  std::vector<OneSet> all() {
    const bool bears_nothing = bear_nothing(hinges_);
    for (std::size_t largest = 0; largest <= hinges_.count(); ++largest) {
      Part part{Sizes<Bounded>(hinges_.count(), Bounded(0, 1)), bears_nothing ? Bounded(0) : Bounded(0, 1)};
      if (largest < hinges_.count())
        part.sizes[largest] = 1;
      else if (bears_nothing)
        continue;
      else
        part.loads = 1;
      parts_.push_back(part);
    }
    constexpr int most_parts = 4000;
    for (int count = 0; !parts_.empty(); ++count) {
      if (count == most_parts) throw not_settled();
      Part part = std::move(parts_.back());
      parts_.pop_back();
      if (!may_hold_one(part) || is_cleared(part)) continue;
      divide(std::move(part));
    }
    if (bears_nothing) return {nothing_at_all(hinges_.count())};
    return found_;
  }

 private:
  struct Part {
    Sizes<Bounded> sizes;  // in `scale_`
    Bounded loads;
  };

  // Narrows the sizes to what the forces that they give may have.
  bool may_hold_one(Part& part) const {
    constexpr int times = 3;
    for (int i = 0; i < times; ++i)
      for (std::size_t h = 0; h < hinges_.count(); ++h) {
        const Bounded size = hinges_.force(h, part.sizes, part.loads / scale_).size();
        const double lower = std::max(size.inf(), part.sizes[h].inf()),
                     upper = std::min(size.sup(), part.sizes[h].sup());
        if (lower > upper) return false;
        part.sizes[h] = Bounded(lower, upper);
      }
    return true;
  }
  // Whether it is proved what solutions the part has.
  bool is_cleared(const Part& part) {
    if (sign(part.loads) != Sign::positive) return false;
    Sizes<Bounded> box;
    for (const Bounded& size : part.sizes) box.push_back(size * scale_ / part.loads);
    if (is_in_one_found(box)) return true;
    const Sizes<Bounded> m = midpoints(box), radius = reach(box, m);
    const NewtonStep<Bounded> newton(hinges_, m);
    if (!newton.exists()) return false;
    const Sizes<Bounded> around = newton.spread(radius);
    bool leads_inside = true;
    for (std::size_t k = 0; k < m.size(); ++k) {
      const Bounded to = widened(m[k] - newton.step()[k], around[k]);
      if (to.inf() > box[k].sup() || to.sup() < box[k].inf()) return true;
      leads_inside = leads_inside && (box[k] - m[k] + newton.step()[k]).do_overlap(0);
    }
    if (leads_inside) find_from(m);
    return is_in_one_found(box);
  }
  void find_from(const Sizes<Bounded>& start) {
    const auto m = iterated(hinges_, start, newton_steps);
    if (!m || is_in_one_found(*m)) return;
    const auto sizes = narrow_box(hinges_, *m);
    if (!sizes) return;
    // As wide a box as may be in which there is no other.
    double most = 0;
    for (const Bounded& size : *m) most = std::max(most, size.sup());
    const NewtonStep<Bounded> newton(hinges_, *m);
    Sizes<Bounded> around = *sizes;
    constexpr int halvings = 40;
    for (int i = 0; i < halvings; ++i) {
      const Sizes<Bounded> radius(m->size(), std::ldexp(most, -i));
      if (!newton.only_one(radius)) continue;
      for (std::size_t k = 0; k < m->size(); ++k) around[k] = widened((*m)[k], radius[k]);
      break;
    }
    for (const OneSet& other : found_)
      if (is_within(*sizes, other.around)) return;
    found_.push_back({*sizes, around});
  }
  bool is_in_one_found(const Sizes<Bounded>& box) const {
    return std::any_of(found_.begin(), found_.end(), [&](const OneSet& one) { return is_within(box, one.around); });
  }
  // Across what the forces are the least certain of.
  void divide(Part part) {
    const auto matters = [&](std::size_t k) {
      double most = 0;
      for (std::size_t h = 0; h < hinges_.count(); ++h)
        most = std::max(most, k < hinges_.count() ? hinges_.by[h][k].size().sup() + (h == k ? 1 : 0)
                                                  : hinges_.without[h].size().sup() / scale_);
      const Bounded& x = k < hinges_.count() ? part.sizes[k] : part.loads;
      return most * (x.sup() - x.inf());
    };
    std::size_t widest = 0;
    for (std::size_t k = 1; k <= hinges_.count(); ++k)
      if (matters(k) > matters(widest)) widest = k;
    const auto of = [&](Part& some) -> Bounded& {
      return widest < hinges_.count() ? some.sizes[widest] : some.loads;
    };
    const Bounded whole = of(part), middle = midpoint(whole);
    of(part) = Bounded(whole.inf(), middle.sup());
    parts_.push_back(part);
    of(part) = Bounded(middle.inf(), whole.sup());
    parts_.push_back(std::move(part));
  }

  const RubbingHinges<Bounded>& hinges_;
  double scale_;
  std::vector<Part> parts_ = {};
  std::vector<OneSet> found_ = {};
};

// Where it is known that there is no other.
OneSet only_set(const RubbingHinges<Bounded>& hinges) {
  const std::size_t n = hinges.count();
  OneSet set = nothing_at_all(n);
  if (bear_nothing(hinges)) return set;
  constexpr int trials = 20;  // each with what the one before gives
  for (int i = 0; i < trials; ++i) {
    Sizes<Bounded> next;
    for (std::size_t h = 0; h < n; ++h) next.push_back(midpoint(hinges.force(h, set.sizes).size()));
    set.sizes = std::move(next);
  }
  const auto near = iterated(hinges, set.sizes, newton_steps);
  const auto box = near ? narrow_box(hinges, *near) : near;
  if (!box) throw not_settled();
  set.sizes = *box;
  return set;
}

}  // namespace

std::vector<OneSet> all_sets(const RubbingHinges<Bounded>& hinges) {
  const Arithmetic<Bounded> scope;
  if (is_contraction(hinges)) return {only_set(hinges)};
  return AllSets(hinges).all();
}

}  // namespace epure::geometry
