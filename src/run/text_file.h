// Text files that say why they could not be written.
#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace weir {

// Opened for writing, flushed after every write so that a reader, or a kill, always finds whole lines.
class TextFile {
 public:
  explicit TextFile(const std::filesystem::path& file);  // throws OutputError, as do the others
  void write(std::string_view text);
  void close();

 private:
  struct Closer {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::filesystem::path path_;
  std::unique_ptr<std::FILE, Closer> file_;
};

// The whole file or none of it: written beside its place and renamed. Throws OutputError.
void write_text_file(const std::filesystem::path& file, std::string_view text);

// Nothing if there is no such file, or if it cannot be read.
std::string read_text_file(const std::filesystem::path& file);

}  // namespace weir
