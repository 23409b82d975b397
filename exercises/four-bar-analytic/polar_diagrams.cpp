// Sheets 2 and 3: v_B = v_A + v_BA, and a_B = a_A + a_BA, as polygons; the midpoints by similarity.
#include <fmt/format.h>

#include <cmath>

#include "exercises/four-bar-analytic/exercise.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::four_bar_analytic {
namespace {

constexpr double mechanism_share = 0.42;  // of the room's height; the polygon needs the larger part

Place tip(const Arrow2& v) { return {v.x, v.y}; }

struct Diagram {
  const VectorPolygon& polygon;
  std::string quantity;  // "v_", "a_"
  std::string letter;    // "v", "a"
  Words remark;          // on what the source printed
  Words description;
  std::vector<std::string> found;  // lines of results
  std::vector<Value> values;
};

Arrow2 image_of(const VectorPolygon& polygon, std::size_t i) { return polygon.images.at(i).absolute.v; }

// What the polygon shows besides its sides.
void measure(Plot& plot, const Diagram& of) {
  const Place O{0, 0};
  const auto size = [&](const char* G) { return of.quantity + G; };
  plot.measures_coordinates(of.quantity + "B", closing_corner(of.polygon), O);
  plot.measures_coordinates(size("G3"), tip(image_of(of.polygon, 0)), O);
  plot.measures_coordinates(size("G2"), tip(image_of(of.polygon, 1)), O);
  plot.measures_coordinates(size("G4"), tip(image_of(of.polygon, 2)), O);
}

drawings::Table results(const Diagram& of, Language language) {
  const auto num = [&](double x) { return figures(x, 4, language); };
  const auto row = [&](const std::string& X, const Arrow2& v) {
    return std::vector<std::string>{"$" + X + "$", num(v.x), num(v.y), num(magnitude(v))};
  };
  const std::string v = "$" + of.letter + "_{X}$ (" + of.polygon.unit + ")";
  const Place b = closing_corner(of.polygon);
  return {{"$X$", "x", "y", v},
          {row("B", {b.x, b.y}), row("G_{2}", image_of(of.polygon, 1)), row("G_{3}", image_of(of.polygon, 0)),
           row("G_{4}", image_of(of.polygon, 2))}};
}

void draw(DrawnSheet& onto, const Drawn& f, const Diagram& of, const SheetRequest& request) {
  const Language language = request.language;
  const bool english = language == Language::english;
  const drawings::Box room = room_above_scale_bars(request);
  const double divide = room.high.y - mechanism_share * room.height();
  const Scale lengths = draw_small(onto, f.figure, {{room.low.x, divide}, room.high}, request);
  const Fit fit = fit_polygon(of.polygon, {room.low, {room.high.x, divide}}, language);
  Plot plot(onto, fit.origin, fit.scale);
  draw_polygon(plot, of.polygon);
  measure(plot, of);
  add_scale_bars(onto, {lengths, plot.scale()}, request);
  auto& column = onto.sheet.column;
  column.push_back(equation(of.polygon));
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(drawings::Steps{steps_of(of.polygon, language)});
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  for (const std::string& line : of.found) column.push_back(drawings::Paragraph{line});
  column.push_back(results(of, language));
  column.push_back(drawings::Paragraph{of.remark.in(language)});
  onto.sheet.description = in_words(of.description, of.values, language);
}

}  // namespace

void draw_velocities(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const auto num = [&](double x) { return figures(x, 4, request.language); };
  draw(onto, f,
       {.polygon = f.velocity,
        .quantity = "v_",
        .letter = "v",
        .remark = {"The source's table writes $\\vec{v}_{B}$ ∥ $B_{0}B$: it is square to it.",
                   "La tabella della fonte scrive $\\vec{v}_{B}$ ∥ $B_{0}B$: è normale."},
        .description = {"The polygon of the velocities of the four-bar, with the images of the links' midpoints",
                        "Il poligono delle velocità del quadrilatero, con le immagini delle mezzerie"},
        .found = {fmt::format(
            "$ω_{{3}}$ = $v_{{BA}}$ / $AB$ = {} rad/s,  $ω_{{4}}$ = $v_{{B}}$ / $B_{{0}}B$ = {} rad/s",
            num(f.omega_3), num(f.omega_4))},
        .values = {{"ω₃", f.omega_3, "rad/s"}, {"ω₄", f.omega_4, "rad/s"}}},
       request);
}

void draw_accelerations(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const auto num = [&](double x) { return figures(x, 4, request.language); };
  draw(onto, f,
       {.polygon = f.acceleration,
        .quantity = "a_",
        .letter = "a",
        .remark =
            {"The source left $α_{4}$·$B_{0}G_{4}$ out of its $a_{G4}$ here, and calls normal and tangential what "
             "is along and square to $AB$.",
             "Qui la fonte dimentica $α_{4}$·$B_{0}G_{4}$ in $a_{G4}$, e chiama normale e tangenziale ciò che è "
             "lungo $AB$ e normale ad $AB$."},
        .description = {"The polygon of the accelerations of the four-bar, with the images of the links' midpoints",
                        "Il poligono delle accelerazioni del quadrilatero, con le immagini delle mezzerie"},
        .found = {fmt::format(
            "$α_{{3}}$ = $a^{{t}}_{{BA}}$ / $AB$ = {} rad/s²,  $α_{{4}}$ = $a^{{t}}_{{B}}$ / $B_{{0}}B$ = {} rad/s²",
            num(f.alpha_3), num(f.alpha_4))},
        .values = {{"α₃", f.alpha_3, "rad/s²"}, {"α₄", f.alpha_4, "rad/s²"}}},
       request);
}

}  // namespace epure::four_bar_analytic
