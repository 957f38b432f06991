#include "runs/scenes.h"

#include <fmt/format.h>

#include <stdexcept>

#include "run/run.h"
#include "support/golden.h"

namespace weir::test {

Scene dam_break_run() {
  Scene scene;
  scene.name = "dam_break";
  scene.title = "Dam break";
  scene.duration = 0.2;
  scene.particle_spacing = 0.02;
  scene.fluid.viscosity.kinematic = 0.005;
  scene.fluid.volumes = {{.shape = Box{Vec3(0), Vec3(0.3, 0.4, 0)}}};
  scene.walls = {{.shape = Tank{Vec3(0), Vec3(0.9, 0.5, 0), {Side::top}}, .layers = 2, .holes = {}}};
  scene.solver.compressibility = Stiffness{2e4};
  scene.render.size = {320, 180};
  scene.render.fps = 25;
  scene.render.color.range = {{0, 2.5}};
  scene.output.movie.reset();
  return scene;
}

Scene cup_run() {
  Scene scene = dam_break_run();
  scene.name = "cup";
  scene.title = "Cup";
  scene.dimension = 3;
  scene.gravity = Vec3(0, 0, -9.81);
  scene.particle_spacing = 0.05;
  scene.fluid.volumes = {{.shape = Box{Vec3(0), Vec3(0.3, 0.2, 0.4)}}};
  scene.walls = {{.shape = Tank{Vec3(0), Vec3(0.6, 0.2, 0.5), {Side::top}}, .layers = 2, .holes = {}}};
  return scene;
}

FinishedRun::FinishedRun(Scene scene, int threads) : name_(scene.name) {
  scene.output.frames = true;
  RunOptions options;
  options.folder = folder_.path();
  options.threads = threads;
  options.device = device_choice("");
  options.instruction_set = InstructionSet::baseline;  // the one that every machine has
  const RunResult result = run(scene, options);
  if (result.exit != ExitCode::done) throw std::runtime_error(result.message);
  manifest_ = read_manifest(folder_ / "manifest.json");
}

Image FinishedRun::frame(int number) const {
  return read_png(folder_ / "frames" / fmt::format("frame_{:05}.png", number));
}

std::filesystem::path FinishedRun::movie() const { return folder_ / (name_ + ".mp4"); }

std::string FinishedRun::machine() const {
  return fmt::format("{}; solver for {}", manifest_.gl_renderer, manifest_.instruction_set);
}

}  // namespace weir::test
