#include "exercises/kit/panels/poles_panel.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "drawings/paths/vectors.h"
#include "exercises/kit/panels/crossing.h"
#include "exercises/kit/panels/edge.h"
#include "exercises/kit/panels/results.h"
#include "exercises/kit/panels/short_vectors.h"
#include "exercises/kit/panels/tracks.h"

namespace epure {
namespace {

constexpr double letters_around = 8;  // mm around a point or a vector's tip

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Place middle_of(const std::vector<Place>& places) {
  Place sum{0, 0};
  for (const Place& P : places) sum = {sum.x + P.x, sum.y + P.y};
  const auto count = static_cast<double>(places.size());
  return {sum.x / count, sum.y / count};
}

// The side of a line on which the supports of hinges do not stand: a unit vector across it.
drawings::Point free_side(const std::vector<drawings::Mark>& marks, drawings::Point along) {
  const drawings::Point left = drawings::left_of(along);
  double supported = 0;
  for (const drawings::Mark& mark : marks)
    if (const auto* fixed = std::get_if<drawings::FixedHinge>(&mark))
      supported += dot(drawings::direction(fixed->down), left);
  return supported > 0 ? -1 * left : left;
}

// How far aside vectors stand that would lie on one another, as at a dead centre: each in a row of its own, clear of
// the links and hinges on their line. (mm)
std::vector<drawings::Point> in_rows(const std::vector<VectorOnPaper>& vectors,
                                     const std::vector<drawings::Mark>& marks) {
  constexpr double first_row = 2.4, between_rows = 1.8, shortest = 3;  // mm: shorter ones cover none
  const auto is_long = [](const VectorOnPaper& v) { return drawings::distance(v.first, v.second) >= shortest; };
  std::vector<drawings::Point> aside(vectors.size());
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    std::vector<std::size_t> together;  // in the order in which they are drawn
    for (std::size_t j = 0; j < vectors.size(); ++j)
      if (j == i || (is_long(vectors[i]) && is_long(vectors[j]) && covered(vectors[i], vectors[j])))
        together.push_back(j);
    if (together.size() == 1) continue;
    const auto before = std::find(together.begin(), together.end(), i) - together.begin();
    const auto& [from, to] = vectors[together.front()];
    aside[i] = (first_row + static_cast<double>(before) * between_rows) * free_side(marks, drawings::unit(from, to));
  }
  return aside;
}

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
          .times_smaller = 4};
}

PolesPanel::PolesPanel(const Solution& solution, std::shared_ptr<const MechanismFigure> mechanism, Kind kind,
                       const std::vector<std::string>& points, std::vector<PolesStep> steps)
    : mechanism_(std::move(mechanism)),
      kind_(std::move(kind)),
      steps_(std::move(steps)),
      origin_(mechanism_->corners().front()) {
  for (const std::string& X : points) {
    VectorQuantity quantity = kind_.vector(X);
    quantity.name = kind_.prefix + quantity.name;
    points_.push_back({X, solution.place(kind_.prefix + X), quantity, solution.vector(quantity.name)});
    if (!solution.is_reported(quantity.name)) points_.back().quantity.name.clear();  // no ruler reads it
    if (solution.is_reported(kind_.prefix + X + "_x") && solution.is_reported(kind_.prefix + X + "_y"))
      reported_points_.push_back(X);
    if (solution.is_reported(name_of_ray(X))) reported_rays_.push_back(X);
  }
  pole_ = solution.point(kind_.prefix + kind_.pole);
  reports_pole_ = solution.is_reported(kind_.prefix + kind_.pole + "_x");
}

