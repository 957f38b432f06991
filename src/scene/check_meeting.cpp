// Volumes and walls against each other, judged by the particles that they make.
#include <algorithm>
#include <optional>

#include "scene/checker.h"
#include "scene/geometry.h"
#include "scene/paths.h"
#include "scene/point_grid.h"
#include "scene/sampling.h"

namespace weir {

namespace {

// Sizes that are no multiple of the spacing are rounded, so that shapes that only touch may come to within half of it.
constexpr double too_near = 0.49;  // dx
constexpr double slack = 1e-6;     // dx, for rounding

bool apart(const Bounds& a, const Bounds& b, int dimension, double gap) {
  for (int axis = 0; axis < dimension; ++axis) {
    if (a.max[axis] <= b.min[axis] + gap || b.max[axis] <= a.min[axis] + gap) return true;
  }
  return false;
}

bool in_hole(const Wall& wall, const Vec3& point, int dimension) {
  return std::any_of(wall.holes.begin(), wall.holes.end(),
                     [&](const Shape& hole) { return inside(hole, point, dimension); });
}

// A closed outline's inside, and whether that is where the solid is.
struct Outline {
  Shape shape;
  bool solid_inside;
};

std::optional<Outline> outline(const Tank& tank) {
  if (!tank.open.empty()) return std::nullopt;
  return Outline{Box{tank.min, tank.max}, false};
}
std::optional<Outline> outline(const Block& block) { return Outline{Box{block.min, block.max}, true}; }
std::optional<Outline> outline(const Polyline& line) {
  if (!line.closed) return std::nullopt;
  const bool counterclockwise = signed_area(line.points) > 0;  // then the inside is on the left
  return Outline{Polygon{line.points}, counterclockwise == (line.solid == Flank::left)};
}
std::optional<Outline> outline(const Round& round) {
  return Outline{Ball{round.center, round.radius}, round.solid == Face::inside};
}

std::optional<Outline> outline(const Wall& wall) {
  return std::visit([](const auto& shape) { return outline(shape); }, wall.shape);
}

class Meeting {
 public:
  explicit Meeting(Checker& checker)
      : checker_(checker),
        scene_(checker.scene),
        dimension_(scene_.dimension),
        dx_(scene_.particle_spacing),
        fluid_(dx_),
        walls_(dx_) {}

  void judge() {
    for (std::size_t i = 0; i < scene_.fluid.volumes.size(); ++i) {
      const bool usable = checker_.usable(volume_path(i));
      samples_.push_back(usable ? sample_volume(scene_.fluid.volumes[i].shape, dimension_, dx_) : std::vector<Vec3>());
    }
    for (std::size_t i = 0; i < scene_.walls.size(); ++i) add_wall(i);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      if (samples_[i].empty()) continue;
      judge_overlap(i);
      judge_walls(i);
      judge_outside(i);
    }
  }

 private:
  void add_wall(std::size_t index) {
    const Wall& wall = scene_.walls[index];
    if (!checker_.usable(wall_path(index))) {
      all_walls_ = false;
      return;
    }
    for (const Vec3& point : sample_wall(wall, dimension_, dx_, wall_layers(scene_, wall))) {
      walls_.add(point, static_cast<std::int32_t>(index));
    }
    const std::optional<Outline> closed = outline(wall);
    if (!closed) return;
    if (closed->solid_inside) {
      solids_.push_back({index, closed->shape});
    } else if (wall.holes.empty()) {
      containers_.push_back({index, closed->shape});
    }
  }

