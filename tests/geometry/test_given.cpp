// Givens are read exactly or refused in one sentence.
#include "geometry/numbers/given.h"

#include "geometry/numbers/unit_product.h"
#include "tests/support/catch.h"

using namespace epure::geometry;

TEST_CASE("Good givens, read as the rational they say") {
  struct Row {
    const char* text;
    const char* unit;
    const char* value;
  };
  const Row rows[] = {
      {"0.20", "m", "1/5"},
      {"0.20", "mm", "1/5"},
      {"-1.5e-3", "m", "-3/2000"},
      {"+3", "1", "3"},
      {".5", "1", "1/2"},
      {"5.", "1", "5"},
      {"007", "1", "7"},
      {"0.1", "1", "1/10"},
      {"1/72", "s", "1/72"},
      {"1/72s", "s", "1/72"},
      {"-3/4", "1", "-3/4"},
      {"3/-4", "1", "-3/4"},
      {"1.5/2.5e1", "1", "3/50"},
      {"-0", "m", "0"},
      {"0/5", "m", "0"},
      {"360rpm", "rpm", "360"},
      {"360 rpm", "rpm", "360"},
      {"360\u00A0rpm", "rpm", "360"},
      {"360\u2009rpm\u202F", "rpm", "360"},
      {"\u22121.5e\u22123", "m", "-3/2000"},
      {"  360\trpm ", "rpm", "360"},
      {"360giri/min", "rpm", "360"},
      {"360 1/min", "rpm", "360"},
      {"360/min", "rpm", "360"},
      {"360 / min", "rpm", "360"},
      {"360 1/ min", "rpm", "360"},
      {"6Hz", "rpm", "360"},
      {"6turn/s", "rpm", "360"},
      {"6rev/s", "rpm", "360"},
      {"360 rev/min", "rpm", "360"},
      {"2160deg/s", "rpm", "360"},
      {"37.7 rad/s", "rad/s", "377/10"},
      {"60rad/min", "rad/s", "1"},
      {"100gon", "deg", "90"},
      {"500 mrad", "rad", "1/2"},
      {"1/2 rev", "deg", "180"},
      {"10in", "m", "127/500"},
      {"1ft", "m", "381/1250"},
      {"250 um", "mm", "1/4"},
      {"250µm", "mm", "1/4"},
      {"2h", "s", "7200"},
      {"1kgf", "N", "196133/20000"},
      {"1t", "kg", "1000"},
      {"2 kg cm^2", "kg m^2", "1/5000"},
      {"2 kg·m²", "kg m^2", "2"},
      {"2 kg m2", "kg m^2", "2"},
      {"2rad/s²", "rad/s^2", "2"},
      {"2m/s2", "m/s^2", "2"},
      {"4.5 m·s⁻¹", "m/s", "9/2"},
      {"4.5 m s^-1", "m/s", "9/2"},
      {"4,5 m s-1", "m/s", "9/2"},
      {"4.5e0 m*s^-1", "m/s", "9/2"},
      {"4.5m/sec", "m/s", "9/2"},
      {"2 rad·s⁻¹", "rad/s", "2"},
      {"2 rad s-2", "rad/s^2", "2"},
      {"2 m⋅s⁻²", "m/s^2", "2"},
      {"2 rad/sec²", "rad/s^2", "2"},
      {"30 gradi", "deg", "30"},
      {"–4.5 m/s", "m/s", "-9/2"},
      {"3 N m^-2", "Pa", "3"},
      {"5 mm⁴", "mm^4", "5"},
      {"0,25", "m", "1/4"},
      {"0,25m", "m", "1/4"},
      {",25", "m", "1/4"},
      {"5,", "m", "5"},
      {"-1,5e-3", "m", "-3/2000"},
      {"1/2,5", "m", "2/5"},
      {"1/,5", "m", "2"},
      {"1,234", "m", "617/500"},
      {"360rpm", "Hz", "6"},
      {"0.25m", "m", "1/4"},
      {"25cm", "m", "1/4"},
      {"250mm", "m", "1/4"},
      {"250mm", "cm", "25"},
      {"1km", "m", "1000"},
      {"30deg", "turn", "1/12"},
      {"30deg", "deg", "30"},
      {"30°", "deg", "30"},
      {"1/12turn", "deg", "30"},
      {"2ms", "s", "1/500"},
      {"1.5min", "s", "90"},
      {"2rad/s^2", "rad/s^2", "2"},
      {"3.6km/h", "m/s", "1"},
      {"120cm/s", "m/s", "6/5"},
      {"9.81m/s^2", "m/s^2", "981/100"},
      {"9810 mm/s^2", "m/s^2", "981/100"},
      {"2kN", "N", "2000"},
      {"1.5Nm", "Nm", "3/2"},
      {"300MPa", "Pa", "300000000"},
      {"210 N/mm²", "MPa", "210"},
      {"210GPa", "MPa", "210000"},
      {"2bar", "kPa", "200"},
      {"5kgf/cm^2", "Pa", "980665/2"},
      {"752 mm²", "m^2", "47/62500"},
      {"3.335e5mm^4", "cm^4", "667/20"},
      {"1e12mm^4", "m^4", "1"},
      {"0.32kN/s^3", "N/s^3", "320"},
      {"-10,4 N/s²", "N/s^2", "-52/5"},
      {"80N/s", "N/s", "80"},
      {"3N/s³", "kN/s^3", "3/1000"},
      {"2,84%", "1", "71/2500"},
      {"2kJ", "J", "2000"},
      {"1e2", "", "100"},
      {"2E3", "1", "2000"},
      {"1e-2m", "cm", "1"},
  };
  for (const Row& row : rows) {
    CAPTURE(row.text, row.unit);
    CHECK(to_text(parse_given(row.text, row.unit)) == row.value);
  }
}

