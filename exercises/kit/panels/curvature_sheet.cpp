// Above, the rays as far as the inflection circle; below, the mechanism with the osculating circles, larger.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exercises/kit/panels/coupler_figure.h"
#include "exercises/kit/panels/edge.h"
#include "exercises/kit/panels/fit.h"
#include "exercises/kit/panels/sheet.h"

namespace epure {
namespace {

constexpr double overview_share = 0.53;                 // of the room's height
constexpr double overview_reach = 6, detail_reach = 2;  // times the mechanism's reach: what is still shown

using Points = std::vector<CouplerPoint>;

Points named(const CouplerFigure& f, const std::vector<std::string>& letters) {
  Points found;
  for (const CouplerPoint& X : f.points)
    if (std::find(letters.begin(), letters.end(), X.letter) != letters.end()) found.push_back(X);
  return found;
}

std::string primed(const CouplerPoint& X) { return "$" + X.written() + "'$"; }
std::string centre_of(const CouplerPoint& X) { return "$Ω_{" + X.letter + "}$"; }

// Steps 1, 2, ... are the points on the inflection circle, the next as many their centres of curvature.
void draw_overview(Plot& plot, const CouplerFigure& f, const Points& points) {
  plot.cycle(f.inflection, Meaning::locus);
  f.mechanism->sketch(plot);
  int step = 1;
  for (const CouplerPoint& X : points) {
    const int number = step++;
    if (!f.P0 || !f.is_near(X.on_circle, overview_reach)) continue;
    plot.segment(*f.P0, *X.on_circle, Meaning::construction);
    plot.segment(X.at, *X.on_circle, Meaning::construction);
    plot.dot(*X.on_circle, Meaning::locus);
    plot.label(primed(X), *X.on_circle, f.P0, Meaning::locus);
    plot.measures(f.prefix + X.letter + "prime_" + X.letter, *X.on_circle, X.at);
    plot.measures_coordinates(f.prefix + X.letter + "prime", *X.on_circle, f.mechanism->corners().front());
    plot.step(number, *X.on_circle);
  }
  if (f.is_near(f.P0, overview_reach)) {
    plot.cross(*f.P0);
    plot.label(f.pole_label(), *f.P0, f.middle(), Meaning::locus);
  }
}

drawings::Box overview_extent(const CouplerFigure& f, const Points& points, const Scale& scale) {
  Extent extent;
  for (const Place& P : f.mechanism->corners()) extent.include(scale, P, 6);
  if (f.is_near(f.P0, overview_reach)) extent.include(scale, *f.P0, 8);
  for (const CouplerPoint& X : points) {
    if (f.is_near(X.on_circle, overview_reach)) extent.include(scale, *X.on_circle, 8);
  }
  return extent.box();
}

void draw_detail(Plot& plot, const CouplerFigure& f, const Points& points, const drawings::Box& room,
                 Language language) {
  const Place O = f.mechanism->corners().front();
  if (f.is_near(f.P0, detail_reach)) {
    for (const CouplerPoint& X : points) {
      plot.segment(X.at, *f.P0, Meaning::construction);
      plot.measures(f.prefix + f.pole + X.letter, *f.P0, X.at);
    }
    plot.cross(*f.P0);
    plot.label(f.pole_label(), *f.P0, f.middle(), Meaning::locus);
    plot.measures_coordinates(f.prefix + f.pole, *f.P0, O);
  }
  f.mechanism->draw(plot);
  int step = static_cast<int>(points.size()) + 1;
  for (const CouplerPoint& X : points) {
    const int number = step++;
    if (!X.centre) continue;
    const Place centre = *X.centre;
    plot.cycle(circle_through(X.at, centre), Meaning::construction);
    if (!is_in(room, plot, centre)) {
      plot.step(number, draw_towards(plot, room, X.at, centre, centre_of(X), language));
      continue;
    }
    plot.segment(centre, X.at, Meaning::dimension, "rho_" + X.letter);
    plot.cross(centre);
    plot.label(centre_of(X), centre, X.at, Meaning::locus);
    plot.measures(f.prefix + "rho_" + X.letter, centre, X.at);
    plot.measures_coordinates(f.prefix + "curvature_centre_" + X.letter, centre, O);
    plot.step(number, centre);
  }
}

drawings::Box detail_extent(const CouplerFigure& f, const Points& points, const Scale& scale) {
  Extent extent;
  f.mechanism->include(extent, scale);
  if (f.is_near(f.P0, detail_reach)) extent.include(scale, *f.P0, 8);
  for (const CouplerPoint& X : points) {
    if (f.is_near(X.centre, detail_reach)) extent.include(scale, *X.centre, 8);
  }
  return extent.box();
}

OffSheet left_out_above(const Plot& plot, const CouplerFigure& f, const Points& points, const drawings::Box& room) {
  OffSheet off(plot, room);
  off.point(f.pole_label(), f.P0);
  for (const CouplerPoint& X : points) off.point(primed(X), X.on_circle);
  off.circle({"part of the inflection circle", "parte della circonferenza dei flessi"}, f.inflection);
  return off;
}

OffSheet left_out_below(const Plot& plot, const Points& points, const drawings::Box& room) {
  OffSheet off(plot, room);
  for (const CouplerPoint& X : points) {
    off.point(centre_of(X), X.centre);
    if (X.centre)
      off.circle({"part of the circle about " + centre_of(X), "parte del cerchio di centro " + centre_of(X)},
                 circle_through(X.at, *X.centre));
  }
  return off;
}

drawings::Table curvature_lengths(const CouplerFigure& f, const Points& points, Language language) {
  drawings::Table table{{"$X$", "$" + f.pole_symbol + "X$ (m)", "$X'X$ (m)", "$ρ_{X}$ (m)"}, {}};
  const auto to = [&](const std::optional<Place>& P, const Place& X, const char* where_none) {
    return P ? figures(distance(*P, X), 4, language) : std::string(where_none);
  };
  for (const CouplerPoint& X : points) {
    const char* none = X.v.x == 0 && X.v.y == 0 ? "–" : "∞";  // the pole has no ray
    table.rows.push_back(
        {"$" + X.written() + "$", to(f.P0, X.at, "∞"), to(X.on_circle, X.at, none), to(X.centre, X.at, none)});
  }
  return table;
}

}  // namespace

void draw_curvature_sheet(DrawnSheet& onto, const CouplerFigure& f, const std::vector<std::string>& letters,
                          const SheetRequest& request, const SheetWords& words) {
  const Language language = request.language;
  const bool english = language == Language::english;
  const Points points = named(f, letters);
  const drawings::Box room = room_above_scale_bars(request);
  const double divide = room.high.y - overview_share * room.height();
  const drawings::Box above{{room.low.x, divide}, room.high}, below{room.low, {room.high.x, divide}};
  SheetRequest own_scale = request;
  own_scale.scale.reset();  // --scale is for the mechanism
  const double at_most = 1000 / f.mechanism->reach();
  const Fit overview =
      fit_lengths(above, own_scale, at_most, [&](const Scale& scale) { return overview_extent(f, points, scale); });
  const Fit detail =
      fit_lengths(below, request, at_most, [&](const Scale& scale) { return detail_extent(f, points, scale); });
  Plot upper_plot(onto, overview.origin, overview.scale), lower_plot(onto, detail.origin, detail.scale);
  onto.sheet.figure.windows = {above, below};
  draw_overview(upper_plot, f, points);
  onto.sheet.figure.window_of.resize(onto.sheet.figure.marks.size(), 0);
  draw_detail(lower_plot, f, points, below, language);
  onto.sheet.figure.window_of.resize(onto.sheet.figure.marks.size(), 1);
  Scale upper = overview.scale, lower = detail.scale;
  upper.caption += english ? " above" : " sopra";
  lower.caption += english ? " below" : " sotto";
  add_scale_bars(onto, {upper, lower}, request);
  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(words.steps);
  OffSheet off = left_out_above(upper_plot, f, points, above);
  off.add(left_out_below(lower_plot, points, below));
  if (const std::string sentence = off.sentence(language); !sentence.empty())
    column.push_back(drawings::Paragraph{sentence});
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  column.push_back(curvature_lengths(f, points, language));
  std::vector<Value> values;
  for (const CouplerPoint& X : points) {
    if (X.centre) values.push_back({"ρ_" + X.letter, distance(*X.centre, X.at), "m"});
  }
  onto.sheet.description = in_words(words.description, values, language);
}

}  // namespace epure
