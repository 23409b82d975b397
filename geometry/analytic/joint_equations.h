// The second route of any linkage: the equations of all its joints at once. The unknowns are the place of every
// moving link, x and y of its origin and the angle θ of its x axis (Haug, Computer Aided Kinematics and Dynamics,
// chapter 3):
//
//   hinge             (x, y)_i + R_i p_i - (x, y)_j - R_j p_j = 0            two equations
//   pin on a line     n_j . (X_i - G_j) = 0                                  one
//   line on a line    n_j . (G_i - G_j) = 0,  s_i x s_j = 0                  two
//   turned link       θ_i - θ = 0                                            one
//   gears             θ_j - θ_c - phase - m (θ_i - θ_c) = 0                  one
//   rolling           r (θ_i - θ_j - phase) + s_j . (X_i - G_j) - at = 0       one
//   slid point        s_j . (X_i - G_j) - at = 0                             one
//   cylinder          (X_i - X_j)² - l² = 0                                  one
//
// solved by Newton's iteration, proved by a step of Krawczyk's on boxes, and differentiated twice: linear equations
// with one matrix for the rates. No link is solved before another; of ruler and compass nothing is used but the place
// where to begin.
#pragma once

#include <vector>

#include "geometry/analytic/complex.h"
#include "geometry/linkages/linkage.h"
#include "geometry/linkages/loads.h"
#include "geometry/numbers/enclosure.h"

namespace epure::geometry::analytic {

// Of a link: its origin, the angle of its x axis and this axis, e^{iθ}; first and second derivatives of origin and
// angle.
template <class T>
struct LinkState {
  Complex<T> O, v, a;
  T theta, omega, alpha;
  Complex<T> x;
};

// A point given in the axes of its link: metres, m/s, m/s².
template <class T>
struct PointState {
  Complex<T> z, v, a;
};

template <class T>
PointState<T> point_of(const LinkState<T>& link, const Own& own) {
  const Complex<T> r = Complex<T>{from_rational<T>(own.x), from_rational<T>(own.y)} * link.x;
  return {link.O + r, link.v + link.omega * times_i(r), link.a + Complex<T>{-square(link.omega), link.alpha} * r};
}

// A line's direction in the plane, of length one.
template <class T>
Complex<T> direction(const LinkLine& line, const LinkState<T>& link) {
  if (const auto* angle = std::get_if<Angle>(&line.along))
    return Complex<T>{cosine<T>(*angle), sine<T>(*angle)} * link.x;
  const Own& own = std::get<Own>(line.along);
  const Complex<T> s{from_rational<T>(own.x), from_rational<T>(own.y)};
  return divided(s, modulus(s)) * link.x;
}

// Where the iteration begins: the state of every link, the frame's first. Only origins and axes are read, and of the
// angles how many whole turns are in them.
template <class T>
using Beginning = std::vector<LinkState<T>>;

// The state of every link, the frame's first, near the beginning: from its origins, and its angles with half of their
// digits, so that something is left to find. Bounded: iterated in doubles. Deep: with as many bits as the scope has,
// for near a dead centre the place and its mirror image may be one in doubles. Both: the only solution in a box about
// the last iterate, proved. Fast: the last iterate. Throws Undecided where the iteration ends nowhere, where no box
// is proved (a limit position, for this number), where a joint is not proved to lie on its side, told in full
// (with_sides_in_full), where one lies on the other side though the beginning is not proved to, and on exact numbers:
// angles are not algebraic. Throws Impossible where one lies on the other side as in the beginning.
template <class T>
std::vector<LinkState<T>> solve_joints(const Linkage& linkage, const Beginning<T>& beginning);

// Where a drive stops: the joints let the links move though all drives stand still, so the equations of all joints
// are dependent there. Solved for the place of every link and for that motion, n, with the drive's own equation left
// out and its place read off:
//
//   Φ = 0 but for the drive's,   J n = 0,   n = 1 for one of its components
//
// of which the slopes are J and those of J n, the second derivatives of Φ along n. One solution is proved in a box
// near the beginning; as the slopes are independent there the mechanism turns back at that place, and does not go on
// through it. v and ω of the links are this motion. On Deep. Errors as above; of the joint
// that is at its limit no side is demanded.
template <class T>
std::vector<LinkState<T>> solve_dead_point(const Linkage& linkage, int drive, const Beginning<T>& beginning);
// Where a drive is: its link's angle as far as it has turned, or the way, in radians and metres.
template <class T>
T place_of_drive(const Linkage& linkage, int drive, const std::vector<LinkState<T>>& links);

// On exact numbers nothing is solved. A state that was found elsewhere (its angles are not read, only its axes) is
// put into the equations of all joints, into their first derivatives, into their second ones: where all hold, and the
// equations are independent at that place, it is the state. So a zero of it is proved, which no enclosure can do.
enum class UpTo { place, velocity, acceleration };

// Links that are placed together, and what stood before: the equations that join the one to the other and each other.
struct Hanging {
  std::vector<bool> stands, is_placed;  // of every link, the frame's first
  std::vector<int> on = {};             // moving ones that stand and are in these equations

  bool has(int link) const { return stands[static_cast<std::size_t>(link)] || places(link); }
  bool places(int link) const { return is_placed[static_cast<std::size_t>(link)]; }
};
// Everything at once, on the frame.
Hanging all_links(const Linkage& linkage);
// The same one after another: `order` lists links as they can be placed. Each has as many equations as unknowns, and
// nothing of what comes later is in them. So where all equations are independent, those of one Hanging and of all
// that it hangs on are so by themselves: what these links do is proved without the rest.
std::vector<Hanging> one_after_another(const Linkage& linkage, const std::vector<std::vector<int>>& order);

// The equations hold exactly. Throws Impossible where one does not, Undecided where that cannot be told. Where
// Linkage::is_turned_steadily, the rates are those of a radian for each 2π.
template <class T>
void demand_joints(const Linkage& linkage, const std::vector<LinkState<T>>& state, UpTo order,
                   const Hanging& hanging);

// The equations are independent at every place that these enclosures hold. Throws Undecided.
void demand_independent(const Linkage& linkage, const std::vector<LinkState<Deep>>& place);

// The equilibrium of all links at once, of forces along x and y and moments about each link's origin: what holds an
// equation does work with what is left of it, so of the multipliers λ that go with the equations J^T λ + load = 0
// (Lagrange). States of solve_joints; with what their accelerations make of the masses, or without.
enum class Inertia { left_out, included };
template <class T>
JointForces<T> solve_forces(const Linkage& linkage, const std::vector<LinkState<T>>& links, const Loads& loads,
                            Inertia inertia = Inertia::left_out);
// How the centre of a mass is accelerated, and its link.
template <class T>
MassInMotion<T> in_motion(const LinkMass& body, const LinkState<T>& link) {
  const Complex<T> a = point_of(link, body.at).a;
  return {a.re, a.im, link.alpha};
}
// On exact numbers: forces that were found elsewhere hold all links in equilibrium, exactly; where the equations of
// the joints are independent no others do. Throws Impossible where they do not, Undecided where that cannot be told.
template <class T>
void demand_equilibrium(const Linkage& linkage, const std::vector<LinkState<T>>& links, const Loads& loads,
                        const JointForces<T>& forces, Inertia inertia = Inertia::left_out);

}  // namespace epure::geometry::analytic
