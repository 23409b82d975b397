// What does not fit into a room of the paper: lines that end at its border, and words for what lies beyond.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exercises/kit/panels/plot.h"
#include "exercises/kit/panels/rounded.h"

namespace epure {

bool is_in(const drawings::Box& room, const Plot& plot, const Place& P);

// From X along the direction (not zero) as far as the room reaches.
Place at_edge(const Plot& plot, const drawings::Box& room, const Place& X, const Arrow2& direction);

// The same, ending a little inside of the room, where letters find room.
Place ray_to_edge(const Plot& plot, const drawings::Box& room, const Place& X, const Arrow2& direction);

// From X towards a point beyond the room: such a line, with "to Ω" at its end, which is returned.
Place draw_towards(Plot& plot, const drawings::Box& room, const Place& X, const Place& beyond,
                   const std::string& letters, Language language);

// The circle about `centre` through X, with its tangent there should it be too large to tell from it. (centre ≠ X)
DrawnCycle circle_through(const Place& X, const Place& centre);

// What a picture leaves beyond the border of its room. Points at infinity and circles that are lines are none of it.
class OffSheet {
 public:
  OffSheet(const Plot& plot, const drawings::Box& room) : plot_(plot), room_(room) {}

  void point(const std::string& letters, const std::optional<Place>& P);
  // `part`: "part of the inflection circle".
  void circle(const Words& part, const DrawnCycle& cycle);
  void add(const OffSheet& other) { found_.insert(found_.end(), other.found_.begin(), other.found_.end()); }
  // "Off the sheet: J, part of the inflection circle." Empty when there is nothing.
  std::string sentence(Language language) const;

 private:
  const Plot& plot_;
  drawings::Box room_;
  std::vector<Words> found_ = {};
};

}  // namespace epure
