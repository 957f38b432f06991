// A movie whose writer is killed, ends without finish() or meets a full disk.
#include <gmock/gmock.h>
#include <sys/wait.h>

#include <cmath>
#include <tuple>

#include "core/error.h"
#include "helpers.h"
#include "output/decode.h"
#include "output/sink.h"

namespace weir::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

// Every frame is there, in order, at its time and the right picture; returns how many.
std::int64_t check_from_the_start(const std::filesystem::path& movie) {
  const MovieFacts facts = decode_movie(movie, [](std::int64_t index, const Image& image) {
    EXPECT_NEAR(*image.pixel(image.width / 2, image.height / 2), grey_of(index), 8) << "frame " << index;
  });
  EXPECT_EQ(facts.first_time, 0);
  EXPECT_LT(facts.max_time_error, 1e-12);
  return facts.frames;
}

using Interrupted = FolderTest;

class Killed : public FolderTest, public ::testing::WithParamInterface<std::tuple<int, const char*>> {};

TEST_P(Killed, LosesAtMostTheLastSecond) {
  const auto [fps, preset] = GetParam();
  const int count = 3 * fps + (2 * fps + 2) / 3;  // not at a border of fragments
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    Scene scene = movie_scene(64, 48, fps);
    scene.output.movie->preset = preset;
    const auto sink = make_movie_sink(folder, scene, provenance());
    for (int k = 0; k < count; ++k) sink->write(numbered(64, 48, k));
    if (::write(ends[1], "x", 1) == 1) pause();
    _exit(1);
  }
  close(ends[1]);
  char written = 0;
  EXPECT_EQ(read(ends[0], &written, 1), 1);
  close(ends[0]);
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);

  EXPECT_FALSE(std::filesystem::exists(folder / "wave.mp4"));
  const std::int64_t frames = check_from_the_start(folder / "wave.part.mp4");
  EXPECT_GE(frames, count - fps);
  EXPECT_LE(frames, count);
}

INSTANTIATE_TEST_SUITE_P(All, Killed,
                         ::testing::Combine(::testing::Values(1, 2, 5, 25, 60),
                                            ::testing::Values("ultrafast", "superfast", "medium", "veryslow")),
                         [](const auto& test) {
                           return std::string(std::get<1>(test.param)) + std::to_string(std::get<0>(test.param));
                         });

TEST_F(Interrupted, WithoutFinishTheWholePartFilePlays) {
  {
    const auto sink = make_movie_sink(folder, movie_scene(64, 48, 10), provenance());
    for (int k = 0; k < 37; ++k) sink->write(numbered(64, 48, k));
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "wave.mp4"));
  EXPECT_EQ(check_from_the_start(folder / "wave.part.mp4"), 37);
}

TEST_F(Interrupted, AFullDiskIsReportedAndEarlierPicturesPlay) {
  std::string text = "no error";
  int written = 0;
  {
    const auto sink = make_movie_sink(folder, movie_scene(64, 48, 10), provenance());
    {
      const FileSizeLimit limit(6000);
      text = error_text<OutputError>([&] {
        for (; written < 1000; ++written) sink->write(numbered(64, 48, written));
      });
    }
    // Even with room again nothing more is written: a fragment is missing.
    EXPECT_THROW(
        {
          for (int k = 0; k < 20; ++k) sink->write(numbered(64, 48, written));
        },
        OutputError);
  }
  EXPECT_THAT(text, AllOf(HasSubstr((folder / "wave.part.mp4").string()), HasSubstr("File too large")));
  ASSERT_GT(written, 10);
  const std::int64_t frames = check_from_the_start(folder / "wave.part.mp4");
  EXPECT_GE(frames, written - 10);
}

TEST_F(Interrupted, ADiskThatFillsAtTheEndKeepsThePartFile) {
  const auto sink = make_movie_sink(folder, movie_scene(64, 48, 10), provenance());
  for (int k = 0; k < 37; ++k) sink->write(numbered(64, 48, k));
  std::filesystem::create_directory(folder / "wave.mp4.tmp");  // blocks the remuxed file
  EXPECT_THAT(error_text<OutputError>([&] { sink->finish(); }), HasSubstr("wave.mp4"));
  EXPECT_FALSE(std::filesystem::exists(folder / "wave.mp4"));
  EXPECT_EQ(check_from_the_start(folder / "wave.part.mp4"), 37);
}

}  // namespace
}  // namespace weir::testing
