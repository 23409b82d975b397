// From the numbers of a construction to the doubles of a drawing: found with many bits, rounded once.
#pragma once

#include <optional>

#include "exercises/kit/plot.h"
#include "geometry/numbers/deep.h"

namespace epure {

// The true value rounded to the digits of a drawing, which are fewer than a double has: so doubles are mostly enough
// to find it, and where they are not, to say so (by TooCoarse). Zero when 256 bits leave open whether it is zero. A
// point's coordinates have their last digit in common, and so have points with what they are drawn beside, such as
// the length of a mechanism, unless they are much larger.
double to_double(const geometry::Deep& x);
Place to_double(const geometry::Point<geometry::Deep>& P, double beside = 0);
Arrow2 to_double(const geometry::Vector<geometry::Deep>& v);

// None for a point at infinity, or one of which 256 bits cannot tell.
std::optional<Place> to_double(const geometry::ProjectivePoint<geometry::Deep>& P, double beside = 0);

// A circle, or the line it has become; neither when every point or none satisfies it.
struct DrawnCycle {
  std::optional<Place> centre = {};  // of a circle
  double radius = 0;
  // The point nearest to the origin and the direction there: of the line, or of a circle too large to tell from one.
  std::optional<Place> on_line = {};
  Arrow2 along{0, 0};
};
DrawnCycle to_double(const geometry::Cycle<geometry::Deep>& cycle);

// While one lives, this thread draws with 256 bits from the start: what drawings in doubles are held against.
class WithBits {
 public:
  WithBits() { is_on_ = true; }
  ~WithBits() { is_on_ = false; }
  WithBits(const WithBits&) = delete;
  WithBits& operator=(const WithBits&) = delete;
  static bool is_on() { return is_on_; }

 private:
  inline static thread_local bool is_on_ = false;
};

// Runs `find`, which works on Deep, as precisely as drawings need: in doubles, and where these do not suffice with
// 256 bits. So it may run twice.
template <class Find>
auto deeply(const Find& find) {
  if (!WithBits::is_on()) try {
      const geometry::Arithmetic<geometry::Deep> doubles(geometry::in_doubles);
      return find();
    } catch (const geometry::TooCoarse&) {
    }
  const geometry::Arithmetic<geometry::Deep> bits(256);
  return find();
}

}  // namespace epure