PolesPanel& PolesPanel::sketched() {
  is_sketched_ = true;
  return *this;
}
PolesPanel& PolesPanel::by_the_tips() {
  is_by_the_tips_ = true;
  return *this;
}
PolesPanel& PolesPanel::on_lines(std::vector<std::pair<Place, std::string>> lines) {
  lines_ = std::move(lines);
  return *this;
}
PolesPanel& PolesPanel::turning(double sense, const std::string& symbol) {
  sense_ = sense;
  turning_symbol_ = symbol;
  return *this;
}
PolesPanel& PolesPanel::compared_with(double rate, const std::string& symbol) {
  rate_ = rate;
  rate_symbol_ = symbol;
  return *this;
}

bool PolesPanel::has_far_pole() const {
  constexpr double not_tried = 100;  // reaches of the mechanism
  return pole_ && distance(mechanism_->corners().front(), *pole_) < not_tried * mechanism_->reach();
}

bool PolesPanel::shows_pole(const Plot& plot, const drawings::Box& room) const {
  return pole_ && is_in(room, plot, *pole_);
}

const PolesPanel::Carried& PolesPanel::carried(const std::string& name) const {
  const auto found = std::find_if(points_.begin(), points_.end(), [&](const Carried& X) { return X.name == name; });
  assert(found != points_.end() && "a point whose vector is drawn");
  return *found;
}

bool PolesPanel::is_on_a_line(const Carried& X) const {
  return lines_.empty() ||
         std::any_of(lines_.begin(), lines_.end(), [&](const auto& line) { return line.second == X.name; });
}

Arrow2 PolesPanel::towards_pole(const Carried& X) const { return pole_ ? *pole_ - X.at : Arrow2{-X.v.y, X.v.x}; }

Panel::Vectors PolesPanel::vectors() const {
  Vectors shown{.unit = is_of_velocity() ? "m/s" : "m/s²", .longest_on_paper = kind_.longest_on_paper};
  for (const Carried& X : points_) shown.longest = std::max(shown.longest, magnitude(X.v));
  return shown;
}

drawings::Box PolesPanel::extent(const Scale& lengths, const Scale& vectors) const {
  Extent extent;
  const drawings::Box near = extent_of_near(lengths, vectors);
  extent.include(near.low.x, near.low.y);
  extent.include(near.high.x, near.high.y);
  if (has_far_pole()) extent.include(lengths, *pole_, letters_around + 3);
  return extent.box();
}

drawings::Box PolesPanel::extent_of_near(const Scale& lengths, const Scale& vectors) const {
  Extent extent;
  if (is_sketched_)
    for (const Place& P : mechanism_->corners()) extent.include(lengths, P, letters_around);
  else
    mechanism_->include(extent, lengths);
  for (const Carried& X : points_) {
    extent.include(lengths, X.at, letters_around);
    const double x = lengths.mm_per_unit * X.at.x + vectors.mm_per_unit * X.v.x;
    const double y = lengths.mm_per_unit * X.at.y + vectors.mm_per_unit * X.v.y;
    extent.include(x - letters_around, y - letters_around);
    extent.include(x + letters_around, y + letters_around);
  }
  return extent.box();
}

// From the points to the pole. The lines it is found by run on a little; what is square to them is marked.
void PolesPanel::draw_rays(Plot& plot) const {
  constexpr double beyond = 6;  // mm
  for (const auto& [from, through] : lines_) plot.long_segment(from, *pole_, beyond, Meaning::construction);
  for (const Carried& X : points_) {
    if (distance(X.at, *pole_) == 0) continue;
    if (lines_.empty() && is_of_velocity())
      plot.long_segment(X.at, *pole_, beyond, Meaning::construction);
    else if (lines_.empty() || !is_on_a_line(X))
      plot.segment(X.at, *pole_, Meaning::construction);
    if (!is_of_velocity()) continue;
    plot.right_angle(X.at, *pole_, plot.tip(X.at, X.v));
    if (is_by_the_tips_) plot.long_segment(plot.tip(X.at, X.v), *pole_, beyond, Meaning::construction);
  }
}

Place PolesPanel::end_of_ray(const Carried& X, const Plot& plot, const drawings::Box& room) const {
  return ray_to_edge(plot, room, X.at, towards_pole(X));
}

