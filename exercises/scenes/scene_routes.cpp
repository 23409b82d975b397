#include "exercises/scenes/scene_routes.h"

#include <algorithm>
#include <string>

#include "exercises/kit/linkages/angles.h"
#include "exercises/kit/linkages/coupler_routes.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/scenes/file/greek.h"
#include "exercises/scenes/forces/forces_found.h"
#include "exercises/scenes/forces/scene_forces.h"
#include "exercises/scenes/links_alike.h"
#include "exercises/scenes/relative_motion.h"

namespace epure::scenes {
namespace {

using namespace geometry;
using analytic::Complex;

Loads without_friction(const Built& built) {
  Loads loads = built.loads.value_or(Loads{});
  loads.frictions.clear();
  loads.hinge_frictions.clear();
  return loads;
}

}  // namespace

struct RoutePlan {
  explicit RoutePlan(const Built& built)
      : vectors(relative_vectors(dyad_equations(built))),
        centres(centre_plan_of(built)),
        alike(built),
        floating(links_without_pivot(built)),
        groups(force_groups(built)) {}

  std::vector<Term> vectors;
  CentrePlan centres;
  LinksAlike alike;
  std::vector<std::size_t> floating;
  std::vector<GroupForces> groups;
};

namespace {

struct SceneRoutes {
  std::shared_ptr<const Built> built;
  std::shared_ptr<const RoutePlan> plan;
  Loads frictionless = without_friction(*built);

  template <class T>
  Ledger<T> operator()() const {
    Ledger<T> ledger("construction");
    const Constructed<T> constructed(*built);
    by_construction(ledger, constructed);
    if (ledger.knows_all_asked()) return ledger;
    ledger.route("joint equations");
    const ByJoints<T> by_joints(*built, constructed);
    by_joint_equations(ledger, constructed, by_joints);
    ledger.route("instant centres");
    by_centres(ledger, constructed);
    if (built->loads) by_power(ledger, constructed);
    return ledger;
  }

 private:
  bool moves(int point) const { return built->linkage.links_at(point).front() != 0; }
  int link_with(int point) const { return built->linkage.links_at(point).front(); }
  const std::string& letter(int point) const { return built->letters.points[index(point)]; }
  // The hinge of the frame about which a link turns that has the point; or nothing. The centre of its path: to prove
  // of what is calculated from the motion that it is this hinge would take minutes at the end of a long chain.
  int turned_about(int point) const {
    for (const int link : built->linkage.links_at(point))
      if (const int O = built->linkage.hinge_of(0, link); O != nothing) return O;
    return nothing;
  }

  // Calls `of_link(index, number)` for every moving link and `of_point(point, name)` for every point that moves.
  template <class OfLink, class OfPoint>
  void for_all(const OfLink& of_link, const OfPoint& of_point) const {
    for (int p = 0; p < built->linkage.count_of_points(); ++p)
      if (moves(p)) of_point(p, letter(p));
    for (std::size_t i = 1; i < built->linkage.links.size(); ++i) of_link(i, built->letters.links[i]);
  }

