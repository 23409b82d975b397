#include "exercises/kit/panels/vectors_panel.h"

#include <algorithm>

#include "exercises/kit/panels/results.h"
#include "exercises/kit/panels/short_vectors.h"

namespace epure {

VectorsPanel::VectorsPanel(const Solution& solution, std::shared_ptr<const Mechanism> mechanism,
                           VectorQuantity (*vector)(const std::string& of), const std::vector<std::string>& points)
    : mechanism_(std::move(mechanism)) {
  for (const std::string& X : points) {
    const VectorQuantity quantity = vector(X);
    acting_.push_back({quantity, mechanism_->at(X), solution.vector(quantity.name)});
  }
}

Panel::Vectors VectorsPanel::vectors() const {
  double longest = 0;
  for (const Acting& each : acting_) longest = std::max(longest, magnitude(each.v));
  const std::string unit = written_unit(acting_.front().quantity.unit, Language::english);  // no vector is in words
  return {unit, longest, longest_on_paper_};
}

drawings::Box VectorsPanel::extent(const Scale& lengths, const Scale& vectors) const {
  constexpr double letters = 9;  // mm
  Extent extent;
  mechanism_->include(extent, lengths);
  const double units = vectors.mm_per_unit / lengths.mm_per_unit;
  for (const Acting& each : acting_) extent.include(lengths, each.at + units * each.v, letters);
  return extent.box();
}

std::vector<drawings::Block> VectorsPanel::draw(Plot& plot, const drawings::Box&, Language language) const {
  mechanism_->draw(plot);
  for (const Acting& each : acting_) {
    draw_terms(plot, each);
    const double mm = drawings::distance(plot.at(each.at), plot.at(plot.tip(each.at, each.v)));
    plot.vector_on(each.quantity.name, each.at, each.v,
                   each.quantity.unit == "m/s" ? Meaning::velocity : Meaning::acceleration,
                   letters_or_value(each.quantity.arrow(), magnitude(each.v), mm,
                                    written_unit(each.quantity.unit, language), language));
  }
  for (const auto& [point, other] : squares_)
    for (const Acting& each : acting_)
      if (const Place& X = mechanism_->at(point); distance(each.at, X) == 0)
        plot.right_angle(X, plot.tip(X, each.v), mechanism_->at(other));
  return {};
}

}  // namespace epure
