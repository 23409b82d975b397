// The torque over a turn of the crank, and at its left quarters of the circles from which it is projected: of the
// radii F_a r and F_m r at the scale of the torques, so that the height of the crank's end is the torque. (Each half
// turn has the same heights twice.)
#pragma once

#include "drawings/charts/chart.h"
#include "exercises/kit/panels/panel.h"

namespace epure::pump_flywheel {

class TorquePanel : public Panel {
 public:
  struct Projected {
    double angle;         // of the turn, in degrees
    std::string letters;  // empty: none
  };
  // Coefficients in N m, both positive; `chart` in degrees and N m, its ordinates from zero. What a ruler reads
  // there:
  struct Read {
    std::string quantity;
    drawings::Datum from, to;
    double si;  // of a unit of the axis along which it lies
  };
  TorquePanel(double suction, double delivery, std::vector<Projected> projected, drawings::Chart chart,
              std::vector<Read> read)
      : suction_(suction),
        delivery_(delivery),
        projected_(std::move(projected)),
        chart_(std::move(chart)),
        read_(std::move(read)) {}

  bool has_scale() const override { return false; }
  drawings::Box extent(const Scale&, const Scale&) const override { return {{0, 0}, {150, 80}}; }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override;
  void draw_given(Plot& plot, const drawings::Box& room, Language language) const override;
  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box& room) const override;

 private:
  // The chart as high as the circles find room for, and its part of the room.
  drawings::Box room_of_chart(const drawings::Box& room, Language language) const;

  // The end of the crank, at an angle of the turn.
  drawings::Point end_of_crank(const drawings::Box& room, const drawings::ChartMap& map, double degrees) const;
  double radius(const drawings::ChartMap& map, double degrees) const;  // mm

  double suction_, delivery_;
  std::vector<Projected> projected_;
  drawings::Chart chart_;
  std::vector<Read> read_;
};

}  // namespace epure::pump_flywheel
