// How many threads to use.
#pragma once

namespace weir {

// `requested` if positive, else OMP_NUM_THREADS, else the processors this process may run on. Results never depend on
// it.
int thread_count(int requested);

}  // namespace weir
