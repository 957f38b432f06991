#include "core/threads.h"

#include <omp.h>

namespace weir {

int thread_count(int requested) {
  // The OpenMP runtime reads OMP_NUM_THREADS and the affinity mask itself.
  return requested > 0 ? requested : omp_get_max_threads();
}

}  // namespace weir
