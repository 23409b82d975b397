// What the exercise reports.
#pragma once

#include <string>

#include "exercises/kit/statement/format_words.h"
#include "exercises/kit/statement/quantity.h"

namespace epure::frame_deflection {

inline Quantity shear_modulus() { return {"G", "$\\it{G}$", "Pa", {"shear modulus", "modulo di taglio"}}; }

// "x1", "p2", "t1"
inline Quantity inertia(const std::string& of) {
  const Words bar =
      of.back() == '1' ? Words{" of the rectangle", " del rettangolo"} : Words{" of the circle", " del cerchio"};
  const Words kind =
      of.front() == 'x'
          ? Words{"moment of inertia about the horizontal axis", "momento d'inerzia rispetto all'asse orizzontale"}
      : of.front() == 'y'
          ? Words{"moment of inertia about the vertical axis", "momento d'inerzia rispetto all'asse verticale"}
      : of.front() == 'p' ? Words{"polar moment of inertia", "momento d'inerzia polare"}
                          : Words{"de Saint-Venant's torsion constant", "costante di torsione di de Saint-Venant"};
  return {"J_" + of, "$\\it{J}_{" + of + "}$", "m^4", kind + bar};
}

inline Quantity clamp_force() {
  return {"R_O_z",
          "$\\it{R}_{Oz}$",
          "N",
          {"force of the clamp on the frame, upwards", "forza dell'incastro sul telaio, verso l'alto"}};
}
inline Quantity clamp_couple(const std::string& axis) {
  return {"M_O_" + axis, "$\\it{M}_{O" + axis + "}$", "N*m",
          Words{"couple of the clamp on the frame, about ", "coppia dell'incastro sul telaio, intorno a "} +
              decimal(axis)};
}
inline Quantity shear() {
  return {"T_y", "$\\it{T}_{y}$", "N", {"shear force in every section", "taglio in ogni sezione"}};
}

// At "O", "A"; in bar 1, 2, 3: its end at "B" or "C", or its "mid".
inline Quantity bending(const std::string& at, int bar) {
  const std::string number = std::to_string(bar);
  const bool is_free_end = at == "O" || at == "A";
  const Words where = at == "mid" ? format_words("in the middle of bar {}", "a metà della barra {}", number)
                                  : format_words("at {}, in bar {}", "in {}, nella barra {}", at, number);
  return {"M_x_" + at + (is_free_end ? "" : "_bar_" + number),
          "$\\it{M}_{f" + (at == "mid" ? std::string("m") : at) + (is_free_end ? "" : number) + "}$", "N*m",
          Words{"bending moment ", "momento flettente "} + where};
}
inline Quantity torsion(int bar) {
  const std::string number = std::to_string(bar);
  return {"M_z_bar_" + number, "$\\it{M}_{t" + number + "}$", "N*m",
          format_words("torque in bar {}", "momento torcente nella barra {}", number)};
}

inline Quantity rotation(const std::string& node, const std::string& axis) {
  return {"theta_" + node + "_" + axis, "$θ_{" + node + axis + "}$", "rad",
          format_words("rotation of {} about {}", "rotazione di {} intorno a {}", node, axis)};
}
inline Quantity rise(const std::string& node) {
  return {"w_" + node, "$w_{" + node + "}$", "m",
          format_words("displacement of {}, upwards", "spostamento di {}, verso l'alto", node)};
}
inline Quantity bending_share(int bar) {
  const std::string number = std::to_string(bar);
  return {"delta_bending_" + number, "$δ_{f" + number + "}$", "m",
          format_words("share of bar {}'s bending in the deflection of A",
                       "parte dell'abbassamento di A per la flessione della barra {}", number)};
}
inline Quantity torsion_share(int bar) {
  const std::string number = std::to_string(bar);
  return {"delta_torsion_" + number, "$δ_{t" + number + "}$", "m",
          format_words("share of bar {}'s torsion in the deflection of A",
                       "parte dell'abbassamento di A per la torsione della barra {}", number)};
}
// Only drawn.
inline Quantity elastic_weight(int bar) {
  const std::string number = std::to_string(bar);
  return {"alpha_" + number, "$α_{" + number + "}$", "rad",
          format_words("elastic weight of bar {}'s bending", "peso elastico della flessione della barra {}", number)};
}
inline Quantity energy(int bar) {
  const std::string number = std::to_string(bar);
  return {"U_" + number, "$\\it{U}_{" + number + "}$", "J",
          format_words("elastic energy of bar {}", "energia elastica della barra {}", number)};
}
inline Quantity whole_energy() { return {"U", "$\\it{U}$", "J", {"elastic energy", "energia elastica"}}; }
inline Quantity deflection() {
  return {"delta_A", "$δ_{A}$", "m", {"deflection of A, downwards", "abbassamento di A"}};
}

}  // namespace epure::frame_deflection
