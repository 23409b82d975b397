// Sheet 4: the balance of powers, right and with the source's mistake, and the function in whose slope they differ.
#include <algorithm>
#include <cmath>

#include "drawings/charts/chart.h"
#include "exercises/kit/panels/fit.h"
#include "exercises/kit/panels/sheet.h"
#include "exercises/pin-in-slot/exercise.h"
#include "exercises/pin-in-slot/figure.h"

namespace epure::pin_in_slot {
namespace {

constexpr double row_height = 7;                     // mm
constexpr double balance_height = 5.4 * row_height;  // its name, three parts, their sum, and air
constexpr double names_width = 34;                   // mm left of the bars
constexpr double letters_size = 2.9;                 // mm
constexpr double air = 4;                            // mm between chart and bars

double length_OB(const Drawn& f) { return CGAL::to_double(f.instant.lengths.OB); }

// The parts of C in the order in which they are added.
struct Balance {
  Words name;
  std::vector<double> parts;  // of M1, of the disc, against the weight
  double couple() const { return parts[0] + parts[1] + parts[2]; }
};
Balance right_balance(const Drawn& f) {
  return {{"$v_{B}$ = $ω$·$OB^{2}$/$R$", "$v_{B}$ = $ω$·$OB^{2}$/$R$"}, {f.of_M1, f.of_disc, f.against_gravity}};
}
Balance mistaken_balance(const Drawn& f) {
  return {{"$v_{B}$ = $k$·$ω$·$OB$, $k$ constant", "$v_{B}$ = $k$·$ω$·$OB$, $k$ costante"},
          {f.of_M1, disc_part_with_constant_angle(f.instant), f.against_gravity}};
}
const std::vector<Words>& part_names() {
  static const std::vector<Words> names{
      {"inertia of $M_{1}$", "inerzia di $M_{1}$"},
      {"inertia of the disc", "inerzia del disco"},
      {"weight of $M_{1}$", "peso di $M_{1}$"},
  };
  return names;
}

// v_B/ω over OB: the parabola OB²/R, and the straight line that meets it at this instant.
drawings::Chart chart_of(const Drawn& f, Language language) {
  const double R = radius(f), b = length_OB(f), far = 1.6 * b, k = b / R;
  constexpr int pieces = 200;
  drawings::Curve parabola{.name = "v_B_true", .meaning = Meaning::velocity, .label = "$OB^{2}$/$R$"};
  parabola.runs.emplace_back();
  for (int i = 0; i <= pieces; ++i) {
    const double x = R + (far - R) * i / pieces;
    parabola.runs.back().push_back({x, x * x / R});
  }
  drawings::Curve straight{.name = "v_B_constant_angle",
                           .runs = {{{R, k * R}, {far, k * far}}},
                           .meaning = Meaning::velocity,
                           .line = drawings::LineType::dashed,
                           .label = "$k$·$OB$"};
  const Words now{"now", "ora"};
  return {.x = {.quantity = "$OB$", .unit = "m", .low = R, .high = far},
          .y = {.quantity = "$v_{B}$/$ω$", .unit = "m", .low = 0, .high = far * far / R},
          .curves = {parabola, straight},
          .markers = {{.at = {b, k * b}, .label = now.in(language), .meaning = Meaning::velocity}}};
}

// The parts of a balance laid end to end, one in a row, and their sum C in the last row.
class Bars {
 public:
  Bars(Plot& plot, double names_at, Language language) : plot_(plot), names_at_(names_at), language_(language) {}

