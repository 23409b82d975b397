// What is known of a scene's forces, by both routes and by the balance of powers, as it is written down.
#pragma once

#include <memory>
#include <string>

#include "exercises/scenes/forces/forces_found.h"
#include "exercises/scenes/forces/scene_forces.h"
#include "exercises/scenes/route_plan.h"

namespace epure::scenes {

struct ForceRoutes {
  std::shared_ptr<const Built> built;
  std::shared_ptr<const RoutePlan> plan;
  Loads frictionless = without_friction(*built);

  template <class T>
  using Complex = geometry::analytic::Complex<T>;

  // Polygons name those that are not along an axis as they are given, and steps how much friction there is.
  template <class T>
  void tell_directions(Ledger<T>& ledger) const {
    const auto& forces = built->loads->forces;
    for (std::size_t k = 0; k < forces.size(); ++k)
      if (!is_zero(forces[k].turned))
        ledger.tells({built->force_names[k].name + "_direction", "", "deg", {}},
                     [&, k] { return given_in_degrees<T>(forces[k].turned); });
    for (std::size_t k = 0; k < built->linkage.gears.size(); ++k)
      ledger.tells({tooth_force(*built, k).quantity.name + "_pressure_angle", "", "deg", {}},
                   [this, k] { return given_in_degrees<T>(built->linkage.gears[k].pressure_angle); });
    for (const LineFriction& each : built->loads->frictions) {
      const std::string name = name_of_contact(contact(*built, each)) + "_friction";
      if (const auto* angle = std::get_if<Angle>(&each.amount))
        ledger.tells({name, "", "deg", {}}, [angle] { return given_in_degrees<T>(*angle); });
      else
        ledger.tells({name, "", "1", {}}, [&each] { return each.coefficient<T>(); });
    }
    for (const HingeFriction& each : built->loads->hinge_frictions)
      ledger.tells({built->letters.points[index(each.point)] + "_friction", "", "m", {}},
                   [&each] { return from_rational<T>(each.radius); });
  }

  template <class T>
  void put_forces(Ledger<T>& ledger, const FoundForces<T>& forces) const {
    const JointForces<Fast> joints(built->linkage);
    const auto put_one = [&](const Quantity& quantity, const auto& select) {
      ledger.put(quantity, [&forces, select] { return forces.of(select); });
    };
    for (std::size_t k = 0; k < joints.hinges.size(); ++k) {
      const auto& [point, by, on, x_of_none, y_of_none, no_couple] = joints.hinges[k];
      const auto& [force, is_opposite] = hinge_force(*built, point, by, on);
      const auto x = [k, is = is_opposite](const JointForces<T>& f) { return is ? -f.hinges[k].x : f.hinges[k].x; };
      const auto y = [k, is = is_opposite](const JointForces<T>& f) { return is ? -f.hinges[k].y : f.hinges[k].y; };
      put_one(force.x(), x);
      put_one(force.y(), y);
      ledger.put(force.length(), [&forces, x, y] { return size(Vector<T>{forces.of(x), forces.of(y)}); });
      if (epure::scenes::has_friction(*built->loads, point))
        put_one(hinge_couple(*built, by, on), [k, is = is_opposite](const JointForces<T>& f) {
          return is ? -f.hinges[k].couple : f.hinges[k].couple;
        });
    }
    for (std::size_t k = 0; k < joints.pins.size(); ++k)
      put_one(pin_force(*built, k), [k](const JointForces<T>& f) { return f.pins[k]; });
    for (std::size_t k = 0; k < joints.guides.size(); ++k) {
      const GuideForces guide = guide_forces(*built, k);
      put_one(guide.force, [k](const JointForces<T>& f) { return f.guides[k].force; });
      put_one(guide.couple, [k](const JointForces<T>& f) { return f.guides[k].couple; });
    }
    for (std::size_t k = 0; k < joints.teeth.size(); ++k) {
      const TeethParts parts = parts_of_tooth_force(*built, k);
      ledger.put(parts.tangential, [&forces, k] {
        return magnitude_of<T>(forces.of([k](const JointForces<T>& f) { return f.teeth[k].tangential; }));
      });
      ledger.put(parts.radial, [&forces, k] { return magnitude_of<T>(forces.all().teeth[k].radial); });
    }
    for (const LineFriction& each : built->loads->frictions) {
      put_one(friction_force(*built, each), [each](const JointForces<T>& f) { return f.friction(each); });
      ledger.put(whole_contact_force(*built, each), [&forces, each] {
        return size(Vector<T>{forces.all().normal(each), forces.all().friction(each)});
      });
    }
    for (std::size_t k = 0; k < joints.drives.size(); ++k)
      put_one(driving_effort(*built, built->linkage.drives[k]), [k](const JointForces<T>& f) { return f.drives[k]; });
  }

