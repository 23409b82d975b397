// The cycloid as a student draws it: wheel and guide in twelve parts, each point by two arcs. Above the whole arch,
// below one point of it, larger.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "exercises/cycloid-involute/exercise.h"
#include "exercises/cycloid-involute/figure.h"
#include "exercises/kit/panels/fit.h"
#include "exercises/kit/panels/rounded.h"
#include "exercises/kit/panels/sheet.h"
#include "geometry/motion/roulette_divisions.h"

namespace epure::cycloid_involute {
namespace {

using geometry::Deep;

constexpr int explained_part = 4;

struct CycloidPart {
  Place on_line, on_wheel, M;
};

// The eleven points within the arch. The twelfth division is the end of the arch: there the arcs touch.
std::vector<CycloidPart> parts_of_cycloid(const Problem& of) {
  return deeply([&] {
    std::vector<CycloidPart> found;
    for (int i = 1; i < divisions; ++i) {
      const auto at = geometry::cycloid_division<Deep>(of.r, {Rational(i, divisions)});
      found.push_back({to_double(at.on_line), to_double(at.on_wheel), to_double(at.M)});
    }
    const Place end{CGAL::to_double(of.r) * 2 * std::numbers::pi, 0};
    found.push_back({end, {0, 0}, end});
    return found;
  });
}

struct Cycloid {
  double r;
  std::vector<CycloidPart> parts;  // 1..12
  const CycloidPart& part(int number) const { return parts[static_cast<std::size_t>(number - 1)]; }
  Place C() const { return {0, r}; }
};

// A short arc about `centre` through P.
void arc_through(Plot& plot, const Place& centre, const Place& P, double half_mm) {
  const drawings::Point c = plot.at(centre), p = plot.at(P);
  const double radius = std::hypot(p.x - c.x, p.y - c.y), at = std::atan2(p.y - c.y, p.x - c.x);
  if (radius < 1) return;  // mm: no compass is set so narrow
  const double half = std::min(half_mm / radius, 1.0);
  plot.mark(drawings::Line{drawings::arc(c, radius, at - half, at + half), Meaning::construction, {}});
}

void draw_guide(Plot& plot, double from, double to) {
  plot.mark(drawings::Ground{plot.at({from, 0}), plot.at({to, 0})});
}

void draw_wheel(Plot& plot, const Cycloid& f) {
  plot.circle(f.C(), f.r, Meaning::link);
  plot.cross(f.C(), Meaning::text);
}

// The whole arch.
drawings::Box extent_of_arch(const Cycloid& f, const Scale& scale) {
  Extent extent;
  constexpr double below = 13, above = 5, beside = 1.5;  // mm for letters
  extent.include(-f.r * scale.mm_per_unit - beside, -below);
  extent.include(f.part(divisions).on_line.x * scale.mm_per_unit + beside, 2 * f.r * scale.mm_per_unit + above);
  return extent.box();
}

void draw_arch(Plot& plot, const Cycloid& f) {
  constexpr double crossing = 2.5;         // mm of arc on both sides of a point
  constexpr double room_for_letters = 18;  // mm: on a smaller wheel only the quarters are named
  const Place P0{0, 0}, end = f.part(divisions).on_line;
  const bool is_small = f.r * plot.scale().mm_per_unit < room_for_letters;
  draw_guide(plot, -f.r, end.x);
  for (int i = 1; i <= divisions; ++i) {
    const CycloidPart& at = f.part(i);
    if (i < divisions) {
      plot.segment(f.C(), at.on_wheel, Meaning::construction);
      plot.segment(at.on_line, at.M, Meaning::construction);
      arc_through(plot, P0, at.M, crossing);
      arc_through(plot, at.on_line, at.M, crossing);
      plot.dot(at.on_wheel, Meaning::construction);
      plot.dot(at.on_line, Meaning::construction);
    }
    plot.dot(at.M, Meaning::locus);
    if (i == divisions) break;
    plot.small_label(roman[static_cast<std::size_t>(i - 1)], at.M, at.on_line);
    if (!is_small || i % 3 == 0) {
      plot.small_label(fmt::format("{}'", i), at.on_wheel, f.C());
    }
    plot.small_label(std::to_string(i), at.on_line, {at.on_line.x, f.r});
  }
  // Below the numbers, from P₀ to 12.
  constexpr double below = 11.5;  // mm
  plot.mark(drawings::Dimension{plot.at(P0), plot.at(end), -below, "$πd$"});
  plot.small_label("XII ≡ 12", end, {end.x, f.r});
  draw_wheel(plot, f);
  plot.label("$C$", f.C(), P0);
  plot.label("$P_{0}$ ≡ 12'", P0, f.C());
}

// One division: 4' on the wheel, 4 on the guide.
drawings::Box extent_of_division(const Cycloid& f, const Scale& scale) {
  const CycloidPart& at = f.part(explained_part);
  Extent extent;
  extent.include(-0.3 * f.r * scale.mm_per_unit, -8);
  extent.include(at.on_line.x * scale.mm_per_unit + 12, at.M.y * scale.mm_per_unit + 9);
  return extent.box();
}

void draw_division(Plot& plot, const Cycloid& f) {
  const CycloidPart& at = f.part(explained_part);
  const Place P0{0, 0}, C = f.C();
  constexpr double quarter = std::numbers::pi / 2;
  draw_guide(plot, -0.3 * f.r, at.on_line.x + 10 / plot.scale().mm_per_unit);
  // Of the wheel what rolls on the way to 4.
  const double to = direction(C, at.on_wheel);
  plot.mark(drawings::Line{
      drawings::arc(plot.at(C), f.r * plot.scale().mm_per_unit, -quarter - 0.3, to + 0.15), Meaning::link, {}});
  plot.cross(C, Meaning::text);
  for (int i = 1; i <= explained_part; ++i) {
    plot.dot(f.part(i).on_wheel);
    plot.dot(f.part(i).on_line);
    plot.label(fmt::format("{}'", i), f.part(i).on_wheel, C);
    plot.label(std::to_string(i), f.part(i).on_line, at.M);
  }
  plot.segment(at.on_wheel, at.on_line, Meaning::dimension);
  plot.segment(P0, at.M, Meaning::construction);
  plot.segment(P0, at.on_wheel, Meaning::dimension);
  plot.segment(at.on_line, at.M, Meaning::construction);
  // As long as the compass is swung to be sure of the crossing.
  arc_through(plot, P0, at.M, 14);
  arc_through(plot, at.on_line, at.M, 14);
  plot.dot(at.M, Meaning::locus);
  plot.label("IV", at.M, at.on_line, Meaning::locus);
  plot.label("$P_{0}$", P0, C);
  plot.label("$C$", C, at.on_line);
  const auto between = [](const Place& P, const Place& Q, double t) {
    return Place{P.x + t * (Q.x - P.x), P.y + t * (Q.y - P.y)};
  };
  plot.step(1, f.part(2).on_wheel);
  plot.step(2, f.part(2).on_line);
  plot.step(3, between(at.on_wheel, at.on_line, 0.45));
  plot.step(4, between(P0, at.on_wheel, 0.6));
  plot.step(5, at.M);
}

drawings::Steps steps_of_cycloid(Language language) {
  if (language == Language::english)
    return {
        {"The wheel, in its position at the start, in twelve parts: 1', 2', ... 12'.",
         "On the guide as many parts, each as long as an arc of the wheel, $πd$/12: 1, 2, ... 12. When 4' has come "
         "to 4, $P_{0}$ has come to IV.",
         "About $P_{0}$ an arc with the radius 4 4'.", "About 4 an arc with the chord $P_{0}$ 4'.",
         "They meet in IV; so all the others. XII is 12 itself: there the arcs touch."}};
  return {
      {"La ruota, nella posizione iniziale, in dodici parti: 1', 2', ... 12'.",
       "Sulla guida altrettante parti, lunghe come un archetto della ruota, $πd$/12: 1, 2, ... 12. Quando 4' viene "
       "in 4, $P_{0}$ è andato in IV.",
       "Con centro $P_{0}$ un arco di raggio 4 4'.", "Con centro 4 un arco di raggio pari alla corda $P_{0}$ 4'.",
       "Si incontrano in IV; così tutti gli altri. XII è 12 stesso: lì gli archi si toccano."}};
}

}  // namespace

void draw_cycloid(DrawnSheet& onto, const Problem& of, const SheetRequest& request) {
  const Language language = request.language;
  const bool english = language == Language::english;
  const Cycloid f{CGAL::to_double(of.r), parts_of_cycloid(of)};
  const drawings::Box room = room_above_scale_bars(request);
  const Fit whole =
      fit_lengths(room, request, 1000 / f.r, [&](const Scale& scale) { return extent_of_arch(f, scale); });
  const drawings::Box arch = extent_of_arch(f, whole.scale);
  const double divide = room.high.y - arch.height() - 3;
  const drawings::Box upper{{room.low.x, divide}, room.high}, lower{room.low, {room.high.x, divide}};
  Plot plot(onto, origin_in(upper, arch), whole.scale);
  const double deviation = draw_path(plot, of.wheel(), 0, 2 * std::numbers::pi, "cycloid");
  draw_arch(plot, f);

  SheetRequest any_scale = request;
  any_scale.scale.reset();
  const Fit detail =
      fit_lengths(lower, any_scale, 1000 / f.r, [&](const Scale& scale) { return extent_of_division(f, scale); });
  Plot larger(onto, detail.origin, detail.scale);
  draw_division(larger, f);
  Scale above = whole.scale, below = detail.scale;
  above.caption += Words{" above", " sopra"}.in(language);
  below.caption += Words{" below", " sotto"}.in(language);
  add_scale_bars(onto, {above, below}, request);

  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(steps_of_cycloid(language));
  column.push_back(drawings::Heading{english ? "The curve" : "La curva"});
  column.push_back(drawings::Paragraph{english ? "$x$ = $r$ ($φ$ − sin $φ$),  $y$ = $r$ (1 − cos $φ$),  $φ$ = $ωt$"
                                               : "$x$ = $r$ ($φ$ − sen $φ$),  $y$ = $r$ (1 − cos $φ$),  $φ$ = $ωt$"});
  column.push_back(drawings::Paragraph{fmt::format(
      fmt::runtime(english
                       ? "The line through the points is the true cycloid; as drawn it is nowhere more than {} mm "
                         "of paper off it (proved)."
                       : "La linea per i punti è la vera cicloide; così disegnata non se ne scosta in alcun punto "
                         "più di {} mm sul foglio (dimostrato)."),
      figures(deviation, 2, language))});
  const Place end = f.part(divisions).on_line;
  plot.measures("cycloid.arch_base", {0, 0}, end);
  onto.sheet.description = in_words({"The wheel in twelve parts, the guide in as many, the twelve points of the "
                                     "cycloid by two arcs each, and the curve through them",
                                     "La ruota in dodici parti, la guida in altrettante, i dodici punti della "
                                     "cicloide per due archi ciascuno, e la curva che li unisce"},
                                    {{"d", 2 * f.r, "m"}, {"πd", end.x, "m"}}, language);
}

}  // namespace epure::cycloid_involute
