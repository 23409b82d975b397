// An instant of a rolling motion: the bodies with the path, velocity and acceleration of M, the inflection circle,
// and the centre of curvature with its circle.
#pragma once

#include "exercises/kit/panels/panel.h"
#include "exercises/kit/rolling/instant_steps.h"
#include "exercises/kit/rolling/rolling_picture.h"

namespace epure {

class RollingInstantPanel : public Panel {
 public:
  // The velocities of a sheet have one scale, which their exercise chooses.
  RollingInstantPanel(const Solution& solution, Rolled at, std::vector<InstantStep> steps, Scale velocities);

  // A title above it.
  RollingInstantPanel& titled(std::string title);
  // No smaller for the centre of curvature: the line from M leads to it, off the sheet too.
  RollingInstantPanel& without_room_for_centre();
  // Its bodies on the paper, where there is little to see of them.
  RollingInstantPanel& no_larger_than(double mm);
  // Coordinates are measured from this place.
  RollingInstantPanel& measured_from(const Place& origin);
  // This much of the path, as far as there is room for it; or shown from end to end.
  RollingInstantPanel& with_path(const Way& way);
  RollingInstantPanel& with_whole_path(const Way& way);
  // With what a line's contact is found by: the x axis with the start of the path, and φ from it.
  RollingInstantPanel& set_out();
  // The contact alone, as large as its circles allow; and the rest, without the points that are so small there.
  RollingInstantPanel& close_up();
  RollingInstantPanel& beside_close_up();
  // The rest is not as large as that of another instant.
  RollingInstantPanel& at_own_scale();

  double reach() const override;
  Vectors vectors() const override;
  std::vector<Scale> own_scales() const override;
  std::string scale_group() const override;
  drawings::Box extent(const Scale& lengths, const Scale& vectors) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override;
  void draw_given(Plot& plot, const drawings::Box& room, Language language) const override;
  bool is_cut() const override { return true; }
  // As much of a fixed circle as there is place for.
  drawings::Point origin(const drawings::Box& room, const drawings::Box& needed, const Scale& lengths) const override;
  std::vector<Place> lettered() const override;
  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box& room) const override;

 private:
  enum class Shows { all, vectors, contact };
  bool is_inflection_circle_small() const;
  bool is_near(const Place& P) const;
  double size() const;
  bool shows_parts(const Scale& accelerations) const;
  // The place of the centre of curvature, or where the line to it leaves the room.
  Place towards_centre(const Plot& plot, const drawings::Box& room) const;

  bool is_set_out() const;
  void draw_start(Plot& plot) const;
  void draw_radius(Plot& plot) const;
  void draw_osculating_circle(Plot& plot, const drawings::Box& room, Language language) const;
  void draw_inflection_circle(Plot& plot) const;
  void draw_ray(Plot& plot) const;
  void draw_velocity(Plot& plot, Language language) const;
  void draw_beside(Plot& plot, const std::pair<std::string, std::string>& name_and_letters, const Arrow2& v,
                   const Arrow2& others) const;
  void draw_acceleration(Plot& plot, Language language) const;
  void draw_directions_at_cusp(Plot& plot) const;
  void draw_points(Plot& plot, const drawings::Box& room) const;
  void measure(Plot& plot) const;
  std::string off_sheet(const Plot& plot, const drawings::Box& room, Language language) const;

  const Solution& solution_;
  Rolled f_;
  std::vector<InstantStep> steps_;
  Scale velocities_;
  std::string title_;
  std::optional<Place> origin_;
  Way way_;
  std::vector<Place> whole_path_;
  Shows shows_ = Shows::all;
  bool leaves_out_centre_ = false;
  double largest_on_paper_ = 1000;  // mm
  bool has_own_scale_ = false, sets_out_ = false;
};

// The scale at which the fastest of these is about so long.
Scale scale_of_velocities(const std::vector<Rolled>& instants, double longest_mm, Language language);

}  // namespace epure
