// Built once per instruction set.
#define WEIR_DIMENSION 3
#include "sph/engine/instantiate.h"
