// Particles to picture to movie, stage by stage: /2d of a wave, /3d of a column. Arguments are numbers of particles.
#include <benchmark/benchmark.h>

#include <array>
#include <filesystem>
#include <future>
#include <memory>

#include "output/sink.h"
#include "render/camera.h"
#include "render/egl_context.h"
#include "render/particle_painter.h"
#include "render/renderer.h"
#include "stills.h"

namespace weir {
namespace {

void draw_movie(benchmark::State& state, Make make) {
  const Still still = make(state.range(0));
  const auto renderer = make_renderer(still.scene, still.static_scene, device_choice(""));
  MovieImage image;
  std::size_t k = 0;
  for (; k < 4; ++k) {  // the driver compiles
    renderer->start(still.frames[k]);
    renderer->finish(image);
  }
  for (auto _ : state) {
    renderer->start(still.frames[k++ % still.frames.size()]);
    renderer->finish(image);
  }
  state.counters["particles"] = static_cast<double>(still.frames[0].particles.size());
}

void draw_png(benchmark::State& state) {
  const Still still = wave(state.range(0));
  const auto renderer = make_renderer(still.scene, still.static_scene, device_choice(""));
  Image image;
  std::size_t k = 0;
  for (; k < 4; ++k) renderer->draw(still.frames[k], image);  // the driver compiles
  for (auto _ : state) renderer->draw(still.frames[k++ % still.frames.size()], image);
}

// The processor's part: into pixels, into the device's memory.
void arrange(benchmark::State& state, Make make) {
  const Still still = make(state.range(0));
  const auto context = EglContext::open(device_choice(""));
  {
    ParticlePainter painter(picture_width, picture_height);
    const CameraPath camera(still.scene, still.static_scene, {0, 0, picture_width, picture_height});
    const Projection projection = camera.at(0);
    std::vector<std::uint8_t> stale;
    for (auto _ : state)
      painter.arrange(still.frames[0].particles, projection, {0.5 * still.scene.particle_spacing, {0, 6}}, stale);
  }
}

// The device's part.
void shade(benchmark::State& state, Make make) {
  const Still still = make(state.range(0));
  const auto context = EglContext::open(device_choice(""));
  {
    ParticlePainter painter(picture_width, picture_height);
    const CameraPath camera(still.scene, still.static_scene, {0, 0, picture_width, picture_height});
    const ParticleStyle style{0.5 * still.scene.particle_spacing, {0, 6}};
    Backdrop background(picture_width, picture_height);
    background.fill(0xffffffff);
    MovieTarget target(picture_width, picture_height);
    std::vector<std::uint8_t> stale;
    painter.arrange({}, camera.at(0), style, stale);
    painter.arrange(still.frames[0].particles, camera.at(0), style, stale);
    for (auto _ : state) {
      painter.draw(target.framebuffer(), PixelsFor::movie, background);
      glFinish();
    }
  }
}

void read_movie(benchmark::State& state) {
  const auto context = EglContext::open(device_choice(""));
  MovieTarget target(picture_width, picture_height);
  MovieImage image;
  for (auto _ : state) target.read(image);
}

std::unique_ptr<MovieSink> sink(const Still& still) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "weir_bench_pictures";
  std::filesystem::create_directories(folder);
  return make_movie_sink(folder, still.scene, {});
}

void encode(benchmark::State& state, Make make) {
  const Still still = make(state.range(0));
  const auto renderer = make_renderer(still.scene, still.static_scene, device_choice(""));
  std::vector<MovieImage> images(still.frames.size());
  for (std::size_t k = 0; k < images.size(); ++k) {
    renderer->start(still.frames[k]);
    renderer->finish(images[k]);
  }
  const auto movie = sink(still);
  std::size_t k = 0;
  for (auto _ : state) movie->write(images[k++ % images.size()]);
}

// From particles to packets: one picture is drawn while the last is read, if the device can, and the one before is encoded.
void draw_and_encode(benchmark::State& state, Make make) {
  const Still still = make(state.range(0));
  const auto renderer = make_renderer(still.scene, still.static_scene, device_choice(""));
  const auto movie = sink(still);
  std::array<MovieImage, 2> images;
  std::size_t k = 0;
  std::future<void> encoded = std::async(std::launch::async, [] {});
  const bool ahead = renderer->most_under_way() > 1;
  const auto start_next = [&] { renderer->start(still.frames[k++ % still.frames.size()]); };
  if (ahead) start_next();
  for (auto _ : state) {
    start_next();
    MovieImage& image = images[k % 2];
    renderer->finish(image);
    encoded.get();
    encoded = std::async(std::launch::async, [&] { movie->write(image); });
  }
  encoded.get();
}

#define MEASURED Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime()
#define STAGE_OF(name, kind, make) BENCHMARK_CAPTURE(name, kind, make)->MEASURED->Arg(15000)->Arg(100000)->Arg(1000000)
#define STAGE(name)         \
  STAGE_OF(name, 2d, wave); \
  STAGE_OF(name, 3d, column)
STAGE(arrange);
STAGE(shade);
STAGE(draw_movie);
BENCHMARK(draw_png)->MEASURED->Arg(15000)->Arg(100000);
BENCHMARK(read_movie)->MEASURED;
STAGE(encode);
STAGE(draw_and_encode);

}  // namespace
}  // namespace weir
