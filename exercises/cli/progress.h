// How far a sweep or a class has come, told on a terminal.
#pragma once

#include <chrono>
#include <cstdint>
#include <ostream>

#include "exercises/kit/statement/format_words.h"

namespace epure {

// "37 %, 1 min 20 s left" in one line that is written over, and gone at the end. Nothing when it is not shown.
class Progress {
 public:
  Progress(std::uint64_t rows, bool is_shown, std::ostream& err, Language language)
      : rows_(rows), is_shown_(is_shown), err_(err), language_(language), begun_(Clock::now()), told_(begun_) {}
  ~Progress() {
    if (is_shown_) err_ << clear_line << std::flush;
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void has_done(std::uint64_t rows) {
    done_ += rows;
    const auto now = Clock::now();
    constexpr std::chrono::milliseconds between{200};
    if (!is_shown_ || now - told_ < between) return;
    told_ = now;
    const double done = static_cast<double>(done_) / static_cast<double>(rows_),
                 passed = std::chrono::duration<double>(now - begun_).count();
    err_ << clear_line
         << format_words("{:.0f} %, {} left", "{:.0f} %, ancora {}", 100 * done, duration(passed / done - passed))
                .in(language_)
         << std::flush;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr const char* clear_line = "\r\x1b[K";

  static std::string duration(double seconds) {
    const auto whole = static_cast<std::uint64_t>(seconds);
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
    return fmt::format("{} h {} min", whole / 3600, whole / 60 % 60);
  }

  std::uint64_t rows_, done_ = 0;
  bool is_shown_;
  std::ostream& err_;
  Language language_;
  Clock::time_point begun_, told_;
};

}  // namespace epure
