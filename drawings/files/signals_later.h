// Ctrl-C while there is something to clear away.
#pragma once

namespace epure::drawings {

// Ctrl-C and a plain kill wait until what was begun is done, in whichever threads: no draft stays behind, and of
// several files none is replaced without the others. What is ignored (nohup) stays so.
class SignalsLater {
 public:
  SignalsLater();
  // The last one that ends lets through what waited.
  ~SignalsLater();
  SignalsLater(const SignalsLater&) = delete;
  SignalsLater& operator=(const SignalsLater&) = delete;

  // Whether one waits.
  static bool is_interrupted();
};

}  // namespace epure::drawings
