// The outputs of a run. To add one: its Observer and its OutputKind in files of their own, and a line in outputs.cpp.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "run/observer.h"
#include "run/run_context.h"
#include "scene/scene.h"

namespace weir {

struct OutputKind {
  // Files of a finished run of the scene, by their paths in its folder; none if the scene asks for none.
  std::vector<std::filesystem::path> (*files)(const Scene& scene);
  // Files in the folder that a run of this name may have written, whatever else its scene said.
  std::vector<std::filesystem::path> (*left_in)(const std::filesystem::path& folder, const Scene& scene);
  // None if the scene asks for none. The context outlives it.
  std::unique_ptr<Observer> (*observe)(const RunContext& run);
};

std::span<const OutputKind> output_kinds();

// Observers for all outputs that the scene asks for, in the order in which they start and look; they finish in reverse.
Observers make_observers(const RunContext& run);

}  // namespace weir
