// Occlusion culling against a reference that rasterises every sphere, in double precision where the result does not
// depend on it.
#include "render/visible_balls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>

#include "render/balls.h"
#include "render/taken_pixels.h"

namespace weir {
namespace {

constexpr int width = 600;  // strips of three widths
constexpr int height = 120;

// Looks along z from (0, 0, -1): depth is 1 + z.
struct View {
  double radius = 0;  // m
  double focal = 0;
  Projection projection() const {
    Projection to;
    to.eye = Vec3(0, 0, -1);
    to.forward = Vec3(0, 0, 1);
    to.perspective = true;
    to.focal = focal;
    to.principal = {width / 2.0, height / 2.0};
    return to;
  }
  BallStyle style() const { return {radius, {0, 255}}; }
};

using Picture = std::vector<std::uint32_t>;  // 0xAABBGGRR

Picture picture_of(const std::vector<glm::vec4>& particles, const View& view, int threads = 1) {
  Balls balls(width, height, threads);
  balls.show(particles, view.projection(), view.style(), distinct_colors());
  return taken_pixels(balls, width, height);
}

std::vector<ScreenBall> seen(const std::vector<glm::vec4>& particles, const View& view) {
  const BallView in_fours(view.projection(), view.radius, view.style().range);
  std::vector<ScreenBall> balls;
  for (const glm::vec4& particle : particles) {
    const BallView::Seen at = in_fours.of(all(particle.x), all(particle.y), all(particle.z));
    if (!(at.depth[0] > in_fours.radius)) continue;
    const auto place = static_cast<std::size_t>(std::clamp(particle.w, 0.0f, 255.0f) + 0.5f);
    balls.push_back({at.column[0], at.row[0], at.depth[0], distinct_colors()[place]});
  }
  return balls;
}

// The pixels if none is left out.
Picture all_looked_at(std::vector<ScreenBall> balls, const View& view) {
  const auto order = [](const ScreenBall& ball) { return std::tuple(ball.depth, ball.x, ball.y, ball.color); };
  std::sort(balls.begin(), balls.end(), [&](const auto& a, const auto& b) { return order(a) < order(b); });
  struct Pixel {
    float covered = 0;
    float nearest = 1e38f;
    float second = 1e38f;
    const ScreenBall* balls[2] = {nullptr, nullptr};
  };
  const auto radius = static_cast<float>(view.radius);
  const auto drawn = [&](const ScreenBall& ball) {
    const float size = radius * static_cast<float>(view.focal) / ball.depth;
    return std::pair(size, std::max(size, 1.0f));
  };
  const auto share_at = [&](const ScreenBall& ball, float squared) {
    const auto [size, seen_size] = drawn(ball);
    const float most = 1024 * size * size / (seen_size * seen_size);
    const float slope = most * 0.5f / seen_size;
    return std::ceil(std::clamp(most * (0.5f + 0.5f * seen_size) - slope * squared, 0.0f, most));
  };
  std::vector<Pixel> pixels(width * height);
  for (const ScreenBall& ball : balls) {
    const float size = drawn(ball).second;
    const int top = std::max(static_cast<int>(ball.y - size) - 1, 0);
    const int left = std::max(static_cast<int>(ball.x - size) - 1, 0);
    for (int y = top; y < height && static_cast<float>(y) < ball.y + size + 1; ++y)
      for (int x = left; x < width && static_cast<float>(x) < ball.x + size + 1; ++x) {
        const float off_x = static_cast<float>(x) + 0.5f - ball.x;
        const float off_y = static_cast<float>(y) + 0.5f - ball.y;
        const float squared = off_x * off_x + off_y * off_y;
        const float share = share_at(ball, squared);
        if (share == 0) continue;
        Pixel& pixel = pixels[y * width + x];
        const float key = ball.depth - radius + std::min(radius / (size * size) * squared, radius);
        pixel.covered = std::min(pixel.covered + share, 1024.0f);
        if (key < pixel.nearest) {
          std::tie(pixel.second, pixel.balls[1]) = std::tuple(pixel.nearest, pixel.balls[0]);
          std::tie(pixel.nearest, pixel.balls[0]) = std::tuple(key, &ball);
        } else if (key < pixel.second) {
          std::tie(pixel.second, pixel.balls[1]) = std::tuple(key, &ball);
        }
      }
  }
  const auto lit = [&](const ScreenBall& ball, int x, int y) {
    const double size = drawn(ball).second;
    const double right = (x + 0.5 - ball.x) / size;
    const double up = (ball.y - (y + 0.5)) / size;
    const double towards = std::sqrt(std::max(1 - right * right - up * up, 0.0));
    const double diffuse = std::max(-0.4243 * right + 0.5657 * up + 0.7071 * towards, 0.0);
    const double light = (0.42 + 0.58 * diffuse) * (0.55 + 0.45 * std::min(2.5 * towards, 1.0));
    return light * glm::dvec3(ball.color >> 16, ball.color >> 8 & 0xff, ball.color & 0xff);
  };
  Picture picture(width * height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const Pixel& pixel = pixels[y * width + x];
      if (pixel.covered == 0) continue;
      glm::dvec3 color = lit(*pixel.balls[0], x, y);
      const double off_x = x + 0.5 - pixel.balls[0]->x;
      const double off_y = y + 0.5 - pixel.balls[0]->y;
      const double front = share_at(*pixel.balls[0], static_cast<float>(off_x * off_x + off_y * off_y)) / pixel.covered;
      if (front < 1) color = front * color + (1 - front) * lit(*pixel.balls[1], x, y);
      const glm::dvec3 bytes = color + 0.5;
      picture[y * width + x] = static_cast<std::uint32_t>(bytes.r) | static_cast<std::uint32_t>(bytes.g) << 8 |
                               static_cast<std::uint32_t>(bytes.b) << 16 |
                               static_cast<std::uint32_t>(pixel.covered / 1024 * 255 + 0.5) << 24;
    }
  return picture;
}

// What is left out may not show at all. Bytes may be rounded to the other side; and the share of the front that the
// drawing takes is not rounded up to whole 1/1024, which where next to nothing is covered makes up to half of it.
void expect_same_picture(const std::vector<glm::vec4>& particles, const View& view) {
  const Picture wanted = all_looked_at(seen(particles, view), view);
  const Picture found = picture_of(particles, view);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::uint32_t a = wanted[y * width + x];
      const std::uint32_t b = found[y * width + x];
      ASSERT_EQ(a >> 24, b >> 24) << x << " " << y;
      if (a >> 24 < 64) continue;
      for (const std::uint32_t shift : {0U, 8U, 16U})
        ASSERT_NEAR(a >> shift & 0xff, b >> shift & 0xff, 2) << x << " " << y << " " << shift;
    }
}

// A filled box whose front is 1 m away, each ball off its place in the lattice by up to `disorder` spacings.
std::vector<glm::vec4> box(const View& view, int across, int deep, double disorder) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-disorder, disorder);
  std::vector<glm::vec4> balls;
  const double dx = 2 * view.radius;
  for (int i = 0; i < across; ++i)
    for (int j = 0; j < across; ++j)
      for (int k = 0; k < deep; ++k)
        balls.emplace_back(dx * (i - 0.5 * across + shift(random)), dx * (j - 0.5 * across + shift(random)),
                           dx * (k + shift(random)), static_cast<float>(random() % 256));
  return balls;
}

