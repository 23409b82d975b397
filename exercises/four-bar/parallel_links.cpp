// Crank and rocker parallel, in the same sense and in opposite senses: the two positions of the drawn branch, and the
// numbers of all four.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exercises/four-bar/figure.h"

namespace epure::four_bar {
namespace {

using geometry::Deep;
using geometry::Sense;
using geometry::Side;

std::unique_ptr<Drawn> at_parallel(const Problem& of, Sense sense, Side branch) {
  const auto position = [&] { return geometry::parallel_position<Deep>(of.instant.lengths, sense, branch); };
  try {
    if (!deeply(position).branch) return nullptr;  // a change point, where the motion is not determined
    return drawn(
        of, [&] { return position().at; }, "");
  } catch (const geometry::Impossible&) {
    return nullptr;
  }
}

Place between(const Place& P, const Place& Q, double t) { return {P.x + t * (Q.x - P.x), P.y + t * (Q.y - P.y)}; }

// The coupler translates: v_A and v_B are one vector.
drawings::Box extent_of(const Drawn& f, const Scale& lengths, const Scale& speeds) {
  Extent extent;
  f.mechanism.include(extent, lengths);
  for (const CouplerPoint& X : f.coupler.points) {
    if (X.letter == "C") continue;
    extent.include(lengths.mm_per_unit * X.at.x + speeds.mm_per_unit * X.v.x,
                   lengths.mm_per_unit * X.at.y + speeds.mm_per_unit * X.v.y);
  }
  return extent.box();
}

// One of the two positions drawn, and its room.
struct Pictured {
  const Drawn* f;
  std::string name;
  drawings::Box room;
};

Fit fit_position(const Pictured& picture, const Scale& speeds, const SheetRequest& request, double at_most) {
  return fit_lengths(picture.room, request, at_most,
                     [&](const Scale& scale) { return extent_of(*picture.f, scale, speeds); });
}

void draw_position(DrawnSheet& onto, const Pictured& picture, const Scale& speeds, const Fit& fit) {
  const Drawn& f = *picture.f;
  const FourBarFigure& m = f.mechanism;
  Plot plot(onto, fit.origin, fit.scale);
  plot.vectors_at(speeds);
  m.draw(plot);
  constexpr double clear_of_arrow = 0.62;
  for (const auto& [P, Q] : {std::pair{m.A0, m.A}, std::pair{m.B0, m.B}}) {
    plot.mark(drawings::ParallelMark{plot.at(between(P, Q, clear_of_arrow)), direction(P, Q), 2});
  }
  for (const CouplerPoint& X : f.coupler.points) {
    if (X.letter == "C") continue;
    plot.vector_on("", X.at, X.v, Meaning::velocity, fmt::format("$\\vec{{v}}_{{{}}}$", X.letter));
    plot.measures_coordinates("parallel_links." + picture.name + "_" + X.letter, X.at, m.A0);
  }
}

// Side by side, at one scale of lengths and one of velocities. Returns the two.
std::vector<Scale> draw_positions(DrawnSheet& onto, const std::vector<Pictured>& pictures,
                                  const SheetRequest& request) {
  constexpr double longest_vector = 40;  // mm
  if (pictures.empty()) return {};
  const Drawn& any = *pictures.front().f;
  const Scale speeds =
      largest_vector_scale(longest_vector / any.coupler.greatest_velocity(), "m/s", request.language);
  double at_most = 1000 / any.mechanism.reach();
  for (const Pictured& picture : pictures) {
    at_most = std::min(at_most, fit_position(picture, speeds, request, at_most).scale.mm_per_unit);
  }
  for (const Pictured& picture : pictures) {
    draw_position(onto, picture, speeds, fit_position(picture, speeds, request, at_most));
  }
  return {fit_position(pictures.front(), speeds, request, at_most).scale, speeds};
}

drawings::Table results(const Problem& of, Language language) {
  drawings::Table table{{"", "$φ$ (°)", "$ω_{4}$", "$α_{3}$", "$α_{4}$"}, {}};
  const bool english = language == Language::english;
  const auto num = [&](double x) { return figures(x, 4, language); };
  for (const Side side : {of.instant.side, geometry::opposite(of.instant.side)}) {
    for (const Sense sense : {Sense::same, Sense::opposite}) {
      const bool same = sense == Sense::same, main = side == of.instant.side;
      const std::string name = (same ? std::string("↑↑") : std::string("↑↓")) +
                               (main ? (english ? " drawn" : " disegnato") : (english ? " other" : " altro"));
      const auto f = at_parallel(of, sense, side);
      if (!f) {
        table.rows.push_back({name, "–", "–", "–", "–"});
        continue;
      }
      const double degrees = direction(f->mechanism.A0, f->mechanism.A) * 180 / std::numbers::pi;
      table.rows.push_back({name, num(degrees < 0 ? degrees + 360 : degrees), num(f->omega_4),
                            num(f->coupler.alpha_3), num(f->alpha_4)});
    }
  }
  return table;
}

drawings::Steps steps_to_parallel_links(Language language) {
  if (language == Language::english) {
    return {
        {"Shift the coupler along until $B$ falls on $B_{0}$: its other end $Q$ comes to lie on the crank's line, at "
         "$B_{0}B$ − $A_{0}A$ from $A_{0}$ (same sense) or $B_{0}B$ + $A_{0}A$ (opposite senses).",
         "$Q$ is where the circle of that radius about $A_{0}$ meets the circle of radius $AB$ about $B_{0}$; the "
         "crank lies on $A_{0}Q$.",
         "Crank and rocker parallel: $P_{31}$ at infinity, $ω_{3}$ = 0, $\\vec{v}_{A}$ = $\\vec{v}_{B}$ = "
         "$\\vec{v}_{C}$; $ω_{4}$ = ±$ω_{2}$·$A_{0}A$ / $B_{0}B$, but $α_{3}$ is not zero."}};
  }
  return {
      {"Si trasli la biella finché $B$ cade in $B_{0}$: l'altro estremo $Q$ viene sulla retta della manovella, a "
       "$B_{0}B$ − $A_{0}A$ da $A_{0}$ (concordi) o $B_{0}B$ + $A_{0}A$ (discordi).",
       "$Q$ è dove la circonferenza di quel raggio attorno ad $A_{0}$ incontra quella di raggio $AB$ attorno a "
       "$B_{0}$; la manovella sta su $A_{0}Q$.",
       "Manovella e bilanciere paralleli: $P_{31}$ all'infinito, $ω_{3}$ = 0, $\\vec{v}_{A}$ = $\\vec{v}_{B}$ = "
       "$\\vec{v}_{C}$; $ω_{4}$ = ±$ω_{2}$·$A_{0}A$ / $B_{0}B$, ma $α_{3}$ non è nulla."}};
}

}  // namespace

void draw_parallel_links(DrawnSheet& onto, const Problem& of, const SheetRequest& request) {
  const Language language = request.language;
  const bool english = language == Language::english;
  const auto same = at_parallel(of, Sense::same, of.instant.side);
  const auto opposite = at_parallel(of, Sense::opposite, of.instant.side);
  const drawings::Box room = room_above_scale_bars(request);
  const double middle = (room.low.x + room.high.x) / 2;
  std::vector<Pictured> pictures;
  if (same) pictures.push_back({same.get(), "same_sense_main_branch", {room.low, {middle, room.high.y}}});
  if (opposite) pictures.push_back({opposite.get(), "opposite_sense_main_branch", {{middle, room.low.y}, room.high}});
  add_scale_bars(onto, draw_positions(onto, pictures, request), request);
  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Construction" : "Costruzione"});
  column.push_back(steps_to_parallel_links(language));
  column.push_back(drawings::Heading{english ? "All four positions" : "Tutte e quattro le posizioni"});
  column.push_back(results(of, language));
  column.push_back(drawings::Paragraph{english ? "↑↑ same sense, ↑↓ opposite senses; rad/s and rad/s²."
                                               : "↑↑ concordi, ↑↓ discordi; rad/s e rad/s²."});
  onto.sheet.description =
      in_words({"The four-bar linkage with crank and rocker parallel, in the same and in opposite "
                "senses",
                "Il quadrilatero articolato con manovella e bilanciere paralleli, concordi e "
                "discordi"},
               {}, language);
}

}  // namespace epure::four_bar
