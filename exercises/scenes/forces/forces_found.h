// The forces on the links of a scene as vectors where they act, by either route: of the joint forces that it found,
// and the places that it found them at.
#pragma once

#include <functional>
#include <vector>

#include "exercises/scenes/forces/force_groups.h"
#include "exercises/scenes/forces/force_names.h"
#include "exercises/scenes/forces/scene_forces.h"

namespace epure::scenes {

// What a route says of places and joint forces.
template <class T>
struct FoundByRoute {
  std::function<const JointForces<T>&()> joints;
  std::function<geometry::Vector<T>(int)> point;                          // of the plane
  std::function<geometry::Vector<T>(int, const geometry::Own&)> on_link;  // the same, by its place on a link
  std::function<geometry::Vector<T>(int)> along;                          // a line's unit vector
  std::function<geometry::Vector<T>(const LinkForce&)> load;
  std::function<geometry::MassInMotion<T>(std::size_t)> mass;
};

template <class T>
class ForcesFound {
 public:
  using Vector = geometry::Vector<T>;
  ForcesFound(const Built& built, FoundByRoute<T> found) : built_(built), found_(std::move(found)) {}

  // On its link.
  Vector vector(const ActingForce& force) const {
    const Vector v = as_reported(force);
    return is_reversed(built_, force) ? -v : v;
  }
  Vector place(const ActingForce& force) const {
    const auto k = index(force.which);
    if (force.kind == ActingForce::Kind::load) {
      const LinkForce& load = built_.loads->forces[k];
      return found_.on_link(load.link, load.at);
    }
    if (is_of_mass(force)) return found_.on_link(built_.loads->masses[k].link, built_.loads->masses[k].at);
    if (force.kind == ActingForce::Kind::guide) return through(of().blocks[k].moving);
    if (force.kind == ActingForce::Kind::tooth)
      return found_.on_link(of().gears[k].carrier, of().pitch_point(of().gears[k]));
    return found_.point(force.point);
  }
  Vector through(int line) const { return found_.on_link(of().link_of_line(line), of().line(line).through); }
  Vector place(const About& about) const {
    return about.point != geometry::nothing ? found_.point(about.point) : through(about.line);
  }
  Vector load(std::size_t k) const { return found_.load(built_.loads->forces[k]); }

  T moment(const ActingForce& force, const About& about) const {
    return cross(place(force) - place(about), vector(force));
  }
  T couple(const ActingCouple& couple) const {
    const T value = couple_as_reported(couple);
    return couple.is_opposite ? -value : value;
  }
  // How far the line of a force passes by a point; of signs, its square.
  T arm(const ActingForce& force, const About& about) const {
    const Phrase none{"the force is zero: it has no line of action", "la forza è nulla: non ha retta d'azione"};
    const Vector F = vector(force);
    return Ledger<T>::ratio(magnitude_of(moment(force, about)), size(F), none);
  }

  // The part of a rod's force across it and along it: as they lie in it ...
  Vector part(const AcrossRod& of_rod, bool is_across) const {
    const Vector rod = found_.point(of_rod.joint) - found_.point(of_rod.pin), F = vector(of_rod.force);
    const T over = quotient(T(1), length_squared(rod));
    if (is_across) return (over * cross(rod, F)) * quarter_turn(rod);
    return (over * dot(rod, F)) * rod;
  }
  // ... and that across as the moments of all else give it.
  Vector across_by_moments(const Moments& moments) const {
    const auto& of_rod = std::get<AcrossRod>(moments.sought);
    found_.joints();  // all in one measure
    T sum(0);
    for (const Arm& arm : moments.arms) sum += moment(arm.force, moments.about);
    for (const ActingCouple& each : moments.couples) sum += couple(each);
    const Vector rod = found_.point(of_rod.joint) - found_.point(of_rod.pin);
    return quotient(sum, length_squared(rod)) * quarter_turn(rod);
  }

 private:
  T couple_as_reported(const ActingCouple& couple) const {
    const auto k = index(couple.which);
    switch (couple.kind) {
      case ActingCouple::Kind::load:
        return geometry::from_rational<T>(built_.loads->couples[k].moment);
      case ActingCouple::Kind::inertia:
        return -(geometry::from_rational<T>(built_.loads->masses[k].inertia) * found_.mass(k).alpha);
      case ActingCouple::Kind::guide:
        return found_.joints().guides[k].couple;
      case ActingCouple::Kind::hinge: {
        const auto& hinge = found_.joints().hinges[k];
        return built_.letters.links[index(hinge.by)] < built_.letters.links[index(hinge.on)] ? hinge.couple
                                                                                             : -hinge.couple;
      }
      case ActingCouple::Kind::drive:
        break;
    }
    return found_.joints().drives[k];
  }
  const geometry::Linkage& of() const { return built_.linkage; }
  // Of length one, from the first wheel to the second.
  Vector line_of_centres(const geometry::MeshingLinks& gear) const {
    const geometry::Own r = of().line_of_centres(gear);
    const T length = root(geometry::from_rational<T>(r.x * r.x + r.y * r.y));
    return quotient(T(1), length) * (found_.point(of().hinge_of(gear.second, gear.carrier)) -
                                     found_.point(of().hinge_of(gear.first, gear.carrier)));
  }
  Vector of_line(int line, const T& normal, const T& friction) const {
    const Vector along = found_.along(line);
    return normal * quarter_turn(along) + friction * along;
  }

  Vector as_reported(const ActingForce& force) const {
    using Kind = ActingForce::Kind;
    const auto k = index(force.which);
    switch (force.kind) {
      case Kind::load:
        return load(k);
      case Kind::weight: {
        const geometry::LinkMass& body = built_.loads->masses[k];
        return geometry::ForcesByGroups<T>::weight(body, built_.loads->gravity);
      }
      case Kind::inertia: {
        const T m = geometry::from_rational<T>(built_.loads->masses[k].mass);
        const geometry::MassInMotion<T> moving = found_.mass(k);
        return {-(m * moving.a_x), -(m * moving.a_y)};
      }
      case Kind::hinge: {
        const auto& hinge = found_.joints().hinges[k];
        const Vector on{hinge.x, hinge.y};
        return built_.letters.links[index(hinge.by)] < built_.letters.links[index(hinge.on)] ? on : -on;
      }
      case Kind::tooth: {
        const auto& tooth = found_.joints().teeth[k];
        const Vector apart = line_of_centres(of().gears[k]),
                     on = tooth.tangential * quarter_turn(apart) + tooth.radial * apart;
        return tooth_force(built_, k).is_opposite ? -on : on;
      }
      case Kind::pin:
        return of_line(of().pins[k].line, found_.joints().pins[k], found_.joints().pin_frictions[k]);
      case Kind::guide:
        return of_line(of().blocks[k].guide, found_.joints().guides[k].force, found_.joints().guides[k].friction);
      case Kind::slid:
        return found_.joints().drives[k] * found_.along(std::get<SlidPoint>(of().drives[k]).guide);
      case Kind::cylinder: {
        const auto& cylinder = std::get<Stretched>(of().drives[k]);
        return quotient(found_.joints().drives[k], geometry::from_rational<T>(cylinder.length)) *
               (found_.point(cylinder.to) - found_.point(cylinder.from));
      }
      case Kind::held:
        break;
    }
    Vector sum{T(0), T(0)};
    for (const ActingForce& each : forces_that_hold(built_, force.which)) sum = sum + vector(each);
    return sum;
  }

  const Built& built_;
  FoundByRoute<T> found_;
};

}  // namespace epure::scenes
