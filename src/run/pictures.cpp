#include "run/pictures.h"

#include <algorithm>
#include <utility>

#include "core/stopwatch.h"
#include "core/trace.h"
#include "run/picture_files.h"

namespace weir {

namespace fs = std::filesystem;

// A thread works for a stage until the end of the block.
class Pictures::AtWork {
 public:
  // `name` is the span's; it is never copied, so it must be a literal.
  AtWork(Pictures& pictures, double PictureTimes::*stage, const char* name)
      : pictures_(pictures), stage_(stage), span_(name) {
    ++pictures_.at_work_;
  }
  ~AtWork() {
    --pictures_.at_work_;
    const std::lock_guard lock(pictures_.mutex_);
    pictures_.times_.*stage_ += watch_.seconds();
  }
  AtWork(const AtWork&) = delete;
  AtWork& operator=(const AtWork&) = delete;

 private:
  Pictures& pictures_;
  double PictureTimes::*stage_;
  Stopwatch watch_;
  Span span_;
};

Pictures::Pictures(const Scene& scene, const StaticScene& static_scene, std::int64_t particles,
                   const DeviceChoice& device)
    : scene_(scene) {
  for (const double time : scene.output.stills) stills_.push_back(frame_at(scene, time));
  std::sort(stills_.begin(), stills_.end());
  const std::int64_t fit = snapshot_bytes / (bytes_per_particle * std::max<std::int64_t>(particles, 1));
  for (std::int64_t i = std::clamp(fit, least_snapshots, most_snapshots); i > 0; --i) free_snapshots_.push(Snapshot{});

  draw_on_calling_thread();
  std::promise<std::string> ready;
  made_ = ready.get_future();
  drawing_ = std::thread([this, &static_scene, &device, promise = std::move(ready)]() mutable {
    Trace::name_thread("drawing");
    if (const std::unique_ptr<Renderer> renderer = start_device(static_scene, device, std::move(promise)))
      draw_frames(*renderer);
  });
  try {
    if (scene.output.movie) load_movies();  // while the device starts
  } catch (...) {
    end_threads();
    throw;
  }
}

Pictures::~Pictures() { end_threads(); }

void Pictures::open(const fs::path& folder, const Provenance& provenance, int png_workers) {
  folder_ = folder;
  provenance_ = provenance;
  if (scene_.output.movie) {
    movie_ = make_movie_sink(folder, scene_, provenance);
    encoder_ = movie_->encoder();
    for (int i = 0; i < movie_buffers; ++i) free_movie_images_.push(MovieImage{});
    encoding_ = std::thread([this] { encode_movie(); });
  }
  const bool pngs = scene_.output.frames || !stills_.empty();
  const int workers = pngs ? std::clamp(png_workers, 1, most_png_workers) : 0;
  for (int i = 0; i < workers; ++i) png_workers_.emplace_back([this, i] { write_pngs(i); });
  for (int i = 0; i < image_buffers + workers; ++i) free_images_.push(std::make_unique<Image>());
  opened_ = true;
}

bool Pictures::wants(std::int64_t frame) const {
  return scene_.output.movie || scene_.output.frames || std::binary_search(stills_.begin(), stills_.end(), frame);
}

void Pictures::add(Simulation& simulation) {
  Snapshot snapshot = *free_snapshots_.pop();
  simulation.fill(snapshot, frame_request(scene_.render.color.by));
  snapshots_.push(std::move(snapshot));
}

void Pictures::finish() {
  end_threads();
  const std::lock_guard lock(mutex_);
  if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
}

// Each stage closes its successors once it has passed on everything, so joining in this order loses nothing.
void Pictures::end_threads() {
  snapshots_.close();
  if (!opened_) {  // no thread takes drawn images
    free_movie_images_.close();
    free_images_.close();
  }
  if (drawing_.joinable()) drawing_.join();
  if (encoding_.joinable()) encoding_.join();
  for (std::thread& worker : png_workers_) worker.join();
  png_workers_.clear();
}

void Pictures::fail(std::exception_ptr error) {
  const std::lock_guard lock(mutex_);
  if (!error_) error_ = std::move(error);
  failed_ = true;
}

// None if there is no device; `ready` then holds the reason.
std::unique_ptr<Renderer> Pictures::start_device(const StaticScene& static_scene, const DeviceChoice& device,
                                                 std::promise<std::string> ready) {
  std::unique_ptr<Renderer> renderer;
  ++at_work_;
  try {
    const Span span("start device");
    renderer = make_renderer(scene_, static_scene, device, 1);
    ready.set_value(renderer->gl_renderer());
  } catch (...) {
    ready.set_exception(std::current_exception());
  }
  --at_work_;
  return renderer;
}

void Pictures::draw_frames(Renderer& renderer) {
  bool broken = false;
  Frame frame;
  while (std::optional<Snapshot> snapshot = snapshots_.pop()) {
    try {
      if (!broken) {
        make_frame(*snapshot, scene_.render.color.by, frame);
        draw_one(renderer, frame);
      }
    } catch (...) {
      fail(std::current_exception());
      broken = true;
    }
    free_snapshots_.put_back(std::move(*snapshot));
  }
  try {
    while (!under_way_.empty()) pass_on_movie(renderer);
  } catch (...) {
    fail(std::current_exception());
  }
  movie_images_.close();
  png_jobs_.close();
}

void Pictures::draw_one(Renderer& renderer, const Frame& frame) {
  if (scene_.output.movie) draw_movie(renderer, frame);
  if (scene_.output.frames || std::binary_search(stills_.begin(), stills_.end(), frame.index))
    draw_png(renderer, frame);
  ++drawn_;
}

// The device draws a picture while the last one is read; but with no frame waiting, nothing is held back.
void Pictures::draw_movie(Renderer& renderer, const Frame& frame) {
  // Before it is drawn, so that the encoder holds up the solver.
  std::optional<MovieImage> image = free_movie_images_.pop();
  if (!image) return;
  {
    const AtWork work(*this, &PictureTimes::render, "begin picture");
    renderer.start(frame);
  }
  under_way_.push_back(std::move(*image));
  const std::size_t ahead = snapshots_.empty() ? 0 : renderer.most_under_way() - 1;
  while (under_way_.size() > ahead) pass_on_movie(renderer);
}

void Pictures::pass_on_movie(Renderer& renderer) {
  MovieImage image = std::move(under_way_.front());
  under_way_.pop_front();
  {
    const AtWork work(*this, &PictureTimes::render, "finish picture");
    renderer.finish(image);
  }
  movie_images_.push(std::move(image));
}

void Pictures::draw_png(Renderer& renderer, const Frame& frame) {
  std::optional<std::unique_ptr<Image>> room = free_images_.pop();
  if (!room) return;
  std::unique_ptr<Image> image = std::move(*room);
  {
    const AtWork work(*this, &PictureTimes::render, "draw");
    renderer.draw(frame, *image);
  }
  const SharedImage shared(image.release(), [this](const Image* done) {
    free_images_.put_back(std::unique_ptr<Image>(const_cast<Image*>(done)));  // the last reference is gone
  });
  if (scene_.output.frames) png_jobs_.push({shared, frame.time, folder_ / frame_file(frame.index)});
  if (std::binary_search(stills_.begin(), stills_.end(), frame.index)) {
    png_jobs_.push({shared, frame.time, folder_ / still_file(frame.index)});
  }
}

void Pictures::encode_movie() {
  Trace::name_thread("encoding");
  bool broken = false;
  const auto attempt = [&](const char* name, auto work) {
    if (broken) return;
    const AtWork at_work(*this, &PictureTimes::encode, name);
    try {
      work();
    } catch (...) {
      fail(std::current_exception());
      broken = true;
    }
  };
  while (std::optional<MovieImage> image = movie_images_.pop()) {
    attempt("encode", [&] { movie_->write(*image); });
    free_movie_images_.put_back(std::move(*image));
  }
  attempt("finish movie", [&] { movie_->finish(); });
}

void Pictures::write_pngs(int worker) {
  // Literals, as spans need; there are never more workers.
  static constexpr std::array<const char*, most_png_workers> names = {"png 1", "png 2", "png 3", "png 4"};
  Trace::name_thread(names[worker]);
  while (const std::optional<PngJob> job = png_jobs_.pop()) {
    const AtWork work(*this, &PictureTimes::write, "write PNG");
    try {
      // Once a stage has failed the run ends; files still queued would only delay its end.
      if (!failed_) write_png(job->file, *job->image, scene_.render.transparent, provenance_, job->time);
    } catch (...) {
      fail(std::current_exception());
    }
  }
}

}  // namespace weir
