// Arb's numbers that free themselves, for its functions that write into one.
#pragma once

#include "geometry/numbers/deep.h"

namespace epure::geometry {

struct Float {
  arf_t value;
  Float() { arf_init(value); }
  Float(const Float&) = delete;
  Float& operator=(const Float&) = delete;
  ~Float() { arf_clear(value); }
};

struct Ball {
  arb_t value;
  Ball() { arb_init(value); }
  Ball(const Ball&) = delete;
  Ball& operator=(const Ball&) = delete;
  ~Ball() { arb_clear(value); }
};

struct ComplexBall {
  acb_t value;
  ComplexBall() { acb_init(value); }
  explicit ComplexBall(const Deep& x) : ComplexBall() { acb_set_arb(value, x.ball()); }
  ComplexBall(const ComplexBall&) = delete;
  ComplexBall& operator=(const ComplexBall&) = delete;
  ~ComplexBall() { acb_clear(value); }
  Deep real() const { return Deep::from_ball(acb_realref(value)); }
};

}  // namespace epure::geometry
