// Inflection and stationarity circle of a moving plane, and the acceleration pole K where they meet again. Drawn is
// how they are built: by Euler and Savary a point X' on the ray of each of two points X of which the path is known,
// where the perpendiculars to the rays meet the inflection pole J; and by A", where the acceleration along the path
// is zero, the end S' of the stationarity circle's diameter.
#pragma once

#include "exercises/kit/panels/cut_panel.h"

namespace epure {

class CirclesPanel : public CutPanel {
 public:
  // A point of the plane, and the centre of curvature of its path: a hinge of the frame; none for a straight path.
  struct Known {
    std::string point;        // "A"
    std::string centre = {};  // "A0"
    bool is_pole = false;     // a dead centre: it stands still
  };
  struct Case {
    std::string pole;               // in names of quantities: "P0"
    Known driven, other;            // the acceleration of the driven one is known
    bool driven_speeds_up = false;  // it is accelerated along its path
    std::string prefix = {};        // of all names, for a case of the exercise: "dead_centre_folded."
  };
  // The solution holds pole, K, both circles, the points and centres; and, for drawing, of circles "_nearest" and
  // "_along", of the points "Aprime", of the driven one "Adoubleprime" (see coupler_routes.h).
  CirclesPanel(const Solution& solution, std::shared_ptr<const MechanismFigure> mechanism, const Case& of);

  // The inflection circle is so many times larger than the mechanism that this needs a picture of its own.
  bool needs_detail(double too_large = 2.5) const;
  // The picture of the mechanism, the stationarity circle and K beside that of the whole inflection circle, each with
  // its own steps.
  CirclesPanel& detail();
  CirclesPanel& beside_detail();

  double reach() const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override;
  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box& room) const override;
  std::vector<Place> lettered() const override;

  // What the column tells of them: the points, and both diameters.
  static std::vector<std::pair<std::string, std::string>> points(const std::string& pole,
                                                                 const std::string& prefix = {});

 private:
  struct Builder {
    Known known;
    std::string letters, centre_letters;  // within mathematics: "A", "A_{0}"
    Place at;
    std::optional<Place> prime;  // X'; X itself on a straight path, and where X is the pole
    bool is_straight() const { return known.centre.empty(); }
    bool has_prime() const { return !is_straight() && !known.is_pole; }
  };

  // Beside its detail the mechanism may be smaller.
  double far() const override { return shows_ == Shows::inflection_circle ? far_of_overview : 7; }
  drawings::Box covered(const Scale& lengths, double points, double circles) const override;

  Builder builder(const Solution& solution, const Known& known) const;
  std::string pole_letters() const;
  bool translates() const { return !P0_; }
  bool is_steady() const { return P0_ && !S_; }  // α = 0: the stationarity circle is the line P₀J

  void draw_builder(Plot& plot, const drawings::Box& room, const Builder& X, Language language) const;
  void draw_inflection_circle(Plot& plot, const drawings::Box& room, Language language) const;
  void draw_stationarity_circle(Plot& plot, const drawings::Box& room, Language language) const;
  void name_circle(Plot& plot, const drawings::Box& room, const DrawnCycle& circle, const Words& name,
                   Language language) const;
  void sketch_mechanism(Plot& plot) const;
  void draw_poles(Plot& plot) const;
  std::string left_out(const Plot& plot, const drawings::Box& room, Language language) const;

  PanelStep step_to_prime(const Plot& plot, const drawings::Box& room, const Builder& X) const;
  PanelStep step_to_J(const Plot& plot, const drawings::Box& room) const;
  PanelStep step_to_S(const Plot& plot, const drawings::Box& room) const;
  std::vector<PanelStep> steps_to_lines() const;

  enum class Shows { all, inflection_circle, detail } shows_ = Shows::all;
  Case case_;
  std::optional<Place> P0_, J_, K_, F_, S_, S_prime_, A_double_;
  DrawnCycle inflection_, stationarity_;
  Builder driven_, other_;
};

}  // namespace epure
