#include "exercises/slider-crank-velocity/exercise.h"

#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/proof/solution.h"
#include "exercises/slider-crank-velocity/quantities.h"

namespace epure {
namespace slider_crank_velocity {
namespace {

std::vector<Quantity> quantities() {
  return {
      {"omega_2", "$ω_{2}$", "rad/s", {"angular velocity of the crank", "velocità angolare della manovella"}},
      {"crank_angle_phi", "$φ$", "rad", {"crank angle from +x", "angolo di manovella da +x"}},
      {"crank_angle_phi_deg", "$φ$", "deg", {"crank angle in degrees", "angolo di manovella in gradi"}},
      {"v_A", "$v_{A}$", "m/s", {"speed of A", "velocità di A"}},
      {"A_x", "$x_{A}$", "m", {"abscissa of A", "ascissa di A"}},
      {"A_y", "$y_{A}$", "m", {"ordinate of A", "ordinata di A"}},
      {"B_x", "$x_{B}$", "m", {"abscissa of B", "ascissa di B"}},
      {"B_y", "$y_{B}$", "m", {"ordinate of B", "ordinata di B"}},
      {"C_x", "$x_{C}$", "m", {"abscissa of C", "ascissa di C"}},
      {"C_y", "$y_{C}$", "m", {"ordinate of C", "ordinata di C"}},
      {"M_x", "$x_{M}$", "m", {"abscissa of M", "ascissa di M"}},
      {"M_y", "$y_{M}$", "m", {"ordinate of M", "ordinata di M"}},
      {"coupler_angle", "$θ_{3}$", "rad", {"direction of AB from the guide", "direzione di AB rispetto alla guida"}},
      {"P0_x", "$x_{P0}$", "m", {"abscissa of the pole", "ascissa del polo"}},
      {"P0_y", "$y_{P0}$", "m", {"ordinate of the pole", "ordinata del polo"}},
      {"P0A", "$P_{0}A$", "m", {"distance of A from the pole", "distanza di A dal polo"}},
      {"P0B", "$P_{0}B$", "m", {"distance of B from the pole", "distanza di B dal polo"}},
      {"P0C", "$P_{0}C$", "m", {"distance of C from the pole", "distanza di C dal polo"}},
      {"P0M", "$P_{0}M$", "m", {"distance of M from the pole", "distanza di M dal polo"}},
      {"omega_3", "$ω_{3}$", "rad/s", {"angular velocity of the coupler", "velocità angolare della biella"}},
      {"v_B_x", "$v_{Bx}$", "m/s", {"velocity of B, along x", "velocità di B, lungo x"}},
      {"v_B_y", "$v_{By}$", "m/s", {"velocity of B, along y", "velocità di B, lungo y"}},
      {"v_B", "$v_{B}$", "m/s", {"speed of B", "velocità di B"}},
      {"v_C", "$v_{C}$", "m/s", {"speed of C", "velocità di C"}},
      {"v_M", "$v_{M}$", "m/s", {"speed of M", "velocità di M"}},
      {"v_C_x", "$v_{Cx}$", "m/s", {"velocity of C, along x", "velocità di C, lungo x"}},
      {"v_C_y", "$v_{Cy}$", "m/s", {"velocity of C, along y", "velocità di C, lungo y"}},
      {"v_M_x", "$v_{Mx}$", "m/s", {"velocity of M, along x", "velocità di M, lungo x"}},
      {"v_M_y", "$v_{My}$", "m/s", {"velocity of M, along y", "velocità di M, lungo y"}},
      {"v_BA", "$v_{BA}$", "m/s", {"speed of B relative to A", "velocità di B relativa ad A"}},
      {"v_CA", "$v_{CA}$", "m/s", {"speed of C relative to A", "velocità di C relativa ad A"}},
      {"v_MA", "$v_{MA}$", "m/s", {"speed of M relative to A", "velocità di M relativa ad A"}},
  };
}

Description description() {
  return {.id = "slider-crank-velocity",
          .title = {"Slider-crank: velocities", "Manovellismo: velocità"},
          .document = "sapienza",
          .item = "N.1",
          .source = {"Sapienza, Exercises in applied mechanics 2009/10, N.1",
                     "Sapienza, Esercitazioni di meccanica applicata 2009/10, N.1"},
          .givens = slider_crank_givens(false),
          .sheets = {{"poles", {"Method of poles", "Metodo dei poli"}},
                     {"polar-diagram", {"Polar diagram of velocity", "Diagramma polare delle velocità"}},
                     {"polodes", {"Fixed and moving polode", "Polare fissa e polare mobile"}},
                     {"coupler-curve", {"Path of the coupler point C", "Traiettoria del punto di biella C"}}},
          .quantities = quantities(),
          .printed = printed_by_the_source()};
}

class SliderCrankVelocity : public Exercise {
 public:
  const Description& about() const override { return about_; }

  std::vector<RouteValue> solve(const Givens& givens, Rung rung) const override {
    return settle(VelocityRoutes{slider_crank_instant(givens)}, rung);
  }

  DrawnSheet draw(const std::string& sheet, const Solution& solution, const SheetRequest& request) const override {
    const Givens& givens = solution.givens();
    const Drawn figure = drawn(slider_crank_instant(givens));
    DrawnSheet onto = blank_sheet(about_, sheet, givens, request);
    if (sheet == "poles") draw_poles(onto, figure, request);
    if (sheet == "polar-diagram") draw_polar_diagram(onto, figure, request);
    if (sheet == "polodes") draw_polodes(onto, figure, request);
    if (sheet == "coupler-curve") draw_coupler_curve(onto, figure, request);
    return onto;
  }

 private:
  Description about_ = description();
};

}  // namespace

Drawn drawn(const SliderCrankInstant& instant) {
  return deeply([&] {
    using geometry::Deep;
    const auto at = instant.position<Deep>();
    const auto motion = geometry::slider_crank_motion(at, instant.omega_2<Deep>(), Deep(0));
    const auto v_A = motion.velocity.first.known;
    const auto v_CA = motion.relative_velocity(at.C - at.A), v_MA = motion.relative_velocity(at.M - at.A);
    Drawn figure{.instant = instant, .at = drawn_position(instant)};
    figure.P0 = to_double(at.pole());
    figure.omega_3 = to_double(motion.coupler.omega);
    figure.v_A = to_double(v_A);
    figure.v_B = to_double(motion.v_B());
    figure.v_C = to_double(v_A + v_CA);
    figure.v_M = to_double(v_A + v_MA);
    figure.v_BA = to_double(motion.velocity.first.closing);
    figure.v_CA = to_double(v_CA);
    figure.v_MA = to_double(v_MA);
    return figure;
  });
}

}  // namespace slider_crank_velocity

std::unique_ptr<Exercise> make_slider_crank_velocity() {
  return std::make_unique<slider_crank_velocity::SliderCrankVelocity>();
}

}  // namespace epure
