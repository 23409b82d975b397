#include "exercises/kit/proof/agreement.h"

#include <algorithm>
#include <cmath>

#include "exercises/kit/proof/route_names.h"
#include "exercises/kit/statement/format_words.h"

namespace epure {
namespace {

using geometry::Settled;

// Which of two routes knows more of a quantity: the smaller number.
int rank(const Settled& settled) {
  switch (settled.kind) {
    case Settled::Kind::certain:
      return 0;
    case Settled::Kind::absent:
      return 1;
    case Settled::Kind::enclosed:
      return 2;
    case Settled::Kind::unbounded:
      return 3;
    case Settled::Kind::undecided:
      break;
  }
  return 4;
}

// Of two routes that know as much, the one with the narrower enclosure: a proved zero before a tiny interval around
// it.
bool knows_more(const Settled& a, const Settled& b) {
  if (rank(a) != rank(b)) return rank(a) < rank(b);
  return a.enclosure.upper - a.enclosure.lower < b.enclosure.upper - b.enclosure.lower;
}

// Undecided and unbounded contradict nothing.
bool contradict(const Settled& a, const Settled& b) {
  if (rank(a) > 2 || rank(b) > 2) return false;
  const bool a_absent = a.kind == Settled::Kind::absent, b_absent = b.kind == Settled::Kind::absent;
  if (a_absent || b_absent) return a_absent != b_absent;
  return are_apart(a.enclosure, b.enclosure);
}

bool is_between_neighbours(const geometry::Enclosure& enclosure) {
  return std::nextafter(enclosure.lower, enclosure.upper) == enclosure.upper;
}

}  // namespace

const Settled& best_known(const std::vector<RouteValue>& routes) {
  return std::min_element(routes.begin(), routes.end(),
                          [](const RouteValue& a, const RouteValue& b) { return knows_more(a.settled, b.settled); })
      ->settled;
}

bool are_apart(const geometry::Enclosure& a, const geometry::Enclosure& b) {
  return a.upper < b.lower || b.upper < a.lower;
}

Words where_it_lies(const Settled& settled) {
  if (settled.kind == Settled::Kind::absent) return format_words("absent ({})", "assente ({})", settled.reason);
  return format_words("in [{}, {}]", "in [{}; {}]", all_digits(settled.enclosure.lower),
                      all_digits(settled.enclosure.upper));
}

std::vector<Words> contradictions(const std::vector<RouteValue>& routes) {
  std::vector<Words> sentences;
  for (auto a = routes.begin(); a != routes.end(); ++a)
    for (auto b = a + 1; b != routes.end(); ++b)
      if (contradict(a->settled, b->settled))
        sentences.push_back(format_words("{} by {}, but {} by {}", "{} ({}), ma {} ({})", where_it_lies(a->settled),
                                         route_in_words(a->route), where_it_lies(b->settled),
                                         route_in_words(b->route)));
  return sentences;
}

Words want_of_certainty(const Settled& settled) {
  if (settled.kind != Settled::Kind::enclosed || is_between_neighbours(settled.enclosure)) return {};
  return format_words("no more is known than that it lies {} ({})", "si sa soltanto che sta {} ({})",
                      where_it_lies(settled), settled.reason);
}

}  // namespace epure