  // Below `top` (mm). Only the right balance shows quantities that are reported.
  void draw(const Balance& balance, double top, bool measured) {
    write(balance.name.in(language_), 0, top - row_height / 2);
    double y = top - 1.5 * row_height, sum = 0;
    plot_.segment(at(0, y + row_height / 2), at(0, y - 3.5 * row_height), Meaning::axis);
    for (std::size_t i = 0; i < balance.parts.size(); ++i, y -= row_height) {
      row(part_names()[i].in(language_), sum, sum + balance.parts[i], y);
      if (measured && i == 2) plot_.measures_abscissa("gravity_torque", at(sum + balance.parts[i], y), at(sum, y));
      sum += balance.parts[i];
      plot_.segment(at(sum, y), at(sum, y - row_height), Meaning::construction);
    }
    row("$C$", 0, sum, y);
    if (measured) plot_.measures_abscissa("C", at(sum, y), at(0, y));
  }

 private:
  Place at(double newton_metres, double y) const { return {newton_metres, plot_.from_paper({0, y}).y}; }
  void write(const std::string& text, double indent, double y) {
    plot_.mark(drawings::Writing{text, {names_at_ + indent, y - letters_size / 3}, letters_size});
  }
  void row(const std::string& name, double from, double to, double y) {
    constexpr double indent = 3;  // mm
    write(name, indent, y);
    plot_.side("", at(from, y), at(to, y), Meaning::force, figures(to - from, 4, language_));
  }

