// What check says of the numbers that a sheet tells.
#include "exercises/kit/proof/told_numbers.h"
#include "tests/support/catch.h"

using namespace epure;

namespace {

const std::vector<KnownNumber> known{{"v_B", "$v_{B}$", 5.10278}, {"omega_3", "$ω_{3}$", -13.3286},
                                     {"e", "$ε$", 1.23456e-7},    {"v_A", "$v_{A}$", 7.53982},
                                     {"C_x", "$x_{C}$", 0.25},    {"C_y", "$y_{C}$", -0.7512}};

std::vector<std::string> wrong_in(const drawings::Block& block) {
  drawings::Sheet sheet;
  sheet.column = {block};
  std::vector<std::string> numbers;
  for (const WrongNumber& wrong : wrong_numbers(sheet, known)) numbers.push_back(wrong.number);
  return numbers;
}
std::vector<std::string> wrong_in(const std::string& text) { return wrong_in(drawings::Paragraph{text}); }

using None = std::vector<std::string>;

}  // namespace

TEST_CASE("a sheet tells the rounding of the quantity whose letters stand before it") {
  CHECK(wrong_in("$v_{B}$ = 5.103 m/s,  $ω_{3}$ = −13.33 rad/s") == None{});
  CHECK(wrong_in("$v_{B}$ = 5.10 m/s") == None{});
  CHECK(wrong_in("$v_{B}$ = 5.11 m/s") == None{"5.11"});
  CHECK(wrong_in("$v_{B}$ = 7.540 m/s") == None{"7.540"});        // v_A's
  CHECK(wrong_in("$ω_{3}$ = 13.33 rad/s") == None{"13.33"});      // its sign
  CHECK(wrong_in("|$ω_{3}$| = 13.33 rad/s") == None{});           // its magnitude
  CHECK(wrong_in("$v_{B}$/$v_{A}$ = 0.6768") == None{"0.6768"});  // no quantity
  CHECK(wrong_in("$c$ = $v_{B}$ = 7.540 m/s") == None{});         // end of a formula: any quantity
  CHECK(wrong_in("$C$ = (0.2500; −0.7512) m") == None{});
  CHECK(wrong_in("$C$ = (−0.7512; −0.7512) m") == None{"−0.7512"});  // y twice
}

TEST_CASE("powers of ten, indices and whole numbers in what a sheet tells") {
  CHECK(wrong_in("$ε$ = $1.235·10^{−7}$") == None{});
  CHECK(wrong_in("$ε$ = $1.235·10^{−6}$") == None{"1.235·10^{−6}"});
  CHECK(wrong_in("v = 1.235e-07") == None{});
  CHECK(wrong_in("$a_{1.5}$ and 12 parts, 1/72") == None{});
}

TEST_CASE("in a table by points a number belongs to its row and its column") {
  const auto table = [](const std::string& A, const std::string& B) {
    return drawings::Table{{"$X$", "$v_{X}$ (m/s)"}, {{"$A$", A}, {"$B$", B}}};
  };
  CHECK(wrong_in(table("7.540", "5.103")) == None{});
  CHECK(wrong_in(table("5.103", "7.540")) == None{"5.103", "7.540"});
}

TEST_CASE("what is given and how near a curve is drawn are no quantities") {
  drawings::Sheet sheet;
  sheet.column = {drawings::Heading{"Given"},      drawings::Paragraph{"$l$ = 0.5 m"},
                  drawings::Heading{"The curves"}, drawings::Paragraph{"at most 0.009 mm"},
                  drawings::Heading{"Results"},    drawings::Paragraph{"0.5"}};
  CHECK(wrong_numbers(sheet, known).size() == 1);
}
