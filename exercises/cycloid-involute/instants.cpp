// Both instants of each curve side by side; of the involute, whose circle is small beside it, the contact once more.
#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "exercises/cycloid-involute/exercise.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/rolling/instant_panel.h"

namespace epure::cycloid_involute {
namespace {

// At a cusp the tangential part has two values.
Result instants_table(const std::vector<std::string>& heads, const std::vector<InstantNames>& instants,
                      const std::string& first_row, const std::string& first, bool has_cusp) {
  const auto row = [&](const std::string& head, const std::string& before, const std::string& after = "") {
    Row cells{head, {}};
    for (const InstantNames& at : instants) cells.names.push_back(at(before) + after);
    return cells;
  };
  std::vector<Row> rows{row("$v_{M}$ (m/s)", "v_M"), row("$ρ$ (m)", "rho_M"),
                        row("$x_{Ω}$ (m)", "curvature_centre_x"), row("$y_{Ω}$ (m)", "curvature_centre_y"),
                        row("$a^{n}_{M}$ (m/s²)", "a_n")};
  if (has_cusp) {
    rows.push_back(row("$a^{t−}_{M}$ (m/s²)", "a_t", "_before_cusp"));
    rows.push_back(row("$a^{t+}_{M}$ (m/s²)", "a_t", "_after_cusp"));
  } else {
    rows.push_back(row("$a^{t}_{M}$ (m/s²)", "a_t"));
  }
  rows.push_back(row("$a_{M}$ (m/s²)", "a_M"));
  if (!first.empty()) rows.insert(rows.begin(), row(first_row, first));
  std::vector<std::string> head{""};
  head.insert(head.end(), heads.begin(), heads.end());
  return table(head, rows);
}

constexpr double longest_velocity = 26;  // mm

// What the first instant has not told.
std::vector<InstantStep> steps_of_second(const Rolled& first, const Rolled& second) {
  if (first.is_at_cusp == second.is_at_cusp) return {};
  std::vector<InstantStep> steps = instant_steps(second);
  steps.erase(steps.begin());
  return steps;
}

// Where the line touches the circle, and M on it.
InstantStep setting_out(const Rolled& f) {
  const bool has_turned = whole_turns(f.given.phi) > 0;
  const Words less_turns = has_turned ? Words{" (less whole turns)", " (meno i giri interi)"} : Words{},
              all_turns = has_turned ? Words{", all turns counted", ", contati tutti i giri"} : Words{};
  return {Words{"$OP_{0}$ at $φ$", "$OP_{0}$ a $φ$"} + less_turns +
              Words{" from $x$, counter-clockwise. Back along the tangent $P_{0}M = ½d_{0}φ$, the arc unrolled since "
                    "$M_{0}$",
                    " da $x$, in senso antiorario. Indietro lungo la tangente $P_{0}M = ½d_{0}φ$, l'arco svolto da "
                    "$M_{0}$"} +
              all_turns + ".",
          InstantStep::At::contact};
}

bool is_as_printed(const Problem& of) {
  return of.r == Rational(1, 2) && of.omega_1 == Angle{0, 30} && of.phi == Angle{Rational(3, 8)};
}
const Words about_source{
    "What the source prints for $φ$ = 135° belongs to 90°: $P_{0}M$ = 0.71 m, $v_{M}$ = 21.2 m/s, $ρ$ = 1.44 m, "
    "$a^{n}_{M}$ = 312.1 m/s², $a^{t}_{M}$ = 315 m/s². It leaves the cusp out.",
    "I valori che la fonte stampa per $φ$ = 135° sono quelli di 90°: $P_{0}M$ = 0,71 m, $v_{M}$ = 21,2 m/s, $ρ$ = "
    "1,44 m, $a^{n}_{M}$ = 312,1 m/s², $a^{t}_{M}$ = 315 m/s². Tralascia la cuspide."};

// The cycloid's instants are drawn where the arch begins with the origin, if it is the first.
RollingInstantPanel of_cycloid(const Solution& s, const Rolled& f, std::vector<InstantStep> steps,
                               const Scale& velocities, const std::string& title) {
  RollingInstantPanel panel(s, f, std::move(steps), velocities);
  panel.titled(title);
  constexpr double large_enough = 60;  // mm: of a cusp there is little to see
  if (f.is_at_cusp)
    panel.no_larger_than(large_enough);
  else
    panel.without_room_for_centre();
  if (whole_turns(f.given.phi) == 0) panel.measured_from({-f.r * to_double(f.given.phi), 0});
  return panel;
}

// Of a longer path only the last turns are drawn.
constexpr double longest_path = 6 * std::numbers::pi;  // rad

struct OfInvolute {
  Rolled f;
  std::string symbol, time;
  bool is_beside_blot = false;  // a circle so small beside its line, at one instant or the other

