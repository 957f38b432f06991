// The facts of a run for its manifest: those of program, solver and observers.
#pragma once

#include "output/manifest.h"
#include "run/observer.h"
#include "run/run_context.h"

namespace weir {

// Facts that are known when the run begins; without exit, for it has not ended.
Manifest opening_facts(const RunContext& run, const Observers& observers);
// All but exit and wall times of the whole run, after every observer has finished.
Manifest closing_facts(const RunContext& run, const Observers& observers);

}  // namespace weir
