// Exercise 4 of Pisa's machine design: a bar turns about a hinge O on a body that translates; velocity and
// acceleration of its end A, and its velocity centre.
#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/panels/mechanism_panel.h"
#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/panels/poles_panel.h"
#include "exercises/kit/panels/polygon_panel.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/kit/statement/format_words.h"
#include "exercises/velocity-centre/routes.h"

namespace epure {
namespace velocity_centre {
namespace {

std::vector<GivenSpec> givens() {
  return {
      {"L", {"length of the bar OA", "lunghezza della barra OA"}, "m", "0.8", Range::positive, "$\\it{L}$"},
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
      {"V", {"velocity of the body, along x", "velocità del corpo, lungo x"}, "m/s", "12", Range::any, "$\\it{V}$"},
      {"a",
       {"acceleration of the body, along x", "accelerazione del corpo, lungo x"},
       "m/s^2",
       "4.5",
       Range::any,
       "$a$"}};
}

// The source calculated all of it; the velocity centre as the meet of two normals.
std::vector<Printed> printed_by_the_source() {
  return {{"A_x", "0.566", "analytic"},        {"A_y", "0.566", "analytic"},   {"v_A_x", "10.303", "analytic"},
          {"v_A_y", "1.697", "analytic"},      {"a_A_x", "1.106", "analytic"}, {"a_A_y", "-6.788", "analytic"},
          {"normal_slope", "-6.071", "poles"}, {"P0_y", "4", "poles"}};
}

std::shared_ptr<const Mechanism> bar_on_its_body(const Solution& s, bool speeds_up = false,
                                                 const std::string& letters_of_O = "$O$") {
  const Instant instant(s.givens());
  const double theta = sign_of(instant.angle) < 0 ? -geometry::to_double(within_one_turn(-instant.angle))
                                                  : geometry::to_double(within_one_turn(instant.angle));
  Mechanism mechanism;
  mechanism.point("O", s.place("O"), Mechanism::Joint::block, letters_of_O)
      .point("A", s.place("A"), Mechanism::Joint::none, "$A$")
      .body({"O", "A"})
      .guide("O", 0, "$x$")
      .angle("O", 0, theta, "$θ$")
      .turning("O", "A", sign_of(instant.omega), "$ω$");
  if (speeds_up) mechanism.turning("A", "O", sign_of(instant.omega_dot), "d$ω$/d$t$");
  return std::make_shared<const Mechanism>(std::move(mechanism));
}

VectorPolygon velocities(const Solution& s) {
  return velocity_polygon({side(s, velocity("A"), "?", "?")},
                          {side(s, velocity("O"), "∥ $x$", "|$\\it{V}$|", "$o'$"),
                           side(s, velocity("AO"), "⊥ $OA$", "|$ω$|·$OA$", "$a'$")});
}

VectorPolygon accelerations(const Solution& s) {
  PolygonSide tangential = side(s, tangential_acceleration("AO"), "⊥ $OA$", "|d$ω$/d$t$|·$OA$", "$a'$");
  tangential.square = true;
  return acceleration_polygon({side(s, acceleration("A"), "?", "?")},
                              {side(s, acceleration("O"), "∥ $x$", "|$a$|", "$o'$"),
                               side(s, normal_acceleration("AO"), "∥ $AO$", "$ω^{2}$·$OA$"), tangential});
}

using Where = PolesStep::Where;

std::vector<PolesStep> steps_to_centre(const Solution& s, Language language) {
  switch (centre_of(Instant(s.givens()))) {
    case Centre::by_two_normals: {
      const std::string m = figures(s.value("normal_slope").value_or(0), 4, language);
      return {{{"$\\vec{v}_{O}$ and $\\vec{v}_{A}$ set off at $O$ and $A$. The normal to $\\vec{v}_{O}$ through $O$ "
                "is the axis $y$.",
                "$\\vec{v}_{O}$ e $\\vec{v}_{A}$ riportate in $O$ e in $A$. La normale alla $\\vec{v}_{O}$ per $O$ è "
                "l'asse $y$."},
               Where::ray,
               "O"},
              {{"The normal to $\\vec{v}_{A}$ through $A$: its slope is $m_{1}$ = −$v_{A\\it{x}}$/$v_{A\\it{y}}$ = " +
                    m + ".",
                "La normale alla $\\vec{v}_{A}$ per $A$, di coefficiente angolare $m_{1}$ = "
                "−$v_{A\\it{x}}$/$v_{A\\it{y}}$ = " +
                    m + "."},
               Where::ray,
               "A"},
              {{"The velocity centre $P_{0}$ lies on both: $P_{0}O$ = |$\\it{V}$/$ω$|, $v_{A}$ = |$ω$|·$P_{0}A$.",
                "Il centro delle velocità $P_{0}$ sta su entrambe: $P_{0}O$ = |$\\it{V}$/$ω$|, $v_{A}$ = "
                "|$ω$|·$P_{0}A$."},
               Where::pole}};
    }
    case Centre::by_the_tips:
      return {{{"$\\vec{v}_{A}$ is parallel to $\\vec{v}_{O}$: the line $OA$ is normal to both.",
                "La $\\vec{v}_{A}$ è parallela alla $\\vec{v}_{O}$: la retta $OA$ è normale a entrambe."},
               Where::ray,
               "O"},
              {{"The line through the tips of the two vectors meets it in the velocity centre $P_{0}$.",
                "La retta per gli estremi dei due vettori la incontra nel centro delle velocità $P_{0}$."},
               Where::pole}};
    case Centre::is_O:
      return {{{"$\\it{V}$ = 0: $O$ rests, and is the velocity centre $P_{0}$. $v_{A}$ = |$ω$|·$OA$.",
                "$\\it{V}$ = 0: $O$ è fermo, ed è il centro delle velocità $P_{0}$. $v_{A}$ = |$ω$|·$OA$."},
               Where::pole}};
    case Centre::at_infinity:
      return {
          {{"$ω$ = 0: $\\vec{v}_{A}$ = $\\vec{v}_{O}$, the two normals are parallel. The bar translates: its "
            "velocity centre is at infinity.",
            "$ω$ = 0: $\\vec{v}_{A}$ = $\\vec{v}_{O}$, le due normali sono parallele. La barra trasla: il centro "
            "delle velocità è all'infinito."}}};
    case Centre::everywhere:
      break;
  }
  return {
      {{"$ω$ = 0 and $\\it{V}$ = 0: the bar rests, and no point of it is the velocity centre more than another.",
        "$ω$ = 0 e $\\it{V}$ = 0: la barra è ferma, e nessun suo punto è centro delle velocità più di un altro."}}};
}

// O, not accelerated, is K itself.
bool is_centre_at_O(const Solution& s) { return Instant(s.givens()).a == 0 && s.point("K"); }

std::vector<PolesStep> steps_to_accelerations(const Solution& s) {
  const Instant instant(s.givens());
  if (!s.point("K") && instant.a == 0)
    return {{{"$ω$, d$ω$/d$t$ and $a$ are zero: no point is accelerated, and none is $K$ more than another.",
              "$ω$, d$ω$/d$t$ e $a$ sono nulle: nessun punto è accelerato, e nessuno è $K$ più di un altro."}}};
  if (!s.point("K"))
    return {{{"$ω$ and d$ω$/d$t$ are zero: every point has the acceleration of $O$, and $K$ is at infinity.",
              "$ω$ e d$ω$/d$t$ sono nulle: ogni punto ha l'accelerazione di $O$, e $K$ è all'infinito."}}};
  const Words same_gamma{"The same $γ$ stands at every point of the bar.",
                         "Lo stesso $γ$ si trova in ogni punto della barra."};
  if (is_centre_at_O(s)) {
    const Words leans = is_zero(instant.omega_dot)
                            ? Words{"d$ω$/d$t$ = 0: $γ$ = 0, $\\vec{a}_{A}$ points along the bar to $K$.",
                                    "d$ω$/d$t$ = 0: $γ$ = 0, la $\\vec{a}_{A}$ è diretta lungo la barra verso $K$."}
                            : Words{"$\\vec{a}_{A}$ stands at $γ$ to $AK$, tan $γ$ = (d$ω$/d$t$)/$ω^{2}$.",
                                    "La $\\vec{a}_{A}$ forma con $AK$ l'angolo $γ$, tg $γ$ = (d$ω$/d$t$)/$ω^{2}$."};
    return {{{"$a$ = 0: $O$ is not accelerated, and is the acceleration centre: $K$ ≡ $O$.",
              "$a$ = 0: $O$ non è accelerato, ed è il centro delle accelerazioni: $K$ ≡ $O$."},
             Where::pole},
            {decimal("$a_{A}$ = $KA$·√($ω^{4}$ + (d$ω$/d$t$)$^{2}$)") + ".", Where::ray, "A"},
            {leans, Where::point, "A"}};
  }
  const Words of_O = decimal("$a_{O}$ = $KO$·√($ω^{4}$ + (d$ω$/d$t$)$^{2}$)");
  return {{{"Rays through $O$ and $A$, at the angle $γ$ to $\\vec{a}_{O}$ and to $\\vec{a}_{A}$, tan $γ$ = "
            "(d$ω$/d$t$)/$ω^{2}$, counter-clockwise when d$ω$/d$t$ > 0: they meet at $K$, where the acceleration is "
            "zero.",
            "Raggi per $O$ e per $A$, all'angolo $γ$ dalla $\\vec{a}_{O}$ e dalla $\\vec{a}_{A}$, tg $γ$ = "
            "(d$ω$/d$t$)/$ω^{2}$, antiorario se d$ω$/d$t$ > 0: si incontrano in $K$, dove l'accelerazione è nulla."},
           Where::pole},
          {of_O + ".", Where::ray, "O"},
          {{"Likewise $a_{A}$ with $KA$: $a_{A}$ : $a_{O}$ = $KA$ : $KO$.",
            "Analogamente $a_{A}$ con $KA$: $a_{A}$ : $a_{O}$ = $KA$ : $KO$."},
           Where::ray,
           "A"},
          {same_gamma, Where::point, "A"}};
}

PanelSheet velocity_sheet(const Solution& s, Language language) {
  const Instant instant(s.givens());
  const auto bar = bar_on_its_body(s);
  PolesPanel::Kind kind = PolesPanel::of_velocity("P0");
  kind.times_smaller = 25;  // the sheet asks for it, and shows the bar itself larger
  PolesPanel poles(s, bar, kind, {"O", "A"}, steps_to_centre(s, language));
  poles.sketched().compared_with(geometry::to_double(instant.omega), "|ω|").turning(sign_of(instant.omega), "$ω$");
  if (centre_of(instant) == Centre::by_the_tips) poles.by_the_tips();
  return {.panels = panels(MechanismPanel(bar, {{"A", s.place("A")}}), PolygonPanel(s, velocities(s)), poles),
          .results = {components(velocity("A")), coordinates("P0")},
          .seen = {"The bar on its body, the polygon of the velocities of A, and the velocity centre where the "
                   "normals to the velocities of O and A meet",
                   "La barra sul suo corpo, il poligono delle velocità di A, e il centro delle velocità dove si "
                   "incontrano le normali alle velocità di O e A"},
          .told = {"v_A", "v_A_x", "v_A_y", "P0_x", "P0_y"},
          .without_part = {"omega_dot", "a"}};
}

PanelSheet acceleration_sheet(const Solution& s, Language) {
  return {.panels = panels(MechanismPanel(bar_on_its_body(s, true)),
                           PolygonPanel(s, accelerations(s), PolygonPanel::Table::measured)),
          .results = {components(acceleration("A"))},
          .seen = {"The bar on its body, and the polygon of the accelerations of A",
                   "La barra sul suo corpo, e il poligono delle accelerazioni di A"},
          .told = {"a_A", "a_A_x", "a_A_y"},
          .without_part = {"V"}};
}

PanelSheet acceleration_pole_sheet(const Solution& s, Language) {
  const bool is_at_O = is_centre_at_O(s);
  PolesPanel::Kind kind = PolesPanel::of_acceleration();
  if (is_at_O) kind.letters.clear();  // O bears both
  const std::vector<std::string> accelerated =
      is_at_O ? std::vector<std::string>{"A"} : std::vector<std::string>{"O", "A"};
  return {.panels = panels(PolesPanel(s, bar_on_its_body(s, true, is_at_O ? "$O$ ≡ $K$" : "$O$"), kind, accelerated,
                                      steps_to_accelerations(s))),
          .results = {values({"gamma_deg"}), coordinates("K"), values({"KO", "KA"}), values({"a_O"}),
                      components(acceleration("A"))},
          .seen = {"The bar on its body, its acceleration centre K, and the accelerations of O and A",
                   "La barra sul suo corpo, il centro delle accelerazioni K, e le accelerazioni di O e A"},
          .told = {"a_O", "a_A", "K_x", "K_y"},
          .without_part = {"V"}};
}

// `given`: what is positive to the right. `find`: what is asked.
Words question(const Words& given, const Words& find) {
  return format_words(
      "A bar turns about a hinge O on a body that translates along $x$, with {} to the right. {}",
      "Un'asta ruota attorno a una cerniera O su un corpo che trasla lungo $x$, con {} verso destra. {}", given,
      find);
}

}  // namespace
}  // namespace velocity_centre

std::unique_ptr<Exercise> make_velocity_centre() {
  using namespace velocity_centre;
  const Words V{"$\\it{V}$ positive", "$\\it{V}$ positiva"}, a{"$a$ positive", "$a$ positiva"},
      both{"$\\it{V}$ and $a$ positive", "$\\it{V}$ e $a$ positive"};
  Description about{.id = "velocity-centre",
                    .title = {"A bar on a translating body", "Una barra su un corpo che trasla"},
                    .document = "pisa",
                    .item = "Esercizio 4",
                    .source = {"Pisa, mid-term test of 14 June 2006, exercise 4",
                               "Pisa, verifica intermedia del 14/6/2006, esercizio 4"},
                    .question = question(
                        both, {"Find the velocity centre of the bar, velocity and acceleration of its end A, and the "
                               "acceleration centre K.",
                               "Trovare il centro delle velocità dell'asta, velocità e accelerazione del suo estremo "
                               "A, e il centro delle accelerazioni K."}),
                    .givens = givens(),
                    .printed = printed_by_the_source};
  const auto solve = [](const Givens& givens, Rung rung) { return settle(Routes{Instant(givens)}, rung); };
  return exercise_of_panels(
      std::move(about), solve,
      {{{"velocities",
         {"Velocity centre of the bar", "Centro delle velocità"},
         question(V, {"Find the velocity centre of the bar and the velocity of its end A.",
                      "Trovare il centro delle velocità dell'asta e la velocità del suo estremo A."})},
        velocity_sheet},
       {{"accelerations",
         {"Acceleration of A", "Accelerazione di A"},
         question(a, {"Find the acceleration of its end A.", "Trovare l'accelerazione del suo estremo A."})},
        acceleration_sheet},
       {{"acceleration-pole",
         {"Acceleration centre K", "Centro delle accelerazioni K"},
         question(a, {"Find the acceleration centre K of the bar.",
                      "Trovare il centro delle accelerazioni K dell'asta."})},
        acceleration_pole_sheet}});
}

}  // namespace epure
