// The Michell bearing: its numbers are those of a corpus of integrals over ln h; the source's numbers; bad givens.
#include "tests/exercises/michell-bearing/cases.h"

using namespace epure;
using namespace epure::tests;

TEST_CASE("michell bearing: values are the corpus', to the last bit of a double, by every route",
          "[michell-bearing]") {
  const std::vector<CorpusCase> corpus = read_corpus(EPURE_CORPUS "/michell_bearing.txt");
  CHECK(corpus.size() == 8);
  holds_against(bearing(), corpus);
}

TEST_CASE("michell bearing: what the source printed, and why it is wrong where it is", "[michell-bearing]") {
  const CheckedExercise result = bearing().checked({});
  CHECK(result.passed());
  const Judged prints = judged(result);
  CHECK(prints.rounding == 29);
  CHECK(prints.explained == 38);
  CHECK(prints.unexplained == 0);
  CHECK_THAT(find(result, "direct.l").printed.front().explanation.value().english, Contains("a misprint only"));
}

TEST_CASE("michell bearing: what is not there", "[michell-bearing]") {
  is_absent(bearing(), {"l=0.3", "x_3=0.25"}, "inverse.p_at_0p35", "ends before");
  is_absent(bearing(), {"dx=0.02"}, "inverse.p_bezout_at_0p15", "no point of the grid");
  is_absent(bearing(), {"h_1=0.32", "x_1=0.4"}, "inverse.u_at_x_1_z_0p20mm", "thinner");
  is_absent(bearing(), {"h_1=0.3199999999999999999999999999999999"}, "inverse.x_shear_zero_fixed", "nowhere");
}

TEST_CASE("michell bearing: givens that cannot be, each in one sentence", "[michell-bearing]") {
  is_refused(bearing(), {"h_1=0.16"}, "carries no load");
  is_refused(bearing(), {"h_2=0.5"}, "n = h_1/h_2 = 0.8");
  is_refused(bearing(), {"dx=0.03"}, "whole number of strips");
  is_refused(bearing(), {"x_1=0.41"}, "the film ends there");
  is_refused(bearing(), {"mu=0"}, "must be positive");
  is_refused(bearing(), {"x_N=0.03675"}, "more than 0.5");
  is_refused(bearing(), {"x_N=0.0733"}, "at most 0.95");
  is_refused(bearing(), {"pads=9"},
             "overlap on the mean circle of r_m = 0.1 m: together they are 0.6615 m long, and the circle only "
             "0.628319 m");
  is_refused(bearing(), {"l_pad=0.07854"}, "together they are 0.62832 m long, and the circle only 0.628319 m");
  is_refused(bearing(), {"l_pad=0.078539817"},
             "together they are 0.628318536 m long, and the circle only 0.62831853 m");
  is_refused(bearing(), {"pads=2.5"}, "whole number");
  is_refused(bearing(), {"b=0.2"}, "inner radius");
  CHECK(bearing().checked({"x_N=0.03675000000001"}).passed());
}

TEST_CASE("michell bearing: both tables of the source, row by row", "[michell-bearing]") {
  const CheckedExercise result = bearing().checked({});
  REQUIRE(result.audits.size() == 2);
  CHECK(result.audits[0].rows.size() == 41);
  CHECK(result.audits[1].rows.size() == 32);
  const auto is_one_block = [](const AuditedColumn& column, RowVerdict verdict) {
    CAPTURE(column.name);
    REQUIRE(column.blocks.size() == 1);
    CHECK(column.blocks.front().verdict == verdict);
    CHECK(column.blocks.front().rounded == 0);
    CHECK(column.blocks.front().mistake.empty() == (verdict == RowVerdict::right));
  };
  REQUIRE(result.audits[0].columns.size() == 3);
  is_one_block(result.audits[0].columns[0], RowVerdict::right);
  is_one_block(result.audits[0].columns[1], RowVerdict::wrong);
  is_one_block(result.audits[0].columns[2], RowVerdict::wrong);
  REQUIRE(result.audits[1].columns.size() == 3);
  for (const AuditedColumn& column : result.audits[1].columns) is_one_block(column, RowVerdict::wrong);
  CHECK(bearing().checked({"dx=0.02"}).audits.empty());
}
