// Time and error of every family with every number.
#include "bench/sheets/bench_sheet.h"

#include <algorithm>
#include <cmath>

#include "drawings/charts/chart.h"

namespace epure::bench {
namespace {

using drawings::Datum;
using drawings::Meaning;
using drawings::PointShape;

// An error of zero has no place on a logarithmic axis: it stands at its foot. What is larger
// than all use stands near its top.
constexpr double foot = 1e-40, foot_shown = 1e-38, top_shown = 1e6, top = 1e8;

const std::vector<std::string> numbers{"fast", "bounded", "deep", "exact"};

struct Look {
  PointShape shape;
  Meaning meaning;
};
Look look_of(const std::string& number) {
  if (number == "fast") return {PointShape::cross, Meaning::acceleration};
  if (number == "bounded") return {PointShape::ring, Meaning::velocity};
  if (number == "deep") return {PointShape::square, Meaning::locus};
  return {PointShape::diamond, Meaning::force};
}

double shown(double error) { return std::clamp(error, foot_shown, top_shown); }

// A mark a family at its largest error, on a line down to its median.
drawings::Curve marks_of(const Report& report, const std::string& number) {
  const Look look = look_of(number);
  drawings::Curve curve{.name = number,
                        .meaning = look.meaning,
                        .line = drawings::LineType::continuous,
                        .shape = look.shape,
                        .label = number};
  for (const FamilyResult& each : report.families) {
    if (each.number != number || !each.settled_any()) continue;
    const Datum worst{each.ns_per_result, shown(each.max_relative_error)};
    curve.points.push_back(worst);
    curve.runs.push_back({{worst.x, shown(each.median_relative_error)}, worst});
  }
  return curve;
}

double median(std::vector<double> of) {
  const auto middle = of.begin() + static_cast<std::ptrdiff_t>(of.size() / 2);
  std::nth_element(of.begin(), middle, of.end());
  return *middle;
}

// Half of the families are faster, half have a smaller worst error.
Datum middle_of(const Report& report, const std::string& number) {
  std::vector<double> times, errors;
  for (const FamilyResult& each : report.families) {
    if (each.number != number || !each.settled_any()) continue;
    times.push_back(each.ns_per_result);
    errors.push_back(shown(each.max_relative_error));
  }
  return {median(times), median(errors)};
}

// Down and to the right, from each number that no other beats both in time and in error.
drawings::Curve frontier(const Drawn& drawn) {
  std::vector<Datum> middles;
  for (const std::string& number : numbers) middles.push_back(middle_of(drawn.report, number));
  std::sort(middles.begin(), middles.end(), [](const Datum& a, const Datum& b) { return a.x < b.x; });
  std::vector<Datum> steps;
  for (const Datum& each : middles) {
    if (!steps.empty() && each.y >= steps.back().y) continue;
    if (!steps.empty()) steps.push_back({each.x, steps.back().y});
    steps.push_back(each);
  }
  return {.name = "frontier",
          .runs = {steps},
          .meaning = Meaning::link,
          .line = drawings::LineType::dashed,
          .label = drawn.say({"frontier", "frontiera"})};
}

}  // namespace

drawings::Sheet speed_against_error(const Drawn& drawn) {
  drawings::Sheet sheet =
      drawn.blank(1, "speed-against-error", {"Speed against error", "Velocità ed errore"},
                  {"For each family of constructions and each number, the time a result takes and the largest "
                   "relative error over the cases of its corpus, both on logarithmic axes.",
                   "Per ogni famiglia di costruzioni e ogni numero, il tempo di un risultato e il massimo errore "
                   "relativo sui casi del suo corpus, su assi logaritmici."});
  double least = INFINITY, most = 0;
  for (const FamilyResult& each : drawn.report.families) {
    least = std::min(least, each.ns_per_result);
    most = std::max(most, each.ns_per_result);
  }
  drawings::Chart chart;
  chart.x = {.quantity = drawn.say({"time per result", "tempo per risultato"}),
             .unit = "ns",
             .low = least / 2,
             .high = 2 * most,
             .scale = drawings::AxisScale::logarithmic};
  chart.y = {.quantity = drawn.say({"relative error made", "errore relativo commesso"}),
             .low = foot,
             .high = top,
             .scale = drawings::AxisScale::logarithmic};
  for (const std::string& number : numbers) chart.curves.push_back(marks_of(drawn.report, number));
  chart.curves.push_back(frontier(drawn));
  chart.horizontals = {{1}};
  chart.legend = true;
  draw(chart, drawn.area(), sheet.figure, drawn.language);
  drawn.explain(
      sheet,
      {{"A mark is a family of constructions with one number: its largest error over all cases of its corpus, "
        "special positions hit and missed by 1e-3 to 1e-30. The line from it ends at the median error.",
        "Un segno è una famiglia di costruzioni con un numero: il suo massimo errore su tutti i casi del suo corpus, "
        "posizioni particolari esatte e mancate di 1e-3 fino a 1e-30. La linea che ne parte finisce all'errore "
        "mediano."},
       {"Errors are those made, against references of 110 digits or more. At the foot they are 1e-38 or less, or "
        "zero; above the line at 1 no digit is right; near the upper edge they are 1e6 or more.",
        "Gli errori sono quelli commessi, rispetto a riferimenti di almeno 110 cifre. Al piede sono 1e-38 o meno, "
        "oppure zero; sopra la linea a 1 nessuna cifra è giusta; presso il bordo superiore sono 1e6 o più."},
       {"Bounded promises an enclosure and hands over what it cannot settle; deep takes more bits; fast promises "
        "nothing. Each is timed on the cases it settles; fast and bounded on four-bar-second-order as a sweep.",
        "Bounded promette un intervallo e cede ciò che non può decidere; deep prende più bit; fast non promette "
        "nulla. Ognuno è misurato sui casi che decide; fast e bounded su four-bar-second-order come scansione."},
       {"The frontier joins the medians of those numbers that no other beats both in time and in error.",
        "La frontiera unisce le mediane dei numeri che nessun altro supera insieme in tempo ed errore."}});
  return sheet;
}

}  // namespace epure::bench
