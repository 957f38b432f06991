// Modules: shared objects beside the program (OpenGL, libav, plots), loaded at first use, so that a run without
// pictures neither maps nor initialises these libraries.
#pragma once

#include <string>

namespace weir {

// The address of `symbol` in module `name` ("weir_render"); the module stays loaded. Search path: the
// folder of the running program, then ../lib/weir from it. Throws std::runtime_error naming every file tried.
void* module_symbol(const std::string& name, const char* symbol);

template <class Function>
Function* module_function(const std::string& name, const char* symbol) {
  return reinterpret_cast<Function*>(module_symbol(name, symbol));
}

}  // namespace weir
