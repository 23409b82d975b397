// What the sheets show of a pair, in the doubles a drawing takes: found with many bits, rounded once.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exercises/kit/panels/plot.h"
#include "geometry/gears/contact_path.h"
#include "geometry/gears/faults.h"
#include "geometry/gears/gear_pair.h"

namespace epure::gear_pair {

// What `find` returns; none for what does not exist, or cannot be told.
template <class Find>
auto if_there(const Find& find) -> std::optional<decltype(find())> {
  try {
    return find();
  } catch (const geometry::Impossible&) {
    return {};
  } catch (const geometry::Undecided&) {
    return {};
  }
}

// The base tangent length over so many teeth. None of a ring or rack, or when the measuring faces would find no
// flank.
struct BaseTangent {
  long teeth;
  double length;
};

struct DrawnWheel {
  geometry::WheelCircles<double> circles;
  double thickness;                     // on the reference circle
  std::optional<double> tip_thickness;  // none when the tip lies inside the base circle
  std::optional<BaseTangent> base_tangent;
};

// The part of the path of contact on which flanks touch: all of AE, or less where a flank is cut away, ends in the
// rounding at its root, or belongs to pointed teeth.
struct DrawnPath {
  using By = geometry::EndOfContact::By;
  struct End {
    double xi;
    std::string name;  // rich text between dollars: "A", "F_{1}"
    By by = By::tip;
  };
  End begins, ends;
  // False when a wheel has no outline: the ends are then those of whole flanks, which T1 and T2 limit all the same.
  bool known = false;
  bool touches = true;        // flanks do, somewhere
  bool is_continuous = true;  // each pair of teeth touches until after the next has begun to; not known: would, on AE

  bool is_whole() const { return known && begins.by == By::tip && ends.by == By::tip; }
  double length() const { return ends.xi - begins.xi; }
};

// Metres, radians, seconds, in the frame of geometry/gears/gear_pair.h.
struct DrawnPair {
  geometry::PairData of;
  double alpha, alpha_w, centre_distance, pitch, base_pitch;
  DrawnWheel wheel1;
  std::optional<DrawnWheel> wheel2;  // none of a rack, nor O2 and T2
  Place O1;
  std::optional<Place> O2;
  Arrow2 along;  // unit vector of the line of action, as contact travels
  double T1;     // positions on it, signed, from P0
  std::optional<double> T2;
  std::optional<double> A, E;  // none when the tip circle does not reach the line of action
  // What is left of AE; there is one when has_contact().
  DrawnPath path = {};
  double omega_1, omega_2;  // counter-clockwise; of a rack omega_2 is 0
  std::vector<geometry::Fault> faults;

  double m() const { return CGAL::to_double(of.m); }  // module
  bool is_ring() const { return of.kind == geometry::PairKind::internal; }
  bool is_rack() const { return of.kind == geometry::PairKind::rack; }
  Place at(double xi) const { return {xi * along.x, xi * along.y}; }
  // Where the tip circle (of a rack, the tip line) cuts the line of centres in the mesh, and the root circle.
  Place tip_at_mesh(int wheel) const;
  Place root_at_mesh(int wheel) const;
  // Both tips reach the line of action, and contact begins before it ends.
  bool has_contact() const { return A && E && *A < *E; }
  double contact_ratio() const { return (*E - *A) / base_pitch; }  // of whole flanks
  double true_contact_ratio() const { return path.length() / base_pitch; }
  // Between B and D one pair of teeth carries alone, before and after them two.
  bool has_single_contact() const;
  double B() const { return path.ends.xi - base_pitch; }
  double D() const { return path.begins.xi + base_pitch; }
  // A place of contact to draw the teeth at: P0 when contact passes it, else the middle of its path.
  double shown_contact() const;
  bool has(geometry::Fault::Kind kind, int wheel = 0) const;
};

// Throws BadGivens as pair_of does for givens without a pair.
DrawnPair drawn_pair(const geometry::PairData& of, const Angle& speed);

}  // namespace epure::gear_pair
