#include "exercises/kit/panels/poles_panel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/kit/panels/edge.h"

namespace epure {
namespace {

constexpr double letters = 8;  // mm around a point or a vector's tip

}  // namespace

PolesPanel::Kind PolesPanel::of_velocity(const std::string& pole) {
  return {.pole = pole, .letters = "$" + point_letters(pole) + "$"};
}
PolesPanel::Kind PolesPanel::of_acceleration() {
  return {.pole = "K",
          .letters = "$K$",
          .ink = Meaning::acceleration,
          .vector = acceleration,
          .longest_on_paper = 45,
          .farthest = 4};
}

PolesPanel::PolesPanel(const Solution& solution, std::shared_ptr<const MechanismFigure> mechanism, Kind kind,
                       const std::vector<std::string>& points, std::vector<PanelStep> steps)
    : mechanism_(std::move(mechanism)), kind_(std::move(kind)), steps_(std::move(steps)) {
  for (const std::string& X : points) {
    const VectorQuantity quantity = kind_.vector(X);
    points_.push_back({X, solution.place(X), quantity, solution.vector(quantity.name)});
    if (solution.is_reported(kind_.pole + X)) reported_.push_back(X);
  }
  if (shows_pole(solution, *mechanism_, kind_)) pole_ = solution.place(kind_.pole);
}

PolesPanel& PolesPanel::sketched() {
  is_sketched_ = true;
  return *this;
}
PolesPanel& PolesPanel::turning_at(double rate, const std::string& symbol) {
  rate_ = rate;
  rate_symbol_ = symbol;
  return *this;
}
PolesPanel& PolesPanel::by_the_tips() {
  is_by_the_tips_ = true;
  return *this;
}

bool PolesPanel::shows_pole(const Solution& solution, const MechanismFigure& mechanism, const Kind& kind) {
  const std::optional<Place> pole = solution.point(kind.pole);
  return pole && distance(mechanism.corners().front(), *pole) < kind.farthest * mechanism.reach();
}

Panel::Vectors PolesPanel::vectors() const {
  Vectors shown{.unit = is_of_velocity() ? "m/s" : "m/s²", .longest_on_paper = kind_.longest_on_paper};
  for (const Carried& X : points_) shown.longest = std::max(shown.longest, magnitude(X.v));
  return shown;
}

drawings::Box PolesPanel::extent(const Scale& lengths, const Scale& vectors) const {
  Extent extent;
  if (is_sketched_)
    for (const Place& P : mechanism_->corners()) extent.include(lengths, P, letters);
  else
    mechanism_->include(extent, lengths);
  for (const Carried& X : points_) {
    extent.include(lengths, X.at, letters);
    const double x = lengths.mm_per_unit * X.at.x + vectors.mm_per_unit * X.v.x;
    const double y = lengths.mm_per_unit * X.at.y + vectors.mm_per_unit * X.v.y;
    extent.include(x - letters, y - letters);
    extent.include(x + letters, y + letters);
  }
  if (pole_) extent.include(lengths, *pole_, letters + 3);
  return extent.box();
}

// From the points to the pole; those of velocities are normals, and run on a little.
void PolesPanel::draw_rays(Plot& plot) const {
  constexpr double beyond = 6;  // mm
  for (const Carried& X : points_) {
    if (distance(X.at, *pole_) == 0) continue;
    if (is_of_velocity()) {
      plot.long_segment(X.at, *pole_, beyond, Meaning::construction);
      plot.right_angle(X.at, *pole_, plot.tip(X.at, X.v));
      if (is_by_the_tips_) plot.long_segment(plot.tip(X.at, X.v), *pole_, beyond, Meaning::construction);
    } else {
      plot.segment(X.at, *pole_, Meaning::construction);
    }
  }
}

// The pole is too far to be shown, or at infinity: the normals, right across the room.
void PolesPanel::draw_leaving_rays(Plot& plot, const drawings::Box& room) const {
  for (const Carried& X : points_) {
    if (!is_of_velocity() || magnitude(X.v) == 0) continue;
    const Arrow2 normal{-X.v.y, X.v.x};
    plot.segment(at_edge(plot, room, X.at, -normal), at_edge(plot, room, X.at, normal), Meaning::construction);
  }
}

void PolesPanel::draw_pole(Plot& plot) const {
  plot.cross(*pole_, kind_.ink);
  Place middle{0, 0};
  for (const Place& P : mechanism_->corners()) middle = {middle.x + P.x, middle.y + P.y};
  const auto count = static_cast<double>(mechanism_->corners().size());
  plot.label(kind_.letters, *pole_, Place{middle.x / count, middle.y / count}, kind_.ink);
  plot.measures_coordinates(kind_.pole, *pole_, mechanism_->corners().front());
  for (const Carried& X : points_)
    if (std::find(reported_.begin(), reported_.end(), X.name) != reported_.end())
      plot.measures(kind_.pole + X.name, *pole_, X.at);
}

// γ at X: from the ray XK to the acceleration. No arc where there is none to see.
void PolesPanel::mark_inclination(Plot& plot, const Carried& X) const {
  constexpr double radius = 13, shortest_arc = 2;  // mm
  const double ray = direction(X.at, *pole_), vector = std::atan2(X.v.y, X.v.x);
  const double turn = std::remainder(vector - ray, 2 * std::numbers::pi);
  if (magnitude(X.v) == 0 || std::abs(turn) * radius < shortest_arc) return;
  plot.mark(drawings::AngleMark{plot.at(X.at), radius, std::min(ray, ray + turn), std::max(ray, ray + turn),
                                Meaning::dimension});
  const double middle = ray + turn / 2;
  const drawings::Point c = plot.at(X.at);
  plot.label("$γ$", plot.from_paper({c.x + radius * std::cos(middle), c.y + radius * std::sin(middle)}), X.at);
}

void PolesPanel::draw(Plot& plot, const drawings::Box& room, Language) const {
  if (pole_)
    draw_rays(plot);
  else
    draw_leaving_rays(plot, room);
  if (is_sketched_)
    mechanism_->sketch(plot);
  else
    mechanism_->draw(plot);
  if (pole_) draw_pole(plot);
  for (const Carried& X : points_)
    plot.vector_on(X.quantity.name, X.at, X.v, is_of_velocity() ? Meaning::velocity : Meaning::acceleration,
                   X.quantity.arrow());
  if (pole_ && !is_of_velocity() && !points_.empty()) mark_inclination(plot, points_.back());
}

// Velocities by the rate; accelerations in the proportion of their rays, from that of the first point, which is
// known.
std::optional<MeasuredTable> PolesPanel::measured(const Readings& readings) const {
  MeasuredTable table{.heading = {"The two methods, as measured", "I due metodi, come misurati"},
                      .rows = {},
                      .first = {"$" + rate_symbol_ + "$·$" + point_letters(kind_.pole) + "X$", ""},
                      .second = {"vector", "vettore"}};
  table.first.italian = table.first.english;
  const auto row = [&](const Carried& X, double by_the_pole, double vector) {
    table.rows.push_back({X.quantity.length().symbol + " (" + vectors().unit + ")", by_the_pole, vector});
  };
  const auto ray = [&](const Carried& X) { return kind_.pole + X.name; };
  if (is_of_velocity() && rate_) {
    for (const Carried& X : points_)
      if (readings.is_unit(ray(X)) && readings.has(X.quantity.name))
        row(X, std::abs(*rate_) * readings[ray(X)], readings[X.quantity.name]);
  } else if (!is_of_velocity() && !points_.empty() && readings.is_unit(ray(points_.front()))) {
    table.first = {"poles", "poli"};
    table.second = {"exact", "esatto"};
    const Carried& driven = points_.front();
    for (const Carried& X : points_)
      if (&X != &driven && readings.has(ray(X)))
        row(X, readings[ray(X)] / readings[ray(driven)] * magnitude(driven.v), magnitude(X.v));
  }
  return table;
}

}  // namespace epure
