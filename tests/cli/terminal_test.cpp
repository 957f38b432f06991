// Output at a terminal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <sstream>

#include "cli/program.h"
#include "cli/scene_text.h"
#include "pipeline/temporary_folder.h"

namespace weir {

namespace fs = std::filesystem;

namespace {

using testing::HasSubstr;

// Everything that weir writes to a terminal of that many columns.
std::string on_terminal(std::vector<std::string> arguments, unsigned short columns, bool no_color) {
  const winsize size{.ws_row = 24, .ws_col = columns, .ws_xpixel = 0, .ws_ypixel = 0};
  std::string program = (fs::read_symlink("/proc/self/exe").parent_path() / "weir").string();
  std::vector<char*> words{program.data()};
  for (std::string& argument : arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, &size);
  if (child == 0) {
    no_color ? setenv("NO_COLOR", "1", 1) : unsetenv("NO_COLOR");
    execv(program.c_str(), words.data());
    _exit(127);
  }
  std::string text;
  std::array<char, 4096> buffer{};
  // Ends with an error of reading once the other side is closed.
  for (ssize_t count = 1; count > 0;) {
    count = read(terminal, buffer.data(), buffer.size());
    if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
  }
  close(terminal);
  waitpid(child, nullptr, 0);
  return text;
}

class Terminal : public testing::Test {
 protected:
  Terminal() { put_file(scene_, small_scene_text); }

  TemporaryFolder temporary_;
  fs::path scene_ = temporary_ / "small.yaml";
};

TEST_F(Terminal, ShowsABarThatFits) {
  for (const unsigned short columns : std::array<unsigned short, 3>{120, 60, 24}) {
    const std::string text = on_terminal(
        {"run", scene_.string(), "-o", (temporary_ / std::to_string(columns)).string(), "--set", "output.movie=false"},
        columns, true);
    std::istringstream pieces(text);
    int bars = 0;
    for (std::string piece; std::getline(pieces, piece, '\r');) {
      const std::size_t end = piece.find("\x1b[K");
      if (end == std::string::npos || end == 0) continue;
      ++bars;
      EXPECT_LT(end, columns) << piece;
    }
    EXPECT_GE(bars, 1) << text;
    // Where the facts alone fill the line there is no room for the bar itself.
    EXPECT_EQ(text.find("####]") != std::string::npos, columns > 24) << text;
  }
}

TEST_F(Terminal, ShowsErrorsInRedUnlessNoColorIsSet) {
  EXPECT_THAT(on_terminal({"fly"}, 80, false), HasSubstr("weir: \x1b[31merror\x1b[0m: "));
  EXPECT_THAT(on_terminal({"fly"}, 80, true), HasSubstr("weir: error: "));
  put_file(scene_, small_scene_text + "colour: red\n");
  EXPECT_THAT(on_terminal({"check", scene_.string()}, 80, false), HasSubstr(":12:1: \x1b[31merror\x1b[0m: "));
  EXPECT_THAT(on_terminal({"check", scene_.string()}, 80, true), HasSubstr(":12:1: error: "));
}

}  // namespace

}  // namespace weir
