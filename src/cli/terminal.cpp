#include "cli/terminal.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace weir {

namespace {

bool colours() {
  const char* refused = std::getenv("NO_COLOR");
  return stderr_is_terminal() && (refused == nullptr || *refused == '\0');
}

}  // namespace

bool stderr_is_terminal() { return isatty(STDERR_FILENO) == 1; }

int terminal_width() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

void say(const std::string& text) { fmt::print(stderr, "weir: {}\n", text); }

void say_error(const std::string& text) {
  fmt::print(stderr, "weir: {}: {}\n", colours() ? "\x1b[31merror\x1b[0m" : "error", text);
}

void say_mistakes(const std::string& lines) {
  std::string text = lines;
  if (colours()) {
    const std::string plain = ": error: ";
    const std::string red = ": \x1b[31merror\x1b[0m: ";
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t found = text.find(plain, at);
      if (found == std::string::npos) break;
      text.replace(found, plain.size(), red);
      const std::size_t line_end = text.find('\n', found);
      at = line_end == std::string::npos ? text.size() : line_end;
    }
  }
  fmt::print(stderr, "{}\n", text);
}

}  // namespace weir
