// Particles to picture to movie, stage by stage, at 1080p: a wave of particles at rest distance in 2D, the column of a dam
// break in 3D (names that end in _3d), coloured by a smooth quantity, in the order of cells as the solver hands them over.
// Arguments are numbers of particles.
#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <future>
#include <memory>

#include "output/sink.h"
#include "render/camera.h"
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

// A column of 0.6 m x 0.6 m x 0.75 m in a tank thrice as long, all off its lattice by up to a fifth of the spacing.
Still column(std::int64_t particles) {
  Still still;
  const double dx = std::cbrt(0.6 * 0.6 * 0.75 / static_cast<double>(particles));
  const Vec3 inside(1.8, 0.6, 0.9);
  still.scene.name = "column";
  still.scene.dimension = 3;
  still.scene.render.overlay.clear();
  still.scene.duration = 2;
  still.scene.particle_spacing = still.still_life.particle_spacing = dx;
  still.scene.render.size = {width, height};
  still.scene.render.color.range = {{0, 6}};
  still.scene.output.movie = Movie{.preset = "ultrafast"};
  still.scene.fluid.volumes = {{.shape = Box{Vec3(0), Vec3(0.6, 0.6, 0.75)}}};
  const auto outside = [&](const Vec3& at) {
    return at.x < 0 || at.y < 0 || at.z < 0 || at.x > inside.x || at.y > inside.y;
  };
  for (double x = -1.5 * dx; x < inside.x + 2 * dx; x += dx)
    for (double y = -1.5 * dx; y < inside.y + 2 * dx; y += dx)
      for (double z = -1.5 * dx; z < inside.z; z += dx)
        if (outside(Vec3(x, y, z))) still.still_life.walls.emplace_back(x, y, z);
  const auto wide = std::lround(0.6 / dx);
  const auto high = std::lround(0.75 / dx);
  for (int k = 0; k < 4; ++k) {
    Frame frame;
    frame.index = k;
    frame.time = 0.5 + k / 60.0;
    constexpr int tile = 16;
    const auto in_tile = [&](std::int64_t i0, std::int64_t j0, std::int64_t l0) {
      for (std::int64_t i = i0; i < std::min<std::int64_t>(i0 + tile, wide); ++i)
        for (std::int64_t j = j0; j < std::min<std::int64_t>(j0 + tile, wide); ++j)
          for (std::int64_t l = l0; l < std::min<std::int64_t>(l0 + tile, high); ++l) {
            const Vec3 cell(i, j, l);
            const auto wobble = [&](double seed) {
              return 0.2 * std::sin(glm::dot(cell, Vec3(12.9898, 78.233, 37.719)) + seed);
            };
            const Vec3 at = dx * (cell + 0.5 + Vec3(wobble(k), wobble(k + 2), wobble(k + 4)));
            frame.particles.emplace_back(glm::vec3(at),
                                         static_cast<float>(3 + 3 * std::sin(6 * at.x + 4 * at.z + 0.05 * k)));
          }
    };
    for (std::int64_t i = 0; i < wide; i += tile)
      for (std::int64_t j = 0; j < wide; j += tile)
        for (std::int64_t l = 0; l < high; l += tile) in_tile(i, j, l);
    still.frames.push_back(std::move(frame));
  }
  return still;
}

using Make = Still(std::int64_t particles);

void draw_movie(benchmark::State& state, Make make) {
  const Still still = make(state.range(0));
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
void arrange(benchmark::State& state, Make make) {
  const Still still = make(state.range(0));
  const auto context = EglContext::open(device_choice(""));
  {
    DiscPainter painter(width, height);
    const CameraPath camera(still.scene, still.still_life, {0, 0, width, height});
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
    DiscPainter painter(width, height);
    const CameraPath camera(still.scene, still.still_life, {0, 0, width, height});
    const DiscStyle style{0.5 * still.scene.particle_spacing, {0, 6}};
    Backdrop background(width, height);
    background.fill(0xffffffff);
    MovieTarget target(width, height);
    std::vector<std::uint8_t> stale;
    painter.arrange({}, camera.at(0), style, stale);
    painter.arrange(still.frames[0].particles, camera.at(0), style, stale);
    for (auto _ : state) {
      painter.draw(target.framebuffer(), {.movie = true, .straight = false, .background = {}}, background);
      glFinish();
    }
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

void encode(benchmark::State& state, Make make) {
  const Still still = make(state.range(0));
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
void draw_and_encode(benchmark::State& state, Make make) {
  const Still still = make(state.range(0));
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
