#include "exercises/cli/variant.h"

#include <algorithm>
#include <cstdint>
#include <random>
#include <set>

#include "drawings/output.h"
#include "exercises/kit/panels/fit.h"

namespace epure {
namespace {

constexpr std::size_t most_tries = 200;

// Numbers by lot that are the same on every machine: the generator is the standard's, what is made of it is our own.
class Lot {
 public:
  Lot(const std::string& seed, const std::string& number) {
    std::vector<std::uint32_t> both;
    for (const char c : seed + '\n' + number) both.push_back(static_cast<unsigned char>(c));
    std::seed_seq bytes(both.begin(), both.end());
    generator_.seed(bytes);
  }
  // 0 ... count - 1, each as likely.
  std::uint64_t below(std::uint64_t count) {
    const std::uint64_t whole = std::mt19937_64::max() - std::mt19937_64::max() % count;
    std::uint64_t drawn = generator_();
    while (drawn >= whole) drawn = generator_();
    return drawn % count;
  }

 private:
  std::mt19937_64 generator_;
};

// Why nobody should have to draw it; empty: it is good.
Words awkwardness(const DrawnSheet& sheet, const std::vector<std::string>& anyway) {
  for (const Awkwardness& each : sheet.awkward)
    if (std::find(anyway.begin(), anyway.end(), each.what) == anyway.end()) return each.sentence;
  return {};
}

// How many different variants there are, up to `most`.
std::size_t count_of(const std::vector<Variation>& variations, std::size_t most) {
  std::uint64_t count = 1;
  for (const Variation& each : variations) {
    if (each.size() >= most) return most;
    count = std::min<std::uint64_t>(most, count * each.size());
  }
  return count;
}

DrawnSheet sheet_of(const Lots& lots, const std::string& sheet, const Solution& solution, const Candidate& student,
                    bool blank) {
  SheetRequest request = lots.request_of(sheet);
  request.solver = {student.name, student.number};
  request.blank = blank;
  return lots.exercise.draw(sheet, solution, request);
}

Givens givens_of(const Lots& lots, const std::vector<std::vector<std::string>>& assignments) {
  Givens givens = lots.givens;
  for (const auto& some : assignments)
    for (const std::string& each : some) givens.set(each);
  return givens;
}

}  // namespace

SheetRequest Lots::request_of(const std::string& sheet) const {
  SheetRequest of_sheet = request;
  if (const auto found = scales.find(sheet); found != scales.end()) of_sheet.scale = found->second;
  return of_sheet;
}

std::vector<std::string> awkward_as_stated(const Lots& lots) {
  std::vector<std::string> all;
  const Solution stated = lots.exercise.solution(Givens(lots.exercise.about().givens));
  SheetRequest request = lots.request;
  request.scale.reset();
  for (const std::string& sheet : lots.sheets)
    for (const Awkwardness& each : lots.exercise.draw(sheet, stated, request).awkward) all.push_back(each.what);
  return all;
}

std::vector<DrawnSheet> sheets_of(const Lots& lots, const Solution& solution, const Candidate& student, bool blank) {
  std::vector<DrawnSheet> all;
  for (const std::string& sheet : lots.sheets) all.push_back(sheet_of(lots, sheet, solution, student, blank));
  return all;
}

Solution solution_of(const Lots& lots, const std::vector<std::string>& assignments) {
  return lots.exercise.solution(givens_of(lots, {assignments}));
}

Variant draw_variant(const Lots& lots, const Candidate& student, const std::vector<std::string>& awkward_anyway) {
  Lot lot(lots.seed, student.number);
  Rejections rejected;
  const bool is_drawn_by_lot = !lots.variations.empty();
  const std::size_t different = count_of(lots.variations, most_tries);
  std::set<std::vector<std::string>> tried;
  Words last;
  for (std::size_t i = 0; i < most_tries && tried.size() < different; ++i) {
    std::vector<std::string> assignments;
    for (const Variation& each : lots.variations) assignments.push_back(each.assignment(lot.below(each.size())));
    if (!tried.insert(assignments).second) continue;
    const auto reject = [&](const Words& kind, const Words& why) {
      ++rejected[{kind.english, kind.italian}];
      last = why;
    };
    try {
      Solution solution = lots.exercise.solution(givens_of(lots, {student.assignments, assignments}));
      std::vector<DrawnSheet> solved;
      Words why;
      for (auto sheet = lots.sheets.begin(); sheet != lots.sheets.end() && why.empty(); ++sheet) {
        solved.push_back(sheet_of(lots, *sheet, solution, student, false));
        if (is_drawn_by_lot) why = awkwardness(solved.back(), awkward_anyway);
        if (!why.empty()) reject(why, format_words("{}: {}", "{}: {}", *sheet, why));
      }
      assignments.insert(assignments.begin(), student.assignments.begin(), student.assignments.end());
      if (why.empty()) return {std::move(assignments), std::move(solution), std::move(solved), std::move(rejected)};
    } catch (const DoesNotFit& why) {
      reject({"does not fit the paper", "non sta sul foglio"}, why.words());
    } catch (const drawings::TooFar& why) {
      reject({"does not fit the paper", "non sta sul foglio"}, why.words());
    } catch (const BadGivens& why) {
      reject({"impossible", "impossibile"}, why.words());
    } catch (const geometry::Impossible& why) {
      reject({"impossible", "impossibile"}, why.words());
    } catch (const geometry::Undecided& why) {
      reject({"could not be decided", "non si è potuto decidere"}, why.words());
    }
  }
  if (!is_drawn_by_lot) throw BadGivens(format_words("student {}: {}", "studente {}: {}", student.number, last));
  throw BadGivens(format_words("student {}: none of {} variants can be drawn well; of the last one: {}",
                               "studente {}: nessuna di {} varianti si disegna bene; dell'ultima: {}", student.number,
                               tried.size(), last));
}

}  // namespace epure
