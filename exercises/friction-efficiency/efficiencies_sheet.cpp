#include <algorithm>

#include "exercises/friction-efficiency/motion.h"
#include "exercises/friction-efficiency/sheets.h"
#include "exercises/kit/linkages/case_of_mechanism.h"
#include "exercises/kit/panels/chart_panel.h"

namespace epure::friction_efficiency {

PanelSheet over_friction_angle(const Solution& s, Language language) {
  struct Plotted {
    std::string name;
    Words label;
  };
  const std::vector<Plotted> all{{"wedge_collar", {"wedge", "cuneo"}},
                                 {"wedge_collar_two_point", {"two forces", "due forze"}},
                                 {"double_slider", {"double slider", "doppio pattino"}},
                                 {"double_slider_pins", {"with pins", "con perni"}},
                                 {"sliding_levers", {"levers", "leve"}},
                                 {"fairbairn", {"Fairbairn", "Fairbairn"}}};
  // Every limit stands on the charts.
  const auto limit_of = [&](const Plotted& each, int k) {
    const std::string name = each.name + (k == 0 ? ".jamming" : ".self_locking") + "_friction_angle_deg";
    return s.has(name) ? s.value(name) : std::nullopt;
  };
  double farthest = 0;
  for (const Plotted& each : all)
    for (const int k : {0, 1}) farthest = std::max(farthest, limit_of(each, k).value_or(0));
  const int most = std::min(90, 10 * (static_cast<int>(farthest / 10) + 1));
  std::map<std::string, std::vector<drawings::Datum>> runs;
  for (const Plotted& each : all) {
    double degrees = 0;
    for (const ValuesByName& values : values_at_friction_angles(
             s.givens(), most, each.name, {each.name + ".eta" + direct, each.name + ".eta" + retrograde})) {
      degrees += 1;
      for (const auto& [quantity, value] : values) {
        if (value <= 0 || value > 1) continue;
        auto& run = runs[quantity];
        if (degrees == 1) run.push_back({0, 1});  // without friction nothing is lost
        const bool goes_on = run.empty() || run.back().x == degrees - 1;
        if (goes_on) run.push_back({degrees, value});
      }
    }
  }
  const double phi = geometry::degrees(s.givens().angle("phi"));
  const auto chart = [&](int k) {
    drawings::Chart drawn{.x = {.quantity = "$φ$",
                                .unit = "°",
                                .low = 0,
                                .high = static_cast<double>(most),
                                .steps = drawings::degree_steps},
                          .y = {.quantity = k == 0 ? "$η_{D}$" : "$η_{R}$", .unit = "", .low = 0, .high = 1}};
    std::vector<ChartPanel::Read> read;
    for (const Plotted& each : all) {
      const std::string eta = each.name + ".eta" + (k == 0 ? direct : retrograde);
      auto& run = runs[eta];
      const std::string limit = each.name + (k == 0 ? ".jamming" : ".self_locking") + "_friction_angle_deg";
      if (const auto angle = limit_of(each, k)) {
        run.push_back({*angle, 0});
        read.push_back({run.back(), limit, {}});
        // Which one it is, its curve says; two that lie on each other are one mark.
        const bool stands = std::any_of(drawn.markers.begin(), drawn.markers.end(), [&](const auto& marker) {
          return marker.at.x == *angle && marker.at.y == 0;
        });
        if (!stands) drawn.markers.push_back({.at = run.back(), .shape = drawings::PointShape::diamond});
      }
      if (const auto value = s.value(eta); value && *value > 0 && phi <= most) {
        read.push_back({{phi, *value}, {}, eta});
        drawn.markers.push_back({.at = read.back().at, .meaning = Meaning::force});
      }
      if (!run.empty())
        drawn.curves.push_back(
            {.name = "eta_" + each.name, .runs = {run}, .meaning = Meaning::force, .label = each.label.in(language)});
    }
    drawn.legend = true;
    drawn.verticals = {{.at = phi, .label = "$φ$"}};
    return ChartPanel(drawn, read);
  };
  std::vector<Row> rows;
  for (const Plotted& each : all) {
    const std::string jamming = each.name + ".jamming_friction_angle_deg";
    rows.push_back({each.label.in(language),
                    {each.name + ".eta_direct", each.name + ".eta_retrograde",
                     each.name + ".self_locking_friction_angle_deg", s.has(jamming) ? jamming : ""},
                    "–"});
  }
  const Words variants{" Levers: with $\\it{Q}$ on lever 3; Fairbairn: with the longer lever.",
                       " Leve: con $\\it{Q}$ sulla leva 3; Fairbairn: con la leva più lunga."};
  return {
      .panels = panels(chart(0), chart(1)),
      .results =
          {table({"", "$η_{D}$", "$η_{R}$", "$φ_{R}$ (°)", "$φ_{D}$ (°)"}, rows),
           remark(
               (Words{"$η_{R}$ = 0 (rhombs) at the friction angle $φ_{R}$, from which the mechanism is self-locking; "
                      "$η_{D}$ = 0 at $φ_{D}$, where it jams and no force moves it.",
                      "$η_{R}$ = 0 (rombi) all'angolo d'attrito $φ_{R}$, dal quale il meccanismo è irreversibile; "
                      "$η_{D}$ = 0 all'angolo $φ_{D}$, dove s'impunta e nessuna forza lo muove."} +
                variants)
                   .in(language))},
      .seen = {"The efficiencies of the direct and of the retrograde motion over the friction angle",
               "I rendimenti del moto diretto e del retrogrado in funzione dell'angolo d'attrito"},
      .told = {"wedge_collar.eta_direct", "wedge_collar.eta_retrograde"},
      .without_part = Case(s, "none").without({}, {"phi"})};
}

}  // namespace epure::friction_efficiency
