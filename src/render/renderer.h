// Draws frames. The implementation lives in the module weir_render; nothing here needs OpenGL.
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

  // All of these draw at the scene's size, resize pictures that do not fit, throw DeviceError, and must be called on the
  // thread that made this.

  virtual void draw(const Frame& frame, Image& image) = 0;

  // The same picture for a movie, in two halves so that the device draws one while the last is read: start() begins it,
  // finish() waits for the one begun first. At most so many may be under way, two or, where that gains nothing, one; then nothing
  // else may be drawn between the halves.
  virtual std::size_t most_under_way() const = 0;
  virtual void start(const Frame& frame) = 0;
  virtual void finish(MovieImage& image) = 0;

  virtual const std::string& gl_renderer() const = 0;
};

// Who puts a movie's pictures together of background, particles and texts.
enum class MovieBy {
  fitting,    // the processor if the device is nothing else, or the device
  device,     // as other pictures
  processor,  // the pixels are the same but for rounding
};

// Which device draws: "auto", "software", or its number in the list of `list_devices`.
struct DeviceChoice {
  std::string device = "auto";
  MovieBy movie_by = MovieBy::fitting;
};
DeviceChoice device_choice(const std::string& requested);  // `requested`, else WEIR_GL_DEVICE, else auto

// Loads the module. `threads` of the processor make pixels, as for thread_count(). Throws DeviceError with every display and
// device tried.
std::unique_ptr<Renderer> make_renderer(const Scene& scene, const StaticScene& static_scene, const DeviceChoice& choice,
                                        int threads = 0);
// Devices that are the processor use the calling thread alone from now on: who has other work for the rest knows then what
// drawing takes. To be called before there are threads that read the environment; what that says already stays.
void draw_on_calling_thread();
std::vector<DeviceTrial> list_devices();

// What does not move in this scene, from a snapshot of its walls.
StaticScene make_static_scene(const Scene& scene, SetSnapshot walls);

// The colour range that pictures of this scene use, in the unit of the quantity (fixed, or estimated from the scene).
std::array<double, 2> color_range(const Scene& scene, const StaticScene& static_scene);

}  // namespace weir