  void judge_overlap(std::size_t index) {
    const Shape& shape = scene_.fluid.volumes[index].shape;
    const Bounds box = shape_bounds(shape, dimension_);
    std::vector<std::size_t> met;
    for (std::size_t other = 0; other < index; ++other) {
      const Shape& other_shape = scene_.fluid.volumes[other].shape;
      if (samples_[other].empty() || apart(box, shape_bounds(other_shape, dimension_), dimension_, slack * dx_))
        continue;
      const bool boxes = std::holds_alternative<Box>(shape) && std::holds_alternative<Box>(other_shape);
      if (boxes || any_inside(samples_[index], other_shape) || any_inside(samples_[other], shape)) met.push_back(other);
    }
    if (samples_.size() == 1) return;
    for (const Vec3& point : samples_[index]) {
      fluid_.any_near(point, too_near * dx_, [&](std::int32_t label, const Vec3&) {
        if (std::find(met.begin(), met.end(), static_cast<std::size_t>(label)) == met.end()) {
          met.push_back(static_cast<std::size_t>(label));
        }
        return false;
      });
    }
    if (met.empty()) {
      for (const Vec3& point : samples_[index]) fluid_.add(point, static_cast<std::int32_t>(index));
      return;
    }
    // Not in the grid, which so holds few points a cell, and every look into it stays short, however many volumes
    // somebody puts in one place.
    std::sort(met.begin(), met.end());
    const std::string more = met.size() > 1 ? fmt::format(" and {} more", met.size() - 1) : "";
    checker_.add(volume_path(scene_, index), fmt::format("overlaps {}{}", volume_path(scene_, met.front()), more));
  }

  bool any_inside(const std::vector<Vec3>& points, const Shape& shape) const {
    return std::any_of(points.begin(), points.end(),
                       [&](const Vec3& point) { return inside(shape, point, dimension_); });
  }

  void judge_walls(std::size_t index) {
    std::vector<std::size_t> met;
    const auto meet = [&](std::size_t wall) {
      if (std::find(met.begin(), met.end(), wall) == met.end()) met.push_back(wall);
    };
    for (const Vec3& point : samples_[index]) {
      walls_.any_near(point, too_near * dx_, [&](std::int32_t label, const Vec3&) {
        meet(static_cast<std::size_t>(label));
        return false;
      });
      for (const auto& [wall, shape] : solids_) {
        if (inside(shape, point, dimension_) && !in_hole(scene_.walls[wall], point, dimension_)) meet(wall);
      }
    }
    std::sort(met.begin(), met.end());
    for (const std::size_t wall : met) {
      checker_.add(volume_path(scene_, index), fmt::format("reaches into {}", wall_path(scene_, wall)));
    }
  }

  void judge_outside(std::size_t index) {
    if (containers_.empty() || !all_walls_) return;
    std::size_t outside = 0;
    Vec3 first(0);
    for (const Vec3& point : samples_[index]) {
      const bool held = std::any_of(containers_.begin(), containers_.end(),
                                    [&](const auto& container) { return holds(container.second, point); });
      if (held) continue;
      if (outside++ == 0) first = point;
    }
    if (outside == 0) return;
    checker_.add(volume_path(scene_, index),
                 fmt::format("lies outside the closed walls: {} of {} particles, such as at {}", outside,
                             samples_[index].size(), point_text(first, dimension_)));
  }

  // The last particle of a rounded box may lie on the face itself.
  bool holds(const Shape& shape, const Vec3& point) const {
    if (const auto* box = std::get_if<Box>(&shape)) {
      return inside(Box{box->min - slack * dx_, box->max + slack * dx_}, point, dimension_);
    }
    return inside(shape, point, dimension_);
  }

  Checker& checker_;
  const Scene& scene_;
  int dimension_;
  double dx_;
  std::vector<std::vector<Vec3>> samples_;
  PointGrid fluid_;
  PointGrid walls_;
  std::vector<std::pair<std::size_t, Shape>> solids_;
  std::vector<std::pair<std::size_t, Shape>> containers_;
  bool all_walls_ = true;
};

}  // namespace

void check_meeting(Checker& checker) {
  if (checker.usable("particles.spacing", "solver.kernel")) Meeting(checker).judge();
}

}  // namespace weir
