// Overlaps of volumes and walls, found by comparing their particles; fluid particles are not stored.
#include <algorithm>
#include <optional>

#include "scene/checker.h"
#include "scene/geometry.h"
#include "scene/lattice.h"
#include "scene/origin.h"
#include "scene/overlap.h"
#include "scene/paths.h"
#include "scene/sampling.h"
#include "scene/tank_sides.h"

namespace weir {

namespace {

// Sizes that are no multiple of the spacing are rounded, so that shapes that only touch may come to within half of it.
constexpr double too_near = 0.49;  // dx
constexpr double slack = 1e-6;     // dx, for rounding

// The region within a closed outline, and whether the solid fills it.
struct Outline {
  Shape shape;
  bool solid_inside;
};

// A tank whose open sides are across periodic axes is closed all the same: its walls go on in its images.
std::optional<Outline> outline(const Tank& tank, const Scene& scene) {
  Box box{tank.min, tank.max};
  std::size_t joined_sides = 0;
  for (int axis = 0; axis < scene.dimension; ++axis) {
    if (!is_periodic(scene, axis)) continue;
    for (const Side side : tank_sides(axis, scene.dimension)) joined_sides += is_open(tank, side) ? 1 : 0;
    box.min[axis] = periodic_extent(scene).min[axis];
    box.max[axis] = periodic_extent(scene).max[axis];
  }
  if (joined_sides < tank.open.size()) return std::nullopt;
  return Outline{box, false};
}
std::optional<Outline> outline(const Block& block, const Scene&) { return Outline{Box{block.min, block.max}, true}; }
std::optional<Outline> outline(const Polyline& line, const Scene&) {
  if (!line.closed) return std::nullopt;
  const bool counterclockwise = signed_area(line.points) > 0;  // then the inside is on the left
  return Outline{Polygon{line.points}, counterclockwise == (line.solid == Flank::left)};
}
std::optional<Outline> outline(const Round& round, const Scene&) {
  return Outline{Ball{round.center, round.radius}, round.solid == Face::inside};
}

std::optional<Outline> outline(const PolygonWall& polygon, const Scene&) {
  return Outline{Polygon{polygon.points}, polygon.solid == Face::inside};
}

std::optional<Outline> outline(const Wall& wall, const Scene& scene) {
  return std::visit([&](const auto& shape) { return outline(shape, scene); }, wall.shape);
}

class Overlap {
 public:
  explicit Overlap(Checker& checker)
      : checker_(checker),
        origin_(scene_origin(checker.scene)),
        scene_(relative_to(checker.scene, origin_)),
        dimension_(scene_.dimension),
        dx_(scene_.particle_spacing) {}

  void report() {
    for (std::size_t i = 0; i < scene_.fluid.volumes.size(); ++i) {
      if (!checker_.usable(volume_path(i))) continue;
      Lattice lattice(scene_.fluid.volumes[i].shape, dimension_, dx_);
      if (!lattice.empty()) fluid_.push_back({i, std::move(lattice), {}, false});
    }
    for (const Fluid& fluid : fluid_) reach_ = around(reach_, grown(fluid.lattice.bounds(), dx_));
    for (std::size_t i = 0; i < scene_.walls.size(); ++i) find_overlaps_with_wall(i);
    for (Fluid& fluid : fluid_) {
      report_overlap(fluid);
      for (const std::size_t wall : fluid.walls) {
        checker_.add(volume_path(scene_, fluid.index), fmt::format("reaches into {}", wall_path(scene_, wall)));
      }
      report_outside(fluid);
    }
  }

 private:
  // A volume that has particles.
  struct Fluid {
    std::size_t index;
    Lattice lattice;
    std::vector<std::size_t> walls;  // that it reaches into, ascending
    bool distinct = false;           // overlaps no volume before it
  };

  void find_overlaps_with_wall(std::size_t index) {
    if (!checker_.usable(wall_path(index))) {
      all_walls_ = false;
      return;
    }
    const Wall& wall = scene_.walls[index];
    const std::optional<Outline> closed = outline(wall, scene_);
    if (closed && !closed->solid_inside && wall.holes.empty()) containers_.push_back(widened(closed->shape));

    std::vector<Vec3> points = sample_wall(wall, dimension_, dx_, wall_layers(scene_, wall));
    if (points.empty()) {
      checker_.add(wall_path(scene_, index),
                   fmt::format("makes no particle at a spacing of {} m: make it thicker, or the spacing smaller",
                               number_text(dx_)));
    }
    std::erase_if(points, [&](const Vec3& point) { return !contains(reach_, point); });
    std::sort(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) { return a.y < b.y; });
    for (Fluid& fluid : fluid_) {
      const bool near = any_near(fluid.lattice, points, too_near * dx_);
      const bool within = closed && closed->solid_inside && any_inside(fluid.lattice, closed->shape, wall.holes);
      if (near || within) fluid.walls.push_back(index);
    }
  }

  void report_overlap(Fluid& fluid) {
    std::vector<std::size_t> met;
    for (const Fluid& other : fluid_) {
      if (&other == &fluid) break;
      if (overlap(fluid.lattice, other.lattice) ||
          (other.distinct && any_near(fluid.lattice, other.lattice, too_near * dx_))) {
        met.push_back(other.index);
      }
    }
    fluid.distinct = met.empty();
    if (fluid.distinct) return;
    const std::string more = met.size() > 1 ? fmt::format(" and {} more", met.size() - 1) : "";
    checker_.add(volume_path(scene_, fluid.index),
                 fmt::format("overlaps {}{}", volume_path(scene_, met.front()), more));
  }

  bool overlap(const Lattice& a, const Lattice& b) const {
    if (apart(shape_bounds(a.shape(), dimension_), shape_bounds(b.shape(), dimension_), dimension_, slack * dx_))
      return false;
    const bool boxes = std::holds_alternative<Box>(a.shape()) && std::holds_alternative<Box>(b.shape());
    return boxes || any_inside(a, b.shape()) || any_inside(b, a.shape());
  }

  void report_outside(const Fluid& fluid) {
    if (containers_.empty() || !all_walls_) return;
    const Outsiders outside = outside_all(fluid.lattice, containers_);
    if (outside.count == 0) return;
    checker_.add(volume_path(scene_, fluid.index),
                 fmt::format("lies outside the closed walls: {} of {} particles, such as at {}", outside.count,
                             fluid.lattice.count(), point_text(outside.first + origin_, dimension_)));
  }

  // The last particle of a rounded box may lie on the face itself.
  Shape widened(const Shape& shape) const {
    const auto* box = std::get_if<Box>(&shape);
    return box == nullptr ? shape : Box{box->min - slack * dx_, box->max + slack * dx_};
  }

  Checker& checker_;
  Vec3 origin_;
  Scene scene_;  // as it is sampled
  int dimension_;
  double dx_;
  std::vector<Fluid> fluid_;
  Bounds reach_ = empty_bounds;  // around all fluid; of walls beyond, no particle is near it
  std::vector<Shape> containers_;
  bool all_walls_ = true;
};

}  // namespace

void check_overlap(Checker& checker) {
  if (checker.usable("particles.spacing", "solver.kernel")) Overlap(checker).report();
}

}  // namespace weir
