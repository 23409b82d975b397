// What the source printed. Its polygon at maximum lift is that of the drawn position again.
#include <cmath>

#include "exercises/cam-dynamics/exercise.h"

namespace epure::cam_dynamics {
namespace {

// Of the source, as it rounded them.
constexpr double omega = 5.24, v_B3 = 0.14, v_B32 = 0.85, AB = 0.15, m_3 = 1.9, P_2 = 21.6, P_3 = 18.6;
constexpr double fast = 36.6, fast_v_B32 = 5.87;

double drawn_A0B() {
  const double angle = 21 * M_PI / 180, x = 0.0486, d = x - 0.03 * std::cos(angle);
  return std::hypot(x, 0.03 * std::sin(angle) + std::sqrt(AB * AB - d * d));
}
double speed_cut_off() { return std::floor(10 * 2 * M_PI * 350 / 60) / 10; }
// The sides of the drawn position with the printed speeds, along AB: A₀B stands at 9.06° to it.
double rest_along_AB() {
  const double angle = 21 * M_PI / 180, x = 0.0486, d = x - 0.03 * std::cos(angle);
  const double lean = std::asin(x / drawn_A0B()) - std::asin(d / AB);
  return fast * fast * drawn_A0B() * std::cos(lean) + fast_v_B32 * fast_v_B32 / AB - 2 * fast * fast_v_B32;
}

// v_B32 of the drawn position: A₀ from P₂₃ to B, square to AB.
double read_short() {
  const double angle = 21 * M_PI / 180, x_A = 0.03 * std::cos(angle), y_A = 0.03 * std::sin(angle), x = 0.0486,
               y = y_A + std::sqrt(AB * AB - (x - x_A) * (x - x_A)), P23 = x_A - y_A * (x - x_A) / (y - y_A);
  const double true_speed = 2 * M_PI * 350 / 60 * std::hypot(x - P23, y), mm = 6.11 / 80;
  return true_speed - mm / 3;
}

Explanation chain(const std::string& english, const std::string& italian, double value) {
  return {{english, italian}, [value] { return value; }};
}

const Words drawn_again{
    "the polygon is that of the drawn position at 350 rpm: at maximum lift A₀, A and B are in line, and v_B3 is zero",
    "il poligono è quello della configurazione disegnata a 350 giri/1': alla massima alzata A₀, A e B sono "
    "allineati, e v_B3 è nulla"};

}  // namespace

std::vector<Printed> printed_by_the_source() {
  const std::string polar = "polar diagram", bodies = "free bodies", lift = "maximum_lift.";
  // On a sheet where A₀B is some 8 cm long and the longest velocity as much, half a millimetre is this part of it.
  constexpr double part = 0.5 / 80, of_v = part * 0.88, of_a = part * 8.91, of_R = part * 89;
  return {
      {"omega_2", "5.24", "analytic"},
      {"v_B3", "0.14", polar, of_v},
      {"v_B2", "0.88", polar, of_v},
      {"v_B32", "0.85", polar, of_v},
      {"v_A_y", "0.15", "analytic"},
      {"a_B3", "0.45", polar, of_a},
      {"a_B2", "4.58", polar, of_a},
      {"a_B32_n", "4.82", polar, 0,
       chain("v_B32 was read as 0.85 m/s: 0.85²/0.15", "v_B32 è stata letta 0,85 m/s: 0,85²/0,15",
             v_B32 * v_B32 / AB)},
      {"a_B32_t", "0.73", polar, of_a},
      {"a_coriolis", "8.91", polar, 0,
       chain("v_B32 was read as 0.85 m/s: 2 · 5.24 · 0.85", "v_B32 è stata letta 0,85 m/s: 2 · 5,24 · 0,85",
             2 * omega * v_B32)},
      {"P_3", "18.6", bodies},
      {"P_2", "21.6", bodies},
      {"F_3_in", "0.86", bodies, 0,
       chain("a_B3 was read as 0.45 m/s²: 1.9 · 0.45 = 0.855, rounded up",
             "a_B3 è stata letta 0,45 m/s²: 1,9 · 0,45 = 0,855, arrotondato per eccesso",
             std::round(100 * m_3 * 0.45) / 100)},
      {"F_2_in", "1.8", bodies},
      {"R_13", "9.4", bodies, of_R},
      {"R_23", "68.4", bodies, of_R},
      {"R_12", "89", bodies, of_R},
      {"d_2", "0.028", bodies},
      {"d_32", "0.027", bodies, part * 0.167},
      {"M_m", "2.45", bodies, 0,
       chain("from rounded and read numbers: 21.6 · 0.028 + 68.4 · 0.027",
             "da numeri arrotondati e letti: 21,6 · 0,028 + 68,4 · 0,027", P_2 * 0.028 + 68.4 * 0.027)},
      {"M_m_virtual_work", "2.5", "virtual work", 0,
       chain("rounded numbers, and forces of inertia that do work by the other body's velocity, F₃ by v_Ay and F₂ by "
             "v_B: (50 · 0.14 + 18.6 · 0.14 + 21.6 · 0.15 + 0.86 · 0.15 + 1.8 · 0.14)/5.24. F₂ does none, it points "
             "away from A₀; F₃ acts upwards, against P",
             "numeri arrotondati, e forze d'inerzia che lavorano con la velocità dell'altro membro, F₃ con v_Ay e F₂ "
             "con v_B: (50 · 0,14 + 18,6 · 0,14 + 21,6 · 0,15 + 0,86 · 0,15 + 1,8 · 0,14)/5,24. F₂ non lavora, è "
             "diretta da A₀; F₃ agisce verso l'alto, contro P",
             (50 * v_B3 + P_3 * v_B3 + P_2 * 0.15 + 0.86 * 0.15 + 1.8 * v_B3) / omega)},
      {lift + "omega_2", "36.6", "analytic", 0,
       Explanation{{"36.65 was cut off, not rounded", "36,65 è stato troncato, non arrotondato"}, speed_cut_off}},
      {lift + "v_B3", "0.98", polar, 0, Explanation{drawn_again, [] { return 7 * v_B3; }}},
      {lift + "v_B2", "6.11", polar, 0, Explanation{drawn_again, [] { return 2 * M_PI * 350 / 60 * drawn_A0B(); }}},
      {lift + "v_B32", "5.87", polar, 0,
       Explanation{
           drawn_again + Words{". There it is 5.90 m/s, read a third of a millimetre short where 6.11 m/s are 80 mm",
                               ". Lì vale 5,90 m/s, letta un terzo di millimetro in meno dove 6,11 m/s sono 80 mm"},
           read_short}},
      {lift + "a_B3", "20", polar, 0,
       Explanation{
           drawn_again + Words{" (a conjecture: with the printed speeds what closes it along AB is 20.4)",
                               " (una congettura: con le velocità stampate ciò che lo chiude lungo AB è 20,4)"},
           rest_along_AB}},
      {lift + "a_B2", "200.9", polar, 0,
       chain("36.6² · 0.15: the length of AB was taken for that of A₀B",
             "36,6² · 0,15: la lunghezza di AB è stata presa per quella di A₀B", fast * fast * AB)},
      {lift + "a_B32_n", "229.7", polar, 0,
       chain("5.87²/0.15, with the v_B32 of the drawn position",
             "5,87²/0,15, con la v_B32 della configurazione disegnata", fast_v_B32 * fast_v_B32 / AB)},
      {lift + "a_coriolis", "429.7", polar, 0,
       chain("2 · 36.6 · 5.87, with the v_B32 of the drawn position",
             "2 · 36,6 · 5,87, con la v_B32 della configurazione disegnata", 2 * fast * fast_v_B32)},
      {lift + "P_3", "18.6", bodies},
      {lift + "F_3_in", "38", bodies, 0,
       chain("1.9 · 20, with the acceleration of the drawn position",
             "1,9 · 20, con l'accelerazione della configurazione disegnata", m_3 * 20)},
      {lift + "P_min", "19.4", bodies, 0,
       chain("38 - 18.6: the force of inertia is that of the drawn position, at 350 rpm. At maximum lift the "
             "follower is accelerated downwards with 50.2 m/s², not 20, and without 76.8 N it leaves the cam",
             "38 - 18,6: la forza d'inerzia è quella della configurazione disegnata, a 350 giri/1'. Alla massima "
             "alzata il cedente ha verso il basso 50,2 m/s², non 20, e senza 76,8 N lascia la camma",
             m_3 * 20 - P_3)}};
}

}  // namespace epure::cam_dynamics
