// The families, measured: a few in each of four files, because each is a template on five numbers.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/results.h"

namespace epure::bench {

struct FamilyJob {
  std::string name;
  // The folder of the corpora; seconds for each number.
  std::function<std::vector<FamilyResult>(const std::string& corpora, double budget)> measure;
  std::function<DecisionResult(const std::string& corpora)> decide;
};
std::vector<FamilyJob> linkage_jobs();
std::vector<FamilyJob> plane_jobs();
std::vector<FamilyJob> gear_jobs();
std::vector<FamilyJob> meeting_jobs();

// All of them.
std::vector<FamilyJob> family_jobs();

}  // namespace epure::bench
