#include "exercises/scenes/scene_routes.h"

#include <algorithm>
#include <string>

#include "exercises/kit/linkages/angles.h"
#include "exercises/kit/linkages/coupler_routes.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/scenes/centre_routes.h"
#include "exercises/scenes/file/greek.h"
#include "exercises/scenes/forces/force_routes.h"
#include "exercises/scenes/relative_motion.h"

namespace epure::scenes {
namespace {

using namespace geometry;
using analytic::Complex;

struct SceneRoutes {
  std::shared_ptr<const Built> built;
  std::shared_ptr<const RoutePlan> plan;
  ForceRoutes forces_of{built, plan};
  CentreRoutes centres_of{built, plan};

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
    if (built->loads) forces_of.by_power(ledger, constructed);
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
          put_vector(ledger, velocity(name), [&motion, p] { return motion.get().points[p].v; });
          put_vector(ledger, acceleration(name), [&motion, p] { return motion.get().points[p].a; });
        });
    put_vectors(ledger, VectorsConstructed<T>(*built, constructed));
    for (const PointOffset& offset : built->offsets)
      ledger.put(described(offset), constructed.carried_out.left_in_plane(offset.line, offset.point, at));
    centres_of.put_centres(
        ledger, [&](int point) { return projective(at.points[index(point)]); },
        [&](const PermanentCentre& touch) {
          return Centres<T>(plan->centres.leading_to(touch.i, touch.j), built->linkage, at).of(touch.i, touch.j);
        },
        [&](std::size_t i, std::size_t j) {
          const PlaneMotion<T>&a = motion.get().links[i], &b = motion.get().links[j];
          return centres_of.at_rest_against(a.omega - b.omega, centres_of.of_origin(a) - centres_of.of_origin(b));
        });
    if (built->loads) {
      const auto find = [&](const Loads& loads, bool with_inertia) {
        return forces_by_groups(*built, constructed, loads, with_inertia);
      };
      const FoundForces<T> forces(*built, *built->loads, find);
      forces_of.put_forces<T>(ledger, forces);
      forces_of.put_frictionless<T>(ledger, {*built, forces_of.frictionless, find});
      forces_of.tell_directions(ledger);
      const ForcesFound<T> found(*built, forces_of.found_by_groups(constructed, forces));
      forces_of.put_acting(ledger, found, [&](const Moments& moments, bool is_across) {
        return is_across ? found.across_by_moments(moments) : found.part(std::get<AcrossRod>(moments.sought), false);
      });
      forces_of.draw_acting(ledger, found);
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
      forces_of.put_forces<T>(ledger, forces);
      forces_of.put_frictionless<T>(ledger, {*built, forces_of.frictionless, find});
      const ForcesFound<T> found(*built, forces_of.found_by_equilibrium(by_joints, forces));
      forces_of.put_acting(ledger, found, [&](const Moments& moments, bool is_across) {
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
          put_vector(ledger, velocity(name), [&, p] { return as_vector(state(p, UpTo::velocity).v); });
          put_vector(ledger, acceleration(name), [&, p] { return as_vector(state(p, UpTo::acceleration).a); });
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
    centres_of.put_centres(
        ledger,
        [&](int point) {
          const Complex<T> z = state(point, UpTo::place).z;
          return ProjectivePoint<T>{z.re, z.im, T(1)};
        },
        [&](const PermanentCentre& touch) {
          const Linkage& of = built->linkage;
          if (touch.gear != nothing) {
            const MeshingLinks& gear = of.gears[index(touch.gear)];
            const Complex<T> P = analytic::point_of(link(index(gear.carrier), UpTo::place), of.pitch_point(gear)).z;
            return ProjectivePoint<T>{P.re, P.im, T(1)};
          }
          // A radius from the centre, square to the line.
          const RollingWheel& roll = of.rolls[index(touch.roll)];
          const LinkState<T>& guide = link(index(of.link_of_line(roll.line)), UpTo::place);
          const Complex<T> P =
              state(roll.centre, UpTo::place).z -
              from_rational<T>(roll.radius) * analytic::times_i(analytic::direction(of.line(roll.line), guide));
          return ProjectivePoint<T>{P.re, P.im, T(1)};
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
      centres_of.put_centre(ledger, i, j, [&, i, j, of, against] {
        if (!centres_of.touching(i, j)) {
          const auto &a = constructed.motion.get().links[i], &b = constructed.motion.get().links[j];
          centres_of.demand_motion(
              i, j, centres_of.at_rest_against(a.omega - b.omega, centres_of.of_origin(a) - centres_of.of_origin(b)));
        }
        return centres.get().of(of, against);
      });
    };
    for (const PermanentCentre& centre : plan->centres.permanent)
      if (centre.is_of_touching()) put(centre.i, centre.j);
    for (const FoundCentre& centre : plan->centres.found) put(centre.i, centre.j);
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
