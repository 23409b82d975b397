#include "exercises/slider-crank-acceleration/exercise.h"

#include <algorithm>
#include <cmath>

#include "exercises/kit/sheet.h"
#include "exercises/slider-crank-acceleration/quantities.h"

namespace epure {
namespace slider_crank_acceleration {
namespace {

using geometry::Deep;

QuantitySpec acceleration(const std::string& name, const std::string& symbol, const Words& meaning) {
  return {name, symbol, "m/s^2", meaning};
}
QuantitySpec metres(const std::string& name, const std::string& symbol, const Words& meaning) {
  return {name, symbol, "m", meaning};
}

std::vector<QuantitySpec> accelerations() {
  return {
      acceleration("a_A", "$a_{A}$", {"acceleration of A", "accelerazione di A"}),
      {"alpha_3",
       "$α_{3}$",
       "rad/s^2",
       {"angular acceleration of the coupler", "accelerazione angolare della biella"}},
      acceleration("a_B_x", "$a_{Bx}$", {"acceleration of B along the guide", "accelerazione di B lungo la guida"}),
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

std::vector<QuantitySpec> poles_and_circles() {
  return {
      metres("P0_x", "$x_{P0}$", {"abscissa of the pole", "ascissa del polo"}),
      metres("P0_y", "$y_{P0}$", {"ordinate of the pole", "ordinata del polo"}),
      metres("K_x", "$x_{K}$", {"abscissa of the acceleration pole", "ascissa del polo delle accelerazioni"}),
      metres("K_y", "$y_{K}$", {"ordinate of the acceleration pole", "ordinata del polo delle accelerazioni"}),
      metres("KA", "$KA$", {"distance of A from K", "distanza di A da K"}),
      metres("KB", "$KB$", {"distance of B from K", "distanza di B da K"}),
      metres("KC", "$KC$", {"distance of C from K", "distanza di C da K"}),
      metres("KM", "$KM$", {"distance of M from K", "distanza di M da K"}),
      metres("P0C", "$P_{0}C$", {"distance of C from the pole", "distanza di C dal polo"}),
      metres("P0M", "$P_{0}M$", {"distance of M from the pole", "distanza di M dal polo"}),
      metres("inflection_diameter", "$δ_{F}$",
             {"diameter of the inflection circle", "diametro della circonferenza dei flessi"}),
      metres("inflection_pole_x", "$x_{J}$", {"abscissa of the inflection pole J", "ascissa del polo dei flessi J"}),
      metres("inflection_pole_y", "$y_{J}$", {"ordinate of the inflection pole J", "ordinata del polo dei flessi J"}),
      metres("inflection_centre_x", "$x_{F}$",
             {"abscissa of the inflection circle's centre", "ascissa del centro della circonferenza dei flessi"}),
      metres("inflection_centre_y", "$y_{F}$",
             {"ordinate of the inflection circle's centre", "ordinata del centro della circonferenza dei flessi"}),
      metres("stationarity_diameter", "$δ_{S}$",
             {"diameter of the stationarity circle", "diametro della circonferenza di stazionarietà"}),
      metres("stationarity_centre_x", "$x_{S}$",
             {"abscissa of the stationarity circle's centre",
              "ascissa del centro della circonferenza di stazionarietà"}),
      metres("stationarity_centre_y", "$y_{S}$",
             {"ordinate of the stationarity circle's centre",
              "ordinata del centro della circonferenza di stazionarietà"})};
}

std::vector<QuantitySpec> curvature_of(const std::string& X) {
  const auto symbol = [&](const char* before, const char* after) { return before + X + after; };
  return {metres(X + "prime_" + X, symbol("$", "'") + X + "$",
                 {"distance from " + X + "' to " + X, "distanza da " + X + "' a " + X}),
          metres("rho_" + X, symbol("$ρ_{", "}$"),
                 {"radius of curvature of the path of " + X, "raggio di curvatura della traiettoria di " + X}),
          metres("curvature_centre_" + X + "_x", symbol("$x_{Ω", "}$"),
                 {"abscissa of the centre of curvature", "ascissa del centro di curvatura"}),
          metres("curvature_centre_" + X + "_y", symbol("$y_{Ω", "}$"),
                 {"ordinate of the centre of curvature", "ordinata del centro di curvatura"}),
          metres(X + "prime_x", symbol("$x_{", "'}$"),
                 {"abscissa of " + X + "', on the inflection circle",
                  "ascissa di " + X + "', sulla circonferenza dei flessi"}),
          metres(X + "prime_y", symbol("$y_{", "'}$"),
                 {"ordinate of " + X + "', on the inflection circle",
                  "ordinata di " + X + "', sulla circonferenza dei flessi"})};
}

std::vector<QuantitySpec> quantities() {
  std::vector<QuantitySpec> all = accelerations();
  for (const auto& group : {poles_and_circles(), curvature_of("C"), curvature_of("M")}) {
    all.insert(all.end(), group.begin(), group.end());
  }
  return all;
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

  DrawnSheet draw(const std::string& sheet, const Givens& givens, const SheetRequest& request) const override {
    const Drawn figure = drawn(slider_crank_instant(givens));
    DrawnSheet onto = blank_sheet(about_, sheet, givens, request);
    if (sheet == "polar-diagram") draw_polar_diagram(onto, figure, request);
    if (sheet == "circles") draw_circles(onto, figure, request);
    if (sheet == "poles") draw_poles(onto, figure, request);
    if (sheet == "curvature") draw_curvature(onto, figure, request);
    return onto;
  }

 private:
  Description about_ = description();
};

Curvature curvature_at(const geometry::PlaneMotion<Deep>& motion, const geometry::Point<Deep>& X) {
  return {to_double(motion.on_inflection_circle(X)), to_double(motion.centre_of_curvature(X))};
}

}  // namespace

Drawn drawn(const SliderCrankInstant& instant) {
  return deeply([&] {
    const auto at = instant.position<Deep>();
    const Deep omega_2 = instant.omega_2<Deep>();
    const auto velocities = geometry::velocity_diagram(at, omega_2);
    const auto found = geometry::acceleration_diagram(at, omega_2, geometry::from_rational<Deep>(instant.alpha_2),
                                                      velocities.omega_3);
    const geometry::PlaneMotion<Deep> motion{at.A, velocities.v_A, found.a_A, velocities.omega_3, found.alpha_3};
    const auto a_CA = found.relative(at.C - at.A), a_MA = found.relative(at.M - at.A);
    Drawn figure{.instant = instant, .at = drawn_position(instant)};
    figure.omega_2 = to_double(omega_2);
    figure.omega_3 = to_double(velocities.omega_3);
    figure.alpha_3 = to_double(found.alpha_3);
    figure.P0 = to_double(at.pole());
    figure.J = to_double(motion.inflection_pole());
    figure.K = to_double(motion.acceleration_pole());
    figure.inflection = to_double(motion.inflection_circle());
    figure.stationarity = to_double(motion.stationarity_circle());
    figure.a_A_n = to_double(found.a_A_n);
    figure.a_A_t = to_double(found.a_A_t);
    figure.a_A = to_double(found.a_A);
    figure.a_B = to_double(found.a_B);
    figure.a_C = to_double(found.a_A + a_CA);
    figure.a_M = to_double(found.a_A + a_MA);
    figure.a_BA_n = to_double(found.a_BA_n);
    figure.a_BA_t = to_double(found.a_BA_t);
    figure.a_CA = to_double(a_CA);
    figure.a_MA = to_double(a_MA);
    figure.C = curvature_at(motion, at.C);
    figure.M = curvature_at(motion, at.M);
    return figure;
  });
}

std::vector<Followed> followed(const Drawn& f) {
  return {{"A", "KA", "a_A", f.at.A, f.a_A},
          {"B", "KB", "a_B", f.at.B, f.a_B},
          {"C", "KC", "a_C", f.at.C, f.a_C},
          {"M", "KM", "a_M", f.at.M, f.a_M}};
}

double greatest_acceleration(const Drawn& f) {
  double greatest = 0;
  for (const Followed& X : followed(f)) greatest = std::max(greatest, std::hypot(X.a.x, X.a.y));
  return greatest;
}

}  // namespace slider_crank_acceleration

std::unique_ptr<Exercise> make_slider_crank_acceleration() {
  return std::make_unique<slider_crank_acceleration::SliderCrankAcceleration>();
}

}  // namespace epure
