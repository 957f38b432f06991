// Shared by the files of rules.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "scene/check.h"
#include "scene/number.h"
#include "scene/path_set.h"

namespace weir {

class Checker {
 public:
  Checker(const Scene& the_scene, const Unread& unread) : scene(the_scene), unread_(unread) {}

  const Scene& scene;

  void add(std::string path, std::string message) {
    broken_.add(path);
    violations_.push_back({std::move(path), std::move(message)});
  }
  std::vector<Violation> take() { return std::move(violations_); }
  // Whether the values at all these paths were read and no rule so far has refused them.
  template <class... Path>
  bool usable(const Path&... paths) const {
    return (usable_one(std::string(paths)) && ...);
  }

 private:
  bool usable_one(const std::string& path) const { return !unread_(path) && !broken_.touches(path); }

  std::vector<Violation> violations_;
  PathSet broken_;
  const Unread& unread_;
};

// "(0.5, 1)" in 2D.
inline std::string point_text(const Vec3& point, int dimension) {
  std::string text = fmt::format("({:.6g}, {:.6g}", point.x, point.y);
  return dimension == 3 ? fmt::format("{}, {:.6g})", text, point.z) : text + ")";
}

void check_ranges(Checker& checker);    // each field by itself, by the field table
void check_geometry(Checker& checker);  // volumes and walls, each by itself and their number
void check_periodic(Checker& checker);  // periodic axes and the domain
void check_solver(Checker& checker);    // the solver's settings against walls
void check_overlap(Checker& checker);   // volumes and walls against each other
void check_timeline(Checker& checker);
void check_pictures(Checker& checker);  // camera, render, output

}  // namespace weir
