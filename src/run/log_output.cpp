#include "run/log_output.h"

#include <algorithm>
#include <optional>

#include "core/stopwatch.h"
#include "output/log.h"
#include "run/left_files.h"
#include "run/schedule.h"

namespace weir {

namespace {

constexpr const char* log_name = "log.csv";

class LogOutput final : public Observer {
 public:
  explicit LogOutput(const Scene& scene) : dimension_(scene.dimension), schedule_(scene.output.log.every) {}

  void open(const std::filesystem::path& folder) override {
    log_.emplace(folder / log_name, dimension_);
    for (const Diagnostics& row : early_rows_) log_->write(row);
    early_rows_.clear();
  }

  bool due(const Simulation& simulation) const override {
    return simulation.finished() || schedule_.due(simulation.time());
  }

  void look(Simulation& simulation) override {
    const Stopwatch watch;
    const Diagnostics row = simulation.diagnostics();
    if (log_) {
      log_->write(row);
    } else {
      early_rows_.push_back(row);
    }
    schedule_.written(row.time);
    max_density_error_ = std::max(max_density_error_, row.max_density_error);
    seconds_ += watch.seconds();
  }

  // With a row of the last step, though the run may have ended before one was due.
  void finish(Simulation& simulation, bool valid) override {
    if (valid && schedule_.last() != simulation.time()) look(simulation);
    log_->close();
  }

  void account(Manifest& facts) const override {
    facts.max_density_error = max_density_error_;
    facts.wall_time_s.write += seconds_;
  }

 private:
  int dimension_;
  Schedule schedule_;
  std::optional<LogWriter> log_;
  std::vector<Diagnostics> early_rows_;  // of steps ahead of the file
  double max_density_error_ = 0;         // over all rows
  double seconds_ = 0;                   // of wall time
};

}  // namespace

std::vector<std::filesystem::path> log_files(const Scene& /*scene*/) { return {log_name}; }

std::vector<std::filesystem::path> log_left_in(const std::filesystem::path& folder, const Scene& /*scene*/) {
  return existing({folder / log_name});
}

std::unique_ptr<Observer> observe_log(const RunContext& run) { return std::make_unique<LogOutput>(run.scene); }

}  // namespace weir
