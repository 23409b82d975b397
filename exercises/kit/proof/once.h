// What is dear, found when it is first asked for.
#pragma once

#include <functional>
#include <optional>
#include <utility>

namespace epure {

template <class T>
class Once {
 public:
  explicit Once(std::function<T()> find) : find_(std::move(find)) {}
  const T& operator()() const {
    if (!found_) found_ = find_();
    return *found_;
  }

 private:
  std::function<T()> find_;
  mutable std::optional<T> found_;
};

}  // namespace epure
