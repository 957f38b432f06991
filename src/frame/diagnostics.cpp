#include "frame/diagnostics.h"

namespace weir {

std::string_view name_of(StepLimit limit) {
  switch (limit) {
    case StepLimit::none:
      return "none";
    case StepLimit::fixed:
      return "fixed";
    case StepLimit::velocity:
      return "velocity";
    case StepLimit::acoustic:
      return "acoustic";
    case StepLimit::force:
      return "force";
    case StepLimit::viscosity:
      return "viscosity";
    case StepLimit::maximum:
      return "maximum";
  }
  return "none";
}

}  // namespace weir
