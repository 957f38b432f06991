#include "cli/program.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

namespace weir {

namespace fs = std::filesystem;

namespace {

constexpr auto patience = std::chrono::seconds(60);  // a slow machine, a sanitizer
constexpr auto glance = std::chrono::milliseconds(2);

fs::path program_file() { return fs::read_symlink("/proc/self/exe").parent_path() / "weir"; }

fs::path temporary_file() {
  std::string pattern = (fs::temp_directory_path() / "weir-output-XXXXXX").string();
  const int file = mkstemp(pattern.data());
  if (file < 0) throw std::runtime_error("cannot make " + pattern);
  close(file);
  return pattern;
}

[[noreturn]] void become(const std::string& program, const std::vector<char*>& arguments,
                         const Surroundings& surroundings, const char* out, const char* err) {
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(open(out, O_WRONLY), STDOUT_FILENO);
  dup2(open(err, O_WRONLY), STDERR_FILENO);
  if (!surroundings.folder.empty() && chdir(surroundings.folder.c_str()) != 0) _exit(126);
  if (surroundings.largest_file) {
    const rlimit limit{*surroundings.largest_file, *surroundings.largest_file};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  for (const auto& [name, value] : surroundings.environment) setenv(name.c_str(), value.c_str(), 1);
  execv(program.c_str(), arguments.data());
  _exit(127);
}

}  // namespace

std::string file_text(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void put_file(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

Program::Program(std::vector<std::string> arguments, const Surroundings& surroundings)
    : out_file_(temporary_file()), err_file_(temporary_file()) {
  std::string program = program_file().string();
  std::vector<char*> words{program.data()};
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  pid_ = fork();
  if (pid_ == 0) become(program, words, surroundings, out_file_.c_str(), err_file_.c_str());
}

Program::~Program() {
  if (running()) {
    signal(SIGKILL);
    wait();
  }
  std::error_code failed;
  fs::remove(out_file_, failed);
  fs::remove(err_file_, failed);
}

void Program::signal(int number) const { kill(pid_, number); }

bool Program::running() {
  if (!ended_ && waitpid(pid_, &status_, WNOHANG) == pid_) ended_ = true;
  return !ended_;
}

Outcome Program::wait() {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  while (running()) {
    if (std::chrono::steady_clock::now() > deadline) {
      signal(SIGKILL);
      waitpid(pid_, &status_, 0);
      ended_ = true;
      throw std::runtime_error("weir did not end in time; it said: " + file_text(err_file_));
    }
    std::this_thread::sleep_for(glance);
  }
  Outcome outcome;
  if (WIFEXITED(status_)) outcome.exit = WEXITSTATUS(status_);
  if (WIFSIGNALED(status_)) outcome.signal = WTERMSIG(status_);
  outcome.out = file_text(out_file_);
  outcome.err = file_text(err_file_);
  return outcome;
}

bool Program::says(const std::string& text, int times) {
  const auto deadline = std::chrono::steady_clock::now() + patience;
  for (;;) {
    const bool alive = running();
    const std::string said = file_text(err_file_);
    int found = 0;
    for (std::size_t at = said.find(text); at != std::string::npos; at = said.find(text, at + 1)) ++found;
    if (found >= times) return true;
    if (!alive || std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(glance);
  }
}

Outcome weir_program(std::vector<std::string> arguments, const Surroundings& surroundings) {
  return Program(std::move(arguments), surroundings).wait();
}

}  // namespace weir
