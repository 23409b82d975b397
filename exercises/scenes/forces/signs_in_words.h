// Which way the forces and couples of a sheet act where they are positive, those that have a sign.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "exercises/scenes/forces/force_figures.h"

namespace epure::scenes {

class SignsInWords {
 public:
  SignsInWords(const ForceFigures& of, const Built& built) : of_(of), built_(built) {}

  // Of what lines and drives exert; that of a hinge has a size alone.
  void add(const ActingForce& force) {
    using Kind = ActingForce::Kind;
    if (force.kind == Kind::cylinder)
      return add(letters_of_force(built_, force), Words{"where it pushes", "se spinge"});
    if (force.kind == Kind::slid) return add(letters_of_force(built_, force), towards(of_.along(force)));
    if (force.kind != Kind::pin && force.kind != Kind::guide) return;
    const Arrow2 along = of_.along(force), normal = geometry::quarter_turn(along);
    const auto* friction = friction_of(built_, force);
    if (!friction) return add(letters_of_force(built_, force), towards(normal));
    add(contact(built_, *friction).normal.symbol, towards(normal));
    add(friction_force(built_, *friction).symbol, towards(along));
  }
  void add_couples() { has_couples_ = true; }

  // Empty where nothing has a sign.
  Words all() const {
    Words written = written_;
    if (has_couples_)
      written = written + (written.empty() ? Words{} : Words{", ", ", "}) +
                Words{"couples counter-clockwise", "coppie in senso antiorario"};
    return written.empty() ? written : Words{"Positive: ", "Verso positivo: "} + written + ".";
  }

 private:
  // The nearest of four: along a line that tells one sense from the other.
  static Words towards(const Arrow2& v) {
    if (std::abs(v.y) >= std::abs(v.x))
      return v.y > 0 ? Words{"upwards", "verso l'alto"} : Words{"downwards", "verso il basso"};
    return v.x > 0 ? Words{"to the right", "verso destra"} : Words{"to the left", "verso sinistra"};
  }
  void add(const std::string& symbol, const Words& sense) {
    if (std::find(told_.begin(), told_.end(), symbol) != told_.end()) return;
    told_.push_back(symbol);
    written_ = written_ + (written_.empty() ? "" : ", ") + symbol + " " + sense;
  }

  const ForceFigures& of_;
  const Built& built_;
  std::vector<std::string> told_ = {};
  Words written_ = {};
  bool has_couples_ = false;
};

}  // namespace epure::scenes
