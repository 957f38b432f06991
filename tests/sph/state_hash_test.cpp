// Golden state hashes, one per case and instruction set: a change of the solver's structure must not change a bit of its
// results. Where a change means to, WEIR_BLESS=1 rewrites the file, and the CHANGELOG says which results changed and why.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "scene/names.h"
#include "scene/reader.h"
#include "sph/simulation.h"
#include "support/scenes.h"

namespace weir {
namespace {

constexpr const char* golden_file = "tests/golden/state_hashes.csv";

struct Case {
  std::string name;
  Scene scene;
  int steps;
};

// Every choice of terms, in a dam break that has walls, a free surface and a splash after these steps.
std::vector<Case> generated_cases() {
  std::vector<Case> cases;
  for (const int dimension : {2, 3}) {
    for (const KernelName kernel : {KernelName::cubic_spline, KernelName::wendland_c2}) {
      for (const ViscosityModel viscosity :
           {ViscosityModel::none, ViscosityModel::morris, ViscosityModel::monaghan, ViscosityModel::hinsch2024}) {
        for (const SurfaceTensionModel tension : {SurfaceTensionModel::none, SurfaceTensionModel::hinsch2024}) {
          for (const WallSlip slip : {WallSlip::no_slip, WallSlip::free_slip}) {
            Scene scene = small_dam_break(dimension, dimension == 2 ? 0.02 : 0.05);
            scene.solver.kernel = {kernel, kernel == KernelName::cubic_spline ? 1.0 : 1.3};
            scene.solver.wall_slip = slip;
            scene.fluid.viscosity = {viscosity, 0.01};
            scene.fluid.surface_tension = {tension, dimension == 2 ? 1e-4 : 1e-6};
            // A third of the cases each keeps tension, or has the linear equation of state, as others do not.
            if (cases.size() % 3 == 1) scene.solver.negative_pressure = NegativePressure::keep;
            if (cases.size() % 3 == 2) scene.solver.exponent = 1;
            cases.push_back({fmt::format("{}d {} {} tension {} {}", dimension, name_of(kernel), name_of(viscosity),
                                         name_of(tension), name_of(slip)),
                             std::move(scene), 120});
          }
        }
      }
    }
  }
  return cases;
}

// Both methods and both kinds of walls, and periodic axes.
std::vector<Case> cases_of_methods() {
  std::vector<Case> cases;
  for (const int dimension : {2, 3}) {
    for (const Method method : {Method::wcsph, Method::delta_sph}) {
      for (const WallPressure walls : {WallPressure::mirrored, WallPressure::extrapolated}) {
        for (const WallSlip slip : {WallSlip::no_slip, WallSlip::free_slip}) {
          if (method == Method::wcsph && walls == WallPressure::mirrored) continue;  // among the generated ones
          Scene scene = small_dam_break(dimension, dimension == 2 ? 0.02 : 0.05);
          scene.solver.method = method;
          scene.solver.wall_pressure = walls;
          scene.solver.wall_slip = slip;
          scene.solver.kernel = {KernelName::wendland_c2, 1.5};
          scene.fluid.viscosity = {ViscosityModel::monaghan, 0.01};
          scene.walls[0].layers = 0;
          cases.push_back({fmt::format("{}d {} {} {}", dimension, name_of(method), name_of(walls), name_of(slip)),
                           std::move(scene), 120});
        }
      }
    }
    Scene shocked = small_dam_break(dimension, dimension == 2 ? 0.02 : 0.05);
    shocked.fluid.viscosity = {ViscosityModel::artificial, 0.01};
    cases.push_back({fmt::format("{}d artificial", dimension), std::move(shocked), 120});
    Scene scene = free_fluid(dimension, dimension == 2 ? 40 : 18);
    scene.periodic = {Axis::x, Axis::y};
    scene.fluid.volumes[0].perturbation = 0.2;
    scene.fluid.volumes[0].velocity = Vec3(5, 3, 0);
    scene.solver.negative_pressure = NegativePressure::keep;
    cases.push_back({fmt::format("{}d periodic", dimension), std::move(scene), 120});
  }
  return cases;
}

std::vector<Case> shipped_cases() {
  std::vector<Case> cases;
  for (const auto& entry : std::filesystem::directory_iterator("scenes")) {
    if (entry.path().extension() != ".yaml") continue;
    cases.push_back({entry.path().stem().string(), read_scene(entry.path()), 60});
  }
  return cases;
}

std::string hash_after(const Case& each, InstructionSet set) {
  const auto simulation = make_simulation(each.scene, 2, set);
  while (simulation->steps() < each.steps && !simulation->finished()) simulation->step();
  return simulation->state_hash().substr(0, 16);
}

using Hashes = std::map<std::string, std::string>;  // by case and instruction set

Hashes read_golden() {
  Hashes hashes;
  std::ifstream file(golden_file);
  for (std::string line; std::getline(file, line);) {
    const std::size_t comma = line.rfind(',');
    hashes[line.substr(0, comma)] = line.substr(comma + 1);
  }
  return hashes;
}

void expect_golden(const std::vector<Case>& cases) {
  ASSERT_FALSE(cases.empty());
  const bool bless = std::getenv("WEIR_BLESS") != nullptr;
  Hashes golden = read_golden();
  for (const Case& each : cases) {
    for (const InstructionSet set : usable_instruction_sets()) {
      const std::string key = fmt::format("{},{}", each.name, name_of(set));
      const std::string hash = hash_after(each, set);
      if (bless) {
        golden[key] = hash;
      } else {
        EXPECT_EQ(hash, golden[key]) << key;
      }
    }
  }
  if (!bless) return;
  std::ofstream file(golden_file);
  for (const auto& [key, hash] : golden) file << key << ',' << hash << '\n';
}

TEST(StateHash, OfEveryChoiceOfTermsIsTheGoldenOne) { expect_golden(generated_cases()); }

TEST(StateHash, OfEveryMethodAndWallIsTheGoldenOne) { expect_golden(cases_of_methods()); }

TEST(StateHash, OfEveryShippedSceneIsTheGoldenOne) { expect_golden(shipped_cases()); }

}  // namespace
}  // namespace weir
