// Movie, frames and stills as an output of a run.
#pragma once

#include <memory>

#include "run/outputs.h"
#include "run/picture_files.h"

namespace weir {

std::unique_ptr<Observer> observe_pictures(const RunContext& run);

inline constexpr OutputKind picture_output{&picture_files, &pictures_left_in, &observe_pictures};

}  // namespace weir
