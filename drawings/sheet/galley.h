// A column of set text in the making: a cursor that moves down, and the ink so far.
#pragma once

#include <string>
#include <vector>

#include "drawings/marks/style.h"
#include "drawings/page.h"

namespace epure::drawings {

struct Setting {
  double size = 3.2;  // mm, nominal size of the letters
  double air = 1;     // factor on the white space between lines and blocks
};

class Galley {
 public:
  Galley(Box room, Setting setting) : room_(room), setting_(setting), top_(room.high.y) {}

  double left() const { return room_.low.x; }
  double right() const { return room_.high.x; }
  double width() const { return room_.width(); }
  double top() const { return top_; }
  double size() const { return setting_.size; }
  double air() const { return setting_.air; }
  bool overflows() const { return top_ < room_.low.y; }
  bool empty() const { return ink_.empty(); }

  void down(double by) { top_ -= by; }
  // Baseline of a line of nominal text set at the cursor, and the distance to the next.
  double baseline() const { return top_ - 0.76 * size(); }
  double leading() const { return (1.12 + 0.2 * air()) * size(); }

  void text(const std::string& rich_text, Point baseline, double size, Weight weight = Weight::regular,
            Colour colour = black) {
    ink_.push_back(PlacedText{rich_text, baseline, size, colour, weight});
  }
  void rule(double y, double from, double to, double width) {
    ink_.push_back(Stroke{segment({from, y}, {to, y}), width, {}, black, {}, {}});
  }
  void add(std::vector<Primitive> primitives) { ink_.insert(ink_.end(), primitives.begin(), primitives.end()); }
  // What was set since there were so many primitives belongs to this step.
  std::size_t count() const { return ink_.size(); }
  void since(std::size_t before, int step) { belongs_to(step, ink_, before); }
  // Lines one under the other from the cursor; tall ones (arrows over letters, exponents) get the room they need.
  void lines(const std::vector<std::string>& lines, double left, Weight weight = Weight::regular);

  std::vector<std::string> complaints;  // what is too wide, in words
  std::vector<Primitive> take() { return std::move(ink_); }

 private:
  Box room_;
  Setting setting_;
  double top_;
  std::vector<Primitive> ink_;
};

}  // namespace epure::drawings
