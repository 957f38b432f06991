// Studies of run time: speed of steps, cost of methods and walls, and savings of absent terms.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "plot/plot.h"
#include "report/report.h"
#include "scene/scene.h"
#include "sph/simulation.h"

namespace weir {

// A column of fluid beside a wall in a tank that is open at the top: Hinsch's dam break in about `particles` particles,
// 1 m high; in 3D half as deep. Wendland C2 with h = 1.3 dx (21 neighbours) in 2D and 1.2 dx (58) in 3D, sound speed
// 10 times that of the fall, viscosity 0.01 h c0. Nothing is drawn.
Scene speed_scene(int dimension, std::int64_t particles);

// Million particle-steps per second: fluid particles times steps over wall time.
struct SpeedSample {
  std::int64_t particles = 0;  // fluid
  std::int64_t steps = 0;
  double mps = 0;
  double neighbours = 0;  // share of that time spent on sorting and lists
};

// A run that has reached `time`, s, past its first steps, in which memory is touched for the first time.
std::unique_ptr<Simulation> flow_at(const Scene& scene, int threads, double time);

// Speed of the first steps, over as many runs as take `seconds` of wall time.
SpeedSample measure_start(const Scene& scene, int threads, double seconds);

// Speed of the next steps, for about `seconds` of wall time; with `log` a log row is computed after every step.
SpeedSample measure_speed(Simulation& simulation, double seconds, bool log = false);

struct SpeedOptions {
  std::vector<std::int64_t> particles{1000, 10000, 100000, 1000000, 10000000};
  std::int64_t developed_particles = 100000;  // of the studies in developed flow; the front has then run 2 heights
  double seconds = 2;                         // per measurement
  double real_time_duration = 2;              // s that the scenes of Hinsch 2024 run
};

LinePlot speed_figure(const SpeedOptions& speed, const ReportOptions& options);
std::string developed_flow_csv(const SpeedOptions& speed, const ReportOptions& options);
// A step of each method with each kind of wall, in turn, five times: the median time, and the median ratio to `wcsph` with
// walls that are mirrored and hold the fluid.
std::string methods_csv(const SpeedOptions& speed, const ReportOptions& options);
// Pairs of cases, alternating, five times; the median ratio. `with` has a term that `without` lacks, with coefficient
// zero: both compute the same.
std::string savings_csv(const SpeedOptions& speed, const ReportOptions& options);
// Simulated time over wall time of Hinsch's two scenes for k = 1e4, 1e5 and 1e6 Pa.
std::string real_time_csv(const SpeedOptions& speed, const ReportOptions& options);

}  // namespace weir
