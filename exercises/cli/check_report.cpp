#include "exercises/cli/check_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "drawings/text/text.h"
#include "exercises/cli/cases.h"
#include "exercises/cli/check_words.h"
#include "exercises/cli/columns.h"
#include "exercises/cli/terminal_ink.h"
#include "exercises/kit/proof/route_names.h"
#include "exercises/kit/statement/decimal.h"
#include "exercises/kit/statement/given_number.h"

namespace epure {
namespace {

using geometry::Settled;
using Rows = std::vector<std::vector<std::string>>;

// What a report calls its routes and sheets by: a letter each, and a number each.
class Marks {
 public:
  explicit Marks(const CheckedExercise& checked) {
    for (const CheckedQuantity& quantity : checked.quantities)
      for (const RouteValue& each : quantity.routes)
        if (std::find(routes_.begin(), routes_.end(), each.route) == routes_.end()) routes_.push_back(each.route);
    for (const SheetSpec& sheet : checked.about.sheets) sheets_.push_back(sheet.name);
  }

  std::string of_route(const std::string& route) const {
    const auto place = std::find(routes_.begin(), routes_.end(), route) - routes_.begin();
    return std::string(1, static_cast<char>('a' + place));
  }
  // Its place in the document, where it is the page.
  std::size_t of_sheet(const std::string& sheet) const {
    return static_cast<std::size_t>(std::find(sheets_.begin(), sheets_.end(), sheet) - sheets_.begin()) + 1;
  }

  // "Routes: a poles, b analytic" and "Sheets: 1 poles, 2 polodes".
  std::string key(Language language) const {
    std::vector<std::string> routes = {Words{"Routes:", "Vie:"}.in(language)};
    for (const std::string& route : routes_)
      routes.push_back(of_route(route) + " " + route_in_words(route).in(language) + ",");
    std::vector<std::string> sheets = {Words{"Sheets:", "Tavole:"}.in(language)};
    for (const std::string& sheet : sheets_) sheets.push_back(fmt::format("{} {},", of_sheet(sheet), sheet));
    for (std::vector<std::string>* list : {&routes, &sheets})
      if (list->size() > 1) list->back().pop_back();
    return wrapped(routes, 2, 4) + (sheets_.empty() ? "" : wrapped(sheets, 2, 4));
  }

