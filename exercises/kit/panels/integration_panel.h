// Graphical integration on one sheet: a curve with its strips and the mean ordinates carried to the axis, the pole
// and its rays at the left, and below, in line with it, the integral polygon; below that the polygon's own integral,
// and so on. The panel chooses the scales for the room it has, the pole distances follow, and the scales have their
// bars: it stands alone on its sheet.
//
//   IntegrationPanel({.letters = "$t$", .unit = "s", .ends = {0, 1, 2, 3}},
//                    {{.letters = "$a$", .unit = "m/s²", .meaning = Meaning::acceleration, .curve = a,
//                      .carried = {0.7, 1.9, 2.8}},
//                     {.letters = "$v$", .unit = "m/s", .curve = v, .corners = {0, 0.7, 2.6, 5.4},
//                      .read = {{.quantity = "graphical.v_1", .label = "$v_{1}$", .at = 3, .value = s["..."]}}}});
//
// The numbers come from the solution, or from graphical_integral<double> (geometry/constructions), which is the twin
// of what the routes computed; what a ruler reads is held against the quantities that `read` names.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "exercises/kit/panels/panel.h"

namespace epure {

struct IntegrationAbscissa {
  std::string letters, unit;
  std::vector<double> ends;  // of the strips, ascending
};

struct IntegrationRow {
  std::string letters, unit;
  Meaning meaning = Meaning::velocity;
  std::string id = {};                       // of the polygon's line in the SVG
  std::function<double(double)> curve = {};  // the true one; none: not shown
  std::vector<double> corners = {};          // of the integral polygon, at the strips' ends; the first row has none
  std::vector<double> carried = {};          // mean ordinates of the strips; the last row has none
  // An ordinate of the polygon, or of the curve, that a ruler reads: an abscissa, the ordinate there, and what a unit
  // of the row is in SI.
  struct Read {
    std::string quantity, label;
    double at, value;
    double si = 1;
  };
  std::vector<Read> read = {};
};

class IntegrationPanel : public Panel {
 public:
  // `mean`: how the ordinates are found that are carried.
  IntegrationPanel(IntegrationAbscissa along, std::vector<IntegrationRow> rows,
                   Words mean = {"the ordinate in the middle of each strip", "l'ordinata a metà di ogni striscia"});

  bool is_of_vectors() const override { return true; }  // it has no scale of lengths
  std::optional<Place> start() const override { return {}; }
  std::vector<Scale> own_scales() const override { return scales_; }
  void choose_view(const drawings::Box& whole_room, const SheetRequest& request) override;
  drawings::Box extent(const Scale&, const Scale&) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language language) const override;
  void draw_given(Plot& plot, const drawings::Box& room, Language language) const override;
  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override;

 private:
  // A place of row i, in mm from the left end of the first row's axis.
  Place at(std::size_t row, double x, double ordinate) const;
  double pole_distance(std::size_t row) const;  // mm
  void lay_rows(double height);
  void draw_axes(Plot& plot, std::size_t row, Language language) const;
  void draw_curve(Plot& plot, std::size_t row) const;
  void draw_polygon(Plot& plot, std::size_t row) const;
  void carry(Plot& plot, std::size_t row, Language language) const;
  void draw_readings(Plot& plot, std::size_t row) const;

  IntegrationAbscissa along_;
  std::vector<IntegrationRow> rows_;
  Words mean_;
  std::vector<std::pair<double, double>> ranges_;  // of the rows' ordinates, with zero
  std::vector<Scale> scales_;                      // of the abscissae, then of each row
  std::vector<double> axes_;                       // heights of the rows' axes of abscissae, mm
};

}  // namespace epure
