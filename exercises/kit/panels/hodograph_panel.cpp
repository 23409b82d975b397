#include "exercises/kit/panels/hodograph_panel.h"

#include <algorithm>

namespace epure {

Panel::Vectors HodographPanel::vectors() const {
  double longest = 0;
  for (const Hodograph::Curve& curve : hodograph_.curves)
    for (const Place& P : curve.points) longest = std::max(longest, magnitude({P.x, P.y}));
  return {hodograph_.unit, longest, 400};
}

drawings::Box HodographPanel::extent(const Scale&, const Scale& vectors) const {
  constexpr double air = 9;
  Extent all;
  all.include(vectors, {0, 0}, air);
  for (const Hodograph::Curve& curve : hodograph_.curves)
    for (const Place& P : curve.points) all.include(vectors, P, air);
  return all.box();
}

std::vector<drawings::Block> HodographPanel::draw(Plot& plot, const drawings::Box&, Language) const {
  const Place pole{0, 0};
  Place low = pole, high = pole;
  for (const Hodograph::Curve& curve : hodograph_.curves)
    for (const Place& P : curve.points) {
      low = {std::min(low.x, P.x), std::min(low.y, P.y)};
      high = {std::max(high.x, P.x), std::max(high.y, P.y)};
    }
  plot.direction_line({low.x, 0}, {high.x, 0}, 5, hodograph_.x_letters);
  plot.direction_line({0, low.y}, {0, high.y}, 5, hodograph_.y_letters);
  for (const Hodograph::Curve& curve : hodograph_.curves) {
    std::vector<drawings::Point> points;
    for (const Place& P : curve.points) points.push_back(plot.at(P));
    plot.mark(drawings::Line{drawings::polyline(points, false), curve.meaning, curve.name});
  }
  for (const Hodograph::Instant& each : hodograph_.instants) {
    if (each.with_arrow) plot.side("", pole, each.tip, Meaning::force, each.letters, Place{0, each.tip.y / 2});
    plot.dot(each.tip, Meaning::force);
    plot.small_label(each.label, each.tip, {0, (low.y + high.y) / 2});
    const auto measure = [&](const std::string& name, const Place& to, Measurement::Kind kind) {
      if (!name.empty() && plot.shows(pole) && plot.shows(to))
        plot.onto().measurements.push_back({name, plot.at(pole), plot.at(to), 1 / plot.scale().mm_per_unit, kind});
    };
    measure(each.along_x, {each.tip.x, 0}, Measurement::along_x);
    measure(each.along_y, {0, each.tip.y}, Measurement::along_y);
  }
  plot.dot(pole);
  plot.label(hodograph_.pole, pole);
  return {};
}

}  // namespace epure
