// A valid scene that costs nothing.
#pragma once

#include "scene/scene.h"

namespace weir {

// 100 particles at rest without gravity; 11 frames of 64 x 48.
inline Scene small_scene() {
  Scene scene;
  scene.name = "small";
  scene.title = "Small";
  scene.duration = 0.5;
  scene.particle_spacing = 0.1;
  scene.gravity = Vec3(0);
  scene.fluid.volumes.push_back({.shape = Box{.min = Vec3(0), .max = Vec3(1, 1, 0)}});
  scene.render.size = {64, 48};
  scene.render.fps = 20;
  scene.output.log.every = 0.125;
  return scene;
}

}  // namespace weir
