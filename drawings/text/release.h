// Objects of C libraries, released by the function that belongs to them.
#pragma once

#include <memory>

namespace epure::drawings {

template <auto release>
struct Release {
  template <class T>
  void operator()(T* what) const {
    release(what);
  }
};
template <class T, auto release>
using Held = std::unique_ptr<T, Release<release>>;

}  // namespace epure::drawings
