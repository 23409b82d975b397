// A mechanism as it is drawn, whatever it is: what sheets that serve several mechanisms need of it.
#pragma once

#include "exercises/kit/panels/fit.h"
#include "exercises/kit/panels/plot.h"

namespace epure {

class MechanismFigure {
 public:
  virtual ~MechanismFigure() = default;
  // With its symbols and letters.
  virtual void draw(Plot& plot) const = 0;
  // Without what the exercise finds: the senses of rates.
  virtual void draw_given(Plot& plot) const { draw(plot); }
  // Links, plates and points without symbols, for a picture in which the mechanism is small.
  virtual void sketch(Plot& plot) const = 0;
  // What `draw` covers at a scale, letters included.
  virtual void include(Extent& extent, const Scale& scale) const = 0;
  // Its hinges and corners.
  virtual std::vector<Place> corners() const = 0;
  // How far it reaches from end to end, in metres: what is far or large in its figures is measured by it.
  virtual double reach() const = 0;
};

// An arc arrow about a point, its middle in this direction (radians), with its symbol beside it: counter-clockwise
// for sense > 0, clockwise for sense < 0.
struct ArcArrow {
  double middle, sense;
  std::string symbol;
  double radius = 9;  // mm
  Meaning meaning = Meaning::link;
};
void draw_arc_arrow(Plot& plot, const Place& centre, const ArcArrow& arrow);

// The direction with most room between these; of several that nearest to straight up. (radians)
double clearest_direction(const std::vector<double>& between);

// The arc arrow at a crank A₀A that turns counter-clockwise (sense > 0) or clockwise, with its symbol beside it:
// ahead of the crank, or behind it where the support of A₀ stands ahead (`support`; none: direction_of_support).
void draw_sense_of_crank(Plot& plot, const Place& A0, const Place& A, double sense,
                         const std::string& symbol = "$ω_{2}$", std::optional<double> support = {});

// The same about a point without a support, ahead of the link to P.
void draw_sense_of_turning(Plot& plot, const Place& centre, const Place& P, double sense, const std::string& symbol);

// Where the hatched support of a fixed hinge stands, clear of the link to `pin`: below, or above when that goes down.
double direction_of_support(const Place& hinge, const Place& pin);

}  // namespace epure