  template <class T>
  void by_construction(Ledger<T>& ledger, const Constructed<T>& constructed) const {
    const auto& at = constructed.at;
    const auto& motion = constructed.motion;
    for (int p = 0; p < built->linkage.count_of_points(); ++p)
      if (!moves(p)) ledger.draws_point(letter(p), at.points[index(p)]);
    for_all(
        [&](std::size_t i, int number) {
          ledger.put(link_angle(number), [&at, i] { return in_degrees(angle_of_axis(at.links[i].axis())); });
          ledger.put(angular_velocity(number), [&motion, i] { return motion.get().links[i].omega; });
          ledger.put(angular_acceleration(number), [&motion, i] { return motion.get().links[i].alpha; });
        },
        [&](int point, const std::string& name) {
          const auto p = index(point);
          ledger.put(epure::point(name), at.points[p]);
          put(ledger, velocity(name), [&motion, p] { return motion.get().points[p].v; });
          put(ledger, acceleration(name), [&motion, p] { return motion.get().points[p].a; });
        });
    put_vectors(ledger, VectorsConstructed<T>(*built, constructed));
    for (const PointOffset& offset : built->offsets)
      ledger.put(described(offset), constructed.carried_out.left_in_plane(offset.line, offset.point, at));
    put_centres(
        ledger, [&](int point) { return projective(at.points[index(point)]); },
        [&](std::size_t i, std::size_t j) {
          const PlaneMotion<T>&a = motion.get().links[i], &b = motion.get().links[j];
          return at_rest_against(a.omega - b.omega, of_origin(a) - of_origin(b));
        });
    if (built->loads) {
      const auto find = [&](const Loads& loads, bool with_inertia) {
        return forces_by_groups(*built, constructed, loads, with_inertia);
      };
      const FoundForces<T> forces(*built, *built->loads, find);
      put_forces<T>(ledger, forces);
      put_frictionless<T>(ledger, {*built, frictionless, find});
      tell_directions(ledger);
      const ForcesFound<T> found(*built, found_by_groups(constructed, forces));
      put_acting(ledger, found, [&](const Moments& moments, bool is_across) {
        return is_across ? found.across_by_moments(moments) : found.part(std::get<AcrossRod>(moments.sought), false);
      });
      draw_acting(ledger, found);
    }
    for (const std::size_t i : plan->floating)
      put_projective(ledger, acceleration_centre(built->letters.links[i]), no_acceleration_centre(i),
                     [&motion, i] { return motion.get().links[i].acceleration_pole(); });
    for (const int P : built->paths) put_curvature(ledger, P, constructed);
    for (int l = 0; l < built->linkage.count_of_lines(); ++l)
      ledger.draws_vector("along_" + built->letters.lines[index(l)],
                          at.links[index(built->linkage.link_of_line(l))].turned(
                              linkages::unit_vector<T>(built->linkage.line(l).along)));
  }

