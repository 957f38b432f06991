#include "scene/memory.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <string>

#include "equations/kernels.h"
#include "scene/geometry.h"

namespace weir {

namespace {

double length_of(const Polyline& line) {
  double length = 0;
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) length += glm::length(line.points[i + 1] - line.points[i]);
  if (line.closed && !line.points.empty()) length += glm::length(line.points.front() - line.points.back());
  return length;
}

double box_content(const Vec3& size, int dimension) {
  double product = 1;
  for (int axis = 0; axis < dimension; ++axis) product *= std::max(size[axis], 0.0);
  return product;
}

// Area or volume that the layers of a wall fill.
double content(const Tank& tank, int dimension, double thick) {
  return box_content(tank.max - tank.min + 2 * thick, dimension) - box_content(tank.max - tank.min, dimension);
}
double content(const Block& block, int dimension, double thick) {
  return box_content(block.max - block.min, dimension) - box_content(block.max - block.min - 2 * thick, dimension);
}
double content(const Polyline& line, int, double thick) { return length_of(line) * thick; }
double content(const PolygonWall& polygon, int, double thick) { return length_of(outline_of(polygon)) * thick; }
double content(const Round& round, int dimension, double thick) {
  const double inner = round.solid == Face::inside ? std::max(round.radius - thick, 0.0) : round.radius;
  const double outer = round.solid == Face::inside ? round.radius : round.radius + thick;
  return measure(Ball{round.center, outer}, dimension) - measure(Ball{round.center, inner}, dimension);
}

// A snapshot, and its file twice while it is put together: the same numbers, in vectors of three, and two more for each
// particle.
double bytes_in_particle_files(const Scene& scene) {
  if (!scene.output.particles) return 0;
  double numbers = 3 * 3 + 2 * 2;
  for (const ParticleField field : scene.output.particles->fields) {
    numbers += facts_of(quantity_of(field)).components == Components::one ? 3 : 3 * 3;
  }
  return 4 * numbers;
}

}  // namespace

// Positions of d dimensions, a copy for the sort, and their tiling:
//   4 x 4 d + 4 x 3   x and its compensation, twice; id, twice; order
//   2 d + d           boxes of clusters (2 d floats for 4 particles), centres of groups (2 x d doubles for 16)
double bytes_per_wall_particle(const Scene& scene) {
  const int d = scene.dimension;
  return 4 * (4 * d + 3) + 3 * d;
}

// Beside the position
//   4 x 2 d + 4 x 2   velocity, acceleration; density, pressure
//   8                 while the state is hashed
// and two kinds of lists, with and without the skin, whose numbers of 4 bytes stand for some four pairs (more in 3D); they
// grow by halves. Measured with 10 million fluid particles: 110 bytes for each in 2D and, walls apart, 168 in 3D.
double bytes_per_particle(const Scene& scene) {
  const int d = scene.dimension;
  const double state = bytes_per_wall_particle(scene) + 4 * (2 * d + 2) + 8;
  const double skin = d == 2 ? 0.6 : 0.4;  // in spacings, as the solver has it
  const double reach = support_per_h * scene.solver.kernel.smoothing + skin;
  const double listed =
      std::numbers::pi * (d == 2 ? reach * reach : 4.0 / 3.0 * reach * reach * reach);  // particles, itself among them
  const double lists = (d == 2 ? 1.2 : 0.9) * listed;
  // Pictures: 16 bytes in each of three snapshots, in the frame made of one and in the copy that is drawn from.
  const double pictures = draws(scene) ? 5 * 16 : 0;
  return state + lists + pictures + bytes_in_particle_files(scene);
}

double expected_particles(const Scene& scene, const Volume& volume) {
  const double dx = scene.particle_spacing;
  double count = measure(volume.shape, scene.dimension) / std::pow(dx, scene.dimension);
  if (std::holds_alternative<Polygon>(volume.shape)) {
    // A sliver has few particles, but every row of its height is looked at.
    const Bounds box = shape_bounds(volume.shape, scene.dimension);
    count = std::max(count, (box.max.y - box.min.y) / dx);
  }
  return count;
}

double expected_particles(const Scene& scene, const Wall& wall) {
  const double thick = wall_layers(scene, wall) * scene.particle_spacing;
  const double filled = std::visit([&](const auto& each) { return content(each, scene.dimension, thick); }, wall.shape);
  return filled / std::pow(scene.particle_spacing, scene.dimension);
}

double available_memory() {
  std::ifstream file("/proc/meminfo");
  std::string name;
  while (file >> name) {
    double kibibytes = 0;
    if (name == "MemAvailable:" && file >> kibibytes) return 1024 * kibibytes;
    std::getline(file, name);
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace weir
