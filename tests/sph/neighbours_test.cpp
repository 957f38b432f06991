#include "sph/neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace weir {
namespace {

template <int Dim>
FluidParticles<Dim> fluid_at(std::vector<Vec<Dim, double>> points) {
  FluidParticles<Dim> fluid;
  fluid.position = std::move(points);
  fluid.velocity.resize(fluid.position.size());
  fluid.id.resize(fluid.position.size());
  std::iota(fluid.id.begin(), fluid.id.end(), 0);
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

template <int Dim>
std::vector<std::int32_t> near(const Vec<Dim, double>& x, const std::vector<Vec<Dim, double>>& points, double radius,
                               std::ptrdiff_t self) {
  std::vector<std::int32_t> found;
  for (std::size_t j = 0; j < points.size(); ++j) {
    const auto x_ij = x - points[j];
    if (static_cast<std::ptrdiff_t>(j) != self && dot(x_ij, x_ij) < radius * radius) {
      found.push_back(static_cast<std::int32_t>(j));
    }
  }
  return found;
}

std::vector<std::int32_t> ascending(std::span<const std::int32_t> list) {
  std::vector<std::int32_t> sorted(list.begin(), list.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

template <int Dim>
void expect_lists_equal_brute_force(FluidParticles<Dim> fluid, WallParticles<Dim> walls, NeighbourSearch search) {
  Team team(2);
  const double radius = 1;
  Neighbours<Dim> neighbours({.support_radius = radius, .skin = 0, .search = search}, team, walls);
  neighbours.update(fluid, walls);
  for (std::size_t i = 0; i < fluid.size(); ++i) {
    EXPECT_EQ(ascending(neighbours.fluid().of(i)),
              near<Dim>(fluid.position[i], fluid.position, radius, static_cast<std::ptrdiff_t>(i)));
    EXPECT_EQ(ascending(neighbours.walls().of(i)), near<Dim>(fluid.position[i], walls.position, radius, -1));
  }
}

template <class T>
class NeighboursIn : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(NeighboursIn, Dimensions);

TYPED_TEST(NeighboursIn, EqualBruteForce) {
  constexpr int dim = TypeParam::value;
  for (const NeighbourSearch search : {NeighbourSearch::index_sort, NeighbourSearch::naive}) {
    const WallParticles<dim> walls{scattered<dim>(200, -4, 6, 11)};
    expect_lists_equal_brute_force<dim>(fluid_at<dim>(scattered<dim>(700, -4, 4, 1)), walls, search);
    auto clustered = scattered<dim>(300, 0, 0.5, 2);
    const auto rest = scattered<dim>(300, -40, 40, 3);
    clustered.insert(clustered.end(), rest.begin(), rest.end());
    expect_lists_equal_brute_force<dim>(fluid_at<dim>(clustered), walls, search);
    expect_lists_equal_brute_force<dim>(fluid_at<dim>(scattered<dim>(300, 1e6, 1e6 + 5, 4)), walls, search);
    expect_lists_equal_brute_force<dim>(fluid_at<dim>({}), walls, search);
    expect_lists_equal_brute_force<dim>(fluid_at<dim>(scattered<dim>(1, 0, 1, 5)), WallParticles<dim>{}, search);
    // Several in the same place.
    expect_lists_equal_brute_force<dim>(fluid_at<dim>(std::vector<Vec<dim, double>>(5)), walls, search);
  }
}

// [Hinsch24 ch. 6.1.2], the particle itself counted as there.
TEST(SeedA, FindsThirteenNineAndFiveNeighboursOnTheLattice) {
  const double h = 0.3;
  std::vector<Vec<2, double>> lattice;
  for (int y = 0; y < 11; ++y) {
    for (int x = 0; x < 11; ++x) lattice.push_back({x * h, y * h});
  }
  for (const NeighbourSearch search : {NeighbourSearch::index_sort, NeighbourSearch::naive}) {
    for (const auto& [radius, count] : {std::pair{2.1, 13}, std::pair{1.9, 9}, std::pair{1.1, 5}}) {
      auto fluid = fluid_at<2>(lattice);
      Team team(1);
      WallParticles<2> walls;
      Neighbours<2> neighbours({.support_radius = radius * h, .skin = 0, .search = search}, team, walls);
      neighbours.update(fluid, walls);
      const auto center = std::find(fluid.id.begin(), fluid.id.end(), 5 * 11 + 5) - fluid.id.begin();
      EXPECT_EQ(neighbours.fluid().of(center).size() + 1, count) << radius;
    }
  }
}

// Lists are kept while they are right, and remade before a pair within the support could be missing from them.
TYPED_TEST(NeighboursIn, ListsWithASkinNeverMissAPair) {
  constexpr int dim = TypeParam::value;
  auto fluid = fluid_at<dim>(scattered<dim>(400, -3, 3, 8));
  Team team(2);
  WallParticles<dim> walls{scattered<dim>(100, -3, 3, 9)};
  Neighbours<dim> neighbours({.support_radius = 1, .skin = 0.2, .search = NeighbourSearch::index_sort}, team, walls);
  std::mt19937 random(10);
  std::uniform_real_distribution<double> u(-0.02, 0.02);
  const int moves = 40;
  for (int move = 0; move < moves; ++move) {
    neighbours.update(fluid, walls);
    for (std::size_t i = 0; i < fluid.size(); ++i) {
      const auto listed = ascending(neighbours.fluid().of(i));
      const auto inside = near<dim>(fluid.position[i], fluid.position, 1, static_cast<std::ptrdiff_t>(i));
      EXPECT_TRUE(std::includes(listed.begin(), listed.end(), inside.begin(), inside.end()));
      const auto listed_walls = ascending(neighbours.walls().of(i));
      const auto inside_walls = near<dim>(fluid.position[i], walls.position, 1, -1);
      EXPECT_TRUE(std::includes(listed_walls.begin(), listed_walls.end(), inside_walls.begin(), inside_walls.end()));
    }
    for (auto& x : fluid.position) {
      for (int d = 0; d < dim; ++d) x[d] += u(random);
    }
  }
  EXPECT_LT(neighbours.rebuilds(), moves / 2) << "a random walk takes several moves to half the skin";
}

}  // namespace
}  // namespace weir
