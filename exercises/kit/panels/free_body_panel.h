// A body cut free, or a whole mechanism, with all that acts on it: forces on their lines of action, couples by their
// sense. The arrows are of one length, and how large the forces are, their polygons show; or they are to scale.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "exercises/kit/panels/mechanism_figure.h"
#include "exercises/kit/panels/panel.h"
#include "exercises/kit/panels/polygon_picture.h"

namespace epure {

class FreeBodyPanel : public Panel {
 public:
  explicit FreeBodyPanel(std::shared_ptr<const MechanismFigure> body) : body_(std::move(body)) {}

  // A force of a polygon, where it acts; none when it is zero. What presses on the body from outside ends there, or
  // before the hinge there, which would hide its head.
  enum class Arrow { starts, ends, ends_at_hinge };
  FreeBodyPanel& force(const PolygonSide& side, const Place& at, Arrow there = Arrow::starts);
  // The same of what is given, and stands on the sheet to be solved too: a load; and of an effort that balances it,
  // the line of action.
  FreeBodyPanel& load(const PolygonSide& side, const Place& at, Arrow there = Arrow::starts);
  FreeBodyPanel& effort(const PolygonSide& side, const Place& at, Arrow there = Arrow::starts);
  // At the scale of the sheet's forces, in this unit: a ruler reads them. All such bodies have one scale of lengths.
  FreeBodyPanel& to_scale(const std::string& unit = "N");
  // The bodies no larger than so many millimetres a metre: their forces are what is to be seen.
  FreeBodyPanel& at_most(double mm_per_metre);
  // The body at a scale of lengths of its own: a part that would be too small at that of the others.
  FreeBodyPanel& larger();
  // Where lines of action meet, as the quantities name_x and name_y (empty: none report it): the lines are drawn as
  // far as there, or as the paper reaches.
  FreeBodyPanel& meeting(const std::string& name, const std::string& letters, const std::optional<Place>& H);
  // The lines of action in another motion, dashed, with where they meet there: as far as it, or a piece of each about
  // its point where they do not meet. `makes_room`: the bodies are as small as it takes to show where they meet.
  struct LineOfForce {
    Place at;
    Arrow2 along;
  };
  FreeBodyPanel& otherwise(const std::string& name, const std::string& letters, const std::optional<Place>& H,
                           const std::vector<LineOfForce>& lines, bool makes_room = true);
  // The friction circle of a hinge in X, which a force's line touches in T, and its radius with its letters.
  FreeBodyPanel& friction_circle(const Place& X, const Place& T, const std::string& letters);
  // How the body slides in X on what presses on it there, `from` outside: an arrow beside the surface, of one length.
  FreeBodyPanel& sliding(const Place& X, const Arrow2& v, const Arrow2& from, const std::string& letters);
  // A line of a construction on the body, with what it is called at its end: a string of a funicular polygon.
  FreeBodyPanel& string(const Place& from, const Place& to, const std::string& letters);
  // The line from a point to another, with its name: as far as the paper reaches, where the other is off it.
  FreeBodyPanel& line_to(const Place& from, const Place& to, const std::string& letters);
  // The force of a contact in X, turned from the normal there by an angle: the normal with its letters, the angle
  // with its name, and the other edge of the cone where it is one of friction. Directions (radians) from X to where
  // the force stands.
  FreeBodyPanel& turned(const Place& X, double normal, double force, const std::string& angle,
                        const std::string& letters = {}, bool is_cone = true);
  // How far a line of action passes by a point: the perpendicular with its name, measured as this quantity
  // where it is reported (else empty). Its dimension line stands so many mm to its left, as seen from `about`, clear
  // of another arm.
  FreeBodyPanel& arm(const Place& about, const Place& on_line, const Arrow2& along, const std::string& letters,
                     const std::string& quantity, double left = 0);
  // Another step of the construction, and where it happens.
  FreeBodyPanel& step(const Words& text, const Place& at);
  // Counter-clockwise for sense > 0, clockwise for sense < 0, none for 0. It stands clear of the forces at this point
  // and of these directions (radians).
  FreeBodyPanel& couple(const std::string& label, const Place& about, double sense,
                        const std::vector<double>& clear_of = {});
  // A step at the arc of a couple about this point, by its label.
  FreeBodyPanel& step_at_couple(const Words& text, const Place& about, const std::string& label);
  // An equation of moments, about a point.
  FreeBodyPanel& moments(const Words& text, const Place& about);

