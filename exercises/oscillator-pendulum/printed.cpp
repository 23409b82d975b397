#include "exercises/oscillator-pendulum/printed.h"

#include <cmath>
#include <functional>

#include "exercises/oscillator-pendulum/printed_tables.h"
#include "exercises/oscillator-pendulum/quantities.h"

namespace epure::oscillator_pendulum {
namespace {

constexpr double beta = 0.22, e = 2.72, constant = 0.0341;  // 0.015/0.44, rounded

const Words rounded_constants{
    "e was rounded to 2.72, β to 0.22 and v_0/2β = 0.015/0.44 to 0.0341: these give all 40 values of the column",
    "e è stato arrotondato a 2,72, β a 0,22 e v_0/2β = 0,015/0,44 a 0,0341: così si ottengono tutti i 40 valori "
    "della colonna"};
const Words shifted_rows{
    "a row holds the numerical value at t = 0.5 i beside the analytical one at t = i, and the error printed compares "
    "the two, over the numerical one; the analytical one has e = 2.72, β = 0.22, v_0/2β = 0.0341",
    "ogni riga ha il valore numerico per t = 0,5 i accanto a quello analitico per t = i, e l'errore stampato "
    "confronta i due, diviso per il numerico; l'analitico ha e = 2,72, β = 0,22, v_0/2β = 0,0341"};
const Words another_start{
    "the table does not start from rest: θ_0 = 1.571 and θ_1 = 1.549 were typed in, -2.2 rad/s; with them the "
    "printed recursion gives all 101 rows",
    "la tabella non parte dalla quiete: sono stati immessi θ_0 = 1,571 e θ_1 = 1,549, cioè -2,2 rad/s; con essi la "
    "formula ricorsiva stampata dà tutte le 101 righe"};
const Words wrong_sign{
    "θ'^2 r cos θ entered equation 2) with the wrong sign, in all 101 rows (and the table starts with θ_0 = 1.571, "
    "θ_1 = 1.549)",
    "θ'^2 r cos θ è entrato nell'equazione 2) con il segno sbagliato, in tutte le 101 righe (e la tabella parte con "
    "θ_0 = 1,571, θ_1 = 1,549)"};

struct FirstAngles {
  double first, second;
};
constexpr FirstAngles typed{1.571, 1.549}, at_rest{M_PI / 2, M_PI / 2};

double angle_of_table(int i, const FirstAngles& start) {
  constexpr double Omega_squared = 39.24, dt = 0.01;
  double before = start.first, now = start.second;
  for (int row = 0; row < i; ++row) {
    const double next = 2 * now - before - Omega_squared * dt * dt * std::sin(before);
    before = now, now = next;
  }
  return before;
}

// `sign`: that of θ'² r cos θ in equation 2).
SourcePendulumRow pendulum_row(int i, const FirstAngles& start, int sign) {
  constexpr double dt = 0.01, m_r = 0.25, weight = 49.05;
  const double theta = angle_of_table(i, start), next = angle_of_table(i + 1, start),
               second = angle_of_table(i + 2, start), rate = (next - theta) / dt,
               acceleration = (second + theta - 2 * next) / (dt * dt);
  return {theta, rate, acceleration, m_r * (acceleration * std::cos(theta) - rate * rate * std::sin(theta)),
          weight + m_r * (acceleration * std::sin(theta) + sign * rate * rate * std::cos(theta))};
}

// Row by row.
std::vector<Rational> column(std::size_t rows, const std::function<double(int)>& value) {
  std::vector<Rational> all;
  for (std::size_t i = 0; i < rows; ++i) all.emplace_back(value(static_cast<int>(i)));
  return all;
}

// x at t, by the closed form with the true constants.
double exact_x(double t) {
  const double b = 0.1 * std::sqrt(5.0);
  return 0.015 * std::exp(-0.3 * t) * std::sinh(b * t) / b;
}

struct Text {
  const char *instant, *text;
};

}  // namespace

SourceOscillatorRow oscillator_row_of_source(int i) {
  constexpr double dt = 0.5;
  double x = 0, v = 0.015, a = 0;
  for (int row = 0;; ++row) {
    a = -0.6 * v - 0.04 * x;
    if (row == i) break;
    x += v * dt, v += a * dt;
  }
  const double analytic = constant * std::pow(e, -0.3 * i) * (std::pow(e, beta * i) - std::pow(e, -beta * i));
  return {a, v, x, analytic, i == 0 ? 0 : (analytic - x) / x};
}

SourcePendulumRow pendulum_row_of_source(int i) { return pendulum_row(i, typed, -1); }

std::vector<Printed> printed_by_the_source() {
  std::vector<Printed> all{
      {"oscillator.alpha", "0.3", "closed form"},
      {"oscillator.beta", "0.22", "closed form"},
      {"oscillator.two_beta", "0.44", "closed form", 0,
       Explanation{{"twice the rounded β = 0.22", "il doppio di β arrotondato a 0,22"}, [] { return 2 * beta; }}}};
  const auto each = [&](const std::string& of, const std::string& route, const std::vector<Text>& texts,
                        const Words& why,
                        const std::function<std::function<double()>(const std::string&)>& evaluate) {
    for (const Text& at : texts)
      all.push_back({of + "_at_" + at.instant, at.text, route, 0, Explanation{why, evaluate(at.instant)}});
  };
  const auto row_of = [](const std::string& name, int rows_in_second) {
    return static_cast<int>(std::lround(CGAL::to_double(instant(name)) * rows_in_second));
  };
  const auto oscillator = [&](double SourceOscillatorRow::*column, int rows_in_second) {
    return [=](const std::string& at) {
      const int row = row_of(at, rows_in_second);
      return [=] { return oscillator_row_of_source(row).*column; };
    };
  };
  each("oscillator.x", "closed form",
       {{"1", "0,011"},  {"2", "0,017"},  {"3", "0,020"},  {"4", "0,021"},  {"5", "0,020"},  {"6", "0,020"},
        {"7", "0,019"},  {"8", "0,017"},  {"9", "0,016"},  {"10", "0,015"}, {"11", "0,014"}, {"12", "0,013"},
        {"13", "0,012"}, {"14", "0,011"}, {"15", "0,010"}, {"16", "0,009"}, {"17", "0,009"}, {"18", "0,008"},
        {"19", "0,007"}, {"20", "0,007"}, {"25", "0,005"}, {"30", "0,003"}, {"35", "0,002"}, {"40", "0,001"}},
       rounded_constants, oscillator(&SourceOscillatorRow::analytic, 1));
  each("oscillator.x_euler", "recursion",
       {{"0p5", "0,008"}, {"1", "0,013"},  {"2", "0,019"},  {"3", "0,021"},  {"4", "0,022"},  {"5", "0,021"},
        {"6", "0,020"},   {"7", "0,019"},  {"8", "0,018"},  {"9", "0,016"},  {"10", "0,015"}, {"11", "0,014"},
        {"12", "0,013"},  {"13", "0,012"}, {"14", "0,011"}, {"15", "0,010"}, {"16", "0,010"}, {"17", "0,009"},
        {"18", "0,008"},  {"19", "0,008"}, {"20", "0,007"}},
       {}, oscillator(&SourceOscillatorRow::x, 2));
  each("oscillator.x_dot_euler", "recursion",
       {{"0p5", "0,011"}, {"1", "0,007"}, {"2", "0,003"}, {"5", "-0,001"}, {"10", "-0,001"}, {"20", "-0,001"}}, {},
       oscillator(&SourceOscillatorRow::x_dot, 2));
  each("oscillator.x_ddot_euler", "recursion",
       {{"0", "-0,009"},
        {"0p5", "-0,007"},
        {"1", "-0,005"},
        {"2", "-0,003"},
        {"5", "0,000"},
        {"10", "0,000"},
        {"20", "0,000"}},
       {}, oscillator(&SourceOscillatorRow::x_ddot, 2));
  each("oscillator.err_euler", "recursion",
       {{"0p5", "0,495"}, {"1", "0,334"}, {"2", "0,094"}, {"5", "-0,283"}, {"10", "-0,551"}, {"20", "-0,804"}},
       shifted_rows, oscillator(&SourceOscillatorRow::error, 2));
  const auto pendulum = [&](double SourcePendulumRow::*column) {
    return [=](const std::string& at) {
      const int row = row_of(at, 100);
      return [=] { return pendulum_row_of_source(row).*column; };
    };
  };
  each("pendulum.theta", "recursion",
       {{"0", "1,571"},
        {"0p01", "1,549"},
        {"0p1", "1,175"},
        {"0p2", "0,423"},
        {"0p3", "-0,505"},
        {"0p4", "-1,289"},
        {"0p5", "-1,720"},
        {"0p6", "-1,763"},
        {"0p7", "-1,420"},
        {"0p8", "-0,696"},
        {"0p9", "0,283"},
        {"1", "1,197"}},
       another_start, pendulum(&SourcePendulumRow::theta));
  each("pendulum.theta_dot", "recursion",
       {{"0", "-2,200"},
        {"0p1", "-6,059"},
        {"0p2", "-8,971"},
        {"0p3", "-8,998"},
        {"0p4", "-6,049"},
        {"0p5", "-2,165"},
        {"0p6", "1,680"},
        {"0p7", "5,577"},
        {"0p8", "9,043"},
        {"0p9", "10,034"},
        {"1", "7,555"}},
       another_start, pendulum(&SourcePendulumRow::theta_dot));
  each("pendulum.theta_ddot", "recursion",
       {{"0", "-39,240"},
        {"0p1", "-36,213"},
        {"0p2", "-16,103"},
        {"0p3", "18,986"},
        {"0p4", "37,688"},
        {"0p5", "38,806"},
        {"0p6", "38,519"},
        {"0p7", "38,795"},
        {"0p8", "25,167"},
        {"0p9", "-10,940"},
        {"1", "-36,528"}},
       another_start, pendulum(&SourcePendulumRow::theta_ddot));
  each("pendulum.R_12_x", "recursion",
       {{"0", "-1,208"},
        {"0p1", "-11,958"},
        {"0p2", "-11,929"},
        {"0p3", "13,948"},
        {"0p4", "11,410"},
        {"0p5", "-0,281"},
        {"0p6", "-1,145"},
        {"0p7", "9,146"},
        {"0p8", "17,940"},
        {"0p9", "-9,643"},
        {"1", "-16,620"}},
       another_start, pendulum(&SourcePendulumRow::R_x));
  each("pendulum.R_12_y", "recursion",
       {{"0", "39,240"},
        {"0p1", "37,160"},
        {"0p2", "29,048"},
        {"0p3", "29,038"},
        {"0p4", "37,453"},
        {"0p5", "39,630"},
        {"0p6", "39,732"},
        {"0p7", "38,293"},
        {"0p8", "29,329"},
        {"0p9", "24,116"},
        {"1", "35,336"}},
       wrong_sign, pendulum(&SourcePendulumRow::R_y));
  all.push_back({"pendulum.theta_dot_max", "10,136", "recursion", 0,
                 Explanation{another_start, [] { return pendulum_row_of_source(88).theta_dot; }}});
  all.push_back({"pendulum.R_12_y_at_bottom", "26,797", "recursion", 0,
                 Explanation{wrong_sign, [] { return pendulum_row_of_source(25).R_y; }}});
  for (Printed& printed : all) {
    if (!printed.explanation || !printed.explanation->sentence.empty()) continue;
    printed.explanation.reset();
    if (printed.quantity == "oscillator.x_euler_at_0p5")
      printed.explanation = Explanation{
          {"exactly midway, 0.0075 m: rounded up", "esattamente a metà, 0,0075 m: arrotondato per eccesso"},
          [] { return std::round(1000 * 0.015 * 0.5) / 1000; }};
  }
  return all;
}

namespace {

using Mistakes = std::vector<PrintedColumn::Mistake>;

TableAudit oscillator_audit() {
  const auto printed = read_printed_table(printed_oscillator_table);
  const std::size_t n = printed.size();
  const auto of_source = [](double SourceOscillatorRow::*part) {
    return [part](int i) { return oscillator_row_of_source(i).*part; };
  };
  const auto scheme = [&](std::size_t place, const std::string& name, double SourceOscillatorRow::*part) {
    return PrintedColumn{name, column_of(printed, place), column(n, of_source(part)), {}};
  };
  const auto error = [&](int i) { return i == 0 ? 0 : oscillator_row_of_source(i).x / exact_x(0.5 * i) - 1; };
  return audit({"oscillator, 41 rows", "oscillatore, 41 righe"}, column_of(printed, 0),
               {scheme(2, "x_ddot_euler", &SourceOscillatorRow::x_ddot),
                scheme(3, "x_dot_euler", &SourceOscillatorRow::x_dot),
                scheme(4, "x_euler", &SourceOscillatorRow::x),
                {"x",
                 column_of(printed, 6),
                 column(n, [](int i) { return exact_x(i); }),
                 {{rounded_constants, column(n, of_source(&SourceOscillatorRow::analytic))}}},
                {"err_euler",
                 column_of(printed, 7),
                 column(n, error),
                 {{shifted_rows, column(n, of_source(&SourceOscillatorRow::error))}}}});
}

TableAudit pendulum_audit() {
  const auto printed = read_printed_table(printed_pendulum_table);
  const std::size_t n = printed.size();
  const auto values = [&](double SourcePendulumRow::*part, const FirstAngles& start, int sign) {
    return column(n, [=](int i) { return pendulum_row(i, start, sign).*part; });
  };
  const auto whole = [&](std::size_t place, const std::string& name, double SourcePendulumRow::*part,
                         const Words& why) {
    return PrintedColumn{name, column_of(printed, place), values(part, at_rest, 1),
                         Mistakes{{why, values(part, typed, -1)}}};
  };
  return audit({"pendulum, 101 rows, against the recursion from rest",
                "pendolo, 101 righe, contro la formula ricorsiva dalla quiete"},
               column_of(printed, 0),
               {whole(2, "theta", &SourcePendulumRow::theta, another_start),
                whole(3, "theta_dot", &SourcePendulumRow::theta_dot, another_start),
                whole(4, "theta_ddot", &SourcePendulumRow::theta_ddot, another_start),
                whole(5, "R_12_x", &SourcePendulumRow::R_x, another_start),
                whole(6, "R_12_y", &SourcePendulumRow::R_y, wrong_sign)});
}

}  // namespace

std::vector<TableAudit> audited_tables() { return {oscillator_audit(), pendulum_audit()}; }

}  // namespace epure::oscillator_pendulum