  template <class T>
  void by_joint_equations(Ledger<T>& ledger, const Constructed<T>& constructed, const ByJoints<T>& by_joints) const {
    if (built->loads) {
      const auto find = [&](const Loads& loads, bool with_inertia) {
        return forces_by_equilibrium(*built, constructed, by_joints, loads, with_inertia);
      };
      const FoundForces<T> forces(*built, *built->loads, find);
      put_forces<T>(ledger, forces);
      put_frictionless<T>(ledger, {*built, frictionless, find});
      const ForcesFound<T> found(*built, found_by_equilibrium(by_joints, forces));
      put_acting(ledger, found, [&](const Moments& moments, bool is_across) {
        return found.part(std::get<AcrossRod>(moments.sought), is_across);
      });
    }
    const auto link = [&](std::size_t i, UpTo order) -> const LinkState<T>& { return by_joints.link(i, order); };
    const auto state = [&](int point, UpTo order) {
      const int on = link_with(point);
      return analytic::point_of(link(index(on), order), built->linkage.place(on, point));
    };
    const auto as_vector = [](const Complex<T>& z) { return Vector<T>{z.re, z.im}; };
    for_all(
        [&](std::size_t i, int number) {
          ledger.put(link_angle(number),
                     [&, i] { return part_of_turn_in_degrees(angle_of_axis(as_vector(link(i, UpTo::place).x))); });
          ledger.put(angular_velocity(number), [&, i] { return link(i, UpTo::velocity).omega; });
          ledger.put(angular_acceleration(number), [&, i] { return link(i, UpTo::acceleration).alpha; });
        },
        [&](int p, const std::string& name) {
          ledger.put(epure::point(name).x(), [&, p] { return state(p, UpTo::place).z.re; });
          ledger.put(epure::point(name).y(), [&, p] { return state(p, UpTo::place).z.im; });
          put(ledger, velocity(name), [&, p] { return as_vector(state(p, UpTo::velocity).v); });
          put(ledger, acceleration(name), [&, p] { return as_vector(state(p, UpTo::acceleration).a); });
        });
    put_vectors(ledger, VectorsByJoints<T>(*built, by_joints));
    for (const PointOffset& offset : built->offsets)
      ledger.put(described(offset), [&] {
        const LinkLine& line = built->linkage.line(offset.line);
        const auto on = index(built->linkage.link_of_line(offset.line));
        const Complex<T> G = analytic::point_of(link(on, UpTo::place), line.through).z;
        return cross(analytic::direction(line, link(on, UpTo::place)), state(offset.point, UpTo::place).z - G);
      });
    const auto body = [&](std::size_t i) {
      const LinkState<T>& moving = link(i, UpTo::acceleration);
      return analytic::PlaneMotion<T>{moving.O, moving.v, moving.a, moving.omega, moving.alpha};
    };
    for (const std::size_t i : plan->floating)
      put_point<T>(ledger, acceleration_centre(built->letters.links[i]), [&, i] {
        const auto K = body(i).acceleration_pole();
        if (!K) throw Impossible(no_acceleration_centre(i));
        return *K;
      });
    for (const int P : built->paths) {
      const auto centre = [&, P] {
        // Whether it has any; of a point that turns about a hinge of the frame that is the place.
        const Complex<T> by_motion =
            present(body(index(link_with(P))).centre_of_curvature(state(P, UpTo::place).z), no_curvature);
        const int O = turned_about(P);
        return O == nothing ? by_motion : state(O, UpTo::place).z;
      };
      put_point<T>(ledger, centre_of_curvature(letter(P)), centre);
      put_length<T>(ledger, radius_of_curvature(letter(P)), [&, P] { return centre() - state(P, UpTo::place).z; });
    }
    put_centres(
        ledger,
        [&](int point) {
          const Complex<T> z = state(point, UpTo::place).z;
          return ProjectivePoint<T>{z.re, z.im, T(1)};
        },
        [&](std::size_t i, std::size_t j) {
          // v + i ω (P - O) = 0 of the difference.
          const LinkState<T>&a = link(i, UpTo::velocity), &b = link(j, UpTo::velocity);
          const Complex<T> P = a.omega * a.O - b.omega * b.O + analytic::times_i(a.v - b.v);
          return ProjectivePoint<T>{P.re, P.im, a.omega - b.omega};
        });
  }

  // In (-π, π]; a direction that so many bits do not tell from -x is π. (Givens of 40 digits that miss it do so by
  // far more; fewer bits would call π what more find beside -π.)
  template <class T>
  static T angle_of_axis(const Vector<T>& x) {
    if constexpr (std::is_same_v<T, Deep>) {
      constexpr long enough = 512;
      if (Arithmetic<Deep>::bits() >= enough && sign(x.y) == Sign::undecided && sign(x.x) == Sign::negative)
        return pi<T>() + arc_tangent(T(-x.y), T(-x.x));
    }
    return angle_of(x);
  }

  // P_ij of all links by their lines, as they are drawn; it is a centre only of links that move against each other.
  template <class T>
  void by_centres(Ledger<T>& ledger, const Constructed<T>& constructed) const {
    const WhenAsked<Centres<T>> centres([&] { return Centres<T>(plan->centres, built->linkage, constructed.at); });
    const auto put = [&](int of, int against) {
      const auto i = index(of), j = index(against);
      put_centre(ledger, i, j, [&, i, j, of, against] {
        const auto &a = constructed.motion.get().links[i], &b = constructed.motion.get().links[j];
        demand_motion(i, j, at_rest_against(a.omega - b.omega, of_origin(a) - of_origin(b)));
        return centres.get().of(of, against);
      });
    };
    for (const PermanentCentre& centre : plan->centres.permanent)
      if (centre.is_of_touching()) put(centre.i, centre.j);
    for (const FoundCentre& centre : plan->centres.found) put(centre.i, centre.j);
  }

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
      ledger.tells({letter(each.point) + "_friction", "", "m", {}},
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

  // --- what sheets of forces show beside --------------------------------------------------------------------------
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
              const int link = link_with(p);
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
      if (!built->force_names[k].is_given) put(ledger, load_force(*built, k), [&found, k] { return found.load(k); });
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
          put(ledger, mass_force(*built, force), [&found, force] { return found.vector(force); });
      if (!built->mass_names[k].inertia.empty() && !turns_steadily(*built, weight.link))
        ledger.put(inertia_couple(*built, k), [&found, weight] {
          return found.couple({ActingCouple::Kind::inertia, weight.which});
        });
    }
    for (std::size_t k = 0; k < built->linkage.gears.size(); ++k) {
      const VectorQuantity& quantity = tooth_force(*built, k).quantity;
      const ActingForce force = on_second_number(k);
      put(ledger, quantity, [&found, force] { return found.vector(force); });
    }
    for (const ActingForce& held : held_pins())
      put(ledger, held_force(*built, held.which), [&found, held] { return found.vector(held); });
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

