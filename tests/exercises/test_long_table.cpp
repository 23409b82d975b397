// Long tables: as CSV, on the pages of a sheet, and asked for on the command line.
#include "exercises/kit/panels/long_table_panel.h"

#include <cmath>

#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/proof/checked.h"
#include "exercises/kit/proof/table_cells.h"
#include "exercises/kit/proof/told_numbers.h"
#include "tests/exercises/run.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

LongTable table_of_rows(std::size_t rows) {
  LongTable table;
  table.columns = {{"t", "$t$", "s", 1, {}}, {"x, or \"y\"", "$x$", "1", 3, {}}, {"v_B", "$v_{B}$", "m/s^2", 2, {}}};
  for (std::size_t i = 0; i < rows; ++i) {
    table.columns[0].values.push_back(static_cast<double>(i) / 10);
    table.columns[1].values.push_back(1.0 / 3 * static_cast<double>(i));
    table.columns[2].values.push_back(i % 2 == 0 ? -1e-30 : 12345678.9);
  }
  return table;
}

std::unique_ptr<Exercise> exercise_with(std::size_t rows) {
  Description about;
  about.id = "some";
  about.title = {"Some", "Uno"};
  const auto solve = [](const Givens&, Rung) { return std::vector<RouteValue>{}; };
  const auto make = [](const Solution&, Language) { return PanelSheet{.seen = {"numbers", "numeri"}}; };
  return exercise_of_panels(
      about, solve,
      {{{"table", {"A table", "Una tabella"}}, make, [rows](const Solution&) { return table_of_rows(rows); }},
       {{"other", {"No table", "Nessuna"}}, make}});
}

std::vector<std::string> written_on(const drawings::Sheet& sheet) {
  std::vector<std::string> all;
  for (const drawings::Mark& mark : sheet.figure.marks)
    if (const auto* writing = std::get_if<drawings::Writing>(&mark)) all.push_back(writing->text);
  return all;
}

bool holds(const std::vector<std::string>& all, const std::string& text) {
  return std::find(all.begin(), all.end(), text) != all.end();
}

Triangle with_table() {
  Triangle triangle;
  triangle.table_of_it = table_of_rows(3);
  return triangle;
}

void is_refused(const std::vector<std::string>& words, const std::string& part) {
  const Ran ran = run_on(with_table(), words);
  CAPTURE(words, ran.err);
  CHECK(ran.exit == 2);
  CHECK(ran.err.find(part) != std::string::npos);
}

}  // namespace

TEST_CASE("CSV: a header, records that end in CR LF, quotes where a field needs them", "[long table]") {
  CHECK(csv(table_of_rows(2)) ==
        "t (s),\"x, or \"\"y\"\"\",v_B (m/s^2)\r\n0,0,-1e-30\r\n0.1,0.3333333333333333,12345678.9\r\n");
  LongTable zero;
  zero.columns = {{"x", "$x$", "1", 2, {-0.0}}};
  CHECK(csv(zero) == "x\r\n0\r\n");
}

TEST_CASE("a long table takes as many pages as it needs, and every row stands on one of them", "[long table]") {
  for (const drawings::Paper paper : {drawings::Paper::a4, drawings::Paper::a3}) {
    const std::size_t rows = rows_of_a_page(paper, 3);
    CHECK(rows > 30);
    for (const auto& [count, pages] :
         std::vector<std::pair<std::size_t, std::size_t>>{{1, 1}, {rows, 1}, {rows + 1, 2}, {5 * rows, 5}}) {
      const auto exercise = exercise_with(count);
      const DrawnSheet drawn = exercise->draw("table", Givens({}), {.paper = paper});
      CAPTURE(count, pages);
      REQUIRE(drawn.further.size() + 1 == pages);
      std::vector<std::string> all = written_on(drawn.sheet);
      for (const drawings::Sheet& further : drawn.further) {
        const std::vector<std::string> more = written_on(further);
        CHECK(holds(more, "$v_{B}$"));
        CHECK(holds(more, "(m/s²)"));
        all.insert(all.end(), more.begin(), more.end());
      }
      CHECK(all.size() == 6 * pages + 3 * count);  // letters and units, also the empty one of a number
      CHECK(holds(all, fmt::format("{:.1f}", static_cast<double>(count - 1) / 10)));
    }
  }
  const DrawnSheet drawn = exercise_with(100)->draw("table", Givens({}), {.language = Language::italian});
  CHECK(drawn.sheet.title_block.sheet == "Una tabella (1/3)");
  CHECK(drawn.further[1].title_block.sheet == "Una tabella (3/3)");
  CHECK(drawn.further[1].id == "some-table-3");
  CHECK(holds(written_on(drawn.sheet), "0,333"));
  CHECK_FALSE(holds(written_on(drawn.sheet), "0.333"));
}

