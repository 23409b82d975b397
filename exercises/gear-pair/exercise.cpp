#include "exercises/gear-pair/exercise.h"

#include <fmt/format.h>

#include <algorithm>

#include "exercises/gear-pair/fault_words.h"
#include "exercises/gear-pair/quantities.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/proof/solution.h"
#include "exercises/kit/proof/verdict.h"

namespace epure {
namespace gear_pair {
namespace {

Description description() {
  return {.id = "gear-pair",
          .title = {"A pair of involute gears", "Una coppia di ruote dentate a evolvente"},
          .document = "sapienza",
          .item = "N.12",
          .source = {"Sapienza, Exercises in applied mechanics 2009/10, N.12",
                     "Sapienza, Esercitazioni di meccanica applicata 2009/10, N.12"},
          .givens = givens(),
          .sheets = {{"pitch-point", {"The mesh around the pitch point", "L'ingranamento intorno al punto P₀"}},
                     {"wheels", {"The wheels", "Le ruote"}},
                     {"sliding", {"Sliding along the path of contact", "Strisciamento lungo l'ingranamento"}}},
          .quantities = quantities(),
          .printed = printed_by_the_source()};
}

class GearPairExercise : public Exercise {
 public:
  const Description& about() const override { return about_; }

  std::vector<RouteValue> solve(const Givens& givens, Rung rung) const override {
    return settle(Routes(pair_of(givens), speed_of(givens)), rung);
  }

  std::vector<Flaw> flaws(const Givens& givens) const override {
    const DrawnPair pair = drawn_pair(pair_of(givens), speed_of(givens));
    std::vector<Flaw> all;
    for (const geometry::Fault& fault : pair.faults)
      all.push_back(
          {{sentence(fault, pair, Language::english), sentence(fault, pair, Language::italian)}, fault.undecided});
    return all;
  }

  DrawnSheet draw(const std::string& sheet, const Solution& solution, const SheetRequest& request) const override {
    const Givens& givens = solution.givens();
    const DrawnPair pair = drawn_pair(pair_of(givens), speed_of(givens));
    const Differences differences = givens.as_stated() ? differences_of_source(givens) : Differences{};
    const std::set<std::string> without_part = pair.is_rack() ? std::set<std::string>{"z2"} : std::set<std::string>{};
    DrawnSheet onto = blank_sheet(about_, sheet, givens, request, without_part);
    if (sheet == "pitch-point") draw_pitch_point(onto, pair, differences, request);
    if (sheet == "wheels") draw_wheels(onto, pair, request);
    if (sheet == "sliding") draw_sliding(onto, pair, differences, request);
    return onto;
  }

 private:
  const Quantity& quantity(const std::string& name) const {
    return *std::find_if(about_.quantities.begin(), about_.quantities.end(),
                         [&](const Quantity& spec) { return spec.name == name; });
  }

  Differences differences_of_source(const Givens& givens) const {
    Differences all;
    const std::vector<RouteValue> values = solve(givens, Rung::bounded);
    for (const Printed& printed : about_.printed) {
      const auto found = std::find_if(values.begin(), values.end(),
                                      [&](const RouteValue& value) { return value.quantity == printed.quantity; });
      if (found == values.end()) continue;
      const PrintedVerdict verdict = judge(printed, found->settled);
      if (verdict.verdict == Verdict::disagrees)
        all.push_back(
            {quantity(printed.quantity), printed.text, found->settled.enclosure.value, verdict.explanation});
    }
    return all;
  }

  Description about_ = description();
};

// Explanations are plain text, with "ω_r"; on a sheet its index is lowered.
std::string with_index(std::string text) {
  const std::string plain = "ω_r", rich = "$ω_{r}$";
  for (auto at = text.find(plain); at != std::string::npos; at = text.find(plain, at + rich.size()))
    text.replace(at, plain.size(), rich);
  return text;
}

}  // namespace

void add_differences(DrawnSheet& onto, const Differences& differences, const std::vector<std::string>& quantities,
                     Language language) {
  const bool english = language == Language::english;
  std::vector<std::string> lines, explanations;
  for (const Difference& each : differences) {
    if (std::find(quantities.begin(), quantities.end(), each.quantity.name) == quantities.end()) continue;
    std::string printed = each.printed;
    if (const auto point = printed.find('.'); !english && point != std::string::npos) printed[point] = ',';
    lines.push_back(fmt::format("{} = {}\u00a0{} {} {}", each.quantity.symbol, printed, each.quantity.unit,
                                english ? "for" : "invece di", figures(each.value, 4, language)));
    if (each.explanation) explanations.push_back(with_index(each.explanation->in(language)));
  }
  if (lines.empty()) return;
  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "The source prints" : "La fonte riporta"});
  std::string all;
  for (const std::string& line : lines) all += (all.empty() ? "" : ", ") + line;
  column.push_back(drawings::Paragraph{all + "."});
  if (!explanations.empty()) column.push_back(drawings::Paragraph{explanations.front()});
}

}  // namespace gear_pair

std::unique_ptr<Exercise> make_gear_pair() { return std::make_unique<gear_pair::GearPairExercise>(); }

}  // namespace epure