  Words no_acceleration_centre(std::size_t i) const {
    return format_words("it is at infinity: link {} neither turns nor begins to",
                        "è all'infinito: il membro {} non ruota, né comincia a farlo", built->letters.links[i]);
  }

  // Ω of the path of P, by the pole of a link that carries it, and its distance from P.
  template <class T>
  void put_curvature(Ledger<T>& ledger, int P, const Constructed<T>& constructed) const {
    const auto& at = constructed.at.points[index(P)];
    const auto centre = [&, P] {
      const PlaneMotion<T>& body = constructed.motion.get().links[index(link_with(P))];
      const Sign moves = sign(length_squared(body.velocity(at)));
      if (moves == Sign::zero)
        throw Impossible("the point is at rest: its path has no curvature there",
                         "il punto è fermo: lì la sua traiettoria non ha curvatura");
      const int O = turned_about(P);
      if (O == nothing) return body.centre_of_curvature(at);
      if (moves == Sign::undecided) throw Undecided("whether the point is at rest", "se il punto sia fermo");
      return projective(constructed.at.points[index(O)]);
    };
    put_projective(ledger, centre_of_curvature(letter(P)), Words(no_curvature), centre);
    ledger.put(radius_of_curvature(letter(P)), [&] {
      const ProjectivePoint<T> found = centre();
      const Vector<T> far{found.x - at.x * found.w, found.y - at.y * found.w};
      if constexpr (signs_only<T>)
        return Ledger<T>::ratio(size(far), square(found.w), no_curvature);
      else
        return Ledger<T>::ratio(size(far), absolute(found.w), no_curvature);
    });
  }
  // Each coordinate looks for it anew.
  template <class T, class Find>
  static void put_projective(Ledger<T>& ledger, const PointQuantity& quantity, const Words& at_infinity,
                             const Find& find) {
    const auto over_w = [&](const T& of_P, const T& w) {
      const Sign decided = sign(w);
      if (decided == Sign::zero) throw Impossible(at_infinity);
      if (decided == Sign::undecided) throw Undecided(Words{"whether ", "se "} + at_infinity);
      return quotient(of_P, w);
    };
    ledger.put(quantity.x(), [&] {
      const ProjectivePoint<T> P = find();
      return over_w(P.x, P.w);
    });
    ledger.put(quantity.y(), [&] {
      const ProjectivePoint<T> P = find();
      return over_w(P.y, P.w);
    });
  }

  Quantity described(const PointOffset& offset) const {
    const std::string &P = letter(offset.point), &g = built->letters.lines[index(offset.line)];
    return {offset.name, given_letters(offset.name), "m",
            format_words("offset of {} from {}, to its left", "scostamento di {} da {}, a sinistra", P, g)};
  }

  // The velocity of the body's point in the origin of the plane.
  template <class T>
  static Vector<T> of_origin(const PlaneMotion<T>& body) {
    return body.velocity({T(0), T(0)});
  }
  // P with c + ω k x P = 0.
  template <class T>
  static ProjectivePoint<T> at_rest_against(const T& omega, const Vector<T>& c) {
    const Vector<T> n = quarter_turn(c);
    return {n.x, n.y, omega};
  }

