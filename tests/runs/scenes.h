// Scenes that run in a moment, and runs of them.
#pragma once

#include <string>
#include <vector>

#include "frame/image.h"
#include "output/manifest.h"
#include "pipeline/temporary_folder.h"
#include "scene/scene.h"

namespace weir::test {

// A column of 300 particles in a tank: 0.2 s at 25 pictures per second, so that frames are 0 .. 5, of 320 x 180.
Scene dam_break_run();
// The same kind of column in three dimensions, of 192 particles.
Scene cup_run();

// A run in a folder of its own, with every frame written.
class FinishedRun {
 public:
  explicit FinishedRun(Scene scene, int threads = 2);

  Image frame(int number) const;
  int frames() const { return static_cast<int>(manifest_.frames); }
  std::filesystem::path movie() const;
  const Manifest& manifest() const { return manifest_; }
  // What the pixels of a run depend on: who drew them, and what the solver was built for.
  std::string machine() const;

 private:
  TemporaryFolder folder_;
  std::string name_;
  Manifest manifest_;
};

}  // namespace weir::test