  Plot& plot_;
  double names_at_;
  Language language_;
};

// From the least to the greatest sum on the way to C.
void include_sums(Extent& extent, const Scale& scale, const Balance& balance) {
  constexpr double letters = 9;  // mm, for a number beside a short bar
  double sum = 0;
  for (const double part : balance.parts) {
    extent.include(scale, {sum, 0}, letters);
    extent.include(scale, {sum + part, 0}, letters);
    sum += part;
  }
}

Scale draw_balances(DrawnSheet& onto, const Drawn& f, const drawings::Box& room, const SheetRequest& request) {
  const Balance right = right_balance(f), mistaken = mistaken_balance(f);
  const drawings::Box for_bars{{room.low.x + names_width, room.low.y}, room.high};
  double greatest = 0;
  for (const Balance& balance : {right, mistaken})
    for (const double part : balance.parts) greatest = std::max(greatest, std::abs(part));
  const Fit fit = fit_vectors(for_bars, "N m", request.language, room.width() / (greatest > 0 ? greatest : 1),
                              [&](const Scale& scale) {
                                Extent extent;
                                include_sums(extent, scale, right);
                                include_sums(extent, scale, mistaken);
                                return drawings::Box{{extent.box().low.x, 0}, {extent.box().high.x, 0}};
                              });
  Extent extent;
  include_sums(extent, fit.scale, right);
  include_sums(extent, fit.scale, mistaken);
  Plot plot(onto, {for_bars.low.x - extent.box().low.x, for_bars.low.y}, fit.scale);  // close to the names
  Bars bars(plot, room.low.x, request.language);
  bars.draw(right, room.high.y, true);
  bars.draw(mistaken, room.high.y - balance_height, false);
  return fit.scale;
}

// dv_B/dt of v_B = k ω OB with k constant.
double mistaken_acceleration(const Drawn& f) {
  const double b = length_OB(f);
  return b / radius(f) * (f.omega_dot * b + f.omega * f.b_dot);
}

std::string explained(const Drawn& f, Language language) {
  const auto num = [&](double x) { return figures(x, 4, language); };
  const std::string k = num(length_OB(f) / radius(f)), mistaken = num(mistaken_acceleration(f)), a_B = num(f.a_B.x);
  return language == Language::english
             ? "The source puts $v_{B}$ = $k$·$ω$·$OB$ into $E_{k}$, with $k$ = 1/sin $α$ = " + k +
                   ", which holds at this instant only, and differentiates as if $k$ were constant. The straight "
                   "line "
                   "meets the parabola here, but rises half as steeply: half of the term in $v_{rel}$ is lost, and B "
                   "would "
                   "have " +
                   mistaken + " m/s² instead of $a_{B}$ = " + a_B + " m/s²."
             : "La fonte pone $v_{B}$ = $k$·$ω$·$OB$ in $E_{k}$, con $k$ = 1/sen $α$ = " + k +
                   ", che vale solo in questo istante, e deriva come se $k$ fosse costante. La retta incontra qui la "
                   "parabola, ma sale la metà: si perde metà del termine in $v_{rel}$, e B avrebbe " +
                   mistaken + " m/s² invece di $a_{B}$ = " + a_B + " m/s².";
}

drawings::Table both_balances(const Drawn& f, Language language) {
  const auto num = [&](double x) { return figures(x, 4, language); };
  const Balance right = right_balance(f), mistaken = mistaken_balance(f);
  const Words head_right{"right", "giusto"}, head_mistaken{"source's", "fonte"};
  drawings::Table table{{"N m", head_right.in(language), head_mistaken.in(language)}, {}};
  for (std::size_t i = 0; i < right.parts.size(); ++i) {
    table.rows.push_back({part_names()[i].in(language), num(right.parts[i]), num(mistaken.parts[i])});
  }
  table.rows.push_back({"$C$", num(right.couple()), num(mistaken.couple())});
  return table;
}

std::string energies(const Drawn& f, Language language) {
  const auto num = [&](double x) { return figures(x, 4, language); };
  return "$E_{k}$ = " + num(f.kinetic_energy) + " J,  $dE_{k}/dt$ = " + num(f.omega * (f.of_M1 + f.of_disc)) + " W";
}

}  // namespace

void draw_power_balance(DrawnSheet& onto, const Drawn& f, const SheetRequest& request) {
  const Language language = request.language;
  const drawings::Box room = room_above_scale_bars(request);
  const double divide = room.low.y + 2 * balance_height;
  drawings::draw(chart_of(f, language), {{room.low.x, divide + air}, room.high}, onto.sheet.figure, language);
  const Scale torques = draw_balances(onto, f, {room.low, {room.high.x, divide}}, request);
  add_scale_bars(onto, {torques}, request);

  const bool english = language == Language::english;
  auto& column = onto.sheet.column;
  column.push_back(drawings::Heading{english ? "Balance" : "Bilancio"});
  column.push_back(drawings::Paragraph{"$C$·$ω$ − $M_{1}g$·$AO$ cos $α$·$ω$ = $dE_{k}/dt$"});
  column.push_back(
      drawings::Paragraph{"$E_{k}$ = ½($M_{1}$·$AO^{2}$·$ω^{2}$ + ($M_{2}$ + $J_{2}$/$R^{2}$)·$v^{2}_{B}$)"});
  column.push_back(drawings::Paragraph{energies(f, language)});
  column.push_back(drawings::Paragraph{
      english
          ? "At every instant sin $α$ = $R$/$OB$, so $v_{B}$ = $ω$·$OB$/sin $α$ = $ω$·$OB^{2}$/$R$. Divided by "
            "$ω$, the balance reads $C$ as a sum of torques: the bars."
          : "In ogni istante sen $α$ = $R$/$OB$, quindi $v_{B}$ = $ω$·$OB$/sen $α$ = $ω$·$OB^{2}$/$R$. Diviso per "
            "$ω$, il bilancio dà $C$ come somma di coppie: le barre."});
  column.push_back(drawings::Heading{english ? "The source's mistake" : "L'errore della fonte"});
  column.push_back(drawings::Paragraph{explained(f, language)});
  column.push_back(both_balances(f, language));
  onto.sheet.description =
      in_words({"The couple C by the balance of powers, right and with the source's mistake, and v_B/ω over OB, "
                "where they part",
                "La coppia C dal bilancio delle potenze, giusto e con l'errore della fonte, e v_B/ω in funzione di "
                "OB, dove si "
                "separano"},
               {{"C", f.couple, "N m"}, {"C (k)", mistaken_balance(f).couple(), "N m"}}, language);
}

}  // namespace epure::pin_in_slot
