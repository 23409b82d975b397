#include "exercises/kit/panels/support_polygon_panel.h"

#include <algorithm>

#include "exercises/kit/panels/on_sides.h"

namespace epure {
namespace {

constexpr double beside_loads = 8;  // mm, of reactions that would lie on them

}  // namespace

std::vector<Place> SupportPolygonPanel::all_points() const {
  std::vector<Place> all = funicular_.polygon.corners;
  all.push_back(funicular_.polygon.pole);
  all.push_back(funicular_.polygon.between);
  return all;
}

Panel::Vectors SupportPolygonPanel::vectors() const {
  constexpr double longest_on_paper = 100;  // mm: longer the truss beside it would have no room
  double longest = 0;
  for (const Place& P : all_points())
    for (const Place& Q : all_points()) longest = std::max(longest, distance(P, Q));
  return {"N", longest, longest_on_paper};
}

Arrow2 SupportPolygonPanel::aside(double mm, const Scale& vectors) const {
  const std::vector<Place>& corners = funicular_.polygon.corners;
  std::vector<std::pair<Place, Place>> sides;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) sides.emplace_back(corners[i], corners[i + 1]);
  const Place& between = funicular_.polygon.between;
  const bool by_roller = covers(1, sides);
  if (!by_roller && !covers(0, sides)) return {0, 0};
  const Arrow2 normal = geometry::quarter_turn(by_roller ? between - corners.back() : corners.front() - between);
  const double side = dot(normal, funicular_.polygon.pole - corners.front()) > 0 ? -1 : 1;
  return (side * mm / vectors.mm_per_unit / magnitude(normal)) * normal;
}

// Of a reaction, places in TrussFigure::outside.
bool SupportPolygonPanel::covers(std::size_t reaction, const std::vector<std::pair<Place, Place>>& sides) const {
  if (magnitude(figure_->outside[reaction].f) == 0) return false;
  const std::vector<Place>& corners = funicular_.polygon.corners;
  const Place& between = funicular_.polygon.between;
  return reaction == 1 ? lies_on_a_side(corners.back(), between, sides)
                       : lies_on_a_side(between, corners.front(), sides);
}

// The ends of the loads: with large reactions they crowd.
std::vector<Place> SupportPolygonPanel::lettered() const { return funicular_.polygon.corners; }

drawings::Box SupportPolygonPanel::extent(const Scale&, const Scale& vectors) const {
  constexpr double air = 8;  // mm
  Extent extent;
  for (const Place& P : all_points()) {
    extent.include(vectors, P, air);
    extent.include(vectors, P + aside(2 * beside_loads, vectors), air);
  }
  return extent.box();
}

std::vector<drawings::Block> SupportPolygonPanel::draw(Plot& plot, const drawings::Box&, Language) const {
  const geometry::SupportPolygon<double>& polygon = funicular_.polygon;
  const std::vector<Place>& corners = polygon.corners;
  const auto ray = [&](const Place& to, const std::string& letters) {
    plot.segment(polygon.pole, to, Meaning::construction);
    plot.label(letters, polygon.pole + 0.5 * (to - polygon.pole));
  };
  constexpr int rays = 1, closed = 2;  // the steps
  plot.in_step(rays);
  for (std::size_t i = 0; i < corners.size(); ++i) ray(corners[i], std::to_string(i + 1));
  plot.in_step(closed);
  ray(polygon.between, "$c$");
  plot.in_step(rays);
  for (std::size_t i = 0; i < funicular_.loads.size(); ++i)
    plot.side("", corners[i], corners[i + 1], Meaning::force, figure_->outside[funicular_.loads[i]].label);
  plot.in_step(closed);
  const Arrow2 off = aside(beside_loads, plot.scale());
  const auto reaction = [&](std::size_t k, const Place& from, const Place& to) {
    const TrussFigure::Outside& of = figure_->outside[k];
    if (magnitude(of.f) != 0) plot.side(of.quantity, from, to, Meaning::force, of.label);
  };
  reaction(1, corners.back() + off, polygon.between + off);
  // In a row of its own, where it would lie on the roller's, which is pulled.
  const bool is_covered = magnitude(off) != 0 && covers(0, {{corners.back(), polygon.between}});
  const Arrow2 off_hinge = is_covered ? 2.0 * off : off;
  reaction(0, polygon.between + off_hinge, corners.front() + off_hinge);
  if (magnitude(off) != 0)
    for (const Place& P : {corners.front(), corners.back(), polygon.between})
      plot.segment(P, P + off_hinge, Meaning::construction);
  plot.in_step(rays);
  plot.cross(polygon.pole, Meaning::force);
  plot.label("$O_{f}$", polygon.pole, corners.front(), Meaning::force);
  return {};
}

std::vector<PanelStep> SupportPolygonPanel::steps(const Plot&, const drawings::Box&) const {
  const std::string &A = figure_->outside[0].label, &B = figure_->outside[1].label;
  return {{{"The loads end to end, a pole $O_{f}$ beside them and a ray to each of their ends.",
            "I carichi uno dopo l'altro, accanto ad essi un polo $O_{f}$ e un raggio a ogni loro estremo."},
           funicular_.polygon.pole},
          {Words{"The ray $c$ parallel to the closing line $c′$ (found on the truss) and the roller's direction from "
                 "the end of the loads meet: there " +
                     B + " ends, and " + A + " closes.",
                 "Il raggio $c$ parallelo alla chiudente $c′$ (trovata sulla travatura) e la direzione del carrello "
                 "dall'estremo dei carichi si incontrano: lì finisce la " +
                     B + ", e la " + A + " chiude."},
           funicular_.polygon.between, true}};
}

}  // namespace epure
