// What a check comes to, counted.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "exercises/cli/check_report.h"
#include "exercises/cli/columns.h"
#include "exercises/cli/terminal_ink.h"

namespace epure {
namespace {

// How many of a kind fail, and how many are open.
struct Tally {
  std::size_t failed = 0, undecided = 0;
};

struct Counts {
  std::size_t all_quantities = 0, measured = 0, within = 0;
  Tally quantities, sheets, mechanisms;
  std::size_t not_drawn = 0;                // sheets
  bool compared = true;                     // not what has no bounds
  std::array<std::size_t, 3> printed = {};  // by Verdict

  void add(const CheckedExercise& checked) {
    // What failed is not counted among the undecided again.
    std::set<std::string> bad, open;
    for (const Complaint& each : checked.failures)
      if (each.about == Complaint::About::quantity)
        bad.insert(each.quantity);
      else
        ++of(each.about).failed;
    for (const Complaint& each : checked.undecided)
      if (each.about != Complaint::About::quantity)
        ++of(each.about).undecided;
      else if (!bad.contains(each.quantity))
        open.insert(each.quantity);
    not_drawn += checked.not_drawn.size();
    quantities.failed += bad.size();
    quantities.undecided += open.size();
    all_quantities += checked.quantities.size();
    for (const CheckedQuantity& quantity : checked.quantities) {
      if (quantity.settled.kind == geometry::Settled::Kind::unbounded) compared = false;
      for (const PrintedVerdict& each : quantity.printed) ++printed.at(static_cast<std::size_t>(each.verdict));
      measured += quantity.measured.size();
      within += static_cast<std::size_t>(std::count_if(quantity.measured.begin(), quantity.measured.end(),
                                                       [](const Measured& each) { return each.within; }));
    }
  }

  std::size_t failed() const { return quantities.failed + sheets.failed + mechanisms.failed; }
  std::size_t undecided() const { return quantities.undecided + sheets.undecided + mechanisms.undecided; }

 private:
  Tally& of(Complaint::About about) { return about == Complaint::About::sheet ? sheets : mechanisms; }
};

std::string outcome(const Counts& counts, const Reader& reader) {
  if (counts.failed() > 0) return coloured(Words{"FAILED", "FALLITO"}.in(reader.language), Ink::bad, reader.colours);
  if (counts.undecided() > 0)
    return coloured(Words{"UNDECIDED", "NON DECISO"}.in(reader.language), Ink::doubtful, reader.colours);
  if (counts.not_drawn > 0)
    return coloured(Words{"NOT DRAWN", "NON DISEGNATO"}.in(reader.language), Ink::doubtful, reader.colours);
  if (!counts.compared) return Words{"not compared", "non confrontato"}.in(reader.language);
  return coloured(Words{"passed", "riuscito"}.in(reader.language), Ink::good, reader.colours);
}

// "2 faults; " or nothing.
Words counted(std::size_t count, const Words& one, const Words& many) {
  return count == 0 ? Words{} : format_words("{} {}; ", "{} {}; ", count, count == 1 ? one : many);
}

// "686 quantities"; "3 of 686 quantities, 2 undecided"; "1 sheet; 686 quantities": how many are not as they should be
// comes first, of the worse of the two kinds.
Words quantities_of(const Counts& counts) {
  const bool is_failed = counts.failed() > 0;
  const auto wanting = [&](const Tally& tally) { return is_failed ? tally.failed : tally.undecided; };
  const std::size_t sheets = is_failed || counts.undecided() > 0 ? wanting(counts.sheets) : counts.not_drawn;
  Words text = counted(wanting(counts.mechanisms), {"fault", "difetto"}, {"faults", "difetti"}) +
               counted(sheets, {"sheet", "tavola"}, {"sheets", "tavole"});
  text =
      text + (wanting(counts.quantities) > 0 ? format_words("{} of {} quantities", "{} di {} grandezze",
                                                            wanting(counts.quantities), counts.all_quantities)
                                             : format_words("{} quantities", "{} grandezze", counts.all_quantities));
  if (is_failed && counts.undecided() > 0)
    text = text + format_words(", {} undecided", ", {} non decise", counts.undecided());
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
