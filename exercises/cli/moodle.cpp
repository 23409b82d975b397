#include "exercises/cli/moodle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "drawings/files/xml.h"
#include "drawings/output.h"
#include "drawings/text/text.h"
#include "exercises/cli/symbol.h"
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

// How far an answer may be off, by quantity: what half a millimetre or so is worth where the sheets show it.
class Tolerances {
 public:
  Tolerances(const Variant& variant, double reading) : variant_(variant) {
    for (const DrawnSheet& sheet : variant.solved)
      for (const Measurement& each : sheet.measurements) {
        const double worth = reading * each.per_mm;
        const auto [known, is_new] = shown_.try_emplace(each.quantity, worth);
        known->second = is_new ? worth : std::min(known->second, worth);  // the finest scale
      }
    for (const auto& [quantity, worth] : shown_)
      if (const auto value = variant_.solution.has(quantity) ? variant_.solution.value(quantity) : std::nullopt;
          value && std::abs(*value) > worth)
        coarsest_ = std::max(coarsest_, worth / std::abs(*value));
  }
  double of(const std::string& quantity, double value) const {
    const auto shown = shown_.find(quantity);
    return shown != shown_.end() ? shown->second : std::max(coarsest_, least_part) * std::abs(value);
  }

 private:
  static constexpr double least_part = 0.01;  // of a calculated number, where no sheet shows anything
  const Variant& variant_;
  std::map<std::string, double> shown_;
  double coarsest_ = 0;
};

std::string givens_in_words(const Solution& solution, Language language) {
  std::string all;
  const Givens& givens = solution.givens();
  for (const GivenSpec& spec : givens.specs()) {
    if (givens.follows(spec.symbol) || !spec.choices.empty()) continue;
    if (spec.beyond_source && !givens.is_changed(spec.symbol)) continue;
    const auto read = *givens.reading(spec.symbol);
    all += (all.empty() ? "" : ", ") + unicode_symbol(spec.letters.empty() ? spec.symbol : spec.letters) + " " +
           equal_to(read.number, language) + unit_after_number(read.unit.symbol, language);
  }
  return all;
}

}  // namespace

std::string moodle_question(const Exercise& exercise, const Candidate& student, const Variant& variant,
                            const Lots& lots, double reading) {
  const Language language = lots.request.language;
  SheetRequest request = lots.request;
  request.blank = request.bare = true;
  const Tolerances tolerances(variant, reading);
  std::string text = "<p>" + escaped_for_xml(drawings::plain(exercise.about().question.in(language))) + "</p>\n<p>" +
                     escaped_for_xml(givens_in_words(variant.solution, language)) + "</p>\n",
              files, rows;
  std::vector<std::string> asked;
  for (std::size_t i = 0; i < lots.sheets.size(); ++i) {
    const std::string name = exercise.about().id + "-" + lots.sheets[i] + "-blank.svg";
    text += fmt::format("<p><img src=\"@@PLUGINFILE@@/{}\" alt=\"{}\" /></p>\n", name, lots.sheets[i]);
    files += fmt::format("<file name=\"{}\" path=\"/\" encoding=\"base64\">{}</file>\n", name,
                         base64(drawings::svg(exercise.draw(lots.sheets[i], variant.solution, request).sheet)));
    for (const std::string& quantity : variant.solved[i].asked)
      if (std::find(asked.begin(), asked.end(), quantity) == asked.end()) asked.push_back(quantity);
  }
  for (const std::string& name : asked) {
    const auto value = variant.solution.value(name);
    if (!value) continue;
    const Quantity& quantity = variant.solution.described(name);
    rows += fmt::format("<tr><td>{}</td><td>{{1:NUMERICAL:={}:{:.3g}}}</td><td>{}</td></tr>\n",
                        escaped_for_xml(unicode_symbol(quantity.symbol)), *value, tolerances.of(name, *value),
                        escaped_for_xml(written_unit(quantity.unit, language)));
  }
  text += "<table>\n" + rows + "</table>\n";
  return fmt::format(
      "<question type=\"cloze\">\n<name><text>{}</text></name>\n<questiontext format=\"html\">\n<text><![CDATA[{}]]>"
      "</text>\n{}</questiontext>\n<generalfeedback format=\"html\"><text></text></generalfeedback>\n"
      "<penalty>0.3333333</penalty>\n<hidden>0</hidden>\n</question>\n",
      escaped_for_xml(exercise.about().id + " " + student.number), text, files);
}

std::string moodle_quiz(const std::vector<std::string>& questions) {
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<quiz>\n";
  for (const std::string& question : questions) text += question;
  return text + "</quiz>\n";
}

}  // namespace epure
