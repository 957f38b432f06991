// Movies, decoded again.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.h"
#include "helpers.h"
#include "output/decode.h"
#include "output/sink.h"

namespace weir::testing {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class Movie : public FolderTest {
 protected:
  std::filesystem::path write(const Scene& scene, const std::vector<MovieImage>& pictures) const {
    const auto sink = make_movie_sink(folder, scene, provenance());
    for (const MovieImage& picture : pictures) sink->write(picture);
    sink->finish();
    return folder / (scene.name + ".mp4");
  }
  std::filesystem::path write_numbered(const Scene& scene, int count) const {
    std::vector<MovieImage> pictures;
    for (int k = 0; k < count; ++k) {
      pictures.push_back(numbered(scene.render.size[0], scene.render.size[1], k));
    }
    return write(scene, pictures);
  }
};

// Boxes of the outermost level, from the file's bytes.
std::vector<std::string> boxes_of(const std::filesystem::path& movie) {
  const std::string bytes = content_of(movie);
  std::vector<std::string> types;
  for (std::size_t at = 0; at + 8 <= bytes.size();) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = length << 8 | static_cast<unsigned char>(bytes[at + i]);
    types.push_back(bytes.substr(at + 4, 4));
    if (length < 8) break;
    at += length;
  }
  return types;
}

class Preset : public Movie, public ::testing::WithParamInterface<const char*> {};

TEST_P(Preset, GivesHigh709FromTimeZero) {
  Scene scene = movie_scene(320, 180, 25);
  scene.output.movie->preset = GetParam();
  const std::filesystem::path movie = write_numbered(scene, 60);

  std::vector<int> found;
  const MovieFacts facts = decode_movie(movie, [&](std::int64_t index, const Image& image) {
    EXPECT_EQ(index, static_cast<std::int64_t>(found.size()));
    found.push_back(*image.pixel(160, 90));
  });
  EXPECT_EQ(facts.width, 320);
  EXPECT_EQ(facts.height, 180);
  EXPECT_EQ(facts.codec, "h264");
  EXPECT_EQ(facts.profile, "High");
  EXPECT_EQ(facts.pixel_format, "yuv420p");
  EXPECT_EQ(facts.color_space, "bt709");
  EXPECT_EQ(facts.color_primaries, "bt709");
  EXPECT_EQ(facts.color_transfer, "bt709");
  EXPECT_EQ(facts.color_range, "tv");
  EXPECT_EQ(facts.frame_rate, 25);
  EXPECT_EQ(facts.frames, 60);
  EXPECT_EQ(facts.first_time, 0);
  EXPECT_EQ(facts.last_time, 59 / 25.0);
  EXPECT_LT(facts.max_time_error, 1e-12);  // the container counts in whole fractions of 1/25 s
  EXPECT_TRUE(facts.faststart);
  ASSERT_EQ(found.size(), 60U);
  for (int k = 0; k < 60; ++k) EXPECT_NEAR(found[static_cast<std::size_t>(k)], grey_of(k), 8) << "frame " << k;
}

INSTANTIATE_TEST_SUITE_P(All, Preset, ::testing::Values("ultrafast", "superfast", "veryfast", "medium", "slow"),
                         [](const auto& test) { return std::string(test.param); });

TEST_F(Movie, EveryQualityIsHigh) {  // x264 calls lossless, quality 0, by another profile's name
  for (const int quality : {0, 1, 20, 51}) {
    Scene scene = movie_scene(64, 48, 10);
    scene.output.movie->quality = quality;
    EXPECT_EQ(decode_movie(write_numbered(scene, 12), {}).profile, "High") << "quality " << quality;
  }
}

TEST_F(Movie, HasItsIndexInFrontAndItsColoursInTheContainer) {
  const std::filesystem::path movie = write_numbered(movie_scene(64, 48, 10), 25);
  // Between them the unused rest of the room for the index.
  EXPECT_THAT(boxes_of(movie), ElementsAre("ftyp", "moov", "free", "free", "mdat"));
  // ISO/IEC 14496-12, 12.1.5: primaries 1, transfer 1, matrix 1 (all BT.709), full-range flag clear.
  const std::string bytes = content_of(movie);
  const std::string colr("colrnclx\0\1\0\1\0\1\0", 15);
  EXPECT_NE(bytes.find(colr), std::string::npos);
}

// The most that a picture may take of it, for each is a key frame; and texts longer than all else.
TEST_F(Movie, HasRoomForTheLongestIndex) {
  Scene scene = movie_scene(32, 32, 1);
  scene.title = std::string(20000, 'x');
  const std::filesystem::path movie = write_numbered(scene, 400);
  EXPECT_EQ(decode_movie(movie, {}).frames, 400);
  EXPECT_TRUE(decode_movie(movie, {}).faststart);
}