TEST_CASE("a page has no more cells than an SVG of 100 kB holds", "[long table]") {
  CHECK(rows_of_a_page(drawings::Paper::a4, 15) == 26);
  CHECK(rows_of_a_page(drawings::Paper::a3, 15) == 26);
  CHECK(rows_of_a_page(drawings::Paper::a4, 0) == rows_of_a_page(drawings::Paper::a4, 1));
}

// Ties, of which the doubles lie beside; and what is a hundredth of the last digit off.
TEST_CASE("a cell is the rounding of a value to either side where it is half way, and of none beyond",
          "[long table]") {
  CHECK(is_rounding_of("34535.812", 34535.8125));
  CHECK(is_rounding_of("34535.813", 34535.8125));
  CHECK(is_rounding_of("$3.022·10^{−7}$", 3.0225e-7));
  CHECK(is_rounding_of("−3.023e-07", -3.0225e-7));
  CHECK_FALSE(is_rounding_of("34535.812", 34535.81251));
  CHECK_FALSE(is_rounding_of("$3.022·10^{−7}$", 3.02251e-7));
  CHECK_FALSE(is_rounding_of("$3.023·10^{−7}$", 3.02249e-7));
  CHECK_FALSE(is_rounding_of("3.022", -3.022));
}

TEST_CASE("every cell of a long table is held against another route, on every page", "[long table]") {
  LongTable table = table_of_rows(100);
  table.by_another_route = [columns = table.columns] {
    std::vector<std::vector<double>> values;
    for (const LongTable::Column& column : columns) values.push_back(column.values);
    return values;
  };
  const auto wrong = [&table](const auto& spoil) {
    DrawnSheet drawn = exercise_with(100)->draw("table", Givens({}), {});
    spoil(drawn);
    const auto found = wrong_table("table", drawn, table);
    return found ? found->english : "";
  };
  // The cell of a page, counted with the heads.
  const auto cell = [](drawings::Sheet& page, std::size_t row, std::size_t column) -> std::string& {
    std::size_t i = 0;
    for (drawings::Mark& mark : page.figure.marks)
      if (auto* writing = std::get_if<drawings::Writing>(&mark); writing && writing->row == row && i++ == column)
        return writing->text;
    throw std::logic_error("no such cell");
  };
  const auto nothing = [](DrawnSheet&) {};
  CHECK(wrong(nothing).empty());
  // One unit of the last digit, on the last page; a lost sign; a power of ten.
  CHECK(wrong([&](DrawnSheet& drawn) {
          std::string& text = cell(drawn.further[1], 19, 1);
          CHECK(text == "33.000");
          text = "33.001";
        }) == "sheet table: in row 100 of its table x, or \"y\" is 33.001 (in full 33), but 33 by another route");
  CHECK_FALSE(wrong([&](DrawnSheet& drawn) { cell(drawn.sheet, 2, 2).erase(1, std::string("−").size()); }).empty());
  CHECK_FALSE(wrong([&](DrawnSheet& drawn) {
                std::string& text = cell(drawn.further[0], 2, 2);
                text.replace(text.find('7'), 1, "6");
              }).empty());
  CHECK_FALSE(wrong([&](DrawnSheet& drawn) { cell(drawn.sheet, 2, 0).clear(); }).empty());
  CHECK(wrong([](DrawnSheet& drawn) { drawn.further.pop_back(); }) ==
        "sheet table: its pages show 82 of the 100 rows of its table");
  // What a spreadsheet reads, beyond the digits on paper.
  double& value = table.columns[1].values[7];
  value = std::nextafter(value, 3);
  CHECK(wrong(nothing).empty());
  value = std::nextafter(value, 3);
  CHECK_FALSE(wrong(nothing).empty());
}

