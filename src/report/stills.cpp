#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <set>

#include "report/hinsch2024.h"
#include "scene/names.h"
#include "scene/origin.h"
#include "sph/simulation.h"

namespace weir {

namespace {

constexpr std::int64_t count = 9;
constexpr int width = 640;  // pixels of one still; the height follows from the scene's picture

std::string title(const Scene& scene, const StaticScene& static_scene, std::int64_t particles) {
  const auto range = color_range(scene, static_scene);
  const Coloring& color = scene.render.color;
  return fmt::format("{}: {} particles, coloured by {} from {:.4g} to {:.4g} {} ({})", scene.title, particles,
                     name_of(color.by), range[0], range[1], typeset(facts_of(color.by).unit), name_of(color.map));
}

}  // namespace

Stills stills_figure(const Scene& dam_break, const ReportOptions& options) {
  Scene scene = dam_break;
  scene.render.size = {width, 2 * (width * dam_break.render.size[1] / dam_break.render.size[0] / 2)};
  scene.render.overlay.clear();  // captions and title replace it
  const std::int64_t last = last_frame(scene);
  std::set<std::int64_t> wanted;
  for (std::int64_t k = 0; k < count; ++k) wanted.insert((2 * k * last + count - 1) / (2 * (count - 1)));

  const std::unique_ptr<Simulation> simulation = make_simulation(scene, options.threads);
  Snapshot snapshot;
  simulation->fill(snapshot, {.fluid_positions = Precision::none, .wall_positions = Precision::single});
  scene = relative_to(scene, snapshot.origin);
  const StaticScene static_scene = make_static_scene(scene, std::move(snapshot.walls));
  const std::unique_ptr<Renderer> renderer = make_renderer(scene, static_scene, options.device);
  Stills stills;
  stills.grid.title = title(scene, static_scene, simulation->fluid_particles());
  stills.csv = "time[s],max_speed[m/s],mean_density_error[1],kinetic_energy[J],potential_energy[J]\n";
  Frame frame;
  while (true) {
    if (wanted.contains(simulation->frame_index())) {
      simulation->fill(snapshot, frame_request(scene.render.color.by));
      make_frame(snapshot, scene.render.color.by, frame);
      Picture picture;
      renderer->draw(frame, picture.image);
      picture.caption = fmt::format("t = {:.3f} s", frame.time);
      options.message(fmt::format("figure 8.1: {}", picture.caption));
      stills.grid.pictures.push_back(std::move(picture));
      const Diagnostics now = simulation->diagnostics();
      stills.csv += fmt::format("{},{},{},{},{}\n", now.time, now.max_speed, now.mean_density_error, now.kinetic_energy,
                                now.potential_energy);
    }
    if (simulation->finished() || simulation->frame_index() == last) return stills;
    simulation->step();
  }
}

}  // namespace weir
