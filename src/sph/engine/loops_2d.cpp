// Built once per instruction set.
#include "sph/engine/wcsph_loops.h"

namespace weir::WEIR_INSTRUCTION_SET {

template Loops<2> loops<2>(const Terms& terms);

}  // namespace weir::WEIR_INSTRUCTION_SET
