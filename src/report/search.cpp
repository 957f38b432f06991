#include <fmt/format.h>

#include <cmath>

#include "core/parallel.h"
#include "core/stopwatch.h"
#include "core/thread_pool.h"
#include "report/hinsch2024.h"
#include "report/median.h"
#include "sph/solver.h"

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

// All pairs of particles compared [Hinsch24 ch. 5.1]: each fluid particle's neighbours, fluid and walls.
class NaiveSearch {
 public:
  NaiveSearch(const Sampling& sampling, double radius, ThreadPool& pool)
      : particles_(sampling.fluid_positions.size()),
        radius_squared_(static_cast<float>(radius * radius)),
        pool_(pool),
        neighbours_(particles_) {
    for (const auto* set : {&sampling.fluid_positions, &sampling.wall_positions}) {
      for (const Vec3& at : *set) {
        x_.push_back(static_cast<float>(at.x));
        y_.push_back(static_cast<float>(at.y));
      }
    }
  }
  void find() {
    parallel_blocks(particles_, pool_, [&](std::size_t, std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        neighbours_[i].clear();
        for (std::size_t j = 0; j < x_.size(); ++j) {
          const float dx = x_[i] - x_[j];
          const float dy = y_[i] - y_[j];
          if (dx * dx + dy * dy < radius_squared_) neighbours_[i].push_back(static_cast<std::int32_t>(j));
        }
      }
    });
  }

 private:
  std::size_t particles_;
  float radius_squared_;
  ThreadPool& pool_;
  std::vector<float> x_, y_;
  std::vector<std::vector<std::int32_t>> neighbours_;
};

// The tower with about so many particles, whole spacings wide.
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
  for (const auto& [naive, name] : {std::pair{false, "index sort"}, std::pair{true, "naive"}}) {
    Series alone{name, {}, {}};
    Series step{fmt::format("step, {}", name), {}, {}};
    for (const std::int64_t n : particles) {
      Scene scene = tower_of(tower, n);
      const Sampling sampling = sample(scene);
      const auto solver = make_solver<2>(scene, sampling, pool, default_instruction_set());
      NaiveSearch everything(sampling, support_radius(scene), pool);
      const auto find_neighbours = [&, by_all_pairs = naive] {
        if (by_all_pairs) {
          everything.find();
        } else {
          solver->search().expire();
          solver->search().update();
        }
      };
      const double search_time = seconds_of(find_neighbours);
      const double dt = 0.1 * smoothing_length(scene) / sound_speed(scene);
      const double step_time = seconds_of([&] {
        find_neighbours();
        solver->refresh();
        solver->accelerate();
        solver->move(dt);
      });
      const auto count = static_cast<double>(solver->fluid().count);
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
