#include "exercises/truss/given_truss.h"

#include <algorithm>
#include <utility>

#include "geometry/numbers/given.h"

namespace epure::truss {
namespace {

using geometry::to_text;

int panels_of(const Givens& givens, Shape shape) {
  const Rational& n = givens["n"];
  if (!has_panels(shape)) return least_panels;
  const bool is_even = needs_even_panels(shape);
  const Rational step = is_even ? n / 2 : n;
  if (n < least_panels || n > most_panels || step.denominator() != 1)
    throw BadGivens(format_words("n = {}: this truss has {} number of panels from {} to {}",
                                 "n = {}: questa travatura ha un numero {} di campi, da {} a {}", to_text(n),
                                 is_even ? Words{"an even", "pari"} : Words{"a whole", "intero"}, least_panels,
                                 most_panels));
  return static_cast<int>(n.to_double());
}

bool contains(const std::vector<std::size_t>& all, std::size_t joint) {
  return std::find(all.begin(), all.end(), joint) != all.end();
}

}  // namespace

std::vector<GivenSpec> given_specs() {
  return {{.symbol = "shape",
           .meaning = {"the truss", "la travatura"},
           .unit = "1",
           .stated = "roof",
           .range = Range::any,
           .choices = {{"roof", {"roof truss", "capriata"}},
                       {"polonceau", {"Polonceau's roof truss", "capriata Polonceau"}},
                       {"warren", {"Warren's girder", "trave Warren"}},
                       {"pratt", {"Pratt's girder", "trave Pratt"}},
                       {"howe", {"Howe's girder", "trave Howe"}},
                       {"bracket", {"wall bracket", "mensola a muro"}},
                       {"crane", {"derrick crane", "gru a braccio"}}}},
          {"L", {"span", "luce"}, "m", "12", Range::positive, "$\\it{L}$"},
          {"h", {"height", "altezza"}, "m", "3", Range::positive, "$h$"},
          {.symbol = "n",
           .meaning = {"number of panels, from 2 to 8", "numero di campi, da 2 a 8"},
           .unit = "1",
           .stated = "4",
           .range = Range::positive,
           .letters = "$n$"},
          {"P",
           {"load of each loaded joint, downwards", "carico di ogni nodo caricato, verso il basso"},
           "N",
           "1000",
           Range::any,
           "$\\it{P}$"},
          {"W",
           {"force of the wind on each joint it meets", "forza del vento su ogni nodo investito"},
           "N",
           "0",
           Range::any,
           "$\\it{W}$"},
          {"beta",
           {"direction of W, counter-clockwise from x", "direzione di W, antioraria da x"},
           "deg",
           "0",
           Range::any,
           "$β$"},
          {"delta",
           {"inclination of the roller's plane, counter-clockwise from level (of the bracket: from upright)",
            "inclinazione del piano del carrello, antioraria dall'orizzontale (della mensola: dalla verticale)"},
           "deg",
           "0",
           Range::any,
           "$δ$"}};
}

Shape shape_of(const Givens& givens) { return static_cast<Shape>(static_cast<int>(givens["shape"].to_double())); }

trusses::LoadedTruss given_truss(const Givens& givens) {
  const Shape shape = shape_of(givens);
  const Rational &P = givens["P"], &W = givens["W"];
  const Built built = truss::built(shape, givens["L"], givens["h"], panels_of(givens, shape));
  std::vector<trusses::Load> loads;
  std::vector<std::string> names;
  for (std::size_t joint = 0; joint < built.joints.size(); ++joint) {
    names.push_back({static_cast<char>('A' + joint)});
    const bool by_P = P != 0 && contains(built.loaded, joint), by_W = W != 0 && contains(built.windward, joint);
    if (!by_P && !by_W) continue;
    loads.push_back({.joint = joint,
                     .components = {0, by_P ? Rational(-P) : Rational(0)},
                     .size = by_W ? W : Rational(0),
                     .along = givens.angle("beta"),
                     .label = !by_W   ? "$\\it{P}$"
                              : !by_P ? "$\\it{W}$"
                                      : "$\\vec{\\it{P}}$+$\\vec{\\it{W}}$"});
  }
  if (loads.empty())
    throw BadGivens(
        Words{"P = 0 N, W = 0 N: nothing loads the truss", "P = 0 N, W = 0 N: nulla carica la travatura"});
  if (is_whole_turns(Rational(2) * givens.angle("delta") - Angle{Rational(1, 2)}))
    throw BadGivens(
        format_words("delta = {}°: the roller's line of action passes through the hinge, and the truss is not held",
                     "delta = {}°: la retta d'azione del carrello passa per la cerniera, e la travatura è labile",
                     to_text(Rational(360) * givens.angle("delta").turns)));
  const Angle roller = givens.angle("delta") + Angle{stands_on_wall(shape) ? Rational(0) : Rational(1, 4)};
  try {
    return {{built.joints, built.bars, {0, 1}, std::move(names)}, roller, std::move(loads)};
  } catch (const geometry::Impossible& why) {
    throw BadGivens(format_words("L = {} m, h = {} m: {}", "L = {} m, h = {} m: {}", to_text(givens["L"]),
                                 to_text(givens["h"]), why.words()));
  }
}

}  // namespace epure::truss
