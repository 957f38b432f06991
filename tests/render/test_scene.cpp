#include "render/test_scene.h"

#include <cmath>

namespace weir::test {

namespace {

// A shift of up to a tenth of the spacing that depends on the index alone.
float wobble(int k, double dx) { return static_cast<float>(0.1 * dx * std::sin(12.9898 * k)); }

}  // namespace

Still blank(double pixels_per_metre) {
  Still still;
  still.scene.name = "blank";
  still.scene.duration = 1;
  still.scene.render.size = {320, 180};
  still.scene.render.overlay = {};
  still.scene.render.color.range = {{0, 1}};
  still.scene.camera.view = View2D{Vec3(0), 320 / pixels_per_metre};
  still.scene.particle_spacing = still.static_scene.particle_spacing = 1;
  return still;
}

Still dam_break() {
  Still still;
  still.scene.name = "dam_break";
  still.scene.title = "Dam break";
  still.scene.duration = 2;
  still.scene.render.size = {320, 180};
  const double dx = 0.03;
  still.scene.particle_spacing = still.static_scene.particle_spacing = dx;
  still.static_scene.max_speed_estimate = 4.43;
  still.scene.fluid.volumes.push_back({Box{Vec3(0), Vec3(1, 1, 0)}, Vec3(0), Vec3(0)});
  for (int i = -2; i < 102; ++i)
    for (int j = -2; j < 67; ++j)
      if (i < 0 || i >= 100 || j < 0) still.static_scene.walls.emplace_back((i + 0.5) * dx, (j + 0.5) * dx, 0);
  for (int i = 0; i < 33; ++i)
    for (int j = 0; j < 33; ++j) {
      const double x = (i + 0.5) * dx;
      const double y = (j + 0.5) * dx;
      const double stretch = 1 + 0.8 * (1 - y);
      still.frame.particles.emplace_back(static_cast<float>(x * stretch) + wobble(33 * i + j, dx),
                                         static_cast<float>(y / stretch) + wobble(33 * j + i, dx), 0.0f,
                                         static_cast<float>(4.4 * x * (1 - 0.6 * y)));
    }
  still.frame.time = 0.25;
  still.frame.cfl = 0.213;
  return still;
}

Still cup() {
  Still still;
  still.scene.name = "cup";
  still.scene.title = "Cup";
  still.scene.dimension = 3;
  still.scene.duration = 2;
  still.scene.gravity = Vec3(0, 0, -9.81);
  still.scene.render.size = {320, 180};
  const double dx = 0.1;
  still.scene.particle_spacing = still.static_scene.particle_spacing = dx;
  still.static_scene.max_speed_estimate = 4.43;
  still.scene.fluid.volumes.push_back({Box{Vec3(0), Vec3(0.8)}, Vec3(0), Vec3(0)});
  still.scene.walls = {{.shape = Tank{Vec3(0), Vec3(0.8, 0.8, 1.2), {Side::top}}, .layers = 1, .holes = {}}};
  for (int i = -1; i < 9; ++i)
    for (int j = -1; j < 9; ++j)
      for (int k = -1; k < 12; ++k)
        if (i < 0 || i > 7 || j < 0 || j > 7 || k < 0)
          still.static_scene.walls.emplace_back((i + 0.5) * dx, (j + 0.5) * dx, (k + 0.5) * dx);
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j)
      for (int k = 0; k < 8; ++k) {
        const int id = 64 * i + 8 * j + k;
        const double x = (i + 0.5) * dx;
        const double z = (k + 0.5) * dx;
        still.frame.particles.emplace_back(static_cast<float>(x) + wobble(id, dx),
                                           static_cast<float>((j + 0.5) * dx) + wobble(id + 7, dx),
                                           static_cast<float>(z * (0.7 + 0.6 * x)), static_cast<float>(5 * x * z));
      }
  still.frame.time = 1.5;
  still.frame.cfl = 0.3;
  return still;
}

Image drawn(const Still& still) {
  Image image;
  make_renderer(still.scene, still.static_scene, device_choice(""))->draw(still.frame, image);
  return image;
}

}  // namespace weir::test
