// The whole wheels, or as much of them as shows their teeth, with their circles and radii.
#pragma once

#include "exercises/gear-pair/teeth.h"
#include "exercises/kit/panels/panel.h"

namespace epure::gear_pair {

class WheelsPanel : public Panel {
 public:
  enum class View {
    both_whole,
    one_whole,  // the other would be too large: as much of it as fits
    circles     // whole, without teeth, as ISO 2203 draws gears
  };
  explicit WheelsPanel(Pair pair) : pair_(std::move(pair)) {}

  bool is_in_millimetres() const override { return true; }
  bool is_cut() const override { return true; }
  double reach() const override;
  // Whole wheels when their teeth can be seen, else one whole wheel, else circles.
  void choose_view(const drawings::Box& whole_room, const SheetRequest& request) override;
  drawings::Box extent(const Scale& scale, const Scale&) const override { return extent_of(view_, scale); }
  void draw_given(Plot& plot, const drawings::Box& room, Language language) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box& room, Language language) const override;

 private:
  drawings::Box extent_of(View view, const Scale& scale) const;

  Pair pair_;
  View view_ = View::both_whole;
};

}  // namespace epure::gear_pair