  bool has_friction() const { return built->loads && built->loads->has_friction(); }

  template <class T>
  void put_frictionless(Ledger<T>& ledger, const FoundForces<T>& forces) const {
    for (std::size_t k = 0; has_friction() && k < built->linkage.drives.size(); ++k)
      ledger.put(frictionless_effort(*built, built->linkage.drives[k]),
                 [&forces, k] { return forces.of([k](const JointForces<T>& f) { return f.drives[k]; }); });
  }

  template <class T>
  FoundByRoute<T> found_by_groups(const Constructed<T>& constructed, const FoundForces<T>& forces) const {
    const auto own = [](const Own& at) { return Vector<T>{from_rational<T>(at.x), from_rational<T>(at.y)}; };
    const auto vector = [](const Point<T>& P) { return Vector<T>{P.x, P.y}; };
    const auto& at = constructed.at;
    return {.joints = [&forces]() -> const JointForces<T>& { return forces.all(); },
            .point = [&at, vector](int p) { return vector(at.points[index(p)]); },
            .on_link = [&at, vector, own](int link,
                                          const Own& there) { return vector(at.links[index(link)].at(own(there))); },
            .along =
                [&at, this](int line) {
                  return at.links[index(built->linkage.link_of_line(line))].turned(
                      linkages::unit_vector<T>(built->linkage.line(line).along));
                },
            .load = [](const LinkForce& load) { return ForcesByGroups<T>::vector(load); },
            .mass = [this, &constructed](std::size_t k) { return masses_in_motion(*built, constructed)[k]; }};
  }

  template <class T>
  FoundByRoute<T> found_by_equilibrium(const ByJoints<T>& by_joints, const FoundForces<T>& forces) const {
    const auto vector = [](const Complex<T>& z) { return Vector<T>{z.re, z.im}; };
    const auto on_link = [&by_joints, vector](int link, const Own& at) {
      return vector(analytic::point_of(by_joints.link(index(link), UpTo::place), at).z);
    };
    return {
        .joints = [&forces]() -> const JointForces<T>& { return forces.all(); },
        .point =
            [this, on_link](int p) {
              const int link = built->linkage.links_at(p).front();
              return on_link(link, built->linkage.place(link, p));
            },
        .on_link = on_link,
        .along =
            [this, &by_joints, vector](int line) {
              const int link = built->linkage.link_of_line(line);
              return vector(analytic::direction(built->linkage.line(line), by_joints.link(index(link), UpTo::place)));
            },
        .load =
            [vector](const LinkForce& load) {
              return vector(Complex<T>{from_rational<T>(load.components.x), from_rational<T>(load.components.y)} *
                            Complex<T>{cosine<T>(load.turned), sine<T>(load.turned)});
            },
        .mass =
            [this, &by_joints](std::size_t k) {
              const LinkMass& body = built->loads->masses[k];
              return analytic::in_motion(body, by_joints.link(index(body.link), UpTo::acceleration));
            }};
  }

