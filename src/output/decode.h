// Pictures back from files: PNG by stb_image, movies by libav (module weir_movie). For `compare` and the tests.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "frame/image.h"

namespace weir {

Image read_png(const std::filesystem::path& file);  // throws OutputError

struct MovieFacts {
  int width = 0;
  int height = 0;
  std::string codec;         // "h264"
  std::string profile;       // "High"
  std::string pixel_format;  // "yuv420p"
  std::string color_space;   // "bt709"; likewise the next three
  std::string color_primaries;
  std::string color_transfer;
  std::string color_range;  // "tv"
  double frame_rate = 0;
  std::int64_t frames = 0;    // decoded
  double first_time = 0;      // s
  double last_time = 0;       // s
  double max_time_error = 0;  // s, largest |time of frame k - k / frame_rate|
  bool faststart = false;     // moov before mdat
};
// Decodes every frame; `each` may be empty. Throws OutputError.
MovieFacts decode_movie(const std::filesystem::path& file,
                        const std::function<void(std::int64_t index, const Image& image)>& each);

}  // namespace weir
