// Periodic axes and the domain: lengths, fluid volumes and tanks.
#include <algorithm>
#include <cmath>

#include "scene/checker.h"
#include "scene/geometry.h"
#include "scene/names.h"
#include "scene/paths.h"
#include "scene/span.h"
#include "scene/tank_sides.h"

namespace weir {

namespace {

constexpr double slack = 1e-6;  // dx, for rounding

std::string_view axis_name(int axis) { return std::string_view("xyz").substr(static_cast<std::size_t>(axis), 1); }

bool whole(double spacings) { return std::abs(spacings - std::round(spacings)) <= slack; }

// "0.97 m long along x, 9.7 spacings of 0.1 m; ..."
std::string not_whole(double length, double dx, int axis) {
  const double below = std::floor(length / dx);
  const auto choices = [&](auto value) {
    return below < 1 ? fmt::format("{:.10g}", value(below + 1))
                     : fmt::format("{:.10g} or {:.10g}", value(below), value(below + 1));
  };
  return fmt::format(
      "{:.10g} m long along {}, {:.7g} spacings of {} m; it must be a whole number of them: choose a length of {} m, "
      "or "
      "a spacing of {} m",
      length, axis_name(axis), length / dx, number_text(dx), choices([&](double n) { return n * dx; }),
      choices([&](double n) { return length / n; }));
}

class PeriodicRules {
 public:
  explicit PeriodicRules(Checker& checker) : checker_(checker), scene_(checker.scene) {}

  void check() {
    check_axes();
    if (!checker_.usable("periodic", "domain")) return;
    if (scene_.periodic.empty()) {
      if (scene_.domain) {
        checker_.add("domain", "without periodic axes is not built yet; name axes in `periodic`, or leave it out");
      }
      return;
    }
    if (scene_.domain) check_corners(*scene_.domain);
    if (!checker_.usable("periodic", "domain", "particles.spacing", "fluid.volumes", "walls")) return;
    for (int axis = 0; axis < scene_.dimension; ++axis) {
      if (is_periodic(scene_, axis)) check_along(axis);
    }
  }

 private:
  void check_axes() {
    for (std::size_t i = 0; i < scene_.periodic.size(); ++i) {
      const auto axis = scene_.periodic.begin() + static_cast<std::ptrdiff_t>(i);
      if (scene_.dimension == 2 && *axis == Axis::z) {
        checker_.add(fmt::format("periodic.{}", i), "is z; a 2D scene has x and y");
      } else if (std::find(scene_.periodic.begin(), axis, *axis) != axis) {
        checker_.add(fmt::format("periodic.{}", i), "repeats an axis");
      }
    }
  }

  void check_corners(const Bounds& domain) {
    for (int axis = 0; axis < scene_.dimension; ++axis) {
      if (domain.min[axis] < domain.max[axis]) continue;
      return checker_.add("domain.max",
                          fmt::format("must lie above min along {}: min is {}, max is {}", axis_name(axis),
                                      number_text(domain.min[axis]), number_text(domain.max[axis])));
    }
  }

  void check_along(int axis) {
    const Bounds extent = periodic_extent(scene_);
    const double dx = scene_.particle_spacing;
    const double length = extent.max[axis] - extent.min[axis];
    const std::string path = scene_.domain ? "domain" : "periodic";
    const std::string_view verb = scene_.domain ? "is" : "makes the domain";
    const double least = support_radius(scene_) + dx;
    if (!whole(length / dx)) {
      checker_.add(path, fmt::format("{} {}", verb, not_whole(length, dx, axis)));
    } else if (checker_.usable("solver.kernel") && length < least - slack * dx) {
      checker_.add(
          path, fmt::format("{} {:.10g} m long along {}; it must hold the support radius and a spacing, {:.6g} m", verb,
                            length, axis_name(axis), least));
    }
    if (!checker_.usable(path)) return;
    for (std::size_t i = 0; i < scene_.fluid.volumes.size(); ++i) check_volume(i, axis, extent);
    for (std::size_t i = 0; i < scene_.walls.size(); ++i) {
      if (const auto* tank = std::get_if<Tank>(&scene_.walls[i].shape)) check_tank(*tank, wall_path(scene_, i), axis);
    }
  }

  void check_volume(std::size_t index, int axis, const Bounds& extent) {
    const Bounds box = shape_bounds(scene_.fluid.volumes[index].shape, scene_.dimension);
    const double margin = slack * scene_.particle_spacing;
    if (box.min[axis] >= extent.min[axis] - margin && box.max[axis] <= extent.max[axis] + margin) return;
    checker_.add(volume_path(scene_, index),
                 fmt::format("leaves the domain along {}, a periodic axis: it reaches from {:.10g} to {:.10g} m, the "
                             "domain from {:.10g} to {:.10g} m",
                             axis_name(axis), box.min[axis], box.max[axis], extent.min[axis], extent.max[axis]));
  }

  void check_tank(const Tank& tank, const std::string& path, int axis) {
    std::string closed;
    for (const Side side : tank_sides(axis, scene_.dimension)) {
      if (!is_open(tank, side)) closed += fmt::format("{}{}", closed.empty() ? "" : " and ", name_of(side));
    }
    if (!closed.empty()) {
      checker_.add(path + ".open", fmt::format("must name {}: {} is a periodic axis", closed, axis_name(axis)));
    }
    const double length = tank.max[axis] - tank.min[axis];
    if (!whole(length / scene_.particle_spacing)) {
      checker_.add(path, "is " + not_whole(length, scene_.particle_spacing, axis));
    }
  }

  Checker& checker_;
  const Scene& scene_;
};

}  // namespace

void check_periodic(Checker& checker) { PeriodicRules(checker).check(); }

}  // namespace weir
