// SIGINT and SIGTERM ask for an orderly end.
#pragma once

#include <atomic>

namespace weir {

// From now on the first SIGINT or SIGTERM sets the flag that this returns; a second one ends the process at once.
// Writing to a closed pipe or beyond a file size limit becomes an error of the write instead of a signal.
const std::atomic<bool>& catch_stop_signals();

}  // namespace weir