TEST_CASE("Large and small exponents are exact") {
  CHECK(to_text(parse_given("1e308", "m")) == "1" + std::string(308, '0'));
  CHECK(to_text(parse_given("1e-400", "m")) == "1/1" + std::string(400, '0'));
  CHECK(parse_given("123456789012345678901234567890.5", "1") * Rational(2) ==
        Rational(CGAL::Gmpz("246913578024691357802469135781"), CGAL::Gmpz(1)));
}

TEST_CASE("Bad givens are refused: the text, what is wrong, what would be accepted") {
  struct Row {
    const char* text;
    const char* unit;
    const char* complaint;
    const char* accepted;
  };
  const Row rows[] = {
      {"", "m", "is empty", "0.25m"},
      {"   ", "m", "is empty", "0.25m"},
      {"1,234.5", "m", "point or comma", "1234.5"},
      {"1.234,5", "m", "point or comma", "1234.5"},
      {"1,234,567", "m", "point or comma", "1234.5"},
      {"1.234.567", "m", "point or comma", "1234.5"},
      {"1e3,5", "m", "point or comma", "1234.5"},
      {",", "m", "finite number", "0.25m"},
      {"nan", "m", "finite number", "0.25m"},
      {"NaN", "m", "finite number", "0.25m"},
      {"inf", "m", "finite number", "0.25m"},
      {"-inf", "m", "finite number", "0.25m"},
      {"m", "m", "finite number", "0.25m"},
      {".", "m", "finite number", "0.25m"},
      {"-", "m", "finite number", "0.25m"},
      {"+-1", "m", "finite number", "0.25m"},
      {"1/0", "m", "divides by zero", "1/4m"},
      {"1/0.0e5", "m", "divides by zero", "1/4m"},
      {"1e401", "m", "exponent", "0.25m"},
      {"1e-401", "m", "exponent", "0.25m"},
      {"1e999999999", "m", "exponent", "0.25m"},
      {"1e99999999999999999999999", "m", "exponent", "0.25m"},
      {"1e", "m", "exponent without digits", "0.25m"},
      {"1e+", "m", "exponent without digits", "0.25m"},
      {"0x10", "m", "no unit", "m, cm, mm, km"},
      {"1.2.3", "m", "point or comma", "1234.5"},
      {"1 000", "m", "point or comma", "1234.5"},
      {"1'000", "m", "point or comma", "1234.5"},
      {"274'", "m", "no unit", "m, cm, mm, km"},
      {"3m3", "m", "no unit of a length", "m, cm, mm, km"},
      {"3 J", "N m", "is an energy where a couple or moment is asked", "kNm"},
      {"3 m m", "m", "is an area where a length is asked", "m, cm, mm, km"},
      {"1/2/3", "m", "no unit", "m, cm, mm, km"},
      {"1/", "m", "no unit", "m, cm, mm, km"},
      {"5furlong", "m", "no unit", "m, cm, mm, km"},
      {"5 M", "m", "no unit", "m, cm, mm, km"},
      {"360rpm", "m", "an angular velocity where a length", "m, cm, mm, km"},
      {"6 1/s", "rpm", "may be in turns or in radians", "rad/s"},
      {"6 1/s", "rad/s", "may be in turns or in radians", "rpm"},
      {"6 s\u207B\u00B9", "rad/s", "may be in turns or in radians", "rpm"},
      {"6 1/s^2", "rad/s^2", "may be in turns or in radians", "rev/s^2"},
      {"6/s", "rpm", "may be in turns or in radians", "rad/s"},
      {"6 1/h", "rpm", "may be in turns or in radians", "rad/s"},
      {"6 1/ms", "rad/s", "may be in turns or in radians", "rpm"},
      {"6 1/min^2", "rad/s^2", "may be in turns or in radians", "rev/s^2"},
      {"6 s-2", "m", "no unit", "m, cm, mm, km"},
      {"1'234.5", "m", "point or comma", "1234.5"},
      {"1.234,5", "m", "point or comma", "1234.5"},
      {"5m", "s", "length where a time", "s, ms, min"},
      {"5m", "1", "length where a pure number", "without a unit"},
      {"1m/s", "m", "velocity where a length", "m, cm, mm, km"},
      {"37.7rad/s", "rpm", "a turn is 2π radians", "rpm"},
      {"30deg", "rad", "a turn is 2π radians", "rad"},
      {"300 N", "MPa", "a force where a stress", "Pa, kPa, MPa, GPa"},
      {"3mm^4", "mm^2", "a second moment of area where an area", "m^2, cm^2, mm^2"},
      {"3N/s", "N/s^2", "a force per time where a force per time squared", "N/s^2, kN/s^2"},
      {"3N", "N/s^3", "a force where a force per time cubed", "N/s^3, kN/s^3"},
      {"3Nm", "W", "a couple or moment where a power", "W, kW"},
      {"30deg", "rpm", "an angle where an angular velocity", "rpm"},
      {"30deg/s", "rad/s^2", "an angular velocity where an angular acceleration", "rad/s^2"},
  };
  for (const Row& row : rows) {
    CAPTURE(row.text, row.unit);
    try {
      parse_given(row.text, row.unit);
      FAIL_CHECK("accepted");
    } catch (const BadGiven& refusal) {
      const std::string message = refusal.what();
      CHECK_THAT(message, StartsWith("\"" + std::string(row.text) + "\""));
      CHECK_THAT(message, Contains(row.complaint));
      CHECK_THAT(message.substr(message.rfind("; write")), Contains(row.accepted));
      CHECK(message.find('\n') == std::string::npos);
    }
  }
}

