// A part of a sheet that may be larger than its room: circles and points far off. It is moved before it is cut.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exercises/kit/panels/edge.h"
#include "exercises/kit/panels/mechanism_figure.h"
#include "exercises/kit/panels/panel.h"
#include "exercises/kit/proof/solution.h"

namespace epure {

class CutPanel : public Panel {
 public:
  bool is_cut() const override { return true; }
  // A large circle is cut rather than that the next but one scale is taken for it.
  double times_smaller() const override { return 2.6; }
  drawings::Box extent(const Scale& lengths, const Scale&) const override { return covered(lengths, far(), far()); }
  drawings::Box extent_of_near(const Scale& lengths, const Scale&) const override {
    return covered(lengths, far(), 0);
  }
  void draw_given(Plot& plot, const drawings::Box&, Language) const override { mechanism_->sketch(plot); }
  // What is farther still stands in the room as far as there is place for it.
  drawings::Point origin(const drawings::Box& room, const drawings::Box& needed, const Scale& lengths) const override;

 protected:
  explicit CutPanel(std::shared_ptr<const MechanismFigure> mechanism) : mechanism_(std::move(mechanism)) {}

  // How far from the mechanism, in its reaches, a point may be for a scale to be chosen that shows it. A circle
  // counts by its diameter.
  virtual double far() const = 0;
  // What is drawn of points within so many reaches, and whole circles, in mm from the plane's origin.
  virtual drawings::Box covered(const Scale& lengths, double points, double circles) const = 0;

  bool is_near(const std::optional<Place>& P, double reaches) const {
    return P && distance(mechanism_->corners().front(), *P) < reaches * mechanism_->reach();
  }
  void include(Extent& extent, const Scale& lengths, const std::optional<Place>& P, double reaches) const;
  void include(Extent& extent, const Scale& lengths, const DrawnCycle& circle, double reaches) const;
  // The mechanism is small beside it.
  bool dwarfs_mechanism(const DrawnCycle& circle) const;
  // Such a circle is shown whole beside a picture of the mechanism, up to so many of its reaches.
  static constexpr double far_of_overview = 10;
  // The reach of that picture: it stays small.
  double reach_of_overview(const DrawnCycle& circle) const;
  // The mechanism's middle, away from which letters stand.
  Place middle() const;

  std::shared_ptr<const MechanismFigure> mechanism_;
};

// A circle of the solution, or the line it has become: by its centre's name, and the quantity of its diameter.
DrawnCycle cycle_of(const Solution& solution, const std::string& centre, const std::string& diameter);

// A point under its letters, as a cross; nothing without one.
void draw_named(Plot& plot, const std::optional<Place>& P, const std::string& letters, const Place& away_from,
                Meaning ink = Meaning::locus);

// The segment PQ. Where it leaves the room letters say where it leads.
void draw_to(Plot& plot, const drawings::Box& room, const Place& P, const Place& Q, const std::string& letters,
             Language language, Meaning meaning = Meaning::construction);
// Where it ends: in Q, or at the room's edge.
Place seen_end(const Plot& plot, const drawings::Box& room, const Place& P, const Place& Q);

}  // namespace epure
