#include "exercises/cli/check_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "exercises/kit/statement/format_words.h"

namespace epure {

using geometry::Settled;

namespace {
constexpr int digits_shown = 6;
}  // namespace

Words shown_digits(double value) { return decimal(value, digits_shown); }

std::string with_unit(const std::string& number, const std::string& unit) {
  return unit == "1" ? number : number + " " + unit;
}

Words percent(const std::optional<double>& value) {
  if (!value) return {"-", "-"};
  if (std::abs(*value) < 0.005) return {"0 %", "0 %"};
  // From where on two digits would make it a hundred.
  constexpr double nearly_all = 99.5;
  return decimal(std::abs(*value) < nearly_all ? fmt::format("{:+.2g} %", *value)
                 : std::abs(*value) < 100      ? fmt::format("{:+.1f} %", *value)
                                               : fmt::format("{:+.0f} %", *value));
}

Words number_in_words(const CheckedQuantity& quantity) {
  const Settled& settled = quantity.settled;
  if (settled.kind == Settled::Kind::absent) return {"absent", "assente"};
  if (settled.kind == Settled::Kind::undecided) return {"undecided", "non decisa"};
  const auto [lower, middle, upper] = settled.enclosure;
  if (settled.kind == Settled::Kind::unbounded) return shown_digits(middle);
  // A value in the middle between two numbers of so many digits is shown by the next digit.
  for (int digits = digits_shown; digits <= digits_shown + 1; ++digits)
    if (decimal(lower, digits) == decimal(middle, digits) && decimal(upper, digits) == decimal(middle, digits))
      return decimal(middle, digits);
  return format_words("[{}, {}]", "[{}; {}]", shown_digits(lower), shown_digits(upper));
}

Words value_in_words(const CheckedQuantity& quantity) {
  const Words number = number_in_words(quantity);
  const std::string unit = has_value(quantity.settled) ? quantity.spec.unit : "1";
  return {with_unit(number.english, unit), with_unit(number.italian, unit)};
}

Words on_sheet_in_words(const OnSheet& on) {
  const Words number = std::abs(on.value) <= on.resolution ? Words{"0", "0"} : shown_digits(on.value);
  return number + " ± " + decimal(on.resolution, 1);
}

Words in_words(Verdict verdict) {
  static const std::array<std::string, 3> italian = {"arrotondata", "lettura", "discorda"};
  return {name(verdict), italian.at(static_cast<std::size_t>(verdict))};
}

namespace {

Words in_words(RowVerdict verdict) {
  static const std::array<std::string, 4> italian = {"giuste", "arrotondate", "spostate", "sbagliate"};
  return {name(verdict), italian.at(static_cast<std::size_t>(verdict))};
}

}  // namespace

Words block_in_words(const TableAudit& of, const AuditedBlock& block) {
  const std::size_t count = block.last - block.first + 1;
  const auto more = [&](std::size_t number, const Words& words) {
    return number == 0 ? Words{} : format_words(", {} ", ", {} ", number) + words;
  };
  const bool is_right = block.verdict == RowVerdict::right;
  const Words rows = count == 1
                         ? decimal(of.rows.at(block.first))
                         : format_words("{} to {} ({} rows)", "da {} a {} ({} righe)",
                                        decimal(of.rows.at(block.first)), decimal(of.rows.at(block.last)), count);
  const Words why = !block.mistake.empty() ? ": " + block.mistake
                    : is_right             ? Words{}
                                           : Words{": unexplained", ": senza spiegazione"};
  return rows + " " + in_words(block.verdict) +
         more(block.rounded, {"off by one in the last digit", "con l'ultima cifra diversa di uno"}) +
         more(is_right ? 0 : block.right, {"right all the same", "giuste lo stesso"}) + why;
}

void Remarks::add(const std::string& subject, const std::string& remark) {
  const auto known =
      std::find_if(all_.begin(), all_.end(), [&](const auto& entry) { return entry.remark == remark; });
  if (known == all_.end() || subject.empty())
    all_.push_back({subject, remark});
  else
    known->subjects += ", " + subject;
}

}  // namespace epure
