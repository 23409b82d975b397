// The reader of reference values (bench/corpus.h), by the names the tests use.
#pragma once

#include "bench/corpus.h"

namespace epure::tests {

using bench::CorpusCase;
using bench::exact_decimal;
using bench::read_corpus;
using bench::Reference;

}  // namespace epure::tests
