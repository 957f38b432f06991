// Parts that most runs do without (OpenGL, libav, plots) are shared objects beside the program, loaded at first use, so
// that a run without pictures neither maps nor initialises them.
#pragma once

#include <string>

namespace weir {

// The address of `symbol` in module `name` ("weir_render"); the module stays loaded. Modules are looked for beside the
// running program and in ../lib/weir from it. Throws std::runtime_error naming what was tried.
void* module_symbol(const std::string& name, const char* symbol);

template <class Function>
Function* module_function(const std::string& name, const char* symbol) {
  return reinterpret_cast<Function*>(module_symbol(name, symbol));
}

}  // namespace weir