TEST_CASE("check fails where a cell of a long table is not what another route finds", "[long table]") {
  for (const double off : {0.0, 0.01}) {
    Description about;
    about.id = "some";
    about.title = {"Some", "Uno"};
    const auto exercise = exercise_of_panels(about, [](const Givens&, Rung) { return std::vector<RouteValue>{}; },
                                             {{{"table", {"A table", "Una tabella"}},
                                               [](const Solution&, Language) {
                                                 return PanelSheet{.seen = {"numbers", "numeri"}};
                                               },
                                               [off](const Solution&) {
                                                 LongTable table;
                                                 table.columns = {{"x", "$x$", "m", 2, {1.25, -2.5}}};
                                                 table.by_another_route = [off] {
                                                   return std::vector<std::vector<double>>{{1.25, -2.5 + off}};
                                                 };
                                                 return table;
                                               }}});
    const CheckedExercise checked = check(*exercise, Givens({}), Rung::climb);
    CHECK(checked.passed() == (off == 0));
    if (off != 0)
      CHECK(complaints(checked) ==
            std::vector<std::string>{
                "sheet table: in row 2 of its table x is −2.50 (in full -2.5), but -2.49 by another route"});
  }
}

TEST_CASE("a column whose decimals do not suit its numbers has them by their figures", "[long table]") {
  const std::vector<std::string> all = written_on(exercise_with(2)->draw("table", Givens({}), {}).sheet);
  CHECK(
      std::any_of(all.begin(), all.end(), [](const std::string& text) { return text.starts_with("$−1.000·10^{"); }));
  CHECK(holds(all, "$1.235·10^{7}$"));
}

TEST_CASE("a table that is too wide is told", "[long table]") {
  LongTable wide;
  for (int i = 0; i < 60; ++i) wide.columns.push_back({"x", "$x$", "1", 3, {1000.0 / 3}});
  CHECK_THROWS_AS(LongTablePanel(wide, 0, {}), DoesNotFit);
}

TEST_CASE("draw --format csv writes the long table of a sheet", "[long table]") {
  const Scratch scratch;
  const Ran folder = run_on(with_table(), {"draw", "triangle", "--format", "csv"});
  CHECK(folder.exit == 0);
  CHECK(folder.out == "out/triangle-sides.csv\n");
  CHECK(scratch.files() == std::vector<std::string>{"out/triangle-sides.csv"});
  CHECK(contents("out/triangle-sides.csv") == csv(table_of_rows(3)));
  CHECK(run_on(with_table(), {"draw", "triangle/sides", "--format", "csv", "-o", "-"}).out == csv(table_of_rows(3)));
  CHECK(run_on(with_table(), {"draw", "triangle", "-o", "some.csv"}).exit == 0);
  CHECK(contents("some.csv") == csv(table_of_rows(3)));
  const Ran all = run_on(with_table(), {"draw", "triangle", "--format", "pdf,csv", "--out", "both"});
  CHECK(all.out == "both/triangle.pdf\nboth/triangle-sides.csv\n");
}

TEST_CASE("a sheet without a long table has no CSV, and says so", "[long table]") {
  const Scratch scratch;
  is_refused({"draw", "triangle/small", "--format", "csv"},
             "triangle/small holds no long table that --format csv could write");
  is_refused({"draw", "triangle/small", "--format", "csv,pdf"}, "holds no long table");
  is_refused({"draw", "triangle", "--format", "csv", "-o", "some.pdf"}, "is not the ending of --format csv");
  const Ran none = run({"draw", "triangle", "--format", "csv"});
  CHECK(none.exit == 2);
  CHECK(none.err == "epure: no sheet of triangle holds a long table that --format csv could write\n");
  CHECK(scratch.files().empty());
}