TEST_F(Movie, HasAKeyFrameEverySecond) {
  const std::string bytes = content_of(write_numbered(movie_scene(64, 48, 10), 35));
  const std::size_t stss = bytes.find("stss");
  ASSERT_NE(stss, std::string::npos);
  const auto number_at = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
  };
  ASSERT_EQ(number_at(stss + 8), 4);  // after the type, version and flags
  std::vector<int> samples;           // counted from 1
  for (std::size_t i = 0; i < 4; ++i) samples.push_back(number_at(stss + 12 + 4 * i));
  EXPECT_THAT(samples, ElementsAre(1, 11, 21, 31));
}

// Colours go through 8-bit BT.709 with Y in 16..235 and chroma in 16..240. Half a step of rounding in Y is
// 0.5 * 255/219 = 0.58 of R, G and B; in Cr and Cb it is at most 0.5 * 2.112 = 1.06 (of B). With the last rounding,
// 0.5, no channel is off by more than floor(0.58 + 1.06 + 0.5) = 2. By BT.601's matrix, red would be off by 20.
TEST_F(Movie, GivesColoursBackWithinTheRoundingOfLimitedRange) {
  const std::vector<std::array<int, 4>> colors = {{255, 0, 0, 255},     {0, 255, 0, 255},   {0, 0, 255, 255},
                                                  {255, 255, 0, 255},   {0, 255, 255, 255}, {255, 0, 255, 255},
                                                  {0, 0, 0, 255},       {1, 1, 1, 255},     {255, 255, 255, 255},
                                                  {254, 254, 254, 255}, {68, 1, 84, 255},   {253, 231, 37, 255}};
  Scene scene = movie_scene(64, 48, 1);
  scene.output.movie->quality = 0;  // a flat picture survives this encoder unchanged
  std::vector<MovieImage> pictures;
  for (const auto& color : colors) pictures.push_back(movie_image(flat(64, 48, color)));
  decode_movie(write(scene, pictures), [&](std::int64_t index, const Image& image) {
    const auto& wanted = colors[static_cast<std::size_t>(index)];
    for (const auto& [x, y] : {std::pair(0, 0), std::pair(63, 0), std::pair(31, 24), std::pair(63, 47)}) {
      for (std::size_t channel = 0; channel < 4; ++channel) {
        EXPECT_NEAR(image.pixel(x, y)[channel], wanted[channel], 2) << "colour " << index << " channel " << channel;
      }
    }
  });
}

// The variance of rounding is 1/12 of a step squared: Y (255/219)^2, chroma (255/224 * {1.575, 0.655, 1.856})^2 for R,
// G, B, and 1 for the output. The mean over the channels is 0.38: 52.3 dB. An encoder at quality 1 may add as much
// again, 3 dB.
TEST_F(Movie, KeepsASmoothGradient) {
  Scene scene = movie_scene(320, 180, 5);
  scene.output.movie->quality = 1;
  Image gradient = flat(320, 180, {0, 0, 0, 255});
  for (int y = 0; y < 180; ++y) {
    for (int x = 0; x < 320; ++x) {
      gradient.pixel(x, y)[0] = static_cast<std::uint8_t>(64 + x / 3);
      gradient.pixel(x, y)[1] = static_cast<std::uint8_t>(64 + y / 2);
      gradient.pixel(x, y)[2] = static_cast<std::uint8_t>(192 - (x + y) / 4);
    }
  }
  double squares = 0;
  decode_movie(write(scene, {movie_image(gradient)}), [&](std::int64_t, const Image& image) {
    for (std::size_t i = 0; i < image.rgba.size(); ++i) squares += std::pow(image.rgba[i] - gradient.rgba[i], 2);
  });
  EXPECT_GT(10 * std::log10(255.0 * 255.0 * 3 * 320 * 180 / squares), 49.3);
}

TEST_F(Movie, OfOneFrameIsAMovie) {
  const MovieFacts facts = decode_movie(write_numbered(movie_scene(64, 48, 60), 1), {});
  EXPECT_EQ(facts.frames, 1);
  EXPECT_EQ(facts.first_time, 0);
  EXPECT_EQ(facts.frame_rate, 60);
  EXPECT_TRUE(facts.faststart);
}

