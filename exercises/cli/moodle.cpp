#include "exercises/cli/moodle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "drawings/files/xml.h"
#include "drawings/output.h"
#include "drawings/text/text.h"
#include "exercises/cli/symbol.h"
#include "exercises/kit/panels/problem_sheet.h"
#include "exercises/kit/panels/results.h"
#include "exercises/kit/statement/given_number.h"

namespace epure {
namespace {

using drawings::escaped_for_xml;

std::string base64(const std::string& bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    const std::size_t there = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (k < there ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= there ? digits[three >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

// What an answer is held against: as mark has it, by all sheets of the exercise.
CheckedExercise checked_by_sheets(const Exercise& exercise, const Variant& variant, const Lots& lots) {
  std::vector<std::pair<std::string, std::vector<Measurement>>> sheets;
  for (const SheetSpec& spec : exercise.about().sheets) {
    const auto solved = std::find(lots.sheets.begin(), lots.sheets.end(), spec.name);
    try {
      sheets.emplace_back(spec.name,
                          solved != lots.sheets.end()
                              ? variant.solved[static_cast<std::size_t>(solved - lots.sheets.begin())].measurements
                              : exercise.draw(spec.name, variant.solution, lots.request).measurements);
    } catch (const Told&) {
      // A sheet that cannot be drawn at these givens shows nothing.
    }
  }
  CheckedExercise checked{exercise.about(), variant.solution.givens(), {}};
  for (const RouteValue& value : variant.solution.values()) {
    if (!variant.solution.is_reported(value.quantity)) continue;
    CheckedQuantity quantity{variant.solution.described(value.quantity), value.settled, {}};
    quantity.spec.name = value.quantity;
    if (const auto known = variant.solution.value(value.quantity)) quantity.settled.enclosure.value = *known;
    for (const auto& [sheet, measurements] : sheets)
      for (const Measurement& each : measurements)
        if (each.quantity == value.quantity) quantity.on_sheets.push_back(measure(each, sheet, lots.request.paper));
    checked.quantities.push_back(std::move(quantity));
  }
  return checked;
}

// What Moodle takes for right, as mark does: the value; of a direction also a whole turn away, either way; and the
// magnitude of a value below zero, as a number without a sign is one.
std::string right_answers(const Quantity& quantity, double value, double tolerance) {
  std::vector<double> right{value};
  if (const double turn = whole_turn(quantity); turn > 0) right.insert(right.end(), {value - turn, value + turn});
  if (value < 0) right.push_back(-value);
  std::string all;
  for (const double each : right) all += fmt::format("{}={}:{:.3g}", all.empty() ? "" : "~", each, tolerance);
  return all;
}

// Of all sheets, each once, as the blank sheets say it; but for what another of them asks.
std::vector<Words> not_asked(const Variant& variant, const std::vector<std::string>& asked) {
  std::set<std::string> seen(asked.begin(), asked.end());
  std::vector<std::string> without_value, off_sheet;
  for (const DrawnSheet& sheet : variant.solved)
    for (const Awkwardness& each : sheet.awkward)
      if (const auto name = quantity_not_asked(each); name && seen.insert(*name).second)
        (variant.solution.value(*name) ? off_sheet : without_value)
            .push_back(unicode_symbol(variant.solution.described(*name).symbol));
  return sentences_of_not_asked(without_value, off_sheet);
}

// The mechanism, of several in an exercise, that a given belongs to, which its meaning ends in; empty: there is one.
std::string mechanism_of(const GivenSpec& given, Language language) {
  if (given.symbol.find('.') == std::string::npos) return {};
  const std::string meaning = drawings::plain(given.meaning.in(language));
  const auto at = meaning.rfind(", ");
  return at == std::string::npos ? std::string() : meaning.substr(at + 2);
}

// A line of them for each mechanism, under its name.
std::vector<std::string> givens_in_words(const Description& about, const Solution& solution, Language language) {
  std::vector<std::string> lines;
  std::optional<std::string> before;
  const Givens& givens = solution.givens();
  for (const GivenSpec& spec : givens.specs()) {
    if (givens.follows(spec.symbol) || !spec.choices.empty()) continue;
    if (spec.beyond_source && !givens.is_changed(spec.symbol)) continue;
    const std::string mechanism = mechanism_of(spec, language);
    if (before != mechanism)
      lines.push_back(mechanism.empty() ? "" : mechanism + ": ");
    else
      lines.back() += ", ";
    before = mechanism;
    const auto read = *givens.reading(spec.symbol);
    lines.back() += unicode_symbol(spec.letters.empty() ? spec.symbol : spec.letters) + " " +
                    equal_to(read.number, language) + unit_after_number(read.unit.symbol, language);
  }
  for (const Words& each : about.also_given(givens)) {
    const std::string told = drawings::plain(each.in(language));
    if (lines.empty())
      lines.push_back(told);
    else
      lines.back() += ", " + told;
  }
  return lines;
}

}  // namespace

std::string moodle_question(const Exercise& exercise, const Variant& variant, const Lots& lots, const Ruler& ruler) {
  const Language language = lots.request.language;
  const auto paragraph = [](const std::string& of) { return "<p>" + escaped_for_xml(of) + "</p>\n"; };
  const Words question =
      lots.sheets.size() == 1 ? question_of(exercise.about(), lots.sheets.front()) : exercise.about().question;
  std::string text = paragraph(drawings::plain(question.in(language))), files, rows, origin;
  for (const std::string& line : givens_in_words(exercise.about(), variant.solution, language))
    text += paragraph(line);
  std::vector<std::string> asked;
  for (std::size_t i = 0; i < lots.sheets.size(); ++i) {
    SheetRequest request = lots.request_of(lots.sheets[i]);
    request.blank = request.bare = true;
    const std::string name = exercise.about().id + "-" + lots.sheets[i] + "-blank.svg";
    text += fmt::format(
        "<p><img src=\"@@PLUGINFILE@@/{}\" alt=\"{}\" /></p>\n", name,
        drawings::escaped_for_attribute(drawings::plain(title_of_sheet(exercise, lots.sheets[i]).in(language))));
    files += fmt::format("<file name=\"{}\" path=\"/\" encoding=\"base64\">{}</file>\n", name,
                         base64(drawings::svg(exercise.draw(lots.sheets[i], variant.solution, request).sheet)));
    for (const std::string& quantity : variant.solved[i].asked)
      if (std::find(asked.begin(), asked.end(), quantity) == asked.end()) asked.push_back(quantity);
    if (origin.empty()) origin = letter_of_origin(variant.solved[i].asked, variant.solution, variant.solved[i]);
  }
  const CheckedExercise checked = checked_by_sheets(exercise, variant, lots);
  Ruler on_it = ruler;
  if (lots.sheets.size() == 1) on_it.sheet = lots.sheets.front();
  for (const std::string& name : asked) {
    const auto quantity = std::find_if(checked.quantities.begin(), checked.quantities.end(),
                                       [&](const CheckedQuantity& each) { return each.spec.name == name; });
    rows += fmt::format(
        "<tr><td>{}</td><td>{{1:NUMERICAL:{}}}</td><td>{}</td><td>{}</td></tr>\n",
        escaped_for_xml(unicode_symbol(quantity->spec.symbol)),
        right_answers(quantity->spec, variant.solution[name], nearest(allowance(checked, *quantity, on_it).size)),
        escaped_for_xml(written_unit(quantity->spec.unit, language)),
        escaped_for_xml(drawings::plain(quantity->spec.meaning.in(language))));
  }
  if (const Words senses = positive_senses(asked, variant.solution, origin); !senses.empty())
    text += paragraph(drawings::plain(senses.in(language)));
  text += "<table>\n" + rows + "</table>\n";
  for (const Words& each : not_asked(variant, asked)) text += paragraph(each.in(language));
  return fmt::format("<questiontext format=\"html\">\n<text><![CDATA[{}]]></text>\n{}</questiontext>\n", text, files);
}

std::string moodle_quiz(const std::string& category, const std::vector<MoodleQuestion>& questions) {
  std::string path;
  for (const char c : category) path += c == '/' ? "//" : std::string(1, c);  // a slash of its own
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<quiz>\n<question type=\"category\">\n<category>"
      "<text>$course$/top/epure/{}</text></category>\n</question>\n",
      escaped_for_xml(path));
  const std::size_t digits = std::max<std::size_t>(3, std::to_string(questions.size()).size());
  for (std::size_t i = 0; i < questions.size(); ++i)
    text += fmt::format(
        "<question type=\"cloze\">\n<name><text>{:0{}} {}</text></name>\n{}"
        "<generalfeedback format=\"html\"><text></text></generalfeedback>\n"
        "<penalty>0.3333333</penalty>\n<hidden>0</hidden>\n</question>\n",
        i + 1, digits, escaped_for_xml(questions[i].name), questions[i].text);
  return text + "</quiz>\n";
}

}  // namespace epure