  bool goes_round() const { return to_double(f.given.phi) > 3; }
  bool has_close_up() const { return goes_round() && is_beside_blot; }
  // All of such a path would make the rest small: then no more of it than a piece at M.
  bool cuts_path() const { return goes_round() && !is_beside_blot; }
  static Way piece() { return {-0.6, 0.15}; }  // rad
  Way path() const {
    if (f.is_at_cusp) return {0, std::numbers::pi / 2};
    return {-std::min(to_double(f.given.phi), longest_path), 0};
  }
};

OfInvolute of_involute(const Solution& s, const Angle& phi, const InstantNames& names, const std::string& symbol,
                       Language language) {
  const Problem of(s.givens());
  const double t = geometry::quotient_of<double>(phi, of.omega_2);
  constexpr double farthest = 1e9;  // rad: beyond, doubles no longer tell where on the circle the line touches
  if (to_double(phi) > farthest)
    throw BadGivens(format_words("at t = {} s the line has turned through {} rad; it can be drawn up to 1e9 rad",
                                 "a t = {} s la retta ha ruotato di {} rad; si può disegnare fino a 1e9 rad",
                                 decimal(t, 17), decimal(to_double(phi), 3)));
  return {rolled(s, {of.line(), phi, of.omega_2, {}}, names), symbol,
          fmt::format("{} = {} s", symbol, short_number(t, language))};
}

}  // namespace

PanelSheet cycloid_instants_sheet(const Solution& s, Language language) {
  const Problem of(s.givens());
  // Near enough to trace the path: from the exact number of whole turns on.
  const Rational arches = of.travelled().arches();
  const double since = s["cycloid.phi_at_s4"] - to_double(Angle{arches});
  const Rolled first = rolled(s, {of.wheel(), of.phi, of.omega_1, {}}, at_phi),
               second = rolled(s, {of.wheel(), {arches, Rational(std::max(since, 0.0))}, of.omega_1, {}}, at_s);
  const Scale velocities = scale_of_velocities({first, second}, longest_velocity, language);
  const bool is_in_radians = of.phi.radians != 0;
  const std::string at_first = is_in_radians
                                   ? "$φ$ = " + short_number(CGAL::to_double(of.phi.radians), language) + " rad"
                                   : "$φ$ = " + short_number(geometry::degrees(of.phi), language) + "°",
                    at_second = "$s$ = " + short_number(CGAL::to_double(of.s), language) + " m";
  const bool has_cusp = first.is_at_cusp || second.is_at_cusp;
  std::vector<Result> results{instants_table({at_first, at_second}, {at_phi, at_s}, "", "", has_cusp)};
  if (is_as_printed(of)) results.push_back(remark(about_source.in(language)));
  return {.panels = panels(of_cycloid(s, first, instant_steps(first), velocities, at_first),
                           of_cycloid(s, second, steps_of_second(first, second), velocities, at_second)),
          .results = std::move(results),
          .seen = {"The wheel on its guide at two instants, with contact point, inflection circle and centre of "
                   "curvature, velocity and acceleration of M",
                   "La ruota sulla guida in due istanti, con punto di contatto, circonferenza dei flessi e centro di "
                   "curvatura, velocità e accelerazione di M"},
          .told = {"cycloid.v_M", "cycloid.rho_M", "cycloid.v_M_at_s4"},
          .without_part = givens_of_involute};
}

PanelSheet involute_instants_sheet(const Solution& s, Language language) {
  const Problem of(s.givens());
  std::vector<OfInvolute> both{of_involute(s, of.phi_1, at_t1, "$t_{1}$", language),
                               of_involute(s, of.phi_2, at_t2, "$t_{2}$", language)};
  constexpr double blot = 20;  // rad: the circle's radius in the line
  const bool has_blot = std::max(to_double(of.phi_1), to_double(of.phi_2)) > blot;
  for (OfInvolute& each : both) each.is_beside_blot = has_blot;
  constexpr double far_shorter = 5;  // times: of two paths at one scale the shorter would be a blot
  const auto [shorter, longer] = std::minmax({to_double(of.phi_1), to_double(of.phi_2)});
  const bool is_one_dwarfed = longer > far_shorter * shorter;
  const Scale velocities = scale_of_velocities({both[0].f, both[1].f}, longest_velocity, language);
  PanelSheet sheet;
  const auto add = [&](RollingInstantPanel panel) {
    sheet.panels.push_back(std::make_unique<RollingInstantPanel>(std::move(panel)));
  };
  // Each step where its points are seen: in the close-up what belongs to the contact.
  std::vector<InstantStep> at_contact = instant_steps(both[0].f), elsewhere;
  if (!both[0].f.is_at_cusp) at_contact.insert(at_contact.begin(), setting_out(both[0].f));
  if (both[0].has_close_up()) {
    const auto is_of_vectors = [](const InstantStep& step) {
      return step.at == InstantStep::At::tip_of_velocity || step.at == InstantStep::At::acceleration;
    };
    std::copy_if(at_contact.begin(), at_contact.end(), std::back_inserter(elsewhere), is_of_vectors);
    std::erase_if(at_contact, is_of_vectors);
  } else {
    std::swap(at_contact, elsewhere);
  }
  std::vector<InstantStep> at_second = steps_of_second(both[0].f, both[1].f);
  if (both[0].f.is_at_cusp && !both[1].f.is_at_cusp) at_second.insert(at_second.begin(), setting_out(both[1].f));
  const auto add_contact = [&](const OfInvolute& each) {
    if (!each.has_close_up()) return;
    RollingInstantPanel panel(s, each.f, std::exchange(at_contact, {}), velocities);
    panel.titled(fmt::format("{}: {}", each.symbol, Words{"the contact", "il contatto"}.in(language)))
        .close_up()
        .set_out();
    add(std::move(panel));
  };
  const auto add_path = [&](const OfInvolute& each) {
    const bool is_first = &each == &both.front();
    RollingInstantPanel panel(s, each.f, is_first ? elsewhere : at_second, velocities);
    panel.titled(each.time).measured_from(*each.f.O());
    if (each.cuts_path())
      panel.with_path(OfInvolute::piece());
    else
      panel.with_whole_path(each.path());
    if (each.has_close_up())
      panel.beside_close_up();
    else
      panel.set_out();
    if (is_one_dwarfed) panel.at_own_scale();
    add(std::move(panel));
  };
  if (both[0].has_close_up() && both[1].has_close_up()) {
    for (const OfInvolute& each : both) {
      add_contact(each);
      add_path(each);
    }
  } else {  // of the one close-up the steps come first
    for (const OfInvolute& each : both) add_contact(each);
    for (const OfInvolute& each : both) add_path(each);
  }
  sheet.results = {instants_table({"$t_{1}$", "$t_{2}$"}, {at_t1, at_t2}, "$φ$ (rad)", "phi", false),
                   remark(Words{"The line rolls counter-clockwise, as the source's equations have it. Clockwise, as "
                                "its text says, all is mirrored in the $x$ axis.",
                                "La retta rotola in senso antiorario, come nelle equazioni della fonte. In senso "
                                "orario, come dice il testo, tutto è simmetrico rispetto all'asse $x$."}
                              .in(language))};
  if (at_second.empty())
    sheet.results.push_back(remark(Words{"The steps are numbered at $t_{1}$; at $t_{2}$ they are the same.",
                                         "I passi sono numerati a $t_{1}$; a $t_{2}$ sono gli stessi."}
                                       .in(language)));
  sheet.seen = {
      "The line on its circle at two instants, with the involute that led there, velocity and acceleration of M",
      "La retta sul suo cerchio in due istanti, con l'evolvente percorsa, velocità e accelerazione di M"};
  sheet.told = {"involute.v_M_t1", "involute.v_M_t2"};
  sheet.without_part = givens_of_cycloid;
  return sheet;
}

}  // namespace epure::cycloid_involute
