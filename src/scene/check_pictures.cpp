#include <cmath>

#include "scene/checker.h"

namespace weir {

namespace {

// More frames or rows than any disk holds; also the largest count that is computed.
constexpr double max_count = 1e9;

void check_view(Checker& checker, const View& view, const std::string& path) {
  if (!checker.usable(path)) return;
  if (const auto* solid = std::get_if<View3D>(&view); solid != nullptr && solid->eye == solid->target) {
    checker.add(path + ".target", "lies in the eye; give the camera something to look at");
  }
  if (std::holds_alternative<View3D>(view) && checker.scene.dimension == 2) {
    checker.add(path, "is a view of a 3D scene; a 2D scene needs center and width");
  }
  if (std::holds_alternative<View2D>(view) && checker.scene.dimension == 3) {
    checker.add(path, "is a view of a 2D scene; a 3D scene needs eye and target");
  }
}

void check_camera(Checker& checker) {
  const Camera& camera = checker.scene.camera;
  check_view(checker, camera.view, "camera.view");
  for (std::size_t i = 0; i < camera.keyframes.size(); ++i) {
    const CameraKeyframe& keyframe = camera.keyframes[i];
    const std::string path = fmt::format("camera.keyframes.{}", i);
    check_view(checker, keyframe.view, path);
    if (!checker.usable(path)) continue;
    if (std::holds_alternative<AutoView>(keyframe.view)) checker.add(path, "needs a view of its own");
    if (i == 0 || !checker.usable(fmt::format("camera.keyframes.{}", i - 1))) continue;
    if (keyframe.at <= camera.keyframes[i - 1].at) {
      checker.add(path + ".at", fmt::format("must come after {} s, the keyframe before it, got {}",
                                            number_text(camera.keyframes[i - 1].at), number_text(keyframe.at)));
    }
  }
}

void check_stills(Checker& checker) {
  const Scene& scene = checker.scene;
  for (std::size_t i = 0; i < scene.output.stills.size(); ++i) {
    const double at = scene.output.stills[i];
    const std::string path = fmt::format("output.stills.{}", i);
    if (!checker.usable(path, "duration", "render.fps")) continue;
    const double frame = std::round(at * scene.render.fps);
    if (frame > static_cast<double>(last_frame(scene))) {
      checker.add(path,
                  fmt::format("lies beyond the last frame at {} s, got {}",
                              number_text(static_cast<double>(last_frame(scene)) / scene.render.fps), number_text(at)));
    } else if (std::abs(at * scene.render.fps - frame) > 1e-6) {
      checker.add(path, fmt::format("is no frame time: at {} frames per second the nearest is {} s, got {}",
                                    scene.render.fps, number_text(frame / scene.render.fps), number_text(at)));
    }
  }
}

}  // namespace

void check_pictures(Checker& checker) {
  const Scene& scene = checker.scene;
  check_camera(checker);
  const auto& range = scene.render.color.range;
  if (range && checker.usable("render.color.range") && !((*range)[0] < (*range)[1])) {
    checker.add("render.color.range",
                fmt::format("must rise, got [{}, {}]", number_text((*range)[0]), number_text((*range)[1])));
  }
  if (checker.usable("duration", "render.fps") && scene.duration * scene.render.fps > max_count) {
    checker.add("duration", fmt::format("makes {:.3g} frames at {} per second; a run has at most {:.3g}",
                                        scene.duration * scene.render.fps, scene.render.fps, max_count));
  }
  if (checker.usable("duration", "output.log.every") && scene.duration / scene.output.log.every > max_count) {
    checker.add("output.log.every", fmt::format("makes {:.3g} rows; a log has at most {:.3g}",
                                                scene.duration / scene.output.log.every, max_count));
  }
  if (const auto& particles = scene.output.particles; particles && checker.usable("duration", "output.particles") &&
                                                      particles->every > 0 &&
                                                      scene.duration / particles->every > max_count) {
    checker.add("output.particles.every", fmt::format("makes {:.3g} files; a run has at most {:.3g}",
                                                      scene.duration / particles->every, max_count));
  }
  check_stills(checker);
  const bool pictures = scene.output.frames || !scene.output.stills.empty();
  if (scene.render.transparent && !pictures && checker.usable("render.transparent", "output")) {
    checker.add("render.transparent", "has no effect: only output.frames and output.stills can be transparent");
  }
}

}  // namespace weir
