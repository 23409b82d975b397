// Instant centres where lines meet, drawn on the mechanism.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "exercises/kit/panels/mechanism_figure.h"
#include "exercises/kit/panels/panel.h"

namespace epure::scenes {

// A centre on a line: a point of the plane, or at infinity in a direction; neither: it is not known.
struct OnLine {
  std::string letters;  // of one that was found before; empty: a joint gives it
  std::optional<Place> at;
  std::optional<Arrow2> towards;
};
// From its first centre to the second; none where neither tells it.
std::optional<Arrow2> along_line(const std::pair<OnLine, OnLine>& line);

struct DrawnCentre {
  std::string quantity;  // "P24"
  std::string letters;   // "$P_{24}$"
  std::optional<Place> at;
  std::vector<std::pair<OnLine, OnLine>> lines;  // the two that it lies on, each through two centres
  Words step;
};

class CentresPanel : public Panel {
 public:
  // `points`: of the mechanism, which have letters too.
  CentresPanel(std::shared_ptr<const MechanismFigure> mechanism, std::vector<Place> points,
               std::vector<DrawnCentre> centres, Words joints)
      : mechanism_(std::move(mechanism)),
        points_(std::move(points)),
        centres_(std::move(centres)),
        joints_(std::move(joints)) {}

  double reach() const override { return mechanism_->reach(); }
  double times_smaller() const override { return 2.6; }  // one standard scale
  drawings::Box extent(const Scale& lengths, const Scale& vectors) const override;
  drawings::Box extent_of_near(const Scale& lengths, const Scale& vectors) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override;
  void draw_given(Plot& plot, const drawings::Box& room, Language) const override {
    draw_axes(plot, room);
    mechanism_->draw_given(plot);
  }
  std::vector<Place> lettered() const override;
  std::vector<double> crossings() const override;
  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box& room) const override;

 private:
  // Of the mechanism, and of centres not farther from it than so many times its reach.
  drawings::Box extent_within(double reaches, const Scale& lengths) const;
  void draw_line(Plot& plot, const drawings::Box& room, const DrawnCentre& centre,
                 const std::pair<OnLine, OnLine>& line, Language language) const;
  std::optional<Place> where_it_leaves(const Plot& plot, const drawings::Box& room, const DrawnCentre& centre) const;
  // Where coordinates count from no point of the mechanism, which marks it anyway.
  bool shows_axes() const;
  void draw_axes(Plot& plot, const drawings::Box& room) const;
  // What the lines start from and another sheet found.
  void draw_earlier(Plot& plot, const drawings::Box& room) const;

  std::shared_ptr<const MechanismFigure> mechanism_;
  std::vector<Place> points_;
  std::vector<DrawnCentre> centres_;
  Words joints_;  // what joints or other sheets give, before the steps
};

}  // namespace epure::scenes
