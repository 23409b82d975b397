// What the column tells as results: quantities of the solution, and nothing else.
#pragma once

#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "drawings/picture.h"
#include "exercises/kit/proof/solution.h"

namespace epure {

// A line or a table; none when the quantities do not exist.
class Result {
 public:
  using Tell = std::function<std::optional<drawings::Block>(const Solution&, Language)>;
  // A quantity it tells: the sheet to be solved asks for it, in the unit in which it is told.
  struct Asked {
    std::string quantity;
    bool is_in_workshop_unit = false;
  };

  // What asks for nothing: words.
  template <std::convertible_to<Tell> Function>
  Result(Function tell) : tell_(std::move(tell)) {}
  Result(Tell tell, std::vector<Asked> asked) : tell_(std::move(tell)), asked_(std::move(asked)) {}
  Result(Tell tell, const std::vector<std::string>& asked, bool in_workshop_units = false);

  std::optional<drawings::Block> operator()(const Solution& solution, Language language) const {
    return tell_(solution, language);
  }
  const std::vector<Asked>& asked() const { return asked_; }

 private:
  Tell tell_;
  std::vector<Asked> asked_ = {};
};

// "v_A = (12.7; 1.7) m/s,  v_A = 12.8 m/s", with an arrow over the first.
Result components(const VectorQuantity& quantity);
// "P0 = (0; 4) m"
Result coordinates(const std::string& point);
// A row of coordinates for each point, by its letters (rich text) and its name.
Result coordinates(const std::vector<std::pair<std::string, std::string>>& points);

// "ω2 = 37.70 rad/s,  ω3 = −13.33 rad/s"
Result values(const std::vector<std::string>& names);
// The same in the workshop's units, where there are any: "σ = 49.33 MPa".
Result workshop_values(const std::vector<std::string>& names);
// One of them under another symbol.
Result value_as(const std::string& symbol, const std::string& name);
// A row for each point, under heads with X for it: of "v_{}" the quantity is v_B in the row of B. What does not exist
// is at infinity.
struct Column {
  std::string head, name;  // "$v_{X}$ (m/s)", "v_{}"
};
Result by_point(const std::vector<std::string>& points, const std::vector<Column>& columns);
// A row of quantities after its first cell. What does not exist is at infinity, unless told.
struct Row {
  std::string head;
  std::vector<std::string> names;  // empty: there is no such quantity here
  std::string where_none = "∞";
  bool is_in_workshop_units = false;  // mm, MPa
};
Result table(const std::vector<std::string>& heads, const std::vector<Row>& rows, int significant = 4);
// Words, in a paragraph of their own; none when they are empty.
Result remark(const std::string& words);

// "mm/s", "MPa": as it is told in the column, or in the workshop's unit.
std::string unit_told(const Quantity& quantity, bool in_workshop_unit, Language language);

// As sheets write it: "m/s²", "°", in Italian "giri/min" for rpm; nothing of a pure number.
std::string written_unit(const std::string& unit, Language language);
// The same behind a number, from which it does not part: "°", and others after a blank.
std::string unit_after_number(const std::string& unit, Language language);

}  // namespace epure
