// Independent jobs on all processors.
#pragma once

#include <cstddef>
#include <functional>

namespace epure {

// Runs job(0), ..., job(count - 1), as many at a time as there are processors; alone in this thread when that is one,
// or there are too few jobs to be worth a second thread. When jobs throw, the exception of the first of them in this
// order comes through, as if they had run one after the other; jobs that would then not have run may or may not have.
void abreast(std::size_t count, const std::function<void(std::size_t)>& job);

}  // namespace epure
