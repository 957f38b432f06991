#include "sph/tiling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <stdexcept>

namespace weir {
namespace {

template <class T>
class TilingIn : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(TilingIn, Dimensions);

template <int Dim>
std::vector<Vec<Dim, double>> scattered(std::size_t n, double low, double high, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(low, high);
  std::vector<Vec<Dim, double>> points(n);
  for (auto& point : points) {
    for (int d = 0; d < Dim; ++d) point[d] = u(random);
  }
  return points;
}

constexpr double dx = 0.01;

template <int Dim>
void expect_sorted(const Tiling<Dim>& tiling, const Positions<Dim>& positions,
                   const std::vector<Vec<Dim, double>>& points) {
  std::vector<int> seen(points.size());
  for (std::size_t tile = 0; tile < tiling.tiles().size(); ++tile) {
    const Tile slots = tiling.tiles()[tile];
    ASSERT_EQ(slots.begin % group_size, 0);
    ASSERT_LT(slots.begin, slots.end) << "no tile is empty";
    for (std::int32_t slot = slots.begin; slot < tiling.end_of_slots(tile); ++slot) {
      if (slot >= slots.end) {
        EXPECT_TRUE(positions.empty(slot));
        EXPECT_EQ(positions.x[0][slot], nowhere);
        continue;
      }
      const auto id = static_cast<std::size_t>(positions.id[slot]);
      ++seen[id];
      for (int d = 0; d < Dim; ++d) {
        // A float and the error of a float: 48 bits of half a tile's width; the sum rounds to the 53 bits of a double.
        const double edge = tiling.lattice().edge(d);
        EXPECT_NEAR(positions.position(slot)[d], points[id][d], edge * 0x1p-49 + std::abs(points[id][d]) * 0x1p-52);
        // What pairs use: an error of at most 1e-6 spacings. [README, positions]
        EXPECT_LE(std::abs(positions.compensation[d][slot]), 1e-6 * dx);
        EXPECT_LE(std::abs(positions.x[d][slot]), 0.5 * edge * (1 + 1e-6));
        const auto cluster = static_cast<std::size_t>(slot / cluster_size);
        EXPECT_LE(tiling.low()[d][cluster], positions.x[d][slot]);
        EXPECT_GE(tiling.high()[d][cluster], positions.x[d][slot]);
      }
      EXPECT_EQ(tiling.find(tiling.lattice().tile_at(points[id])), static_cast<std::int32_t>(tile));
    }
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(points.size()));
}

TYPED_TEST(TilingIn, KeepsEveryParticleInTheTileWhereItIs) {
  constexpr int dim = TypeParam::value;
  ThreadPool pool(3);
  for (const auto& [low, high] : {std::pair{-1.0, 1.0}, std::pair{1e4, 1e4 + 0.5}, std::pair{0.0, 1e-3}}) {
    auto points = scattered<dim>(3000, low, high, 1);
    Positions<dim> positions = unsorted<dim>(points);
    Tiling<dim> tiling(TileLattice<dim>(dx, 3 * dx, 100'000));
    tiling.sort(positions, pool);
    // As unsorted() took them: about the origin, with 48 bits.
    std::vector<Vec<dim, double>> taken(points.size());
    for (std::size_t slot = 0; slot < positions.slots(); ++slot) {
      if (!positions.empty(slot)) taken[static_cast<std::size_t>(positions.id[slot])] = positions.position(slot);
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (int d = 0; d < dim; ++d)
        EXPECT_NEAR(taken[i][d], points[i][d], 0.32 * 0x1p-49 + std::abs(points[i][d]) * 0x1p-47);
    }
    expect_sorted<dim>(tiling, positions, taken);
    // Moved and sorted again, as a run does.
    std::mt19937 random(2);
    std::uniform_real_distribution<float> u(-0.001F, 0.001F);
    for (std::size_t slot = 0; slot < positions.slots(); ++slot) {
      if (positions.empty(slot)) continue;
      for (int d = 0; d < dim; ++d) positions.x[d][slot] += u(random);
      taken[static_cast<std::size_t>(positions.id[slot])] = positions.position(slot);
    }
    tiling.sort(positions, pool);
    expect_sorted<dim>(tiling, positions, taken);
  }
}

TYPED_TEST(TilingIn, OrderDoesNotDependOnThreads) {
  constexpr int dim = TypeParam::value;
  const auto points = scattered<dim>(20000, -1, 1, 3);
  std::vector<std::vector<std::int32_t>> ids;
  for (const int threads : {1, 2, 5}) {
    ThreadPool pool(threads);
    Positions<dim> positions = unsorted<dim>(points);
    Tiling<dim> tiling(TileLattice<dim>(dx, 3 * dx, 100'000));
    tiling.sort(positions, pool);
    ids.emplace_back(positions.id.begin(), positions.id.end());
  }
  EXPECT_EQ(ids[0], ids[1]);
  EXPECT_EQ(ids[0], ids[2]);
}

// Two drops a thousand kilometres apart need no more than two drops side by side.
TYPED_TEST(TilingIn, MemoryFollowsTheParticlesNotTheDomain) {
  constexpr int dim = TypeParam::value;
  auto points = scattered<dim>(1000, 0, 0.1, 4);
  for (std::size_t i = 500; i < points.size(); ++i) points[i][0] += dim == 2 ? 1e5 : 5e4;
  ThreadPool pool(1);
  Positions<dim> positions = unsorted<dim>(points);
  Tiling<dim> tiling(TileLattice<dim>(dx, 3 * dx, 100'000));
  tiling.sort(positions, pool);
  EXPECT_LE(tiling.tiles().size(), 4U);
  EXPECT_LE(tiling.slots(), points.size() + tiling.tiles().size() * group_size);
}

TYPED_TEST(TilingIn, RefusesParticlesTooFarAwayAndThoseThatAreNowhere) {
  constexpr int dim = TypeParam::value;
  ThreadPool pool(2);
  Tiling<dim> tiling(TileLattice<dim>(dx, 3 * dx, 100'000));
  for (const double wrong : {1e9, -1e9, std::nan("")}) {
    auto points = scattered<dim>(100, 0, 1, 5);
    points[50][dim - 1] = wrong;
    Positions<dim> positions = unsorted<dim>(points);
    EXPECT_THROW(tiling.sort(positions, pool), std::range_error) << wrong;
  }
  Positions<dim> none;
  tiling.sort(none, pool);
  EXPECT_TRUE(tiling.tiles().empty());
}

}  // namespace
}  // namespace weir
