// A force shared out between two lines parallel to it: its polygon with pole and rays. The strings parallel to the
// rays stand on the body (FreeBodyPanel::string).
#pragma once

#include <array>
#include <string>
#include <vector>

#include "exercises/kit/panels/panel.h"

namespace epure {

class SharedLoadPanel : public Panel {
 public:
  struct Part {
    std::string quantity;  // what a ruler reads; empty: nothing
    std::string label;
    Arrow2 v;
  };
  // The first part starts where the whole does; the second ends where it does. `pole`: from where the whole starts.
  SharedLoadPanel(Part whole, Part first, Part second, const Arrow2& pole, std::string unit)
      : whole_(std::move(whole)),
        first_(std::move(first)),
        second_(std::move(second)),
        pole_{pole.x, pole.y},
        unit_(std::move(unit)) {}
  // Of the rays to the start, to the end and between the parts; and of the pole.
  SharedLoadPanel& named(std::array<std::string, 3> rays, std::string pole) {
    rays_ = std::move(rays);
    pole_letters_ = std::move(pole);
    return *this;
  }
  enum class At { pole, between };
  SharedLoadPanel& step(const Words& text, At at) {
    steps_.push_back({text, at == At::pole ? pole_ : Place{first_.v.x, first_.v.y}});
    return *this;
  }

  bool is_of_vectors() const override { return true; }
  Vectors vectors() const override;
  drawings::Box extent(const Scale&, const Scale& vectors) const override;
  std::vector<drawings::Block> draw(Plot& plot, const drawings::Box&, Language language) const override;
  std::vector<PanelStep> steps(const Plot&, const drawings::Box&) const override { return steps_; }

 private:
  Place end() const { return {whole_.v.x, whole_.v.y}; }
  Place between() const { return {first_.v.x, first_.v.y}; }
  // Beside the whole, on the side without the pole, where parts would cover it: so many mm off.
  Arrow2 aside(double mm, const Scale& vectors) const;

  Part whole_, first_, second_;
  Place pole_;
  std::string unit_, pole_letters_;
  std::array<std::string, 3> rays_;
  std::vector<PanelStep> steps_;
};

}  // namespace epure
