// Vectors at the points of a moving plane, laid off from its pole: velocities square to the rays from the velocity
// pole, accelerations at one angle to the rays from the acceleration pole.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exercises/kit/panels/mechanism_figure.h"
#include "exercises/kit/panels/panel.h"
#include "exercises/kit/proof/solution.h"

namespace epure {

class PolesPanel : public Panel {
 public:
  struct Kind {
    std::string pole;     // in names of quantities: "P0"
    std::string letters;  // "$P_{0}$"
    Meaning ink = Meaning::locus;
    VectorQuantity (*vector)(const std::string& of) = velocity;
    double longest_on_paper = 60;  // mm
    double farthest = 12;          // times the mechanism's reach: a pole beyond is not drawn
  };
  static Kind of_velocity(const std::string& pole);
  static Kind of_acceleration();  // K

  // `points`: of the plane, those whose vectors are drawn.
  PolesPanel(const Solution& solution, std::shared_ptr<const MechanismFigure> mechanism, Kind kind,
             const std::vector<std::string>& points, std::vector<PanelStep> steps);

  // Without supports and arrows, where the mechanism is small beside its pole.
  PolesPanel& sketched();
  // The pole lies on this line through the vectors' tips, not only on the rays.
  PolesPanel& by_the_tips();

  // The velocities, measured, are held against this rate (an angular velocity) times the distances from the pole.
  PolesPanel& turning_at(double rate, const std::string& symbol);

  // Whether the pole exists, and is near enough to be drawn.
  static bool shows_pole(const Solution& solution, const MechanismFigure& mechanism, const Kind& kind);

  double reach() const override { return mechanism_->reach(); }
  Vectors vectors() const override;
  drawings::Box extent(const Scale& lengths, const Scale& vectors) const override;
  void draw(Plot& plot, const drawings::Box& room, Language language) const override;
  std::vector<PanelStep> steps(const Plot&) const override { return steps_; }
  std::optional<MeasuredTable> measured(const Readings& readings) const override;

 private:
  struct Carried {
    std::string name;
    Place at;
    VectorQuantity quantity;
    Arrow2 v;
  };

  bool is_of_velocity() const { return kind_.ink == Meaning::locus; }
  void draw_rays(Plot& plot) const;
  void draw_leaving_rays(Plot& plot, const drawings::Box& room) const;
  void draw_pole(Plot& plot) const;
  void mark_inclination(Plot& plot, const Carried& X) const;

  std::shared_ptr<const MechanismFigure> mechanism_;
  Kind kind_;
  std::vector<Carried> points_;
  std::vector<std::string> reported_;  // of the pole's distances
  std::vector<PanelStep> steps_;
  std::optional<Place> pole_;  // when it is drawn
  bool is_sketched_ = false, is_by_the_tips_ = false;
  std::optional<double> rate_;
  std::string rate_symbol_;
};

}  // namespace epure
