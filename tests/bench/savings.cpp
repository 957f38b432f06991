// What is saved where a picture or a part of it is as it was, each with and without, for 15,000 discs in a tank.
#include <benchmark/benchmark.h>

#include <algorithm>

#include "render/balls.h"
#include "render/camera.h"
#include "render/egl_context.h"
#include "render/particle_painter.h"
#include "render/renderer.h"
#include "stills.h"

namespace weir {
namespace {

constexpr int particles = 15000;

#define MEASURED Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime()

Still with_overlay() {
  Still still = wave(particles);
  still.scene.render.overlay = Scene{}.render.overlay;
  return still;
}

View2D all_in_view() { return {Vec3(1.8, 0.9, 0), 4}; }

void draw(benchmark::State& state, const Still& still, const std::vector<const Frame*>& frames,
          const DeviceChoice& choice = device_choice("")) {
  const auto renderer = make_renderer(still.scene, still.static_scene, choice);
  MovieImage image;
  std::size_t k = 0;
  const auto draw_next = [&] {
    renderer->start(*frames[k++ % frames.size()]);
    renderer->finish(image);
  };
  for (int warm = 0; warm < 4; ++warm) draw_next();
  for (auto _ : state) draw_next();
}

std::vector<const Frame*> frames_of(const Still& still) {
  std::vector<const Frame*> frames;
  for (const Frame& frame : still.frames) frames.push_back(&frame);
  return frames;
}

// The same particles and texts in every picture, but the view moves or not: background, walls and overlay are drawn anew or
// were drawn before.
void view(benchmark::State& state, bool moves) {
  Still still = with_overlay();
  still.scene.camera.view = all_in_view();
  if (moves) {
    View2D nearer = all_in_view();
    nearer.width *= 0.999;
    still.scene.camera.keyframes = {{0.4, all_in_view()}, {0.7, nearer}};
  }
  draw(state, still, frames_of(still));
}
BENCHMARK_CAPTURE(view, stays, false)->MEASURED;
BENCHMARK_CAPTURE(view, moves, true)->MEASURED;

void picture(benchmark::State& state, bool changes) {
  Still still = with_overlay();
  still.scene.camera.view = all_in_view();
  if (changes)
    draw(state, still, frames_of(still));
  else
    draw(state, still, {&still.frames[0]});
}
BENCHMARK_CAPTURE(picture, stays, false)->MEASURED;
BENCHMARK_CAPTURE(picture, changes, true)->MEASURED;

// Blocks in which nothing is nor was are shaded or not.
void empty_blocks(benchmark::State& state, bool are_shaded) {
  const Still still = wave(particles);
  const auto context = EglContext::open(device_choice(""));
  {
    ParticlePainter painter(picture_width, picture_height);
    const CameraPath camera(still.scene, still.static_scene, {0, 0, picture_width, picture_height});
    Backdrop background(picture_width, picture_height);
    background.fill(0xffffffff);
    MovieTarget target(picture_width, picture_height);
    MovieImage image;
    std::vector<std::uint8_t> stale;
    for (auto _ : state) {
      if (are_shaded) stale.clear();  // the target may show anything
      painter.arrange(still.frames[0].particles, camera.at(0), {0.5 * still.scene.particle_spacing, {0, 6}}, stale);
      painter.draw(target.framebuffer(), PixelsFor::movie, background);
      target.read(image);
    }
  }
}
BENCHMARK_CAPTURE(empty_blocks, left, false)->MEASURED;
BENCHMARK_CAPTURE(empty_blocks, shaded, true)->MEASURED;

// Where the device is the processor: a movie's pictures composed by its shader and read, or by the processor at once.
void movie_by(benchmark::State& state, MovieBy who) {
  const Still still = wave(particles);
  DeviceChoice choice = device_choice("");
  choice.movie_by = who;
  draw(state, still, frames_of(still), choice);
}
BENCHMARK_CAPTURE(movie_by, device, MovieBy::device)->MEASURED;
BENCHMARK_CAPTURE(movie_by, processor, MovieBy::processor)->MEASURED;

// Particles that are all off the picture or all in it.
void fluid(benchmark::State& state, bool on_camera) {
  Still still = wave(particles);
  still.scene.camera.view = View2D{on_camera ? Vec3(1.8, 0.9, 0) : Vec3(1.8, 30, 0), 4};
  draw(state, still, frames_of(still));
}
BENCHMARK_CAPTURE(fluid, off_camera, false)->MEASURED;
BENCHMARK_CAPTURE(fluid, on_camera, true)->MEASURED;

// A million balls of a column, from the front to the back as they are drawn, and from the back to the front, when nothing is
// hidden by what came before.
void hidden_balls_left_out(benchmark::State& state) {
  const Still still = column(state.range(0));
  const CameraPath camera(still.scene, still.static_scene, {0, 0, picture_width, picture_height});
  Balls balls(picture_width, picture_height, 1);
  for (auto _ : state)
    balls.show(still.frames[0].particles, camera.at(0), {0.5 * still.scene.particle_spacing, {0, 6}}, Colormap{});
}
BENCHMARK(hidden_balls_left_out)->MEASURED->Arg(1000000);

void hidden_balls_drawn(benchmark::State& state) {
  const Still still = column(state.range(0));
  const CameraPath camera(still.scene, still.static_scene, {0, 0, picture_width, picture_height});
  const double radius = 0.5 * still.scene.particle_spacing;
  const BallView view(camera.at(0), radius, {0, 6});
  std::vector<ScreenBall> balls;
  for (const glm::vec4& particle : still.frames[0].particles) {
    const BallView::Seen seen = view.of(all(particle.x), all(particle.y), all(particle.z));
    balls.push_back({seen.column[0], seen.row[0], seen.depth[0], 0});
  }
  std::sort(balls.begin(), balls.end(), [](const ScreenBall& a, const ScreenBall& b) { return a.depth > b.depth; });
  BallPixels pixels({0, 0, picture_width - 1, picture_height - 1});
  for (auto _ : state) {
    pixels.begin(radius, camera.at(0).focal, camera.at(0).pixels_per_metre() * radius);
    for (const ScreenBall& ball : balls) pixels.add(ball);
  }
}
BENCHMARK(hidden_balls_drawn)->MEASURED->Arg(1000000);

}  // namespace
}  // namespace weir
