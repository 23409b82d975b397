#include "exercises/velocity-centre/exercise.h"

#include "exercises/kit/panels/sheet.h"
#include "exercises/velocity-centre/quantities.h"

namespace epure {
namespace velocity_centre {
namespace {

std::vector<GivenSpec> givens() {
  return {{"L", {"length of the bar OA", "lunghezza della barra OA"}, "m", "0.8", Range::positive, "$L$"},
          {.symbol = "phi",
           .meaning = {"direction of OA, counter-clockwise from x", "direzione di OA, antioraria da x"},
           .unit = "deg",
           .stated = "45",
           .range = Range::any,
           .letters = "$θ$",
           .also = {"angle"}},
          {"omega",
           {"angular velocity of the bar, counter-clockwise", "velocità angolare della barra, antioraria"},
           "rad/s",
           "3",
           Range::any,
           "$ω$"},
          {"omega_dot",
           {"angular acceleration of the bar, counter-clockwise", "accelerazione angolare della barra, antioraria"},
           "rad/s^2",
           "-3",
           Range::any,
           "d$ω$/d$t$"},
          {"V", {"velocity of the body, along x", "velocità del corpo, lungo x"}, "m/s", "12", Range::any, "$V$"},
          {"a",
           {"acceleration of the body, along x", "accelerazione del corpo, lungo x"},
           "m/s^2",
           "4.5",
           Range::any,
           "$a$"}};
}

std::vector<QuantitySpec> velocities() {
  return {
      {"A_x", "$x_{A}$", "m", {"abscissa of A", "ascissa di A"}},
      {"A_y", "$y_{A}$", "m", {"ordinate of A", "ordinata di A"}},
      {"v_O", "$v_{O}$", "m/s", {"speed of O, which is the body's", "velocità di O, che è quella del corpo"}},
      {"v_AO", "$v_{AO}$", "m/s", {"speed of A relative to O", "velocità di A relativa ad O"}},
      {"v_A_x", "$v_{Ax}$", "m/s", {"velocity of A, along x", "velocità di A, lungo x"}},
      {"v_A_y", "$v_{Ay}$", "m/s", {"velocity of A, along y", "velocità di A, lungo y"}},
      {"v_A", "$v_{A}$", "m/s", {"speed of A", "velocità di A"}},
      {"normal_slope",
       "$m_{1}$",
       "1",
       {"slope of the normal to v_A", "coefficiente angolare della normale alla v_A"}},
      {"P0_x", "$x_{P0}$", "m", {"abscissa of the velocity centre", "ascissa del centro delle velocità"}},
      {"P0_y", "$y_{P0}$", "m", {"ordinate of the velocity centre", "ordinata del centro delle velocità"}},
      {"P0O", "$P_{0}O$", "m", {"distance of O from the velocity centre", "distanza di O dal centro delle velocità"}},
      {"P0A",
       "$P_{0}A$",
       "m",
       {"distance of A from the velocity centre", "distanza di A dal centro delle velocità"}}};
}

std::vector<QuantitySpec> accelerations() {
  return {
      {"a_O",
       "$a_{O}$",
       "m/s^2",
       {"acceleration of O, which is the body's", "accelerazione di O, che è quella del corpo"}},
      {"a_AO_n", "$a^{n}_{AO}$", "m/s^2", {"normal part of A's relative to O", "parte normale di A rispetto ad O"}},
      {"a_AO_t",
       "$a^{t}_{AO}$",
       "m/s^2",
       {"tangential part of A's relative to O", "parte tangenziale di A rispetto ad O"}},
      {"a_A_x", "$a_{Ax}$", "m/s^2", {"acceleration of A, along x", "accelerazione di A, lungo x"}},
      {"a_A_y", "$a_{Ay}$", "m/s^2", {"acceleration of A, along y", "accelerazione di A, lungo y"}},
      {"a_A", "$a_{A}$", "m/s^2", {"acceleration of A", "accelerazione di A"}},
      {"K_x", "$x_{K}$", "m", {"abscissa of the acceleration centre", "ascissa del centro delle accelerazioni"}},
      {"K_y", "$y_{K}$", "m", {"ordinate of the acceleration centre", "ordinata del centro delle accelerazioni"}},
      {"KO", "$KO$", "m", {"distance of O from K", "distanza di O da K"}},
      {"KA", "$KA$", "m", {"distance of A from K", "distanza di A da K"}}};
}

std::vector<QuantitySpec> quantities() {
  std::vector<QuantitySpec> all = velocities();
  for (const QuantitySpec& spec : accelerations()) all.push_back(spec);
  return all;
}

Description description() {
  return {.id = "velocity-centre",
          .title = {"A bar on a translating body", "Una barra su un corpo che trasla"},
          .document = "pisa",
          .item = "Esercizio 4",
          .source = {"Pisa, mid-term test of 14 June 2006, exercise 4",
                     "Pisa, verifica intermedia del 14/6/2006, esercizio 4"},
          .givens = givens(),
          .sheets = {{"velocities", {"Velocity centre of the bar", "Centro delle velocità"}},
                     {"accelerations", {"Acceleration of A", "Accelerazione di A"}},
                     {"acceleration-pole", {"Acceleration centre K", "Centro delle accelerazioni K"}}},
          .quantities = quantities(),
          .printed = printed_by_the_source()};
}

class VelocityCentre : public Exercise {
 public:
  const Description& about() const override { return about_; }

  std::vector<RouteValue> solve(const Givens& givens, Rung rung) const override {
    return settle(Routes{instant_of(givens)}, rung);
  }

  DrawnSheet draw(const std::string& sheet, const Givens& givens, const SheetRequest& request) const override {
    const auto figure = drawn(instant_of(givens));
    DrawnSheet onto = blank_sheet(about_, sheet, givens, request);
    if (sheet == "velocities") draw_velocities(onto, *figure, request);
    if (sheet == "accelerations") draw_accelerations(onto, *figure, request);
    if (sheet == "acceleration-pole") draw_acceleration_pole(onto, *figure, request);
    return onto;
  }

 private:
  Description about_ = description();
};

}  // namespace

bool Instant::is_upright() const {
  const Rational quarters = 4 * angle.turns;
  return angle.radians == 0 && quarters.denominator() == 1 && mpz_odd_p(quarters.numerator().mpz()) != 0;
}

Instant instant_of(const Givens& givens) {
  return {givens["L"], givens.angle("phi"), givens.angle("omega"), givens.angle("omega_dot"),
          givens["V"], givens["a"]};
}

Centre centre_of(const Instant& instant) {
  if (!instant.turns()) return instant.V == 0 ? Centre::everywhere : Centre::at_infinity;
  if (instant.V == 0) return Centre::is_O;
  return instant.is_upright() ? Centre::by_the_tips : Centre::by_two_normals;
}

}  // namespace velocity_centre

std::unique_ptr<Exercise> make_velocity_centre() { return std::make_unique<velocity_centre::VelocityCentre>(); }

}  // namespace epure
