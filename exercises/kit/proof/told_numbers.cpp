#include "exercises/kit/proof/told_numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace epure {
namespace {

constexpr std::string_view minus = "−";

struct Told {
  std::string_view text;
  std::size_t at = 0;    // where it begins
  double value = 0;      // of its digits
  double half_unit = 0;  // of its last one
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// "_{2}", "^{n}" from `at` on: where it ends; `at` itself when there is none.
std::size_t after_script(std::string_view text, std::size_t at) {
  if (at + 1 >= text.size() || (text[at] != '_' && text[at] != '^') || text[at + 1] != '{') return at;
  const std::size_t end = text.find('}', at);
  return end == std::string_view::npos ? at : end + 1;
}

// The exponent of "·10^{−3}" or "e-05" at `at`, which moves behind it; 0 when there is none.
int power_of_ten(std::string_view text, std::size_t& at) {
  constexpr std::array<std::string_view, 2> powers{"·10^{", "e"};
  for (const std::string_view power : powers) {
    if (text.substr(at, power.size()) != power) continue;
    std::size_t digits = at + power.size();
    const bool is_negative = text.substr(digits, minus.size()) == minus || text.substr(digits, 1) == "-";
    if (is_negative) digits += text[digits] == '-' ? 1 : minus.size();
    if (text.substr(digits, 1) == "+") ++digits;
    int exponent = 0;
    const auto [end, error] = std::from_chars(text.data() + digits, text.data() + text.size(), exponent);
    if (error != std::errc{}) continue;
    at = static_cast<std::size_t>(end - text.data()) + (power == "e" ? 0 : 1);
    return is_negative ? -exponent : exponent;
  }
  return 0;
}

// The double nearest to these digits times a power of ten.
double nearest(const std::string& digits, int power) {
  const std::string written = digits + "e" + std::to_string(power);
  double value = 0;
  std::from_chars(written.data(), written.data() + written.size(), value);
  return value;
}

enum class Numbers { with_decimals, all };

// What is raised or lowered belongs to a symbol.
std::vector<Told> numbers_in(std::string_view text, Numbers which = Numbers::with_decimals) {
  std::vector<Told> all;
  for (std::size_t i = 0; i < text.size();) {
    if (const std::size_t behind = after_script(text, i); behind != i) {
      i = behind;
      continue;
    }
    if (!is_digit(text[i])) {
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && is_digit(text[end])) ++end;
    int decimals = 0;
    if (end + 1 < text.size() && text[end] == '.' && is_digit(text[end + 1])) {
      const std::size_t point = end++;
      while (end < text.size() && is_digit(text[end])) ++end;
      decimals = static_cast<int>(end - point - 1);
    } else if (which == Numbers::with_decimals) {
      i = end;
      continue;
    }
    Told told{.text = {}, .at = i};
    const std::string digits(text.substr(i, end - i));
    const int power = power_of_ten(text, end);
    told.value = nearest(digits, power);
    told.half_unit = nearest("5", power - decimals - 1);
    if (i >= minus.size() && text.substr(i - minus.size(), minus.size()) == minus) told.at -= minus.size();
    if (i >= 1 && text[i - 1] == '-') told.at -= 1;
    if (told.at != i) told.value = -told.value;
    told.text = text.substr(told.at, end - told.at);
    all.push_back(told);
    i = end;
  }
  return all;
}

// Whether it is the value, rounded. Of a tie the doubles may lie beside it, what is told, what is known and the half
// of a unit each by half of its last place.
bool rounds(const Told& told, double value) {
  const double most = std::max(std::abs(told.value), std::abs(value)),
               last_place = std::nextafter(most, INFINITY) - most;
  return std::abs(told.value - value) <= told.half_unit + 2 * last_place;
}
// In formulas magnitudes stand between bars.
bool tells(const Told& told, double value) { return rounds(told, value) || rounds(told, -value); }

class Reader {
 public:
  Reader(const std::vector<KnownNumber>& known, const std::vector<std::string>& quoted) : known_(known) {
    for (const std::string& text : quoted)
      for (const Told& told : numbers_in(text)) known_.push_back({"", "", told.value});
  }

  void read(const std::string& text) {
    const std::vector<Told> all = numbers_in(text);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool is_right = is_pair(text, all, i) ? tells_one_thing(all[i], all[i + 1])
                                                  : this->is_right(all[i], letters_before(text, all[i].at));
      if (!is_right) wrong_.push_back({std::string(all[i].text), text});
    }
  }