TEST_CASE("Hostile givens stay short in the message and small in memory") {
  const std::string endless(2'000'000, '9');
  CHECK_THROWS_AS(parse_given(endless, "m"), BadGiven);
  try {
    parse_given(endless, "m");
  } catch (const BadGiven& refusal) {
    CHECK(std::string(refusal.what()).size() < 300);
  }
  CHECK_THROWS_AS(parse_given(std::string("1\0m", 3), "m"), BadGiven);
  try {
    parse_given("1\nm\x1b[31m", "m");
    FAIL_CHECK("accepted");
  } catch (const BadGiven& refusal) {
    CHECK(std::string(refusal.what()).find('\x1b') == std::string::npos);
    CHECK(std::string(refusal.what()).find('\n') == std::string::npos);
  }
}

TEST_CASE("Units of one kind convert exactly, but for π between them, there and back") {
  REQUIRE(known_units().size() > 20);
  for (const Unit& a : known_units())
    for (const Unit& b : known_units()) {
      if (a.kind != b.kind || a.counts_turns != b.counts_turns) continue;
      CAPTURE(a.symbol, b.symbol);
      CHECK(conversion(a.symbol, b.symbol) * conversion(b.symbol, a.symbol) == 1);
      if (a.symbol == "1" && b.symbol != "1") continue;  // a text without a unit is in that of b
      CHECK(parse_given("1" + std::string(a.symbol == "1" ? "" : " " + a.symbol), b.symbol) ==
            conversion(a.symbol, b.symbol));
    }
  CHECK(conversion("rpm", "Hz") == Rational(1, 60));
  CHECK_FALSE(find_unit("ell"));
}

