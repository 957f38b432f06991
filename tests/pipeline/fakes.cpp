#include "pipeline/fakes.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "output/sink.h"
#include "render/renderer.h"
#include "sph/simulation.h"

namespace weir {

namespace {

FakeBehaviour behaviour_now;
FakeRecord record_now;
std::mutex record_mutex;

constexpr int steps_per_frame = 4;

// A stage at work for that long.
void work(std::chrono::milliseconds time) {
  static int at_work = 0;
  {
    const std::lock_guard lock(record_mutex);
    record_now.most_at_once = std::max(record_now.most_at_once, ++at_work);
  }
  std::this_thread::sleep_for(time);
  const std::lock_guard lock(record_mutex);
  --at_work;
}

class FakeSimulation final : public Simulation {
 public:
  explicit FakeSimulation(const Scene& scene)
      : fps_(scene.render.fps), last_(std::llround(scene.duration * scene.render.fps * steps_per_frame)) {}

  bool finished() const override { return step_ >= last_; }
  void step() override {
    if (others_ != nullptr) {
      const std::lock_guard lock(record_mutex);
      record_now.others_at_work.insert(*others_);
    }
    work(behaviour_now.step_time);
    ++step_;
    {
      const std::lock_guard lock(record_mutex);
      record_now.steps = step_;
    }
    if (step_ == behaviour_now.diverge_in_step) throw SimulationError("diverged on purpose");
  }
  double time() const override { return static_cast<double>(step_) / steps_per_frame / fps_; }
  double simulated_time() const override { return time(); }
  std::int64_t steps() const override { return step_; }
  std::int64_t frame_index() const override { return step_ % steps_per_frame == 0 ? step_ / steps_per_frame : -1; }
  void use_threads(int) override {}
  void give_way_to(const std::atomic<int>& others) override { others_ = &others; }
  std::int64_t fluid_particles() const override { return behaviour_now.particles; }
  std::int64_t wall_particles() const override { return 0; }
  void fill(Snapshot& snapshot, const SnapshotRequest& request) override {
    snapshot.index = frame_index();
    snapshot.time = time();
    snapshot.fluid.fields.clear();
    for (const Quantity quantity : request.fluid) snapshot.fluid.fields.push_back({.quantity = quantity, .values = {}});
    if (request.fluid_positions == Precision::none) return;
    const std::lock_guard lock(record_mutex);
    ++record_now.filled;
  }
  Diagnostics diagnostics() override {
    Diagnostics row;
    row.time = time();
    row.step = step_;
    row.max_density_error = 0.125 * static_cast<double>(step_);
    return row;
  }
  std::string state_hash() const override { return "state of step " + std::to_string(step_); }
  StageTimes stage_times() const override { return {.setup = 0, .neighbours = 1, .solve = 3}; }
  InstructionSet instruction_set() const override { return InstructionSet::baseline; }

 private:
  int fps_;
  std::int64_t last_;
  std::int64_t step_ = 0;
  const std::atomic<int>* others_ = nullptr;
};

class FakeRenderer final : public Renderer {
 public:
  FakeRenderer() {
    const std::lock_guard lock(record_mutex);
    record_now.renderer_thread = std::this_thread::get_id();
  }
  void draw(const Frame& frame, Image& image) override {
    draw_one(frame);
    image.width = 2;
    image.height = 1;
    image.rgba.assign(8, 0);
    image.rgba[0] = static_cast<std::uint8_t>(frame.index);
  }
  std::size_t most_under_way() const override { return 2; }
  void start(const Frame& frame) override {
    draw_one(frame);
    begun_.push_back(frame.index);
    if (begun_.size() > 2) throw DeviceError("three pictures under way");
  }
  void finish(MovieImage& image) override {
    image.y.assign(1, static_cast<std::uint8_t>(begun_.at(0)));
    begun_.erase(begun_.begin());
  }
  const std::string& gl_renderer() const override { return name_; }

 private:
  void draw_one(const Frame& frame) {
    work(behaviour_now.draw_time);
    if (frame.index == behaviour_now.draw_fails_at) throw DeviceError("drawing failed on purpose");
    const std::lock_guard lock(record_mutex);
    if (record_now.drawn.empty() || record_now.drawn.back() != frame.index) record_now.drawn.push_back(frame.index);
    if (std::this_thread::get_id() != record_now.renderer_thread) record_now.drawn_elsewhere = true;
  }

  std::vector<std::int64_t> begun_;
  std::string name_ = "fake renderer";
};

class FakeMovie final : public MovieSink {
 public:
  void write(const MovieImage& image) override {
    work(behaviour_now.encode_time);
    const std::int64_t frame = image.y[0];
    if (frame == behaviour_now.encode_fails_at) throw OutputError("encoding failed on purpose");
    const std::lock_guard lock(record_mutex);
    record_now.encoded.push_back(frame);
    record_now.most_ahead = std::max(record_now.most_ahead, record_now.filled - frame);
  }
  void finish() override {
    if (behaviour_now.finish_fails) throw OutputError("finishing failed on purpose");
    const std::lock_guard lock(record_mutex);
    record_now.movie_finished = true;
  }
  const std::string& encoder() const override { return name_; }

 private:
  std::string name_ = "fake encoder";
};

}  // namespace

void behave(const FakeBehaviour& behaviour) {
  behaviour_now = behaviour;
  record_now = {};
}

const FakeRecord& record() { return record_now; }

std::unique_ptr<Simulation> make_simulation(const Scene& scene, int /*threads*/, InstructionSet /*set*/) {
  return std::make_unique<FakeSimulation>(scene);
}

std::unique_ptr<Renderer> make_renderer(const Scene& /*scene*/, const StaticScene& /*static_scene*/,
                                        const DeviceChoice& /*choice*/, int /*threads*/) {
  std::this_thread::sleep_for(behaviour_now.device_time);
  {
    const std::lock_guard lock(record_mutex);
    record_now.steps_ahead = record_now.steps;
  }
  if (behaviour_now.no_device) throw DeviceError("no device on purpose");
  return std::make_unique<FakeRenderer>();
}

StaticScene make_static_scene(const Scene& /*scene*/, SetSnapshot /*walls*/) { return {}; }

std::array<double, 2> color_range(const Scene& /*scene*/, const StaticScene& /*static_scene*/) { return {0, 1}; }

void draw_on_calling_thread() {}

void load_movies() {}

std::unique_ptr<MovieSink> make_movie_sink(const std::filesystem::path& /*folder*/, const Scene& /*scene*/,
                                           const Provenance& /*provenance*/) {
  if (behaviour_now.no_encoder) throw OutputError("no encoder on purpose");
  const std::lock_guard lock(record_mutex);
  record_now.movie_made = true;
  return std::make_unique<FakeMovie>();
}

void write_png(const std::filesystem::path& file, const Image& image, bool /*alpha*/, const Provenance& /*provenance*/,
               double /*time*/) {
  if (image.rgba[0] == behaviour_now.png_fails_at) throw OutputError("PNG failed on purpose");
  const std::lock_guard lock(record_mutex);
  record_now.pngs.insert(file.filename().string());
}

}  // namespace weir
