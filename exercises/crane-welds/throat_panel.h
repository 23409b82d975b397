// The joint of flange and web with its two fillets: legs, faces and throat.
#pragma once

#include "exercises/kit/panels/panel.h"

namespace epure::crane_welds {

class ThroatPanel : public Panel {
 public:
  // Metres: wall of web and flange, leg of the fillets, throat.
  ThroatPanel(double wall, double leg, double throat) : wall_(wall), leg_(leg), throat_(throat) {}

  double reach() const override { return 2 * beside(); }
  bool is_in_millimetres() const override { return true; }
  drawings::Box extent(const Scale& lengths, const Scale&) const override;
  // The fillet's corners and its throat: between thick walls a small one has a close-up.
  std::vector<Place> lettered() const override {
    return {corner(), foot(), {corner().x + leg_, 0}, {corner().x, -leg_}};
  }
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language) const override;
  void draw_given(Plot& plot, const drawings::Box& room, Language language) const override;
  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override;

 private:
  // How far of the flange is drawn beside the web's middle, and of the web below the flange.
  double beside() const { return wall_ / 2 + 1.5 * leg_; }
  double below() const { return 1.5 * leg_; }
  Place corner() const { return {wall_ / 2, 0}; }
  Place foot() const;

  double wall_, leg_, throat_;
};

}  // namespace epure::crane_welds
