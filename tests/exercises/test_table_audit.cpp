// Printed tables held against their schemes: rows that are right, rounded, shifted and wrong, and the mistakes that
// explain blocks of them.
#include "exercises/kit/statement/table_audit.h"

#include <nlohmann/json.hpp>

#include "exercises/cli/check_report.h"
#include "tests/support/catch.h"

using namespace epure;
using geometry::Rational;

namespace {

// i²/8 from 0 to 9: 0.125 and 1.125 lie between two numbers of two decimals.
std::vector<Rational> eighths() {
  std::vector<Rational> all;
  for (int i = 0; i < 10; ++i) all.push_back(Rational(i * i, 8));
  return all;
}
const std::vector<std::string> right{"0,00", "0,12", "0,50", "1,13", "2,00", "3,13", "4,50", "6,12", "8,00", "10,13"};

std::vector<std::string> with(std::vector<std::string> texts, std::size_t row, const std::string& text) {
  texts.at(row) = text;
  return texts;
}

}  // namespace

TEST_CASE("audit: a right table is one block, whichever way ties were rounded", "[audit]") {
  const AuditedColumn found = audit(PrintedColumn{.name = "y", .printed = right, .right = eighths()});
  REQUIRE(found.blocks.size() == 1);
  CHECK(found.blocks[0].verdict == RowVerdict::right);
  CHECK(found.blocks[0].last == 9);
  CHECK(found.blocks[0].right == 10);
  CHECK(found.blocks[0].rounded == 0);
}

TEST_CASE("audit: a row off by one in its last digit is rounded, by two wrong", "[audit]") {
  const AuditedColumn rounded =
      audit(PrintedColumn{.name = "y", .printed = with(right, 4, "2,01"), .right = eighths()});
  REQUIRE(rounded.blocks.size() == 1);
  CHECK(rounded.blocks[0].rounded == 1);
  CHECK(rounded.rows[4] == RowVerdict::rounded);
  const AuditedColumn wrong =
      audit(PrintedColumn{.name = "y", .printed = with(right, 4, "2,02"), .right = eighths()});
  REQUIRE(wrong.blocks.size() == 3);
  CHECK(wrong.blocks[1].verdict == RowVerdict::wrong);
  CHECK(wrong.blocks[1].mistake.empty());
  CHECK(wrong.blocks[1].first == 4);
  CHECK(wrong.blocks[1].last == 4);
}

TEST_CASE("audit: rows that stand too high or too low", "[audit]") {
  std::vector<std::string> shifted(right.begin() + 1, right.end());
  shifted.push_back("10,13");
  const AuditedColumn high = audit(PrintedColumn{.name = "y", .printed = shifted, .right = eighths()});
  REQUIRE(high.blocks.size() == 1);
  CHECK(high.blocks[0].verdict == RowVerdict::shifted);
  CHECK(high.blocks[0].mistake.english.find("too high") != std::string::npos);
  CHECK(high.blocks[0].right == 1);
  shifted = right;
  for (std::size_t i = 9; i > 3; --i) shifted[i] = right[i - 1];
  const AuditedColumn low = audit(PrintedColumn{.name = "y", .printed = shifted, .right = eighths()});
  REQUIRE(low.blocks.size() == 2);
  CHECK(low.blocks[0].verdict == RowVerdict::right);
  CHECK(low.blocks[1].mistake.english.find("too low") != std::string::npos);
  CHECK(low.blocks[1].first <= 4);
  CHECK(low.rows[9] == RowVerdict::shifted);
}

TEST_CASE("audit: the simplest mistake that explains a block, with what is right in it by chance", "[audit]") {
  std::vector<Rational> doubled = eighths(), other = eighths();
  for (Rational& value : doubled) value *= 2;
  other = doubled;
  other[0] = 7;
  PrintedColumn column{.name = "y", .printed = right, .right = eighths()};
  column.printed = {"0,00", "0,25", "1,00", "2,25", "4,00", "6,25", "4,50", "6,12", "8,00", "10,13"};
  column.mistakes = {{{"odd", "strano"}, other}, {{"twice", "doppio"}, doubled}};
  const AuditedColumn found = audit(column);
  REQUIRE(found.blocks.size() == 2);
  CHECK(found.blocks[0].mistake.english == "twice");
  CHECK(found.blocks[0].last == 5);
  CHECK(found.blocks[0].right == 1);
  CHECK(found.blocks[1].verdict == RowVerdict::right);
  column.mistakes = {{{"odd", "strano"}, other}};
  CHECK(audit(column).blocks[0].verdict == RowVerdict::right);  // the first row
  CHECK(audit(column).blocks[1].mistake.english == "odd");
  column.mistakes = {{{"short", "corto"}, {0, Rational(1, 4)}}};  // says nothing of later rows
  CHECK(audit(column).blocks.size() >= 2);
}

TEST_CASE("audit: rows without a number, negative ones, and the table's text", "[audit]") {
  const auto table = read_printed_table("\n0,0 -0,13\t1\n\n0,1 0,25 2\n");
  REQUIRE(table.size() == 2);
  CHECK(column_of(table, 1) == std::vector<std::string>{"-0,13", "0,25"});
  const PrintedColumn column{
      .name = "y", .printed = {"-0,13", "", "0,13"}, .right = {Rational(-1, 8), 100, Rational(-1, 8)}};
  const AuditedColumn found = audit(column);
  CHECK(found.rows == std::vector<RowVerdict>{RowVerdict::right, RowVerdict::right, RowVerdict::wrong});
}

TEST_CASE("audit: check tells blocks of rows, in both languages and as JSON", "[audit]") {
  Description about;
  about.id = "some";
  CheckedExercise checked{.about = about, .givens = Givens({}), .quantities = {}};
  PrintedColumn column{.name = "y", .printed = with(right, 9, "1"), .right = eighths()};
  column.mistakes = {{{"a slip", "un lapsus"}, {7, 7, 7, 7, 7, 7, 7, 7, 7, 1}}};
  PrintedColumn same = column;
  same.name = "z";
  const std::vector<std::string> rows{"0,0", "0,1", "0,2", "0,3", "0,4", "0,5", "0,6", "0,7", "0,8", "0,9"};
  checked.audits = {audit({"table", "tabella"}, rows, {column, same})};
  const std::string english = text_report(checked, {}), italian = text_report(checked, {Language::italian});
  CHECK(english.find("Printed table, row by row:") != std::string::npos);
  CHECK(english.find("y, z: 0,0 to 0,8 (9 rows) right; 0,9 wrong: a slip") != std::string::npos);
  CHECK(italian.find("y, z: da 0,0 a 0,8 (9 righe) giuste; 0,9 sbagliate: un lapsus") != std::string::npos);
  const auto told = nlohmann::json::parse(json_report({checked}))["exercises"][0]["audit"][0];
  CHECK(told["rows"] == 10);
  CHECK(told["columns"][1]["name"] == "z");
  CHECK(told["columns"][0]["blocks"][1]["verdict"] == "wrong");
  CHECK(told["columns"][0]["blocks"][1]["mistake"] == "a slip");
  CHECK(told["columns"][0]["blocks"][0]["last"] == "0,8");
}
