// Sheet 4: the path of C by the transport method: the triangle ABC of the instant carried onto the AB of each
// position.
#include <fmt/format.h>

#include <cmath>

#include "exercises/kit/panels/curve.h"
#include "exercises/kit/panels/fit.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/slider-crank-velocity/loci.h"

namespace epure::slider_crank_velocity {
namespace {

drawings::Box extent(const Drawn& f, const std::vector<Position>& all, const Scale& scale) {
  Extent extent;
  const double r = std::hypot(f.at.A.x, f.at.A.y);
  extent.include(scale, {-r, -r}, 1);
  extent.include(scale, {r, r}, 4);
  for (const Position& at : all) {
    extent.include(scale, at.B, 1);
    extent.include(scale, at.C, 7);
  }
  extent.include(scale, f.at.B, 8);
  extent.include(scale, f.at.C, 8);
  if (f.instant.is_offset() || f.instant.is_inclined()) include_slider_crank(extent, scale, f.at);
  return extent.box();
}

void draw_positions(Plot& plot, const Drawn& f, const std::vector<Position>& all) {
  for (const Position& at : all) {
    plot.polygon({at.A, at.B, at.C}, Meaning::alternative);
    plot.dot(at.A, Meaning::construction);
    plot.dot(at.C, Meaning::locus);
    plot.small_label(at.label, at.A, f.at.A0);
    plot.small_label(at.label, at.C, Place{(at.A.x + at.B.x) / 2, (at.A.y + at.B.y) / 2});
  }
  if (all.empty()) return;
  // Where there is room; a swinging crank does not reach every position.
  const auto position = [&](std::size_t number) -> const Position& {
    for (const Position& at : all)
      if (at.number == static_cast<int>(number)) return at;
    return all[number % all.size()];
  };
  plot.step(2, position(3).B);
  plot.step(3, position(4).C);
  plot.step(1, position(5).A);
  plot.step(4, position(8).C);
}

drawings::Steps steps(const SliderCrankInstant& instant, Language language) {
  if (language == Language::english) {
    return {{division_in_words(instant, language),
             "The slider: each $B$ on the guide by the arc of radius $l$ about its $A$.",
             "The triangle $ABC$ on tracing paper, carried forth until its $AB$ covers that of each position: $C$ "
             "marks a point.",
             "The curve through the points: the path of $C$."}};
  }
  return {{division_in_words(instant, language),
           "Il piede di biella: ogni $B$ sulla guida con l'arco di raggio $l$ dal suo $A$.",
           "Il triangolo $ABC$ su carta da lucido, portato finché il suo $AB$ copre quello di ogni posizione: $C$ "
           "segna un punto.",
           "La curva per i punti: la traiettoria di $C$."}};
}

}  // namespace

void draw_coupler_curve(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const drawings::Box room = room_above_scale_bars(request);
  const std::vector<Position> all = divided_positions(f.instant);
  const double size = std::hypot(f.at.A.x, f.at.A.y) + CGAL::to_double(f.instant.lengths.l);
  const Fit fit = fit_lengths(room, request, 1000 / size, [&](const Scale& scale) { return extent(f, all, scale); });
  Plot plot(onto, fit.origin, fit.scale);
  draw_positions(plot, f, all);
  const geometry::Arithmetic<geometry::Bounded> scope;
  const Reference reference = reference_of(f.instant);
  const auto curve = [&](const geometry::SliderCrankLoop<geometry::Bounded>& loop) {
    return geometry::CouplerCurve<geometry::Bounded>{loop, reference.coupler, reference.C};
  };
  const geometry::Trace path = draw_loci(plot, f.instant, curve, room, Meaning::locus, "path_of_C");
  draw_slider_crank(plot, f.at, sign_of(f.instant.n));
  plot.measures_coordinates("C", f.at.C, f.at.A0);
  add_scale_bars(onto, {fit.scale}, request);

  const bool english = request.language == Language::english;
  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(steps(f.instant, request.language));
  column.push_back(drawings::Heading{english ? "The curve" : "La curva"});
  column.push_back(drawings::Paragraph{fmt::format(
      fmt::runtime(english ? "{} Bezier arcs, at most {} mm on this sheet from the true path."
                           : "{} archi di Bézier, su questo foglio a non più di {} mm dalla traiettoria vera."),
      path.arcs(), figures(path.deviation() * fit.scale.mm_per_unit, 1, request.language))});
  onto.sheet.description =
      in_words({"The path of the coupler point C by the transport method, in twelve positions; C now",
                "La traiettoria del punto di biella C col metodo del trasporto, in dodici posizioni; C ora"},
               {{"x_C", f.at.C.x, "m"}, {"y_C", f.at.C.y, "m"}}, request.language);
}

}  // namespace epure::slider_crank_velocity
