// The mechanism with its poles: D of the disc on the frame, P₂₃ of the disc on the lever.
#pragma once

#include <memory>

#include "exercises/kit/panels/mechanism.h"
#include "exercises/kit/panels/panel.h"
#include "exercises/kit/proof/solution.h"

namespace epure::pin_in_slot {

class RelativePolePanel : public Panel {
 public:
  RelativePolePanel(const Solution& solution, std::shared_ptr<const Mechanism> mechanism);

  double reach() const override { return mechanism_->reach(); }
  double times_smaller() const override { return 2; }
  drawings::Box extent(const Scale& lengths, const Scale& vectors) const override;
  drawings::Box extent_of_near(const Scale& lengths, const Scale& vectors) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override;
  void draw_given(Plot& plot, const drawings::Box& room, Language language) const override;
  std::vector<PanelStep> steps(const Plot& plot, const drawings::Box& room) const override;
  // ω₃ as measured on the velocity polygon, and on this figure.
  std::optional<MeasuredTable> measured(const Readings& readings) const override;

 private:
  std::shared_ptr<const Mechanism> mechanism_;
  std::optional<Place> pole_;  // P₂₃; none at infinity
  Arrow2 normal_;              // to the slot
  double speed_;               // of the lever, without its sense
};

}  // namespace epure::pin_in_slot
