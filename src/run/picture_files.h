// Where a run's pictures are: paths in its folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "scene/scene.h"

namespace weir {

// Index of the frame at `time` s of run time.
std::int64_t frame_at(const Scene& scene, double time);

std::filesystem::path movie_file(const Scene& scene);
std::filesystem::path frame_file(std::int64_t frame);
std::filesystem::path still_file(std::int64_t frame);

// Those that the scene asks for.
std::vector<std::filesystem::path> picture_files(const Scene& scene);
// Pictures in the folder that a run of this name may have written.
std::vector<std::filesystem::path> pictures_left_in(const std::filesystem::path& folder, const Scene& scene);

}  // namespace weir
