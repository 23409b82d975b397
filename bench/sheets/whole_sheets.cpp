// Where the time of whole sheets goes, and the floor under them.
#include "bench/sheets/bench_sheet.h"

#include <algorithm>

#include "drawings/charts/chart.h"

namespace epure::bench {
namespace {

constexpr double of_many_columns = 2.2;  // mm, for thirteen columns

}  // namespace

drawings::Sheet whole_sheets(const Drawn& drawn) {
  drawings::Sheet sheet =
      drawn.blank(4, "whole-sheets", {"Whole sheets", "Tavole intere"},
                  {"Processor time of epure draw for the first sheet of each exercise, by kind of work, beside a "
                   "bare program that draws the same by Cairo and Pango.",
                   "Tempo di processore di epure draw per la prima tavola di ogni esercizio, per tipo di lavoro, "
                   "accanto a un programma nudo che disegna lo stesso con Cairo e Pango."});
  const drawings::Box room = drawn.area();
  const double width = room.width();
  Rows rows{{drawn.say({"sheet", "tavola"}), "epure", drawn.say({"floor", "minimo"}),
             drawn.say({"ratio", "rapporto"}), drawn.say({"start", "avvio"}), drawn.say({"constr.", "costr."}),
             "layout", drawn.say({"fonts", "caratteri"}), drawn.say({"text", "testo"}), "PDF", "SVG",
             drawn.say({"files", "file"}), drawn.say({"other", "altro"})}};
  drawings::Chart chart;
  chart.x = {.quantity = drawn.say({"floor", "minimo"}), .unit = "ms", .low = 0, .high = 10};
  chart.y = {.quantity = drawn.say({"epure draw, PDF and SVG", "epure draw, PDF e SVG"}),
             .unit = "ms",
             .low = 0,
             .high = 15};
  std::vector<drawings::Datum> points;
  for (const SheetResult& each : drawn.report.sheets) {
    const auto& p = each.parts_ms;
    const auto part = [&](std::size_t i) { return i < p.size() ? fmt::format("{:.1f}", p[i]) : std::string("–"); };
    rows.push_back({each.sheet, fmt::format("{:.1f}", each.epure_ms), fmt::format("{:.1f}", each.floor_ms),
                    fmt::format("{:.2f}", each.epure_ms / each.floor_ms), part(0), part(2), part(3), part(4), part(5),
                    part(6), part(7), part(8), part(1)});
    points.push_back({each.floor_ms, each.epure_ms});
    chart.x.high = std::max(chart.x.high, 1.2 * each.floor_ms);
    chart.y.high = std::max(chart.y.high, 1.2 * each.epure_ms);
  }
  const double end = chart.x.high;
  chart.y.high = std::max(chart.y.high, 1.6 * end);
  if (!points.empty())
    chart.curves.push_back({.name = "sheets", .points = points, .shape = drawings::PointShape::ring});
  const auto times = [&](double factor, const std::string& label, drawings::LineType line) {
    chart.curves.push_back(
        {.runs = {{{0, 0}, {end, factor * end}}}, .meaning = drawings::Meaning::link, .line = line, .label = label});
  };
  times(1, drawn.say({"the floor itself", "il minimo stesso"}), drawings::LineType::continuous);
  times(1.5, drawn.say({"1.5 times the floor", "1,5 volte il minimo"}), drawings::LineType::dashed);
  std::vector<SheetColumn> columns{{0.27 * width, false}, {0.066 * width}, {0.066 * width}, {0.07 * width}};
  columns.resize(13, {0.0585 * width});
  const double table_height = height_of_table(rows, of_many_columns);
  draw_table(sheet.figure, rows, columns, {room.low.x, room.low.y + table_height}, of_many_columns);
  draw(chart, {{room.low.x, room.low.y + table_height + 5}, room.high}, sheet.figure, drawn.language);
  drawn.explain(
      sheet,
      {{"Milliseconds of processor time, from the start of the process to its end, the least of some runs in turn. "
        "PDF and SVG of one sheet, synced to the disk.",
        "Millisecondi di tempo di processore, dall'inizio alla fine del processo, il minore di alcune esecuzioni "
        "alternate. PDF e SVG di una tavola, scritti fino al disco."},
       {"The floor is a bare program: it opens the fonts, shapes each run of letters once, makes the recorded calls "
        "of Cairo for the PDF, writes the SVG plainly, and both files whole or not at all.",
        "Il minimo è un programma nudo: apre i caratteri, compone ogni gruppo di lettere una volta, fa le chiamate "
        "registrate di Cairo per il PDF, scrive l'SVG in modo semplice, e i due file interi o per niente."},
       {"The parts are the program's own account, of its fastest run with --times; the end of the process is in none "
        "of them.",
        "Le parti sono il conto del programma stesso, della sua esecuzione più rapida con --times; la fine del "
        "processo non è in nessuna."}});
  if (drawn.report.sheets.empty())
    sheet.column.push_back(drawings::Paragraph{drawn.say({"Nothing measured.", "Nulla di misurato."}) + " (" +
                                               drawn.report.no_sheets + ")"});
  return sheet;
}

}  // namespace epure::bench