// The pole is too far to be shown, or at infinity. The lines it is found by tell where it is.
void PolesPanel::draw_leaving_rays(Plot& plot, const drawings::Box& room, Language language) const {
  for (const Carried& X : points_) {
    if (magnitude(X.v) == 0 || (!pole_ && !is_of_velocity())) continue;
    if (is_on_a_line(X))
      draw_towards(plot, room, X.at, X.at + towards_pole(X), kind_.letters, language);
    else
      plot.segment(X.at, at_edge(plot, room, X.at, towards_pole(X)), Meaning::construction);
  }
}

void PolesPanel::draw_pole(Plot& plot) const {
  plot.cross(*pole_, kind_.ink);
  if (!kind_.letters.empty()) plot.label(kind_.letters, *pole_, middle_of(mechanism_->corners()), kind_.ink);
  if (reports_pole_) plot.measures_coordinates(kind_.prefix + kind_.pole, *pole_, origin_);
  for (const Carried& X : points_)
    if (contains(reported_rays_, X.name)) plot.measures(name_of_ray(X.name), *pole_, X.at);
}

// On the side of the mechanism, where the rays are.
void PolesPanel::draw_turning(Plot& plot) const {
  constexpr double radius = 8, nearest = 1.0, farthest = 2.2;  // mm, radians from the rays
  if (sense_ == 0) return;
  const double way = sense_ > 0 ? 1 : -1, rays = direction(*pole_, middle_of(mechanism_->corners()));
  plot.mark(drawings::Rotation{plot.at(*pole_), radius, rays - farthest * way, rays - nearest * way});
  const double middle = rays - (nearest + farthest) / 2 * way, out = (radius + 1) / plot.scale().mm_per_unit;
  plot.label(turning_symbol_, {pole_->x + out * std::cos(middle), pole_->y + out * std::sin(middle)}, *pole_);
}

// γ at X: from the ray XK to the acceleration. No arc where there is none to see.
void PolesPanel::mark_inclination(Plot& plot, const Carried& X) const {
  constexpr double radius = 10, shortest_arc = 2;  // mm
  const double ray = direction(X.at, *pole_), vector = std::atan2(X.v.y, X.v.x);
  const double turn = std::remainder(vector - ray, 2 * std::numbers::pi);
  if (magnitude(X.v) == 0 || std::abs(turn) * radius < shortest_arc) return;
  plot.mark(drawings::AngleMark{plot.at(X.at), radius, std::min(ray, ray + turn), std::max(ray, ray + turn),
                                Meaning::dimension});
  const double middle = ray + turn / 2;
  const drawings::Point c = plot.at(X.at);
  plot.label("$γ$", plot.from_paper({c.x + radius * std::cos(middle), c.y + radius * std::sin(middle)}), X.at);
}

void PolesPanel::draw_given(Plot& plot, const drawings::Box&, Language) const {
  if (is_sketched_)
    mechanism_->sketch(plot);
  else
    mechanism_->draw_given(plot);
}

std::vector<drawings::Block> PolesPanel::draw(Plot& plot, const drawings::Box& room, Language language) const {
  const bool shows_pole = this->shows_pole(plot, room);
  const auto draw_all_rays = [&] {
    if (shows_pole)
      draw_rays(plot);
    else
      draw_leaving_rays(plot, room, language);
  };
  if (is_of_velocity()) draw_all_rays();
  if (is_sketched_)
    mechanism_->sketch(plot);
  else
    mechanism_->draw(plot);
  if (!is_of_velocity()) draw_all_rays();  // over blocks, or γ would have but one side there
  if (shows_pole) {
    draw_pole(plot);
    draw_turning(plot);
  }
  std::vector<VectorOnPaper> vectors;
  for (const Carried& X : points_) vectors.emplace_back(plot.at(X.at), plot.at(plot.tip(X.at, X.v)));
  const std::vector<drawings::Point> aside = in_rows(vectors, plot.onto().sheet.figure.marks);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Carried& X = points_[i];
    const double mm = drawings::distance(vectors[i].first, vectors[i].second);
    const Place from = plot.from_paper(vectors[i].first + aside[i]);
    if (drawings::length(aside[i]) > 0) plot.segment(X.at, from, Meaning::dimension);
    plot.vector_on(
        X.quantity.name, from, X.v, is_of_velocity() ? Meaning::velocity : Meaning::acceleration,
        letters_or_value(X.quantity.arrow(), magnitude(X.v), mm, written_unit(X.quantity.unit, language), language));
    if (contains(reported_points_, X.name)) plot.measures_coordinates(kind_.prefix + X.name, X.at, origin_);
  }
  if (pole_ && !is_of_velocity())
    for (const Carried& X : points_) mark_inclination(plot, X);
  return {};
}