TEST_F(Movie, OfNoFramesLeavesNoFile) {
  write(movie_scene(64, 48, 60), {});
  EXPECT_TRUE(std::filesystem::is_empty(folder));
  make_movie_sink(folder, movie_scene(64, 48, 60), provenance());
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST_F(Movie, ReplacesThePartFileWhenFinished) {
  const auto sink = make_movie_sink(folder, movie_scene(64, 48, 10), provenance());
  EXPECT_TRUE(std::filesystem::exists(folder / "wave.part.mp4"));
  sink->write(numbered(64, 48, 0));
  EXPECT_FALSE(std::filesystem::exists(folder / "wave.mp4"));
  sink->finish();
  EXPECT_TRUE(std::filesystem::exists(folder / "wave.mp4"));
  EXPECT_FALSE(std::filesystem::exists(folder / "wave.part.mp4"));
  EXPECT_FALSE(std::filesystem::exists(folder / "wave.mp4.tmp"));
}

TEST_F(Movie, IsTheSameBytesForTheSamePictures) {
  const std::string first = content_of(write_numbered(movie_scene(320, 180, 10), 25));
  const std::string second = content_of(write_numbered(movie_scene(320, 180, 10), 25));
  EXPECT_TRUE(first == second);
}

TEST_F(Movie, NamesItsSceneButNeitherTheTimeOfDayNorTheMuxer) {
  const std::string bytes = content_of(write_numbered(movie_scene(64, 48, 10), 2));
  EXPECT_THAT(bytes, HasSubstr("weir 1.2.3, scene SHA-256 " + std::string(64, 'a')));
  EXPECT_THAT(bytes, HasSubstr("A wave"));
  EXPECT_EQ(bytes.find("Lavf"), std::string::npos);
  const std::size_t mvhd = bytes.find("mvhd");
  ASSERT_NE(mvhd, std::string::npos);
  EXPECT_EQ(bytes.substr(mvhd + 8, 8), std::string(8, '\0'));  // creation and modification time
}

TEST_F(Movie, CanBeNamedLikeAProtocol) {
  Scene scene = movie_scene(64, 48, 10);
  scene.name = "http: a % b";
  EXPECT_EQ(decode_movie(write_numbered(scene, 3), {}).frames, 3);
}

TEST_F(Movie, RefusesAPictureOfAnotherSize) {
  const auto sink = make_movie_sink(folder, movie_scene(64, 48, 10), provenance());
  EXPECT_THAT(error_text<OutputError>([&] { sink->write(numbered(62, 48, 0)); }),
              AllOf(HasSubstr("62 x 48"), HasSubstr("64 x 48"), HasSubstr("wave.mp4")));
}

TEST_F(Movie, NamesAFolderThatIsNotThere) {
  const std::string text =
      error_text<OutputError>([&] { make_movie_sink(folder / "nowhere", movie_scene(64, 48, 10), provenance()); });
  EXPECT_EQ(text, "cannot write " + (folder / "nowhere" / "wave.part.mp4").string() + ": No such file or directory");
}

TEST_F(Movie, IsEncodedByLibx264WhenItIsThere) {
  const std::vector<std::string> encoders = list_encoders();
  ASSERT_FALSE(encoders.empty());
  EXPECT_EQ(make_movie_sink(folder, movie_scene(64, 48, 10), provenance())->encoder(), encoders.front());
  EXPECT_THAT(encoders, ::testing::Contains("libx264"));
}

TEST_F(Movie, CanBeEncodedByMpeg4) {
  Scene scene = movie_scene(64, 48, 10);
  scene.output.movie->encoder = "mpeg4";
  const MovieFacts facts = decode_movie(write_numbered(scene, 25), {});
  EXPECT_EQ(facts.codec, "mpeg4");
  EXPECT_EQ(facts.frames, 25);
  EXPECT_EQ(facts.first_time, 0);
  EXPECT_LT(facts.max_time_error, 1e-12);
  EXPECT_EQ(facts.color_space, "bt709");
  EXPECT_EQ(facts.color_range, "tv");
}

TEST_F(Movie, RefusesAnUnknownEncoderAndNamesThoseThereAre) {
  Scene scene = movie_scene(64, 48, 10);
  scene.output.movie->encoder = "librainbow";
  const std::string text = error_text<OutputError>([&] { make_movie_sink(folder, scene, provenance()); });
  EXPECT_THAT(text, StartsWith("output.movie.encoder: there is no librainbow here; usable: auto, libx264"));
  EXPECT_THAT(text, EndsWith("mpeg4"));
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST_F(Movie, RefusesAnUnknownPreset) {
  for (const char* encoder : {"libx264", "mpeg4"}) {
    Scene scene = movie_scene(64, 48, 10);
    scene.output.movie->encoder = encoder;
    scene.output.movie->preset = "warp";
    EXPECT_THAT(error_text<OutputError>([&] { make_movie_sink(folder, scene, provenance()); }),
                AllOf(HasSubstr("warp"), HasSubstr(encoder)));
    EXPECT_TRUE(std::filesystem::is_empty(folder));
  }
}

TEST_F(Movie, ThatCannotBeReadIsNamed) {
  EXPECT_THAT(error_text<OutputError>([&] { decode_movie(folder / "none.mp4", {}); }),
              AllOf(HasSubstr("none.mp4"), HasSubstr("No such file")));
  std::ofstream(folder / "text.mp4") << "not a movie";
  EXPECT_THAT(error_text<OutputError>([&] { decode_movie(folder / "text.mp4", {}); }), HasSubstr("text.mp4"));
}

}  // namespace
}  // namespace weir::testing