TEST(VisibleBalls, CullingKeepsThePicture) {
  for (const double size : {0.7, 1.6, 4.3, 17.0})  // pixels
    for (const double disorder : {0.0, 0.2, 0.6}) {
      const View view{0.01, size / 0.01};
      expect_same_picture(box(view, 24, 12, disorder), view);
      if (HasFatalFailure()) FAIL() << size << " " << disorder;
    }
}

// Some hide all that is behind, some are between others, and there are droplets far in front of a body, whose balls
// close some pixels of what they touch and never all.
TEST(VisibleBalls, InFrontMakeNoHole) {
  const View view{0.01, 400};
  std::vector<glm::vec4> balls = box(view, 24, 8, 0.2);
  for (int k = 0; k < 40; ++k) balls.emplace_back(0.001 * (k % 7), 0.0012 * (k % 5), -0.4, 5);
  expect_same_picture(balls, view);
}

TEST(VisibleBalls, AreTheSamePixelsInAnyOrder) {
  for (const double disorder : {0.0, 0.3}) {  // on the lattice many surfaces are equally far
    const View view{0.01, 430};
    std::vector<glm::vec4> balls = box(view, 24, 12, disorder);
    const Picture picture = picture_of(balls, view);
    std::shuffle(balls.begin(), balls.end(), std::mt19937(3));
    EXPECT_TRUE(picture_of(balls, view) == picture);
  }
}