  // Loads that are no plain givens, what holds pins alone, arms, and the two parts of a rod's force.
  template <class T, class PartOf>
  void put_acting(Ledger<T>& ledger, const ForcesFound<T>& found, const PartOf& part) const {
    for (std::size_t k = 0; k < built->force_names.size(); ++k)
      if (!built->force_names[k].is_given)
        put_vector(ledger, load_force(*built, k), [&found, k] { return found.load(k); });
    for (std::size_t k = 0; k < built->couple_names.size(); ++k)
      if (const LoadName& of = built->couple_names[k]; !of.is_given)
        ledger.put(Quantity{of.name, of.symbol, "N*m",
                            format_words("load on link {}, a couple", "carico sul membro {}, una coppia",
                                         built->letters.links[index(built->loads->couples[k].link)])},
                   from_rational<T>(built->loads->couples[k].moment));
    for (std::size_t k = 0; k < built->loads->masses.size(); ++k) {
      const ActingForce weight{ActingForce::Kind::weight, static_cast<int>(k), built->loads->masses[k].link},
          inertia{ActingForce::Kind::inertia, weight.which, weight.link};
      for (const ActingForce& force : {weight, inertia})
        if (force.kind == ActingForce::Kind::inertia || !built->gravity.empty())
          put_vector(ledger, mass_force(*built, force), [&found, force] { return found.vector(force); });
      if (!built->mass_names[k].inertia.empty() && !turns_steadily(*built, weight.link))
        ledger.put(inertia_couple(*built, k), [&found, weight] {
          return found.couple({ActingCouple::Kind::inertia, weight.which});
        });
    }
    for (std::size_t k = 0; k < built->linkage.gears.size(); ++k) {
      const VectorQuantity& quantity = tooth_force(*built, k).quantity;
      const ActingForce force = on_second_number(k);
      put_vector(ledger, quantity, [&found, force] { return found.vector(force); });
    }
    for (const ActingForce& held : held_pins())
      put_vector(ledger, held_force(*built, held.which), [&found, held] { return found.vector(held); });
    for (const GroupForces& group : plan->groups)
      for (const Moments& moments : group.moments) {
        for (const Arm& arm : moments.arms) put_arm(ledger, found, arm, moments.about);
        if (const auto* arm = std::get_if<Arm>(&moments.sought)) put_arm(ledger, found, *arm, moments.about);
        const auto* of_rod = std::get_if<AcrossRod>(&moments.sought);
        if (!of_rod) continue;
        for (const bool is_across : {true, false}) {
          const VectorQuantity quantity =
              part_of_force(*built, of_rod->force, is_across ? ForcePart::across : ForcePart::along);
          const auto find = [&part, &moments, is_across] { return part(moments, is_across); };
          ledger.put(quantity.length(), [find] { return size(find()); });
          ledger.draws_point(quantity.name, std::function<Point<T>()>([find] {
                               const Vector<T> v = find();
                               return Point<T>{v.x, v.y};
                             }));
        }
      }
  }

  // The teeth's force of the lower number on the other, as it is reported.
  ActingForce on_second_number(std::size_t gear) const {
    const MeshingLinks& of = built->linkage.gears[gear];
    return {ActingForce::Kind::tooth, static_cast<int>(gear),
            tooth_force(*built, gear).is_opposite ? of.first : of.second};
  }

  template <class T>
  static void put_arm(Ledger<T>& ledger, const ForcesFound<T>& found, const Arm& arm, const About& about) {
    ledger.put(arm.length, [&found, &arm, &about] { return found.arm(arm.force, about); });
  }

  std::vector<ActingForce> held_pins() const {
    std::vector<ActingForce> all;
    for (const GroupForces& group : plan->groups)
      for (const LinkForces& body : group.bodies)
        for (const ActingForce& force : body.sought)
          if (force.kind == ActingForce::Kind::held) all.push_back(force);
    return all;
  }

  template <class T>
  void draw_acting(Ledger<T>& ledger, const ForcesFound<T>& found) const {
    const auto draw = [&ledger](const std::string& name, const std::function<Vector<T>()>& find) {
      ledger.draws_point(name, std::function<Point<T>()>([find] {
                           const Vector<T> v = find();
                           return Point<T>{v.x, v.y};
                         }));
    };
    for (std::size_t k = 0; k < built->force_names.size(); ++k) {
      const ActingForce force{ActingForce::Kind::load, static_cast<int>(k), built->loads->forces[k].link};
      draw("load " + built->force_names[k].name, [&found, force] { return found.vector(force); });
      draw("place of " + built->force_names[k].name, [&found, force] { return found.place(force); });
    }
    for (std::size_t k = 0; k < built->loads->masses.size(); ++k) {
      const ActingForce inertia{ActingForce::Kind::inertia, static_cast<int>(k), built->loads->masses[k].link};
      draw("centre of " + std::to_string(built->letters.links[index(inertia.link)]),
           [&found, inertia] { return found.place(inertia); });
    }
    for (std::size_t k = 0; k < built->linkage.gears.size(); ++k)
      draw("place of " + tooth_force(*built, k).quantity.name,
           [&found, force = on_second_number(k)] { return found.place(force); });
    for (const LineOnLine& block : built->linkage.blocks)
      draw("through " + built->letters.lines[index(block.moving)],
           [&found, line = block.moving] { return found.through(line); });
  }

  template <class T>
  void by_power(Ledger<T>& ledger, const Constructed<T>& constructed) const {
    ledger.route("power balance");
    for (std::size_t k = 0; k < built->linkage.drives.size(); ++k)
      // What friction takes would be known of forces that are found already.
      ledger.put((has_friction() ? frictionless_effort : driving_effort)(*built, built->linkage.drives[k]),
                 [&] { return effort_by_power(*built, constructed, k); });
  }

 private:
  static Loads without_friction(const Built& built) {
    Loads loads = built.loads.value_or(Loads{});
    loads.frictions.clear();
    loads.hinge_frictions.clear();
    return loads;
  }
};

}  // namespace epure::scenes
