// Curves to a tolerance: arcs of proved deviation, and lines between points at equal steps.
#include "bench/sheets/bench_sheet.h"

#include <algorithm>

#include "drawings/charts/chart.h"

namespace epure::bench {
namespace {

Words name_of(const std::string& curve) {
  if (curve == "cycloid") return {"cycloid", "cicloide"};
  if (curve == "involute") return {"involute", "evolvente"};
  if (curve == "polode") return {"polode", "polare"};
  return {"coupler curve", "curva di biella"};
}

}  // namespace

drawings::Sheet curves(const Drawn& drawn) {
  drawings::Sheet sheet =
      drawn.blank(3, "curves", {"Curves to a tolerance", "Curve entro una tolleranza"},
                  {"Number of Bezier arcs of proved deviation, and of lines between points at equal steps, against "
                   "the tolerance asked; with time, bytes and the deviation verified.",
                   "Numero di archi di Bezier con scostamento dimostrato, e di segmenti fra punti a passi uguali, in "
                   "funzione della tolleranza; con tempo, byte e scostamento verificato."});
  const drawings::Box room = drawn.area();
  drawings::Chart chart;
  chart.x = {.quantity = drawn.say({"tolerance asked", "tolleranza richiesta"}),
             .unit = "m",
             .low = 1e-4,
             .high = 1e-4,
             .scale = drawings::AxisScale::logarithmic};
  chart.y = {.quantity = drawn.say({"arcs or lines", "archi o segmenti"}),
             .low = 1,
             .high = 10,
             .scale = drawings::AxisScale::logarithmic};
  std::vector<std::string> names;
  for (const CurveResult& each : drawn.report.curves) {
    if (std::find(names.begin(), names.end(), each.curve) == names.end()) names.push_back(each.curve);
    chart.x.low = std::min(chart.x.low, each.tolerance);
    chart.y.high = std::max({chart.y.high, static_cast<double>(each.arcs), static_cast<double>(each.uniform_lines)});
  }
  chart.x.low /= 2;
  chart.x.high *= 2;
  for (const std::string& name : names) {
    std::vector<drawings::Datum> arcs, lines;
    for (const CurveResult& each : drawn.report.curves) {
      if (each.curve != name) continue;
      arcs.push_back({each.tolerance, static_cast<double>(each.arcs)});
      if (each.uniform_lines > 0) lines.push_back({each.tolerance, static_cast<double>(each.uniform_lines)});
    }
    chart.curves.push_back({.runs = {arcs},
                            .meaning = drawings::Meaning::locus,
                            .line = drawings::LineType::continuous,
                            .points = arcs,
                            .label = drawn.say(name_of(name)) + drawn.say({", arcs", ", archi"})});
    if (!lines.empty())
      chart.curves.push_back({.runs = {lines},
                              .meaning = drawings::Meaning::acceleration,
                              .line = drawings::LineType::dashed,
                              .points = lines,
                              .label = drawn.say(name_of(name)) + drawn.say({", lines", ", segmenti"})});
  }
  chart.legend = true;
  Rows rows{{drawn.say({"curve", "curva"}), drawn.say({"asked", "richiesta"}), drawn.say({"proved", "dimostrato"}),
             drawn.say({"verified", "verificato"}), drawn.say({"arcs", "archi"}), drawn.say({"time", "tempo"}),
             drawn.say({"bytes", "byte"}), drawn.say({"lines", "segmenti"}), drawn.say({"time", "tempo"}),
             drawn.say({"bytes", "byte"})}};
  for (const CurveResult& each : drawn.report.curves)
    rows.push_back({drawn.say(name_of(each.curve)), fmt::format("{:.0e}", each.tolerance), short_error(each.proved),
                    short_error(each.verified), std::to_string(each.arcs), short_time(1e6 * each.ms),
                    std::to_string(each.bytes), each.uniform_lines > 0 ? std::to_string(each.uniform_lines) : ">1e5",
                    each.uniform_lines > 0 ? short_time(1e6 * each.uniform_ms) : "–",
                    each.uniform_lines > 0 ? std::to_string(each.uniform_bytes) : "–"});
  const double width = room.width();
  std::vector<SheetColumn> columns{{0.16 * width, false}};
  columns.resize(10, {0.093 * width});
  const double table_height = height_of_table(rows, letters);
  draw_table(sheet.figure, rows, columns, {room.low.x, room.low.y + table_height}, letters);
  draw(chart, {{room.low.x, room.low.y + table_height + 5}, room.high}, sheet.figure, drawn.language);
  drawn.explain(sheet,
                {{"Arcs: as epure draws, to the tolerance asked; proved is the bound it promises, verified the "
                  "largest distance of 2001 true points from the arcs. A curve is some 0.3 m to 1 m long.",
                  "Archi: come disegna epure, entro la tolleranza richiesta; dimostrato è il limite promesso, "
                  "verificato la massima distanza di 2001 punti veri dagli archi. Una curva è lunga da 0,3 m a 1 m."},
                 {"Lines: between points at equal steps of the angle, as many as deviate no more (found by looking, "
                  "not proved). Bytes are those the curve adds to a PDF.",
                  "Segmenti: fra punti a passi uguali dell'angolo, quanti bastano a scostarsi non di più (trovati "
                  "provando, non dimostrati). I byte sono quelli che la curva aggiunge a un PDF."}});
  return sheet;
}

}  // namespace epure::bench