TEST_CASE("Products of units are known by their dimensions, also where no given has them") {
  CHECK(parse_given("2 kN m", "N m") == 2000);
  CHECK(parse_given("3 N·cm", "N m") == Rational(3, 100));
  CHECK(parse_given("2 kg·cm²", "kg m^2") == Rational(2, 10000));
  CHECK(parse_given("5 daN/mm^2", "MPa") == 50);
  CHECK(parse_given("5 N m", "J") == 5);
  CHECK(conversion("kN m", "J") == 1000);
  CHECK(parse_given("2 kW h", "J") == 7200000);
  CHECK(parse_given("1 mm/m", "1") == Rational(1, 1000));
  CHECK(parse_given("1 kg m s^-2", "N") == 1);
  for (const char* none : {"m^3", "1/s", "1/s^2", "rad^2/s^2"}) CHECK_FALSE(find_unit(none));  // of no given
  struct Row {
    const char *text, *same;
    Rational times;
  };
  for (const Row& each : {Row{"cm³", "m^3", Rational(1, 1000000)},
                          {"l", "m^3", Rational(1, 1000)},
                          {"N m²", "N*m^2", 1},
                          {"kN/m", "N/m", 1000},
                          {"N/mm", "N/m", 1000},
                          {"kg m/s", "N s", 1},
                          {"N s/m", "kg/s", 1},
                          {"Ns/m", "N*s/m", 1},
                          {"MPa/m", "Pa/m", 1000000},
                          {"J s", "N*m*s", 1},
                          {"mm^2/s", "m^2/s", Rational(1, 1000000)},
                          {"W/mm", "W/m", 1000},
                          {"rad²/s²", "rad^2/s^2", 1},
                          {"1/s²", "s^-2", 1}}) {
    CAPTURE(each.text, each.same);
    const auto one = unit_product(each.text), other = unit_product(each.same);
    REQUIRE((one && other));
    CHECK(one->powers == other->powers);
    CHECK(one->factor == each.times * other->factor);
  }
  for (const char* none :
       {"", "/", "mN", "cl", "m//s", "m/s/s", "m^", "m^12", "^2", "deg/s", "rpm m", "N+m", "0", "2"}) {
    CAPTURE(none);
    CHECK_FALSE(unit_product(none));
  }
}

TEST_CASE("With π between, a number keeps the unit it was typed in") {
  struct Row {
    const char* text;
    const char* unit;
    const char* number;
    const char* kept;
    const char* turns;
    const char* radians;
  };
  const Row rows[] = {
      {"37.7rad/s", "rpm", "377/10", "rad/s", "0", "377/10"},
      {"360rpm", "rpm", "360", "rpm", "6", "0"},
      {"30rpm", "rad/s", "30", "rpm", "1/2", "0"},
      {"2rev/s", "rad/s", "2", "rev/s", "2", "0"},
      {"2rev/s", "rpm", "120", "rpm", "2", "0"},
      {"0,5rad", "deg", "1/2", "rad", "0", "1/2"},
      {"500mrad", "deg", "500", "mrad", "0", "1/2"},
      {"90°", "rad", "90", "°", "1/4", "0"},
      {"0.25rev", "deg", "90", "deg", "1/4", "0"},
      {"180deg/s^2", "rad/s^2", "180", "deg/s^2", "1/2", "0"},
      {"30rpm/s", "rad/s^2", "30", "rpm/s", "1/2", "0"},
      {"-3", "rad/s^2", "-3", "rad/s^2", "0", "-3"},
  };
  for (const Row& row : rows) {
    CAPTURE(row.text, row.unit);
    const InUnit read = read_given(row.text, row.unit);
    CHECK(to_text(read.number) == row.number);
    CHECK(read.unit.symbol == row.kept);
    CHECK(to_text(angle_of(read).turns) == row.turns);
    CHECK(to_text(angle_of(read).radians) == row.radians);
  }
}

TEST_CASE("A rational as text reads back as itself") {
  for (const char* text : {"1/5", "360", "-3", "0", "-22/7"}) CHECK(to_text(parse_given(text, "1")) == text);
}
