#include "exercises/kit/panels/shared_load_panel.h"

#include <algorithm>

namespace epure {
namespace {

constexpr double row = 8;  // mm between the whole and each of its parts

}  // namespace

Panel::Vectors SharedLoadPanel::vectors() const {
  return {unit_, std::max({magnitude(whole_.v), magnitude(first_.v), magnitude(second_.v)})};
}

Arrow2 SharedLoadPanel::aside(double mm, const Scale& vectors) const {
  const Arrow2 normal = geometry::quarter_turn(whole_.v);
  const double side = geometry::dot(normal, Arrow2{pole_.x, pole_.y}) > 0 ? -1 : 1;
  return (side * mm / vectors.mm_per_unit / magnitude(normal)) * normal;
}

drawings::Box SharedLoadPanel::extent(const Scale&, const Scale& vectors) const {
  constexpr double air = 8;  // mm
  Extent extent;
  const Place start{0, 0};
  for (const Place& P : {start, end(), between(), pole_}) {
    extent.include(vectors, P, air);
    extent.include(vectors, P + aside(2 * row, vectors), air);
  }
  return extent.box();
}

std::vector<drawings::Block> SharedLoadPanel::draw(Plot& plot, const drawings::Box&, Language) const {
  const Place start{0, 0};
  const Arrow2 first_row = aside(row, plot.scale()), second_row = aside(2 * row, plot.scale());
  plot.side(whole_.quantity, start, end(), Meaning::force, whole_.label, start + second_row);
  plot.side(first_.quantity, start + first_row, between() + first_row, Meaning::force, first_.label);
  plot.side(second_.quantity, between() + second_row, end() + second_row, Meaning::force, second_.label);
  for (const Place& P : {start, end(), between()}) plot.segment(P, P + second_row, Meaning::construction);
  plot.segment(start, between(), Meaning::construction);
  const std::array<Place, 3> ends{start, end(), between()};
  for (std::size_t i = 0; i < ends.size(); ++i) {
    plot.segment(pole_, ends[i], Meaning::construction);
    plot.label(rays_[i], pole_ + 0.5 * (ends[i] - pole_), {}, Meaning::construction);
  }
  plot.cross(pole_, Meaning::force);
  plot.label(pole_letters_, pole_, start, Meaning::force);
  return {};
}

}  // namespace epure
