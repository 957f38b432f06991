// Particles to picture to movie, stage by stage, at 1080p: a wave of particles at rest distance, coloured by a smooth
// quantity, in the order of cells as the solver hands them over. Arguments are numbers of particles.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <future>
#include <memory>

#include "output/sink.h"
#include "render/disc_painter.h"
#include "render/egl_context.h"
#include "render/renderer.h"

namespace weir {
namespace {

constexpr int width = 1920;
constexpr int height = 1080;

struct Still {
  Scene scene;
  StillLife still_life;
  std::vector<Frame> frames;  // a few, of which each differs from the next
};

// A column collapsed to a wave in a tank of 3.6 m x 1.8 m, an eighth of it full.
Still wave(std::int64_t particles) {
  Still still;
  const double dx = std::sqrt(3.6 * 1.8 * 0.23 / static_cast<double>(particles));
  still.scene.name = "wave";
  still.scene.title = "A wave";
  still.scene.render.overlay.clear();
  still.scene.duration = 2;
  still.scene.particle_spacing = still.still_life.particle_spacing = dx;
  still.scene.render.size = {width, height};
  still.scene.render.color.range = {{0, 6}};
  still.scene.output.movie = Movie{.preset = "ultrafast"};
  still.scene.fluid.volumes = {{.shape = Box{Vec3(0), Vec3(3.6, 0.4, 0)}}};
  for (double x = -1.5 * dx; x < 3.6 + 2 * dx; x += dx)
    for (double y = -1.5 * dx; y < 1.8; y += dx)
      if (x < 0 || x > 3.6 || y < 0) still.still_life.walls.emplace_back(x, y, 0);
  for (int k = 0; k < 4; ++k) {
    Frame frame;
    frame.index = k;
    frame.time = 0.5 + k / 60.0;
    constexpr int cells = 400;
    for (int row = 0; row < cells / 2; ++row)
      for (int column = 0; column < cells; ++column) {
        const double side = 3.6 / cells;
        for (auto j = std::lround(row * side / dx); j < std::lround((row + 1) * side / dx); ++j)
          for (auto i = std::lround(column * side / dx); i < std::lround((column + 1) * side / dx); ++i) {
            const double x = (static_cast<double>(i) + 0.5) * dx;
            const double y = (static_cast<double>(j) + 0.5) * dx;
            const double surface = 0.41 + 0.3 * std::sin(2 * x + 0.1 * k);
            if (y > surface) continue;
            const double wobble =
                0.2 * dx * std::sin(12.9898 * static_cast<double>(i) + 78.233 * static_cast<double>(j) + k);
            frame.particles.emplace_back(static_cast<float>(x + wobble), static_cast<float>(y - wobble + 0.3 * k * dx),
                                         0.0f, static_cast<float>(3 + 3 * std::sin(3 * x + 2 * y + 0.05 * k)));
          }
      }
    still.frames.push_back(std::move(frame));
  }
  return still;
}

void draw_movie(benchmark::State& state) {
  const Still still = wave(state.range(0));
  const auto renderer = make_renderer(still.scene, still.still_life, device_choice(""));
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
  const auto renderer = make_renderer(still.scene, still.still_life, device_choice(""));
  Image image;
  std::size_t k = 0;
  for (; k < 4; ++k) renderer->draw(still.frames[k], image);  // the driver compiles
  for (auto _ : state) renderer->draw(still.frames[k++ % still.frames.size()], image);
}

// The processor's part: into pixels, into bins, into the device's memory.
void arrange(benchmark::State& state) {
  const Still still = wave(state.range(0));
  const auto context = EglContext::open(device_choice(""));
  {
    DiscPainter painter(width, height);
    const Projection projection = projection_of(View2D{Vec3(1.8, 0.9, 0), 3.8}, width, height);
    std::vector<std::uint8_t> stale;
    for (auto _ : state)
      painter.arrange(still.frames[0].particles, projection, {0.5 * still.scene.particle_spacing, {0, 6}}, stale);
  }
}

void read_movie(benchmark::State& state) {
  const auto context = EglContext::open(device_choice(""));
  MovieTarget target(width, height);
  MovieImage image;
  for (auto _ : state) target.read(image);
}

std::unique_ptr<MovieSink> sink(const Still& still) {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "weir_bench_pictures";
  std::filesystem::create_directories(folder);
  return make_movie_sink(folder, still.scene, {});
}

void encode(benchmark::State& state) {
  const Still still = wave(state.range(0));
  const auto renderer = make_renderer(still.scene, still.still_life, device_choice(""));
  std::vector<MovieImage> images(still.frames.size());
  for (std::size_t k = 0; k < images.size(); ++k) {
    renderer->start(still.frames[k]);
    renderer->finish(images[k]);
  }
  const auto movie = sink(still);
  std::size_t k = 0;
  for (auto _ : state) movie->write(images[k++ % images.size()]);
}

// From particles to packets: one picture is drawn while the last is read and the one before is encoded.
void draw_and_encode(benchmark::State& state) {
  const Still still = wave(state.range(0));
  const auto renderer = make_renderer(still.scene, still.still_life, device_choice(""));
  const auto movie = sink(still);
  std::array<MovieImage, 2> images;
  std::size_t k = 0;
  std::future<void> encoded = std::async(std::launch::async, [] {});
  renderer->start(still.frames[k++]);
  for (auto _ : state) {
    renderer->start(still.frames[k % still.frames.size()]);
    MovieImage& image = images[k++ % 2];
    renderer->finish(image);
    encoded.get();
    encoded = std::async(std::launch::async, [&] { movie->write(image); });
  }
  encoded.get();
}

#define STAGE(name) BENCHMARK(name)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime()
STAGE(arrange)->Arg(15000)->Arg(100000)->Arg(1000000);
STAGE(draw_movie)->Arg(15000)->Arg(100000)->Arg(1000000);
STAGE(draw_png)->Arg(15000)->Arg(100000);
STAGE(read_movie);
STAGE(encode)->Arg(15000)->Arg(100000)->Arg(1000000);
STAGE(draw_and_encode)->Arg(15000)->Arg(100000)->Arg(1000000);

}  // namespace
}  // namespace weir
