// Drawing and encoding beside the solver: one thread draws (and owns the GL context), one encodes the movie, some
// compress PNG files. They count themselves while they work, so that the solver can leave them as many processors: a loop
// whose threads share their processors with others waits for the slowest.
// Frames and images are recycled buffers of fixed number, so a slow stage holds up those before it.
//
// A stage that fails keeps emptying its queue without working, so that no stage waits for it in vain, and the others finish
// their items; finish() throws the first error.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <exception>
#include <filesystem>
#include <future>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "frame/frame.h"
#include "frame/image.h"
#include "output/sink.h"
#include "render/renderer.h"
#include "run/queue.h"
#include "sph/simulation.h"

namespace weir {

struct PictureTimes {  // s, of work; PNG workers added up
  double render = 0;
  double encode = 0;
  double write = 0;
};

class Pictures {
 public:
  static constexpr int most_png_workers = 4;  // beyond that the solver starves

  // Starts the drawing thread and makes the renderer on it. The arguments live until await_device() returns; `particles`
  // are those of a snapshot.
  Pictures(const Scene& scene, const StaticScene& static_scene, std::int64_t particles, const DeviceChoice& device);
  ~Pictures();
  Pictures(const Pictures&) = delete;
  Pictures& operator=(const Pictures&) = delete;

  // Until the device has started, or failed to, snapshots wait in the queue.
  bool device_starts() const { return made_.wait_for(std::chrono::seconds(0)) != std::future_status::ready; }
  // Throws DeviceError.
  void await_device() { gl_renderer_ = made_.get(); }
  // Starts to write; the folder is there. Throws OutputError.
  void open(const std::filesystem::path& folder, const Provenance& provenance, int png_workers);

  bool wants(std::int64_t frame) const;
  bool has_room() const { return !free_snapshots_.empty(); }  // add() would not wait
  // Queues a snapshot of the simulation; waits while all buffers are in use.
  void add(Simulation& simulation);
  // A stage has failed: no further picture will be written.
  bool failed() const { return failed_; }
  // How many threads draw, encode or compress at this moment.
  const std::atomic<int>& at_work() const { return at_work_; }
  // Waits until everything is drawn and written. Throws the first error of any stage.
  void finish();

  std::int64_t drawn() const { return drawn_; }
  const std::string& gl_renderer() const { return gl_renderer_; }
  const std::string& encoder() const { return encoder_; }
  PictureTimes times() const { return times_; }  // after finish()

 private:
  class AtWork;
  using SharedImage = std::shared_ptr<const Image>;  // a frame's file and its still are one picture
  struct PngJob {
    SharedImage image;
    double time = 0;  // s
    std::filesystem::path file;
  };
  // Snapshots in flight: one being drawn, one waiting, one being filled. Small ones may be more, since several wait while
  // the device starts and shaders are compiled.
  static constexpr std::int64_t least_snapshots = 3;
  static constexpr std::int64_t most_snapshots = 8;
  static constexpr std::int64_t snapshot_bytes = 32 << 20;  // of all of them, beyond the least
  static constexpr std::int64_t bytes_per_particle = sizeof(glm::vec3) + sizeof(float);
  // Movie pictures: one being read, one encoded, one waiting.
  static constexpr int movie_buffers = 3;
  // Images beyond those that the PNG workers hold: one being drawn, one waiting.
  static constexpr int image_buffers = 2;

  std::unique_ptr<Renderer> start_device(const StaticScene& static_scene, const DeviceChoice& device,
                                         std::promise<std::string> ready);
  void draw_frames(Renderer& renderer);
  void draw_one(Renderer& renderer, const Frame& frame);
  void draw_movie(Renderer& renderer, const Frame& frame);
  void pass_on_movie(Renderer& renderer);
  void draw_png(Renderer& renderer, const Frame& frame);
  void encode_movie();
  void write_pngs(int worker);
  void fail(std::exception_ptr error);
  void end_threads();

  const Scene& scene_;
  std::vector<std::int64_t> stills_;  // frame numbers, ascending
  std::filesystem::path folder_;
  bool opened_ = false;
  Provenance provenance_;
  std::future<std::string> made_;
  std::string gl_renderer_;
  std::string encoder_;
  std::unique_ptr<MovieSink> movie_;

  // Pools before queues: items left in a queue return to its pool.
  Queue<std::unique_ptr<Image>> free_images_;
  Queue<MovieImage> free_movie_images_;
  Queue<Snapshot> free_snapshots_;
  Queue<Snapshot> snapshots_;
  Queue<MovieImage> movie_images_;
  Queue<PngJob> png_jobs_;

  std::atomic<int> at_work_ = 0;
  std::atomic<bool> failed_ = false;
  std::mutex mutex_;  // of the next two
  std::exception_ptr error_;
  PictureTimes times_;
  std::atomic<std::int64_t> drawn_ = 0;

  std::deque<MovieImage> under_way_;  // begun and not yet read; of the drawing thread alone

  std::thread drawing_;
  std::thread encoding_;
  std::vector<std::thread> png_workers_;
};

}  // namespace weir
