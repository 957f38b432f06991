// Finding the files of earlier runs.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

namespace weir {

// Whether the path exists, be it as a dangling link.
bool path_exists(const std::filesystem::path& file);

// Those of the files that exist.
std::vector<std::filesystem::path> existing(const std::vector<std::filesystem::path>& files);

// Files in `folder` named by `prefix`, five digits or more, and `suffix`.
std::vector<std::filesystem::path> numbered_files(const std::filesystem::path& folder, std::string_view prefix,
                                                  std::string_view suffix);

}  // namespace weir
