// The forces in a scene's joints and what its drives must provide: what they are called, and three ways to find them,
// with the inertia of masses.
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "exercises/kit/statement/forces.h"
#include "exercises/scenes/scene_states.h"
#include "geometry/linkages/forces_by_groups.h"

namespace epure::scenes {

using geometry::Drive;
using geometry::JointForces;
using geometry::LineOnLine;
using geometry::LinkCouple;
using geometry::LinkForce;
using geometry::SlidPoint;
using geometry::Stretched;
using geometry::TurnedLink;

// R_34, the force of link 3 on link 4, at the hinge of the two: the lower number first, so that it may be the force
// of the second link of the hinge on the first, which is the opposite.
struct HingeForce {
  VectorQuantity quantity;
  bool is_opposite;
};
inline HingeForce force_of_links(const Built& built, int by, int on, const Words& where) {
  constexpr int two_digits = 10;
  const auto [i, j] = std::minmax(built.letters.links[index(by)], built.letters.links[index(on)]);
  VectorQuantity force = force_between(i, j);
  if (j >= two_digits) {
    force.name = "R_" + std::to_string(i) + "_" + std::to_string(j);
    force.of = std::to_string(i) + "," + std::to_string(j);
  }
  force.meaning = force.size =
      format_words("force of link {} on link {}, {}", "forza del membro {} sul membro {}, {}", i, j, where);
  return {force, built.letters.links[index(by)] != i};
}
inline HingeForce hinge_force(const Built& built, int point, int by, int on) {
  return force_of_links(built, by, on, format_words("in {}", "in {}", built.letters.points[index(point)]));
}
// The same between the teeth of two wheels, and its two parts: R_25_t and R_25_r.
inline HingeForce tooth_force(const Built& built, std::size_t gear) {
  const geometry::MeshingLinks& of = built.linkage.gears[gear];
  return force_of_links(built, of.first, of.second, {"in their teeth", "fra i denti"});
}
struct TeethParts {
  Quantity tangential, radial;
};
inline TeethParts parts_of_tooth_force(const Built& built, std::size_t gear) {
  const VectorQuantity whole = tooth_force(built, gear).quantity;
  const auto part = [&](const std::string& script, const Words& meaning) {
    return Quantity{whole.name + "_" + script, "$\\it{R}^{" + script + "}_{" + whole.of + "}$", "N", meaning};
  };
  return {part("t", format_words("part of {} along the common tangent of the pitch circles",
                                 "componente di {} lungo la tangente comune alle primitive", whole.name)),
          part("r", format_words("part of {} along the line of centres",
                                 "componente di {} lungo la congiungente i centri", whole.name))};
}

// What slides, by its letter; with its guide where it has several.
inline std::string sliding_name(const std::string& slides, const std::string& guide, bool has_several) {
  return slides + (has_several ? "_" + guide : "");
}
inline Quantity pin_force(const Built& built, std::size_t pin) {
  const auto& pins = built.linkage.pins;
  const auto& [point, line] = pins[pin];
  const std::string &A = built.letters.points[index(point)], &g = built.letters.lines[index(line)];
  const bool has_several =
      std::count_if(pins.begin(), pins.end(), [&, P = point](const auto& each) { return each.point == P; }) > 1;
  return {"N_" + sliding_name(A, g, has_several),
          "$\\it{N}_{" + point_letters(A) + (has_several ? "," + point_letters(g) : "") + "}$", "N",
          format_words("force of {0} on {1}, to the left of {0}", "forza di {0} su {1}, a sinistra di {0}", g, A)};
}
struct GuideForces {
  Quantity force, couple;
};
inline GuideForces guide_forces(const Built& built, std::size_t block) {
  const auto& blocks = built.linkage.blocks;
  const LineOnLine& lines = blocks[block];
  const std::string &b = built.letters.lines[index(lines.moving)], &g = built.letters.lines[index(lines.guide)];
  const bool has_several =
      std::count_if(blocks.begin(), blocks.end(), [&](const auto& each) { return each.moving == lines.moving; }) > 1;
  const std::string name = sliding_name(b, g, has_several),
                    letters = "_{" + point_letters(b) + (has_several ? "," + point_letters(g) : "") + "}$";
  return {{"N_" + name, "$\\it{N}" + letters, "N",
           format_words("force of {0} on {1}, to the left of {0}", "forza di {0} su {1}, a sinistra di {0}", g, b)},
          {"M_" + name, "$\\it{M}" + letters, "N*m",
           format_words("couple of {0} on {1}, about the point that {1} is given through",
                        "coppia di {0} su {1}, rispetto al punto per cui {1} è data", g, b)}};
}
// Of friction in a hinge, of link i on link j.
inline std::string letters_of_hinge_couple(int i, int j) {
  constexpr int two_digits = 10;
  return "$\\it{M}_{" + std::to_string(i) + (std::max(i, j) < two_digits ? "" : ",") + std::to_string(j) + "}$";
}
// The couple of friction in it, of the lower number on the other: "M_34".
inline Quantity hinge_couple(const Built& built, int by, int on) {
  const auto [i, j] = std::minmax(built.letters.links[index(by)], built.letters.links[index(on)]);
  constexpr int two_digits = 10;
  const std::string a = std::to_string(i), b = std::to_string(j);
  return {
      "M_" + a + (j < two_digits ? "" : "_") + b, letters_of_hinge_couple(i, j), "N*m",
      format_words("couple of friction of link {} on link {}", "coppia d'attrito del membro {} sul membro {}", i, j)};
}
inline bool has_friction(const geometry::Loads& loads, int point) {
  return std::any_of(loads.hinge_frictions.begin(), loads.hinge_frictions.end(),
                     [&](const geometry::HingeFriction& each) { return each.point == point; });
}

// Where there is friction: what slides, on which line; N as it is without, T of the same name, and both together,
// R_gb, of g on b.
struct Contact {
  Quantity normal;
  std::string slides, line;
};
inline Contact contact(const Built& built, const geometry::LineFriction& of) {
  const auto k = index(of.which);
  if (!of.is_of_block) {
    const geometry::PinOnLine& pin = built.linkage.pins[k];
    return {pin_force(built, k), built.letters.points[index(pin.point)], built.letters.lines[index(pin.line)]};
  }
  const LineOnLine& block = built.linkage.blocks[k];
  return {guide_forces(built, k).force, built.letters.lines[index(block.moving)],
          built.letters.lines[index(block.guide)]};
}
// "b" of what is N_b: as names and letters have it.
inline std::string name_of_contact(const Contact& of) { return of.normal.name.substr(2); }
inline std::string letters_of_contact(const Contact& of) {
  const std::size_t first = of.normal.symbol.find("_{") + 2;
  return of.normal.symbol.substr(first, of.normal.symbol.rfind('}') - first);
}
inline Quantity friction_force(const Built& built, const geometry::LineFriction& of) {
  const Contact at = contact(built, of);
  return {"T_" + name_of_contact(at), "$\\it{T}_{" + letters_of_contact(at) + "}$", "N",
          format_words("friction of {0} on {1}, along {0}", "attrito di {0} su {1}, lungo {0}", at.line, at.slides)};
}
inline Quantity whole_contact_force(const Built& built, const geometry::LineFriction& of) {
  const Contact at = contact(built, of);
  return {
      "R_" + at.line + at.slides, "$\\it{R}_{" + point_letters(at.line) + point_letters(at.slides) + "}$", "N",
      format_words("force of {0} on {1}, with friction", "forza di {0} su {1}, con l'attrito", at.line, at.slides)};
}
// "φ_b", rich text.
inline std::string friction_angle(const Built& built, const geometry::LineFriction& of) {
  return "$φ_{" + letters_of_contact(contact(built, of)) + "}$";
}

inline Quantity driving_effort(const Built& built, const Drive& drive) {
  const auto letter = [&](int point) { return built.letters.points[index(point)]; };
  if (const auto* crank = std::get_if<TurnedLink>(&drive)) {
    const std::string number = std::to_string(built.letters.links[index(crank->link)]);
    return {"M_" + number, "$\\it{M}_{" + number + "}$", "N*m",
            format_words("driving couple on link {}", "coppia motrice sul membro {}", number)};
  }
  if (const auto* slid = std::get_if<SlidPoint>(&drive)) {
    const std::string A = letter(slid->point);
    return {"F_" + A, "$\\it{F}_{" + point_letters(A) + "}$", "N",
            format_words("driving force on {} along {}", "forza motrice su {} lungo {}", A,
                         built.letters.lines[index(slid->guide)])};
  }
  const auto& cylinder = std::get<Stretched>(drive);
  const std::string P = letter(cylinder.from), Q = letter(cylinder.to);
  return {"F_" + P + Q, "$\\it{F}_{" + point_letters(P) + point_letters(Q) + "}$", "N",
          format_words("push of the cylinder {} {}", "spinta del cilindro {} {}", P, Q)};
}

inline bool moves(const Built& built) {
  const auto is_driven = [](const Drive& drive) {
    if (const auto* turned = std::get_if<TurnedLink>(&drive))
      return !is_zero(turned->omega) || !is_zero(turned->alpha);
    if (const auto* slid = std::get_if<SlidPoint>(&drive)) return slid->velocity != 0 || slid->acceleration != 0;
    const auto& cylinder = std::get<Stretched>(drive);
    return cylinder.velocity != 0 || cylinder.acceleration != 0;
  };
  return std::any_of(built.linkage.drives.begin(), built.linkage.drives.end(), is_driven);
}
// The same, were there no friction: "M_2_0".
inline Quantity frictionless_effort(const Built& built, const Drive& drive) {
  Quantity effort = driving_effort(built, drive);
  effort.name += "_0";
  effort.symbol.insert(effort.symbol.rfind('}'), ",0");
  effort.meaning = effort.meaning + Words{", were there no friction", ", se non ci fosse attrito"};
  return effort;
}

// Whether inertia acts: masses on a mechanism that moves.
inline bool has_inertia(const Built& built) { return !built.loads->masses.empty() && moves(built); }
// The masses, and nothing else that acts.
inline geometry::Loads without_loads(const geometry::Loads& loads) { return {.masses = loads.masses}; }

// Whether numbers of this kind count a radian for each 2π of a turn in what inertia makes, and not in the loads.
template <class T>
bool has_inertia_apart(const Built& built) {
  return signs_only<T> && has_inertia(built) && built.linkage.is_turned_steadily();
}
// A number that loads and inertia make together. Exact numbers count a radian for each 2π of a turn, so what inertia
// makes is too small by (2π)²: that is transcendental, and the sum is zero where both are.
template <class T>
T of_both(const T& of_loads, const T& of_inertia) {
  using geometry::Sign;
  const Sign one = sign(of_loads), other = sign(of_inertia);
  if (one == Sign::zero) return of_inertia;
  if (other == Sign::zero || (one == other && one != Sign::undecided)) return of_loads;
  throw geometry::Undecided("whether loads and inertia outweigh each other", "se carichi e inerzia si compensino");
}

// The forces that a route finds, `find` under these loads and with inertia or without.
template <class T>
class FoundForces {
 public:
  using Find = std::function<JointForces<T>(const geometry::Loads&, bool)>;
  // Of these loads.
  FoundForces(const Built& built, const geometry::Loads& loads, const Find& find)
      : has_inertia_(has_inertia(built)),
        is_parted_(has_inertia_apart<T>(built)),
        has_loads_(!loads.forces.empty() || !loads.couples.empty() || loads.has_weight()),
        has_friction_(loads.has_friction()),
        whole_([&loads, find, with = has_inertia_ && !is_parted_] { return find(loads, with); }),
        inertia_([&loads, find] { return find(without_loads(loads), true); }) {}
  // One of them: `select` takes it from the JointForces.
  template <class Select>
  T of(const Select& select) const {
    if (has_friction_) return select(all());  // from which side what rubs presses is a question to their sum
    return is_parted_ ? of_both<T>(select(whole_.get()), select(inertia_.get())) : T(select(whole_.get()));
  }
  // All in one measure. Throws Undecided where exact numbers have two.
  const JointForces<T>& all() const {
    if (!is_parted_) return whole_.get();
    if (has_loads_ || has_friction_)
      throw geometry::Undecided("whether loads and inertia outweigh each other",
                                "se carichi e inerzia si compensino");
    return inertia_.get();
  }

