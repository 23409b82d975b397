// Sheet 2: a_B = a_B* + a_cor + a_rel as a polygon.
#include <fmt/format.h>

#include "exercises/kit/panels/polygon_picture.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/pin-in-slot/figure.h"

namespace epure::pin_in_slot {
namespace {

constexpr double mechanism_share = 0.45;  // of the room's height

bool is_zero(const Arrow2& v) { return v.x == 0 && v.y == 0; }

PolygonSide known(const std::string& label, const std::string& direction, const std::string& magnitude,
                  const Arrow2& v, const std::string& tip) {
  return {.label = label, .direction = direction, .magnitude = is_zero(v) ? "0" : magnitude, .v = v, .tip = tip};
}

// The tangential part first: so neighbours are square to each other, and a_cor never runs back over it.
VectorPolygon acceleration_polygon(const Drawn& f, Language language) {
  const Words guide{"∥ guide", "∥ guida"};
  PolygonSide coriolis = known("$\\vec{a}_{cor}$", "⊥ $OB$", "2$ω$·$v_{rel}$", f.a_cor, "$c$");
  coriolis.quantity = "a_cor";
  coriolis.square = true;
  return {.meaning = Meaning::acceleration,
          .unit = "m/s²",
          .origin = "$O_{a}$",
          .left = {{.quantity = "a_B",
                    .label = "$\\vec{a}_{B}$",
                    .direction = guide.in(language),
                    .magnitude = "?",
                    .v = f.a_B,
                    .along = {1, 0}}},
          .right = {known("$\\vec{a}^{t}_{B*}$", "⊥ $OB$", "($dω/dt$)·$OB$", f.a_Bstar_t, ""),
                    known("$\\vec{a}^{n}_{B*}$", "∥ $BO$", "$ω^{2}$·$OB$", f.a_Bstar_n, "$b*$"),
                    coriolis,
                    {.quantity = "b_ddot",
                     .label = "$\\vec{a}_{rel}$",
                     .direction = "∥ $OB$",
                     .magnitude = "?",
                     .v = f.a_rel,
                     .tip = "$b'$",
                     .along = f.slot}}};
}

// What follows from the polygon, and the sense of the Coriolis part.
std::string remarks(Language language) {
  return language == Language::english ? "$\\vec{a}_{cor}$ is $\\vec{v}_{rel}$ turned by 90° in the sense of $ω$. "
                                         "The disc's pole $D$ stays below "
                                         "$B$, so $α_{d}$ = −$a_{B}$ / $R$."
                                       : "$\\vec{a}_{cor}$ è $\\vec{v}_{rel}$ ruotata di 90° nel verso di $ω$. Il "
                                         "polo $D$ del disco resta sotto "
                                         "$B$, perciò $α_{d}$ = −$a_{B}$ / $R$.";
}

}  // namespace

void draw_acceleration(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const Language language = request.language;
  const drawings::Box room = room_above_scale_bars(request);
  const double divide = room.high.y - mechanism_share * room.height();
  const VectorPolygon polygon = acceleration_polygon(f, language);
  const Fit above = fit_mechanism(f, {{room.low.x, divide}, room.high}, request);
  Plot mechanism(onto, above.origin, above.scale);
  draw_mechanism(mechanism, f);
  const Fit below = fit_polygon(polygon, {room.low, {room.high.x, divide}}, language);
  Plot plot(onto, below.origin, below.scale);
  draw_polygon(plot, polygon);
  const Arrow2 a_Bstar = f.a_Bstar_t + f.a_Bstar_n;
  plot.measures("a_Bstar", {0, 0}, {a_Bstar.x, a_Bstar.y});
  add_scale_bars(onto, {above.scale, below.scale}, request);

  const bool english = language == Language::english;
  auto& column = onto.sheet.column;
  column.push_back(equation(polygon));
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(drawings::Steps{steps_of(polygon, language)});
  column.push_back(drawings::Paragraph{remarks(language)});
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  const auto num = [&](double x) { return figures(x, 4, language); };
  column.push_back(
      drawings::Paragraph{fmt::format("$v_{{rel}}$ = {} m/s,  $a_{{rel}}$ = {} m/s²", num(f.b_dot), num(f.b_ddot))});
  column.push_back(drawings::Paragraph{
      fmt::format("$a_{{B}}$ = {} m/s²,  $α_{{d}}$ = {} rad/s²", num(f.a_B.x), num(f.alpha_disc))});
  onto.sheet.description =
      in_words({"The polygon of the accelerations of the pin B, with the Coriolis acceleration",
                "Il poligono delle accelerazioni del piolo B, con l'accelerazione di Coriolis"},
               {{"a_B", f.a_B.x, "m/s²"}, {"a_rel", f.b_ddot, "m/s²"}, {"α_d", f.alpha_disc, "rad/s²"}}, language);
}

}  // namespace epure::pin_in_slot
