// The mechanism of a sheet without the rest of it, for pictures of one movement that lie over each other: the plane's
// origin and the scales are the same in all of them.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>

#include "exercises/kit/panels/panel_sheet.h"

namespace epure {

class MovingMechanism {
 public:
  // Of the sheet's first panel that shows lengths, in the position that was solved; none: no panel does, or a student
  // is given nothing on it.
  static std::optional<MovingMechanism> of(const Exercise& exercise, const std::string& sheet,
                                           const Solution& solution, Language language);

  struct View {
    drawings::Point origin;  // mm of paper, of the plane's
    Scale lengths, vectors;
    drawings::Box room = drawings::drawing_area(drawings::Paper::a4);  // what lies beyond it is cut, or left out
  };
  // What a student is given; and of these quantities the vectors and points that the solved sheet draws.
  drawings::Figure drawn(const View& view, const std::set<std::string>& quantities) const;

  double reach() const { return panel().reach(); }
  // What `drawn` covers, letters included, in mm from the plane's origin, but for points that may lie far off.
  drawings::Box extent(const Scale& lengths, const Scale& vectors, const std::set<std::string>& quantities) const;
  // How many of the quantities are drawn, and the longest of those that are vectors, in this unit.
  struct Shown {
    std::size_t count = 0;
    std::string unit = {};
    double longest = 0;
  };
  Shown shown(const std::set<std::string>& quantities) const;

 private:
  explicit MovingMechanism(PanelSheet sheet, std::size_t panel, Language language)
      : sheet_(std::make_shared<const PanelSheet>(std::move(sheet))), panel_(panel), language_(language) {}
  const Panel& panel() const { return *sheet_->panels[panel_]; }
  DrawnSheet solved(const View& view) const;
  void add(const std::set<std::string>& quantities, const View& view, drawings::Figure& figure) const;

  std::shared_ptr<const PanelSheet> sheet_;
  std::size_t panel_;
  Language language_;
};

}  // namespace epure
