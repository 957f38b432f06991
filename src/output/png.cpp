// PNG: pixels by stb_image_write, its compressor replaced by libdeflate, text chunks put in after the header.
#include <fmt/format.h>
#include <libdeflate.h>

#include <array>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "core/error.h"
#include "output/file.h"
#include "output/sink.h"

namespace {

// Where stb_image_write hands its rows for a zlib stream. The result is freed with std::free; null: out of memory.
unsigned char* compress(unsigned char* data, int length, int* compressed_length, int level) {
  struct Free {
    void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
  };
  // One per thread, kept: frames are written by several threads and each holds some 100 KB.
  static thread_local std::unique_ptr<libdeflate_compressor, Free> compressor(libdeflate_alloc_compressor(level));
  if (!compressor) return nullptr;
  const std::size_t bytes = static_cast<std::size_t>(length);
  const std::size_t bound = libdeflate_zlib_compress_bound(compressor.get(), bytes);
  auto* compressed = static_cast<unsigned char*>(std::malloc(bound));
  if (compressed == nullptr) return nullptr;
  *compressed_length = static_cast<int>(libdeflate_zlib_compress(compressor.get(), data, bytes, compressed, bound));
  return compressed;
}

}  // namespace

#define STBIW_ZLIB_COMPRESS compress
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace weir {

namespace {

constexpr int compression_level = 1;
constexpr int no_filter = 0;
constexpr std::size_t header_end = 8 + 4 + 4 + 13 + 4;  // signature, then length, type, data and check sum of IHDR

bool use_measured_settings() {
  stbi_write_png_compression_level = compression_level;
  stbi_write_force_png_filter = no_filter;
  return true;
}

void append_big_endian(std::string& bytes, std::uint32_t value) {
  for (const int shift : {24, 16, 8, 0}) bytes.push_back(static_cast<char>(value >> shift & 0xff));
}

std::string text_chunk(std::string_view keyword, std::string_view text) {
  std::string typed = "tEXt";
  typed.append(keyword).push_back('\0');
  typed.append(text);
  std::string chunk;
  append_big_endian(chunk, static_cast<std::uint32_t>(typed.size() - 4));
  chunk += typed;
  append_big_endian(chunk, libdeflate_crc32(0, typed.data(), typed.size()));
  return chunk;
}

std::vector<std::uint8_t> without_alpha(const Image& image) {
  const std::size_t pixels = image.rgba.size() / 4;
  std::vector<std::uint8_t> rgb(3 * pixels);
  for (std::size_t i = 0; i < pixels; ++i) std::memcpy(&rgb[3 * i], &image.rgba[4 * i], 3);
  return rgb;
}

}  // namespace

void write_png(const std::filesystem::path& file, const Image& image, bool alpha, const Provenance& provenance,
               double time) {
  [[maybe_unused]] static const bool set_once = use_measured_settings();  // globals, and frames come from many threads
  const int channels = alpha ? 4 : 3;
  const std::vector<std::uint8_t> rgb = alpha ? std::vector<std::uint8_t>{} : without_alpha(image);
  const std::uint8_t* pixels = alpha ? image.rgba.data() : rgb.data();
  std::string png;
  const auto collect = [](void* context, void* data, int size) {
    static_cast<std::string*>(context)->assign(static_cast<const char*>(data), static_cast<std::size_t>(size));
  };
  if (stbi_write_png_to_func(collect, &png, image.width, image.height, channels, pixels, image.width * channels) == 0) {
    throw OutputError(fmt::format("cannot write {}: no memory for a PNG of {} x {} pixels", file.string(), image.width,
                                  image.height));
  }
  std::string texts = text_chunk("Software", fmt::format("weir {}", provenance.version));
  if (!provenance.scene_sha256.empty()) texts += text_chunk("Scene-SHA-256", provenance.scene_sha256);
  texts += text_chunk("Time", fmt::format("{} s", time));
  png.insert(header_end, texts);
  write_file(file, png);
}

}  // namespace weir
