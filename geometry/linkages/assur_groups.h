// In which order ruler and compass place the links of a linkage: Assur's groups of one or two links, each on what
// stands already. What moves only together in larger groups (a triad) is not placed by ruler and compass alone, and
// is refused by name.
//
//   step            what is placed                                                       by
//   TurnedCrank     a link on a hinge, its angle given                                   the angle
//   GearedWheel     a link on a hinge, its angle given by gears and drives               the angle
//   RolledWheel     a link on a hinge that rolls on a line                               a length over its radius
//   SlidBlock       a link in a guide, its place given                                   a length set off
//   SlidPin         a point in a slot, its place given                                   the same
//   TwoRods         RRR: the joint of two rods (one may be a cylinder)                   two circles
//   RodAndTrack     RRP: a joint on a rod and on a track                                 a circle and a line
//   TwoTracks       PRP: a joint on two tracks                                           two lines
//   SlotOnPin       RPR: a link on a hinge whose line runs over a pin                    a tangent to a circle
//   BlockOnPin      a link in a guide whose line runs over a pin                         a parallel
//   CrossedBlock    RPP: a link on a hinge, and a block in its line and in another guide a parallel and two lines
#pragma once

#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "geometry/constructions/circle.h"
#include "geometry/linkages/linkage.h"

namespace epure::geometry {

// What keeps a joint at a distance from the point `pin`, which is placed: a link that has both, or a cylinder.
struct Rod {
  int pin;
  int link = nothing;
  int cylinder = nothing;  // which of the drives
};
// A line of a link that is placed, on which a joint moves: the joint's pin runs in it, or a block does that has the
// joint and the line `moving`.
struct Track {
  int line;
  int block = nothing, moving = nothing;
};

struct TurnedCrank {
  int link, hinge, drive;
};
// Of a link that gears and drives turn: its angle is that of the drives, each so many times, and the rest of it.
struct GearedTurn {
  Angle rest;
  std::vector<Rational> times;  // as the drives: of those that turn a link
};
struct GearedWheel {
  int link, hinge;
  GearedTurn turn;
};
// `roll` of the linkage's.
struct RolledWheel {
  int link, hinge, roll;
};
struct SlidBlock {
  Track track;
  int point, drive;
};
struct SlidPin {
  int point, drive;
};
struct TwoRods {
  Rod first, second;
  int joint;
  Side side;  // of the line from the first pin to the second
};
struct RodAndTrack {
  Rod rod;
  Track track;
  int joint;
  Along which;
};
struct TwoTracks {
  Track first, second;
  int joint;
};
// The line runs over the pin, or carries a block that is hinged there.
struct SlotOnPin {
  int link, hinge, line, pin;
  int block = nothing, moving = nothing;
  bool is_towards_pin;
};
struct BlockOnPin {
  Track track;
  int line, pin;
};
// `link` hangs on the hinge, and in its line runs the line `crossing` of the track's block.
struct CrossedBlock {
  int link, hinge, line;
  Track track;
  int crossing;
};
using Step = std::variant<TurnedCrank, GearedWheel, RolledWheel, SlidBlock, SlidPin, TwoRods, RodAndTrack, TwoTracks,
                          SlotOnPin, BlockOnPin, CrossedBlock>;

// How a link hangs that a step places: on a pin, where one of its points is, and (a rod) on the joint that the step
// places; a block that a pin runs over on neither.
struct Hung {
  int link, pin = nothing, joint = nothing;
};
std::vector<Hung> hung_by(const Step& step);
// The links that a step places.
std::vector<int> placed_by(const Step& step);

// Which of two places is meant, where nothing says it. The numbers are those of the linkage.
struct OpenSide {
  enum class Kind {
    beside_line,  // the joint: on which side of from -> to?
    on_guide,     // the joint: ahead or behind on the line?
    along_slot    // the line through `from`: towards `to` or away?
  };
  Kind kind;
  int joint = nothing, from = nothing, to = nothing, line = nothing;
};

// Why a linkage has no such order; the numbers are those of the linkage, for who knows its letters.
struct NotPlaced : std::runtime_error {
  enum class Why {
    overconstrained,    // `links` hang on more than they can follow
    freedom,            // `links` are not held: `freedom` drives are missing
    not_dyadic,         // `links` move only together, on what stands at `points`
    open_sides,         // all of them, in the order of the construction
    contradicting_side  // chosen[chosen] says so of nothing that is open
  };
  explicit NotPlaced(Why why, std::vector<int> links = {}, std::vector<int> points = {});
  Why why;
  std::vector<int> links, points;
  std::vector<OpenSide> sides = {};
  int freedom = 0;
  std::size_t chosen = 0;
};

// Where the drives turn such a link to.
Angle angle_of(const GearedTurn& turn, const Linkage& linkage);

// Throws NotPlaced.
std::vector<Step> assur_groups(const Linkage& linkage);

// The linkage with its sides told in full: with the guide and the bar's other end that a joint on a guide is seen
// from, and the hinge and the pin of a slot.
Linkage with_sides_in_full(Linkage linkage, const std::vector<Step>& steps);

}  // namespace epure::geometry
