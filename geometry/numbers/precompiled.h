// What nearly every source reads and nobody here changes (geometry/CMakeLists.txt). No header of ours: included from
// here it would count as the system's, and lose its warnings.
#pragma once

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>