  // Of vectors that polygons show beside those of points the length is reported.
  template <class T, class Find>
  void put_vectors(Ledger<T>& ledger, const Find& find) const {
    for (const Term& term : plan->vectors) {
      const VectorSource& source = *term.source;
      ledger.put(term.quantity.length(), [&] { return size(find(source)); });
      ledger.draws_point(term.quantity.name, std::function<Point<T>()>([&] {
                           const Vector<T> v = find(source);
                           return Point<T>{v.x, v.y};
                         }));
    }
  }

  // Of all pairs of links: what a joint gives, or what `find` finds of the two.
  template <class T, class OfPoint, class Find>
  void put_centres(Ledger<T>& ledger, const OfPoint& of_point, const Find& find) const {
    const std::size_t count = built->linkage.links.size();
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = i + 1; j < count; ++j) {
        const PermanentCentre* joint = plan->centres.permanent_of(static_cast<int>(i), static_cast<int>(j));
        if (!joint || joint->is_of_touching())
          put_centre(ledger, i, j, [&, i, j] { return find(i, j); });
        else if (joint->point != nothing)
          put_centre(ledger, i, j, [&] { return of_point(joint->point); });
        else
          put_centre(ledger, i, j, [&]() -> ProjectivePoint<T> {
            throw Impossible(format_words("it is at infinity, square to {}, on which the two slide",
                                          "è all'infinito, normale a {}, su cui i due scorrono",
                                          built->letters.lines[index(joint->line)]));
          });
      }
  }
  template <class T, class Find>
  void put_centre(Ledger<T>& ledger, std::size_t i, std::size_t j, const Find& find) const {
    const PointQuantity P = instant_centre(built->letters.links[i], built->letters.links[j]);
    const auto found = [this, i, j, &find] {
      if (plan->alike.move_as_one(i, j)) refuse_at_rest(i, j);
      return find();
    };
    ledger.put(P.x(), [this, i, j, found] {
      const auto centre = found();
      return coordinate(i, j, centre, centre.x);
    });
    ledger.put(P.y(), [this, i, j, found] {
      const auto centre = found();
      return coordinate(i, j, centre, centre.y);
    });
  }

  // One of P's. Throws Impossible, with the direction in which it is, where the links are proved not to turn against
  // each other.
  template <class T>
  T coordinate(std::size_t i, std::size_t j, const ProjectivePoint<T>& P, const T& of_P) const {
    const Sign turns = plan->alike.turn_alike(i, j) ? Sign::zero : sign(P.w);
    if (turns == Sign::positive || turns == Sign::negative) return quotient(of_P, P.w);
    const std::string a = std::to_string(built->letters.links[i]), b = std::to_string(built->letters.links[j]);
    if (turns == Sign::undecided)
      throw Undecided(i == 0 ? format_words("whether link {} turns", "se il membro {} ruoti", b)
                             : format_words("whether links {} and {} turn alike",
                                            "se i membri {} e {} ruotino ugualmente", a, b));
    demand_motion(i, j, P);
    if (i != 0)
      throw Impossible(format_words("it is at infinity: links {} and {} turn alike",
                                    "è all'infinito: i membri {} e {} ruotano ugualmente", a, b));
    const auto& points = built->linkage.links[j].points;
    const Words whose = points.empty() ? Words{"its velocity", "sua velocità"}
                                       : Words{"the velocity of ", "velocità di "} + letter(points.front().point);
    throw Impossible(format_words("it is at infinity, square to {}: link {} does not turn",
                                  "è all'infinito, normale alla {}: il membro {} non ruota", whose, b));
  }
  // Throws where the two are proved to rest against each other, or that cannot be told: then each point is one.
  template <class T>
  void demand_motion(std::size_t i, std::size_t j, const ProjectivePoint<T>& P) const {
    bool is_at_rest = true;
    for (const T& x : {P.x, P.y, plan->alike.turn_alike(i, j) ? T(0) : P.w}) {
      const Sign moves = sign(x);
      if (moves == Sign::positive || moves == Sign::negative) return;
      is_at_rest = is_at_rest && moves == Sign::zero;
    }
    if (is_at_rest) refuse_at_rest(i, j);
    const std::string a = std::to_string(built->letters.links[i]), b = std::to_string(built->letters.links[j]);
    throw Undecided(i == 0 ? format_words("whether link {} rests", "se il membro {} sia fermo", b)
                           : format_words("whether links {} and {} move against each other",
                                          "se i membri {} e {} si muovano l'uno rispetto all'altro", a, b));
  }
  [[noreturn]] void refuse_at_rest(std::size_t i, std::size_t j) const {
    const std::string a = std::to_string(built->letters.links[i]), b = std::to_string(built->letters.links[j]);
    throw Impossible(i == 0 ? format_words("link {} rests: each of its points is one",
                                           "il membro {} è fermo: ogni suo punto lo è", b)
                            : format_words("links {} and {} do not move against each other",
                                           "i membri {} e {} non si muovono l'uno rispetto all'altro", a, b));
  }

