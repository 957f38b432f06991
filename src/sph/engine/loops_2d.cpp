// Built once per instruction set.
#define WEIR_DIMENSION 2
#include "sph/engine/instantiate.h"
