#include "sph/neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "support/listed_pairs.h"

namespace weir {
namespace {

template <int Dim>
FluidParticles<Dim> fluid_at(const std::vector<Vec<Dim, double>>& points) {
  FluidParticles<Dim> fluid;
  static_cast<Positions<Dim>&>(fluid) = unsorted<Dim>(points);
  for (auto& each : fluid.velocity) each.resize(fluid.slots() + group_size);
  fluid.count = points.size();
  return fluid;
}

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

// Pairs closer than `radius`, each compared with each.
template <int Dim>
IdPairs near(const Positions<Dim>& from, const Positions<Dim>& to, double radius, bool same) {
  IdPairs pairs;
  for (std::size_t i = 0; i < from.slots(); ++i) {
    if (from.empty(i)) continue;
    for (std::size_t j = 0; j < to.slots(); ++j) {
      if (to.empty(j) || (same && i == j)) continue;
      const auto x_ij = from.position(i) - to.position(j);
      if (dot(x_ij, x_ij) < radius * radius) pairs.insert({from.id[i], to.id[j]});
    }
  }
  return pairs;
}

bool holds(const IdPairs& listed, const IdPairs& wanted) {
  return std::includes(listed.begin(), listed.end(), wanted.begin(), wanted.end());
}

constexpr double spacing = 0.4;        // dx, against a support of 1
constexpr std::size_t many = 100'000;  // particles: tiles of full width, 32 spacings in 2D and 16 in 3D

// Every pair within the support is listed; a listed cluster holds some pair within the reach.
template <int Dim>
void expect_every_pair_within(const std::vector<Vec<Dim, double>>& points,
                              const std::vector<Vec<Dim, double>>& wall_points, NeighbourSearch search,
                              InstructionSet set) {
  ThreadPool pool(2);
  const double radius = 1;
  auto fluid = fluid_at<Dim>(points);
  WallParticles<Dim> walls = unsorted<Dim>(wall_points);
  Neighbours<Dim> neighbours({spacing, radius, 0, many, search, set}, pool, walls);
  neighbours.update(fluid, walls);
  const int rows = loops_for<Dim>(set, {}).rows;
  const IdPairs listed = listed_fluid_pairs<Dim>(neighbours, fluid, rows);
  const IdPairs inside = near<Dim>(fluid, fluid, radius * (1 - 1e-6), true);
  EXPECT_TRUE(holds(listed, inside));
  EXPECT_FALSE(std::any_of(listed.begin(), listed.end(), [](const auto& pair) { return pair.first == pair.second; }));
  const IdPairs listed_walls = listed_wall_pairs<Dim>(neighbours, fluid, walls, rows);
  EXPECT_TRUE(holds(listed_walls, near<Dim>(fluid, walls, radius * (1 - 1e-6), false)));
  // Not much more than needed: a row and a cluster hold at most 4 x 4 pairs, one of which at least is inside.
  EXPECT_LE(listed.size(), 32 * near<Dim>(fluid, fluid, radius * (1 + 1e-6), true).size() + 32 * points.size());
}

template <class T>
class NeighboursIn : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(NeighboursIn, Dimensions);

TYPED_TEST(NeighboursIn, EqualBruteForceWithEveryInstructionSet) {
  constexpr int dim = TypeParam::value;
  for (const InstructionSet set : usable_instruction_sets()) {
    for (const NeighbourSearch search : {NeighbourSearch::index_sort, NeighbourSearch::naive}) {
      const auto walls = scattered<dim>(200, -4, 6, 11);
      expect_every_pair_within<dim>(scattered<dim>(700, -4, 4, 1), walls, search, set);
      auto clustered = scattered<dim>(300, 0, 0.5, 2);
      const auto rest = scattered<dim>(300, -40, 40, 3);
      clustered.insert(clustered.end(), rest.begin(), rest.end());
      expect_every_pair_within<dim>(clustered, walls, search, set);
      expect_every_pair_within<dim>(scattered<dim>(300, 1e6, 1e6 + 5, 4), walls, search, set);
      expect_every_pair_within<dim>({}, walls, search, set);
      expect_every_pair_within<dim>(scattered<dim>(1, 0, 1, 5), {}, search, set);
      // Several in the same place.
      expect_every_pair_within<dim>(std::vector<Vec<dim, double>>(5), walls, search, set);
    }
  }
}

// The sorted search lists what comparing everything with everything lists, in the same order.
TYPED_TEST(NeighboursIn, BothSearchesMakeTheSameLists) {
  constexpr int dim = TypeParam::value;
  ThreadPool pool(2);
  for (const InstructionSet set : usable_instruction_sets()) {
    std::vector<std::vector<std::int32_t>> lists;
    for (const NeighbourSearch search : {NeighbourSearch::index_sort, NeighbourSearch::naive}) {
      auto fluid = fluid_at<dim>(scattered<dim>(3000, -8, 8, 6));
      WallParticles<dim> walls = unsorted<dim>(scattered<dim>(600, -9, 9, 7));
      Neighbours<dim> neighbours({spacing, 1, 0.2, many, search, set}, pool, walls);
      neighbours.update(fluid, walls);
      std::vector<std::int32_t> all;
      for (std::size_t tile = 0; tile < neighbours.tiling().tiles().size(); ++tile) {
        for (const IntBuffer* list : {&neighbours.lists().fluid[tile], &neighbours.lists().walls[tile]}) {
          all.insert(all.end(), list->data(), list->data() + list->size());
        }
      }
      lists.push_back(std::move(all));
    }
    EXPECT_EQ(lists[0], lists[1]) << name_of(set);
  }
}

// [Hinsch24 ch. 6.1.2], the particle itself counted as there.
TEST(Hinsch2024, FindsThirteenNineAndFiveNeighboursOnTheLattice) {
  const double h = 0.3;
  std::vector<Vec<2, double>> lattice;
  for (int y = 0; y < 11; ++y) {
    for (int x = 0; x < 11; ++x) lattice.push_back({x * h, y * h});
  }
  const auto fluid = fluid_at<2>(lattice);
  const std::int32_t center = 5 * 11 + 5;
  for (const auto& [radius, count] : {std::pair{2.1, 13}, std::pair{1.9, 9}, std::pair{1.1, 5}}) {
    const IdPairs pairs = near<2>(fluid, fluid, radius * h, false);
    EXPECT_EQ(std::count_if(pairs.begin(), pairs.end(), [](const auto& pair) { return pair.first == center; }), count);
    auto sorted = fluid_at<2>(lattice);
    ThreadPool pool(1);
    WallParticles<2> walls;
    const InstructionSet set = usable_instruction_sets().back();
    Neighbours<2> neighbours({h, radius * h, 0, many, NeighbourSearch::index_sort, set}, pool, walls);
    neighbours.update(sorted, walls);
    IdPairs listed = listed_fluid_pairs<2>(neighbours, sorted, loops_for<2>(set, {}).rows);
    listed.insert({center, center});
    for (const auto& pair : pairs) {
      EXPECT_TRUE(pair.first != center || listed.contains(pair)) << pair.second << " at radius " << radius;
    }
  }
}

// Moves every particle, by move(slot, d) along each axis.
template <int Dim, class Move>
void move_all(FluidParticles<Dim>& fluid, Neighbours<Dim>& neighbours, const Move& move) {
  for (std::size_t tile = 0; tile < neighbours.tiling().tiles().size(); ++tile) {
    const Tile slots = neighbours.tiling().tiles()[tile];
    DisplacementBox<Dim> moved;
    for (int d = 0; d < Dim; ++d) {
      moved.least[d] = nowhere;
      moved.greatest[d] = -nowhere;
      for (std::int32_t slot = slots.begin; slot < slots.end; ++slot) {
        const float distance = move(slot, d);
        fluid.x[d][static_cast<std::size_t>(slot)] += distance;
        moved.least[d] = std::min(moved.least[d], distance);
        moved.greatest[d] = std::max(moved.greatest[d], distance);
      }
    }
    neighbours.follow(tile, moved);
  }
}

// Lists are kept while they are right, and remade before a pair within the support could be missing from them.
TYPED_TEST(NeighboursIn, ListsWithASkinNeverMissAPair) {
  constexpr int dim = TypeParam::value;
  auto fluid = fluid_at<dim>(scattered<dim>(400, -3, 3, 8));
  ThreadPool pool(2);
  WallParticles<dim> walls = unsorted<dim>(scattered<dim>(100, -3, 3, 9));
  const InstructionSet set = usable_instruction_sets().back();
  Neighbours<dim> neighbours({spacing, 1, 0.2, many, NeighbourSearch::index_sort, set}, pool, walls);
  const int rows = loops_for<dim>(set, {}).rows;
  std::mt19937 random(10);
  std::uniform_real_distribution<float> u(-0.02F, 0.02F);
  const int moves = 60;
  std::int64_t most_tiles = 0;
  for (int move = 0; move < moves; ++move) {
    neighbours.update(fluid, walls);
    EXPECT_TRUE(holds(listed_fluid_pairs<dim>(neighbours, fluid, rows), near<dim>(fluid, fluid, 1, true)));
    EXPECT_TRUE(holds(listed_wall_pairs<dim>(neighbours, fluid, walls, rows), near<dim>(fluid, walls, 1, false)));
    move_all<dim>(fluid, neighbours, [&](std::int32_t, int) { return u(random); });
    most_tiles = std::max(most_tiles, static_cast<std::int64_t>(neighbours.tiling().tiles().size()));
  }
  // A box of 0.04 a move and axis lets lists live for 3 moves in 2D and 2 in 3D; of three makings one sorts.
  EXPECT_LE(neighbours.listed_tiles(), (dim == 2 ? moves / 3 + 1 : moves / 2) * most_tiles);
  EXPECT_GT(neighbours.sorts(), 2);
  EXPECT_LT(neighbours.sorts(), dim == 2 ? moves / 6 : moves / 5);
}

// Where particles of one tile stir, its lists and those beside it are made anew, and no others. The pairs are right, over
// places that have moved far from the columns that they were sorted into, too.
TYPED_TEST(NeighboursIn, OnlyWhatMovedIsListedAnew) {
  constexpr int dim = TypeParam::value;
  const double edge = dim == 2 ? 12.8 : 6.4;  // 32 and 16 spacings
  std::vector<Vec<dim, double>> points;
  std::mt19937 random(14);
  std::uniform_real_distribution<double> within(0, edge);
  constexpr int tiles_in_a_row = 5;
  for (int k = 0; k < 1500; ++k) {
    Vec<dim, double> point;
    for (int d = 0; d < dim; ++d) point[d] = within(random);
    point[0] *= tiles_in_a_row;
    points.push_back(point);
  }
  ThreadPool pool(2);
  auto fluid = fluid_at<dim>(points);
  WallParticles<dim> walls;
  const InstructionSet set = usable_instruction_sets().back();
  Neighbours<dim> neighbours({spacing, 1, 0.2, many, NeighbourSearch::index_sort, set}, pool, walls);
  neighbours.update(fluid, walls);
  ASSERT_EQ(neighbours.tiling().tiles().size(), tiles_in_a_row);
  EXPECT_EQ(neighbours.listed_tiles(), tiles_in_a_row);
  const Tile first = neighbours.tiling().tiles()[0];
  std::uniform_real_distribution<float> u(0, 0.2F);
  const int rows = loops_for<dim>(set, {}).rows;
  for (int move = 1; move <= 4; ++move) {
    // The first tile falls apart while all drift.
    move_all<dim>(fluid, neighbours, [&](std::int32_t slot, int) { return 0.3F + (slot < first.end ? u(random) : 0); });
    neighbours.update(fluid, walls);
    EXPECT_EQ(neighbours.listed_tiles(), tiles_in_a_row + 2 * move) << "the tile and the one beside it";
    EXPECT_EQ(neighbours.sorts(), 1);
    EXPECT_TRUE(holds(listed_fluid_pairs<dim>(neighbours, fluid, rows), near<dim>(fluid, fluid, 1, true))) << move;
  }
}

// Fluid that moves as one brings no new pairs; beside a wall it does, and tiles must not drift past each other.
TYPED_TEST(NeighboursIn, AUniformMotionNeedsNoNewLists) {
  constexpr int dim = TypeParam::value;
  for (const bool walled : {false, true}) {
    ThreadPool pool(1);
    auto fluid = fluid_at<dim>(scattered<dim>(100, 0, 2, 12));
    WallParticles<dim> walls = unsorted<dim>(walled ? scattered<dim>(10, 0, 2, 13) : std::vector<Vec<dim, double>>{});
    Neighbours<dim> neighbours({spacing, 1, 0.2, many, NeighbourSearch::index_sort, InstructionSet::baseline}, pool,
                               walls);
    neighbours.update(fluid, walls);
    const auto far = static_cast<float>(0.5 * (neighbours.tiling().lattice().edge() - 1.2));
    const auto along_x = [](float distance) { return [=](std::int32_t, int d) { return d == 0 ? distance : 0; }; };
    move_all<dim>(fluid, neighbours, along_x(0.9F * far));
    neighbours.update(fluid, walls);
    EXPECT_EQ(neighbours.listed_tiles(), walled ? 2 : 1);
    EXPECT_EQ(neighbours.sorts(), 1);
    move_all<dim>(fluid, neighbours, along_x(0.2F * far));
    neighbours.update(fluid, walls);
    EXPECT_EQ(neighbours.sorts(), 2);
  }
}

}  // namespace
}  // namespace weir
