#include <fmt/format.h>

#include <cmath>

#include "core/stopwatch.h"
#include "core/thread_pool.h"
#include "report/hinsch2024.h"
#include "report/median.h"
#include "sph/wcsph.h"

namespace weir {

namespace {

// Time of one call, s: median of five rounds, each of as many calls as take 20 ms.
template <class Work>
double seconds_of(const Work& work) {
  std::vector<double> rounds;
  for (int round = 0; round < 5; ++round) {
    const Stopwatch watch;
    double taken = 0;
    int calls = 0;
    do {
      work();
      ++calls;
      taken = watch.seconds();
    } while (taken < 0.02);
    rounds.push_back(taken / calls);
  }
  return median(rounds);
}

// The tower with about this number of particles and a width of whole spacings.
Scene tower_of(Scene tower, std::int64_t particles) {
  const Box& water = std::get<Box>(tower.fluid.volumes.at(0).shape);
  const Vec3 size = water.max - water.min;
  tower.particle_spacing = size.x / std::round(std::sqrt(static_cast<double>(particles) * size.x / size.y));
  return tower;
}

}  // namespace

LinePlot search_figure(const Scene& tower, const std::vector<std::int64_t>& particles, const ReportOptions& options) {
  LinePlot plot;
  plot.title = "Tower: index sort against naive search";
  plot.x = {"fluid particles", "particles", true};
  plot.y = {"time in ms", "time[ms]", true};
  plot.legend = "of";
  plot.series_column = "case";
  ThreadPool pool(thread_count(options.threads));
  for (const auto& [search, name] :
       {std::pair{NeighbourSearch::index_sort, "index sort"}, std::pair{NeighbourSearch::naive, "naive"}}) {
    Series alone{name, {}, {}};
    Series step{fmt::format("step, {}", name), {}, {}};
    for (const std::int64_t n : particles) {
      Scene scene = tower_of(tower, n);
      scene.solver.neighbour_search = search;
      Wcsph<2> solver(scene, sample(scene), pool);
      const double search_time = seconds_of([&] { solver.relist(); });
      const double dt = 0.1 * smoothing_length(scene) / sound_speed(scene);
      const double step_time = seconds_of([&] {
        solver.relist();
        solver.compute_density_and_pressure();
        solver.compute_accelerations();
        solver.integrate(dt);
      });
      const auto count = static_cast<double>(solver.fluid().count);
      for (const auto& [series, seconds] : {std::pair{&alone, search_time}, std::pair{&step, step_time}}) {
        series->x.push_back(count);
        series->y.push_back(1e3 * seconds);
      }
      options.message(fmt::format("figure 7.4: {}, {} particles: search {:.3g} ms, step {:.3g} ms", name, count,
                                  1e3 * search_time, 1e3 * step_time));
    }
    plot.series.push_back(std::move(alone));
    plot.series.push_back(std::move(step));
  }
  return plot;
}

}  // namespace weir
