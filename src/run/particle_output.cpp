#include "run/particle_output.h"

#include <optional>
#include <utility>

#include "core/stopwatch.h"
#include "core/trace.h"
#include "output/file.h"
#include "output/particles.h"
#include "run/left_files.h"
#include "run/schedule.h"
#include "scene/origin.h"

namespace weir {

namespace fs = std::filesystem;

namespace {

// Snapshots kept while another output starts and the solver steps ahead.
constexpr std::size_t most_early_snapshots = 3;

SnapshotRequest request_of(const Scene& scene) {
  SnapshotRequest request;
  // Far from the origin, single precision would not resolve the positions in the scene's coordinates.
  if (scene_origin(scene) != Vec3(0)) request.fluid_positions = Precision::exact;
  for (const ParticleField field : scene.output.particles->fields) request.fluid.push_back(quantity_of(field));
  return request;
}

class ParticleOutput final : public Observer {
 public:
  explicit ParticleOutput(const Scene& scene) : request_(request_of(scene)) {
    if (scene.output.particles->every > 0) schedule_.emplace(scene.output.particles->every);
  }

  bool has_room() const override { return early_snapshots_.size() < most_early_snapshots; }

  void open(const fs::path& folder) override {
    writer_.emplace(folder);
    for (const Snapshot& snapshot : early_snapshots_) writer_->write(snapshot);
    early_snapshots_ = {};
  }

  bool due(const Simulation& simulation) const override {
    return schedule_ ? schedule_->due(simulation.time()) : simulation.frame_index() >= 0;
  }

  void look(Simulation& simulation) override {
    const Stopwatch watch;
    const Span span("write particles");
    simulation.fill(snapshot_, request_);
    if (writer_) {
      writer_->write(snapshot_);
    } else {
      early_snapshots_.push_back(std::move(snapshot_));
    }
    if (schedule_) schedule_->written(simulation.time());
    seconds_ += watch.seconds();
  }

  void account(Manifest& facts) const override { facts.wall_time_s.write += seconds_; }

 private:
  SnapshotRequest request_;
  std::optional<Schedule> schedule_;  // none: frame times
  std::optional<ParticleWriter> writer_;
  std::vector<Snapshot> early_snapshots_;
  Snapshot snapshot_;
  double seconds_ = 0;  // of wall time
};

}  // namespace

// With an interval of their own their number depends on the steps; the collection and the first are always there.
std::vector<fs::path> particle_files(const Scene& scene) {
  if (!scene.output.particles) return {};
  const std::int64_t last = scene.output.particles->every > 0 ? 0 : last_frame(scene);
  std::vector<fs::path> files{particle_collection_name};
  for (std::int64_t file = 0; file <= last; ++file) files.push_back(particle_file_name(file));
  return files;
}

std::vector<fs::path> particles_left_in(const fs::path& folder, const Scene& /*scene*/) {
  const fs::path collection = folder / particle_collection_name;
  std::vector<fs::path> files = existing({collection, temporary_of(collection)});
  for (const char* suffix : {".vtp", ".vtp.tmp"}) {
    for (const fs::path& file : numbered_files(folder, "particles_", suffix)) files.push_back(file);
  }
  return files;
}

std::unique_ptr<Observer> observe_particles(const RunContext& run) {
  if (!run.scene.output.particles) return nullptr;
  return std::make_unique<ParticleOutput>(run.scene);
}

}  // namespace weir
