// Interface of the renderer. The implementation is in the module weir_render; this header does not need OpenGL.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "frame/frame.h"
#include "frame/image.h"
#include "scene/scene.h"

namespace weir {

// One display or device that was tried, in order.
struct DeviceTrial {
  std::string name;
  bool usable = false;
  std::string detail;  // GL renderer and version, or the call that failed, its EGL error and a hint
};

class Renderer {
 public:
  virtual ~Renderer() = default;
  Renderer() = default;
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  // These functions draw at the scene's size, resize pictures of other sizes, throw DeviceError, and must be called on
  // the thread of construction.

  virtual void draw(const Frame& frame, Image& image) = 0;

  // The same picture for a movie, in two steps, so that the device draws one frame while the last is read: start()
  // starts a frame, finish() waits for the first frame started. At most most_under_way() frames may be started: two, or
  // one where two gain nothing; nothing else may be drawn in between.
  virtual std::size_t most_under_way() const = 0;
  virtual void start(const Frame& frame) = 0;
  virtual void finish(MovieImage& image) = 0;

  virtual const std::string& gl_renderer() const = 0;
};

// Where background, particles and texts of a movie frame are composed.
enum class MovieBy {
  fitting,    // on the processor for a software device, else on the device
  device,     // as for other pictures
  processor,  // the same pixels up to rounding
};

// The device: "auto", "software", or a number in the list of list_devices().
struct DeviceChoice {
  std::string device = "auto";
  MovieBy movie_by = MovieBy::fitting;
};
DeviceChoice device_choice(const std::string& requested);  // `requested`, else WEIR_GL_DEVICE, else auto

// Loads the module. `threads`, as for thread_count(), rasterise particles. Throws DeviceError naming every display and
// device tried.
std::unique_ptr<Renderer> make_renderer(const Scene& scene, const StaticScene& static_scene, const DeviceChoice& choice,
                                        int threads = 0);
// Restricts software devices to the calling thread, so that the processors that drawing takes are known. Must be called
// before any thread reads the environment; an existing LP_NUM_THREADS is kept.
void draw_on_calling_thread();
std::vector<DeviceTrial> list_devices();

// The static scene, from a snapshot of its walls. Scene, walls and frames are relative to the origin of the snapshots.
StaticScene make_static_scene(const Scene& scene, SetSnapshot walls);

// The colour range that pictures of this scene use, in the unit of the quantity (fixed, or estimated from the scene).
std::array<double, 2> color_range(const Scene& scene, const StaticScene& static_scene);

}  // namespace weir
