// Where a scene's links are and how they move, on any number: placed group after group, and by the equations of all
// joints at once.
#pragma once

#include <exception>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "exercises/kit/proof/ledger.h"
#include "exercises/scenes/file/refusals.h"
#include "geometry/analytic/joint_equations.h"
#include "geometry/linkages/carried_out.h"

namespace epure::scenes {

using geometry::analytic::LinkState;
using geometry::analytic::UpTo;

// What a computation gives when it is first asked for, or how it fails: thrown anew for each quantity that asks.
template <class Result>
class WhenAsked {
 public:
  explicit WhenAsked(std::function<Result()> find) : find_(std::move(find)) {}
  const Result& get() const {
    if (failure_) std::rethrow_exception(failure_);
    if (result_) return *result_;
    try {
      result_ = find_();
    } catch (const geometry::Undecided&) {
      failure_ = std::current_exception();
      throw;
    } catch (const geometry::Impossible&) {
      failure_ = std::current_exception();
      throw;
    }
    return *result_;
  }

 private:
  std::function<Result()> find_;
  mutable std::optional<Result> result_ = {};
  mutable std::exception_ptr failure_ = {};
};

// Signs alone: a radian for each 2π, so that π stays out.
template <class T>
std::vector<geometry::DriveRates<T>> rates(const geometry::Linkage& linkage,
                                           const geometry::CarriedOut<T>& carried_out) {
  if (!signs_only<T> || !linkage.is_turned_steadily()) return carried_out.rates();
  return {{geometry::from_rational<T>(std::get<geometry::TurnedLink>(linkage.drives[0]).omega.turns), T(0)}};
}

// All in the origin.
template <class T>
geometry::LinkagePosition<T> no_position(const geometry::Linkage& linkage) {
  const geometry::Point<T> O{T(0), T(0)};
  return {std::vector(linkage.links.size(), geometry::PlacedLink<T>{O, {T(1), T(0)}}),
          std::vector(static_cast<std::size_t>(linkage.count_of_points()), O)};
}

// Group after group. Names ask for no place: doubles do not always find one where it exists.
template <class T>
struct Constructed {
  explicit Constructed(const Built& built)
      : carried_out(built.linkage, built.steps),
        at(NamesOnly::holds() ? no_position<T>(built.linkage) : carried_out.position()),
        motion([this, &built] {
          try {
            return carried_out.motion(at, rates(built.linkage, carried_out));
          } catch (const geometry::NotClosed& at_limit) {
            throw geometry::Impossible(in_words_at_limit(at_limit, built));
          }
        }) {}
  Constructed(const Constructed&) = delete;
  Constructed& operator=(const Constructed&) = delete;

  // As the equations of the joints have it; without the angles.
  std::vector<LinkState<T>> states(bool with_rates) const {
    const auto complex = [](const geometry::Vector<T>& v) { return geometry::analytic::Complex<T>{v.x, v.y}; };
    std::vector<LinkState<T>> all;
    for (std::size_t i = 0; i < at.links.size(); ++i) {
      const geometry::Point<T>& O = at.links[i].O;
      LinkState<T> link{{O.x, O.y}, {}, {}, T(0), T(0), T(0), complex(at.links[i].x)};
      if (with_rates) {
        const geometry::PlaneMotion<T>& moving = motion.get().links[i];
        link.v = complex(moving.velocity(O));
        link.a = complex(moving.acceleration(O));
        link.omega = moving.omega;
        link.alpha = moving.alpha;
      }
      all.push_back(std::move(link));
    }
    return all;
  }

