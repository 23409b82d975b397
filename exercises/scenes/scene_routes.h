// What is reported of a scene, by two routes: group after group with ruler and compass, and by the equations of all
// joints at once.
#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "exercises/kit/proof/ledger.h"
#include "exercises/scenes/scene.h"
#include "geometry/analytic/joint_equations.h"
#include "geometry/linkages/carried_out.h"

namespace epure::scenes {

// Where the links are, in doubles: for Newton's iteration to begin. Only near, so that it has something to do. Throws
// Undecided where doubles find no place: they prove nothing.
inline geometry::analytic::Beginning beginning(const Built& built) {
  const geometry::Arithmetic<geometry::Fast> scope;
  geometry::analytic::Beginning q;
  try {
    for (const auto& link : geometry::CarriedOut<geometry::Fast>(built.linkage, built.steps).position().links)
      for (const double x : {link.O.x, link.O.y, geometry::arc_tangent(link.x.y, link.x.x)})
        q.push_back(static_cast<double>(static_cast<float>(x)));
  } catch (const geometry::Impossible& in_doubles) {
    throw geometry::Undecided(in_doubles.words());
  }
  return q;
}

// What a computation gave, or how it failed: thrown anew by each quantity that asks.
template <class Result>
class OnceFor {
 public:
  explicit OnceFor(const std::function<Result()>& find) {
    try {
      result_ = find();
    } catch (const geometry::Undecided&) {
      failure_ = std::current_exception();
    } catch (const geometry::Impossible&) {
      failure_ = std::current_exception();
    }
  }
  const Result& get() const {
    if (failure_) std::rethrow_exception(failure_);
    return *result_;
  }

 private:
  std::optional<Result> result_;
  std::exception_ptr failure_;
};

struct SceneRoutes {
  std::shared_ptr<const Built> built;

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("construction");
    by_construction(ledger);
    ledger.route("joint equations");
    by_joint_equations(ledger);
    return ledger;
  }

 private:
  bool moves(int point) const { return built->linkage.links_at(point).front() != 0; }
  int link_with(int point) const { return built->linkage.links_at(point).front(); }
  const std::string& letter(int point) const { return built->letters.points[static_cast<std::size_t>(point)]; }

  // Calls `of_link(index, number)` for every moving link and `of_point(point, name)` for every point that moves.
  template <class OfLink, class OfPoint>
  void for_all(const OfLink& of_link, const OfPoint& of_point) const {
    for (int p = 0; p < built->linkage.count_of_points(); ++p)
      if (moves(p)) of_point(p, letter(p));
    for (std::size_t i = 1; i < built->linkage.links.size(); ++i) of_link(i, built->letters.links[i]);
  }

  // Signs alone: with one drive that turns steadily, a radian for each 2π, so that π stays out.
  template <class T>
  std::vector<geometry::DriveRates<T>> rates(const geometry::CarriedOut<T>& carried_out) const {
    if constexpr (signs_only<T>) {
      const auto& drives = built->linkage.drives;
      if (const auto* turned = drives.size() == 1 ? std::get_if<geometry::TurnedLink>(&drives[0]) : nullptr;
          turned && turned->omega.radians == 0 && is_zero(turned->alpha))
        return {{geometry::from_rational<T>(turned->omega.turns), T(0)}};
    }
    return carried_out.rates();
  }

  template <class T>
  void by_construction(Ledger<T>& ledger) const {
    using namespace geometry;
    const CarriedOut<T> carried_out(built->linkage, built->steps);
    const LinkagePosition<T> at = carried_out.position();
    const OnceFor<LinkageMotion<T>> motion([&] { return carried_out.motion(at, rates(carried_out)); });
    for (int p = 0; p < built->linkage.count_of_points(); ++p)
      if (!moves(p)) ledger.draws_point(letter(p), at.points[static_cast<std::size_t>(p)]);
    for_all(
        [&](std::size_t i, int number) {
          ledger.put(angular_velocity(number), [&motion, i] { return motion.get().links[i].omega; });
          ledger.put(angular_acceleration(number), [&motion, i] { return motion.get().links[i].alpha; });
          put_pole(ledger, number, [&motion, i] { return motion.get().links[i].pole(); });
        },
        [&](int point, const std::string& name) {
          const auto p = static_cast<std::size_t>(point);
          ledger.put(epure::point(name), at.points[p]);
          put(ledger, velocity(name), [&motion, p] { return motion.get().points[p].v; });
          put(ledger, acceleration(name), [&motion, p] { return motion.get().points[p].a; });
        });
  }

  template <class T>
  void by_joint_equations(Ledger<T>& ledger) const {
    using namespace geometry;
    const OnceFor<std::vector<analytic::LinkState<T>>> states([&] { return solved<T>(); });
    const auto state = [&](int point) {
      const int link = link_with(point);
      return analytic::point_of(states.get()[static_cast<std::size_t>(link)], built->linkage.place(link, point));
    };
    const auto as_vector = [](const analytic::Complex<T>& z) { return Vector<T>{z.re, z.im}; };
    for_all(
        [&](std::size_t i, int number) {
          ledger.put(angular_velocity(number), [&states, i] { return states.get()[i].omega; });
          ledger.put(angular_acceleration(number), [&states, i] { return states.get()[i].alpha; });
          // v + i ω (P - O) = 0.
          put_pole(ledger, number, [&states, i] {
            const analytic::LinkState<T>& link = states.get()[i];
            const analytic::Complex<T> P = link.omega * link.O + analytic::times_i(link.v);
            return ProjectivePoint<T>{P.re, P.im, link.omega};
          });
        },
        [&](int p, const std::string& name) {
          ledger.put(epure::point(name).x(), [&state, p] { return state(p).z.re; });
          ledger.put(epure::point(name).y(), [&state, p] { return state(p).z.im; });
          put(ledger, velocity(name), [&, p] { return as_vector(state(p).v); });
          put(ledger, acceleration(name), [&, p] { return as_vector(state(p).a); });
        });
  }

  template <class T>
  std::vector<geometry::analytic::LinkState<T>> solved() const {
    if constexpr (signs_only<T>) {
      return geometry::analytic::solve_joints<T>(built->linkage, {});
    } else {
      return geometry::analytic::solve_joints<T>(built->linkage, beginning(*built));
    }
  }

  // P₁ᵢ, the instant centre of link i on the frame.
  template <class T, class Find>
  static void put_pole(Ledger<T>& ledger, int number, const Find& find) {
    static constexpr Phrase at_infinity{"it is at infinity: the link does not turn",
                                        "è all'infinito: il membro non ruota"};
    const PointQuantity P1i = pole("P1" + std::to_string(number));
    ledger.put(P1i.x(), [find] {
      const auto P = find();
      return Ledger<T>::ratio(P.x, P.w, at_infinity);
    });
    ledger.put(P1i.y(), [find] {
      const auto P = find();
      return Ledger<T>::ratio(P.y, P.w, at_infinity);
    });
  }

  template <class T, class Find>
  static void put(Ledger<T>& ledger, const VectorQuantity& quantity, const Find& find) {
    ledger.put(quantity.x(), [find] { return find().x; });
    ledger.put(quantity.y(), [find] { return find().y; });
    ledger.put(quantity.length(), [find] { return size(find()); });
  }
};

}  // namespace epure::scenes
