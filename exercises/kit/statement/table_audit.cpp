#include "exercises/kit/statement/table_audit.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <sstream>

#include "exercises/kit/statement/decimal.h"

namespace epure {
namespace {

using geometry::Rational;

// How far a printed number is from one it may stand for: not at all, by a unit of its last digit, or more.
enum class Fit { good, rounded, none };
Fit fit(const Decimal& printed, const Rational& value) {
  const Rational apart = CGAL::abs(printed.value - value);
  if (apart <= printed.half_unit) return Fit::good;
  return apart <= 2 * printed.half_unit ? Fit::rounded : Fit::none;
}

// What a row may be, and what believing it costs. A mistake explains a block, so that beginning one is dear; rounding
// on the way is cheaper than that, and a row that nothing explains dearer.
struct Explanation {
  RowVerdict verdict;
  Words mistake;
  std::vector<Rational> values;  // none: nothing fits it, and everything does
};
constexpr int new_block = 100, of_rounded = 30, of_unexplained = 90, impossible = std::numeric_limits<int>::max() / 4;
constexpr int of_mistake = 1;  // for each place in the order of the mistakes

std::vector<Explanation> explanations(const PrintedColumn& column) {
  std::vector<Explanation> all{{RowVerdict::right, {}, column.right}};
  for (const PrintedColumn::Mistake& mistake : column.mistakes)
    all.push_back({RowVerdict::wrong, mistake.sentence, mistake.values});
  const auto shifted = [&](long by) {
    std::vector<Rational> values(column.right.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const long from = std::clamp(static_cast<long>(i) + by, 0L, static_cast<long>(values.size()) - 1);
      values[i] = column.right[static_cast<std::size_t>(from)];
    }
    return values;
  };
  all.push_back(
      {RowVerdict::shifted, {"each stands a row too high", "ognuno sta una riga troppo in alto"}, shifted(1)});
  all.push_back(
      {RowVerdict::shifted, {"each stands a row too low", "ognuno sta una riga troppo in basso"}, shifted(-1)});
  all.push_back({RowVerdict::wrong, {}, {}});
  return all;
}

struct Row {
  bool is_printed;
  Decimal number;
};

Fit fit(const Row& row, const Explanation& explanation, std::size_t i) {
  if (!row.is_printed) return Fit::good;
  return i < explanation.values.size() ? fit(row.number, explanation.values[i]) : Fit::none;
}

int cost(const Row& row, const Explanation& explanation, std::size_t place, std::size_t i) {
  if (explanation.values.empty()) return of_unexplained;
  switch (fit(row, explanation, i)) {
    case Fit::good:
      return of_mistake * static_cast<int>(place);
    case Fit::rounded:
      return of_rounded + of_mistake * static_cast<int>(place);
    case Fit::none:
      break;
  }
  return impossible;
}

// The cheapest sequence of explanations (Viterbi's).
std::vector<std::size_t> cheapest(const std::vector<Row>& rows, const std::vector<Explanation>& all) {
  std::vector<std::vector<std::size_t>> before(rows.size(), std::vector<std::size_t>(all.size()));
  std::vector<int> so_far(all.size(), 0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t best =
        static_cast<std::size_t>(std::min_element(so_far.begin(), so_far.end()) - so_far.begin());
    std::vector<int> next(all.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
      const bool stays = i > 0 && so_far[k] <= so_far[best] + new_block;
      before[i][k] = stays ? k : best;
      const int earlier = stays ? so_far[k] : so_far[best] + new_block;
      next[k] = std::min(impossible, earlier + cost(rows[i], all[k], k, i));
    }
    so_far = next;
  }
  std::vector<std::size_t> chosen(rows.size());
  std::size_t k = static_cast<std::size_t>(std::min_element(so_far.begin(), so_far.end()) - so_far.begin());
  for (std::size_t i = rows.size(); i-- > 0;) {
    chosen[i] = k;
    k = before[i][k];
  }
  return chosen;
}

RowVerdict verdict_alone(const Row& row, const std::vector<Explanation>& all, std::size_t i) {
  const Fit own = fit(row, all.front(), i);
  if (own == Fit::good) return RowVerdict::right;
  for (const Explanation& each : all)
    if (each.verdict == RowVerdict::shifted && fit(row, each, i) == Fit::good) return RowVerdict::shifted;
  return own == Fit::rounded ? RowVerdict::rounded : RowVerdict::wrong;
}

}  // namespace

std::string name(RowVerdict verdict) {
  switch (verdict) {
    case RowVerdict::right:
      return "right";
    case RowVerdict::rounded:
      return "rounded";
    case RowVerdict::shifted:
      return "shifted";
    case RowVerdict::wrong:
      break;
  }
  return "wrong";
}

AuditedColumn audit(const PrintedColumn& column) {
  assert(column.printed.size() == column.right.size());
  const std::vector<Explanation> all = explanations(column);
  std::vector<Row> rows;
  for (const std::string& text : column.printed)
    rows.push_back({!text.empty(), text.empty() ? Decimal{} : read_decimal(text, "1")});
  AuditedColumn result{column.name, {}, {}};
  for (std::size_t i = 0; i < rows.size(); ++i) result.rows.push_back(verdict_alone(rows[i], all, i));
  const std::vector<std::size_t> chosen = cheapest(rows, all);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Explanation& why = all[chosen[i]];
    if (i == 0 || chosen[i] != chosen[i - 1]) result.blocks.push_back({i, i, why.verdict, why.mistake});
    AuditedBlock& block = result.blocks.back();
    block.last = i;
    if (fit(rows[i], why, i) == Fit::rounded) ++block.rounded;
    if (result.rows[i] == RowVerdict::right) ++block.right;
  }
  return result;
}

TableAudit audit(const Words& table, const std::vector<std::string>& rows,
                 const std::vector<PrintedColumn>& columns) {
  TableAudit result{table, rows, {}};
  for (const PrintedColumn& column : columns) {
    assert(column.printed.size() == rows.size());
    result.columns.push_back(audit(column));
  }
  return result;
}

std::vector<std::vector<std::string>> read_printed_table(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::vector<std::string> row;
    for (std::string word; words >> word;) row.push_back(word);
    if (!row.empty()) rows.push_back(row);
  }
  return rows;
}

std::vector<std::string> column_of(const std::vector<std::vector<std::string>>& table, std::size_t column) {
  std::vector<std::string> all;
  for (const auto& row : table) all.push_back(row.at(column));
  return all;
}

}  // namespace epure
