#include "scene/reader.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "scene/sampling.h"

namespace weir {
namespace {

TEST(Tmp, Tmp) {
  const char* text = R"(weir: 1                            # format version
title: Dam break
dimension: 2                       # 2 or 3
duration: 2.0                      # s
gravity: [0, -9.81]                # m/s^2
particles: {spacing: 0.01}         # m
fluid:
  rest_density: 1000               # kg/m^3
  viscosity: {model: morris, kinematic: 1.0e-6}    # m^2/s; morris | monaghan | artificial | seed_a | seed_b
  surface_tension: {model: none}
  volumes:
    - box: {min: [0, 0], max: [1, 1]}              # velocity:, more shapes
walls:
  - tank: {min: [0, 0], max: [3, 2], open: [top], layers: 2}   # default ceil(support/dx); particles | plane; motion: {...}
periodic: []                       # e.g. [x]
bodies: []                         # rigid bodies
solver:
  method: wcsph                    # wcsph | iisph | dfsph | ...
  kernel: {name: cubic_spline, smoothing: 1.0}     # h / dx
  stiffness: 100000                # k in Pa (linear: p = k (rho/rho0 - 1)), or sound_speed: m/s
  exponent: 7
  time_step: {cfl: 0.4}            # or {fixed: 1.0e-4}
timeline:                          # seed A's sliders, headless
  - {at: 1.0, set: {gravity: [3, -9.81], fluid.viscosity.kinematic: 0.01}}
  - {at: 1.5, reset: true}
camera: {view: auto}               # or keyframes
render:
  size: [1920, 1080]
  fps: 60
  color: {by: speed, map: viridis, range: [0, 5]}
  overlay: [time, colorbar, cfl]
probes: []                         # fronts, water heights, pressures -> probes.csv
output: {movie: true, frames: false, log: {every: 0.01}, particles: false}
)";
  const Scene scene = read_scene_text(text, "dam_break.yaml", {parse_override("timeline.0.set.solver.stiffness=3"),parse_override("output.movie.quality=3")});
  printf("%s", write_scene(scene).c_str());
  EXPECT_EQ(write_scene(read_scene_text(write_scene(scene), "dam_break.yaml")), write_scene(scene));
  const Sampling s = sample(scene);
  printf("%zu %zu\n", s.fluid_positions.size(), s.wall_positions.size());
  try {
    read_scene_text("weir: 1\ntitel: 3\ndimension: 2\nfluid: {volumes: [{disc: {center: [0], radius: -1, radius: 0x10}}], viscosity: {model: artificial}}\nsolver: {time_step: {fixed: 1, cfl: .4}, stiffness: .inf, sound_speed: 3}\noutput: {checkpoint: {every: 3}}\nwalls:\n- {tank: {min: *a}}\n", "x.yaml");
  } catch (const SceneError& e) { printf("%s\n", e.what()); }
  try {
    read_scene_text("weir: 1\ntitel: 3\ndimension: 2\nfluid: {volumes: [{disc: {center: [0], radius: -1, radius: 0x10}}], viscosity: {model: artificial}}\nsolver: {time_step: {fixed: 1, cfl: .4}, stiffness: .inf, sound_speed: 3}\noutput: {checkpoint: {every: 3}}\nwalls:\n- {tank: {min: &a 3, max: *a}}\n", "x.yaml");
  } catch (const SceneError& e) { printf("%s\n", e.what()); }
}

}  // namespace
}  // namespace weir
