#include "exercises/slider-crank-acceleration/exercise.h"

#include "exercises/kit/linkages/coupler_quantities.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/proof/solution.h"
#include "exercises/slider-crank-acceleration/quantities.h"

namespace epure {
namespace slider_crank_acceleration {
namespace {

using geometry::Deep;

std::vector<Quantity> accelerations() {
  return {acceleration("a_A", "$a_{A}$", {"acceleration of A", "accelerazione di A"}),
          {"alpha_3",
           "$α_{3}$",
           "rad/s^2",
           {"angular acceleration of the coupler", "accelerazione angolare della biella"}},
          acceleration("a_B_x", "$a_{Bx}$", {"acceleration of B, along x", "accelerazione di B, lungo x"}),
          acceleration("a_B_y", "$a_{By}$", {"acceleration of B, along y", "accelerazione di B, lungo y"}),
          acceleration("a_B", "$a_{B}$", {"acceleration of B", "accelerazione di B"}),
          acceleration("a_C_x", "$a_{Cx}$", {"acceleration of C, along x", "accelerazione di C, lungo x"}),
          acceleration("a_C_y", "$a_{Cy}$", {"acceleration of C, along y", "accelerazione di C, lungo y"}),
          acceleration("a_C", "$a_{C}$", {"acceleration of C", "accelerazione di C"}),
          acceleration("a_M_x", "$a_{Mx}$", {"acceleration of M, along x", "accelerazione di M, lungo x"}),
          acceleration("a_M_y", "$a_{My}$", {"acceleration of M, along y", "accelerazione di M, lungo y"}),
          acceleration("a_M", "$a_{M}$", {"acceleration of M", "accelerazione di M"}),
          acceleration("a_BA_n", "$a^{n}_{BA}$",
                       {"normal part of B's relative to A", "parte normale di B rispetto ad A"}),
          acceleration("a_BA_t", "$a^{t}_{BA}$",
                       {"tangential part of B's relative to A", "parte tangenziale di B rispetto ad A"}),
          acceleration("a_BA", "$a_{BA}$", {"acceleration of B relative to A", "accelerazione di B relativa ad A"}),
          acceleration("a_CA", "$a_{CA}$", {"acceleration of C relative to A", "accelerazione di C relativa ad A"}),
          acceleration("a_MA", "$a_{MA}$", {"acceleration of M relative to A", "accelerazione di M relativa ad A"}),
          {"gamma", "$γ$", "rad", {"tan γ = α₃/ω₃²", "tan γ = α₃/ω₃²"}}};
}

std::vector<Quantity> quantities() {
  return joined({accelerations(), pole_quantities("P0", "P_{0}", {"C", "M"}),
                 acceleration_pole_quantities({"A", "B", "C", "M"}), circle_quantities(),
                 curvature_quantities("C", "C"), curvature_quantities("M", "M")});
}

Description description() {
  return {
      .id = "slider-crank-acceleration",
      .title = {"Slider-crank: accelerations", "Manovellismo: accelerazioni"},
      .document = "sapienza",
      .item = "N.2",
      .source = {"Sapienza, Exercises in applied mechanics 2009/10, N.2",
                 "Sapienza, Esercitazioni di meccanica applicata 2009/10, N.2"},
      .givens = slider_crank_givens(true),
      .sheets = {{"polar-diagram", {"Polar diagram of acceleration", "Diagramma polare delle accelerazioni"}},
                 {"circles", {"Inflection and stationarity circles", "Circonferenze dei flessi e di stazionarietà"}},
                 {"poles", {"Accelerations by the pole K", "Accelerazioni col metodo dei poli"}},
                 {"curvature", {"Centres of curvature (Euler-Savary)", "Centri di curvatura (Euler-Savary)"}}},
      .quantities = quantities(),
      .printed = printed_by_the_source()};
}

class SliderCrankAcceleration : public Exercise {
 public:
  const Description& about() const override { return about_; }

  std::vector<RouteValue> solve(const Givens& givens, Rung rung) const override {
    return settle(AccelerationRoutes{slider_crank_instant(givens)}, rung);
  }

  DrawnSheet draw(const std::string& sheet, const Solution& solution, const SheetRequest& request) const override {
    const Givens& givens = solution.givens();
    const auto figure = drawn(slider_crank_instant(givens));
    DrawnSheet onto = blank_sheet(about_, sheet, givens, request);
    if (sheet == "polar-diagram") draw_polar_diagram(onto, *figure, request);
    if (sheet == "circles") draw_circles(onto, *figure, request);
    if (sheet == "poles") draw_poles(onto, *figure, request);
    if (sheet == "curvature") draw_curvature(onto, *figure, request);
    return onto;
  }

 private:
  Description about_ = description();
};

// A' on the ray P₀A by Euler-Savary, for the centre of curvature A₀ of A's path; and B, whose path is straight.
std::vector<CircleBuilder> builders(const geometry::SliderCrank<Deep>& at) {
  if (!to_double(at.pole())) return {};
  const geometry::Point<Deep> P0 = finite(at.pole());
  const Place B = to_double(at.B);
  return {{"$A'$", to_double(geometry::euler_savary_point(P0, at.A, at.A0)), to_double(at.A)}, {"", B, B}};
}

}  // namespace

std::unique_ptr<Drawn> drawn(const SliderCrankInstant& instant) {
  return deeply([&] {
    const auto at = instant.position<Deep>();
    const Deep omega_2 = instant.omega_2<Deep>(), alpha_2 = geometry::radians<Deep>(instant.alpha_2);
    const auto found = geometry::slider_crank_motion(at, omega_2, alpha_2);
    const geometry::PlaneMotion<Deep>& motion = found.coupler;
    const auto& terms = found.acceleration.first;
    const auto crank = at.A - at.A0, a_A = terms.known;
    const auto a_CA = found.relative_acceleration(at.C - at.A), a_MA = found.relative_acceleration(at.M - at.A);
    const DrawnSliderCrank position = drawn_position(instant);
    auto figure = std::make_unique<Drawn>(Drawn{.instant = instant,
                                                .at = position,
                                                .omega_2 = to_double(omega_2),
                                                .mechanism = {position, sign_of(instant.n)},
                                                .coupler = {}});
    figure->coupler = coupler_figure(figure->mechanism, motion, {{"A", at.A}, {"B", at.B}, {"C", at.C}, {"M", at.M}});
    figure->coupler.builders = builders(at);
    figure->a_A_n = to_double(-(geometry::square(omega_2) * crank));
    figure->a_A_t = to_double(alpha_2 * geometry::quarter_turn(crank));
    figure->a_A = to_double(a_A);
    figure->a_B = to_double(found.a_B());
    figure->a_C = to_double(a_A + a_CA);
    figure->a_M = to_double(a_A + a_MA);
    figure->a_BA_n = to_double(terms.normal);
    figure->a_BA_t = to_double(terms.closing);
    figure->a_CA = to_double(a_CA);
    figure->a_MA = to_double(a_MA);
    return figure;
  });
}

}  // namespace slider_crank_acceleration

std::unique_ptr<Exercise> make_slider_crank_acceleration() {
  return std::make_unique<slider_crank_acceleration::SliderCrankAcceleration>();
}

}  // namespace epure
