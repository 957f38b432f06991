// A process of our own program.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace weir {

class Child {
 public:
  // Starts this program with other arguments. It is in a process group of its own, so that a Ctrl-C reaches it
  // once, from us; if we die, it is asked to stop. Throws std::runtime_error.
  explicit Child(const std::vector<std::string>& arguments);
  ~Child();
  Child(Child&& other) noexcept;
  Child& operator=(Child&&) = delete;
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  int output() const { return output_; }  // descriptor from which its standard error is read
  // Complete lines that it has said since the last call; also the incomplete last one when it has ended.
  std::vector<std::string> read_lines();
  bool ended() const { return ended_; }  // it has closed its output
  void stop(int signal) const;
  // Waits for the end: its exit code, or 128 + signal.
  int wait();

 private:
  pid_t pid_ = -1;
  int output_ = -1;
  bool ended_ = false;
  std::string unfinished_;
};

}  // namespace weir
