// Where a scene's links are and how they move, on any number: placed group after group, and by the equations of all
// joints at once.
#pragma once

#include <exception>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "exercises/kit/proof/ledger.h"
#include "exercises/scenes/refusals.h"
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

// Group after group.
template <class T>
struct Constructed {
  explicit Constructed(const Built& built)
      : carried_out(built.linkage, built.steps), at(carried_out.position()), motion([this, &built] {
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
      const auto& [O, x] = at.links[i];
      LinkState<T> link{{O.x, O.y}, {}, {}, T(0), T(0), T(0), complex(x)};
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

// Where the links are, and what turns wheels have made.
template <class T>
geometry::analytic::Beginning<T> beginning(const Built& built, const Constructed<T>& constructed) {
  geometry::analytic::Beginning<T> links = constructed.states(false);
  for (const geometry::Step& step : built.steps)
    if (const auto* wheel = std::get_if<geometry::GearedWheel>(&step))
      links[index(wheel->link)].theta = geometry::radians<T>(angle_of(wheel->turn, built.linkage));
  return links;
}

// The equations of all joints, solved.
template <class T, bool has_signs_only = signs_only<T>>
class ByJoints {
 public:
  ByJoints(const Built& built, const Constructed<T>& constructed)
      : states_([&] { return geometry::analytic::solve_joints<T>(built.linkage, beginning(built, constructed)); }) {}
  const std::vector<LinkState<T>>& states(UpTo) const { return states_.get(); }

 private:
  WhenAsked<std::vector<LinkState<T>>> states_;
};

// On exact numbers: what was constructed, put into them, as far as is asked for.
template <class T>
class ByJoints<T, true> {
 public:
  ByJoints(const Built& built, const Constructed<T>& constructed) : built_(built), constructed_(constructed) {}

  const std::vector<LinkState<T>>& states(UpTo order) const {
    if (order == UpTo::place) return place_.get();
    return order == UpTo::velocity ? velocity_.get() : acceleration_.get();
  }

 private:
  using States = std::vector<LinkState<T>>;
  States holding(States states, UpTo order) const {
    geometry::analytic::demand_joints(built_.linkage, states, order);
    return states;
  }
  States at_independent_place() const {
    States states = holding(constructed_.states(false), UpTo::place);
    demand_independent(256);
    return states;
  }
  // Near a dead centre only many bits can tell.
  void demand_independent(long bits) const {
    constexpr long most_bits = 4096;
    try {
      const geometry::Arithmetic<geometry::Deep> scope(bits);
      geometry::analytic::demand_independent(built_.linkage, Constructed<geometry::Deep>(built_).states(false));
    } catch (const geometry::Undecided&) {
      if (bits >= most_bits) throw;
      demand_independent(4 * bits);
    }
  }
  States moving() const {
    place_.get();
    return holding(constructed_.states(true), UpTo::velocity);
  }

  const Built& built_;
  const Constructed<T>& constructed_;
  WhenAsked<States> place_{[this] { return at_independent_place(); }};
  WhenAsked<States> velocity_{[this] { return moving(); }};
  WhenAsked<States> acceleration_{[this] { return holding(velocity_.get(), UpTo::acceleration); }};
};

}  // namespace epure::scenes
