// Acceleration, velocity and space by graphical integration.
#include "exercises/kit/panels/integration_panel.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/statement/decimal.h"
#include "exercises/point-mass/exercise.h"
#include "exercises/point-mass/motion.h"
#include "exercises/point-mass/quantities.h"
#include "geometry/constructions/graphical_integral.h"

namespace epure::point_mass {
namespace {

std::vector<double> heights(const geometry::IntegralPolygon<double>& polygon) {
  std::vector<double> all;
  for (const auto& corner : polygon.corners) all.push_back(corner.y);
  return all;
}

// The polygons' ordinates at the three instants.
std::vector<IntegrationRow::Read> read(const Solution& s, const Problem& of, const std::string& kind) {
  std::vector<IntegrationRow::Read> all;
  for (int i = 0; i < 3; ++i) {
    const Quantity quantity = ordinate_of_polygon(kind, std::to_string(i + 1));
    const std::string name = "graphical." + quantity.name;
    all.push_back({name, quantity.symbol, nearest(of.t[i]), s[name]});
  }
  return all;
}

IntegrationPanel panel(const Solution& s) {
  const Problem of(s.givens());
  const ByPowers motion(of);
  std::vector<double> ends, means;
  for (const Rational& end : of.strip_ends()) ends.push_back(nearest(end));
  for (std::size_t i = 1; i < ends.size(); ++i) means.push_back(motion.a.at((ends[i - 1] + ends[i]) / 2));
  const auto v = geometry::graphical_integral<double>(ends, means, 1);
  const auto space = geometry::graphical_integral<double>(ends, v.middles(), 1);
  return IntegrationPanel({.letters = "$t$", .unit = "s", .ends = ends},
                          {{.letters = "$a$",
                            .unit = "m/s²",
                            .meaning = Meaning::acceleration,
                            .curve = [motion](double t) { return motion.a.at(t); },
                            .carried = means},
                           {.letters = "$v$",
                            .unit = "m/s",
                            .meaning = Meaning::velocity,
                            .id = "v-polygon",
                            .curve = [motion](double t) { return motion.v.at(t); },
                            .corners = heights(v),
                            .carried = v.middles(),
                            .read = read(s, of, "v")},
                           {.letters = "$s$",
                            .unit = "m",
                            .meaning = Meaning::locus,
                            .id = "s-polygon",
                            .curve = [motion](double t) { return motion.s.at(t); },
                            .corners = heights(space),
                            .read = read(s, of, "s")}});
}

}  // namespace

PanelSheet integration_sheet(const Solution& s, Language language) {
  const auto name = [](const char* quantity) { return std::string("graphical.") + quantity; };
  const Words poles{
      "At the scales of the source, where a centimetre is $u_{t}$, $u_{a}$, $u_{v}$, $u_{s}$, the poles would stand "
      "$\\it{H}_{v}$ = $u_{v}$/$u_{t}u_{a}$ and $\\it{H}_{s}$ = $u_{s}$/$u_{t}u_{v}$ centimetres from the axis:",
      "Alle scale della fonte, dove un centimetro vale $u_{t}$, $u_{a}$, $u_{v}$, $u_{s}$, i poli disterebbero "
      "$\\it{H}_{v}$ = $u_{v}$/$u_{t}u_{a}$ e $\\it{H}_{s}$ = $u_{s}$/$u_{t}u_{v}$ centimetri dall'asse:"};
  const bool are_above = s[name("off_v")] >= 0 && s[name("off_s")] >= 0;
  const Words distances = are_above
                              ? Words{"At their ends the polygons stand above the true curves by",
                                      "Agli estremi i poligoni stanno sopra le curve esatte di"}
                              : Words{"At their ends the polygons stand above (+) or below (−) the true curves by",
                                      "Agli estremi i poligoni stanno sopra (+) o sotto (−) le curve esatte di"};
  return {
      .panels = panels(panel(s)),
      .results = {table({"", "$t_{1}$", "$t_{2}$", "$t_{3}$"},
                        {{"$v_{g}$ (m/s)", {name("v_1"), name("v_2"), name("v_3")}},
                         {"$v$ (m/s)", {"v_1", "v_2", "v_3"}},
                         {"$s_{g}$ (m)", {name("s_1"), name("s_2"), name("s_3")}},
                         {"$s$ (m)", {"s_1", "s_2", "s_3"}}}),
                  remark(distances.in(language)), values({name("off_v"), name("off_s")}), remark(poles.in(language)),
                  values({name("pole_distance_v"), name("pole_distance_s")})},
      .seen =
          {"Acceleration, and below it velocity and space as integral polygons, each with the pole of its rays",
           "L'accelerazione e, sotto, velocità e spazio come poligoni integrali, ciascuno col polo dei suoi raggi"},
      .told = {name("v_1"), name("v_2"), name("v_3"), name("s_1"), name("s_2"), name("s_3")},
      .without_part = {"dt"}};
}

}  // namespace epure::point_mass
