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
  int right = 0, explained = 0;
  for (const CheckedQuantity& quantity : result.quantities)
    for (const PrintedVerdict& verdict : quantity.printed) {
      CAPTURE(quantity.spec.name, verdict.text);
      CHECK(verdict.explanation_holds);
      CHECK((verdict.verdict == Verdict::rounding || verdict.explanation));
      verdict.verdict == Verdict::rounding ? ++right : ++explained;
    }
  CHECK(right == 76);
  CHECK(explained == 116);
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
  const auto absent = [](const Assignments& assignments, const char* name, const char* because) {
    const CheckedExercise result = body().checked(assignments);
    CAPTURE(assignments, name, find(result, name).settled.reason.english);
    CHECK(result.passed());
    CHECK(find(result, name).settled.kind == geometry::Settled::Kind::absent);
    CHECK(find(result, name).settled.reason.english.find(because) != std::string::npos);
  };
  absent({"t_1=0.05"}, "v_bezout_1", "dt does not divide it");
  absent({"dt=0.8"}, "table.v_simpson_at_7", "dt does not divide it");
  absent({"t_2=6", "t_3=8"}, "table.s_at_9", "the table ends before");
  absent({"A=0.1", "B=1", "C=5"}, "v_max", "does not pass from positive to negative");
  absent({"A=0.1", "B=1", "C=5"}, "t_F_max", "none inside");
  absent({"A=0", "B=0", "C=0"}, "err_v_bezout_1", "no relative error");
  absent({"A=0", "B=0", "C=0"}, "t_centroid_1", "areas cancel");
  absent({"t_3=15"}, "F_min", "none inside");
}

TEST_CASE("point mass: givens that cannot be, each in one sentence", "[point-mass]") {
  const auto refused = [](const Assignments& assignments, const char* because) {
    CAPTURE(assignments, because);
    CHECK_THROWS_WITH(body().checked(assignments), Contains(because));
  };
  refused({"m=-50"}, "must be positive");
  refused({"m=0"}, "must be positive");
  refused({"dt=0.3"}, "dt = 0.3 s does not divide the interval");
  refused({"dt=0.00002"}, "a table of 1000000 rows");
  refused({"dt=20"}, "at most half of t_3");
  refused({"t_1=14"}, "t_1 = 14 s must be before t_2 = 14 s");
  refused({"t_3=13"}, "t_2 = 14 s must be before t_3 = 13 s");
  refused({"strip=0.05"}, "at most 200 are drawn");
  refused({"A=3N"}, "force per time cubed");
  CHECK(body().checked({"A=0.00032kN/s³", "B=-0.0104 kN/s^2"}).passed());
}
