// Text files, whole.
#pragma once

#include <filesystem>
#include <string_view>

namespace weir {

// The folder must exist. Throws OutputError naming the file.
void write_text(const std::filesystem::path& file, std::string_view text);

}  // namespace weir
