// The real program, started and watched.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace weir {

struct Outcome {
  int exit = -1;    // -1 if a signal ended it
  int signal = 0;   // that ended it
  std::string out;  // standard output
  std::string err;  // standard error
};

struct Surroundings {
  std::filesystem::path folder{};                                  // to start in; empty: that of the test
  std::vector<std::pair<std::string, std::string>> environment{};  // on top of ours
  std::optional<std::size_t> largest_file{};                       // bytes, RLIMIT_FSIZE
};

// A running weir. Its output goes to files, so it never waits for a reader.
class Program {
 public:
  explicit Program(std::vector<std::string> arguments, const Surroundings& surroundings = {});
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  pid_t pid() const { return pid_; }
  void signal(int number) const;
  bool running();
  Outcome wait();
  // Whether the text appears on standard error, so many times, before it ends and while we wait.
  bool says(const std::string& text, int times = 1);

 private:
  std::filesystem::path out_file_;
  std::filesystem::path err_file_;
  pid_t pid_ = -1;
  int status_ = 0;
  bool ended_ = false;
};

Outcome weir_program(std::vector<std::string> arguments, const Surroundings& surroundings = {});

std::string file_text(const std::filesystem::path& file);
void put_file(const std::filesystem::path& file, const std::string& text);

}  // namespace weir
