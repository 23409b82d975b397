// The vector equations of a scene's groups of links, as they are drawn: which vectors, in which order, what is known
// of them. Their letters and quantities; no numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exercises/kit/statement/quantity.h"
#include "exercises/scenes/scene.h"

namespace epure::scenes {

// Where a vector comes from that is not the velocity or acceleration of a point of the mechanism. The numbers are
// those of the linkage.
struct VectorSource {
  enum class Kind {
    // Of `link` at the place of `point`.
    on_link_velocity,
    on_link_acceleration,
    // The same, seen from the link's point `about`.
    rod_velocity,
    rod_normal,
    rod_tangential,
    // Of `point`, which slides in `line` of `link`.
    sliding_velocity,
    sliding_acceleration,
    coriolis,
    // Of `point`, the far end of the cylinder `drive` from `about`: along it and across it.
    stretch_velocity,
    swing_velocity,
    stretch_acceleration,
    stretch_normal,
    stretch_coriolis,
    swing_acceleration
  };
  Kind kind;
  int point;
  int link = geometry::nothing, about = geometry::nothing, line = geometry::nothing, drive = geometry::nothing;
};

struct Term {
  VectorQuantity quantity;
  std::string direction, magnitude;              // as a side of a polygon has them (polygon_picture.h)
  std::string tip = {};                          // letters at its end
  std::optional<VectorSource> source = {};       // none: of a point of the mechanism
  std::string across_from = {}, across_to = {};  // of an unknown one: its line is square to this
  std::string along_line = {};                   // ... or along this line of a link
  bool is_square = false, is_subtracted = false;
  std::string found_before = {};  // a point: it is its vector, of another polygon
};

// Another point of a link of which two points have their images already.
struct Image {
  std::string point;
  std::string body;               // letters of the three: "ABC"
  std::string first, base, last;  // ... and of their images: empty where the first one rests, "b'", "c'"
  bool is_in_line = false;        // the three points are
};

struct DyadEquation {
  std::string joint;           // whose vectors it finds
  bool is_joint_found = true;  // and they were not known before: of a pin that leads a slotted link they were
  std::vector<Term> v_left, v_right, a_left, a_right;
  std::vector<Image> images;
  std::vector<std::string> sums;  // points whose whole vectors are drawn, as no side is one
  std::vector<int> links;         // that it places, as the file numbers them
  std::vector<std::string> rates_from_velocities, rates_from_accelerations;  // "|$ω_{3}$| = $v_{BA}$ / $AB$"
  struct TurningRod {
    int link;  // as the file numbers it
    std::string from, to;
  };
  std::vector<TurningRod> rods;  // of which it finds how they turn
};

inline std::string in_mathematics(const std::string& letters) { return "$" + letters + "$"; }

// In the order of the construction; steps without an equation of their own have none.
std::vector<DyadEquation> dyad_equations(const Built& built);

// All vectors of the equations that have a source, each once.
std::vector<Term> relative_vectors(const std::vector<DyadEquation>& equations);

}  // namespace epure::scenes
