#include <optional>
#include <type_traits>
#include <utility>

#include "geometry/analytic/joints/enclosed.h"
#include "geometry/analytic/joints/in_doubles.h"
#include "geometry/linkages/friction_circles.h"

namespace epure::geometry::analytic {
namespace {

using namespace joints;

// Forces on the links' origins along x and y, and moments about them.
template <class T>
Column<T> loads_on_links(const std::vector<LinkState<T>>& links, const Loads& loads, Inertia inertia) {
  Column<T> all(unknowns_of_a_link * (links.size() - 1), T(0));
  const auto of_link = [&](int link, std::size_t which) -> T& {
    return all[unknowns_of_a_link * (static_cast<std::size_t>(link) - 1) + which];
  };
  const auto add = [&](int link, const Own& at, const Complex<T>& F) {
    const LinkState<T>& state = links[static_cast<std::size_t>(link)];
    of_link(link, 0) += F.re;
    of_link(link, 1) += F.im;
    of_link(link, 2) += cross(point_of(state, at).z - state.O, F);
  };
  for (const LinkForce& load : loads.forces)
    if (load.link != 0)
      add(load.link, load.at,
          Complex<T>{from_rational<T>(load.components.x), from_rational<T>(load.components.y)} *
              Complex<T>{cosine<T>(load.turned), sine<T>(load.turned)});
  for (const LinkCouple& load : loads.couples)
    if (load.link != 0) of_link(load.link, 2) += from_rational<T>(load.moment);
  for (const LinkMass& body : loads.masses) {
    const T m = from_rational<T>(body.mass);
    add(body.link, body.at, m * Complex<T>{from_rational<T>(loads.gravity.x), from_rational<T>(loads.gravity.y)});
    if (inertia == Inertia::left_out) continue;
    const MassInMotion<T> moving = in_motion(body, links[static_cast<std::size_t>(body.link)]);
    add(body.link, body.at, -(m * Complex<T>{moving.a_x, moving.a_y}));
    of_link(body.link, 2) -= from_rational<T>(body.inertia) * moving.alpha;
  }
  return all;
}

// J^T, row by row.
template <class T>
std::vector<Equation<T>> transposed(const std::vector<Equation<T>>& rows) {
  std::vector<Equation<T>> columns(rows.size(), Equation<T>{.residual = T(0), .slopes = {}});
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (const auto& [column, slope] : rows[i].slopes)
      columns[static_cast<std::size_t>(column)].slopes.emplace_back(static_cast<int>(i), slope);
  return columns;
}

// Multipliers in the order of the equations, and the forces that they are. `take` is called with the force and its
// multiplier's factor: force = factor * λ.
template <class T, class Take>
void for_each_force(const Linkage& linkage, JointForces<T>& forces, const Take& take) {
  for (auto& hinge : forces.hinges) {
    take(hinge.x, Rational(-1));
    take(hinge.y, Rational(-1));
  }
  for (T& pin : forces.pins) take(pin, Rational(1));
  for (auto& guide : forces.guides) {
    take(guide.force, Rational(1));
    take(guide.couple, Rational(1));
  }
  for (auto& tooth : forces.teeth) take(tooth.tangential, Rational(1));
  for (std::size_t i = 0; i < linkage.drives.size(); ++i) {
    const auto* cylinder = std::get_if<Stretched>(&linkage.drives[i]);
    take(forces.drives[i], cylinder ? Rational(2) * cylinder->length : Rational(1));
  }
}
// Where the multipliers of the pins, the blocks and the gears begin.
struct Multipliers {
  std::size_t pins, blocks, gears;
  explicit Multipliers(const Linkage& linkage)
      : pins(2 * JointForces<Fast>(linkage).hinges.size()),
        blocks(pins + linkage.pins.size()),
        gears(blocks + 2 * linkage.blocks.size()) {}
};

// What acts beside what presses, so many times its size: friction, which does work with what slides, and the part of
// a tooth's force along the line of centres.
template <class T>
struct Beside {
  std::size_t multiplier;  // of what presses
  Equation<T> along;
  T slope;  // against `along`
};
// Of all friction, and then of all gears.
template <class T>
std::vector<Beside<T>> beside_what_presses(const Linkage& linkage, const std::vector<LinkState<T>>& links,
                                           const Loads& loads) {
  const Hanging whole = all_links(linkage);
  const JointEquations<T> joints(linkage, links, whole);
  const Column<T> rates = rates_of(links, true);
  const Multipliers at(linkage);
  std::vector<Beside<T>> all;
  for (const LineFriction& each : loads.frictions) {
    const auto k = static_cast<std::size_t>(each.which);
    Equation<T> sliding = joints.sliding(each);
    const int sense = sense_of_sliding(along(sliding, rates));
    all.push_back(
        {each.is_of_block ? at.blocks + 2 * k : at.pins + k, std::move(sliding), T(sense) * each.coefficient<T>()});
  }
  for (std::size_t k = 0; k < linkage.gears.size(); ++k) {
    const MeshingLinks& gear = linkage.gears[k];
    all.push_back({at.gears + k, joints.pressing(gear, true), -slope_of_teeth<T>(gear)});
  }
  return all;
}
template <class T>
T& beside(JointForces<T>& forces, const Loads& loads, std::size_t i) {
  const std::size_t frictions = loads.frictions.size();
  return i < frictions ? forces.friction(loads.frictions[i]) : forces.teeth[i - frictions].radial;
}
template <class T>
const T& pressing(const JointForces<T>& forces, const Loads& loads, std::size_t i) {
  const std::size_t frictions = loads.frictions.size();
  return i < frictions ? forces.normal(loads.frictions[i]) : forces.teeth[i - frictions].tangential;
}

// The equilibrium of all links: what each force of a joint does to them. (That wheels mesh is an equation of their
// angles; what their teeth do to each other acts in the pitch point.)
template <class T>
std::vector<Equation<T>> equilibrium(const Linkage& linkage, const std::vector<LinkState<T>>& links) {
  std::vector<Equation<T>> rows = equations(linkage, links);
  const Hanging whole = all_links(linkage);
  const JointEquations<T> joints(linkage, links, whole);
  const Multipliers at(linkage);
  for (std::size_t k = 0; k < linkage.gears.size(); ++k)
    rows[at.gears + k] = joints.pressing(linkage.gears[k], false);
  return transposed(rows);
}

// What is left over of a sum of forces on exact numbers.
template <class T>
void demand_in_equilibrium(const T& left_over) {
  const Sign left = sign(left_over);
  if (left == Sign::undecided)
    throw Undecided("whether the forces found hold all links in equilibrium",
                    "se le forze trovate tengano in equilibrio tutti i membri");
  if (left != Sign::zero)
    throw Impossible("the forces found do not hold all links in equilibrium",
                     "le forze trovate non tengono in equilibrio tutti i membri");
}

template <class T>
T magnitude_proved(const T& x) {
  const Sign decided = sign(x);
  if (decided == Sign::undecided)
    throw Undecided("from which side a guide presses", "da quale parte prema una guida");
  return decided == Sign::negative ? -x : x;
}

// The equilibrium under friction with one set of senses.
template <class T>
class WithSenses {
 public:
  WithSenses(const std::vector<Equation<T>>& columns, const std::vector<Beside<T>>& rubbing,
             const std::vector<int>& senses)
      : equations_(columns) {
    for (std::size_t i = 0; i < rubbing.size(); ++i) {
      slopes_.push_back(T(senses[i]) * rubbing[i].slope);
      for (const auto& [column, slope] : rubbing[i].along.slopes)
        equations_[static_cast<std::size_t>(column)].slopes.emplace_back(static_cast<int>(rubbing[i].multiplier),
                                                                         -(slopes_[i] * slope));
    }
    if constexpr (!std::is_same_v<T, Fast>) inverse_.emplace(equations_);
  }
  JointForces<T> forces(const Linkage& linkage, const Loads& loads, const Column<T>& borne) const {
    const Column<T> multipliers = solution(borne);
    JointForces<T> all(linkage);
    std::size_t next = 0;
    for_each_force(linkage, all,
                   [&](T& force, const Rational& factor) { force = from_rational<T>(factor) * multipliers[next++]; });
    for (std::size_t i = 0; i < slopes_.size(); ++i) beside(all, loads, i) = -(slopes_[i] * pressing(all, loads, i));
    return all;
  }

