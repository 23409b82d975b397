// A mechanism as points, bodies and joints, ready to be drawn: whatever it is, by the places its solution found.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "exercises/kit/panels/mechanism_figure.h"

namespace epure {

class Mechanism : public MechanismFigure {
 public:
  enum class Joint {
    none,   // a point of a body: a dot
    hinge,  // between two bodies
    fixed,  // a hinge on the frame
    block,  // a hinge on a block that slides on the frame
    mass,   // no joint: a point of a body in which its mass is
    corner  // of an outline: nothing is drawn there
  };

  // A point under its letters, which are rich text. Panels measure coordinates from the first one.
  Mechanism& point(const std::string& name, const Place& at, Joint joint, const std::string& letters);
  // A link between two points, or a plate between three and more. With a number it stands beside the link, and the
  // frame is 1.
  Mechanism& body(const std::vector<std::string>& points, int number = 0);
  // A straight link through these points, the last of them the pin of another body that runs in a slot of it, or the
  // hinge of a block that does. `letter`: of the slot's line, at its end.
  Mechanism& slotted(const std::vector<std::string>& points, int number = 0, bool takes_block = false,
                     const std::string& letter = {});
  // A cylinder hinged at `from`, and its piston's rod hinged at `to`.
  Mechanism& cylinder(const std::string& from, const std::string& to);
  // A round body about a point, with another on its rim; there it `rolls` on the frame, or not.
  Mechanism& disc(const std::string& centre, const std::string& rim, bool rolls, int number = 0);
  // A surface of the frame, hatched on the right of from -> to.
  Mechanism& surface(const Place& from, const Place& to);
  // A round profile of a body: an arc, counter-clockwise (radians).
  Mechanism& profile(const Place& centre, double radius, double from, double to);
  // The same in another position: dashed, and kept clear of like the links.
  Mechanism& other_position(const std::vector<std::string>& points);
  // These points are found in a step of the construction, and what joins them comes with it. (On a sheet to be solved
  // they stand all the same, unless the panel leaves them out.)
  Mechanism& found_in(int step, const std::vector<std::string>& points);
  // The guide of a block, along this direction (radians), with the name of its axis ahead of it; or with its letter
  // at its end.
  Mechanism& guide(const std::string& block, double direction, const std::string& axis = {},
                   const std::string& letter = {});
  // The blocks of its guides are outlines, where curves pass beneath them.
  Mechanism& with_open_blocks();
  // `of` goes round `about`: its way is drawn.
  Mechanism& path(const std::string& about, const std::string& of);
  // `of` swings about `about`: its way is drawn, from so far behind where it is to so far ahead (radians);
  // as far as ever told.
  Mechanism& swing(const std::string& about, const std::string& of, double from, double to);
  // The ways told so far are left out, where vectors along them would hide in them.
  Mechanism& without_ways();
  // Its links without numbers, where others stand.
  Mechanism& unnumbered();
  // An arc arrow at the link from `about` to `of`: counter-clockwise (sense > 0), clockwise, or none (0).
  Mechanism& turning(const std::string& about, const std::string& of, double sense, const std::string& symbol);
  // The same of a rate that the exercise finds.
  Mechanism& turning_found(const std::string& about, const std::string& of, double sense, const std::string& symbol);
  // A line of centres, a little beyond both ends, with what it is written at the second.
  Mechanism& axis(const Place& from, const Place& to, const std::string& name = {});
  // How far a point lies from a line, of which `foot` is the foot of the perpendicular: dimensioned `clear` metres
  // and some millimetres away, in this direction (radians) along the line.
  Mechanism& offset(const std::string& point, const Place& foot, double direction, double clear,
                    const std::string& symbol);
  // An angle at a point, from one direction to another (radians), marked where there is room for it.
  Mechanism& angle(const std::string& at, double from, double to, const std::string& symbol);
  // The angle of the direction from `at` to `of`, counter-clockwise from +x, in (-π, π]: an arc arrow.
  Mechanism& angle_from_x(const std::string& at, const std::string& of, const std::string& symbol);
  // A right angle at a point, between the directions to two others.
  Mechanism& right_angle(const std::string& at, const std::string& one, const std::string& other);

