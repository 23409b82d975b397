// What the source printed: thrusts in tonnes-force, here in newtons, with as many digits.
#include <cmath>

#include "exercises/kit/statement/decimal.h"
#include "exercises/michell-thrust/exercise.h"

namespace epure::michell_thrust {
namespace {

// The source's numbers.
namespace stated {
constexpr double R_m = 0.825, d = 0.05, b = 0.55, N_p = 70, l = 0.4681, newtons_in_tonne = 9806.65,
                 pi = 3.14159265358979324;
}

Printed plain(const std::string& quantity, const std::string& text) { return {quantity, text, "closed form"}; }
Printed wrong(const std::string& quantity, const std::string& text, const Words& why,
              std::function<double()> mistake) {
  return {quantity, text, "closed form", 0, Explanation{why, std::move(mistake)}};
}

// What gives both films to their last digit: the pad with π = 3.14, the load on c·b = 0.195 m; and g is 9.81 in the
// viscosity, 9.80665 in the load.
double film_of_the_source() { return stated::l * std::sqrt(0.156 * 0.0035 * 9.81 * 6.479 / (358974 * 9.80665)); }
Words other_film() {
  return {
      "with the mistaken N of 358.974 t/m, l = 0.4681 m (π taken as 3.14), and g = 9.81 m/s² in the viscosity but "
      "9.80665 m/s² in the load",
      "con l'N sbagliato di 358,974 t/m, l = 0,4681 m (π = 3,14), e g = 9,81 m/s² nella viscosità ma 9,80665 m/s² "
      "nel carico"};
}

// x_N/l by the closed form, of the logarithm that is given.
double centre(double n, double ln) {
  return (1 + 4 * n - 5 * n * n + 2 * n * (n + 2) * ln) / ((n * n - 1) * ln - 2 * (n - 1) * (n - 1)) / 2;
}
// Of the table. Near n = 1 the closed form cancels, and asks for more digits of the logarithm than were taken.
Printed printed_centre(const std::string& quantity, const std::string& text, double n) {
  if (n == 2.2)
    return wrong(quantity, text, {"0.5779, cut off instead of rounded", "0,5779, troncato anziché arrotondato"},
                 [=] { return std::floor(1000 * centre(n, std::log(n))) / 1000; });
  if (n == 2.0)
    return wrong(quantity, text,
                 {"two neighbouring digits of ln 2 exchanged, 0.693174 for 0.693147 (a conjecture): the row's A and "
                  "k stay right so, as they hardly depend on it",
                  "due cifre vicine di ln 2 scambiate, 0,693174 per 0,693147 (una congettura): A e k della riga "
                  "restano giusti così, perché ne dipendono appena"},
                 [=] { return centre(n, 0.693174); });
  return wrong(quantity, text,
               {"the natural logarithm was taken as 2.3026 times the decimal one (a conjecture): the closed form "
                "cancels for small n, and the fifth digit counts (the column's other values, but for n = 2.0 and "
                "2.2, stay right so). Or numerator and denominator were rounded to four decimals",
                "il logaritmo naturale preso come 2,3026 volte il decimale (una congettura): la formula chiusa per n "
                "piccoli si cancella, e la quinta cifra conta (gli altri valori della colonna, tranne n = 2,0 e 2,2, "
                "restano giusti così). Oppure numeratore e denominatore arrotondati a quattro decimali"},
               [=] { return centre(n, 2.3026 * std::log10(n)); });
}

Printed of_table(const TableRow& row, const TableRow::Column& column) {
  const std::string quantity = "table_n_" + row.name + "." + column.name;
  if (column.name == std::string("x_N_over_l")) return printed_centre(quantity, column.text, nearest(row.n));
  if (quantity == "table_n_1_8.A_n_minus_1_squared")
    return wrong(quantity, column.text, {"A was rounded to 0.1534 before", "A era già arrotondato a 0,1534"},
                 [] { return 0.1534 * 0.8 * 0.8; });
  return plain(quantity, column.text);
}

}  // namespace

std::vector<Printed> printed_by_the_source() {
  std::vector<Printed> all{
      plain("R_m", "0.825"),
      wrong("v", "6.479", {"cut off instead of rounded", "cifre troncate anziché arrotondate"},
            [] { return std::floor(1000 * stated::R_m * 75 * 2 * stated::pi / 60) / 1000; }),
      plain("b", "0.55"),
      wrong("l", "2.542",
            {"as printed: half the mean circle less d, instead of a tenth of it",
             "come stampato: mezza circonferenza media meno d, anziché un decimo"},
            [] { return 2 * stated::pi * stated::R_m / 2 - stated::d; }),
      plain("N_p", "686.5e3"),
      wrong("c", "0.355", {"1 was read for l: b/(b + 1)", "1 letto al posto di l: b/(b + 1)"},
            [] { return stated::b / (stated::b + 1); }),
      wrong("N", "3.52034e6",
            {"358.974 t/m are 70 t over c·b = 0.195 m, with the mistaken c = 0.355",
             "358,974 t/m sono 70 t diviso c·b = 0,195 m, con il c = 0,355 sbagliato"},
            [] { return stated::N_p * stated::newtons_in_tonne / 0.195; }),
      plain("n", "1.9"),
      plain("A", "0.156"),
      plain("A_n_minus_1_squared", "0.126"),
      wrong("k", "1.98", {"1.985, cut off instead of rounded", "1,985, troncato anziché arrotondato"},
            [] { return std::floor(100 * (2.03 + 1.94) / 2) / 100; }),
      wrong("h_2", "46.476e-6", other_film(), film_of_the_source),
      wrong("h_1", "88.305e-6", other_film(), [] { return 1.9 * film_of_the_source(); }),
      wrong("alpha_deg", "9e-7",
            {"l was taken in centimetres, the films in metres, and the radians that came out called degrees (a "
             "conjecture)",
             "l preso in centimetri, gli spessori in metri, e i radianti ottenuti detti gradi (una congettura)"},
            [] { return (88.305e-6 - 46.476e-6) / (100 * stated::l); }),
      wrong("c_prime", "2.09865",
            {"with l = 0.4681 m (π taken as 3.14), and cut off", "con l = 0,4681 m (π = 3,14), e troncato"},
            [] { return std::floor(1e5 * std::sqrt((4 * stated::l + stated::b) / stated::b)) / 1e5; })};
  for (const TableRow& row : table_1())
    for (const TableRow::Column& column : row.printed) all.push_back(of_table(row, column));
  return all;
}

}  // namespace epure::michell_thrust
