#include "exercises/gear-pair/problem.h"

#include <fmt/format.h>

#include "exercises/kit/statement/decimal.h"
#include "geometry/gears/pressure_angle.h"
#include "geometry/numbers/climb.h"

namespace epure::gear_pair {
namespace {

using geometry::PairData;
using geometry::PairKind;

GivenSpec profile(const std::string& symbol, const Words& meaning, const std::string& stated, Range range,
                  const std::string& letters) {
  return {symbol, meaning, "1", stated, range, letters, {}, symbol != "ha" && symbol != "hf" && symbol != "rho"};
}

constexpr long fewest_teeth = 3, most_teeth = 1'000'000;

long teeth(const Givens& givens, const std::string& symbol) {
  const Rational& z = givens[symbol];
  if (z.denominator() != 1 || z < fewest_teeth || z > most_teeth)
    throw BadGivens(format_words("{} = {}: teeth are counted, a whole number from {} to {}",
                                 "{} = {}: i denti si contano, un numero intero da {} a {}", symbol,
                                 givens.text(symbol), fewest_teeth, most_teeth));
  return mpz_get_si(z.numerator().mpz());
}

// A profile of more than ten modules is none.
Rational factor(const Givens& givens, const std::string& symbol) {
  const Rational& value = givens[symbol];
  if (CGAL::abs(value) > 10)
    throw BadGivens(format_words("{} = {}: no more than 10 times the module",
                                 "{} = {}: non più di 10 volte il modulo", symbol, givens.text(symbol)));
  return value;
}

PairKind kind_of(const Givens& givens) {
  const std::string& word = givens.chosen("kind").word;
  if (word == "internal") return PairKind::internal;
  return word == "rack" ? PairKind::rack : PairKind::external;
}

void require_wheels(const PairData& of, const Givens& givens) {
  require(of.kind != PairKind::internal || of.z2 > of.z1,
          format_words("z2 = {}: a ring has more teeth than the wheel inside it, z1 = {}",
                       "z2 = {}: una corona ha più denti della ruota al suo interno, z1 = {}", of.z2, of.z1));
  require(of.kind != PairKind::rack || of.x2 == 0,
          format_words("x2 = {}: a rack is not shifted, wheel 1 is (x1)",
                       "x2 = {}: una dentiera non si corregge, si corregge la ruota 1 (x1)", givens.text("x2")));
  require(of.ha + of.hf > of.k,
          format_words("k = {}: shortened by their whole height, ha + hf = {}, the teeth vanish",
                       "k = {}: accorciati di tutta la loro altezza, ha + hf = {}, i denti spariscono",
                       givens.text("k"), decimal(nearest(of.ha + of.hf), 6)));
  const auto radius = [](const Rational& r) { return decimal(1000 * nearest(r), 6); };
  const geometry::WheelData wheel1 = geometry::first_wheel(of);
  require(
      wheel1.r_root > 0,
      format_words("the teeth of wheel 1 are cut down beyond its centre: root radius {} mm, must be positive",
                   "i denti della ruota 1 sono tagliati oltre il centro: raggio di piede {} mm, dev'essere positivo",
                   radius(wheel1.r_root)));
  if (of.kind == PairKind::rack) return;
  const geometry::WheelData wheel2 = geometry::second_wheel(of);
  const Rational& inner = wheel2.ring ? wheel2.r_tip : wheel2.r_root;
  const Words beyond =
      wheel2.ring
          ? Words{"reach beyond its centre: tip radius", "superano il centro: raggio di testa"}
          : Words{"are cut down beyond its centre: root radius", "sono tagliati oltre il centro: raggio di piede"};
  require(inner > 0, format_words("the teeth of wheel 2 {} {} mm, must be positive",
                                  "i denti della ruota 2 {} {} mm, dev'essere positivo", beyond, radius(inner)));
}

// inv α + 2 tan α shift_per_tooth is never exactly zero: π is not algebraic.
void require_working_angle(const PairData& of) {
  const Rational shift = geometry::shift_per_tooth(of);
  if (shift >= 0) return;
  const geometry::Decision room = geometry::decide([&]<class T>() -> T {
    const geometry::PressureAngle<T> alpha = geometry::pressure_angle<T>(of.alpha);
    return geometry::involute(alpha.tangent) + geometry::from_rational<T>(2 * shift) * alpha.tangent;
  });
  require(room.sign == geometry::Sign::positive,
          format_words("x1 = {}, x2 = {}: shifted so far towards each other the wheels have no working pressure "
                       "angle: inv α + 2·tan α·({}) must be positive",
                       "x1 = {}, x2 = {}: corrette tanto l'una verso l'altra le ruote non hanno angolo di pressione "
                       "di lavoro: inv α + 2·tg α·({}) dev'essere positivo",
                       decimal(nearest(of.x1), 6), decimal(nearest(of.x2), 6),
                       std::string(of.kind == PairKind::internal ? "x2 - x1)/(z2 - z1" : "x1 + x2)/(z1 + z2")));
}

}  // namespace

std::vector<GivenSpec> givens() {
  return {
      {"m", {"module", "modulo"}, "mm", "10", Range::positive, "$m$"},
      {"z1",
       {"teeth of wheel 1, which drives", "denti della ruota 1, motrice"},
       "1",
       "20",
       Range::positive,
       "$z_{1}$"},
      {"z2", {"teeth of wheel 2", "denti della ruota 2"}, "1", "40", Range::positive, "$z_{2}$"},
      {"alpha", {"pressure angle", "angolo di pressione"}, "deg", "22", Range::positive, "$α$"},
      profile("x1", {"profile shift of wheel 1, over m", "spostamento del profilo della ruota 1, su m"}, "0",
              Range::any, "$x_{1}$"),
      profile("x2", {"profile shift of wheel 2, over m", "spostamento del profilo della ruota 2, su m"}, "0",
              Range::any, "$x_{2}$"),
      profile("ha", {"addendum of the rack, over m", "addendum della dentiera, su m"}, "1", Range::positive,
              "$h_{a}^{*}$"),
      profile("hf", {"dedendum of the rack, over m", "dedendum della dentiera, su m"}, "1.25", Range::positive,
              "$h_{f}^{*}$"),
      profile("k", {"shortening of the tips, over m", "raccorciamento delle teste, su m"}, "0", Range::any, "$k$"),
      profile("rho", {"rounding of the cutter's tip, over m", "raccordo di testa dell'utensile, su m"}, "0.25",
              Range::not_negative, "$ρ^{*}$"),
      {"j",
       {"backlash on the pitch circles", "gioco sulle primitive"},
       "mm",
       "0",
       Range::not_negative,
       "$j$",
       {},
       true},
      {"n1", {"speed of wheel 1", "velocità della ruota 1"}, "rpm", "150", Range::positive, "$n_{1}$"},
      {.symbol = "kind",
       .meaning = {"kind of pair", "tipo di coppia"},
       .unit = "1",
       .stated = "external",
       .range = Range::any,
       .letters = {},
       .choices = {{"external", {"external wheels", "ruote esterne"}},
                   {"internal", {"wheel 2 is a ring", "la ruota 2 è interna"}},
                   {"rack", {"wheel 2 is a rack", "la ruota 2 è una dentiera"}}},
       .beyond_source = true}};
}

PairData pair_of(const Givens& givens) {
  const Angle alpha = givens.angle("alpha"), degree{Rational(1, 360)};
  require(sign_of(alpha - degree) >= 0 && sign_of(alpha - Rational(75) * degree) <= 0,
          format_words("alpha = {} {}: must lie between 1 and 75 deg", "alpha = {} {}: dev'essere tra 1 e 75 deg",
                       givens.text("alpha"), givens.reading("alpha")->unit.symbol));
  const PairKind kind = kind_of(givens);
  const PairData of{.kind = kind,
                    .z1 = teeth(givens, "z1"),
                    .z2 = kind == PairKind::rack ? 0 : teeth(givens, "z2"),
                    .m = givens["m"] / 1000,
                    .alpha = alpha,
                    .x1 = factor(givens, "x1"),
                    .x2 = factor(givens, "x2"),
                    .ha = factor(givens, "ha"),
                    .hf = factor(givens, "hf"),
                    .k = factor(givens, "k"),
                    .rho = factor(givens, "rho"),
                    .j = givens["j"] / 1000};
  require(of.j <= 3 * of.m,
          format_words("j = {} mm: a backlash of more than three modules leaves no tooth",
                       "j = {} mm: un gioco di più di tre moduli non lascia dente", givens.text("j")));
  require_wheels(of, givens);
  require_working_angle(of);
  return of;
}

}  // namespace epure::gear_pair
