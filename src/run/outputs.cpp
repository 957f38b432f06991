#include "run/outputs.h"

#include <array>

#include "run/log_output.h"
#include "run/particle_output.h"
#include "run/picture_output.h"

namespace weir {

std::span<const OutputKind> output_kinds() {
  static constexpr std::array kinds{
      picture_output,
      log_output,
      particle_output,
  };
  return kinds;
}

Observers make_observers(const RunContext& run) {
  Observers observers;
  for (const OutputKind& kind : output_kinds()) {
    if (std::unique_ptr<Observer> observer = kind.observe(run)) observers.push_back(std::move(observer));
  }
  return observers;
}

}  // namespace weir
