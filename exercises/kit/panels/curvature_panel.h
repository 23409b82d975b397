// Centres of curvature of the paths of points of a moving plane, by Euler and Savary: the rays from the pole to the
// inflection circle, and on them the centres, with the osculating circles and a piece of the paths themselves. In one
// picture, or where the circle dwarfs the mechanism in two: the rays as small as the circle asks, the centres larger.
#pragma once

#include <functional>

#include "exercises/kit/panels/cut_panel.h"

namespace epure {

struct Curved {
  std::string pole;                 // in names of quantities: "P0"
  std::vector<std::string> points;  // "C", "M"
  int circles_sheet = 1;            // of the exercise: where the inflection circle is found
  std::string prefix = {};          // of all names, for a case of the exercise
};

// Of the solution: the inflection circle as CirclesPanel needs it, pole (not at infinity), points, "Cprime".
class RaysPanel : public CutPanel {
 public:
  RaysPanel(const Solution& solution, std::shared_ptr<const MechanismFigure> mechanism, Curved of);

  double reach() const override;
  // Small, because the circle is larger than the mechanism: one picture at its scale would have to cut the circle.
  bool is_overview() const { return inflection_.centre && 2 * inflection_.radius > mechanism_->reach(); }
  // For a picture with more on it: what this one covers, and draws below the mechanism and above.
  drawings::Box covered(const Scale& lengths, double points, double circles) const override;
  void draw_circle(Plot& plot, const drawings::Box& room, Language language) const;
  void draw_rays(Plot& plot, const drawings::Box& room, Language language) const;
  void note_off(OffSheet& off) const;

  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override;
  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box& room) const override;

 private:
  struct OnRay {
    std::string name, letters;  // "C", within mathematics
    Place at;
    std::optional<Place> prime;  // X'
  };
  double far() const override { return is_overview() ? far_of_overview : 5; }
  void name_circle(Plot& plot, const drawings::Box& room, Language language) const;

  Curved curved_;
  std::optional<Place> P0_, J_, F_;
  DrawnCycle inflection_;
  std::vector<OnRay> points_;
};

// Of the solution: pole, points, "curvature_centre_C".
class OsculatingPanel : public CutPanel {
 public:
  // The rays too, in one picture.
  OsculatingPanel& with_rays(RaysPanel rays) {
    rays_ = std::move(rays);
    return *this;
  }
  // Draws the path of a point as far as it runs through this box of the paper.
  using DrawPath = std::function<void(Plot&, const std::string& point, const drawings::Box& around)>;
  OsculatingPanel(const Solution& solution, std::shared_ptr<const MechanismFigure> mechanism, Curved of,
                  DrawPath draw_path);

  double reach() const override { return mechanism_->reach(); }
  // Small as an osculating circle may be, the inflection circle beside it is rather cut.
  double times_smaller() const override { return 1.5; }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override;
  void draw_given(Plot& plot, const drawings::Box&, Language) const override { mechanism_->draw_given(plot); }
  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box& room) const override;

 private:
  struct OnPath {
    std::string name, letters;
    Place at;
    std::optional<Place> centre;  // of curvature
    bool is_pole;
  };
  double far() const override { return 1.2; }
  drawings::Box covered(const Scale& lengths, double points, double circles) const override;
  void draw_piece_of_path(Plot& plot, const drawings::Box& room, const OnPath& X) const;
  void draw_centre(Plot& plot, const drawings::Box& room, const OnPath& X, Language language) const;
  Words step_to(const OnPath& X, bool is_first) const;

  Curved curved_;
  std::optional<Place> P0_;
  std::vector<OnPath> points_;
  DrawPath draw_path_;
  std::optional<RaysPanel> rays_ = {};
};

// Both, or where the pole is at infinity the second alone.
Panels curvature_panels(const Solution& solution, const std::shared_ptr<const MechanismFigure>& mechanism,
                        const Curved& of, const OsculatingPanel::DrawPath& draw_path);

}  // namespace epure
