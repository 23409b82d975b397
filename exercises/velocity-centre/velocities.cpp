// The sheet of velocities: the bar on its body, the polygon of v_A = v_O + v_AO, and the velocity centre where the
// normals to v_O and v_A meet.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exercises/kit/panels/compare.h"
#include "exercises/kit/panels/edge.h"
#include "exercises/kit/panels/fit.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/velocity-centre/exercise.h"

namespace epure::velocity_centre {
namespace {

constexpr double centre_share = 0.5;      // of the room's width, for the picture with the velocity centre
constexpr double mechanism_share = 0.55;  // of the height of what is left
constexpr double longest_vector = 60;     // mm
constexpr double letters = 8;             // mm around a point or a vector's tip

// The centre is shown when the bar beside it can still be seen; else its lines leave the picture.
bool shows_centre(const Drawn& f) { return f.motion.is_near(f.motion.P0, 12); }

drawings::Box extent_of(const Drawn& f, const Scale& lengths, const Scale& velocities) {
  Extent extent;
  for (const CouplerPoint& X : f.motion.points) {
    extent.include(lengths, X.at, letters);
    const double x = lengths.mm_per_unit * X.at.x + velocities.mm_per_unit * X.v.x;
    const double y = lengths.mm_per_unit * X.at.y + velocities.mm_per_unit * X.v.y;
    extent.include(x - letters, y - letters);
    extent.include(x + letters, y + letters);
  }
  if (shows_centre(f)) extent.include(lengths, *f.motion.P0, letters + 3);
  return extent.box();
}

// Right across the room: the centre is too far to be shown, or at infinity.
void draw_normals_leaving(Plot& plot, const Drawn& f, const drawings::Box& room) {
  for (const CouplerPoint& X : f.motion.points) {
    if (magnitude(X.v) == 0) continue;
    const Arrow2 normal{-X.v.y, X.v.x};
    plot.segment(at_edge(plot, room, X.at, -normal), at_edge(plot, room, X.at, normal), Meaning::construction);
  }
}

// The lines that meet in the centre.
void draw_normals(Plot& plot, const Drawn& f) {
  const Place P0 = *f.motion.P0, O = f.O().at, A = f.A().at;
  constexpr double beyond = 6;  // mm
  plot.long_segment(O, P0, beyond, Meaning::construction);
  plot.long_segment(A, P0, beyond, Meaning::construction);
  if (f.centre == Centre::by_the_tips) {
    const Place from = plot.tip(O, f.O().v), to = plot.tip(A, f.A().v);
    plot.long_segment(from, P0, beyond, Meaning::construction);
    plot.long_segment(to, P0, beyond, Meaning::construction);
  }
  for (const CouplerPoint& X : f.motion.points) plot.right_angle(X.at, P0, plot.tip(X.at, X.v));
}

void draw_centre(Plot& plot, const Drawn& f) {
  const Place P0 = *f.motion.P0;
  if (f.centre == Centre::is_O) {
    plot.segment(f.A().at, P0, Meaning::construction);
  } else {
    draw_normals(plot, f);
  }
  plot.cross(P0);
  plot.label("$P_{0}$", P0, f.A().at, Meaning::locus);
  plot.measures_coordinates("P0", P0, f.O().at);
  plot.measures("P0O", P0, f.O().at);
  plot.measures("P0A", P0, f.A().at);
}

void number_steps(Plot& plot, const Drawn& f, int first) {
  const auto between = [](const Place& P, const Place& Q) {
    return Place{P.x + 0.6 * (Q.x - P.x), P.y + 0.6 * (Q.y - P.y)};
  };
  const Place O = f.O().at, A = f.A().at;
  if (!shows_centre(f)) return;
  const Place P0 = *f.motion.P0;
  switch (f.centre) {
    case Centre::by_two_normals:
      plot.step(first, between(O, P0));
      plot.step(first + 1, between(A, P0));
      plot.step(first + 2, P0);
      break;
    case Centre::by_the_tips:
      plot.step(first, between(O, P0));
      plot.step(first + 1, P0);
      break;
    default:
      plot.step(first, P0);
  }
}

std::vector<Words> steps_to_centre(const Drawn& f, Language language) {
  const Words far{" Here it lies off the sheet.", " Qui cade fuori del foglio."};
  const bool off = f.motion.P0 && !shows_centre(f);
  switch (f.centre) {
    case Centre::by_two_normals: {
      const std::string m = figures(f.normal_slope.value_or(0), 4, language);
      return {
          {"$\\vec{v}_{O}$ and $\\vec{v}_{A}$ set off at $O$ and $A$. The normal to $\\vec{v}_{O}$ through $O$ is "
           "the axis $y$.",
           "$\\vec{v}_{O}$ e $\\vec{v}_{A}$ riportate in $O$ e in $A$. La normale alla $\\vec{v}_{O}$ per $O$ è "
           "l'asse $y$."},
          {fmt::format("The normal to $\\vec{{v}}_{{A}}$ through $A$: its slope is $m_{{1}}$ = "
                       "−$v_{{Ax}}$/$v_{{Ay}}$ = {}.",
                       m),
           fmt::format("La normale alla $\\vec{{v}}_{{A}}$ per $A$, di coefficiente angolare $m_{{1}}$ = "
                       "−$v_{{Ax}}$/$v_{{Ay}}$ = {}.",
                       m)},
          {"The velocity centre $P_{0}$ lies on both: $P_{0}O$ = $V$/$ω$, $v_{A}$ = $ω$·$P_{0}A$." +
               (off ? far.english : ""),
           "Il centro delle velocità $P_{0}$ sta su entrambe: $P_{0}O$ = $V$/$ω$, $v_{A}$ = $ω$·$P_{0}A$." +
               (off ? far.italian : "")}};
    }
    case Centre::by_the_tips:
      return {{"$\\vec{v}_{A}$ is parallel to $\\vec{v}_{O}$: the line $OA$ is normal to both.",
               "La $\\vec{v}_{A}$ è parallela alla $\\vec{v}_{O}$: la retta $OA$ è normale a entrambe."},
              {"The line through the tips of the two vectors meets it in the velocity centre $P_{0}$." +
                   (off ? far.english : ""),
               "La retta per gli estremi dei due vettori la incontra nel centro delle velocità $P_{0}$." +
                   (off ? far.italian : "")}};
    case Centre::is_O:
      return {{"$V$ = 0: $O$ rests, and is the velocity centre $P_{0}$. $v_{A}$ = $ω$·$OA$.",
               "$V$ = 0: $O$ è fermo, ed è il centro delle velocità $P_{0}$. $v_{A}$ = $ω$·$OA$."}};
    case Centre::at_infinity:
      return {
          {"$ω$ = 0: $\\vec{v}_{A}$ = $\\vec{v}_{O}$, the two normals are parallel. The bar translates: its velocity "
           "centre is at infinity.",
           "$ω$ = 0: $\\vec{v}_{A}$ = $\\vec{v}_{O}$, le due normali sono parallele. La barra trasla: il centro "
           "delle velocità è all'infinito."}};
    case Centre::everywhere:
      break;
  }
  return {{"$ω$ = 0 and $V$ = 0: the bar rests, and no point of it is the velocity centre more than another.",
           "$ω$ = 0 e $V$ = 0: la barra è ferma, e nessun suo punto è centro delle velocità più di un altro."}};
}

// v_A, and v_O, once as vectors and once as ω times the distance from the centre.
std::vector<Comparison> comparisons(const DrawnSheet& sheet, const Drawn& f) {
  const Readings read(sheet);
  std::vector<Comparison> rows;
  const double omega = std::abs(f.motion.omega_3);
  for (const char* X : {"O", "A"}) {
    const std::string distance = std::string("P0") + X, speed = std::string("v_") + X;
    if (read.is_unit(distance))
      rows.push_back({fmt::format("$v_{{{}}}$ (m/s)", X), omega * read[distance], read[speed]});
  }
  return rows;
}

void fill_column(DrawnSheet& onto, const Drawn& f, Language language) {
  const bool english = language == Language::english;
  const auto num = [&](double x) { return figures(x, 4, language); };
  auto& column = onto.sheet.column;
  column.push_back(equation(f.velocities));
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  drawings::Steps steps{steps_of(f.velocities, language)};
  for (const Words& step : steps_to_centre(f, language)) steps.lines.push_back(step.in(language));
  column.push_back(steps);
  column.push_back(drawings::Heading{english ? "Results" : "Risultati"});
  const Arrow2 v_A = f.A().v;
  column.push_back(drawings::Paragraph{fmt::format("$\\vec{{v}}_{{A}}$ = ({}; {}) m/s,  $v_{{A}}$ = {} m/s",
                                                   num(v_A.x), num(v_A.y), num(magnitude(v_A)))});
  if (const auto& P0 = f.motion.P0)
    column.push_back(drawings::Paragraph{fmt::format("$P_{{0}}$ = ({}; {}) m", num(P0->x), num(P0->y))});
  if (const auto rows = comparisons(onto, f); !rows.empty()) {
    column.push_back(drawings::Heading{english ? "The two methods, as measured" : "I due metodi, come misurati"});
    column.push_back(comparison_table(rows, {"$ω$·$P_{0}X$", "$ω$·$P_{0}X$"}, {"vector", "vettore"}, language));
  }
}

}  // namespace

void draw_velocities(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const drawings::Box room = room_above_scale_bars(request);
  const double across = room.low.x + centre_share * room.width();
  const double down = room.high.y - mechanism_share * room.height();
  const drawings::Box left{room.low, {across, room.high.y}};
  const Scale lengths = draw_small(onto, f.bar, {{across, down}, room.high}, request);

  // One scale for the polygon and for the vectors on the bar.
  const double longest = greatest(f.velocities);
  const Fit polygon_fit = fit_vectors({{across, room.low.y}, {room.high.x, down}}, "m/s", request.language,
                                      longest_vector / (longest > 0 ? longest : 1),
                                      [&](const Scale& s) { return extent_of(f.velocities, s); });
  Plot polygon(onto, polygon_fit.origin, polygon_fit.scale);
  draw_polygon(polygon, f.velocities);
  polygon.measures_coordinates("v_A", {f.A().v.x, f.A().v.y}, {0, 0});

  SheetRequest any_scale = request;  // a scale asked for is the mechanism's
  any_scale.scale.reset();
  const Fit fit = fit_lengths(left, any_scale, 1000 / f.bar.reach(),
                              [&](const Scale& s) { return extent_of(f, s, polygon_fit.scale); });
  Plot plot(onto, fit.origin, fit.scale);
  plot.vectors_at(polygon_fit.scale);
  shows_centre(f) ? draw_centre(plot, f) : draw_normals_leaving(plot, f, left);
  f.bar.sketch(plot);
  plot.measures_coordinates("A", f.A().at, f.O().at);
  for (const CouplerPoint& X : f.motion.points)
    plot.vector_on("v_" + X.letter, X.at, X.v, Meaning::velocity, fmt::format("$\\vec{{v}}_{{{}}}$", X.letter));
  number_steps(plot, f, steps_of_sides(f.velocities) + 1);

  Scale of_left = fit.scale, of_right = lengths;  // that of the vectors is for both sides
  of_left.caption += Words{" left", " a sinistra"}.in(request.language);
  of_right.caption += Words{" right", " a destra"}.in(request.language);
  add_scale_bars(onto, {of_left, of_right, polygon_fit.scale}, request);
  // The title block has no room for the words.
  onto.sheet.title_block.scales = {fit.scale.caption, lengths.caption, polygon_fit.scale.caption};
  fill_column(onto, f, request.language);
  std::vector<Value> values{
      {"v_A", magnitude(f.A().v), "m/s"}, {"v_A_x", f.A().v.x, "m/s"}, {"v_A_y", f.A().v.y, "m/s"}};
  if (const auto& P0 = f.motion.P0) values.insert(values.end(), {{"x_P0", P0->x, "m"}, {"y_P0", P0->y, "m"}});
  onto.sheet.description =
      in_words({"The bar on its body, the polygon of the velocities of A, and the velocity centre "
                "where the normals to the velocities of O and A meet",
                "La barra sul suo corpo, il poligono delle velocità di A, e il centro delle "
                "velocità dove si incontrano le normali alle velocità di O e A"},
               values, request.language);
}

}  // namespace epure::velocity_centre
