#include "exercises/kit/linkages/loaded_mechanisms.h"

#include "exercises/kit/statement/given_number.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "geometry/numbers/climb.h"

namespace epure {
namespace {

using geometry::Sign;

// The givens of one mechanism under its name.
class Part {
 public:
  Part(std::string mechanism, Words of) : before_(std::move(mechanism) + "."), of_(std::move(of)) {}

  Part& length(const std::string& symbol, const std::string& letters, const Words& meaning, const std::string& stated,
               Range range = Range::positive) {
    return add(symbol, letters, meaning, "m", stated, range);
  }
  Part& force(const std::string& symbol, const Words& meaning, const std::string& stated) {
    return add(symbol, "$\\it{" + symbol + "}$", meaning, "N", stated, Range::positive);
  }
  Part& angle(const std::string& symbol, const std::string& letters, const Words& meaning,
              const std::string& stated) {
    return add(symbol, letters, meaning, "deg", stated, Range::any);
  }
  const std::vector<GivenSpec>& givens() const { return givens_; }

 private:
  Part& add(const std::string& symbol, const std::string& letters, const Words& meaning, const std::string& unit,
            const std::string& stated, Range range) {
    givens_.push_back({before_ + symbol, meaning + of_, unit, stated, range, letters});
    return *this;
  }

