#include "exercises/cli/moved_by_speed.h"

#include <algorithm>

namespace epure {

std::vector<Words> moved_by_speed(const Givens& givens, const std::vector<std::string>& varied) {
  const auto varies = [&](const std::string& symbol) {
    return std::find(varied.begin(), varied.end(), symbol) != varied.end();
  };
  std::vector<Words> all;
  for (const GivenSpec& spec : givens.specs()) {
    if (!spec.turned || !givens.follows(spec.symbol)) continue;
    const auto& [instant, speed] = *spec.turned;
    if (!varies(speed) || varies(spec.symbol) || varies(instant)) continue;
    const Givens stated(givens.specs());
    const auto read = stated.reading(spec.symbol);
    all.push_back(format_words(
        "{0} changes with {1}, as the instant {2} is what is stated; --set {0}={3} keeps it",
        "{0} cambia con {1}, perché ciò che è dato è l'istante {2}; --set {0}={3} lo tiene fermo", spec.symbol, speed,
        instant, read ? stated.text(spec.symbol) + read->unit.symbol : std::string("...")));
  }
  return all;
}

}  // namespace epure
