#include "run/text_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "core/error.h"

namespace weir {

namespace {

[[noreturn]] void throw_unwritable(const std::filesystem::path& file) {
  throw OutputError(fmt::format("cannot write {}: {}", file.string(), std::strerror(errno)));
}

}  // namespace

TextFile::TextFile(const std::filesystem::path& file) : path_(file), file_(std::fopen(file.c_str(), "we")) {
  if (!file_) throw_unwritable(path_);
}

void TextFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size() || std::fflush(file_.get()) != 0) {
    throw_unwritable(path_);
  }
}

void TextFile::close() {
  if (file_ && std::fclose(file_.release()) != 0) throw_unwritable(path_);
}

void write_text_file(const std::filesystem::path& file, std::string_view text) {
  const std::filesystem::path unfinished = file.string() + ".part";
  try {
    TextFile writer(unfinished);
    writer.write(text);
    writer.close();
    std::filesystem::rename(unfinished, file);
  } catch (const std::filesystem::filesystem_error& error) {
    throw OutputError(fmt::format("cannot write {}: {}", file.string(), error.code().message()));
  } catch (const OutputError&) {
    std::error_code ignored;  // the first error is the one to tell
    std::filesystem::remove(unfinished, ignored);
    throw;
  }
}

std::string read_text_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace weir
