#include "exercises/kit/statement/long_table.h"

#include "exercises/kit/statement/csv_style.h"

namespace epure {

std::string csv(const LongTable& table) { return csv(table, CsvStyle{}); }

}  // namespace epure
