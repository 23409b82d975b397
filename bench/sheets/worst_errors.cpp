// What plain doubles say of the hardest cases, and what the other numbers promise.
#include "bench/sheets/bench_sheet.h"

namespace epure::bench {
namespace {

constexpr double of_three_tables = 2.3, gap = 5;  // mm: three tables in the height of A4

std::vector<const FamilyResult*> rows_of(const Report& report, const std::string& number) {
  std::vector<const FamilyResult*> rows;
  for (const FamilyResult& each : report.families)
    if (each.number == number) rows.push_back(&each);
  return rows;
}

}  // namespace

drawings::Sheet worst_errors(const Drawn& drawn) {
  drawings::Sheet sheet = drawn.blank(2, "worst-errors", {"Worst errors", "Errori peggiori"},
                                      {"What plain doubles say of the hardest case of each family, and what is true; "
                                       "what the other numbers promise and hand over.",
                                       "Che cosa dicono i numeri double del caso più difficile di ogni famiglia, e "
                                       "che cosa è vero; che cosa promettono e cedono gli altri numeri."});
  const drawings::Box room = drawn.area();
  const double width = room.width();
  Rows told{{drawn.say({"family", "famiglia"}), drawn.say({"doubles say", "i double dicono"}),
             drawn.say({"true", "vero"}), drawn.say({"error", "errore"}), drawn.say({"wrong", "errati"}),
             drawn.say({"case: result", "caso: risultato"})}};
  for (const FamilyResult* each : rows_of(drawn.report, "fast"))
    told.push_back({each->family, fmt::format("{:.6g}", each->worst.told), fmt::format("{:.6g}", each->worst.truth),
                    short_error(each->max_relative_error), fmt::format("{}/{}", each->wrong, each->results),
                    each->worst.name});
  const double below = draw_table(
      sheet.figure, told,
      {{0.18 * width, false}, {0.13 * width}, {0.13 * width}, {0.09 * width}, {0.09 * width}, {0.38 * width, false}},
      {room.low.x, room.high.y - 2}, of_three_tables);
  Rows promised{{drawn.say({"family", "famiglia"}), "bounded ≤", drawn.say({"made", "fatto"}),
                 drawn.say({"handed", "ceduti"}), "deep ≤", drawn.say({"made", "fatto"}),
                 drawn.say({"handed", "ceduti"}), "exact", drawn.say({"handed", "ceduti"})}};
  const auto bounded = rows_of(drawn.report, "bounded"), deep = rows_of(drawn.report, "deep"),
             exact = rows_of(drawn.report, "exact");
  const auto bound = [](const FamilyResult* of) {
    return of->max_relative_bound ? short_error(*of->max_relative_bound) : std::string("–");
  };
  const auto handed = [](const FamilyResult* of) { return fmt::format("{:.0f} %", 100 * of->handed_over); };
  for (std::size_t i = 0; i < bounded.size(); ++i)
    promised.push_back({bounded[i]->family, bound(bounded[i]), short_error(bounded[i]->max_relative_error),
                        handed(bounded[i]), bound(deep[i]), short_error(deep[i]->max_relative_error), handed(deep[i]),
                        exact[i]->settled_any() ? short_error(exact[i]->max_relative_error) : std::string("–"),
                        handed(exact[i])});
  std::vector<SheetColumn> columns{{0.2 * width, false}};
  columns.resize(9, {0.1 * width});
  const double further_below =
      draw_table(sheet.figure, promised, columns, {room.low.x, below - gap}, of_three_tables);
  Rows decided{{drawn.say({"decisions", "decisioni"}), drawn.say({"asked", "chieste"}), "bounded", "deep",
                drawn.say({"otherwise", "altrimenti"}), drawn.say({"open", "aperte"}),
                drawn.say({"slowest", "più lenta"}), drawn.say({"case: question", "caso: domanda"})}};
  for (const DecisionResult& each : drawn.report.decisions)
    decided.push_back({each.family, std::to_string(each.asked), std::to_string(each.by_bounded),
                       std::to_string(each.by_deep), std::to_string(each.otherwise), std::to_string(each.undecided),
                       short_time(1e6 * each.slowest_ms), each.slowest});
  draw_table(sheet.figure, decided,
             {{0.2 * width, false},
              {0.07 * width},
              {0.08 * width},
              {0.07 * width},
              {0.07 * width},
              {0.07 * width},
              {0.09 * width},
              {0.35 * width, false}},
             {room.low.x, further_below - gap}, of_three_tables);
  drawn.explain(
      sheet,
      {{"Above: the result of a family that plain doubles get worst, of those that have a value other than zero. "
        "Wrong: results they call a number though they are zero or do not exist, or cannot give.",
        "Sopra: il risultato di una famiglia che i double sbagliano di più, fra quelli con un valore diverso da "
        "zero. Errati: risultati che chiamano un numero benché siano zero o non esistano, o che non sanno dare."},
       {"Below: the largest relative bound promised, the error made inside of it, and the share handed over: by "
        "bounded when half its width exceeds the value, by deep when 128 bits are too few for 30 digits, by exact "
        "when the scene leaves the tower of quadratic fields.",
        "Sotto: il massimo limite relativo promesso, l'errore commesso entro di esso, e la parte ceduta: da bounded "
        "quando metà della sua ampiezza supera il valore, da deep quando 128 bit non bastano per 30 cifre, da exact "
        "quando la scena esce dalla torre di campi quadratici."},
       {"At the foot: questions such as whether the linkage stands at a dead centre and on which side of it, and "
        "which number proves the answer (otherwise: an exact one, the rationals alone, or that nothing exists "
        "there).",
        "In basso: domande come se il meccanismo sta in un punto morto e da che parte, e quale numero dimostra la "
        "risposta."}});
  return sheet;
}

}  // namespace epure::bench
