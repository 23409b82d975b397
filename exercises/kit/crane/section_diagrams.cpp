#include "exercises/kit/crane/section_diagrams.h"

namespace epure {
namespace {

double metres(const Solution& s, const std::string& given) { return CGAL::to_double(s.givens()[given]) / 1000; }

// From the axis and back to it.
std::vector<Place> jourawsky_along_depth(const Solution& s, double shear_over_J) {
  const double H = half_depth(s), h = half_web(s), b = metres(s, "b_1"), web = metres(s, "s_1");
  constexpr int pieces = 60;
  std::vector<Place> upper;
  for (int i = 0; i <= pieces; ++i) {
    const double y = H - (H - h) * i / pieces;
    upper.push_back({shear_over_J * (H * H - y * y) / 2, y});
  }
  for (int i = 0; i <= pieces; ++i) {
    const double y = h - h * i / pieces;
    upper.push_back({shear_over_J * (b * (H * H - h * h) / 2 / web + (h * h - y * y) / 2), y});
  }
  std::vector<Place> border = upper;
  for (auto P = upper.rbegin(); P != upper.rend(); ++P) border.push_back({P->x, -P->y});
  return border;
}

}  // namespace

double half_depth(const Solution& s) { return metres(s, "H_1") / 2; }
double half_web(const Solution& s) { return half_depth(s) - metres(s, "s_1"); }

SectionPanel section_with_stresses(const Solution& s, double outer, double shear_over_J,
                                   std::vector<StressDiagram::Read> bending, std::vector<StressDiagram::Read> shear,
                                   Language language) {
  constexpr double mega = 1e6;
  const double H = half_depth(s);
  SectionPanel section(2 * H, metres(s, "b_1"), metres(s, "s_1"), "MPa", mega, language);
  section.dimensioned("$\\it{H}_{1}$", "$b_{1}$", "$s_{1}$");
  section.diagram(
      {.name = "$σ_{z}$", .border = {{0, H}, {outer, H}, {-outer, -H}, {0, -H}}, .reads = std::move(bending)});
  section.diagram({.name = "$τ$", .border = jourawsky_along_depth(s, shear_over_J), .reads = std::move(shear)});
  return section;
}

}  // namespace epure
