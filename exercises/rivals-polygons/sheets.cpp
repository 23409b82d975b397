// The four sheets: what stands beside the pictures.
#include <fmt/format.h>

#include <cmath>

#include "exercises/kit/panels/sheet.h"
#include "exercises/rivals-polygons/exercise.h"
#include "exercises/rivals-polygons/pictures.h"

namespace epure::rivals_polygons {
namespace {

double magnitude(const Arrow2& v) { return std::hypot(v.x, v.y); }

// What a sheet has of its own.
struct Content {
  const VectorPolygon& polygon;
  std::vector<int> figures;  // the source's numbers of the last pictures
  Words seen;                // for readers who do not see the sheet
};

std::vector<const PolygonSide*> reported(const VectorPolygon& polygon) {
  std::vector<const PolygonSide*> sides;
  for (const auto* chain : {&polygon.right, &polygon.left})
    for (const PolygonSide& side : *chain)
      if (side.is_drawn()) sides.push_back(&side);
  return sides;
}

void draw(DrawnSheet& onto, const Drawn& figure, const Content& content, const SheetRequest& request) {
  const Language language = request.language;
  const bool english = language == Language::english;
  const auto scales =
      draw_pictures(onto, figure.mechanism, content.polygon, pictures_of(content.polygon, content.figures), request);
  add_scale_bars(onto, scales, request);
  auto& column = onto.sheet.column;
  column.push_back(
      drawings::Paragraph{fmt::format("$ω_{{2}}$ = 2π·$n$ = {} rad/s", figures(figure.omega_2, 4, language))});
  column.push_back(equation(content.polygon));
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(drawings::Steps{steps_of(content.polygon, language)});
  column.push_back(drawings::Heading{english ? "Results, and as measured" : "Risultati, e come misurati"});
  column.push_back(measured_table(onto, content.polygon, language));
  std::vector<Value> values;
  for (const PolygonSide* side : reported(content.polygon))
    values.push_back({side->quantity, magnitude(side->v), content.polygon.unit});
  onto.sheet.description = in_words(content.seen, values, language);
}

std::string sense(double rate, Language language) {
  const Words words = rate > 0   ? Words{", counter-clockwise", ", antioraria"}
                      : rate < 0 ? Words{", clockwise", ", oraria"}
                                 : Words{};
  return words.in(language);
}

// What the polygon of velocities says of the coupler's rotation, and that of accelerations.
drawings::Paragraph rotation(const Drawn& figure, Language language) {
  return {fmt::format("$ω_{{3}}$ = $v_{{BA}}$ / $AB$ = {} rad/s{}", figures(figure.omega_3, 4, language),
                      sense(figure.omega_3, language))};
}
drawings::Paragraph angular_acceleration(const Drawn& figure, Language language) {
  return {fmt::format("$α_{{3}}$ = $a^{{t}}_{{BA}}$ / $AB$ = {} rad/s²{}", figures(figure.alpha_3, 4, language),
                      sense(figure.alpha_3, language))};
}

}  // namespace

void draw_velocity_of_B(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request) {
  draw(onto, figure,
       {figure.velocity_of_B,
        {2, 3, 4},
        {"The slider-crank, and the polygon of the velocities of B in three pictures",
         "Il manovellismo, e il poligono delle velocità di B in tre figure"}},
       request);
  onto.sheet.column.push_back(rotation(figure, request.language));
}

void draw_velocity_of_G(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request) {
  draw(onto, figure,
       {figure.velocity_of_G,
        {5, 6, 7, 8},
        {"The slider-crank, and the polygon of the velocities of G in four pictures",
         "Il manovellismo, e il poligono delle velocità di G in quattro figure"}},
       request);
  onto.sheet.column.push_back(rotation(figure, request.language));
}

void draw_acceleration_of_B(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request) {
  const Language language = request.language;
  draw(onto, figure,
       {figure.acceleration_of_B,
        {9, 10},
        {"The slider-crank, and the polygon of the accelerations of B, a step a picture",
         "Il manovellismo, e il poligono delle accelerazioni di B, un passo per figura"}},
       request);
  auto& column = onto.sheet.column;
  column.push_back(angular_acceleration(figure, language));
  const std::string wrong = figures(magnitude(figure.a_B_as_printed), 4, language),
                    right = figures(magnitude(figure.acceleration_of_B.left.back().v), 4, language);
  const Words remark{
      fmt::format(
          "The source's equation (1) has $\\vec{{a}}_{{A}}$ besides $\\vec{{a}}^{{n}}_{{A}}$ + "
          "$\\vec{{a}}^{{t}}_{{A}}$, which are its parts. Drawn so, it would give $a_{{B}}$ = {} m/s² instead "
          "of {} m/s². Its table 3 has it right.",
          wrong, right),
      fmt::format(
          "La (1) della fonte ha $\\vec{{a}}_{{A}}$ oltre ad $\\vec{{a}}^{{n}}_{{A}}$ + "
          "$\\vec{{a}}^{{t}}_{{A}}$, che ne sono le parti. Disegnata così darebbe $a_{{B}}$ = {} m/s² invece di "
          "{} m/s². La tabella 3 è giusta.",
          wrong, right)};
  column.push_back(drawings::Heading{language == Language::english ? "Remark" : "Osservazione"});
  column.push_back(drawings::Paragraph{remark.in(language)});
}

void draw_acceleration_of_G(DrawnSheet& onto, const Drawn& figure, const SheetRequest& request) {
  draw(onto, figure,
       {figure.acceleration_of_G,
        {},
        {"The slider-crank, and the polygon of the accelerations of G, a step a picture",
         "Il manovellismo, e il poligono delle accelerazioni di G, un passo per figura"}},
       request);
  onto.sheet.column.push_back(angular_acceleration(figure, request.language));
}

}  // namespace epure::rivals_polygons