  double reach() const override;
  std::string scale_group() const override { return unit_.empty() ? "" : is_larger_ ? "bodies, larger" : "bodies"; }
  Vectors vectors() const override;
  bool shows_directions_only() const override { return unit_.empty() && !forces_.empty(); }
  double times_smaller() const override { return unit_.empty() ? 1 : 2.2; }
  drawings::Box extent(const Scale& lengths, const Scale& vectors) const override;
  drawings::Box extent_of_near(const Scale& lengths, const Scale& vectors) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language) const override;
  void draw_given(Plot& plot, const drawings::Box&, Language) const override;
  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box& room) const override;

 private:
  enum class Given { nothing, line, all };
  struct Force {
    std::string label;
    Place at;
    Arrow2 along;  // unit vector
    double size;
    int after;  // another force, which would cover it: it stands behind that one
    bool ends;
    double clear;  // mm from the point
    std::string quantity;
    Given given;
    std::optional<double> value;
  };
  // On paper, mm from the point along the force.
  struct OnPaper {
    double tail, tip;
  };
  struct String {
    Place from, to;
    std::string letters;
  };
  struct Line {
    Place from, to;
    std::string letters;
  };
  struct Otherwise {
    std::string name, letters;
    std::optional<Place> H;
    std::vector<LineOfForce> lines;
    bool makes_room;
  };
  struct FrictionCircle {
    Place X, T;
    std::string letters;
  };
  struct Sliding {
    Place X;
    Arrow2 along, from;  // unit vectors
    std::string letters;
  };
  struct Turned {
    Place X;
    double normal, force;
    std::string angle, letters;
    bool is_cone;
  };
  struct Arm {
    Place about, on_line, foot;
    std::string letters, quantity;
    double left;
  };
  struct Meeting {
    std::string name, letters;
    Place H;
  };
  struct Couple {
    std::string label;
    Place about;
    double sense;
    std::vector<double> clear_of;
  };

  FreeBodyPanel& add(const PolygonSide& side, const Place& at, Arrow there, Given given);
  bool is_line_otherwise(const Place& X, double direction) const;
  double middle_of(const Couple& couple) const;
  double radius_of(const Couple& couple) const;  // mm
  ArcArrow arc_of(const Couple& couple) const;
  static double radius_of(const Turned& turned);  // mm
  static double leg_of(const Turned& turned);     // mm
  std::string letters_of(const Force& force, const Scale& vectors, Language language) const;
  double length_of(const Force& force, const Scale& vectors) const;
  OnPaper on_paper(const Force& force, const Scale& vectors) const;
  void draw_force(Plot& plot, const Force& force, Language language) const;
  void draw_line_of_action(Plot& plot, const Force& force) const;
  void draw_turned(Plot& plot, const Turned& turned) const;
  void draw_arm(Plot& plot, const Arm& arm) const;
  static void draw_friction_circle(Plot& plot, const FrictionCircle& circle);
  static void draw_sliding(Plot& plot, const Sliding& sliding);
  static void draw_otherwise(Plot& plot, const drawings::Box& room, const Otherwise& motion, Language language);
  void draw_meeting(Plot& plot, const drawings::Box& room, const Meeting& meeting, Language language) const;

  std::shared_ptr<const MechanismFigure> body_;
  std::vector<Force> forces_;
  std::vector<Couple> couples_;
  std::vector<Meeting> meetings_;
  std::vector<String> strings_;
  std::vector<Line> lines_;
  std::vector<Turned> turned_;
  std::vector<Sliding> sliding_;
  std::vector<Otherwise> otherwise_;
  std::vector<FrictionCircle> circles_;
  std::vector<Arm> arms_;
  std::vector<PanelStep> steps_;
  struct StepAtCouple {
    std::size_t step;
    Place about;
    std::string label;
  };
  std::vector<StepAtCouple> steps_at_couples_;
  std::string unit_;  // of forces to scale
  double least_reach_ = 0;
  bool is_larger_ = false;
};

}  // namespace epure
