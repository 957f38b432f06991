#include "run/left_files.h"

#include <algorithm>
#include <string>
#include <system_error>

namespace weir {

namespace fs = std::filesystem;

namespace {

bool is_numbered(std::string_view name, std::string_view prefix, std::string_view suffix) {
  if (!name.starts_with(prefix) || !name.ends_with(suffix)) return false;
  name.remove_prefix(prefix.size());
  name.remove_suffix(std::min(suffix.size(), name.size()));
  return name.size() >= 5 && name.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

bool path_exists(const fs::path& file) {
  std::error_code unknown;
  return fs::exists(fs::symlink_status(file, unknown));
}

std::vector<fs::path> existing(const std::vector<fs::path>& files) {
  std::vector<fs::path> found;
  std::copy_if(files.begin(), files.end(), std::back_inserter(found), path_exists);
  return found;
}

std::vector<fs::path> numbered_files(const fs::path& folder, std::string_view prefix, std::string_view suffix) {
  std::vector<fs::path> files;
  std::error_code missing;
  for (fs::directory_iterator entry(folder, missing), end; !missing && entry != end; entry.increment(missing)) {
    if (is_numbered(entry->path().filename().string(), prefix, suffix)) files.push_back(entry->path());
  }
  return files;
}

}  // namespace weir
