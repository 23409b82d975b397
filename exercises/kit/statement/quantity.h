// What is reported, by kind: from the kind and from what it is of follow name, letters, unit and meaning.
//
// Points are named as in names of quantities: "B", "P0", "G3", "Cprime". Two of them together, "BA", stand for the
// first seen from the second.
#pragma once

#include <string>
#include <vector>

#include "words/words.h"

namespace epure {

struct Quantity {
  std::string name;    // ASCII: "omega_3", "a_BA_n"
  std::string symbol;  // rich text: "$ω_{3}$"
  std::string unit;    // "rad/s"; "1" for a pure number
  Words meaning;
  bool is_rotation =
      false;  // an angle that something turns through: whole turns count, as they do not of a direction

  // The same with other words.
  Quantity meaning_that(const Words& other) const { return {name, symbol, unit, other, is_rotation}; }
  Quantity turned_through() const { return {name, symbol, unit, meaning, true}; }
};

// A vector in the plane: two components, along the axes, and the length.
struct VectorQuantity {
  std::string name;     // "v_B", "a_BA_n"
  std::string letters;  // rich text within mathematics, "{}" where the subscript goes: "v_{{{}}}", "a^{{n}}_{{{}}}"
  std::string of;       // the subscript
  std::string unit;
  Words meaning, size;  // "velocity of B", "speed of B"

  Quantity x() const { return component("x", {", along x", ", lungo x"}); }
  Quantity y() const { return component("y", {", along y", ", lungo y"}); }
  Quantity length() const;
  // With an arrow over its letter, as rich text.
  std::string arrow() const;
  // The same with other words for its length.
  VectorQuantity meaning_that(const Words& other) const { return {name, letters, of, unit, meaning, other}; }

 private:
  Quantity component(const std::string& axis, const Words& along) const;
};

// A point of the plane: two coordinates, in metres.
struct PointQuantity {
  std::string name;          // "P0"
  Words of;                  // " of the velocity centre", " del centro delle velocità"
  std::string letters = {};  // within mathematics, where the name is not what is written: "F"

  Quantity x() const;
  Quantity y() const;
};

// "B", or "BA": of B relative to A.
VectorQuantity velocity(const std::string& of);
VectorQuantity acceleration(const std::string& of);
// The parts of the acceleration across and along the path of B, or of B about A.
VectorQuantity normal_acceleration(const std::string& of);
VectorQuantity tangential_acceleration(const std::string& of);

PointQuantity point(const std::string& name);
PointQuantity pole(const std::string& name);
PointQuantity acceleration_pole();  // K

// From P to X: "P0", "A" is called P0A.
Quantity distance(const std::string& P, const std::string& X);

// Of body i: ω_i and α_i, counter-clockwise.
Quantity angular_velocity(int body);
Quantity angular_acceleration(int body);

// The points that a velocity or an acceleration is of: "BA" is B and A, as B is seen from A; "G3A" is G3 and A; "B"
// is B alone.
std::vector<std::string> points_in(const std::string& of);

// A point's letters within mathematics: "P0" is P_{0}, "Cprime" C'.
std::string point_letters(const std::string& name);

}  // namespace epure
