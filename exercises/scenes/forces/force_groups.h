// What acts on the links of a scene under loads, group after group in the order in which the forces are found: from
// the last group to the drive. Which forces, known or sought, about which points their moments are taken, in which
// order their polygons have them. Their letters and quantities; no numbers.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "exercises/kit/statement/quantity.h"
#include "exercises/scenes/scene.h"

namespace epure::scenes {

// A force on a link; the numbers are those of the linkage.
struct ActingForce {
  enum class Kind {
    load,      // as the loads
    weight,    // of a link's mass: as the masses
    inertia,   // the same
    hinge,     // as the hinges of JointForces
    tooth,     // of wheels that mesh: as the linkage's gears
    pin,       // of a slot on the pin in it: as the linkage's pins
    guide,     // of a guide on a block: as its blocks
    slid,      // of a drive that slides a point: as the drives
    cylinder,  // of a cylinder: as the drives
    held       // all that holds a point which no link brings along as it is placed: the point
  };
  Kind kind;
  int which;
  int link;                       // nothing: on the pin of a point alone
  bool is_opposite = false;       // of what is reported
  int point = geometry::nothing;  // where it acts; of a load, and of guides, they tell

  bool is_same(const ActingForce& other) const { return kind == other.kind && which == other.which; }
};
// Of one link on another, by whose numbers it is called.
inline bool is_of_links(const ActingForce& force) {
  return force.kind == ActingForce::Kind::hinge || force.kind == ActingForce::Kind::tooth;
}
// At the centre of a link's mass.
inline bool is_of_mass(const ActingForce& force) {
  return force.kind == ActingForce::Kind::weight || force.kind == ActingForce::Kind::inertia;
}
struct ActingCouple {
  enum class Kind { load, inertia, guide, drive, hinge };  // the last of friction, as the hinges of JointForces
  Kind kind;
  int which;
  bool is_opposite = false;
};

// About a point, or that through which a line of a link is given.
struct About {
  int point = geometry::nothing, line = geometry::nothing;
};
struct Arm {
  ActingForce force;
  Quantity length;
};
// The part of a rod's force on its pin that is square to the rod.
struct AcrossRod {
  ActingForce force;
  int pin, joint;
};
// The moments of all that acts on a link, and what they give.
struct Moments {
  int link;
  About about;
  std::vector<Arm> arms;
  std::vector<ActingCouple> couples;
  std::variant<AcrossRod, ActingCouple, Arm> sought;
};

// All of it, or of a rod's force on its pin the part square to the rod, or along it.
enum class ForcePart { whole, across, along };
struct ForceSide {
  ActingForce force;
  ForcePart part = ForcePart::whole;
  bool is_unknown = false;
  std::string direction = {};
  // The line of an unknown one: from one point to another, or square to a line of a link or along it.
  int from = geometry::nothing, to = geometry::nothing, line = geometry::nothing;
  bool is_square = false;
  bool is_along_action = false;  // turned from its direction by the pressure angle
};
// right + left = 0, as force_polygon has them. The first side of the group stands on the left and at the beginning.
struct ForceLoop {
  std::string letter;
  std::vector<ForceSide> left, right;
  // Forces that the closed polygon shows beside, between two of its corners: 0 the origin, and one after each side of
  // the right.
  struct Between {
    ActingForce force;
    std::size_t from, to;
    bool is_sum;  // of the two parts of a rod's force; or it closes the forces on a link
  };
  std::vector<Between> between = {};
};

struct LinkForces {
  int link;  // nothing: a pin alone
  std::vector<ActingForce> known, sought;
  std::vector<ActingCouple> couples;
};

struct GroupForces {
  std::size_t step;
  std::vector<LinkForces> bodies;
  std::vector<Moments> moments;
  std::vector<ForceLoop> loops;
  // Links without loads, whose forces so run along the line of their hinges, and their two points.
  struct Strut {
    int link, from, to;
  };
  std::vector<Strut> struts = {};
  // Pins and blocks on lines without friction: what is pressed on, and the line.
  struct Pressed {
    ActingForce force;
    int line;
  };
  std::vector<Pressed> pressed = {};
  std::vector<ActingForce> teeth = {};  // that are sought, on the wheel
};

// Of the groups that bear anything; none without loads.
std::vector<GroupForces> force_groups(const Built& built);

// Which links a force of two is of: the first as the linkage has it, and the one that it acts on there.
struct TwoLinks {
  int by, on;
  int other(int link) const { return by == link ? on : by; }
};
TwoLinks links_of(const geometry::Linkage& linkage, const ActingForce& force);

// What holds a point that no link brings along as it is placed: R_A is their sum.
std::vector<ActingForce> forces_that_hold(const Built& built, int point);

}  // namespace epure::scenes
