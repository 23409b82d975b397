// The linkage in one configuration, in the doubles a drawing takes.
#pragma once

#include "exercises/four-bar/exercise.h"
#include "exercises/kit/linkages/four_bar_figure.h"
#include "exercises/kit/panels/coupler_figure.h"
#include "exercises/kit/panels/diagram_sheet.h"
#include "geometry/mechanisms/four_bar_positions.h"

namespace epure::four_bar {

struct Drawn {
  const Problem& problem;
  FourBarFigure mechanism;
  CouplerFigure coupler;  // of `mechanism`, so that neither is moved
  VectorPolygon velocity, acceleration;
  double omega_2 = 0, omega_4 = 0, alpha_4 = 0;
  std::optional<Place> P42 = {};  // the pole of rocker and crank; none at infinity, or not determined

  // Found with many bits; `prefix` is that of the case.
  Drawn(const Problem& of, const geometry::FourBar<geometry::Deep>& at, const std::string& prefix);
  Drawn(const Drawn&) = delete;
  Drawn& operator=(const Drawn&) = delete;
};

// Makes a Drawn where the numbers that it takes live.
template <class Find>
std::unique_ptr<Drawn> drawn(const Problem& of, const Find& find_position, const std::string& prefix) {
  return deeply([&] { return std::make_unique<Drawn>(of, find_position(), prefix); });
}
std::unique_ptr<Drawn> at_instant(const Problem& of);
// None when the rocker has no such dead centre, or the linkage is at a change point there.
std::unique_ptr<Drawn> at_dead_centre(const Problem& of, geometry::Reach reach);

// One sheet each; they add to an empty sheet.
void draw_poles(DrawnSheet& onto, const Drawn& f, const SheetRequest& request);
void draw_velocity_diagram(DrawnSheet& onto, const Drawn& f, const SheetRequest& request);
void draw_acceleration_diagram(DrawnSheet& onto, const Drawn& f, const SheetRequest& request);
void draw_circles(DrawnSheet& onto, const Drawn& f, const SheetRequest& request);
void draw_acceleration_pole(DrawnSheet& onto, const Drawn& f, const SheetRequest& request);
void draw_curvature(DrawnSheet& onto, const Drawn& f, const SheetRequest& request);
// In place of a sheet on a dead centre that the rocker has not.
void say_that_there_is_none(DrawnSheet& onto, Language language);
void draw_dead_centres(DrawnSheet& onto, const Problem& of, const SheetRequest& request);
void draw_dead_centre(DrawnSheet& onto, const Drawn& f, const SheetRequest& request);
void draw_parallel_links(DrawnSheet& onto, const Problem& of, const SheetRequest& request);
void draw_slider_crank(DrawnSheet& onto, const Problem& of, const SheetRequest& request);

}  // namespace epure::four_bar