 private:
  std::vector<std::string> routes_, sheets_;
};

// "abd": by whom it was found; "abd?" where the last of them could not tell.
std::string routes_of(const CheckedQuantity& quantity, const Marks& marks) {
  std::map<std::string, std::string> all;  // in the order of the marks
  for (const RouteValue& each : quantity.routes)
    if (std::string& doubt = all[marks.of_route(each.route)]; each.settled.kind == Settled::Kind::undecided)
      doubt = "?";
  std::string text;
  for (const auto& [mark, doubt] : all) text += mark + doubt;
  return text;
}

std::string shown(const OnSheet& on, const Marks& marks, Language language) {
  return fmt::format("{} ({})", on_sheet_in_words(on).in(language), marks.of_sheet(on.sheet));
}

std::string quantities(const CheckedExercise& checked, const Marks& marks, const Reader& reader) {
  const Language language = reader.language;
  const bool drawn = std::any_of(checked.quantities.begin(), checked.quantities.end(),
                                 [](const CheckedQuantity& quantity) { return !quantity.on_sheets.empty(); });
  Rows rows = {{Words{"quantity", "grandezza"}.in(language), Words{"value", "valore"}.in(language),
                Words{"routes", "vie"}.in(language), drawn ? Words{"on sheet", "sulla tavola"}.in(language) : ""}};
  Cases cases;
  for (const CheckedQuantity& quantity : checked.quantities) {
    const std::string name = cases.within(quantity.spec.name, rows);
    const bool open = quantity.settled.kind == Settled::Kind::undecided;
    const std::string text = value_in_words(quantity).in(language);
    std::vector<std::string> row = {name, open ? coloured(text, Ink::doubtful, reader.colours) : text,
                                    routes_of(quantity, marks), ""};
    for (const OnSheet& on : quantity.on_sheets) {
      row.back() = shown(on, marks, language);
      rows.push_back(row);
      row.assign(4, "");  // what a second sheet shows stands below
    }
    if (quantity.on_sheets.empty()) rows.push_back(row);
  }
  return table(rows, 2, {24, 19, 6});
}

Ink ink_of(Verdict verdict) {
  return verdict == Verdict::rounding ? Ink::good : verdict == Verdict::reading ? Ink::doubtful : Ink::bad;
}

std::string printed(const CheckedExercise& checked, const Reader& reader) {
  const Language language = reader.language;
  Rows rows = {{Words{"quantity", "grandezza"}.in(language), Words{"printed", "stampata"}.in(language),
                Words{"by", "per via"}.in(language), Words{"value", "valore"}.in(language),
                Words{"difference", "differenza"}.in(language), Words{"verdict", "giudizio"}.in(language)}};
  Cases cases;
  for (const CheckedQuantity& quantity : checked.quantities) {
    if (quantity.printed.empty()) continue;
    std::string name = cases.within(quantity.spec.name, rows);
    for (const PrintedVerdict& each : quantity.printed) {
      const Words found =
          has_value(quantity.settled) ? shown_digits(quantity.settled.enclosure.value) : value_in_words(quantity);
      rows.push_back({name, decimal(each.text).in(language), route_in_words(each.route).in(language),
                      found.in(language), percent(each.difference_percent).in(language),
                      coloured(in_words(each.verdict).in(language), ink_of(each.verdict), reader.colours)});
      name.clear();
    }
  }
  return rows.size() == 1 ? "" : "\n" + table(rows, 2, {16, 8, 13, 10, 10});
}

// Each after the heading, if there is one.
std::string text_of(const Remarks& remarks, const std::string& heading = {}) {
  std::string text = remarks.all().empty() ? "" : "\n";
  for (const auto& [subjects, remark] : remarks.all())
    text +=
        wrapped(heading + (heading.empty() ? "" : " ") + subjects + (subjects.empty() ? "" : ": ") + remark, 2, 4);
  return text;
}

std::string absences(const CheckedExercise& checked, Language language) {
  Remarks remarks;
  for (const CheckedQuantity& quantity : checked.quantities)
    if (quantity.settled.kind == Settled::Kind::absent)
      remarks.add(quantity.spec.name, quantity.settled.reason.in(language));
  return text_of(remarks);
}

std::string explanations(const CheckedExercise& checked, Language language) {
  Remarks remarks;
  for (const CheckedQuantity& quantity : checked.quantities)
    for (const PrintedVerdict& each : quantity.printed)
      if (each.explanation)
        remarks.add(
            format_words("{} printed {}", "{}, stampata {}", quantity.spec.name, decimal(each.text)).in(language),
            drawings::plain(each.explanation->in(language)));
  return text_of(remarks);
}

// Columns with the same blocks are told together.
std::string audits(const CheckedExercise& checked, Language language) {
  std::string text;
  for (const TableAudit& each : checked.audits) {
    Remarks remarks;
    for (const AuditedColumn& column : each.columns) {
      std::string blocks;
      for (const AuditedBlock& block : column.blocks)
        blocks += (blocks.empty() ? "" : "; ") + drawings::plain(block_in_words(each, block).in(language));
      remarks.add(column.name, blocks);
    }
    text +=
        "\n" + wrapped(format_words("Printed {}, row by row:", "Riga per riga, {}:", each.table).in(language), 2, 4);
    text += text_of(remarks).substr(1);
  }
  return text;
}

// As decimals where these have an end.
std::string givens(const Givens& givens, Language language) {
  constexpr std::size_t most_decimals = 24;
  std::vector<std::string> all;
  for (const GivenSpec& given : givens.specs())
    if (const auto read = givens.reading(given.symbol)) {
      const auto as_number = given.choices.empty() ? as_decimal(read->number, most_decimals) : std::nullopt;
      const std::string text = as_number ? decimal(*as_number).in(language) : givens.text(given.symbol);
      all.push_back(given.symbol + " = " + with_unit(text, read->unit.symbol) + ",");
    }
  if (!all.empty()) all.back().pop_back();
  return wrapped(all, 2, 4);
}

std::string listed(const std::vector<Complaint>& all, const std::string& heading, Language language) {
  Remarks remarks;
  for (const Complaint& each : all) {
    const std::string sentence = drawings::plain(each.sentence.in(language)), subject = each.quantity + ": ";
    if (!each.quantity.empty() && sentence.starts_with(subject))
      remarks.add(each.quantity, sentence.substr(subject.size()));
    else
      remarks.add({}, sentence);
  }
  return text_of(remarks, heading);
}

}  // namespace

std::string measured_report(const CheckedExercise& checked, const Reader& reader) {
  std::string text;
  for (const CheckedQuantity& quantity : checked.quantities)
    for (const Measured& each : quantity.measured) {
      const Words difference = each.difference ? decimal(fmt::format("{:+.3g}", *each.difference)) : Words{"-", "-"};
      const Words line =
          format_words("{} measured {}: computed {}, difference {} ({}), allowed {} ({}):",
                       "{} misurata {}: calcolata {}, differenza {} ({}), ammessa {} ({}):", quantity.spec.name,
                       each.text, value_in_words(quantity), difference, percent(each.difference_percent),
                       decimal(each.allowed, 3), each.allowed_by);
      text +=
          wrapped(line.in(reader.language) + " " +
                      coloured(verdict(each).in(reader.language), each.within ? Ink::good : Ink::bad, reader.colours),
                  2, 4);
    }
  return text;
}

std::string text_report(const CheckedExercise& checked, const Reader& reader) {
  const Language language = reader.language;
  const Marks marks(checked);
  const std::string title =
      fmt::format("{}: {} ({}, {})", checked.about.id, drawings::plain(checked.about.title.in(language)),
                  checked.about.document, checked.about.item);
  const std::string numbers = measured_report(checked, reader);
  return wrapped(title, 0, 2) + givens(checked.givens, language) + marks.key(language) + "\n" +
         quantities(checked, marks, reader) + absences(checked, language) + printed(checked, reader) +
         explanations(checked, language) + audits(checked, language) + (numbers.empty() ? "" : "\n" + numbers) +
         listed(checked.failures, coloured(Words{"FAILED", "FALLITO"}.in(language), Ink::bad, reader.colours),
                language) +
         listed(checked.undecided,
                coloured(Words{"UNDECIDED", "NON DECISO"}.in(language), Ink::doubtful, reader.colours), language) +
         listed(checked.not_drawn,
                coloured(Words{"NOT DRAWN", "NON DISEGNATO"}.in(language), Ink::doubtful, reader.colours), language);
}

Words verdict(const Measured& measured) {
  return measured.within ? Words{"within reading", "entro l'errore di lettura"}
                         : Words{"beyond reading", "oltre l'errore di lettura"};
}

}  // namespace epure
