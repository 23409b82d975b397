// Where a label could stand, and how good each place is as far as the drawing alone decides.
#pragma once

#include <optional>
#include <vector>

#include "drawings/labels/labels.h"

namespace epure::drawings {

struct Candidate {
  Box box;
  std::optional<Segment> leader = {};
  double cost = 0;       // without other labels
  bool blocked = false;  // touches a line or symbol
  double own = 0;        // of a step's number: from its middle to the nearest that its step drew
};

// The prices of bad places, in one currency: a millimetre away from what the label names costs 1.
namespace price {
inline constexpr double wrong_side = 4;         // at worst, when a side was asked for
inline constexpr double usual_side = 0.8;       // at worst, when none was
inline constexpr double off_middle = 5;         // from the middle of a segment to its end
inline constexpr double as_near_as_own = 8;     // another step's line, to a step's number
inline constexpr double along_line = 0.4;       // a millimetre, from the place of a step's number
inline constexpr double crowded = 8;            // as near to a line as possible without touching
inline constexpr double leader = 14;            // more than any bad choice of side
inline constexpr double short_leader = 5;       // to letters that stand a little off: any near place is better
inline constexpr double leader_crossing = 1.5;  // a line under the leader
inline constexpr double touch_thin = 45, touch_heavy = 70, inside = 6;  // then a millimetre of line under it
inline constexpr double stranger = 42;           // nearer to another thing of the kind it names: a leader is better
inline constexpr double near_stranger = 5;       // as near
inline constexpr double out_of_window = 30;      // a close-up's letters beyond its frame: a leader within is better
inline constexpr double past_stranger = 10;      // with a leader across one: a longer one elsewhere is better
inline constexpr double behind_another = 10;     // a point's or an arc's letters: less than a leader
inline constexpr double letters_of_another = 6;  // as near to a step's number as what that step drew
inline constexpr double one_word = 6;            // letters of two things in a row, as near as they may stand
inline constexpr double overlap = 120;           // of two labels
inline constexpr double leader_through = 60;     // a leader through another label
inline constexpr double leaders_crossed = 10;
}  // namespace price

bool cross(const Segment& first, const Segment& second);

// Places inside `area` around the point the label belongs to, where it touches nothing, that cost less than `below`.
std::vector<Candidate> clear_places_around_point(const LabelBox& label, const Obstacles& obstacles, Box area,
                                                 double below);
// The same beside the point or the segment it belongs to.
std::vector<Candidate> clear_places(const LabelBox& label, const Obstacles& obstacles, Box area);
// Farther off, with leaders, touching nothing: each costs at least price::leader.
std::vector<Candidate> places_with_leader(const LabelBox& label, const Obstacles& obstacles, Box area);
// As near as the clear ones, but touching a line or symbol: each costs at least price::touch_thin.
std::vector<Candidate> touching_places(const LabelBox& label, const Obstacles& obstacles, Box area);

}  // namespace epure::drawings
