// The run, as its outputs see it.
#pragma once

#include <string>

#include "output/sink.h"
#include "run/run.h"
#include "sph/simulation.h"

namespace weir {

struct RunContext {
  const Scene& scene;
  const RunOptions& options;
  const Provenance& provenance;
  int threads;
  Simulation& simulation;

  void say(const std::string& text) const {
    if (options.message) options.message(text);
  }
};

}  // namespace weir
