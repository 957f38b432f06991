// The folder that a run writes: its files, and those of earlier runs that it may replace.
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
  std::filesystem::path trace_file() const { return folder_ / "trace.json"; }
  // Files and folders of the outputs that the scene asks for: "dam_break.mp4", "frames/", "particles_*.vtp".
  std::vector<std::string> top_names_of_outputs() const;

  // The run of this scene by this version is here, ended without error, and lacks none of its files.
  bool holds_finished(const Provenance& provenance) const;
  // Throws UsageError if the folder holds files of a run that may not be overwritten.
  void refuse_other_run(bool force) const;

  // Makes the folder and those below it, locks it for this run, and removes the files of an earlier run, never anything
  // else. Throws OutputError, and UsageError while another process is writing a run here.
  void prepare();
  // After prepare(), when the run cannot begin: removes its files and the folders that prepare() made.
  void withdraw();

 private:
  std::vector<std::filesystem::path> files_of_runs() const;     // that exist
  std::vector<std::filesystem::path> files_of_outputs() const;  // of this run, by their paths in the folder
  void make(const std::filesystem::path& folder);
  void lock();

  std::filesystem::path folder_;
  const Scene& scene_;
  std::vector<std::filesystem::path> made_;
  int lock_ = -1;  // descriptor of the locked folder; the kernel unlocks it when the process ends
};

}  // namespace weir
