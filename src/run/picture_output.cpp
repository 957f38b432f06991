#include "run/picture_output.h"

#include <fmt/format.h>

#include <utility>

#include "run/pictures.h"
#include "scene/origin.h"

namespace weir {

namespace {

Snapshot walls_of(Simulation& simulation) {
  Snapshot snapshot;
  simulation.fill(snapshot, {.fluid_positions = Precision::none, .wall_positions = Precision::single});
  return snapshot;
}

class PictureOutput final : public Observer {
 public:
  PictureOutput(const RunContext& run, Snapshot walls)
      : run_(run),
        scene_(relative_to(run.scene, walls.origin)),
        static_scene_(make_static_scene(scene_, std::move(walls.walls))),
        pictures_(scene_, static_scene_, run.simulation.fluid_particles(), run.options.device) {
    run.simulation.give_way_to(pictures_.at_work());
  }

  bool starting() const override { return pictures_.device_starts(); }
  bool has_room() const override { return pictures_.has_room(); }

  void await_start() override {
    pictures_.await_device();
    run_.say(fmt::format("drawing with {}", pictures_.gl_renderer()));
    const Coloring& color = scene_.render.color;
    if (!color.range) {
      const auto [low, high] = color_range(scene_, static_scene_);
      run_.say(fmt::format("colour range of {}: {:.4g} to {:.4g}, estimated from the scene", name_with_unit(color.by),
                           low, high));
    }
    static_scene_ = {};  // the renderer has its own by now
  }

  void open(const std::filesystem::path& folder) override {
    pictures_.open(folder, run_.provenance, run_.threads);
    if (scene_.output.movie) run_.say(fmt::format("encoding with {}", pictures_.encoder()));
  }

  void describe(Manifest& facts) const override {
    facts.gl_renderer = pictures_.gl_renderer();
    facts.encoder = pictures_.encoder();
  }

  bool due(const Simulation& simulation) const override {
    const std::int64_t frame = simulation.frame_index();
    return frame >= 0 && pictures_.wants(frame);
  }
  void look(Simulation& simulation) override { pictures_.add(simulation); }
  bool failed() const override { return pictures_.failed(); }
  std::int64_t pictures() const override { return pictures_.drawn(); }

  void finish(Simulation& /*simulation*/, bool /*valid*/) override { pictures_.finish(); }

  void account(Manifest& facts) const override {
    const PictureTimes times = pictures_.times();
    facts.frames = pictures_.drawn();
    facts.wall_time_s.render = times.render;
    facts.wall_time_s.encode = times.encode;
    facts.wall_time_s.write += times.write;
  }

 private:
  const RunContext& run_;
  const Scene scene_;  // its positions relative to the snapshots' origin, as the solver's
  StaticScene static_scene_;
  Pictures pictures_;
};

}  // namespace

std::unique_ptr<Observer> observe_pictures(const RunContext& run) {
  if (!draws(run.scene)) return nullptr;
  return std::make_unique<PictureOutput>(run, walls_of(run.simulation));
}

}  // namespace weir
