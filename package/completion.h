// What shells complete, as lines for the scripts beside this file.
#pragma once

#include <string>

#include "exercises/kit/proof/exercise.h"

namespace epure {

// Fields with tabulators between:
//   verb      VERB  meaning
//   option    VERB  --option  TYPE  meaning       of the program, VERB is -; of a flag, TYPE is -
//   value     VERB  --option  one of the words it takes
//   exercise  ID  title
//   sheet     ID  sheet  title
//   given     ID  symbol  meaning
//   quantity  ID  name  meaning
// Throws std::logic_error where a value is listed of an option that is no more.
// Plain text without straight quotation marks, backslashes or dollars, so that it may stand quoted in any shell.
std::string completion_lines(const Catalogue& exercises);

}  // namespace epure
