#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "core/error.h"
#include "output/decode.h"
#include "output/file.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb/stb_image.h>

namespace weir {

Image read_png(const std::filesystem::path& file) {
  const std::string png = read_file(file);
  Image image;
  int channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(png.data()), static_cast<int>(png.size()), &image.width,
                            &image.height, &channels, 4),
      stbi_image_free);
  if (!pixels) throw OutputError(fmt::format("cannot read {}: {}", file.string(), stbi_failure_reason()));
  image.rgba.assign(pixels.get(), pixels.get() + 4 * static_cast<std::size_t>(image.width) * image.height);
  return image;
}

}  // namespace weir
