// The folder that a run writes: which file is where, and whose files stand there already.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "output/manifest.h"
#include "output/sink.h"
#include "scene/scene.h"

namespace weir {

// The scene as it is written to scene.yaml and hashed: all defaults filled in, the same text for the same meaning.
std::string effective_scene_text(const Scene& scene);

// The manifest of an earlier run, if there is one that can be read.
std::optional<Manifest> past_run(const std::filesystem::path& manifest_file);

class RunFolder {
 public:
  RunFolder(std::filesystem::path folder, const Scene& scene);
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  const std::filesystem::path& path() const { return folder_; }
  std::filesystem::path scene_file() const { return folder_ / "scene.yaml"; }
  std::filesystem::path manifest_file() const { return folder_ / "manifest.json"; }
  std::filesystem::path log_file() const { return folder_ / "log.csv"; }
  std::filesystem::path trace_file() const { return folder_ / "trace.json"; }
  std::filesystem::path movie_file() const;
  std::filesystem::path frame_file(std::int64_t frame) const;
  std::filesystem::path still_file(std::int64_t frame) const;

  // The run of this scene by this version stands here, ended well, and none of its files is missing.
  bool holds_finished(const Provenance& provenance) const;
  // Throws UsageError if files of a run stand here that may not be overwritten.
  void refuse_other_run(bool force) const;

  // Makes the folder and those below it, takes it for this run, and removes what an earlier run wrote, never anything
  // else. Throws OutputError, and UsageError when another process is writing a run here at this moment.
  void prepare();
  // After prepare(), when the run cannot begin: removes its files and the folders that prepare() made.
  void withdraw();

 private:
  std::vector<std::filesystem::path> files_of_runs() const;
  std::vector<std::filesystem::path> products() const;
  void make(const std::filesystem::path& folder);
  void lock();

  std::filesystem::path folder_;
  const Scene& scene_;
  std::vector<std::filesystem::path> made_;
  int lock_ = -1;  // descriptor of the folder while it is ours; the kernel lets go of it when the process ends
};

// Index of the frame at `time` s of run time.
std::int64_t frame_at(const Scene& scene, double time);

}  // namespace weir
