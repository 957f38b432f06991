// PNG files, read back by another decoder and taken apart chunk by chunk.
#include <gmock/gmock.h>

#include <random>
#include <thread>
#include <vector>

#include "core/error.h"
#include "helpers.h"
#include "output/decode.h"
#include "output/sink.h"

namespace weir::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

Image noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Image image{.width = width, .height = height, .rgba = {}};
  for (int i = 0; i < 4 * width * height; ++i) image.rgba.push_back(static_cast<std::uint8_t>(random() >> 24));
  return image;
}

Image opaque(Image image) {
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
  return image;
}

struct Chunk {
  std::string type;
  std::string data;
};

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes.at(at + i));
  return value;
}

// The check sum as the PNG specification defines it, bit by bit.
std::uint32_t crc_of(const std::string& bytes) {
  std::uint32_t crc = 0xffffffff;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) crc = (crc & 1) != 0 ? crc >> 1 ^ 0xedb88320 : crc >> 1;
  }
  return ~crc;
}

std::vector<Chunk> chunks_of(const std::filesystem::path& file) {
  const std::string bytes = content_of(file);
  EXPECT_EQ(bytes.substr(0, 8), "\x89PNG\r\n\x1a\n");
  std::vector<Chunk> chunks;
  for (std::size_t at = 8; at < bytes.size();) {
    const std::size_t length = big_endian(bytes, at);
    const std::string typed = bytes.substr(at + 4, 4 + length);
    EXPECT_EQ(big_endian(bytes, at + 8 + length), crc_of(typed)) << typed.substr(0, 4);
    chunks.push_back({.type = typed.substr(0, 4), .data = typed.substr(4)});
    at += 12 + length;
  }
  return chunks;
}

class Png : public FolderTest {
 protected:
  std::filesystem::path file() const { return folder / "a.png"; }
};

TEST_F(Png, ComesBackBitForBit) {
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(7, 3), std::pair(320, 180)}) {
    const Image image = noise(width, height, 1);
    write_png(file(), image, true, provenance(), 0);
    const Image with_alpha = read_png(file());
    EXPECT_EQ(with_alpha.width, width);
    EXPECT_EQ(with_alpha.height, height);
    EXPECT_TRUE(with_alpha.rgba == image.rgba);

    write_png(file(), image, false, provenance(), 0);
    EXPECT_TRUE(read_png(file()).rgba == opaque(image).rgba);
  }
}

TEST_F(Png, HoldsItsProvenance) {
  write_png(file(), noise(16, 9, 1), false, provenance(), 0.1 + 0.2);
  const std::vector<Chunk> chunks = chunks_of(file());
  std::vector<std::string> types;
  std::vector<std::string> texts;
  for (const Chunk& chunk : chunks) {
    types.push_back(chunk.type);
    if (chunk.type == "tEXt") texts.push_back(chunk.data);
  }
  EXPECT_THAT(types, ElementsAre("IHDR", "tEXt", "tEXt", "tEXt", "IDAT", "IEND"));
  const auto entry = [](std::string keyword, const std::string& text) { return (keyword += '\0') += text; };
  EXPECT_THAT(texts, ElementsAre(entry("Software", "weir 1.2.3"), entry("Scene-SHA-256", std::string(64, 'a')),
                                 entry("Time", "0.30000000000000004 s")));
  // Width, height, 8 bits, colour type 2 (RGB), nothing unusual.
  EXPECT_EQ(chunks[0].data, std::string("\0\0\0\x10\0\0\0\x09\x08\x02\0\0\0", 13));
}

TEST_F(Png, HasAnAlphaChannelOnlyWhenAsked) {
  write_png(file(), noise(16, 9, 1), true, provenance(), 0);
  EXPECT_EQ(chunks_of(file())[0].data[9], 6);  // RGBA
  write_png(file(), noise(16, 9, 1), false, provenance(), 0);
  EXPECT_EQ(chunks_of(file())[0].data[9], 2);  // RGB
}

TEST_F(Png, IsTheSameBytesForTheSamePicture) {
  write_png(file(), noise(64, 48, 1), false, provenance(), 1);
  const std::string first = content_of(file());
  write_png(file(), noise(64, 48, 1), false, provenance(), 1);
  EXPECT_TRUE(content_of(file()) == first);
}

TEST_F(Png, CanBeWrittenByManyThreads) {
  {
    std::vector<std::jthread> threads;
    for (unsigned k = 0; k < 4; ++k) {
      threads.emplace_back([this, k] {
        for (unsigned i = 0; i < 5; ++i) {
          write_png(folder / (std::to_string(5 * k + i) + ".png"), noise(64, 48, 5 * k + i), true, provenance(), 0);
        }
      });
    }
  }
  for (unsigned i = 0; i < 20; ++i) {
    EXPECT_TRUE(read_png(folder / (std::to_string(i) + ".png")).rgba == noise(64, 48, i).rgba);
  }
}

TEST_F(Png, ThatCannotBeWrittenIsNamedAndLeavesNothing) {
  const Image image = noise(64, 48, 1);
  EXPECT_EQ(error_text<OutputError>([&] { write_png(folder / "no" / "a.png", image, true, provenance(), 0); }),
            "cannot write " + (folder / "no" / "a.png").string() + ": No such file or directory");
  {
    const FileSizeLimit limit(1000);
    EXPECT_THAT(error_text<OutputError>([&] { write_png(file(), image, true, provenance(), 0); }),
                AllOf(HasSubstr(file().string()), HasSubstr("File too large")));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST_F(Png, ThatCannotBeReadIsNamed) {
  EXPECT_THAT(error_text<OutputError>([&] { read_png(file()); }), HasSubstr("a.png: No such file"));
  std::ofstream(file()) << "not a picture";
  EXPECT_THAT(error_text<OutputError>([&] { read_png(file()); }), AllOf(HasSubstr("a.png"), Not(HasSubstr("null"))));
  write_png(file(), noise(64, 48, 1), true, provenance(), 0);
  std::filesystem::resize_file(file(), 2000);
  EXPECT_THAT(error_text<OutputError>([&] { read_png(file()); }), HasSubstr("a.png"));
}

}  // namespace
}  // namespace weir::testing
