// Sheet 1: the linkage opened at B: each iterate brings the ends of coupler and rocker nearer. Above the whole
// linkage; below, where it is too small to be seen, the gap at a larger scale.
#include <fmt/format.h>

#include <cmath>

#include "exercises/four-bar-constraints/exercise.h"
#include "exercises/kit/panels/sheet.h"

namespace epure::four_bar_constraints {
namespace {

constexpr double overview_share = 0.60;  // of the room's height

double gap(const Drawn& f, std::size_t k) { return f.iterates()[k].residual_norm; }

// A gap this long on paper can be drawn with its letters.
bool is_seen(const Plot& plot, const Drawn& f, std::size_t k) { return gap(f, k) * plot.scale().mm_per_unit > 1.5; }

drawings::Box overview_extent(const Drawn& f, const Scale& scale) {
  Extent extent;
  f.figure.include(extent, scale);
  for (std::size_t k = 0; k < f.iterates().size(); ++k) {
    extent.include(scale, f.coupler_end(k), 8);
    extent.include(scale, f.rocker_end(k), 8);
  }
  return extent.box();
}

drawings::Box detail_extent(const Drawn& f, const Scale& scale) {
  Extent extent;
  for (const Place& P : {f.coupler_end(0), f.rocker_end(0), f.figure.B}) extent.include(scale, P, 14);
  return extent.box();
}

// The iterates whose gap shows at the plot's scale, with their numbers.
void draw_open_linkages(Plot& plot, const Drawn& f) {
  for (std::size_t k = 0; k < f.iterates().size(); ++k) {
    if (!is_seen(plot, f, k)) continue;
    const Place on_coupler = f.coupler_end(k), on_rocker = f.rocker_end(k);
    plot.segment(f.figure.A, on_coupler, Meaning::alternative);
    plot.segment(f.figure.B0, on_rocker, Meaning::alternative);
    plot.side("", on_rocker, on_coupler, Meaning::dimension, fmt::format("$\\vec{{ψ}}^{{{}}}$", k), f.figure.B);
    plot.dot(on_coupler, Meaning::construction);
    plot.dot(on_rocker, Meaning::construction);
  }
}

void draw_overview(Plot& plot, const Drawn& f) {
  draw_open_linkages(plot, f);
  f.figure.draw(plot);
}

void draw_detail(Plot& plot, const Drawn& f) {
  draw_open_linkages(plot, f);
  plot.segment(f.figure.A, f.figure.B, Meaning::link);
  plot.segment(f.figure.B0, f.figure.B, Meaning::link);
  plot.hinge(f.figure.B);
  plot.label("$B$", f.figure.B, f.coupler_end(0));
  for (std::size_t k = 0; k < f.iterates().size(); ++k) {
    if (!is_seen(plot, f, k)) continue;
    plot.small_label(fmt::format("$AB$, {}", k), f.coupler_end(k), f.rocker_end(k));
    plot.small_label(fmt::format("$B_{{0}}B$, {}", k), f.rocker_end(k), f.coupler_end(k));
  }
}

drawings::Table iterates(const Drawn& f, Language language) {
  drawings::Table table{{"$k$", "$θ_{3}$ (rad)", "$θ_{4}$ (rad)", "$|ψ|$ (m)"}, {}};
  constexpr std::size_t most_rows = 9;  // the first ones and the last
  const std::size_t count = f.iterates().size();
  for (std::size_t k = 0; k < count; ++k) {
    if (count > most_rows && k + 1 >= most_rows && k + 1 < count) continue;
    const auto& now = f.iterates()[k];
    table.rows.push_back({std::to_string(k), figures(now.q(0), 7, language), figures(now.q(1), 7, language),
                          figures(now.residual_norm, 2, language)});
  }
  return table;
}

std::vector<std::string> method(Language language) {
  const std::string sin = Words{"sin", "sen"}.in(language);
  return {"$ψ_{1}$ = $r_{2}$ cos $θ_{2}$ + $r_{3}$ cos $θ_{3}$ + $r_{4}$ cos $θ_{4}$ − $r_{1}$ = 0",
          "$ψ_{2}$ = $r_{2}$ " + sin + " $θ_{2}$ + $r_{3}$ " + sin + " $θ_{3}$ + $r_{4}$ " + sin + " $θ_{4}$ = 0",
          "$y$ = ($θ_{3}$, $θ_{4}$);  $y^{k+1}$ = $y^{k}$ − $ψ^{−1}_{y}$ $ψ^{k}$;  det $ψ_{y}$ = $r_{3}$ $r_{4}$ " +
              sin + "($θ_{4}$ − $θ_{3}$)"};
}

std::string on_the_start(Language language) {
  return language == Language::english
             ? "The source prints the start (0.349, 1.22, −0.87) as [$θ_{3}$, $θ_{4}$, $θ_{2}$]: it is [$θ_{2}$, "
               "$θ_{3}$, $θ_{4}$], 0.349 rad being 20°."
             : "La fonte stampa i valori iniziali (0,349; 1,22; −0,87) come [$θ_{3}$, $θ_{4}$, $θ_{2}$]: sono "
               "[$θ_{2}$, $θ_{3}$, $θ_{4}$], 0,349 rad essendo 20°.";
}

std::string on_the_gap(const Drawn& f, Language language) {
  const std::string determinant = figures(f.iterates().back().determinant, 4, language);
  return language == Language::english
             ? fmt::format(
                   "$\\vec{{ψ}}$ leads from the rocker's end to the coupler's: the linkage is open at $B$. At the "
                   "solution det $ψ_{{y}}$ = {} m².",
                   determinant)
             : fmt::format(
                   "$\\vec{{ψ}}$ va dall'estremo del bilanciere a quello della biella: il quadrilatero è aperto "
                   "in $B$. Nella soluzione det $ψ_{{y}}$ = {} m².",
                   determinant);
}

}  // namespace

void draw_iterations(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const Language language = request.language;
  const bool english = language == Language::english;
  const drawings::Box room = room_above_scale_bars(request);
  const auto fit_whole = [&](const drawings::Box& box) {
    return fit_lengths(box, request, 1000 / f.figure.reach(),
                       [&](const Scale& scale) { return overview_extent(f, scale); });
  };
  Fit overview = fit_whole(room);
  constexpr double smallest_gap = 1e-9;  // m: below, no standard scale makes it a drawing
  constexpr double clear_gap = 12;       // mm: from here on the whole linkage shows it
  const bool has_detail = gap(f, 0) > smallest_gap && gap(f, 0) * overview.scale.mm_per_unit < clear_gap;
  const double divide = has_detail ? room.high.y - overview_share * room.height() : room.low.y;
  const drawings::Box above{{room.low.x, divide}, room.high}, below{room.low, {room.high.x, divide}};
  if (has_detail) overview = fit_whole(above);
  Plot whole(onto, overview.origin, overview.scale);
  draw_overview(whole, f);
  std::vector<Scale> scales{overview.scale};
  if (has_detail) {
    onto.sheet.figure.windows = {above, below};
    onto.sheet.figure.window_of.resize(onto.sheet.figure.marks.size(), 0);
    SheetRequest own_scale = request;
    own_scale.scale.reset();        // --scale is for the linkage
    constexpr double longest = 45;  // mm, of the first gap
    const Fit detail = fit_lengths(below, own_scale, longest / gap(f, 0),
                                   [&](const Scale& scale) { return detail_extent(f, scale); });
    Plot near(onto, detail.origin, detail.scale);
    draw_detail(near, f);
    onto.sheet.figure.window_of.resize(onto.sheet.figure.marks.size(), 1);
    scales.push_back(detail.scale);
    scales[0].caption += english ? " above" : " sopra";
    scales[1].caption += english ? " below" : " sotto";
  }
  add_scale_bars(onto, scales, request);
  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Constraint equations" : "Equazioni di vincolo"});
  for (const std::string& line : method(language)) column.push_back(drawings::Paragraph{line});
  column.push_back(drawings::Heading{english ? "Iterates" : "Iterazioni"});
  column.push_back(iterates(f, language));
  column.push_back(drawings::Paragraph{on_the_gap(f, language)});
  column.push_back(drawings::Paragraph{on_the_start(language)});
  onto.sheet.description = in_words(
      {"The open four-bar linkage as Newton-Raphson closes it", "Il quadrilatero aperto che Newton-Raphson chiude"},
      {{"θ₃", f.iterates().back().q(0), "rad"}, {"θ₄", f.iterates().back().q(1), "rad"}}, language);
}

}  // namespace epure::four_bar_constraints
