#include "core/write_text.h"

#include <fmt/format.h>

#include <fstream>

#include "core/error.h"

namespace weir {

void write_text(const std::filesystem::path& file, std::string_view text) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw OutputError(fmt::format("cannot write {}", file.string()));
}

}  // namespace weir
