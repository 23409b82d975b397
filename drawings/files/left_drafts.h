// What a killed run leaves of files it was about to write.
#pragma once

#include <filesystem>

namespace epure::drawings {

// Removes the drafts in this folder whose processes are no more: a file that is written has a temporary name for the
// moment before it takes its place. What has any other name stays, and so do drafts of processes that run. That
// something cannot be removed is no failure.
void remove_left_drafts(const std::filesystem::path& folder);

}  // namespace epure::drawings