  const Place& at(const std::string& name) const { return find(name).at; }
  bool has_bodies() const { return !bodies_.empty(); }

  void draw(Plot& plot) const override;
  void draw_given(Plot& plot) const override;
  void sketch(Plot& plot) const override;
  void include(Extent& extent, const Scale& scale) const override;
  std::vector<Place> corners() const override;
  double reach() const override;

 private:
  struct Point {
    std::string name;
    Place at;
    Joint joint;
    std::string letters;
  };
  struct Body {
    std::vector<std::string> points;
    int number;
    bool is_slotted, is_cylinder = false;
    bool takes_block = false;
    std::string letter = {};
  };
  struct Disc {
    std::string centre, rim;
    bool rolls;
    int number;
  };
  struct Axis {
    Place from, to;
    std::string name;
  };
  struct Guide {
    std::string block;
    double direction;
    std::string axis, letter;
  };
  struct Path {
    std::string about, of;
  };
  struct Swing {
    std::string about, of;
    double from, to;
  };
  struct Surface {
    Place from, to;
  };
  struct Profile {
    Place centre;
    double radius, from, to;
  };
  struct Turning {
    std::string about, of;
    double sense;
    std::string symbol;
    bool is_given = true;
  };
  struct Offset {
    std::string point;
    Place foot;
    double direction, clear;
    std::string symbol;
  };
  struct Angle {
    std::string at;
    double from, to;
    std::string symbol;
    bool is_directed = false;
  };
  static double radius_of(const Angle& angle);  // mm
  struct RightAngle {
    std::string at, one, other;
  };

  const Point& find(const std::string& name) const;
  // Of what joins these points: the last in which one of them is found; none where all are given.
  void begin_step_of(Plot& plot, const std::vector<std::string>& points) const;
  Place middle() const;
  // The other end of the first link at a point.
  Place neighbour(const Point& P) const;
  std::vector<std::pair<Place, Place>> edges(const std::vector<Body>& bodies) const;
  // Where the hatched support of a fixed hinge stands: below, or where the links leave it the most room.
  double direction_of_support(const Point& P, const Scale& scale) const;
  // Of all links at a point, away from it.
  std::vector<double> directions_at(const std::string& point) const;
  double radius(const Disc& disc) const { return distance(at(disc.centre), at(disc.rim)); }
  // The ends of a slot's middle line.
  std::pair<Place, Place> slot(const Body& body, const Scale& scale) const;
  void include_discs(Extent& extent, const Scale& scale) const;
  void include_arcs(Extent& extent, const Scale& scale) const;
  void draw_guide(Plot& plot, const Guide& guide) const;
  void draw_offset(Plot& plot, const Offset& offset) const;
  void draw_discs(Plot& plot) const;
  void draw_surface(Plot& plot, const Disc& disc) const;
  void draw_axes(Plot& plot) const;
  void draw_bodies(Plot& plot) const;
  void draw_cylinder(Plot& plot, const Body& body) const;
  void draw_joint(Plot& plot, const Point& P) const;
  void draw_angle(Plot& plot, const Angle& angle) const;
  void draw_turning(Plot& plot, const Turning& each) const;
  void draw_letters(Plot& plot, const Point& P) const;
  void draw_numbers(Plot& plot) const;

  std::vector<Point> points_;
  std::map<std::string, int> steps_;  // of the points that a construction finds
  std::vector<Body> bodies_, other_positions_;
  std::vector<Disc> discs_;
  std::vector<Guide> guides_;
  bool has_open_blocks_ = false;
  std::vector<Path> paths_;
  std::vector<Swing> swings_;
  std::vector<Surface> surfaces_;
  std::vector<Profile> profiles_;
  std::vector<Turning> turnings_;
  std::vector<Axis> axes_;
  std::vector<Offset> offsets_;
  std::vector<Angle> angles_;
  std::vector<RightAngle> right_angles_;
};

}  // namespace epure
