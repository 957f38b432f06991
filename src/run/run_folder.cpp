#include "run/run_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <set>
#include <string_view>
#include <system_error>

#include "core/error.h"
#include "output/file.h"
#include "output/manifest.h"
#include "run/left_files.h"
#include "run/outputs.h"
#include "scene/reader.h"

namespace weir {

namespace fs = std::filesystem;

namespace {

// The first line of every scene.yaml in a run folder. A file without it is the user's and is never touched.
constexpr std::string_view mark = "# The effective scene of a run of weir, all defaults filled in.\n";

// "particles_00042.vtp" -> "particles_*.vtp": the name that numbered files share.
std::string without_number(const fs::path& file) {
  std::string stem = file.stem().string();
  const std::size_t last = stem.find_last_not_of("0123456789");
  const bool numbered = last != std::string::npos && stem[last] == '_' && stem.size() - last > 5;
  if (numbered) stem.replace(last + 1, std::string::npos, "*");
  return stem + file.extension().string();
}

}  // namespace

std::optional<Manifest> past_run(const fs::path& manifest_file) {
  if (!path_exists(manifest_file)) return std::nullopt;
  try {
    return read_manifest(manifest_file);
  } catch (const OutputError&) {
    return std::nullopt;  // it cannot identify a run
  }
}

std::string effective_scene_text(const Scene& scene) { return std::string(mark) + write_scene(scene); }

RunFolder::RunFolder(fs::path folder, const Scene& scene) : folder_(std::move(folder)), scene_(scene) {}

RunFolder::~RunFolder() {
  if (lock_ >= 0) close(lock_);
}

std::vector<fs::path> RunFolder::files_of_outputs() const {
  std::vector<fs::path> files;
  for (const OutputKind& kind : output_kinds()) {
    for (const fs::path& file : kind.files(scene_)) files.push_back(file);
  }
  return files;
}

std::vector<std::string> RunFolder::top_names_of_outputs() const {
  std::vector<std::string> names;
  for (const fs::path& file : files_of_outputs()) {
    std::string name = without_number(*file.begin());
    if (file.has_parent_path()) name += '/';
    if (names.empty() || names.back() != name) names.push_back(std::move(name));
  }
  return names;
}

bool RunFolder::holds_finished(const Provenance& provenance) const {
  const std::optional<Manifest> past = past_run(manifest_file());
  if (!past || past->exit != ExitCode::done || past->version != provenance.version ||
      past->scene_sha256 != provenance.scene_sha256) {
    return false;
  }
  const std::vector<fs::path> files = files_of_outputs();
  return path_exists(scene_file()) &&
         std::all_of(files.begin(), files.end(), [this](const fs::path& file) { return path_exists(folder_ / file); });
}

std::vector<fs::path> RunFolder::files_of_runs() const {
  std::vector<fs::path> files = existing({manifest_file(), scene_file(), trace_file()});
  for (const OutputKind& kind : output_kinds()) {
    for (const fs::path& file : kind.left_in(folder_, scene_)) files.push_back(file);
  }
  return files;
}

void RunFolder::refuse_other_run(bool force) const {
  const std::vector<fs::path> files = files_of_runs();
  if (files.empty()) return;
  if (path_exists(scene_file()) && !read_file(scene_file()).starts_with(mark)) {
    throw UsageError(fmt::format("{} was not written by weir and would be overwritten: choose another folder with -o",
                                 scene_file().string()));
  }
  if (force) return;
  throw UsageError(
      fmt::format("{} holds a different or unfinished run ({}): --force overwrites it, -o chooses another folder",
                  folder_.string(), files.front().filename().string()));
}

void RunFolder::make(const fs::path& folder) {
  std::error_code failed;
  if (folder.empty() || fs::is_directory(folder, failed)) return;
  if (path_exists(folder))
    throw OutputError(fmt::format("cannot make folder {}: a file of that name exists", folder.string()));
  make(folder.parent_path());
  if (!fs::create_directory(folder, failed) && failed) {
    throw OutputError(fmt::format("cannot make folder {}: {}", folder.string(), failed.message()));
  }
  made_.push_back(folder);
}

void RunFolder::lock() {
  lock_ = open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ < 0) throw_file_error("open folder", folder_);
  // Some network file systems have no locks; a run there goes without.
  if (flock(lock_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(lock_);
  lock_ = -1;
  throw UsageError(fmt::format(
      "another process is writing a run into {} now: wait for it, or choose another folder with -o", folder_.string()));
}

void RunFolder::prepare() {
  make(folder_);
  lock();
  for (const fs::path& file : files_of_runs()) {
    std::error_code failed;
    fs::remove(file, failed);
    if (failed) throw OutputError(fmt::format("cannot remove {}: {}", file.string(), failed.message()));
  }
  std::set<fs::path> folders;
  for (const fs::path& file : files_of_outputs()) folders.insert(file.parent_path());
  for (const fs::path& folder : folders) {
    if (!folder.empty()) make(folder_ / folder);
  }
}

void RunFolder::withdraw() {
  if (lock_ < 0) return;        // prepare() left all as it was
  std::error_code not_removed;  // the error that led here is the one to report
  for (const fs::path& file : files_of_runs()) fs::remove(file, not_removed);
  for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) fs::remove(*folder, not_removed);
}

}  // namespace weir
