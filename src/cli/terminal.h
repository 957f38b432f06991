// Messages on standard error.
#pragma once

#include <string>

namespace weir {

bool stderr_is_terminal();
int terminal_width();  // columns of the terminal behind standard error; 80 if unknown

// "weir: text" on standard error.
void say(const std::string& text);
// "weir: error: text", the word in red on a terminal unless NO_COLOR is set.
void say_error(const std::string& text);
// Mistakes with their position: "file:line:column: error: text", one a line.
void say_mistakes(const std::string& lines);

}  // namespace weir
