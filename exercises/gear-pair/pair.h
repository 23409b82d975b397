// A pair as its sheets show it: read from the solution, in the frame of geometry/gears/gear_pair.h.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "exercises/gear-pair/quantities.h"
#include "exercises/kit/proof/solution.h"
#include "geometry/gears/faults.h"
#include "geometry/gears/pair_data.h"

namespace epure::gear_pair {

// Where contact begins or ends: at a tip (A, E), or short of it (F, V: routes.h).
struct PathEnd {
  std::string point;                                                    // "A", "F1"
  double xi = 0;                                                        // position on the line of action
  bool is_short() const { return point[0] == 'F' || point[0] == 'V'; }  // of the tip
  std::string letters() const { return point_letters(point); }
};

struct Pair {
  explicit Pair(const Solution& solution);

  const Solution& s;
  geometry::PairData of;
  std::vector<geometry::Fault> faults;
  std::array<Place, 2> centres;
  double pitch, base_pitch;
  Arrow2 along;                // unit vector of the line of action, as contact travels
  double T1;                   // positions on it
  std::optional<double> T2;    // none of a rack
  std::optional<double> A, E;  // none when the tip circle does not reach the line of action
  // What is left of AE, when has_contact(). Not known when a wheel has no outline: the ends are then those of whole
  // flanks, which T1 and T2 limit all the same.
  PathEnd begins = {}, ends = {};
  bool is_known = false;
  bool touches = true;        // flanks do, somewhere
  bool is_continuous = true;  // each pair of teeth touches until after the next has begun to; not known: would, on AE

  double m() const;  // module
  bool is_ring(int wheel = 2) const { return wheel == 2 && of.kind == geometry::PairKind::internal; }
  bool is_rack(int wheel = 2) const { return wheel == 2 && of.kind == geometry::PairKind::rack; }
  // The working pitch circles are not the reference circles.
  bool is_shifted() const { return geometry::shift_per_tooth(of) != 0; }

  // Where the wheel lies is given with its teeth; else that is asked for: the centre distance of shifted wheels.
  bool is_placed(int wheel) const { return wheel == 1 || !is_shifted(); }

  // "r_tip_" and 1: what is called r_tip_1.
  double operator()(const std::string& name, int wheel) const { return s[on(name, wheel)]; }
  const Place& O(int wheel) const { return centres[static_cast<std::size_t>(wheel - 1)]; }  // no rack
  // Of P0 seen from the centre, and of a rack from its body: 1 up, -1 down.
  int up(int wheel) const { return wheel == 1 || is_ring(wheel) ? 1 : -1; }
  // Where the tip circle (of a rack, the tip line) cuts the line of centres in the mesh, and the root circle.
  Place tip_at_mesh(int wheel) const;
  Place root_at_mesh(int wheel) const;
  double rim() const { return 2.5 * m(); }  // how thick the rim of a ring or rack is drawn, beyond its root
  Place at(double xi) const { return {xi * along.x, xi * along.y}; }

  // Both tips reach the line of action, and contact begins before it ends.
  bool has_contact() const { return A && E && *A < *E; }
  bool is_whole() const { return is_known && !begins.is_short() && !ends.is_short(); }
  std::string name_of_path() const { return begins.letters() + ends.letters(); }  // "F_{1}E"
  // Between B and D one pair of teeth carries alone, before and after them two.
  bool has_single_contact() const;
  double B() const { return ends.xi - base_pitch; }
  double D() const { return begins.xi + base_pitch; }
  // A place of contact to draw the teeth at: P0 when contact passes it, else the middle of its path.
  double shown_contact() const;
  bool has(geometry::Fault::Kind kind, int wheel = 0) const;
};

// A number to so many figures.
Words written(double value, int significant = 4);
// A length: "23.63", in millimetres.
inline Words in_mm(double metres, int significant = 4) { return written(1000 * metres, significant); }

}  // namespace epure::gear_pair
