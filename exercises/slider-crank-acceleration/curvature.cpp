// Sheet 4: centres of curvature of the paths of C and M: P₀X² = Ω_X X · X'X, X' on the inflection circle.
// Above, the rays as far as the inflection circle; below, the mechanism with the osculating circles, larger.
#include <fmt/format.h>

#include <cmath>

#include "exercises/kit/fit.h"
#include "exercises/kit/sheet.h"
#include "exercises/slider-crank-acceleration/exercise.h"

namespace epure::slider_crank_acceleration {
namespace {

constexpr double overview_share = 0.53;  // of the room's height

struct Traced {
  std::string symbol;
  Place at;
  Curvature curvature;
};

std::vector<Traced> traced(const Drawn& f) { return {{"C", f.at.C, f.C}, {"M", f.at.M, f.M}}; }

bool is_near(const Drawn& f, const std::optional<Place>& P, double times) {
  return P && std::hypot(P->x, P->y) < times * reach(f.at);
}

void draw_overview(Plot& plot, const Drawn& f) {
  plot.cycle(f.inflection, Meaning::locus);
  sketch_slider_crank(plot, f.at);
  for (const Traced& X : traced(f)) {
    if (!f.P0 || !is_near(f, X.curvature.on_circle, 6)) continue;
    plot.segment(*f.P0, *X.curvature.on_circle, Meaning::construction);
    plot.dot(*X.curvature.on_circle, Meaning::locus);
    plot.label("$" + X.symbol + "'$", *X.curvature.on_circle, f.P0, Meaning::locus);
    plot.measures(X.symbol + "prime_" + X.symbol, *X.curvature.on_circle, X.at);
    plot.measures_coordinates(X.symbol + "prime", *X.curvature.on_circle, f.at.A0);
    plot.step(X.symbol == "C" ? 1 : 2, *X.curvature.on_circle);
  }
  if (is_near(f, f.P0, 6)) {
    plot.cross(*f.P0);
    plot.label("$P_{0}$", *f.P0, f.at.M, Meaning::locus);
  }
}

drawings::Box overview_extent(const Drawn& f, const Scale& scale) {
  Extent extent;
  for (const Place& P : {f.at.A0, f.at.A, f.at.B, f.at.C}) extent.include(scale, P, 6);
  if (is_near(f, f.P0, 6)) extent.include(scale, *f.P0, 8);
  for (const Traced& X : traced(f)) {
    if (is_near(f, X.curvature.on_circle, 6)) extent.include(scale, *X.curvature.on_circle, 8);
  }
  return extent.box();
}

void draw_detail(Plot& plot, const Drawn& f) {
  if (is_near(f, f.P0, 1.5)) {
    for (const Traced& X : traced(f)) {
      plot.segment(X.at, *f.P0, Meaning::construction);
      plot.measures("P0" + X.symbol, *f.P0, X.at);
    }
    plot.cross(*f.P0);
    plot.label("$P_{0}$", *f.P0, f.at.M, Meaning::locus);
    plot.measures_coordinates("P0", *f.P0, f.at.A0);
  }
  draw_slider_crank(plot, f.at, f.omega_2);
  for (const Traced& X : traced(f)) {
    if (!is_near(f, X.curvature.centre, 2)) continue;
    const Place centre = *X.curvature.centre;
    plot.circle(centre, std::hypot(X.at.x - centre.x, X.at.y - centre.y), Meaning::construction);
    plot.segment(centre, X.at, Meaning::dimension, "rho_" + X.symbol);
    plot.cross(centre);
    plot.label("$Ω_{" + X.symbol + "}$", centre, X.at, Meaning::locus);
    plot.measures("rho_" + X.symbol, centre, X.at);
    plot.measures_coordinates("curvature_centre_" + X.symbol, centre, f.at.A0);
    plot.step(X.symbol == "C" ? 3 : 4, centre);
  }
}

drawings::Box detail_extent(const Drawn& f, const Scale& scale) {
  Extent extent;
  include_slider_crank(extent, scale, f.at);
  if (is_near(f, f.P0, 1.5)) extent.include(scale, *f.P0, 8);
  for (const Traced& X : traced(f)) {
    if (is_near(f, X.curvature.centre, 2)) extent.include(scale, *X.curvature.centre, 8);
  }
  return extent.box();
}

// With the pole at infinity C' and M' are there too, and only the last two steps are left.
drawings::Steps steps_without_pole(Language language) {
  if (language == Language::english) {
    return {{"$P_{0}$ is at infinity, and $C'$ with it. $Ω_{C}$ on the normal to $\\vec{v}_{C}$, at $ρ_{C}$ = "
             "$v^{2}_{C}$ / $a^{n}_{C}$.",
             "Likewise $Ω_{M}$. The thin circles are the osculating circles of the two paths."},
            3};
  }
  return {{"$P_{0}$ è all'infinito, e $C'$ con lui. $Ω_{C}$ sulla normale a $\\vec{v}_{C}$, a $ρ_{C}$ = $v^{2}_{C}$ "
           "/ $a^{n}_{C}$.",
           "Così $Ω_{M}$. I cerchi sottili sono i cerchi osculatori delle due traiettorie."},
          3};
}

drawings::Steps steps(Language language) {
  if (language == Language::english) {
    return {{"The ray $P_{0}C$ meets the inflection circle again in $C'$.", "Likewise $M'$ on the ray $P_{0}M$.",
             "Euler-Savary: $P_{0}C^{2}$ = $Ω_{C}C$·$C'C$ gives $Ω_{C}$ on the ray, on the same side of $C$ as $C'$.",
             "Likewise $Ω_{M}$: $P_{0}M^{2}$ = $Ω_{M}M$·$M'M$. The thin circles are the osculating circles of the "
             "two paths."}};
  }
  return {{"Il raggio $P_{0}C$ incontra ancora la circonferenza dei flessi in $C'$.",
           "Così $M'$ sul raggio $P_{0}M$.",
           "Euler-Savary: $P_{0}C^{2}$ = $Ω_{C}C$·$C'C$ dà $Ω_{C}$ sul raggio, dalla stessa parte di $C'$ rispetto a "
           "$C$.",
           "Così $Ω_{M}$: $P_{0}M^{2}$ = $Ω_{M}M$·$M'M$. I cerchi sottili sono i cerchi osculatori delle due "
           "traiettorie."}};
}

drawings::Table results(const Drawn& f, Language language) {
  drawings::Table table{{"$X$", "$P_{0}X$ (m)", "$X'X$ (m)", "$ρ_{X}$ (m)"}, {}};
  const auto distance = [&](const std::optional<Place>& P, const Place& X) {
    return P ? figures(std::hypot(P->x - X.x, P->y - X.y), 4, language) : std::string("∞");
  };
  for (const Traced& X : traced(f)) {
    table.rows.push_back({"$" + X.symbol + "$", distance(f.P0, X.at), distance(X.curvature.on_circle, X.at),
                          distance(X.curvature.centre, X.at)});
  }
  return table;
}

}  // namespace

void draw_curvature(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const Language language = request.language;
  const bool english = language == Language::english;
  const drawings::Box room = room_above_scale_bars(request);
  const double divide = room.high.y - overview_share * room.height();
  const drawings::Box above{{room.low.x, divide}, room.high}, below{room.low, {room.high.x, divide}};
  SheetRequest own_scale = request;
  own_scale.scale.reset();  // --scale is for the mechanism
  const Fit overview = fit_lengths(above, own_scale, 1000 / reach(f.at),
                                   [&](const Scale& scale) { return overview_extent(f, scale); });
  const Fit detail =
      fit_lengths(below, request, 1000 / reach(f.at), [&](const Scale& scale) { return detail_extent(f, scale); });
  Plot far(onto, overview.origin, overview.scale), near(onto, detail.origin, detail.scale);
  onto.sheet.figure.windows = {above, below};
  draw_overview(far, f);
  onto.sheet.figure.window_of.resize(onto.sheet.figure.marks.size(), 0);
  draw_detail(near, f);
  onto.sheet.figure.window_of.resize(onto.sheet.figure.marks.size(), 1);
  Scale upper = overview.scale, lower = detail.scale;
  upper.caption += english ? " above" : " sopra";
  lower.caption += english ? " below" : " sotto";
  add_scale_bars(onto, {upper, lower}, request);
  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(f.P0 ? steps(language) : steps_without_pole(language));
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  column.push_back(results(f, language));
  std::vector<Value> values;
  for (const Traced& X : traced(f)) {
    if (!X.curvature.centre) continue;
    values.push_back(
        {"ρ_" + X.symbol, std::hypot(X.curvature.centre->x - X.at.x, X.curvature.centre->y - X.at.y), "m"});
  }
  onto.sheet.description =
      in_words({"Centres of curvature of the paths of C and M by Euler-Savary, with their osculating circles",
                "Centri di curvatura delle traiettorie di C e M con Euler-Savary, con i cerchi osculatori"},
               values, language);
}

}  // namespace epure::slider_crank_acceleration