  std::string before_;
  Words of_;
  std::vector<GivenSpec> givens_;
};

Part wedge_givens() {
  return Part("wedge_collar", {", wedge and collar", ", cuneo e collare"})
      .force("Q", {"load on the rod", "carico sull'asta"}, "200")
      .angle("theta", "$θ$", {"angle of the wedge", "angolo del cuneo"}, "41")
      .length("w", "$w$", {"width of the rod", "larghezza dell'asta"}, "0.025")
      .length("y_lower", "$y_{l}$", {"lower end of the collar", "estremo inferiore del collare"}, "0.035", Range::any)
      .length("y_upper", "$y_{u}$", {"upper end of the collar", "estremo superiore del collare"}, "0.120",
              Range::any);
}

Part double_slider_givens() {
  return Part("double_slider", {", double slider", ", doppio pattino"})
      .force("Q", {"load on slider 2", "carico sul pattino 2"}, "150")
      .angle("theta", "$θ$", {"angle of the link with the guide of P", "angolo dell'asta con la guida di P"}, "69")
      .length("l", "$l$", {"length of the link AB", "lunghezza dell'asta AB"}, "0.30");
}

struct StatedLevers {
  std::string x_Q, x_C, y_C, arm_P, r_2, r_3, nu, direction_Q, direction_P;
};
Part levers_givens(const std::string& name, const Words& of, const StatedLevers& stated) {
  return Part(name, of)
      .force("Q", {"load", "carico"}, "230")
      .length("x_Q", "$x_{Q}$",
              {"where the line of Q meets the line of hinges y = 0",
               "dove la retta di Q incontra la retta delle cerniere y = 0"},
              stated.x_Q, Range::any)
      .angle("direction_Q", "$δ_{Q}$", {"direction of Q from +x", "direzione di Q da +x"}, stated.direction_Q)
      .length("A0B0", "$A_{0}B_{0}$", {"distance of the hinges", "distanza delle cerniere"}, "0.35")
      .length("x_C", "$x_{C}$", {"abscissa of the contact C", "ascissa del contatto C"}, stated.x_C, Range::any)
      .length("y_C", "$y_{C}$", {"ordinate of the contact C", "ordinata del contatto C"}, stated.y_C, Range::any)
      .angle("nu", "$ν$",
             {"direction of the contact's force on the lever that Q loads, from +x",
              "direzione della forza di contatto sulla leva caricata da Q, da +x"},
             stated.nu)
      .angle("direction_P", "$δ_{P}$", {"direction of P from +x", "direzione di P da +x"}, stated.direction_P)
      .length("arm_P", "$b_{P}$",
              {"arm of P about its lever's hinge, counter-clockwise positive",
               "braccio di P rispetto alla cerniera della sua leva, positivo antiorario"},
              stated.arm_P, Range::any)
      .length("r_2", "$r_{2}$", {"radius of the profile of lever 2", "raggio del profilo della leva 2"}, stated.r_2)
      .length("r_3", "$r_{3}$", {"radius of the profile of lever 3", "raggio del profilo della leva 3"}, stated.r_3);
}
Part levers_givens() {
  return levers_givens("sliding_levers", {", sliding levers with Q on 3", ", leve striscianti con Q sulla 3"},
                       {"0.122", "0.191", "0.042", "0.112", "0.060", "0.050", "73", "-90", "11.5"});
}
Part levers_Q_on_2_givens() {
  return levers_givens("sliding_levers_Q_on_2", {", sliding levers with Q on 2", ", leve striscianti con Q sulla 2"},
                       {"0.365", "0.125", "0.041", "-0.228", "0.050", "0.060", "108.5", "-120", "97.5"});
}

Part fairbairn_givens(const std::string& name, const Words& of, const std::string& AC, const std::string& theta,
                      const std::string& CD) {
  return Part(name, of)
      .force("F", {"force on the ram", "forza sulla slitta"}, "50")
      .length("AB", "$AB$", {"crank AB", "manovella AB"}, "0.20")
      .length("AC", "$AC$", {"distance of the hinges A and C", "distanza delle cerniere A e C"}, AC)
      .angle("theta", "$θ$", {"angle of the lever from CA, clockwise", "angolo della leva da CA, orario"}, theta)
      .length("CD", "$CD$", {"length CD of the lever", "lunghezza CD della leva"}, CD);
}
Part fairbairn_givens() {
  return fairbairn_givens("fairbairn", {", Fairbairn's mechanism", ", guida di Fairbairn"}, "0.449", "23", "0.95");
}
Part short_fairbairn_givens() {
  return fairbairn_givens("fairbairn_short_lever",
                          {", Fairbairn's mechanism with a shorter lever", ", guida di Fairbairn con leva più corta"},
                          "0.423", "23.5", "0.714");
}

// In degrees, for a message.
constexpr int quarters_in_a_turn = 4;
Angle right_angle() { return {Rational(1, quarters_in_a_turn)}; }

// Strictly between 0 and a right angle.
Angle acute(const Givens& givens, const std::string& symbol, const Words& why) {
  const Angle angle = givens.angle(symbol);
  if (sign_of(angle) <= 0 || sign_of(right_angle() - angle) <= 0)
    throw BadGivens(format_words("{} = {}°: must lie between 0° and 90°, both left out; {}",
                                 "{} = {}°: dev'essere tra 0° e 90°, estremi esclusi; {}", symbol,
                                 told_degrees(angle), why));
  return angle;
}

Wedge wedge(const Givens& givens) {
  const auto of = [](const char* symbol) { return std::string("wedge_collar.") + symbol; };
  Wedge wedge{givens[of("Q")], givens[of("w")], givens[of("y_lower")], givens[of("y_upper")], {}};
  wedge.theta = acute(givens, of("theta"),
                      {"at 0° the wedge does not lift, at 90° no force moves it",
                       "a 0° il cuneo non solleva, a 90° nessuna forza lo muove"});
  if (wedge.y_upper <= wedge.y_lower)
    throw BadGivens(format_words("{} = {} m must lie above {} = {} m: the collar has no length",
                                 "{} = {} m deve stare sopra {} = {} m: il collare non ha lunghezza", of("y_upper"),
                                 told_value(wedge.y_upper), of("y_lower"), told_value(wedge.y_lower)));
  return wedge;
}

DoubleSlider double_slider(const Givens& givens) {
  return {givens["double_slider.Q"], givens["double_slider.l"],
          acute(givens, "double_slider.theta",
                {"at 0° no force P lifts Q, at 90° Q stands without P",
                 "a 0° nessuna forza P solleva Q, a 90° Q si regge senza P"})};
}

// Of unit force along `direction` through (x, y), about (x_0, 0): its sign.
Sign sign_of_arm(const Angle& direction, const Rational& x, const Rational& y) {
  return geometry::decide([&]<class T>() {
           return geometry::from_rational<T>(x) * geometry::sine<T>(direction) -
                  geometry::from_rational<T>(y) * geometry::cosine<T>(direction);
         })
      .sign;
}

// The contact's force and Q must turn the loaded lever opposite ways, or the levers part.
void require_contact(const std::string& name, const Levers& of) {
  const Sign contact = turned_from_C(of, of.loaded, of.nu),
             load = sign_of_arm(of.direction_Q, of.x_Q - of.hinge(of.loaded), 0);
  const auto refuse = [&](const Words& why) {
    throw BadGivens(format_words("{}.nu = {}°, {}.x_C = {} m, {}.y_C = {} m: {}",
                                 "{}.nu = {}°, {}.x_C = {} m, {}.y_C = {} m: {}", name, told_degrees(of.nu), name,
                                 told_value(of.x_C), name, told_value(of.y_C), why));
  };
  if (contact == Sign::zero)
    refuse({"the contact's normal passes through the hinge of the lever that Q loads, and cannot hold it",
            "la normale di contatto passa per la cerniera della leva caricata da Q, e non può reggerla"});
  if (turned_from_C(of, of.driven(), of.nu) == Sign::zero)
    refuse({"the contact's normal passes through the hinge of the lever of P, which then holds any load without P",
            "la normale di contatto passa per la cerniera della leva di P, che regge allora ogni carico senza P"});
  if (load == Sign::zero)
    throw BadGivens(
        format_words("{}.direction_Q = {}°, {}.x_Q = {} m: the line of Q passes through the hinge of its lever, and "
                     "the contact carries nothing",
                     "{}.direction_Q = {}°, {}.x_Q = {} m: la retta di Q passa per la cerniera della sua leva, e il "
                     "contatto non porta nulla",
                     name, told_degrees(of.direction_Q), name, told_value(of.x_Q)));
  if (contact == load)
    refuse({"Q and the contact's force turn the lever the same way: the levers would part in C",
            "Q e la forza di contatto fanno ruotare la leva nello stesso verso: le leve si staccherebbero in C"});
}

Levers levers(const Givens& givens, const std::string& name, int loaded) {
  const auto of = [&](const char* symbol) { return name + "." + symbol; };
  Levers levers{loaded,
                givens[of("Q")],
                givens[of("x_Q")],
                givens[of("A0B0")],
                givens[of("x_C")],
                givens[of("y_C")],
                givens[of("arm_P")],
                givens[of("r_2")],
                givens[of("r_3")],
                givens.angle(of("nu")),
                givens.angle(of("direction_Q")),
                givens.angle(of("direction_P"))};
  if (levers.arm_P == 0)
    throw BadGivens(format_words("{} = 0 m: P passes through the hinge of its lever and cannot turn it",
                                 "{} = 0 m: P passa per la cerniera della sua leva e non può farla ruotare",
                                 of("arm_P")));
  require_contact(name, levers);
  return levers;
}

// The circle of the crank's pin must reach the lever, ahead of C.
Fairbairn fairbairn(const Givens& givens, const std::string& name) {
  const auto of = [&](const char* symbol) { return name + "." + symbol; };
  Fairbairn made{givens[of("F")], givens[of("AB")], givens[of("AC")], givens[of("CD")], givens.angle(of("theta"))};
  if (sign_of(right_angle() - made.theta) <= 0 || sign_of(made.theta + right_angle()) <= 0)
    throw BadGivens(format_words("{} = {}°: must lie between -90° and 90°, both left out",
                                 "{} = {}°: dev'essere tra -90° e 90°, estremi esclusi", of("theta"),
                                 told_degrees(made.theta)));
  const Sign reaches = geometry::decide([&]<class T>() {
                         return geometry::from_rational<T>(made.AB * made.AB) -
                                geometry::square(geometry::from_rational<T>(made.AC) * geometry::sine<T>(made.theta));
                       }).sign;
  if (reaches == Sign::negative)
    throw BadGivens(format_words(
        "{} = {} m: the crank does not reach the lever, which passes A at {} m; B does not exist",
        "{} = {} m: la manovella non raggiunge la leva, che passa a {} m da A; B non esiste", of("AB"),
        told_value(made.AB), decimal(CGAL::to_double(made.AC) * std::abs(geometry::sine<double>(made.theta)), 6)));
  made.touches = reaches == Sign::zero;
  return made;
}

}  // namespace

Sign turned_from_C(const Levers& of, int lever, const Angle& direction) {
  return sign_of_arm(direction, of.x_C - of.hinge(lever), of.y_C);
}

std::vector<GivenSpec> givens_of_loaded_mechanisms() {
  std::vector<GivenSpec> all;
  for (const Part& part : {wedge_givens(), double_slider_givens(), levers_givens(), levers_Q_on_2_givens(),
                           fairbairn_givens(), short_fairbairn_givens()})
    all.insert(all.end(), part.givens().begin(), part.givens().end());
  return all;
}

LoadedMechanisms::LoadedMechanisms(const Givens& givens)
    : wedge(epure::wedge(givens)),
      double_slider(epure::double_slider(givens)),
      levers(epure::levers(givens, "sliding_levers", 3)),
      levers_Q_on_2(epure::levers(givens, "sliding_levers_Q_on_2", 2)),
      fairbairn(epure::fairbairn(givens, "fairbairn")),
      fairbairn_short_lever(epure::fairbairn(givens, "fairbairn_short_lever")) {}

}  // namespace epure
