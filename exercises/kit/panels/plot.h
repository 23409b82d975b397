// From geometry to marks: one picture of the plane (or of a plane of vectors) on a sheet, at its own scale.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drawings/picture.h"
#include "exercises/kit/panels/scale.h"
#include "exercises/kit/proof/exercise.h"
#include "exercises/kit/proof/place.h"
#include "geometry/constructions/cycle.h"

namespace epure {

using drawings::Meaning;

struct DrawnCycle;

class Plot {
 public:
  // `origin`: where on the paper (0, 0) lies.
  Plot(DrawnSheet& onto, drawings::Point origin, Scale scale)
      : onto_(onto), origin_(origin), scale_(std::move(scale)) {}

  drawings::Point at(const Place& P) const {
    return {origin_.x + scale_.mm_per_unit * P.x, origin_.y + scale_.mm_per_unit * P.y};
  }
  Place from_paper(drawings::Point p) const {
    return {(p.x - origin_.x) / scale_.mm_per_unit, (p.y - origin_.y) / scale_.mm_per_unit};
  }
  const Scale& scale() const { return scale_; }
  // The plot with another scale for the vectors that start on its points.
  void vectors_at(Scale scale) { vectors_ = std::move(scale); }
  const Scale& vector_scale() const { return vectors_; }

  // What is cut at the border of a room has no letters beyond it either.
  void keep_within(const drawings::Box& room) { room_ = room; }

  // P lies on the drawing area, and in the room. What is put at a point off it (a dot, letters, a step number) is
  // left out.
  bool shows(const Place& P) const;

  // What is drawn from now on comes with this step of the panel (0: before the first), or of the sheet where the
  // panel has none; none: it is found with which.
  void in_step(std::optional<int> number);

  // For what has axes of its own: a chart.
  DrawnSheet& onto() { return onto_; }

  void mark(drawings::Mark m) { onto_.sheet.figure.marks.push_back(std::move(m)); }
  void segment(const Place& P, const Place& Q, Meaning meaning, const std::string& name = {});
  // The segment PQ drawn `beyond` mm past both ends.
  void long_segment(const Place& P, const Place& Q, double beyond, Meaning meaning);
  // The line of the direction PQ, drawn `beyond` mm past both ends, with what it is written at its end beyond Q.
  void direction_line(const Place& P, const Place& Q, double beyond, const std::string& what);
  void polygon(const std::vector<Place>& corners, Meaning meaning);
  void area(const std::vector<Place>& corners, Meaning meaning);
  void circle(const Place& centre, double radius, Meaning meaning, const std::string& name = {});
  // A circle, or the line it has become, as far as it crosses the drawing area.
  void cycle(const DrawnCycle& cycle, Meaning meaning, const std::string& name = {});
  void dot(const Place& P, Meaning meaning = Meaning::construction);
  void cross(const Place& P, Meaning meaning = Meaning::locus);
  void hinge(const Place& P);
  // A small square between the directions from P to Q and from P to R.
  void right_angle(const Place& P, const Place& Q, const Place& R);

  // A vector of this plane of vectors, or one that starts on a point of the plane at the scale of `vectors_at`.
  void side(const std::string& name, const Place& from, const Place& to, Meaning meaning, const std::string& label,
            std::optional<Place> away_from = {});
  void vector_on(const std::string& name, const Place& from, const Arrow2& v, Meaning meaning,
                 const std::string& label);
  // The paper point at the tip of such a vector, in the coordinates of the plane.
  Place tip(const Place& from, const Arrow2& v) const;

  void label(const std::string& text, const Place& P, std::optional<Place> away_from = {},
             Meaning ink = Meaning::text);
  // A number or name in the smaller letters of a crowd of positions.
  void small_label(const std::string& text, const Place& P, const Place& away_from, Meaning ink = Meaning::text);
  void step(int number, const Place& P);

  // The sheet shows quantity `name` as the distance PQ. What runs off the drawing area cannot be measured and is left
  // out; so it is with coordinates.
  void measures(const std::string& name, const Place& P, const Place& Q);
  // ... and the coordinates of P, as name_x and name_y, from `origin`.
  void measures_abscissa(const std::string& name, const Place& P, const Place& origin);
  void measures_coordinates(const std::string& name, const Place& P, const Place& origin);

 private:
  void measure(const std::string& name, const Place& from, const Place& to, double per_mm, Measurement::Kind kind);

  DrawnSheet& onto_;
  drawings::Point origin_;
  Scale scale_, vectors_;
  std::optional<drawings::Box> room_ = {};
  std::optional<int> step_ = {};
};

}  // namespace epure
