#include "exercises/four-bar-analytic/exercise.h"

#include "exercises/kit/linkages/four_bar_routes.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/proof/solution.h"

namespace epure {
namespace four_bar_analytic {
namespace {

using geometry::Deep;

Description description() {
  return {.id = "four-bar-analytic",
          .title = {"Four-bar linkage: analytic methods", "Quadrilatero articolato: metodi analitici"},
          .document = "sapienza",
          .item = "N.10",
          .source = {"Sapienza, Exercises in applied mechanics 2009/10, N.10",
                     "Sapienza, Esercitazioni di meccanica applicata 2009/10, N.10"},
          .givens = givens(),
          .sheets = {{"configurations", {"Both configurations", "Le due configurazioni"}},
                     {"velocities", {"Polar diagram of velocity", "Diagramma polare delle velocità"}},
                     {"accelerations", {"Polar diagram of acceleration", "Diagramma polare delle accelerazioni"}},
                     {"curvature", {"Curvature of the path of G₃", "Curvatura della traiettoria di G₃"}},
                     {"omega-4", {"ω₄ over a turn of the crank", "ω₄ in un giro della manovella"}},
                     {"coupler-curve", {"Path of the coupler point P", "Traiettoria del punto di biella P"}}},
          .quantities = quantities(),
          .printed = printed_by_the_source()};
}

class FourBarAnalytic : public Exercise {
 public:
  const Description& about() const override { return about_; }

  std::vector<RouteValue> solve(const Givens& givens, Rung rung) const override {
    return four_bar_analytic::solve(problem(givens), rung);
  }

  DrawnSheet draw(const std::string& sheet, const Solution& solution, const SheetRequest& request) const override {
    const Givens& givens = solution.givens();
    const Drawn figure = drawn(problem(givens));
    DrawnSheet onto = blank_sheet(about_, sheet, givens, request);
    if (sheet == "configurations") draw_configurations(onto, figure, request);
    if (sheet == "velocities") draw_velocities(onto, figure, request);
    if (sheet == "accelerations") draw_accelerations(onto, figure, request);
    if (sheet == "curvature") draw_curvature(onto, figure, request);
    if (sheet == "omega-4") draw_omega_4(onto, figure, request);
    if (sheet == "coupler-curve") draw_coupler_curve(onto, figure, request);
    return onto;
  }

 private:
  Description about_ = description();
};

double sense_of(const FourBarInstant& instant) { return sign_of(instant.n); }

PolygonImage image(const std::string& letter, const std::string& quantity, const std::string& label, const Arrow2& v,
                   const std::string& tip, const Words& explained) {
  return {.absolute = {.quantity = quantity + letter, .label = label, .v = v, .tip = tip},
          .relative = {},
          .explained = explained};
}

// G₂, G₃, G₄ halve Oa', a'b' and Ob'.
std::vector<PolygonImage> images_of_midpoints(const std::string& quantity, const Arrow2& of_A, const Arrow2& of_B) {
  const auto half = [](const Arrow2& v) { return Arrow2{v.x / 2, v.y / 2}; };
  const std::string vector = "$\\vec{" + quantity.substr(0, 1) + "}_{G3}$";
  const std::string O = "$O_{" + quantity.substr(0, 1) + "}$";
  return {image("G3", quantity, vector, half({of_A.x + of_B.x, of_A.y + of_B.y}), "$g'_{3}$",
                {"$g'_{3}$ halves $a'b'$, as $G_{3}$ halves $AB$.",
                 "$g'_{3}$ è il punto medio di $a'b'$, come $G_{3}$ di $AB$."}),
          image("G2", quantity, "", half(of_A), "$g'_{2}$",
                {"$g'_{2}$ halves " + O + "$a'$: the crank's fixed point has its image in " + O + ".",
                 "$g'_{2}$ è il punto medio di " + O + "$a'$: il punto fisso ha l'immagine in " + O + "."}),
          image("G4", quantity, "", half(of_B), "$g'_{4}$",
                {"$g'_{4}$ likewise halves " + O + "$b'$.", "Così $g'_{4}$ è il punto medio di " + O + "$b'$."})};
}

void add_pole(Drawn& f, const geometry::FourBar<Deep>& at) {
  f.P0 = to_double(at.pole());
  if (f.of.instant.pole_at_infinity) {
    f.P0.reset();
    return;
  }
  const auto P0 = finite(at.pole());
  f.A_prime = to_double(geometry::euler_savary_point(P0, at.A, at.A0));
  f.B_prime = to_double(geometry::euler_savary_point(P0, at.B, at.B0));
}

void add_motion(Drawn& f, const geometry::FourBar<Deep>& at, const geometry::FourBarMotion<Deep>& motion) {
  const auto G3 = midpoint(at.A, at.B);
  f.omega_3 = to_double(motion.coupler.omega);
  f.omega_4 = to_double(motion.rocker.omega);
  f.alpha_3 = to_double(motion.coupler.alpha);
  f.alpha_4 = to_double(motion.rocker.alpha);
  f.v_G3 = to_double(motion.coupler.velocity(G3));
  f.a_G3 = to_double(motion.coupler.acceleration(G3));
  f.velocity = velocity_polygon(at, motion, "");
  f.velocity.images =
      images_of_midpoints("v_", to_double(motion.coupler.v_A), to_double(motion.coupler.velocity(at.B)));
  f.acceleration = acceleration_polygon(at, motion, "");
  f.acceleration.images =
      images_of_midpoints("a_", to_double(motion.coupler.a_A), to_double(motion.coupler.acceleration(at.B)));
  f.J = to_double(motion.coupler.inflection_pole());
  f.K = to_double(motion.coupler.acceleration_pole());
  f.inflection = to_double(motion.coupler.inflection_circle());
  f.G3_prime = to_double(motion.coupler.on_inflection_circle(G3));
  f.centre_of_G3 = to_double(motion.coupler.centre_of_curvature(G3));
}

void add_points(FourBarFigure& figure, const geometry::FourBar<Deep>& at) {
  figure.points = {{"$G_{2}$", to_double(midpoint(at.A0, at.A))},
                   {"$G_{3}$", to_double(midpoint(at.A, at.B))},
                   {"$G_{4}$", to_double(midpoint(at.B0, at.B))}};
}

}  // namespace

Drawn drawn(const Problem& of) {
  return deeply([&] {
    const FourBarInstant &instant = of.instant, other = on_other_branch(instant);
    const Deep omega_2 = instant.omega_2<Deep>(), alpha_2 = geometry::radians<Deep>(instant.alpha_2);
    const auto at = instant.position<Deep>(), at_other = other.position<Deep>();
    Drawn f{.of = of,
            .figure = drawn_four_bar(at, sense_of(instant)),
            .other = drawn_four_bar(at_other, sense_of(instant)),
            .P = to_double(coupler_point(of, at)),
            .omega_2 = to_double(omega_2)};
    add_points(f.figure, at);
    add_motion(f, at, geometry::four_bar_motion(at, omega_2, alpha_2));
    add_pole(f, at);
    const auto motion = geometry::four_bar_motion(at_other, omega_2, alpha_2);
    f.omega_3_other = to_double(motion.coupler.omega);
    f.omega_4_other = to_double(motion.rocker.omega);
    f.alpha_3_other = to_double(motion.coupler.alpha);
    f.alpha_4_other = to_double(motion.rocker.alpha);
    return f;
  });
}

}  // namespace four_bar_analytic

std::unique_ptr<Exercise> make_four_bar_analytic() { return std::make_unique<four_bar_analytic::FourBarAnalytic>(); }

}  // namespace epure
