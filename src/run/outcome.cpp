#include "run/outcome.h"

#include <exception>

namespace weir {

void Outcome::note(ExitCode exit, const std::string& message) {
  if (exit_ == ExitCode::done) {
    exit_ = exit;
    message_ = message;
  } else if (message_.find(message) == std::string::npos) {  // the same disk is full for every file
    message_ += "\n" + message;
  }
}

void Outcome::note_current_exception() {
  try {
    throw;
  } catch (const SimulationError& error) {
    note(ExitCode::diverged, error.what());
  } catch (const OutputError& error) {
    note(ExitCode::output, error.what());
  } catch (const DeviceError& error) {
    note(ExitCode::no_device, error.what());
  } catch (const std::exception& error) {
    note(ExitCode::internal, error.what());
  }
}

}  // namespace weir