  geometry::CarriedOut<T> carried_out;
  geometry::LinkagePosition<T> at;
  WhenAsked<geometry::LinkageMotion<T>> motion;
};

// What turns wheels have made.
template <class T>
void add_turns_of_wheels(const Built& built, geometry::analytic::Beginning<T>& links) {
  for (const geometry::Step& step : built.steps)
    if (const auto* wheel = std::get_if<geometry::GearedWheel>(&step))
      links[index(wheel->link)].theta = geometry::radians<T>(angle_of(wheel->turn, built.linkage));
}
// Where the links are, and these turns.
template <class T>
geometry::analytic::Beginning<T> beginning(const Built& built, const Constructed<T>& constructed) {
  geometry::analytic::Beginning<T> links = constructed.states(false);
  add_turns_of_wheels(built, links);
  return links;
}

// The equations of all joints, solved.
template <class T, bool has_signs_only = signs_only<T>>
class ByJoints {
 public:
  ByJoints(const Built& built, const Constructed<T>& constructed)
      : states_([&] { return geometry::analytic::solve_joints<T>(built.linkage, beginning(built, constructed)); }) {}
  const std::vector<LinkState<T>>& states(UpTo) const { return states_.get(); }
  const LinkState<T>& link(std::size_t i, UpTo order) const { return states(order)[i]; }

 private:
  WhenAsked<std::vector<LinkState<T>>> states_;
};

// On exact numbers: what was constructed, put into them, as far as is asked for: of one link into those of the links
// that it hangs on, as those of others may be beyond these numbers.
template <class T>
class ByJoints<T, true> {
 public:
  ByJoints(const Built& built, const Constructed<T>& constructed)
      : built_(built), constructed_(constructed), groups_(one_after_another(built)) {
    for (std::size_t k = 0; k < groups_.size(); ++k) {
      std::vector<Held>& held = held_.emplace_back();
      for (const UpTo order : {UpTo::place, UpTo::velocity, UpTo::acceleration})
        held.emplace_back([this, k, order] { return holds(k, order); });
    }
  }
  ByJoints(const ByJoints&) = delete;
  ByJoints& operator=(const ByJoints&) = delete;

  const LinkState<T>& link(std::size_t i, UpTo order) const {
    independent_.get();
    demand(i, order);
    return found(order)[i];
  }
  const std::vector<LinkState<T>>& states(UpTo order) const {
    independent_.get();
    for (std::size_t i = 1; i < built_.linkage.links.size(); ++i) demand(i, order);
    return found(order);
  }

 private:
  using States = std::vector<LinkState<T>>;
  using Held = WhenAsked<bool>;

  static std::vector<geometry::analytic::Hanging> one_after_another(const Built& built) {
    std::vector<std::vector<int>> order;
    for (const geometry::Step& step : built.steps) order.push_back(geometry::placed_by(step));
    return geometry::analytic::one_after_another(built.linkage, order);
  }
  void demand(std::size_t i, UpTo order) const {
    for (std::size_t k = 0; k < groups_.size(); ++k)
      if (groups_[k].is_placed[i]) held_[k][static_cast<std::size_t>(order)].get();
  }
  bool holds(std::size_t k, UpTo order) const {
    if (order != UpTo::place) held_[k][static_cast<std::size_t>(order) - 1].get();
    for (const int link : groups_[k].on) demand(index(link), order);
    geometry::analytic::demand_joints(built_.linkage, found(order), order, groups_[k]);
    return true;
  }
  const States& found(UpTo order) const { return order == UpTo::place ? place_.get() : moving_.get(); }
  // Near a dead centre only many bits can tell.
  bool are_independent(long bits) const {
    constexpr long most_bits = 4096;
    try {
      const geometry::Arithmetic<geometry::Deep> scope(bits);
      geometry::analytic::demand_independent(built_.linkage, Constructed<geometry::Deep>(built_).states(false));
      return true;
    } catch (const geometry::Undecided&) {
      if (bits >= most_bits) throw;
      return are_independent(4 * bits);
    }
  }

  const Built& built_;
  const Constructed<T>& constructed_;
  std::vector<geometry::analytic::Hanging> groups_;
  std::vector<std::vector<Held>> held_;  // of each of these, up to each order
  Held independent_{[this] { return are_independent(256); }};
  WhenAsked<States> place_{[this] { return constructed_.states(false); }};
  WhenAsked<States> moving_{[this] { return constructed_.states(true); }};
};

}  // namespace epure::scenes
