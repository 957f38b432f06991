#include "sph/pair_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "support/listed_pairs.h"

namespace weir {
namespace {

constexpr double spacing = 0.4;        // dx, against a support of 1
constexpr std::size_t many = 100'000;  // particles: tiles of full width, 32 spacings in 2D and 16 in 3D

// Fluid that moves and walls that do not, and lists of both pairs that begin with the fluid.
template <int Dim>
struct Searched {
  ParticleSet<Dim> fluid;
  ParticleSet<Dim> walls;
  ThreadPool pool;
  PairSearch<Dim> search;
  int rows;

  Searched(const std::vector<Vec<Dim, double>>& points, const std::vector<Vec<Dim, double>>& wall_points, double skin,
           InstructionSet set, double support = 1, double dx = spacing)
      : pool(2),
        search({.particle_spacing = dx,
                .support_radius = support,
                .skin = skin,
                .particles = many,
                .instruction_set = set},
               pool),
        rows(listers_for<Dim>(set).rows) {
    fluid.start_at(points);
    walls.start_at(wall_points);
    search.add(fluid, Mobility::moving);
    search.add(walls, Mobility::fixed);
    search.list(fluid, fluid);
    search.list(fluid, walls);
  }
  IdPairs fluid_pairs() const { return listed_fluid_pairs<Dim>(search, fluid, rows); }
  IdPairs wall_pairs() const { return listed_wall_pairs<Dim>(search, fluid, walls, rows); }
  std::int64_t listed_tiles() const { return search.listed_tiles(fluid); }
  std::int64_t sorts() const { return search.sorts(fluid); }
  std::span<const Tile> tiles() const { return search.tiling(fluid).tiles(); }
};

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

// Every pair within the support is listed; a listed cluster holds some pair within the reach.
template <int Dim>
void expect_every_pair_within(const std::vector<Vec<Dim, double>>& points,
                              const std::vector<Vec<Dim, double>>& wall_points, InstructionSet set) {
  const double radius = 1;
  Searched<Dim> at(points, wall_points, 0, set);
  at.search.update();
  const IdPairs listed = at.fluid_pairs();
  EXPECT_TRUE(holds(listed, near<Dim>(at.fluid, at.fluid, radius * (1 - 1e-6), true)));
  EXPECT_FALSE(std::any_of(listed.begin(), listed.end(), [](const auto& pair) { return pair.first == pair.second; }));
  EXPECT_TRUE(holds(at.wall_pairs(), near<Dim>(at.fluid, at.walls, radius * (1 - 1e-6), false)));
  // Not much more than needed: an i-cluster and a j-cluster hold at most 4 x 4 pairs, one of which at least is inside.
  EXPECT_LE(listed.size(), 32 * near<Dim>(at.fluid, at.fluid, radius * (1 + 1e-6), true).size() + 32 * points.size());
}

template <class T>
class PairSearchIn : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(PairSearchIn, Dimensions);

TYPED_TEST(PairSearchIn, EqualBruteForceWithEveryInstructionSet) {
  constexpr int dim = TypeParam::value;
  for (const InstructionSet set : usable_instruction_sets()) {
    const auto walls = scattered<dim>(200, -4, 6, 11);
    expect_every_pair_within<dim>(scattered<dim>(700, -4, 4, 1), walls, set);
    auto clustered = scattered<dim>(300, 0, 0.5, 2);
    const auto far = scattered<dim>(300, -40, 40, 3);
    clustered.insert(clustered.end(), far.begin(), far.end());
    expect_every_pair_within<dim>(clustered, walls, set);
    expect_every_pair_within<dim>(scattered<dim>(300, 1e6, 1e6 + 5, 4), walls, set);
    expect_every_pair_within<dim>({}, walls, set);
    expect_every_pair_within<dim>(scattered<dim>(1, 0, 1, 5), {}, set);
    // Several in the same place.
    expect_every_pair_within<dim>(std::vector<Vec<dim, double>>(5), walls, set);
  }
}

// [Hinsch24 ch. 6.1.2], the particle itself counted as there.
TEST(Hinsch2024, FindsThirteenNineAndFiveNeighboursOnTheLattice) {
  const double h = 0.3;
  std::vector<Vec<2, double>> lattice;
  for (int y = 0; y < 11; ++y) {
    for (int x = 0; x < 11; ++x) lattice.push_back({x * h, y * h});
  }
  const std::int32_t center = 5 * 11 + 5;
  for (const auto& [radius, count] : {std::pair{2.1, 13}, std::pair{1.9, 9}, std::pair{1.1, 5}}) {
    Searched<2> at(lattice, {}, 0, usable_instruction_sets().back(), radius * h, h);
    at.search.update();
    const IdPairs pairs = near<2>(at.fluid, at.fluid, radius * h, false);
    EXPECT_EQ(std::count_if(pairs.begin(), pairs.end(), [](const auto& pair) { return pair.first == center; }), count);
    IdPairs listed = at.fluid_pairs();
    listed.insert({center, center});
    for (const auto& pair : pairs) {
      EXPECT_TRUE(pair.first != center || listed.contains(pair)) << pair.second << " at radius " << radius;
    }
  }
}

// Moves every particle, by move(slot, d) along each axis.
template <int Dim, class Move>
void move_all(Searched<Dim>& at, const Move& move) {
  for (std::size_t tile = 0; tile < at.tiles().size(); ++tile) {
    const Tile slots = at.tiles()[tile];
    DisplacementBox<Dim> moved;
    for (int d = 0; d < Dim; ++d) {
      moved.least[d] = nowhere;
      moved.greatest[d] = -nowhere;
      for (std::int32_t slot = slots.begin; slot < slots.end; ++slot) {
        const float distance = move(slot, d);
        at.fluid.x[d][static_cast<std::size_t>(slot)] += distance;
        moved.least[d] = std::min(moved.least[d], distance);
        moved.greatest[d] = std::max(moved.greatest[d], distance);
      }
    }
    at.search.follow(at.fluid, tile, moved);
  }
}

// Lists are kept while they are valid, and rebuilt before a pair within the support could be missing from them; also those
// of the walls as targets.
TYPED_TEST(PairSearchIn, ListsWithASkinNeverMissAPair) {
  constexpr int dim = TypeParam::value;
  Searched<dim> at(scattered<dim>(400, -3, 3, 8), scattered<dim>(100, -3, 3, 9), 0.2, usable_instruction_sets().back());
  at.search.list(at.walls, at.fluid);
  std::mt19937 random(10);
  std::uniform_real_distribution<float> u(-0.02F, 0.02F);
  const int moves = 60;
  std::int64_t most_tiles = 0;
  for (int move = 0; move < moves; ++move) {
    at.search.update();
    EXPECT_TRUE(holds(at.fluid_pairs(), near<dim>(at.fluid, at.fluid, 1, true)));
    EXPECT_TRUE(holds(at.wall_pairs(), near<dim>(at.fluid, at.walls, 1, false)));
    EXPECT_TRUE(
        holds(listed_wall_pairs<dim>(at.search, at.walls, at.fluid, at.rows), near<dim>(at.walls, at.fluid, 1, false)));
    move_all(at, [&](std::int32_t, int) { return u(random); });
    most_tiles = std::max(most_tiles, static_cast<std::int64_t>(at.tiles().size()));
  }
  // A box of 0.04 a move and axis lets lists live for 3 moves in 2D and 2 in 3D; of three builds one sorts.
  EXPECT_LE(at.listed_tiles(), (dim == 2 ? moves / 3 + 1 : moves / 2) * most_tiles);
  EXPECT_GT(at.sorts(), 2);
  EXPECT_LT(at.sorts(), dim == 2 ? moves / 6 : moves / 5);
}

// Where particles of one tile stir, its lists and those beside it are rebuilt, and no others. The pairs are right, over
// positions that have moved far from the columns that they were sorted into, too.
TYPED_TEST(PairSearchIn, OnlyWhatMovedIsListedAgain) {
  constexpr int dim = TypeParam::value;
  const double edge = dim == 2 ? 12.8 : 6.4;  // 32 and 16 spacings
  std::vector<Vec<dim, double>> points;
  std::mt19937 random(14);
  std::uniform_real_distribution<double> within(0, edge);
  constexpr int tiles_along_x = 5;
  for (int k = 0; k < 1500; ++k) {
    Vec<dim, double> point;
    for (int d = 0; d < dim; ++d) point[d] = within(random);
    point[0] *= tiles_along_x;
    points.push_back(point);
  }
  Searched<dim> at(points, {}, 0.2, usable_instruction_sets().back());
  at.search.update();
  ASSERT_EQ(at.tiles().size(), tiles_along_x);
  EXPECT_EQ(at.listed_tiles(), tiles_along_x);
  const Tile first = at.tiles()[0];
  std::uniform_real_distribution<float> u(0, 0.2F);
  for (int move = 1; move <= 4; ++move) {
    // The first tile falls apart while all drift.
    move_all(at, [&](std::int32_t slot, int) { return 0.3F + (slot < first.end ? u(random) : 0); });
    at.search.update();
    EXPECT_EQ(at.listed_tiles(), tiles_along_x + 2 * move) << "the tile and the one beside it";
    EXPECT_EQ(at.sorts(), 1);
    EXPECT_TRUE(holds(at.fluid_pairs(), near<dim>(at.fluid, at.fluid, 1, true))) << move;
  }
}

// Fluid that moves as one brings no new pairs; beside a wall it does, and tiles must not drift past each other.
TYPED_TEST(PairSearchIn, AUniformMotionNeedsNoNewLists) {
  constexpr int dim = TypeParam::value;
  for (const bool walled : {false, true}) {
    Searched<dim> at(scattered<dim>(100, 0, 2, 12),
                     walled ? scattered<dim>(10, 0, 2, 13) : std::vector<Vec<dim, double>>{}, 0.2,
                     InstructionSet::baseline);
    at.search.update();
    const auto far = static_cast<float>(0.5 * (at.search.lattice().edge(0) - 1.2));
    const auto along_x = [](float distance) { return [=](std::int32_t, int d) { return d == 0 ? distance : 0; }; };
    move_all(at, along_x(0.9F * far));
    at.search.update();
    EXPECT_EQ(at.listed_tiles(), walled ? 2 : 1);
    EXPECT_EQ(at.sorts(), 1);
    move_all(at, along_x(0.2F * far));
    at.search.update();
    EXPECT_EQ(at.sorts(), 2);
  }
}

}  // namespace
}  // namespace weir
