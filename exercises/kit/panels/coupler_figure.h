// The coupler of a mechanism as a moving plane, ready to be drawn: its poles, its circles, and the points that the
// exercise follows. The sheets that show them are the same for every mechanism.
#pragma once

#include <functional>

#include "exercises/kit/panels/mechanism_figure.h"
#include "exercises/kit/panels/rounded.h"
#include "geometry/motion/plane_motion.h"

namespace epure {

// A point of the coupler that the exercise follows.
struct CouplerPoint {
  std::string letter;  // "C": of the names of quantities, and on the figure
  Place at;
  Arrow2 v, a;
  std::optional<Place> on_circle =
      {};                            // X', where the ray from the pole meets the inflection circle; none at infinity
  std::optional<Place> centre = {};  // of curvature; none when the path is straight there
  std::string symbol = {};           // rich text within mathematics, when it is not the letter: "G_{3}"
  const std::string& written() const { return symbol.empty() ? letter : symbol; }
};

// A point X' from which, with the pole, the inflection circle is built: by Euler-Savary on the normal through X.
struct CircleBuilder {
  std::string label;  // "$A'$"
  Place at, from;     // X', X
};

struct CouplerFigure {
  const MechanismFigure* mechanism;
  std::string pole = "P0", pole_symbol = "P_{0}";  // in the names of quantities; as it is written
  double omega_3 = 0, alpha_3 = 0;
  std::optional<Place> P0 = {}, J = {}, K = {};  // none when at infinity
  DrawnCycle inflection = {}, stationarity = {};
  std::vector<CouplerPoint> points = {};     // driven point first: its velocity and acceleration are known
  std::vector<CircleBuilder> builders = {};  // two
  // Prefix of the quantities' names, for a case of the exercise.
  std::string prefix = {};

  std::string pole_label() const { return "$" + pole_symbol + "$"; }
  double greatest_acceleration() const;
  double greatest_velocity() const;
  // The mechanism's middle, away from which letters stand.
  Place middle() const;
  bool is_near(const std::optional<Place>& P, double times) const;  // within so many times the mechanism's reach
};

struct FollowedPoint {
  std::string letter;
  geometry::Point<geometry::Deep> at;
  std::string symbol = {};
};
CouplerFigure coupler_figure(const MechanismFigure& mechanism, const geometry::PlaneMotion<geometry::Deep>& motion,
                             const std::vector<FollowedPoint>& points);

// The words that differ from mechanism to mechanism.
struct SheetWords {
  drawings::Steps steps;
  Words description;
};

// Inflection circle by the pole and the builders, stationarity circle, and K where they meet again.
void draw_circles_sheet(DrawnSheet& onto, const CouplerFigure& figure, const SheetRequest& request,
                        const SheetWords& words);

// Accelerations proportional to the distance from K, at the angle γ to the ray. `compared`, when given, draws the
// polar diagram whose vectors the table holds against these.
void draw_acceleration_pole_sheet(DrawnSheet& onto, const CouplerFigure& figure, const SheetRequest& request,
                                  const SheetWords& words,
                                  const std::function<void(DrawnSheet&, const SheetRequest&)>& compared = {});

// Centres of curvature of the paths of the points named: above the rays as far as the inflection circle, below the
// mechanism with the osculating circles.
void draw_curvature_sheet(DrawnSheet& onto, const CouplerFigure& figure, const std::vector<std::string>& letters,
                          const SheetRequest& request, const SheetWords& words);

}  // namespace epure
