// How a run ends: its first error decides the exit code, later ones add their messages.
#pragma once

#include <string>

#include "core/error.h"

namespace weir {

class Outcome {
 public:
  // Notes an exception of the work.
  template <class Work>
  void attempt(Work work) {
    try {
      work();
    } catch (...) {
      note_current_exception();
    }
  }
  void note(ExitCode exit, const std::string& message);

  ExitCode exit() const { return exit_; }
  const std::string& message() const { return message_; }
  void append(const std::string& text) { message_ += text; }

 private:
  void note_current_exception();

  ExitCode exit_ = ExitCode::done;
  std::string message_;
};

}  // namespace weir
