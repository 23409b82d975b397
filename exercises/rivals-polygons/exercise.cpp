#include "exercises/rivals-polygons/exercise.h"

#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/proof/solution.h"
#include "exercises/rivals-polygons/quantities.h"

namespace epure {
namespace rivals_polygons {
namespace {

std::vector<GivenSpec> givens() {
  return {{"r", {"crank A₀A", "manovella A₀A"}, "m", "0.2", Range::positive, "$r$"},
          {"l", {"coupler AB", "biella AB"}, "m", "0.5", Range::positive, "$l$"},
          {"AG", {"distance of G from A, towards B", "distanza di G da A, verso B"}, "m", "0.25", Range::any, "$AG$"},
          {"n",
           {"crank speed, counter-clockwise", "velocità della manovella, antioraria"},
           "rpm",
           "360",
           Range::any,
           "$n$"},
          {"alpha_2",
           {"angular acceleration of the crank", "accelerazione angolare della manovella"},
           "rad/s^2",
           "0",
           Range::any,
           "$α_{2}$"},
          {"phi",
           {"crank angle from the outer dead centre", "angolo di manovella dal punto morto esterno"},
           "deg",
           "30",
           Range::any,
           "$φ$"}};
}

std::vector<Quantity> velocities() {
  const auto speed = [](const std::string& name, const std::string& symbol, const Words& meaning) {
    return Quantity{name, symbol, "m/s", meaning};
  };
  return {speed("v_A", "$v_{A}$", {"speed of A", "velocità di A"}),
          speed("v_BA", "$v_{BA}$", {"speed of B relative to A", "velocità di B relativa ad A"}),
          speed("v_B_x", "$v_{Bx}$", {"velocity of B along the guide", "velocità di B lungo la guida"}),
          speed("v_B", "$v_{B}$", {"speed of B", "velocità di B"}),
          {"omega_3",
           "$ω_{3}$",
           "rad/s",
           {"angular velocity of the coupler (Ω in the source)", "velocità angolare della biella (Ω nella fonte)"}},
          speed("v_GA", "$v_{GA}$", {"speed of G relative to A", "velocità di G relativa ad A"}),
          speed("v_G_x", "$v_{Gx}$", {"velocity of G, along x", "velocità di G, lungo x"}),
          speed("v_G_y", "$v_{Gy}$", {"velocity of G, along y", "velocità di G, lungo y"}),
          speed("v_G", "$v_{G}$", {"speed of G", "velocità di G"})};
}

std::vector<Quantity> accelerations() {
  const auto acceleration = [](const std::string& name, const std::string& symbol, const Words& meaning) {
    return Quantity{name, symbol, "m/s^2", meaning};
  };
  return {
      acceleration("a_A_n", "$a^{n}_{A}$", {"normal acceleration of A", "accelerazione normale di A"}),
      acceleration("a_A_t", "$a^{t}_{A}$", {"tangential acceleration of A", "accelerazione tangenziale di A"}),
      acceleration("a_A", "$a_{A}$", {"acceleration of A", "accelerazione di A"}),
      acceleration("a_BA_n", "$a^{n}_{BA}$",
                   {"normal part of B's relative to A", "parte normale di B rispetto ad A"}),
      acceleration("a_BA_t", "$a^{t}_{BA}$",
                   {"tangential part of B's relative to A", "parte tangenziale di B rispetto ad A"}),
      acceleration("a_B_x", "$a_{Bx}$", {"acceleration of B along the guide", "accelerazione di B lungo la guida"}),
      acceleration("a_B", "$a_{B}$", {"acceleration of B", "accelerazione di B"}),
      {"alpha_3",
       "$α_{3}$",
       "rad/s^2",
       {"angular acceleration of the coupler (Ω' in the source)",
        "accelerazione angolare della biella (Ω' nella fonte)"}},
      acceleration("a_GA_n", "$a^{n}_{GA}$",
                   {"normal part of G's relative to A", "parte normale di G rispetto ad A"}),
      acceleration("a_GA_t", "$a^{t}_{GA}$",
                   {"tangential part of G's relative to A", "parte tangenziale di G rispetto ad A"}),
      acceleration("a_G_x", "$a_{Gx}$", {"acceleration of G, along x", "accelerazione di G, lungo x"}),
      acceleration("a_G_y", "$a_{Gy}$", {"acceleration of G, along y", "accelerazione di G, lungo y"}),
      acceleration("a_G", "$a_{G}$", {"acceleration of G", "accelerazione di G"}),
      acceleration("a_B_as_printed", "$a^{(1)}_{B}$",
                   {"what the source's equation (1) makes of B's: with a_A besides its two parts",
                    "quella di B secondo la (1) della fonte: con a_A oltre alle sue due parti"})};
}

std::vector<Quantity> quantities() {
  std::vector<Quantity> all = velocities();
  for (const Quantity& spec : accelerations()) all.push_back(spec);
  return all;
}

Description description() {
  return {
      .id = "rivals-polygons",
      .title = {"Slider-crank: Rivals' theorem", "Manovellismo: teorema di Rivals"},
      .document = "macchine",
      .item = "Teoremi di Rivals e Coriolis",
      .source = {"Machines, exercises: Theorems of Rivals and Coriolis",
                 "Macchine, esercizi: Teoremi di Rivals e Coriolis"},
      .givens = givens(),
      .sheets = {{"velocity-of-B", {"Velocity of B, step by step", "Velocità di B, passo per passo"}},
                 {"velocity-of-G", {"Velocity of G, step by step", "Velocità di G, passo per passo"}},
                 {"acceleration-of-B", {"Acceleration of B, step by step", "Accelerazione di B, passo per passo"}},
                 {"acceleration-of-G", {"Acceleration of G, step by step", "Accelerazione di G, passo per passo"}}},
      .quantities = quantities(),
      .printed = {}};  // the source solves it in letters
}

class RivalsPolygons : public Exercise {
 public:
  const Description& about() const override { return about_; }

  std::vector<RouteValue> solve(const Givens& givens, Rung rung) const override {
    return settle(Routes{instant_of(givens)}, rung);
  }

  DrawnSheet draw(const std::string& sheet, const Solution& solution, const SheetRequest& request) const override {
    const Givens& givens = solution.givens();
    const Drawn figure = drawn(instant_of(givens));
    DrawnSheet onto = blank_sheet(about_, sheet, givens, request);
    if (sheet == "velocity-of-B") draw_velocity_of_B(onto, figure, request);
    if (sheet == "velocity-of-G") draw_velocity_of_G(onto, figure, request);
    if (sheet == "acceleration-of-B") draw_acceleration_of_B(onto, figure, request);
    if (sheet == "acceleration-of-G") draw_acceleration_of_G(onto, figure, request);
    return onto;
  }

 private:
  Description about_ = description();
};

}  // namespace

Instant instant_of(const Givens& givens) {
  const Rational &l = givens["l"], &AG = givens["AG"];
  Instant instant{{.lengths = {givens["r"], l, CGAL::abs(AG), CGAL::abs(l - AG)},
                   .n = givens.angle("n"),
                   .crank = givens.angle("phi"),
                   .alpha_2 = givens.angle("alpha_2")},
                  AG};
  require_drivable(instant.crank);
  return instant;
}

}  // namespace rivals_polygons

std::unique_ptr<Exercise> make_rivals_polygons() { return std::make_unique<rivals_polygons::RivalsPolygons>(); }

}  // namespace epure