 private:
  bool has_inertia_, is_parted_, has_loads_, has_friction_;
  WhenAsked<JointForces<T>> whole_, inertia_;
};

template <class T>
std::vector<geometry::MassInMotion<T>> masses_in_motion(const Built& built, const Constructed<T>& constructed) {
  const geometry::ForcesByGroups<T> drawn(built.linkage, constructed.at);
  std::vector<geometry::MassInMotion<T>> all;
  for (const geometry::LinkMass& body : built.loads->masses) {
    const geometry::PlaneMotion<T>& moving = constructed.motion.get().links[index(body.link)];
    const geometry::Vector<T> a = moving.acceleration(drawn.place(body));
    all.push_back({a.x, a.y, moving.alpha});
  }
  return all;
}

// How fast what rubs slides along its line.
template <class T>
std::vector<T> sliding_velocities(const Built& built, const Constructed<T>& constructed,
                                  const geometry::Loads& loads) {
  const geometry::ForcesByGroups<T> drawn(built.linkage, constructed.at);
  std::vector<T> all;
  for (const geometry::LineFriction& each : loads.frictions) {
    const bool is_of_block = each.is_of_block;
    const auto k = index(each.which);
    const int line = is_of_block ? built.linkage.blocks[k].guide : built.linkage.pins[k].line,
              moving = is_of_block ? built.linkage.blocks[k].moving : geometry::nothing;
    const auto& motion = constructed.motion.get();
    const geometry::Point<T> X =
        is_of_block ? drawn.through(moving) : constructed.at.points[index(built.linkage.pins[k].point)];
    const geometry::Vector<T> v = is_of_block ? motion.links[index(built.linkage.link_of_line(moving))].velocity(X)
                                              : motion.points[index(built.linkage.pins[k].point)].v;
    all.push_back(dot(v - motion.links[index(built.linkage.link_of_line(line))].velocity(X), drawn.along(line)));
  }
  return all;
}

// How fast the second link of each hinge turns on the first.
template <class T>
std::vector<T> turning_in_hinges(const Built& built, const Constructed<T>& constructed,
                                 const geometry::Loads& loads) {
  std::vector<T> all;
  if (loads.hinge_frictions.empty()) return all;
  const auto& links = constructed.motion.get().links;
  for (const auto& hinge : JointForces<T>(built.linkage).hinges)
    all.push_back(links[index(hinge.on)].omega - links[index(hinge.by)].omega);
  return all;
}

// Group after group, from the last to the drive.
template <class T>
JointForces<T> forces_by_groups(const Built& built, const Constructed<T>& constructed, const geometry::Loads& loads,
                                bool with_inertia) {
  // How hinges turn may take Calcium minutes, and the couples lead on to nested roots.
  if (std::is_same_v<T, geometry::Calcium> && !loads.hinge_frictions.empty())
    throw geometry::Undecided("forces with friction circles on exact numbers",
                              "forze con cerchi d'attrito su numeri esatti");
  return geometry::ForcesByGroups<T>(built.linkage, constructed.at)
      .under(loads, built.steps,
             with_inertia ? masses_in_motion(built, constructed) : std::vector<geometry::MassInMotion<T>>{},
             sliding_velocities(built, constructed, loads), turning_in_hinges(built, constructed, loads));
}
// The equilibrium of all links at once; on exact numbers, that what was constructed satisfies it.
template <class T>
JointForces<T> forces_by_equilibrium(const Built& built, const Constructed<T>& constructed,
                                     const ByJoints<T>& by_joints, const geometry::Loads& loads, bool with_inertia) {
  const UpTo slides = loads.has_friction() ? UpTo::velocity : UpTo::place;
  const auto& links = by_joints.states(with_inertia ? UpTo::acceleration : slides);
  const auto inertia = with_inertia ? geometry::analytic::Inertia::included : geometry::analytic::Inertia::left_out;
  if constexpr (signs_only<T>) {
    JointForces<T> found = forces_by_groups(built, constructed, loads, with_inertia);
    geometry::analytic::demand_equilibrium<T>(built.linkage, links, loads, found, inertia);
    return found;
  } else {
    return geometry::analytic::solve_forces<T>(built.linkage, links, loads, inertia);
  }
}

// What a drive must provide: while it alone moves, at one radian or metre a second, its power and that of the loads
// and weights are together the rate at which the kinetic energy grows.
template <class T>
T effort_by_power(const Built& built, const Constructed<T>& constructed, std::size_t drive) {
  std::vector<geometry::DriveRates<T>> rates(built.linkage.drives.size(), geometry::DriveRates<T>{T(0), T(0)});
  rates[drive].first = T(1);
  const geometry::LinkageMotion<T> motion = constructed.carried_out.motion(constructed.at, rates);
  const geometry::ForcesByGroups<T> drawn(built.linkage, constructed.at);
  const auto& loads = *built.loads;
  T power(0), growing(0);
  for (const LinkForce& load : loads.forces)
    power += dot(drawn.vector(load), motion.links[index(load.link)].velocity(drawn.place(load)));
  for (const LinkCouple& load : loads.couples)
    power += geometry::from_rational<T>(load.moment) * motion.links[index(load.link)].omega;
  for (const geometry::LinkMass& body : loads.masses)
    power += dot(drawn.weight(body, loads.gravity), motion.links[index(body.link)].velocity(drawn.place(body)));
  if (!has_inertia(built)) return -power;
  const std::vector<geometry::MassInMotion<T>> moving = masses_in_motion(built, constructed);
  for (std::size_t k = 0; k < moving.size(); ++k) {
    const geometry::LinkMass& body = loads.masses[k];
    const geometry::PlaneMotion<T>& link = motion.links[index(body.link)];
    growing += geometry::from_rational<T>(body.mass) *
                   dot(geometry::Vector<T>{moving[k].a_x, moving[k].a_y}, link.velocity(drawn.place(body))) +
               geometry::from_rational<T>(body.inertia) * (moving[k].alpha * link.omega);
  }
  return has_inertia_apart<T>(built) ? of_both<T>(-power, growing) : growing - power;
}

}  // namespace epure::scenes
