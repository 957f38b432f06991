// Balls that are left out, against a picture for which none are: pixel by pixel, with what gather.frag makes of a list.
#include "render/visible_balls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <random>
#include <set>
#include <tuple>

namespace weir {
namespace {

constexpr int width = 200;
constexpr int height = 120;

using Key = std::tuple<float, float, float, std::uint32_t>;
Key key_of(const ScreenBall& ball) { return {ball.depth, ball.x, ball.y, ball.color}; }

struct View {
  double radius = 0;  // m
  double focal = 0;
  int shift = 0;  // of the bins
};

struct Lists {
  std::vector<ScreenBall> entries;
  std::vector<Bins::Range> ranges;
  int columns = 0;
  std::span<const ScreenBall> at(const View& view, int x, int y) const {
    const int column = std::min(x / (block_width << view.shift), columns - 1);
    const Bins::Range& range = ranges[y / (block_height << view.shift) * columns + column];
    return std::span(entries).subspan(range.first, range.past - range.first);
  }
};

Lists lists_of(const std::vector<ScreenBall>& balls, const View& view) {
  VisibleBalls visible(width, height);
  Bins bins(width, height);
  bins.reset(view.shift);
  visible.begin(view.radius, view.focal, balls.size(), bins);
  for (const ScreenBall& ball : balls)
    visible.add({Lanes{ball.x}, Lanes{ball.y}, Lanes{std::bit_cast<float>(ball.color)}, Lanes{ball.depth}}, Whole{-1});
  visible.count(bins);
  std::vector<std::uint8_t> stale;
  Lists lists;
  lists.entries.resize(bins.close(stale));
  lists.ranges.assign(bins.ranges().begin(), bins.ranges().end());
  lists.columns = bins.columns();
  visible.scatter(bins, lists.entries.data());
  return lists;
}

// The same with none left out.
Lists all_of(const std::vector<ScreenBall>& balls, const View& view) {
  struct Disc {
    float x;
    float y;
    float reach;
    ScreenBall ball;
  };
  std::vector<Disc> discs;
  for (const ScreenBall& ball : balls)
    discs.push_back({ball.x, ball.y, std::max(static_cast<float>(view.radius * view.focal) / ball.depth, 1.0f), ball});
  Bins bins(width, height);
  bins.reset(view.shift);
  bins.count(std::span<const Disc>(discs));
  std::vector<std::uint8_t> stale;
  Lists lists;
  lists.entries.resize(bins.close(stale));
  lists.ranges.assign(bins.ranges().begin(), bins.ranges().end());
  lists.columns = bins.columns();
  bins.scatter(std::span<const Disc>(discs), lists.entries.data(), [](const Disc& disc) { return disc.ball; });
  return lists;
}

// What a pixel shows: how much of it is covered, in 1/1024, and of the nearest two which they are and how much the first
// covers; of the second only if the first leaves anything.
struct Shown {
  float covered = 0;
  float share = 0;
  Key first{};
  Key second{};
  bool operator==(const Shown&) const = default;
};

Shown shown(std::span<const ScreenBall> balls, const View& view, int x, int y) {
  std::vector<std::tuple<float, Key, float>> touching;
  float covered = 0;
  for (const ScreenBall& ball : balls) {
    const auto radius = static_cast<float>(view.radius);
    const float size = radius * static_cast<float>(view.focal) / ball.depth;
    const float seen = std::max(size, 1.0f);
    const float most = 1024 * size * size / (seen * seen);
    const float off_x = static_cast<float>(x) + 0.5f - ball.x;
    const float off_y = static_cast<float>(y) + 0.5f - ball.y;
    const float squared = off_x * off_x + off_y * off_y;
    const float share = std::ceil(std::clamp(most * (0.5f + 0.5f * seen) - most * 0.5f / seen * squared, 0.0f, most));
    if (share == 0) continue;
    covered += share;
    touching.emplace_back(ball.depth - radius + std::min(radius / (seen * seen) * squared, radius), key_of(ball),
                          share);
  }
  Shown found;
  std::sort(touching.begin(), touching.end());
  found.covered = std::min(covered, 1024.0f);
  if (!touching.empty()) std::tie(std::ignore, found.first, found.share) = touching[0];
  if (touching.size() > 1 && found.share < found.covered) found.second = std::get<1>(touching[1]);
  return found;
}

std::size_t expect_same_picture(const std::vector<ScreenBall>& balls, const View& view) {
  const Lists lists = lists_of(balls, view);
  const Lists all = all_of(balls, view);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Shown wanted = shown(all.at(view, x, y), view, x, y);
      EXPECT_EQ(shown(lists.at(view, x, y), view, x, y), wanted) << x << " " << y;
      // The block to the right takes this pixel's colour for its chroma.
      const int right = std::min(x + 1, width - 1);
      EXPECT_EQ(shown(lists.at(view, right, y), view, x, y), wanted) << x << " " << y;
      if (testing::Test::HasFailure()) return 0;
    }
  std::set<Key> listed;
  for (const ScreenBall& ball : lists.entries) listed.insert(key_of(ball));
  return listed.size();
}

// A filled box whose front is 1 m away, each ball off its place in the lattice by up to `disorder` spacings.
std::vector<ScreenBall> box(const View& view, int across, int deep, double disorder) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-disorder, disorder);
  std::vector<ScreenBall> balls;
  const double dx = 2 * view.radius;
  for (int i = 0; i < across; ++i)
    for (int j = 0; j < across; ++j)
      for (int k = 0; k < deep; ++k) {
        const double depth = 1 + dx * (k + shift(random));
        const double x = dx * (i - 0.5 * across + shift(random));
        const double y = dx * (j - 0.5 * across + shift(random));
        balls.push_back({static_cast<float>(0.5 * width + view.focal * x / depth),
                         static_cast<float>(0.5 * height + view.focal * y / depth),
                         static_cast<std::uint32_t>(random()), static_cast<float>(depth)});
      }
  return balls;
}

