// What compression costs and saves at 1080p, for 15,000 moving discs: presets of the movie's encoder, levels of PNG files.
#include <benchmark/benchmark.h>
#include <libdeflate.h>

#include <cmath>
#include <filesystem>
#include <memory>

#include "output/decode.h"
#include "output/sink.h"
#include "render/renderer.h"
#include "stills.h"

namespace weir {
namespace {

constexpr int frames = 60;
constexpr int particles = 15000;

std::vector<MovieImage> movie_images(const Still& still) {
  const auto renderer = make_renderer(still.scene, still.static_scene, device_choice(""));
  std::vector<MovieImage> images(still.frames.size());
  for (std::size_t k = 0; k < images.size(); ++k) {
    renderer->start(still.frames[k]);
    renderer->finish(images[k]);
  }
  return images;
}

// Of Y' [Rec. ITU-R BT.709-6, 3.2] in 219 steps from black to white; what comes back has been rounded to RGB.
double squared_error(const Image& decoded, const MovieImage& image) {
  double sum = 0;
  for (std::size_t k = 0; k < image.y.size(); ++k) {
    const std::uint8_t* p = &decoded.rgba[4 * k];
    const double luma = 16 + 219.0 / 255 * (0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2]);
    sum += (luma - image.y[k]) * (luma - image.y[k]);
  }
  return sum / static_cast<double>(image.y.size());
}

void encode_with(benchmark::State& state, const char* preset) {
  static const Still still = moving_wave(particles, frames);
  static const std::vector<MovieImage> images = movie_images(still);
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "weir_bench_compression";
  std::filesystem::create_directories(folder);
  Scene scene = still.scene;
  scene.output.movie->preset = preset;
  for (auto _ : state) {
    const auto movie = make_movie_sink(folder, scene, {});
    for (const MovieImage& image : images) movie->write(image);
    movie->finish();
  }
  const std::filesystem::path file = folder / (scene.name + ".mp4");
  double error = 0;
  decode_movie(file, [&](std::int64_t k, const Image& image) { error += squared_error(image, images[k]) / frames; });
  state.counters["frames"] = frames;
  state.counters["KB/frame"] = static_cast<double>(std::filesystem::file_size(file)) / 1024 / frames;
  state.counters["PSNR"] = 10 * std::log10(255.0 * 255.0 / error);
}

#define MEASURED Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime()
#define PRESET(name) BENCHMARK_CAPTURE(encode_with, name, #name)->MEASURED->Iterations(1)
PRESET(ultrafast);
PRESET(superfast);
PRESET(veryfast);
PRESET(medium);

// The rows that write_png hands to the compressor. The argument is the level.
void compress_png(benchmark::State& state) {
  const Still still = wave(particles);
  Image image;
  make_renderer(still.scene, still.static_scene, device_choice(""))->draw(still.frames[0], image);
  std::vector<std::uint8_t> rows;
  for (int y = 0; y < image.height; ++y) {
    rows.push_back(0);  // no filter
    for (int x = 0; x < image.width; ++x) rows.insert(rows.end(), image.pixel(x, y), image.pixel(x, y) + 3);
  }
  const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
      libdeflate_alloc_compressor(static_cast<int>(state.range(0))), libdeflate_free_compressor);
  std::vector<std::uint8_t> compressed(libdeflate_zlib_compress_bound(compressor.get(), rows.size()));
  std::size_t bytes = 0;
  for (auto _ : state)
    bytes = libdeflate_zlib_compress(compressor.get(), rows.data(), rows.size(), compressed.data(), compressed.size());
  state.counters["KB/frame"] = static_cast<double>(bytes) / 1024;
}
BENCHMARK(compress_png)->MEASURED->Arg(1)->Arg(6)->Arg(12);

}  // namespace
}  // namespace weir
