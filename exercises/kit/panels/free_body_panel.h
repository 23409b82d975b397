// A body cut free, or a whole mechanism, with all that acts on it: forces on their lines of action, couples by their
// sense. The arrows are of one length: how large the forces are, their polygons show.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "exercises/kit/panels/mechanism_figure.h"
#include "exercises/kit/panels/panel.h"
#include "exercises/kit/panels/polygon_picture.h"

namespace epure {

class FreeBodyPanel : public Panel {
 public:
  explicit FreeBodyPanel(std::shared_ptr<const MechanismFigure> body) : body_(std::move(body)) {}

  // A force of a polygon, where it acts; none when it is zero. What presses on the body from outside ends there.
  enum class Arrow { starts, ends };
  FreeBodyPanel& force(const PolygonSide& side, const Place& at, Arrow there = Arrow::starts);
  // Counter-clockwise for sense > 0, clockwise for sense < 0, none for 0. It stands clear of the forces at this point
  // and of these directions (radians).
  FreeBodyPanel& couple(const std::string& label, const Place& about, double sense,
                        const std::vector<double>& clear_of = {});
  // An equation of moments, about a point.
  FreeBodyPanel& moments(const Words& text, const Place& about);

  double reach() const override { return body_->reach(); }
  drawings::Box extent(const Scale& lengths, const Scale&) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language) const override;
  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override { return steps_; }

 private:
  struct Force {
    std::string label;
    Place at;
    Arrow2 along;   // unit vector
    double behind;  // mm from the point to the arrow's tail, against the force when it ends there
    bool ends;
    // On paper, mm from the point along the force.
    double tail() const;
    double tip() const;
  };
  struct Couple {
    std::string label;
    Place about;
    double sense;
    std::vector<double> clear_of;
  };

  double middle_of(const Couple& couple) const;
  void draw_force(Plot& plot, const Force& force) const;

  std::shared_ptr<const MechanismFigure> body_;
  std::vector<Force> forces_;
  std::vector<Couple> couples_;
  std::vector<PanelStep> steps_;
};

}  // namespace epure
