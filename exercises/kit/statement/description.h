// What an exercise says of itself.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "exercises/kit/statement/format_words.h"
#include "exercises/kit/statement/givens.h"
#include "exercises/kit/statement/quantity.h"
#include "exercises/kit/statement/table_audit.h"

namespace epure {

struct SheetSpec {
  std::string name;  // "polar-diagram"
  Words title;
  Words question = {};  // of this sheet, where it is to be solved; empty: its part of the exercise's
};

// A number the source printed, and by which of its methods. `reading` is what half a millimetre on the source's own
// drawing is worth in this number (derived beside the entry); 0 for a number that was calculated, not measured.
// `explanation`, for a number that is neither rounded nor read, evaluates the source's own mistake: it must give the
// printed digits.
struct Explanation {
  Words sentence;
  std::function<double()> evaluate;
};
struct Printed {
  std::string quantity, text, route;
  double reading = 0;
  std::optional<Explanation> explanation = {};
};

// A list that is found once, when it is first looked at, as no sheet needs it and it takes long: what a source
// printed of a long table, longer than a sheet to draw. Copies share it.
template <class Entry>
class LateList {
 public:
  LateList() : LateList([] { return std::vector<Entry>{}; }) {}
  template <class Find>
  requires std::is_invocable_r_v<std::vector<Entry>, Find> LateList(Find find)
      : found_(std::make_shared<Found>()) {  // NOLINT(google-explicit-constructor)
    found_->find = std::move(find);
  }

  const std::vector<Entry>& operator()() const {
    std::call_once(found_->once, [&] { found_->list = found_->find(); });
    return found_->list;
  }

 private:
  struct Found {
    std::function<std::vector<Entry>()> find;
    std::once_flag once;
    std::vector<Entry> list;
  };
  std::shared_ptr<Found> found_;
};

struct Description {
  std::string id;  // "slider-crank-velocity"
  Words title;
  std::string document, item;  // "sapienza", "N.1"
  Words source;                // as it stands in the title block
  Words question;              // what is given and what is to be found, in sentences; rich text
  std::vector<GivenSpec> givens;
  // Numbers beside them that nobody can set, as they now are: "$m_{3}$ = 1.2 kg"; rich text.
  std::function<std::vector<Words>(const Givens&)> also_given = [](const Givens&) { return std::vector<Words>{}; };
  std::vector<SheetSpec> sheets = {};
  LateList<Quantity> quantities = {};
  LateList<Printed> printed = {};
  // Of tables that the source printed; none: it printed none.
  std::function<std::vector<TableAudit>()> audit = {};
};

}  // namespace epure
