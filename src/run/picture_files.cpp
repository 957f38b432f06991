#include "run/picture_files.h"

#include <fmt/format.h>

#include <cmath>

#include "run/left_files.h"

namespace weir {

namespace fs = std::filesystem;

std::int64_t frame_at(const Scene& scene, double time) { return std::llround(time * scene.render.fps); }

fs::path movie_file(const Scene& scene) { return scene.name + ".mp4"; }

fs::path frame_file(std::int64_t frame) { return fs::path("frames") / fmt::format("frame_{:05}.png", frame); }

fs::path still_file(std::int64_t frame) { return fs::path("stills") / fmt::format("still_{:05}.png", frame); }

std::vector<fs::path> picture_files(const Scene& scene) {
  std::vector<fs::path> files;
  if (scene.output.movie) files.push_back(movie_file(scene));
  if (scene.output.frames) {
    for (std::int64_t frame = 0; frame <= last_frame(scene); ++frame) files.push_back(frame_file(frame));
  }
  for (const double time : scene.output.stills) files.push_back(still_file(frame_at(scene, time)));
  return files;
}

std::vector<fs::path> pictures_left_in(const fs::path& folder, const Scene& scene) {
  std::vector<fs::path> files = existing({folder / movie_file(scene), folder / (scene.name + ".part.mp4")});
  for (const fs::path& png : numbered_files(folder / "frames", "frame_", ".png")) files.push_back(png);
  for (const fs::path& png : numbered_files(folder / "stills", "still_", ".png")) files.push_back(png);
  return files;
}

}  // namespace weir
