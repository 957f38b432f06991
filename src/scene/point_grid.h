// Points in a hash grid, asked for neighbours of a point.
#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/types.h"

namespace weir {

class PointGrid {
 public:
  // `reach`: the largest distance that will be asked for, m.
  explicit PointGrid(double reach) : cell_(reach) {}

  void add(const Vec3& point, std::int32_t label) {
    next_.push_back(-1);
    points_.push_back(point);
    flat_ = flat_ && point.z == 0;
    labels_.push_back(label);
    const auto index = static_cast<std::int32_t>(points_.size() - 1);
    const auto [head, inserted] = heads_.try_emplace(key(cell(point)), index);
    if (inserted) return;
    next_.back() = head->second;
    head->second = index;
  }

  // Calls visit(label, point) for every point nearer than `distance`, until it returns true; says whether it did.
  template <class Visit>
  bool any_near(const Vec3& point, double distance, Visit visit) const {
    if (points_.empty()) return false;
    const glm::i64vec3 home = cell(point);
    const std::int64_t reach_z = flat_ && point.z == 0 ? 0 : 1;
    for (std::int64_t z = -reach_z; z <= reach_z; ++z) {
      for (std::int64_t y = -1; y <= 1; ++y) {
        for (std::int64_t x = -1; x <= 1; ++x) {
          const auto found = heads_.find(key(home + glm::i64vec3(x, y, z)));
          if (found == heads_.end()) continue;
          for (std::int32_t i = found->second; i >= 0; i = next_[static_cast<std::size_t>(i)]) {
            const Vec3& other = points_[static_cast<std::size_t>(i)];
            const Vec3 d = point - other;
            if (glm::dot(d, d) < distance * distance && visit(labels_[static_cast<std::size_t>(i)], other)) return true;
          }
        }
      }
    }
    return false;
  }
  bool any_near(const Vec3& point, double distance) const {
    return any_near(point, distance, [](std::int32_t, const Vec3&) { return true; });
  }

 private:
  glm::i64vec3 cell(const Vec3& point) const { return glm::i64vec3(glm::floor(point / cell_)); }
  // Cells that share a key only cost time: distances are compared anyway.
  static std::uint64_t key(const glm::i64vec3& cell) {
    return static_cast<std::uint64_t>(cell.x) * 0x9E3779B97F4A7C15U ^
           static_cast<std::uint64_t>(cell.y) * 0xC2B2AE3D27D4EB4FU ^
           static_cast<std::uint64_t>(cell.z) * 0x165667B19E3779F9U;
  }

  double cell_;
  bool flat_ = true;  // all points in the plane z = 0: a 2D scene
  std::vector<Vec3> points_;
  std::vector<std::int32_t> labels_;
  std::vector<std::int32_t> next_;  // of the same cell; -1: last
  std::unordered_map<std::uint64_t, std::int32_t> heads_;
};

}  // namespace weir
