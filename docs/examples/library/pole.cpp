// The pole of a four-bar's coupler, with bounds that are proved, or the proof that it lies at infinity.
//   pole [CRANK]      such as 90deg (where it lies at infinity), 1.2rad; else 60deg
#include <cstdio>
#include <exception>

#include "geometry/mechanisms/four_bar.h"
#include "geometry/numbers/climb.h"
#include "geometry/numbers/given.h"

using namespace epure::geometry;

int main(int count, char** words) {
  try {
    const Angle crank = angle_of(read_given(count > 1 ? words[1] : "60deg", "deg"));
    // 12 cm, 50 cm, 26 cm; B0 at (48 cm, 0). Exactly: 0.12 would be the double nearest to it.
    const FourBarLengths lengths{Rational(12, 100), Rational(50, 100), Rational(26, 100), Rational(48, 100), 0};

    // Written once, for any number; the climb runs it on intervals first, and then on better numbers as far as it
    // takes.
    const auto coordinates = [&]<class T>() -> std::vector<Reading<T>> {
      const FourBar<T> at = four_bar<T>(lengths, {cosine<T>(crank), sine<T>(crank)}, Side::left);
      const ProjectivePoint<T> P0 = at.pole();
      const auto finite_pole = [&] {
        if (sign(P0.w) == Sign::zero)
          throw Impossible("crank and rocker are parallel", "manovella e bilanciere paralleli");
        return finite(P0);
      };
      return {Reading<T>::from([&] { return finite_pole().x; }), Reading<T>::from([&] { return finite_pole().y; })};
    };
    const std::vector<Settled> found = climb(coordinates);
    for (std::size_t i = 0; i < found.size(); ++i) {
      const char* const name = i == 0 ? "P0_x" : "P0_y";
      const auto [lower, value, upper] = found[i].enclosure;
      if (found[i].kind == Settled::Kind::certain || found[i].kind == Settled::Kind::enclosed)
        std::printf("%s = %.17g m, proved between %.17g and %.17g (%s)\n", name, value, lower, upper,
                    found[i].rung.c_str());
      else
        std::printf("%s: none, %s (%s)\n", name, found[i].reason.english.c_str(), found[i].rung.c_str());
    }
    return 0;
  } catch (const epure::Told& sentence) {  // what cannot be read, closed or decided
    std::fprintf(stderr, "pole: %s\n", sentence.what());
    return 2;
  }
}
