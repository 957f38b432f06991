#include <fmt/format.h>

#include "core/error.h"
#include "core/module.h"
#include "output/decode.h"
#include "output/movie_module.h"
#include "output/sink.h"

namespace weir {

namespace {

template <class Function>
Function* movie_function(const char* symbol) {
  try {
    return module_function<Function>("weir_movie", symbol);
  } catch (const std::runtime_error& error) {
    throw OutputError(fmt::format("no movie can be written or read: {}", error.what()));
  }
}

}  // namespace

void load_movies() { movie_function<decltype(weir_open_movie)>("weir_open_movie"); }

std::unique_ptr<MovieSink> make_movie_sink(const std::filesystem::path& folder, const Scene& scene,
                                           const Provenance& provenance) {
  std::unique_ptr<MovieSink> sink;
  movie_function<decltype(weir_open_movie)>("weir_open_movie")(folder, scene, provenance, sink);
  return sink;
}

std::vector<std::string> list_encoders() {
  std::vector<std::string> names;
  movie_function<decltype(weir_list_encoders)>("weir_list_encoders")(names);
  return names;
}

std::unique_ptr<MovieReader> make_movie_reader(const std::filesystem::path& file) {
  std::unique_ptr<MovieReader> reader;
  movie_function<decltype(weir_read_movie)>("weir_read_movie")(file, reader);
  return reader;
}

MovieFacts decode_movie(const std::filesystem::path& file,
                        const std::function<void(std::int64_t index, const Image& image)>& each) {
  const std::unique_ptr<MovieReader> reader = make_movie_reader(file);
  Image image;
  for (std::int64_t index = 0; reader->next(each ? &image : nullptr); ++index) {
    if (each) each(index, image);
  }
  return reader->facts();
}

}  // namespace weir
