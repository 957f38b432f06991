#include "core/module.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace weir {

void* module_symbol(const std::string& name, const char* symbol) {
  namespace fs = std::filesystem;
  const fs::path here = fs::read_symlink("/proc/self/exe").parent_path();
  std::string tried;
  for (const fs::path& folder : {here, here.parent_path() / "lib" / "weir"}) {
    const fs::path file = folder / (name + ".so");
    std::error_code missing;
    if (!fs::exists(file, missing)) {
      tried += fmt::format("\n  {}: not there", file.string());
      continue;
    }
    void* module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (module == nullptr) {
      tried += fmt::format("\n  {}", dlerror());
      continue;
    }
    if (void* address = dlsym(module, symbol)) return address;
    tried += fmt::format("\n  {}: no symbol {}", file.string(), symbol);
  }
  throw std::runtime_error(fmt::format("cannot load module {}:{}", name, tried));
}

}  // namespace weir