TEST(VisibleBalls, LeaveThePictureAsItIs) {
  for (const double size : {0.7, 1.6, 4.3, 17.0})  // pixels
    for (const double disorder : {0.0, 0.2, 0.6})
      for (const int shift : {0, 1, 3}) {
        const View view{0.01, size / 0.01, shift};
        const std::vector<ScreenBall> balls = box(view, 24, 12, disorder);
        expect_same_picture(balls, view);
        if (HasFailure()) return;
      }
}

TEST(VisibleBalls, AreTheSkinOfABox) {
  const View view{0.005, 2.4 / 0.005, 1};
  const std::size_t listed = expect_same_picture(box(view, 24, 24, 0.2), view);
  EXPECT_GT(listed, 24U * 24);      // at least the front
  EXPECT_LT(listed, 7U * 24 * 24);  // of 24 layers about six, until no gap is left between balls out of line
}

// A droplet far in front of a body, of the same size in the picture: its balls close some pixels of bins, never all.
TEST(VisibleBalls, InFrontMakeNoHole) {
  const View view{0.01, 400, 1};
  std::vector<ScreenBall> balls = box(view, 24, 8, 0.2);
  for (int k = 0; k < 40; ++k)
    balls.push_back({101.3f + 0.37f * static_cast<float>(k % 7), 60.2f + 0.41f * static_cast<float>(k % 5), 5, 0.6f});
  expect_same_picture(balls, view);
}

TEST(VisibleBalls, AreListedTheSameInAnyOrder) {
  const View view{0.01, 430, 1};
  std::vector<ScreenBall> balls = box(view, 24, 12, 0.3);
  const Lists lists = lists_of(balls, view);
  std::shuffle(balls.begin(), balls.end(), std::mt19937(3));
  const Lists again = lists_of(balls, view);
  ASSERT_EQ(again.entries.size(), lists.entries.size());
  for (std::size_t k = 0; k < lists.entries.size(); ++k) EXPECT_EQ(key_of(again.entries[k]), key_of(lists.entries[k]));
}

TEST(VisibleBalls, MayBeNoneOrFarOrNear) {
  const View view{0.01, 430, 1};
  EXPECT_TRUE(lists_of({}, view).entries.empty());
  // One beyond the last layer, one that fills the picture, one in its corner.
  expect_same_picture({{100, 60, 1, 1e6f}, {100, 60, 2, 0.02f}, {-2, -3, 3, 1}}, view);
}

}  // namespace
}  // namespace weir