// Of the first two lines on which the pole lies.
std::vector<double> PolesPanel::crossings() const {
  if (!pole_) return {};
  std::vector<Arrow2> lines;
  for (const auto& [from, through] : lines_) lines.push_back(*pole_ - from);
  if (lines.empty())
    for (const Carried& X : points_) lines.push_back(*pole_ - X.at);
  std::erase_if(lines, [](const Arrow2& line) { return magnitude(line) == 0; });
  if (lines.size() < 2) return {};
  return {crossing_angle(lines[0], lines[1])};
}

std::vector<PanelStep> PolesPanel::steps(const Plot& plot, const drawings::Box& room) const {
  constexpr double along_ray = 0.6;
  using Where = PolesStep::Where;
  std::vector<PanelStep> placed;
  for (const PolesStep& step : steps_) {
    placed.push_back({step.text});
    std::optional<Place>& at = placed.back().at;
    if (step.where == Where::pole)
      at = shows_pole(plot, room) || !pole_ || points_.empty() ? pole_ : end_of_ray(points_.front(), plot, room);
    if (step.where == Where::point) at = carried(step.of).at;
    if (step.where == Where::tip) at = plot.tip(carried(step.of).at, carried(step.of).v);
    if (step.where != Where::ray) continue;
    const Carried& X = carried(step.of);
    at = shows_pole(plot, room) ? X.at + along_ray * (*pole_ - X.at) : end_of_ray(X, plot, room);
  }
  return placed;
}

// Velocities by the rate; accelerations in the proportion of their rays, from that of the first point, which is
// known.
std::optional<MeasuredTable> PolesPanel::measured(const Readings& readings) const {
  MeasuredTable table{.heading = {"Comparison, measured on the sheet", "Confronto, misure sul foglio"},
                      .rows = {},
                      .first = {"poles", "poli"},
                      .second = {"exact", "esatto"}};
  const auto row = [&](const Carried& X, double by_the_pole, double vector) {
    table.rows.push_back({X.quantity.length().symbol + " (" + vectors().unit + ")", by_the_pole, vector});
  };
  const auto ray = [&](const Carried& X) { return name_of_ray(X.name); };
  if (is_of_velocity() && rate_) {
    const std::string by_the_pole = "$" + rate_symbol_ + "$·$" + point_letters(kind_.pole) + "X$";
    table.first = {by_the_pole, by_the_pole};
    table.second = {"vector", "vettore"};
    for (const Carried& X : points_)
      if (readings.has(ray(X)) && readings.is_unit(ray(X)) && readings.has(X.quantity.name))
        row(X, std::abs(*rate_) * readings[ray(X)], readings[X.quantity.name]);
  } else if (!is_of_velocity() && !points_.empty() && readings.has(ray(points_.front())) &&
             readings.is_unit(ray(points_.front()))) {
    const Carried& driven = points_.front();
    for (const Carried& X : points_)
      if (&X != &driven && readings.has(ray(X)))
        row(X, readings[ray(X)] / readings[ray(driven)] * magnitude(driven.v), magnitude(X.v));
  }
  return table;
}

}  // namespace epure
