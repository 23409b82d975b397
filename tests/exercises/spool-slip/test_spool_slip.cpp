// The spool drawn by a counterweight: every route holds against a corpus that tries all regimes; limits hit, and
// missed by 1e-9 and 1e-30; what is refused; and what a ruler reads off the sheets.
#include "exercises/cli/check_words.h"
#include "tests/exercises/held_against_corpus.h"

using namespace epure;
using namespace epure::tests;

namespace {

const Tried& spool() {
  static const Tried tried("spool-slip");
  return tried;
}

const std::vector<CorpusCase>& corpus() {
  static const std::vector<CorpusCase> cases = read_corpus(EPURE_CORPUS "/spool.txt");
  return cases;
}

std::string refusal(const Assignments& assignments) {
  try {
    spool().checked(assignments);
  } catch (const BadGivens& refused) {
    return refused.what();
  }
  return {};
}

}  // namespace

TEST_CASE("its values are the corpus', to the last bit of a double, by every route", "[spool-slip]") {
  CHECK(corpus().size() == 18);
  holds_against(spool(), corpus());
  CHECK(spool().checked({}).quantities.size() == 56);
}

TEST_CASE("at the limits it still holds, and beyond them by however little it does not", "[spool-slip]") {
  const auto verdict = [](const std::string& m_b, const char* name) {
    return value(spool().checked({"m_b=" + m_b}), name);
  };
  const Rational slip(4960, 101), start(2, 5);
  Rational tiny(1);
  for (int i = 0; i < 40; ++i) tiny = tiny / 10;
  CHECK(verdict(geometry::to_text(slip), "slips") == 0);
  CHECK(verdict(geometry::to_text(slip), "slip_margin") == 0);
  CHECK(verdict(geometry::to_text(slip + tiny), "slips") == 1);
  CHECK(verdict(geometry::to_text(slip + tiny), "slip_margin") < 0);
  CHECK(verdict(geometry::to_text(start), "starts") == 0);
  CHECK(verdict(geometry::to_text(start), "a") == 0);
  CHECK(verdict(geometry::to_text(start + tiny), "starts") == 1);
  CHECK(verdict(geometry::to_text(start + tiny), "a") > 0);
}

TEST_CASE("what slips is told from what would roll, and a limit that is not there says why", "[spool-slip]") {
  const CheckedExercise stated = spool().checked({});
  CHECK(value(stated, "heavy_if_rolling.slips") == 1);
  CHECK(value(stated, "heavy.F") < value(stated, "heavy_if_rolling.F"));
  CHECK(value(stated, "light.u_required") < value(stated, "u"));
  const auto reason = [](const Assignments& given) {
    return find(spool().checked(given), "mass_ratio_slip").settled.reason.english;
  };
  CHECK(reason({"f_a=4"}).find("however heavy") != std::string::npos);
  CHECK(reason({"f_v=3"}).find("before it can roll") != std::string::npos);
}

TEST_CASE("what must hold is told apart from what does", "[spool-slip]") {
  for (const char* m_b : {"m_b=30", "m_b=100"}) {
    const CheckedExercise result = spool().checked({m_b});
    const double needed = value(result, "F_required");
    CAPTURE(m_b, needed);
    CHECK(value(result, "F_over_N") == Approx(needed / value(result, "N")));
    CHECK(value(result, "slip_margin") == Approx(value(result, "F_max") - needed));
    CHECK((value(result, "F") < needed) == (value(result, "slips") == 1));
    CHECK(find(result, "F_over_N").spec.symbol == find(result, "F_required").spec.symbol + "/$\\it{N}$");
  }
}

TEST_CASE("a value halfway between two of six digits is shown by a seventh", "[spool-slip]") {
  CHECK(number_in_words(find(spool().checked({}), "heavy_if_rolling.a")).english == "3.654225");
  CHECK(percent(-99.9).english == "-99.9 %");
  CHECK(percent(-99.4).english == "-99 %");
  CHECK(percent(-100.2).english == "-100 %");
}

TEST_CASE("no friction cone runs into the polygon beside it", "[spool-slip][sheets]") {
  for (const Assignments& given : {Assignments{}, {"m_b_light=0.1"}, {"m_b=0.1"}, {"m_b_heavy=20"}}) {
    const DrawnSheet drawn = spool().draw("friction-cone", given);
    // The cone's legs come before its polygon.
    std::vector<drawings::Box> covered;
    int legs = 0;
    const auto include = [&](drawings::Point p) {
      auto& [low, high] = covered.back();
      low = {std::min(low.x, p.x), std::min(low.y, p.y)}, high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    };
    for (const drawings::Mark& mark : drawn.sheet.figure.marks) {
      if (const auto* line = std::get_if<drawings::Line>(&mark);
          line && line->meaning == drawings::Meaning::alternative) {
        if (++legs % 2 == 1) covered.push_back({line->path.start, line->path.start});
        include(line->path.start), include(line->path.pieces.back().end);
      }
      if (const auto* arrow = std::get_if<drawings::Arrow>(&mark); arrow && !covered.empty())
        include(arrow->from), include(arrow->to);
    }
    CHECK(covered.size() == 4);
    for (std::size_t i = 0; i < covered.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        CAPTURE(given, i, j);
        const bool apart = covered[i].low.x > covered[j].high.x || covered[j].low.x > covered[i].high.x ||
                           covered[i].low.y > covered[j].high.y || covered[j].low.y > covered[i].high.y;
        CHECK(apart);
      }
  }
}

TEST_CASE("a spool that cannot be is refused with the value and the condition", "[spool-slip]") {
  CHECK(refusal({"r=0.5"}).find("r = 0.5 m must be less than R = 0.5 m") != std::string::npos);
  CHECK(refusal({"r=0.7"}).find("r = 0.7 m") != std::string::npos);
  CHECK(refusal({"f_r=1.2"}).find("f_r = 1.2 is more than f_a = 1") != std::string::npos);
  for (const char* wrong : {"m_a=0", "m_a=-20", "m_b=-1", "m_b_heavy=-60", "R=0", "r=-0.1", "f_v=-0.01", "g=0"}) {
    CAPTURE(wrong);
    CHECK_FALSE(refusal({wrong}).empty());
  }
  for (const Assignments& possible :
       {Assignments{"m_b=0"}, {"f_v=0"}, {"f_r=1"}, {"f_a=0", "f_r=0"}, {"r=0.4999999"}}) {
    CAPTURE(possible);
    CHECK(refusal(possible).empty());
  }
}

TEST_CASE("every sheet is drawn, whatever is given", "[spool-slip][sheets]") { draws_every_sheet(spool(), corpus()); }

TEST_CASE("letters find room on all sheets", "[spool-slip][sheets]") {
  letters_find_room(spool(), {{}, {"m_b=60"}, {"f_a=0.5", "f_r=0.4", "f_v=0.1", "r=0.1", "m_b_light=5"}, {"f_a=3"}});
}
