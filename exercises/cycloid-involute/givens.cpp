// What is given.
#include "exercises/cycloid-involute/exercise.h"

namespace epure::cycloid_involute {
namespace {

GivenSpec given(const std::string& symbol, const Words& meaning, const std::string& unit, const std::string& stated,
                Range range, const std::string& letters) {
  return {symbol, meaning, unit, stated, range, letters};
}

GivenSpec angle_of_line(const std::string& symbol, const std::string& instant, const std::string& letters) {
  return {.symbol = symbol,
          .meaning = {"angle the line has turned through, in place of " + instant,
                      "angolo di cui è ruotata la retta, in luogo di " + instant},
          .unit = "rad",
          .stated = "",
          .range = Range::not_negative,
          .letters = letters,
          .turned = TurnedThrough{.instant = instant, .speed = "omega_2"}};
}

}  // namespace

std::vector<GivenSpec> given_specs() {
  return {given("d", {"diameter of the wheel", "diametro della ruota"}, "m", "1", Range::positive, "$d$"),
          given("omega_1", {"angular velocity of the wheel", "velocità angolare della ruota"}, "rad/s", "30",
                Range::positive, "$ω_{1}$"),
          given("phi", {"angle of the wheel at the first instant", "rotazione della ruota al primo istante"}, "deg",
                "135", Range::not_negative, "$φ$"),
          given("s", {"arc travelled at the second instant", "spazio percorso al secondo istante"}, "m", "4",
                Range::not_negative, "$s$"),
          given("d_0", {"diameter of the base circle", "diametro del cerchio di base"}, "m", "0.6", Range::positive,
                "$d_{0}$"),
          given("omega_2", {"angular velocity of the line", "velocità angolare della retta"}, "rad/s", "50",
                Range::positive, "$ω_{2}$"),
          given("t1", {"first instant of the involute", "primo istante dell'evolvente"}, "s", "0.14",
                Range::not_negative, "$t_{1}$"),
          angle_of_line("phi_1", "t1", "$φ_{1}$"),
          given("t2", {"second instant of the involute", "secondo istante dell'evolvente"}, "s", "0.28",
                Range::not_negative, "$t_{2}$"),
          angle_of_line("phi_2", "t2", "$φ_{2}$")};
}

}  // namespace epure::cycloid_involute
