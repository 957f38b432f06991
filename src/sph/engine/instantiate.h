// Instantiates the loops of instances.def for WEIR_DIMENSION. Included once per source, no header otherwise.
#include "sph/engine/loops.h"
#include "sph/passes/continuity.h"
#include "sph/passes/density.h"
#include "sph/passes/momentum.h"
#include "sph/passes/motion.h"
#include "sph/passes/vorticity.h"
#include "sph/passes/wall_state.h"

namespace weir::WEIR_INSTRUCTION_SET {

constexpr int Dim = WEIR_DIMENSION;

#define WEIR_WITHIN(...) template struct Pairs<Within<__VA_ARGS__>>;
#define WEIR_BETWEEN(...) template struct Pairs<Between<__VA_ARGS__>>;
#define WEIR_EACH(...) template struct Each<__VA_ARGS__>;
#include "sph/engine/instances.def"

template Listers<Dim> listers<Dim>();

}  // namespace weir::WEIR_INSTRUCTION_SET
