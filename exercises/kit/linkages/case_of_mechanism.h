// One of the mechanisms of an exercise, by its name before all quantities and givens.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "exercises/kit/panels/panel_sheet.h"
#include "exercises/kit/panels/poles_panel.h"
#include "exercises/kit/panels/polygon_panel.h"
#include "exercises/kit/statement/forces.h"

namespace epure::loaded {

// One mechanism's quantities under their names.
class Case {
 public:
  Case(const Solution& solution, const std::string& name, const std::string& givens = {})
      : s(solution), prefix_(name + "."), givens_((givens.empty() ? name : givens) + ".") {}

  VectorQuantity of(VectorQuantity quantity) const {
    quantity.name = prefix_ + quantity.name;
    return quantity;
  }
  PolygonSide known(const VectorQuantity& quantity, const std::string& direction, const std::string& magnitude,
                    const std::string& tip = {}) const {
    return side(s, of(quantity), direction, magnitude, tip);
  }
  PolygonSide sought(const VectorQuantity& quantity, const std::string& direction,
                     const std::string& tip = {}) const {
    return side(s, of(quantity), direction, "?", tip);
  }
  // The load, which is given and so not measured.
  PolygonSide load(const std::string& letter, const std::string& direction, const std::string& tip) const {
    PolygonSide side = known(applied_force(letter, {}), direction, "$\\it{" + letter + "}$", tip);
    side.quantity.clear();
    return side;
  }
  // Of a virtual motion, which is drawn and not reported.
  PolygonSide moves(const std::string& of_what, const std::string& direction, const std::string& magnitude,
                    const std::string& tip = {}) const {
    PolygonSide side = known(velocity(of_what), direction, magnitude, tip);
    side.quantity.clear();
    return side;
  }
  PolesPanel::Kind pole(const std::string& name) const {
    PolesPanel::Kind kind = PolesPanel::of_velocity(name);
    kind.prefix = prefix_;
    return kind;
  }
  std::string name(const std::string& quantity) const { return prefix_ + quantity; }
  std::vector<std::string> names(std::vector<std::string> quantities) const {
    for (std::string& each : quantities) each = name(each);
    return quantities;
  }
  Result results(const std::vector<std::string>& quantities) const { return values(names(quantities)); }
  double operator[](const std::string& quantity) const { return s[name(quantity)]; }
  Place place(const std::string& point) const { return s.place(name(point)); }
  std::optional<Place> point(const std::string& point) const { return s.point(name(point)); }
  Arrow2 vector(const std::string& quantity) const { return s.vector(name(quantity)); }
  double given(const std::string& symbol) const { return CGAL::to_double(s.givens()[givens_ + symbol]); }
  Angle angle(const std::string& symbol) const { return s.givens().angle(givens_ + symbol); }
  double radians(const std::string& symbol) const { return geometry::to_double(angle(symbol)); }
  // Of the other mechanisms, which this sheet does not show, `but` these; and of this one.
  std::set<std::string> without(const std::vector<std::string>& symbols = {},
                                const std::set<std::string>& but = {}) const {
    std::set<std::string> others;
    for (const GivenSpec& spec : s.givens().specs())
      if (!spec.symbol.starts_with(givens_) && !but.contains(spec.symbol)) others.insert(spec.symbol);
    for (const std::string& symbol : symbols) others.insert(givens_ + symbol);
    return others;
  }

  const Solution& s;

 private:
  std::string prefix_, givens_;
};

// The same force on the other body: R_32 of R_23.
inline PolygonSide reversed(const PolygonSide& force, int i, int j, const std::string& tip = {}) {
  PolygonSide side = reaction(force, force_between(i, j).arrow(),
                              "$" + std::string("\\it{R}_{") + std::to_string(j) + std::to_string(i) + "}$");
  side.tip = tip;
  return side;
}

}  // namespace epure::loaded