  // Of the rows of a table by points, "$v_{X}$ (m/s)" in the head is "$v_{B}$" in the row of B.
  void read(const drawings::Table& table) {
    for (const auto& row : table.rows)
      for (std::size_t column = 0; column < row.size(); ++column) {
        const std::string letters = column > 0 && column < table.head.size()
                                        ? letters_of_cell(table.head[0], table.head[column], row[0])
                                        : std::string();
        for (const Told& told : numbers_in(row[column]))
          if (!is_right(told, letters))
            wrong_.push_back({std::string(told.text), row[0] + ", " + table.head[column]});
      }
  }

  std::vector<WrongNumber> wrong() && { return std::move(wrong_); }

 private:
  // "(1.2; 3.4)" from the number of this index on.
  static bool is_pair(std::string_view text, const std::vector<Told>& all, std::size_t i) {
    if (i + 1 == all.size()) return false;
    const Told &x = all[i], &y = all[i + 1];
    return text.substr(0, x.at).ends_with('(') && text.substr(y.at + y.text.size()).starts_with(')') &&
           text.substr(x.at + x.text.size(), 2) == "; " && x.at + x.text.size() + 2 == y.at;
  }

  bool tells_one_thing(const Told& x, const Told& y) const {
    return std::any_of(known_.begin(), known_.end(), [&](const KnownNumber& of_x) {
      if (!of_x.name.ends_with("_x") || !rounds(x, of_x.value)) return false;
      const std::string other = of_x.name.substr(0, of_x.name.size() - 1) + "y";
      return std::any_of(known_.begin(), known_.end(),
                         [&](const KnownNumber& of_y) { return of_y.name == other && rounds(y, of_y.value); });
    });
  }

  bool is_right(const Told& told, std::string_view letters) const {
    bool is_named = false;
    for (const KnownNumber& each : known_) {
      if (letters.empty() || each.symbol != letters) continue;
      if (rounds(told, each.value)) return true;
      is_named = true;
    }
    return !is_named && std::any_of(known_.begin(), known_.end(),
                                    [&](const KnownNumber& each) { return tells(told, each.value); });
  }

  // "$v_{B}$" before " = "; empty when nothing of the kind stands there.
  static std::string_view letters_before(std::string_view text, std::size_t number) {
    constexpr std::string_view equals = " = ";
    if (number < equals.size() || text.substr(number - equals.size(), equals.size()) != equals) return {};
    const std::size_t end = number - equals.size();
    if (end < 2 || text[end - 1] != '$') return {};
    const std::size_t begin = text.rfind('$', end - 2);
    if (begin == std::string_view::npos || ends_a_formula(text.substr(0, begin))) return {};
    return text.substr(begin, end - begin);
  }

  // Whether an operator stands at its end: a sum or a product goes on.
  static bool ends_a_formula(std::string_view text) {
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    constexpr std::array<std::string_view, 7> operators{"/", "·", "+", "-", minus, "×", "="};
    return std::any_of(operators.begin(), operators.end(),
                       [&](std::string_view each) { return text.ends_with(each); });
  }

  static std::string letters_of_cell(const std::string& first_head, const std::string& head,
                                     const std::string& point) {
    if (first_head != "$X$" || point.size() < 3 || point.front() != '$' || point.back() != '$') return {};
    const std::size_t end = head.find('$', 1);
    if (head.empty() || head.front() != '$' || end == std::string::npos) return {};
    std::string letters = head.substr(0, end + 1);
    if (const std::size_t X = letters.find('X'); X != std::string::npos)
      letters.replace(X, 1, point, 1, point.size() - 2);
    return letters;
  }

  std::vector<KnownNumber> known_;
  std::vector<WrongNumber> wrong_ = {};
};

bool is_of_the_solution(const std::string& heading) {
  constexpr std::array<std::string_view, 3> others{"Given", "The curve", "The curves"};
  return std::find(others.begin(), others.end(), heading) == others.end();
}

}  // namespace

std::vector<WrongNumber> wrong_numbers(const drawings::Sheet& sheet, const std::vector<KnownNumber>& known,
                                       const std::vector<std::string>& quoted) {
  Reader reader(known, quoted);
  reader.read(sheet.description);
  bool is_looked_at = true;
  for (const drawings::Block& block : sheet.column) {
    if (const auto* heading = std::get_if<drawings::Heading>(&block))
      is_looked_at = is_of_the_solution(heading->text);
    if (!is_looked_at) continue;
    if (const auto* paragraph = std::get_if<drawings::Paragraph>(&block)) reader.read(paragraph->text);
    if (const auto* steps = std::get_if<drawings::Steps>(&block))
      for (const std::string& line : steps->lines) reader.read(line);
    const auto* table = std::get_if<drawings::Table>(&block);
    if (table && table->head.back() != "Δ %") reader.read(*table);
  }
  return std::move(reader).wrong();
}

bool is_rounding_of(const std::string& cell, double value) {
  const auto told = numbers_in(cell, Numbers::all);
  return told.size() == 1 && rounds(told.front(), value);
}

}  // namespace epure
