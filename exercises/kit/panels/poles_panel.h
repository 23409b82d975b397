// Vectors at the points of a moving plane, laid off from its pole: velocities square to the rays from the velocity
// pole, accelerations at one angle to the rays from the acceleration pole.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "exercises/kit/panels/mechanism_figure.h"
#include "exercises/kit/panels/panel.h"
#include "exercises/kit/proof/solution.h"

namespace epure {

// A step, and what of the picture it is about.
struct PolesStep {
  enum class Where { nowhere, point, ray, tip, pole };
  Words text;
  Where where = Where::nowhere;
  std::string of = {};  // the point; its ray to the pole, or the tip of its vector
};

class PolesPanel : public Panel {
 public:
  struct Kind {
    std::string pole;     // in names of quantities: "P0"
    std::string letters;  // "$P_{0}$"; none: the point of the mechanism that it is bears them
    Meaning ink = Meaning::locus;
    VectorQuantity (*vector)(const std::string& of) = velocity;
    double longest_on_paper = 60;  // mm
    double times_smaller = 12;     // the plane may be drawn to show the pole
    std::string prefix = {};       // of all names, for a case of the exercise: "dead_centre_folded."
  };
  static Kind of_velocity(const std::string& pole);
  static Kind of_acceleration();  // K

  // `points`: of the plane, those whose vectors are drawn.
  PolesPanel(const Solution& solution, std::shared_ptr<const MechanismFigure> mechanism, Kind kind,
             const std::vector<std::string>& points, std::vector<PolesStep> steps);

  // Without supports and arrows, where the mechanism is small beside its pole.
  PolesPanel& sketched();
  // The pole lies on the line through the vectors' tips, not only on the rays.
  PolesPanel& by_the_tips();
  // The pole is where these lines meet, each through two points (a fixed one and one of the plane), and square to the
  // path of the second. Of velocities only; without it the rays of all points are such lines.
  PolesPanel& on_lines(std::vector<std::pair<Place, std::string>> lines);
  // Coordinates count from this point, and not from the mechanism's first corner.
  PolesPanel& coordinates_from(const Place& origin) {
    origin_ = origin;
    return *this;
  }
  // The plane turns: an arc arrow about the pole.
  PolesPanel& turning(double sense, const std::string& symbol);
  // The velocities, measured, are held against this rate (an angular velocity) times the distances from the pole.
  PolesPanel& compared_with(double rate, const std::string& symbol);

  double reach() const override { return mechanism_->reach(); }
  Vectors vectors() const override;
  double times_smaller() const override { return has_far_pole() ? kind_.times_smaller : 1; }
  drawings::Box extent(const Scale& lengths, const Scale& vectors) const override;
  drawings::Box extent_of_near(const Scale& lengths, const Scale& vectors) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override;
  void draw_given(Plot& plot, const drawings::Box& room, Language language) const override;
  std::vector<double> crossings() const override;
  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box& room) const override;
  std::optional<MeasuredTable> measured(const Readings& readings) const override;

 private:
  struct Carried {
    std::string name;
    Place at;
    VectorQuantity quantity;
    Arrow2 v;
  };

  bool is_of_velocity() const { return kind_.ink == Meaning::locus; }
  bool has_far_pole() const;  // and not too far for any sheet
  bool shows_pole(const Plot& plot, const drawings::Box& room) const;
  std::string name_of_ray(const std::string& X) const { return kind_.prefix + kind_.pole + X; }
  const Carried& carried(const std::string& name) const;
  bool is_on_a_line(const Carried& X) const;
  // Towards the pole, wherever it is: across the velocity where it is at infinity.
  Arrow2 towards_pole(const Carried& X) const;
  Place end_of_ray(const Carried& X, const Plot& plot, const drawings::Box& room) const;

  void draw_rays(Plot& plot) const;
  void draw_leaving_rays(Plot& plot, const drawings::Box& room, Language language) const;
  void draw_pole(Plot& plot) const;
  void draw_turning(Plot& plot) const;
  void mark_inclination(Plot& plot, const Carried& X) const;

  std::shared_ptr<const MechanismFigure> mechanism_;
  Kind kind_;
  std::vector<Carried> points_;
  std::vector<std::string> reported_points_, reported_rays_;
  std::vector<PolesStep> steps_;
  std::optional<Place> pole_;  // none at infinity
  Place origin_;
  std::vector<std::pair<Place, std::string>> lines_;
  bool reports_pole_ = false, is_sketched_ = false, is_by_the_tips_ = false;
  std::optional<double> rate_;
  std::string rate_symbol_, turning_symbol_;
  double sense_ = 0;
};

}  // namespace epure
