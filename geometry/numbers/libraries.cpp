#include "geometry/numbers/libraries.h"

#include <CGAL/version.h>
#include <gmp.h>
#include <mpfr.h>

#include <Eigen/Core>
#include <boost/version.hpp>

#include "geometry/numbers/calcium_bridge.h"
#include "geometry/numbers/flint.h"

namespace epure::geometry {
namespace {

std::string dotted(int major, int minor, int patch) {
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

}  // namespace

Libraries libraries() {
  Libraries all{{"FLINT", flint_version}};
#if __FLINT_VERSION < 3  // FLINT 3 holds them
  all.push_back({"Arb", arb_version});
  all.push_back({"Calcium", epure_calcium_version()});
#endif
  all.push_back({"GMP", gmp_version});
  all.push_back({"MPFR", mpfr_get_version()});
  all.push_back({"CGAL", CGAL_VERSION_STR});
  all.push_back({"Eigen", dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)});
  all.push_back({"Boost", dotted(BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100)});
  return all;
}

}  // namespace epure::geometry
