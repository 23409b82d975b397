// The body under a force that depends on time: its numbers are those of a corpus by Romberg's integrals and
// bisection; the source's numbers and its table; bad givens.
#include "tests/exercises/point-mass/cases.h"

using namespace epure;
using namespace epure::tests;

TEST_CASE("point mass: values are the corpus', to the last bit of a double, by every route", "[point-mass]") {
  const std::vector<CorpusCase> corpus = read_corpus(EPURE_CORPUS "/point_mass.txt");
  CHECK(corpus.size() == 13);
  holds_against(body(), corpus);
}

TEST_CASE("point mass: every printed number is right, or explained by a mistake that gives it", "[point-mass]") {
  const CheckedExercise result = body().checked({});
  CHECK(result.passed());
  const Judged prints = judged(result);
  CHECK(prints.rounding == 76);
  CHECK(prints.explained == 116);
  CHECK(prints.unexplained == 0);
}

TEST_CASE("point mass: the table is right where it is exact, and one mistake explains each other column",
          "[point-mass]") {
  const CheckedExercise result = body().checked({});
  REQUIRE(result.audits.size() == 1);
  const TableAudit& table = result.audits.front();
  CHECK(table.rows.size() == 201);
  CHECK(table.rows.back() == "20,0");
  REQUIRE(table.columns.size() == 14);
  for (std::size_t i = 0; i < 14; ++i) {
    const AuditedColumn& column = table.columns[i];
    CAPTURE(column.name);
    REQUIRE(column.blocks.size() == 1);
    const AuditedBlock& block = column.blocks.front();
    CHECK(block.last == 200);
    CHECK(block.rounded == 0);
    CHECK((block.verdict == RowVerdict::right) == (i < 6));
    CHECK(block.mistake.empty() == (i < 6));
    if (i < 6) CHECK(block.right == 201);
  }
  CHECK(body().checked({"m=51"}).audits.empty());
}

TEST_CASE("point mass: what is not there", "[point-mass]") {
  is_absent(body(), {"t_1=0.05"}, "v_bezout_1", "dt does not divide it");
  is_absent(body(), {"dt=0.8"}, "table.v_simpson_at_7", "dt does not divide it");
  is_absent(body(), {"t_2=6", "t_3=8"}, "table.s_at_9", "the table ends before");
  is_absent(body(), {"A=0.1", "B=1", "C=5"}, "v_max", "does not pass from positive to negative");
  is_absent(body(), {"A=0.1", "B=1", "C=5"}, "t_F_max", "none inside");
  is_absent(body(), {"A=0", "B=0", "C=0"}, "err_v_bezout_1", "no relative error");
  is_absent(body(), {"A=0", "B=0", "C=0"}, "t_centroid_1", "areas cancel");
  is_absent(body(), {"t_3=15"}, "F_min", "none inside");
}

TEST_CASE("point mass: givens that cannot be, each in one sentence", "[point-mass]") {
  is_refused(body(), {"m=-50"}, "must be positive");
  is_refused(body(), {"m=0"}, "must be positive");
  is_refused(body(), {"dt=0.3"}, "dt = 0.3 s does not divide the interval");
  is_refused(body(), {"dt=0.00002"}, "a table of 1000000 rows");
  is_refused(body(), {"dt=20"}, "at most half of t_3");
  is_refused(body(), {"t_1=14"}, "t_1 = 14 s must be before t_2 = 14 s");
  is_refused(body(), {"t_3=13"}, "t_2 = 14 s must be before t_3 = 13 s");
  is_refused(body(), {"strip=0.05"}, "at most 200 are drawn");
  is_refused(body(), {"A=3N"}, "force per time cubed");
  CHECK(body().checked({"A=0.00032kN/s³", "B=-0.0104 kN/s^2"}).passed());
}
