// A plane linkage as plain data: rigid links, the joints between them, what drives it, and on which side each joint
// lies where two places are possible. Exact, and nothing but what was stated: both routes read this and nothing of
// each other (assur_groups.h places link after link with ruler and compass, analytic/joint_equations.h solves the
// equations of all joints at once).
//
// Link 0 is the frame, its axes are those of the plane. Every other link is a plate with axes of its own, in which
// its points and lines are given. A point that several links have is a hinge between them. Metres, radians, seconds;
// counter-clockwise positive.
#pragma once

#include <variant>
#include <vector>

#include "geometry/numbers/angle.h"

namespace epure::geometry {

inline constexpr int nothing = -1;  // nor point, line, drive

// In the axes of a link.
struct Own {
  Rational x, y;
};
// The direction of a line in its link: a vector, not zero, of any length, or the angle from the link's x axis.
using Direction = std::variant<Own, Angle>;

// A point of a link; `point` numbers the points of the linkage from 0.
struct LinkPoint {
  int point;
  Own at;
};
// A directed line of a link, a guide or a slot; `line` numbers the lines of the linkage from 0. Each is of one link.
struct LinkLine {
  int line;
  Own through;
  Direction along;
};
struct Link {
  std::vector<LinkPoint> points = {};
  std::vector<LinkLine> lines = {};
};

// A pin that runs in a slot: the point stays on the line of another link.
struct PinOnLine {
  int point, line;
};
// A block in its guide: the line `moving` of one link stays on the line `guide` of another, and points the same way.
// The two links do not turn against each other.
struct LineOnLine {
  int moving, guide;
};
// Two wheels that mesh, both hinged on a third link, the carrier: seen from there they turn in the inverse ratio of
// their teeth (or radii), against each other or, where one lies inside the other, the same way. Where the first one's
// x axis lies on the carrier's, the second one's is turned by the phase from it.
struct MeshingLinks {
  int first, second, carrier;
  Rational first_teeth, second_teeth;
  bool is_inside = false;
  Angle phase = {};
  // Of the line along which teeth press, from the common tangent of the pitch circles; 20 degrees.
  Angle pressure_angle = {Rational(1, 18)};

  // Of the turns seen from the carrier: second = phase - ratio first, inside phase + ratio first.
  Rational turns_of_second() const {
    const Rational ratio = first_teeth / second_teeth;
    return is_inside ? ratio : Rational(-ratio);
  }
};

// A wheel that rolls on a line of another link: other joints keep its centre the radius away from that line, and it
// turns by the way that its centre goes along the line, over the radius. Where the centre is `at` ahead of the point
// that the line is given through, the wheel's x axis is turned by the phase from that of the line's link.
struct RollingWheel {
  int wheel, centre, line;
  Rational radius;  // positive where the centre lies left of the line
  Rational at = 0;
  Angle phase = {};
};

// What drives: each with its rates, of the instant that is looked at.
// The link's x axis is at the angle from the x axis of the frame.
struct TurnedLink {
  int link;
  Angle angle, omega, alpha;
};
// The point's foot on the guide (a line of another link) is `at` ahead of the point that the line is given through.
struct SlidPoint {
  int point, guide;
  Rational at, velocity = 0, acceleration = 0;
};
// A cylinder: the points of two links are `length` apart.
struct Stretched {
  int from, to;
  Rational length, velocity = 0, acceleration = 0;
};
using Drive = std::variant<TurnedLink, SlidPoint, Stretched>;

// Which of two places is meant.
// The joint lies on the left of the line directed from one pin to the other, or on the right.
struct BesideLine {
  int joint, from, to;
  bool is_left;
};
// The joint lies ahead of (behind) the foot of the bar's other end on the guide, seen along the guide.
struct OnGuide {
  int joint;
  bool is_ahead;
  int guide = nothing, other_end = nothing;  // where they are told
};
// The line of a link that hangs on a hinge points from there towards the pin that runs in it, or away from it.
struct SlotPoints {
  int line;
  bool is_towards_pin;
  int hinge = nothing, pin = nothing;  // where they are told
};
using Chosen = std::variant<BesideLine, OnGuide, SlotPoints>;

struct Linkage {
  std::vector<Link> links;  // the frame first
  std::vector<PinOnLine> pins = {};
  std::vector<LineOnLine> blocks = {};
  std::vector<MeshingLinks> gears = {};
  std::vector<RollingWheel> rolls = {};
  std::vector<Drive> drives = {};
  std::vector<Chosen> chosen = {};

  int count_of_points() const;
  int count_of_lines() const;
  // The links that have the point, in their order.
  std::vector<int> links_at(int point) const;
  int link_of_line(int line) const;
  // Both of what a link has: a caller's mistake otherwise (assertion).
  const Own& place(int link, int point) const;
  const LinkLine& line(int line) const;
  // A hinge of both links; none: `nothing`.
  int hinge_of(int one, int other) const;
  // Where two wheels touch, in the axes of their carrier.
  Own pitch_point(const MeshingLinks& gear) const;
  // From the first one's centre to the second one's, the same.
  Own line_of_centres(const MeshingLinks& gear) const;
  // 3 for each moving link, less what joints, gears, rolling and drives take.
  int freedom() const;
  // One drive, a link that turns steadily by so many turns a second: who asks for nothing but signs counts a radian
  // for each 2π of it, and π stays out.
  bool is_turned_steadily() const;
};

}  // namespace epure::geometry
