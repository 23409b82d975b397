#include "exercises/kit/proof/checked.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "drawings/output.h"
#include "drawings/text/text.h"
#include "exercises/kit/proof/agreement.h"
#include "exercises/kit/proof/measured.h"
#include "exercises/kit/proof/route_names.h"
#include "exercises/kit/proof/solution.h"
#include "exercises/kit/proof/table_cells.h"
#include "exercises/kit/proof/told_numbers.h"
#include "exercises/kit/statement/decimal.h"
#include "exercises/kit/statement/workshop_unit.h"

namespace epure {
namespace {

using geometry::Settled;

void complain(std::vector<Complaint>& complaints, const std::string& quantity, const Words& what) {
  complaints.push_back({Complaint::About::quantity, quantity, quantity + ": " + what});
}

void compare_routes(CheckedExercise& checked, const CheckedQuantity& quantity) {
  for (const Words& each : contradictions(quantity.routes)) complain(checked.failures, quantity.spec.name, each);
}

// What several routes cannot tell for one reason is said once.
void demand_settled(CheckedExercise& checked, const CheckedQuantity& quantity) {
  std::vector<std::pair<Words, Words>> open;  // routes and their reason
  for (const RouteValue& route : quantity.routes) {
    if (route.settled.kind != Settled::Kind::undecided) continue;
    const auto same = std::find_if(open.begin(), open.end(),
                                   [&](const auto& earlier) { return earlier.second == route.settled.reason; });
    if (same == open.end())
      open.emplace_back(route_in_words(route.route), route.settled.reason);
    else
      same->first = same->first + ", " + route_in_words(route.route);
  }
  for (const auto& [routes, reason] : open)
    complain(checked.undecided, quantity.spec.name,
             format_words("undecided by {} ({})", "non decisa ({}: {})", routes, reason));
}

void demand_certainty(CheckedExercise& checked, const CheckedQuantity& quantity) {
  if (const Words why = want_of_certainty(quantity.settled); !why.empty())
    complain(checked.undecided, quantity.spec.name, why);
  std::set<std::string> routes;
  for (const RouteValue& route : quantity.routes) routes.insert(route.route);
  if (routes.size() < 2)
    complain(checked.failures, quantity.spec.name,
             {"only one route, so nothing confirms it", "una sola via, dunque nulla la conferma"});
}

// Quantities in the order of the description, each with its routes.
void group(CheckedExercise& checked, const std::vector<RouteValue>& values) {
  for (const Quantity& spec : checked.about.quantities()) {
    CheckedQuantity quantity{.spec = spec, .settled = {}, .routes = {}};
    std::copy_if(values.begin(), values.end(), std::back_inserter(quantity.routes),
                 [&](const RouteValue& value) { return value.quantity == spec.name; });
    if (quantity.routes.empty()) {
      complain(checked.failures, spec.name, {"no route gives it", "nessuna via la dà"});
      continue;
    }
    quantity.settled = best_known(quantity.routes);
    checked.quantities.push_back(std::move(quantity));
  }
}

CheckedQuantity* find(CheckedExercise& checked, const std::string& name) {
  const auto found = std::find_if(checked.quantities.begin(), checked.quantities.end(),
                                  [&](const CheckedQuantity& quantity) { return quantity.spec.name == name; });
  return found == checked.quantities.end() ? nullptr : &*found;
}

// What an exercise says of a quantity it does not list would be lost in silence.
void demand_listed(CheckedExercise& checked, const std::string& name, const Words& where) {
  const auto& listed = checked.about.quantities();
  if (std::none_of(listed.begin(), listed.end(), [&](const Quantity& spec) { return spec.name == name; }))
    complain(checked.failures, name,
             format_words("{}, but is not among the exercise's quantities",
                          "{}, ma non è tra le grandezze dell'esercizio", where));
}

// A direction at the seam of a turn may be drawn at its other side.
bool shows(const OnSheet& shown, double value, const std::string& unit) {
  constexpr double turn = 360;
  if (is_within_resolution(shown, value)) return true;
  return unit == "deg" && (is_within_resolution(shown, value - turn) || is_within_resolution(shown, value + turn));
}

void compare_sheet(CheckedExercise& checked, CheckedQuantity& quantity, const OnSheet& shown) {
  quantity.on_sheets.push_back(shown);
  if (quantity.settled.kind == Settled::Kind::unbounded) return;  // doubles promise nothing
  if (quantity.settled.kind == Settled::Kind::absent)
    complain(checked.failures, quantity.spec.name,
             format_words("sheet {} shows it, but it does not exist ({})",
                          "la tavola {} la mostra, ma non esiste ({})", shown.sheet, quantity.settled.reason));
  if (has_value(quantity.settled) && !shows(shown, quantity.settled.enclosure.value, quantity.spec.unit))
    complain(checked.failures, quantity.spec.name,
             format_words("sheet {} shows {}, which is not {} within {}",
                          "la tavola {} mostra {}, che non è {} entro {}", shown.sheet, all_digits(shown.value),
                          all_digits(quantity.settled.enclosure.value), all_digits(shown.resolution)));
}

// At the scale it is handed out at, on the smallest paper that has room for it; else at the largest that fits.
DrawnSheet as_handed_out(const Exercise& exercise, const Solution& solution, const std::string& name,
                         const SheetScales& scales) {
  if (const auto scale = scales.find(name); scale != scales.end())
    for (const drawings::Paper paper : {drawings::Paper::a4, drawings::Paper::a3}) {
      try {
        SheetRequest request;
        request.paper = paper;
        request.scale = scale->second;
        return exercise.draw(name, solution, request);
      } catch (const BadGivens&) {
        // then on the larger one
      }
    }
  return exercise.draw(name, solution, {});
}

// None when it cannot be drawn, or something on it could not be decided: the numbers and the other sheets are looked
// at all the same. (Givens that no exercise can have were refused by solve.)
std::optional<DrawnSheet> drawn_sheet(CheckedExercise& checked, const Exercise& exercise, const Solution& solution,
                                      const std::string& name, const SheetScales& scales) {
  const auto leave_out = [&](const Words& why) {
    checked.not_drawn.push_back(
        {Complaint::About::sheet, "", format_words("sheet {}: {}", "tavola {}: {}", name, why)});
  };
  try {
    return as_handed_out(exercise, solution, name, scales);
  } catch (const geometry::Undecided& open) {
    checked.undecided.push_back(
        {Complaint::About::sheet, "", format_words("sheet {}: {}", "tavola {}: {}", name, open.words())});
  } catch (const drawings::TooFar& why) {
    leave_out(why.words());
  } catch (const BadGivens& why) {
    leave_out(why.words());
  } catch (const geometry::Impossible& why) {
    leave_out(why.words());
  }
  return std::nullopt;
}

void look_for_flaws(CheckedExercise& checked, const Exercise& exercise) {
  for (const Flaw& flaw : exercise.flaws(checked.givens))
    (flaw.undecided ? checked.undecided : checked.failures)
        .push_back({Complaint::About::mechanism, "", flaw.sentence});
}

// What the sheets draw and print. None when nothing of it could be decided.
std::optional<Solution> drawn_solution(CheckedExercise& checked, const Exercise& exercise) {
  try {
    return exercise.solution(checked.givens);
  } catch (const geometry::Undecided& open) {
    checked.undecided.push_back(
        {Complaint::About::sheet, "", format_words("its sheets: {}", "le tavole: {}", open.words())});
  }
  return std::nullopt;
}

// Sheets are drawn with the bits that drawings need, not more: each number of theirs is held against what is proved.
void compare_solution(CheckedExercise& checked, const Solution& solution) {
  for (const CheckedQuantity& quantity : checked.quantities) {
    if (!solution.has(quantity.spec.name) || !has_value(quantity.settled)) continue;
    const auto drawn = solution.enclosure(quantity.spec.name);
    if (drawn && are_apart(*drawn, quantity.settled.enclosure))
      complain(checked.failures, quantity.spec.name,
               format_words("the sheets take it for {}, which does not lie {}",
                            "le tavole la prendono per {}, che non sta {}", all_digits(drawn->value),
                            where_it_lies(quantity.settled)));
  }
}

// What is proved; what belongs to the way there, which sheets tell and nobody reports (an iteration's steps); and
// what is given, without letters, as it may be said in other words. All as it is, and in the workshop's units.
std::vector<KnownNumber> known_numbers(const CheckedExercise& checked, const Solution& solution) {
  std::vector<KnownNumber> known;
  const auto add = [&](const Quantity& quantity, double value) {
    known.push_back({quantity.name, quantity.symbol, value});
    if (const auto unit = workshop_unit(quantity.unit))
      known.push_back({quantity.name, quantity.symbol, unit->per_si * value});
  };
  for (const CheckedQuantity& quantity : checked.quantities)
    if (has_value(quantity.settled)) add(quantity.spec, quantity.settled.enclosure.value);
  const auto& reported = checked.about.quantities();
  for (const RouteValue& told : solution.values()) {
    if (!told.described || std::any_of(reported.begin(), reported.end(),
                                       [&](const Quantity& each) { return each.name == told.quantity; }))
      continue;
    if (const auto value = solution.value(told.quantity)) add(*told.described, *value);
  }
  for (const GivenSpec& given : checked.givens.specs())
    if (given.choices.empty() && !checked.givens.follows(given.symbol))
      known.push_back({"", "", nearest(checked.givens[given.symbol])});
  return known;
}

// What sheets repeat in words: what the source prints, with the mistake that explains it, and faults.
std::vector<std::string> quoted(const CheckedExercise& checked) {
  std::vector<std::string> all;
  for (const Printed& printed : checked.about.printed()) {
    all.push_back(printed.text);
    if (printed.explanation) all.push_back(printed.explanation->sentence.english);
  }
  for (const auto* complaints : {&checked.failures, &checked.undecided})
    for (const Complaint& each : *complaints)
      if (each.about == Complaint::About::mechanism) all.push_back(each.sentence.english);
  return all;
}

void demand_told(CheckedExercise& checked, const drawings::Sheet& sheet, const std::string& name,
                 const std::vector<KnownNumber>& known) {
  for (const WrongNumber& wrong : wrong_numbers(sheet, known, quoted(checked)))
    checked.failures.push_back({Complaint::About::sheet, "",
                                format_words("sheet {} tells {}, which is not the quantity's value: {}",
                                             "la tavola {} dice {}, che non è il valore della grandezza: {}", name,
                                             wrong.number, drawings::plain(wrong.text))});
}

// Its rows are no quantities: they are held against another route, cell by cell.
void compare_table(CheckedExercise& checked, const Exercise& exercise, const Solution& solution,
                   const DrawnSheet& drawn, const std::string& name) {
  const std::optional<LongTable> table = exercise.long_table(name, solution);
  if (!table) return;
  try {
    if (const std::optional<Words> wrong = wrong_table(name, drawn, *table))
      checked.failures.push_back({Complaint::About::sheet, "", *wrong});
  } catch (const geometry::Undecided& open) {
    checked.undecided.push_back(
        {Complaint::About::sheet, "", format_words("sheet {}: {}", "tavola {}: {}", name, open.words())});
  }
}

void compare_sheets(CheckedExercise& checked, const Exercise& exercise, const SheetScales& scales) {
  const std::optional<Solution> solution = drawn_solution(checked, exercise);
  if (!solution) return;
  compare_solution(checked, *solution);
  const std::vector<KnownNumber> known = known_numbers(checked, *solution);
  for (const SheetSpec& spec : checked.about.sheets) {
    const std::optional<DrawnSheet> drawn = drawn_sheet(checked, exercise, *solution, spec.name, scales);
    if (!drawn) continue;
    demand_told(checked, drawn->sheet, spec.name, known);
    compare_table(checked, exercise, *solution, *drawn, spec.name);
    for (const Measurement& measurement : drawn->measurements) {
      demand_listed(checked, measurement.quantity, Words{"shown on sheet ", "mostrata sulla tavola "} + spec.name);
      if (CheckedQuantity* quantity = find(checked, measurement.quantity))
        compare_sheet(checked, *quantity, measure(measurement, spec.name, drawn->sheet.paper));
    }
  }
}

// A direction may be printed a turn off, 340° for -20°.
PrintedVerdict judged(const Printed& printed, const CheckedQuantity& quantity) {
  const PrintedVerdict verdict = judge(printed, quantity.settled);
  if (verdict.verdict != Verdict::disagrees || quantity.spec.unit != "deg" || !has_value(quantity.settled))
    return verdict;
  geometry::Settled a_turn_off = quantity.settled;
  double& value = a_turn_off.enclosure.value;
  value = nearest_turn(value, nearest(read_printed(printed.text).value), quantity.spec);
  const PrintedVerdict other = judge(printed, a_turn_off);
  return other.verdict == Verdict::disagrees ? verdict : other;
}

void compare_printed(CheckedExercise& checked) {
  for (const Printed& printed : checked.about.printed()) {
    demand_listed(checked, printed.quantity, {"printed by the source", "stampata dalla fonte"});
    CheckedQuantity* quantity = find(checked, printed.quantity);
    if (!quantity) continue;
    quantity->printed.push_back(judged(printed, *quantity));
    if (!quantity->printed.back().explanation_holds)
      complain(checked.failures, printed.quantity,
               format_words("the mistake that is to explain the printed {} does not give it",
                            "l'errore che dovrebbe spiegare il numero stampato {} non lo dà", decimal(printed.text)));
  }
}

}  // namespace

std::vector<std::string> complaints(const CheckedExercise& checked) {
  std::vector<std::string> sentences;
  for (const auto* all : {&checked.failures, &checked.undecided})
    for (const Complaint& each : *all) sentences.push_back(each.sentence.english);
  return sentences;
}

CheckedExercise check(const Exercise& exercise, const Givens& givens, Rung rung, const SheetScales& scales) {
  CheckedExercise checked{.about = exercise.about(), .givens = givens, .quantities = {}};
  const std::vector<RouteValue> values = exercise.solve(givens, rung);
  group(checked, values);
  for (const RouteValue& value : values)
    demand_listed(checked, value.quantity, Words{"found by ", "trovata per via "} + route_in_words(value.route));
  for (const CheckedQuantity& quantity : checked.quantities) {
    compare_routes(checked, quantity);
    demand_settled(checked, quantity);
    if (rung == Rung::climb) demand_certainty(checked, quantity);
  }
  look_for_flaws(checked, exercise);
  compare_sheets(checked, exercise, scales);
  if (givens.as_stated()) compare_printed(checked);
  if (givens.as_stated() && checked.about.audit) checked.audits = checked.about.audit();
  return checked;
}

}  // namespace epure
