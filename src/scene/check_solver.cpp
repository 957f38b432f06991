// Settings of the solver and of walls that require each other.
#include "scene/checker.h"
#include "scene/names.h"
#include "scene/paths.h"

namespace weir {

void check_solver(Checker& checker) {
  const Scene& scene = checker.scene;
  const Solver& solver = scene.solver;
  for (std::size_t i = 0; i < scene.walls.size(); ++i) {
    if (!checker.usable(wall_path(i)) || scene.walls[i].slide == Vec3(0)) continue;
    const std::string path = wall_path(scene, i) + ".motion.slide";
    // Friction alone carries the motion to the fluid, and mirrored walls have no state that friction could act with.
    if (checker.usable("solver.wall_slip") && solver.wall_slip != WallSlip::no_slip) {
      checker.add(path, fmt::format("needs solver.wall_slip: no_slip; it is {}", name_of(solver.wall_slip)));
    }
    if (checker.usable("solver.wall_pressure") && solver.wall_pressure != WallPressure::extrapolated) {
      checker.add(path,
                  fmt::format("needs solver.wall_pressure: extrapolated; it is {}", name_of(solver.wall_pressure)));
    }
  }
}

}  // namespace weir
