// Pictures back from files: PNG by stb_image, movies by libav (module weir_movie). For `compare` and the tests.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
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
// Frame after frame, so that two movies can be compared without keeping either.
class MovieReader {
 public:
  MovieReader() = default;
  virtual ~MovieReader() = default;
  MovieReader(const MovieReader&) = delete;
  MovieReader& operator=(const MovieReader&) = delete;

  // False at the end. Without an image the frame is only counted. Throws OutputError.
  virtual bool next(Image* image) = 0;
  virtual MovieFacts facts() const = 0;  // frames and times are those of the frames so far
};
std::unique_ptr<MovieReader> make_movie_reader(const std::filesystem::path& file);  // throws OutputError

// Decodes every frame; `each` may be empty. Throws OutputError.
MovieFacts decode_movie(const std::filesystem::path& file,
                        const std::function<void(std::int64_t index, const Image& image)>& each);

}  // namespace weir