  template <class T, class Find>
  static void put(Ledger<T>& ledger, const VectorQuantity& quantity, const Find& find) {
    ledger.put_x(quantity, [find] { return find().x; });
    ledger.put_y(quantity, [find] { return find().y; });
    ledger.put_size(quantity, [find] { return size(find()); });
  }
};

}  // namespace

std::shared_ptr<const RoutePlan> route_plan(const Built& built) { return std::make_shared<const RoutePlan>(built); }

std::vector<RouteValue> by_both_routes(const std::shared_ptr<const Built>& built,
                                       const std::shared_ptr<const RoutePlan>& plan, Rung rung) {
  return settle(SceneRoutes{.built = built, .plan = plan}, rung);
}

Quantity link_angle(int number) {
  const std::string i = std::to_string(number);
  return {"theta_" + i, "$θ_{" + i + "}$", "deg",
          format_words("angle of the x axis of link {} from that of the frame, counter-clockwise",
                       "angolo dell'asse x del membro {} da quello del telaio, antiorario", i)};
}
CentrePlan centre_plan_of(const Built& built) {
  const Arithmetic<Fast> scope;
  try {
    return centre_plan(built.linkage, CarriedOut<Fast>(built.linkage, built.steps).position());
  } catch (const geometry::Impossible&) {  // no place in doubles: nothing is drawn of it
  } catch (const geometry::Undecided&) {
  }
  return {};
}

std::vector<std::size_t> links_without_pivot(const Built& built) {
  std::vector<std::size_t> all;
  for (std::size_t i = 1; i < built.linkage.links.size(); ++i) {
    const auto& points = built.linkage.links[i].points;
    if (std::none_of(points.begin(), points.end(),
                     [&](const LinkPoint& p) { return built.linkage.links_at(p.point).front() == 0; }))
      all.push_back(i);
  }
  return all;
}

PointQuantity acceleration_centre(int link) {
  const std::string number = std::to_string(link);
  return {"K_" + number,
          format_words(" of the acceleration pole of link {}", " del polo delle accelerazioni del membro {}", link),
          "K," + number};
}

PointQuantity instant_centre(int one, int other) {
  constexpr int two_digits = 10;
  const auto [i, j] = std::minmax(one, other);
  const bool is_apart = i > 1 && j >= two_digits;  // P1 and 12 is nobody else's name
  const std::string first = "P" + std::to_string(i), second = std::to_string(j);
  const Words of = i == 1 ? format_words(" of the instant centre of link {} on the frame",
                                         " del centro di istantanea rotazione del membro {} sul telaio", j)
                          : format_words(" of the instant centre of links {} and {}",
                                         " del centro di istantanea rotazione dei membri {} e {}", i, j);
  return {first + (is_apart ? "_" : "") + second, of, first + (is_apart ? "," : "") + second};
}

}  // namespace epure::scenes
