// Small scenes built in C++, for tests.
#pragma once

#include "scene/scene.h"

namespace weir {

// A square or cube of fluid of n particles a side, at rest in free space without gravity.
inline Scene free_fluid(int dimension, int n, double dx = 0.1) {
  Scene scene;
  scene.name = "free_fluid";
  scene.dimension = dimension;
  scene.duration = 1;
  scene.gravity = Vec3(0);
  scene.particle_spacing = dx;
  const double side = n * dx;
  scene.fluid.volumes = {{.shape = Box{Vec3(0), {side, side, dimension == 3 ? side : 0}}}};
  scene.solver.compressibility = Stiffness{1e3};
  scene.output.movie.reset();
  return scene;
}

// A column of water in the corner of an open tank three times as wide.
inline Scene small_dam_break(int dimension, double dx) {
  Scene scene;
  scene.name = "small_dam_break";
  scene.dimension = dimension;
  scene.duration = 1;
  scene.gravity = dimension == 2 ? Vec3{0, -9.81, 0} : Vec3{0, 0, -9.81};
  scene.particle_spacing = dx;
  const Vec3 column = dimension == 2 ? Vec3{0.3, 0.5, 0} : Vec3{0.3, 0.2, 0.5};
  const Vec3 tank = dimension == 2 ? Vec3{0.9, 0.8, 0} : Vec3{0.9, 0.2, 0.8};
  scene.fluid.volumes = {{.shape = Box{Vec3(0), column}}};
  scene.walls = {{.shape = Tank{Vec3(0), tank, {Side::top}}, .layers = 2, .holes = {}}};
  scene.solver.compressibility = Stiffness{2e4};
  scene.output.movie.reset();
  return scene;
}

}  // namespace weir
