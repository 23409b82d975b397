// The whole bench.
#pragma once

#include <functional>

#include "bench/results.h"
#include "exercises/kit/proof/exercise.h"

namespace epure::bench {

// Takes about `seconds`, and not less than looking once at every case of the corpora. `progress` is told what is
// measured next. Throws what reading the corpora throws.
Report run_bench(const Catalogue& exercises, double seconds, const std::function<void(const std::string&)>& progress);

// A table for a terminal.
std::string text_of(const Report& report);
// {"schema":"epure.bench/1","results":[...]}; a bound that was not promised is null.
std::string json_of(const Report& report);
// What was measured, drawn: speed against error, worst errors, curves, whole sheets.
std::vector<drawings::Sheet> sheets_of(const Report& report, Language language, drawings::Paper paper);

// Short forms for tables: "0.04 ns", "1.23 µs" of nanoseconds; "1.2e-16", "0", "∞" of errors.
std::string short_time(double ns);
std::string short_error(double error);

}  // namespace epure::bench