TEST(VisibleBalls, AreTheSamePixelsForAnyNumberOfThreads) {
  const View view{0.01, 1400};  // in all strips
  const std::vector<glm::vec4> balls = box(view, 24, 12, 0.3);
  const Picture picture = picture_of(balls, view, 1);
  for (const int threads : {2, 3, 5}) EXPECT_TRUE(picture_of(balls, view, threads) == picture) << threads;
}

TEST(VisibleBalls, AreTheSkinOfABox) {
  const View view{0.005, 2.4 / 0.005};
  const std::vector<glm::vec4> balls = box(view, 24, 24, 0.2);
  const BallView in_fours(view.projection(), view.radius, view.style().range);
  std::vector<BallGroup> groups;
  for (std::size_t first = 0; first < balls.size(); first += BallGroup::most)
    groups.push_back(group_of(std::span(balls).subspan(first, BallGroup::most), in_fours, width, height));
  BallPixels pixels({0, 0, width - 1, height - 1});
  pixels.begin(view.radius, view.focal, 2.4);
  VisibleBalls().add_to(pixels, balls, groups, in_fours, distinct_colors());
  EXPECT_GT(pixels.added(), 24U * 24);      // at least the front
  EXPECT_LT(pixels.added(), 7U * 24 * 24);  // of 24 layers about six, until no gap is left between balls out of line
}

// What is looked at ends with what hides it: none of the balls behind a wall of large ones reaches the pixels.
TEST(VisibleBalls, BehindOthersAreHidden) {
  const View view{0.01, 1000};
  BallPixels pixels({0, 0, 255, height - 1});
  pixels.begin(view.radius, view.focal, 10);
  const PixelRange part{40, 40, 80, 80};
  EXPECT_FALSE(pixels.hides(part, 1e9f));
  for (int x = -10; x < 270; x += 8)
    for (int y = -10; y < 140; y += 8) pixels.add({static_cast<float>(x), static_cast<float>(y), 1, 0});
  EXPECT_TRUE(pixels.hides(part, 1.01f));
  EXPECT_FALSE(pixels.hides(part, 0.98f));
  EXPECT_FALSE(pixels.hides(part, std::nanf("")));
}

TEST(VisibleBalls, MayBeNoneOrFarOrNear) {
  const View view{0.01, 430};
  EXPECT_TRUE(picture_of({}, view) == Picture(width * height));
  // One beyond the last layer, one that fills the picture, one in its corner.
  expect_same_picture({{0, 0, 1e6f, 1}, {0, 0, -0.98f, 2}, {-0.7f, 0.14f, 0, 3}}, view);
}

// Those beside it count as if it were not there.
TEST(VisibleBalls, ThatAreNotFiniteAreSkipped) {
  const View view{0.01, 430};
  std::vector<glm::vec4> balls = box(view, 12, 6, 0.3);
  const Picture picture = picture_of(balls, view);
  const float infinity = std::numeric_limits<float>::infinity();
  const float not_a_number = std::numeric_limits<float>::quiet_NaN();
  balls.insert(balls.begin() + 10, {not_a_number, 0, 0, 1});
  balls.insert(balls.begin() + 100, {0, infinity, 0, 1});
  balls.insert(balls.begin() + 200, {0, 0, infinity, 1});
  balls.insert(balls.begin() + 300, {0, 0, -infinity, 1});
  balls.emplace_back(0, 0, 0, not_a_number);
  EXPECT_TRUE(picture_of(balls, view) == picture);
}

// Registers of eight floats and of four.
TEST(VisibleBalls, AreTheSamePixelsInAnyRegisters) {
  if (!has_wide_registers()) GTEST_SKIP() << "this processor has no AVX2";
  const View view{0.01, 430};
  const std::vector<ScreenBall> balls = seen(box(view, 20, 8, 0.3), view);
  const auto drawn = [&](bool wide_registers) {
    BallPixels pixels({0, 0, width - 1, height - 1}, wide_registers);
    pixels.begin(view.radius, view.focal, 4.3);
    for (const ScreenBall& ball : balls)
      if (ball.x > 0 && ball.x < width && ball.y > 0 && ball.y < height) pixels.add(ball);
    Squares squares(width, height);
    pixels.mark(squares);
    std::vector<std::uint8_t> stale;
    std::vector<Texel> texels(squares.close(stale));
    pixels.take(squares, 1, texels.data());
    return texels;
  };
  EXPECT_TRUE(drawn(true) == drawn(false));
}

}  // namespace
}  // namespace weir
