// Sinks of pictures: PNG files (in the program), a movie (in the module weir_movie).
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "frame/image.h"
#include "scene/scene.h"

namespace weir {

// Facts written beside the pixels.
struct Provenance {
  std::string scene_sha256;  // of the effective scene's text
  std::string version;
};

class MovieSink {
 public:
  virtual ~MovieSink() = default;
  MovieSink() = default;
  MovieSink(const MovieSink&) = delete;
  MovieSink& operator=(const MovieSink&) = delete;

  // Pictures come in order, one per frame time. Throws OutputError.
  virtual void write(const MovieImage& image) = 0;
  // Drains the encoder and turns <name>.part.mp4 into the faststart <name>.mp4. Without it the part file stays
  // playable. Throws OutputError.
  virtual void finish() = 0;
  virtual const std::string& encoder() const = 0;
};

// Loads the module in advance, which takes some 30 ms. Throws OutputError.
void load_movies();

// Loads the module. Writes <folder>/<name>.part.mp4 while open. Throws OutputError (no encoder: all that were tried).
std::unique_ptr<MovieSink> make_movie_sink(const std::filesystem::path& folder, const Scene& scene,
                                           const Provenance& provenance);
std::vector<std::string> list_encoders();

// A PNG with scene hash, version and time in tEXt, no wall-clock time. `alpha` keeps transparency. Throws OutputError.
void write_png(const std::filesystem::path& file, const Image& image, bool alpha, const Provenance& provenance,
               double time);

}  // namespace weir
