#include "run/run_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <string_view>
#include <system_error>

#include "core/error.h"
#include "output/file.h"
#include "output/manifest.h"
#include "scene/reader.h"

namespace weir {

namespace fs = std::filesystem;

namespace {

// The first line of every scene.yaml in a run folder. What lacks it is a file of the user's and is never touched.
constexpr std::string_view mark = "# The effective scene of a run of weir, all defaults filled in.\n";

bool stands(const fs::path& file) {
  std::error_code unknown;
  return fs::exists(fs::symlink_status(file, unknown));
}

// Whether a name is `prefix`, five digits or more, and ".png".
bool is_numbered_png(std::string_view name, std::string_view prefix) {
  constexpr std::string_view suffix = ".png";
  if (!name.starts_with(prefix) || !name.ends_with(suffix)) return false;
  name.remove_prefix(prefix.size());
  name.remove_suffix(std::min(suffix.size(), name.size()));
  return name.size() >= 5 && name.find_first_not_of("0123456789") == std::string_view::npos;
}

void append_numbered_pngs(const fs::path& folder, std::string_view prefix, std::vector<fs::path>& files) {
  std::error_code missing;
  for (fs::directory_iterator entry(folder, missing), end; !missing && entry != end; entry.increment(missing)) {
    if (is_numbered_png(entry->path().filename().string(), prefix)) files.push_back(entry->path());
  }
}

}  // namespace

std::optional<Manifest> past_run(const fs::path& manifest_file) {
  if (!stands(manifest_file)) return std::nullopt;
  try {
    return read_manifest(manifest_file);
  } catch (const OutputError&) {
    return std::nullopt;  // whatever it is, no run that could be known again
  }
}

std::string effective_scene_text(const Scene& scene) { return std::string(mark) + write_scene(scene); }

std::int64_t frame_at(const Scene& scene, double time) { return std::llround(time * scene.render.fps); }

RunFolder::RunFolder(fs::path folder, const Scene& scene) : folder_(std::move(folder)), scene_(scene) {}

RunFolder::~RunFolder() {
  if (lock_ >= 0) close(lock_);
}

fs::path RunFolder::movie_file() const { return folder_ / (scene_.name + ".mp4"); }

fs::path RunFolder::frame_file(std::int64_t frame) const {
  return folder_ / "frames" / fmt::format("frame_{:05}.png", frame);
}

fs::path RunFolder::still_file(std::int64_t frame) const {
  return folder_ / "stills" / fmt::format("still_{:05}.png", frame);
}

std::vector<fs::path> RunFolder::products() const {
  std::vector<fs::path> files{scene_file(), log_file()};
  if (scene_.output.movie) files.push_back(movie_file());
  if (scene_.output.frames) {
    for (std::int64_t frame = 0; frame <= last_frame(scene_); ++frame) files.push_back(frame_file(frame));
  }
  for (const double time : scene_.output.stills) files.push_back(still_file(frame_at(scene_, time)));
  return files;
}

bool RunFolder::holds_finished(const Provenance& provenance) const {
  const std::optional<Manifest> past = past_run(manifest_file());
  if (!past || past->exit != ExitCode::done || past->version != provenance.version ||
      past->scene_sha256 != provenance.scene_sha256) {
    return false;
  }
  for (const fs::path& file : products()) {
    if (!stands(file)) return false;
  }
  return true;
}

std::vector<fs::path> RunFolder::files_of_runs() const {
  std::vector<fs::path> files;
  const auto append_existing = [&files](const fs::path& file) {
    if (stands(file)) files.push_back(file);
  };
  append_existing(manifest_file());
  append_existing(scene_file());
  append_existing(log_file());
  append_existing(trace_file());
  append_existing(movie_file());
  append_existing(folder_ / (scene_.name + ".part.mp4"));
  append_numbered_pngs(folder_ / "frames", "frame_", files);
  append_numbered_pngs(folder_ / "stills", "still_", files);
  return files;
}

void RunFolder::refuse_other_run(bool force) const {
  const std::vector<fs::path> files = files_of_runs();
  if (files.empty()) return;
  if (stands(scene_file()) && !read_file(scene_file()).starts_with(mark)) {
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
  if (stands(folder)) throw OutputError(fmt::format("cannot make folder {}: a file is there", folder.string()));
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
  if (scene_.output.frames) make(folder_ / "frames");
  if (!scene_.output.stills.empty()) make(folder_ / "stills");
}

void RunFolder::withdraw() {
  if (lock_ < 0) return;        // prepare() left all as it was
  std::error_code not_removed;  // the trouble that led here is the one to tell
  for (const fs::path& file : files_of_runs()) fs::remove(file, not_removed);
  for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) fs::remove(*folder, not_removed);
}

}  // namespace weir
