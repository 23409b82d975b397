// What a check comes to, counted.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "exercises/cli/ink.h"
#include "exercises/cli/report.h"
#include "exercises/kit/columns.h"

namespace epure {
namespace {

struct Counts {
  std::size_t quantities = 0, failed = 0, undecided = 0, sheets_undecided = 0, measured = 0, within = 0;
  std::array<std::size_t, 3> printed = {};  // by Verdict

  void add(const CheckedExercise& checked) {
    quantities += checked.quantities.size();
    // What failed is not counted among the undecided again.
    std::set<std::string> bad, open;
    for (const Complaint& each : checked.failures) bad.insert(each.quantity);
    for (const Complaint& each : checked.undecided) {
      if (each.quantity.empty())
        ++sheets_undecided;
      else if (!bad.contains(each.quantity))
        open.insert(each.quantity);
    }
    failed += bad.size();
    undecided += open.size();
    for (const CheckedQuantity& quantity : checked.quantities) {
      for (const PrintedVerdict& each : quantity.printed) ++printed.at(static_cast<std::size_t>(each.verdict));
      measured += quantity.measured.size();
      within += static_cast<std::size_t>(std::count_if(quantity.measured.begin(), quantity.measured.end(),
                                                       [](const Measured& each) { return each.within; }));
    }
  }
};

std::string outcome(const Counts& counts, const Reader& reader) {
  if (counts.failed > 0) return coloured(Words{"FAILED", "FALLITO"}.in(reader.language), Ink::bad, reader.colours);
  if (counts.undecided + counts.sheets_undecided > 0)
    return coloured(Words{"UNDECIDED", "NON DECISO"}.in(reader.language), Ink::doubtful, reader.colours);
  return coloured(Words{"passed", "riuscito"}.in(reader.language), Ink::good, reader.colours);
}

// "686 quantities"; "3 of 686 quantities, 2 undecided"; "1 sheet; 686 quantities": how many are not as they should be
// comes first.
Words quantities_of(const Counts& counts) {
  const bool is_open = counts.undecided + counts.sheets_undecided > 0;
  Words text;
  if (counts.sheets_undecided > 0 && counts.failed == 0)
    text = counts.sheets_undecided == 1 ? Words{"1 sheet; ", "1 tavola; "}
                                        : format_words("{} sheets; ", "{} tavole; ", counts.sheets_undecided);
  const std::size_t wanting = counts.failed > 0 ? counts.failed : counts.undecided;
  text = text + (wanting > 0 ? format_words("{} of {} quantities", "{} di {} grandezze", wanting, counts.quantities)
                             : format_words("{} quantities", "{} grandezze", counts.quantities));
  if (counts.failed > 0 && is_open)
    text = text + format_words(", {} undecided", ", {} non decise", counts.undecided + counts.sheets_undecided);
  return text;
}

Words printed_numbers(const Counts& counts) {
  const auto [rounding, reading, disagree] = counts.printed;
  if (rounding + reading + disagree == 0) return {};
  return format_words("; printed: {} rounding, {} reading, {} disagree",
                      "; stampate: {} arrotondate, {} lettura, {} discordi", rounding, reading, disagree);
}

Words measured_numbers(const Counts& counts) {
  return format_words("; measured: {} of {} within reading", "; misurate: {} di {} entro la lettura", counts.within,
                      counts.measured);
}

}  // namespace

std::string closing_line(const CheckedExercise& checked, const Reader& reader) {
  Counts counts;
  counts.add(checked);
  std::set<std::string> routes;
  for (const CheckedQuantity& quantity : checked.quantities)
    for (const RouteValue& each : quantity.routes) routes.insert(each.route);
  return wrapped(fmt::format("{}: {}, {} {}, {}", checked.about.id, quantities_of(counts).in(reader.language),
                             routes.size(), Words{"routes", "vie"}.in(reader.language), outcome(counts, reader)),
                 0, 2);
}

std::string totals(const std::vector<CheckedExercise>& all, const Reader& reader) {
  Counts counts;
  for (const CheckedExercise& checked : all) counts.add(checked);
  const Words text =
      quantities_of(counts) + (counts.measured > 0 ? measured_numbers(counts) : printed_numbers(counts));
  return wrapped(outcome(counts, reader) + ": " + text.in(reader.language), 0, 2);
}

}  // namespace epure