 private:
  Column<T> solution(const Column<T>& borne) const {
    if constexpr (std::is_same_v<T, Fast>)
      return solved(equations_, borne);
    else
      return solved(equations_, *inverse_, borne);
  }

  std::vector<Equation<T>> equations_;
  std::vector<T> slopes_;
  std::optional<Preconditioner<T>> inverse_ = {};
};

template <class T>
FrictionCircles<T> friction_circles(const Linkage& linkage, const std::vector<LinkState<T>>& links,
                                    const Loads& loads) {
  std::vector<T> turning;
  for (const auto& hinge : JointForces<T>(linkage).hinges)
    turning.push_back(links[static_cast<std::size_t>(hinge.on)].omega -
                      links[static_cast<std::size_t>(hinge.by)].omega);
  return {linkage, loads, turning};
}
template <class T>
void add_couple(const typename JointForces<T>::Hinge& hinge, const T& couple, Column<T>& acting) {
  const auto on_link = [&](int link) -> T& {
    return acting[unknowns_of_a_link * static_cast<std::size_t>(link) - 1];
  };
  if (hinge.on != 0) on_link(hinge.on) += couple;
  if (hinge.by != 0) on_link(hinge.by) -= couple;
}

template <class T>
JointForces<T> forces_found(const Linkage& linkage, const std::vector<LinkState<T>>& links, const Loads& loads,
                            Inertia inertia) {
  const std::vector<Equation<T>> columns = equilibrium(linkage, links);
  const Column<T> acting = loads_on_links(links, loads, inertia);
  const std::vector<Beside<T>> rubbing = beside_what_presses(linkage, links, loads);
  const JointForces<T> none(linkage);
  const FrictionCircles<T> circles = friction_circles(linkage, links, loads);
  return forces_with_friction<JointForces<T>>(
      rubbing.size(),
      [&](const std::vector<int>& senses) {
        const WithSenses<T> held(columns, rubbing, senses);
        return circles.forces([&](const std::vector<T>& couples, bool is_loaded) {
          Column<T> borne;
          for (const T& load : acting) borne.push_back(is_loaded ? -load : T(0));
          for (std::size_t k = 0; k < couples.size(); ++k) add_couple(none.hinges[k], -couples[k], borne);
          JointForces<T> forces = held.forces(linkage, loads, borne);
          for (std::size_t k = 0; k < couples.size(); ++k) forces.hinges[k].couple = couples[k];
          return forces;
        });
      },
      [&](const JointForces<T>& found, std::size_t i) { return pressing(found, loads, i); },
      [](const JointForces<T>& a, const JointForces<T>& b) { return either(a, b); });
}

}  // namespace

template <class T>
JointForces<T> solve_forces(const Linkage& linkage, const std::vector<LinkState<T>>& links, const Loads& loads,
                            Inertia inertia) {
  return forces_found(linkage, links, loads, inertia);
}

template <class T>
void demand_equilibrium(const Linkage& linkage, const std::vector<LinkState<T>>& links, const Loads& loads,
                        const JointForces<T>& forces, Inertia inertia) {
  JointForces<T> held = forces;
  Column<T> multipliers;
  for_each_force(linkage, held, [&](T& force, const Rational& factor) {
    multipliers.push_back(from_rational<T>(Rational(1 / factor)) * force);
  });
  Column<T> borne = loads_on_links(links, loads, inertia);
  for (const T& left : friction_circles(linkage, links, loads).left_over(forces)) demand_in_equilibrium(left);
  for (const auto& hinge : forces.hinges) add_couple(hinge, hinge.couple, borne);
  const std::vector<Beside<T>> rubbing = beside_what_presses(linkage, links, loads);
  for (std::size_t k = 0; k < rubbing.size(); ++k) {
    const T& acts = beside(held, loads, k);
    demand_in_equilibrium(acts + rubbing[k].slope * magnitude_proved(pressing(held, loads, k)));
    for (const auto& [column, each] : rubbing[k].along.slopes) borne[static_cast<std::size_t>(column)] += each * acts;
  }
  const std::vector<Equation<T>> columns = equilibrium(linkage, links);
  for (std::size_t i = 0; i < columns.size(); ++i) demand_in_equilibrium(along(columns[i], multipliers) + borne[i]);
}
template JointForces<Fast> solve_forces<Fast>(const Linkage&, const std::vector<LinkState<Fast>>&, const Loads&,
                                              Inertia);
template JointForces<Bounded> solve_forces<Bounded>(const Linkage&, const std::vector<LinkState<Bounded>>&,
                                                    const Loads&, Inertia);
template JointForces<Deep> solve_forces<Deep>(const Linkage&, const std::vector<LinkState<Deep>>&, const Loads&,
                                              Inertia);
template void demand_equilibrium<Exact>(const Linkage&, const std::vector<LinkState<Exact>>&, const Loads&,
                                        const JointForces<Exact>&, Inertia);
template void demand_equilibrium<Generic>(const Linkage&, const std::vector<LinkState<Generic>>&, const Loads&,
                                          const JointForces<Generic>&, Inertia);
template void demand_equilibrium<Calcium>(const Linkage&, const std::vector<LinkState<Calcium>>&, const Loads&,
                                          const JointForces<Calcium>&, Inertia);

}  // namespace epure::geometry::analytic
