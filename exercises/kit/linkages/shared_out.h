// Where the lines of three forces on a body do not meet on any paper, as two of them are parallel or all but: the
// known force shared out between the line of the second and the point of the third, by a funicular polygon.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "exercises/kit/panels/chained_polygons_panel.h"
#include "exercises/kit/panels/free_body_panel.h"
#include "exercises/kit/panels/shared_load_panel.h"

namespace epure::loaded {

// Whether H is too far from where the forces act, or at infinity.
inline bool is_out_of_reach(const std::optional<Place>& H, const Place& X, const Place& Y, const Place& Z) {
  constexpr double reaches = 20;
  const double apart = std::max({distance(X, Y), distance(Y, Z), distance(Z, X)});
  return !H || distance(*H, X) > reaches * apart;
}

class SharedOut {
 public:
  // `known` acts in X, `on_line` along its own line through Y, `through` in O; they are in equilibrium.
  SharedOut(const PolygonSide& known, const Place& X, const PolygonSide& on_line, const Place& Y,
            const PolygonSide& through, const Place& O)
      : known_(known), on_line_(on_line), through_(through), X_(X), Y_(Y), O_(O) {
    const Arrow2 whole = on_line.v + through.v;
    pole_ = 0.5 * whole + geometry::quarter_turn(whole);
    on_known_ = crossing(O, whole - pole_, X, known.v);
    on_the_line_ = crossing(on_known_, -pole_, Y, on_line.v);
  }

  // That of another motion has strings 1″, 2″, 3″ and a pole with a prime.
  SharedOut& otherwise() {
    stroke_ = "″";
    pole_letters_ = "$O'_{f}$";
    return *this;
  }

  // The strings, and the step that tells of them.
  void draw_strings(FreeBodyPanel& body) const {
    const std::string one = "1" + stroke_, two = "2" + stroke_, three = "3" + stroke_;
    body.string(X_, on_known_, "").string(Y_, on_the_line_, "");
    body.string(O_, on_known_, two).string(on_known_, on_the_line_, one).string(on_the_line_, O_, three);
    body.step(
        Words{"The lines of " + known_.label + " and " + on_line_.label +
                  " do not meet on the sheet. Funicular polygon: " + two + " parallel to the ray 2, from where " +
                  through_.label + " acts to the line of " + known_.label + "; " + one +
                  " parallel to 1, to that of " + on_line_.label + "; " + three + " closes it.",
              "Le rette della " + known_.label + " e della " + on_line_.label +
                  " non si incontrano nel foglio. Poligono funicolare: " + two +
                  " parallela al raggio 2, da dove agisce la " + through_.label + " alla retta della " +
                  known_.label + "; " + one + " parallela a 1, fino a quella della " + on_line_.label + "; " + three +
                  " lo chiude."},
        O_);
  }
  // The force polygon with its pole. `name`: of the known force turned round.
  SharedLoadPanel polygon(const std::string& name) const {
    const auto part = [](const PolygonSide& side) {
      return SharedLoadPanel::Part{side.quantity, side.label, side.v};
    };
    SharedLoadPanel panel({{}, name, on_line_.v + through_.v}, part(on_line_), part(through_), pole_, "N");
    panel.named({"1", "2", "3"}, pole_letters_);
    panel.step(Words{"A pole " + pole_letters_ + " beside " + name + ", and the rays 1 and 2 to its ends.",
                     "Un polo " + pole_letters_ + " accanto alla " + name + ", e i raggi 1 e 2 ai suoi estremi."},
               SharedLoadPanel::At::pole);
    panel.step(
        Words{
            "The ray 3 parallel to 3" + stroke_ + " parts it into " + on_line_.label + " and " + through_.label + ".",
            "Il raggio 3 parallelo a 3" + stroke_ + " la divide in " + on_line_.label + " e " + through_.label + "."},
        SharedLoadPanel::At::between);
    return panel;
  }

 private:
  static Place crossing(const Place& P, const Arrow2& u, const Place& Q, const Arrow2& v) {
    return P + (cross(Q - P, v) / cross(u, v)) * u;
  }

  PolygonSide known_, on_line_, through_;
  Place X_, Y_, O_, on_known_, on_the_line_;
  Arrow2 pole_;
  std::string stroke_ = "′", pole_letters_ = "$O_{f}$";
};

// The polygons of two bodies of which the second starts `from` the first's origin; instead of one of them, where it
// is shared out, that with the pole. `names`: of the known forces turned round.
inline void add_polygons(Panels& all, const VectorPolygon& first, const VectorPolygon& second, const Arrow2& from,
                         const std::array<const std::optional<SharedOut>*, 2>& shared,
                         const std::array<std::string, 2>& names) {
  const auto& [shared_first, shared_second] = shared;
  const auto add = [&](auto panel) { all.push_back(std::make_unique<decltype(panel)>(std::move(panel))); };
  if (*shared_first) {
    add((*shared_first)->polygon(names[0]));
    if (!*shared_second) add(ChainedPolygonsPanel(second));
  } else {
    ChainedPolygonsPanel chained(first);
    if (!*shared_second) chained.then(second, from);
    add(chained);
  }
  if (*shared_second) add((*shared_second)->polygon(names[1]));
}

}  // namespace epure::loaded
