#include "sph/cell_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <stdexcept>

namespace weir {
namespace {

template <class T>
class CellGridOf : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 2>, std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(CellGridOf, Dimensions);

template <int Dim>
std::vector<Vec<Dim, double>> scattered(std::size_t n, double size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(-size, size);
  std::vector<Vec<Dim, double>> points(n);
  for (auto& point : points) {
    for (int d = 0; d < Dim; ++d) point[d] = u(random);
  }
  return points;
}

// Every point whose cell is at most one away must be in the ranges, and no other.
template <int Dim>
void expect_rows_are_the_adjacent_cells(std::vector<Vec<Dim, double>> points, double cell_size) {
  CellGrid<Dim> grid;
  const auto order = grid.sort(points, cell_size);
  ASSERT_EQ(order.size(), points.size());
  std::vector<Vec<Dim, double>> sorted;
  for (const std::int32_t k : order) sorted.push_back(points[k]);
  for (const auto& point : sorted) {
    const auto own = grid.cell_of(point);
    std::set<std::int32_t> found;
    for (const PointRange& range : grid.neighbourhood(own)) {
      for (std::int32_t j = range.begin; j < range.end; ++j) EXPECT_TRUE(found.insert(j).second) << "visited twice";
    }
    std::set<std::int32_t> expected;
    for (std::size_t j = 0; j < sorted.size(); ++j) {
      bool adjacent = true;
      for (int d = 0; d < Dim; ++d) adjacent = adjacent && std::abs(grid.cell_of(sorted[j])[d] - own[d]) <= 1;
      if (adjacent) expected.insert(static_cast<std::int32_t>(j));
    }
    EXPECT_EQ(found, expected);
  }
}

TYPED_TEST(CellGridOf, RowsHoldExactlyTheAdjacentCells) {
  constexpr int dim = TypeParam::value;
  for (unsigned seed = 0; seed < 3; ++seed) expect_rows_are_the_adjacent_cells<dim>(scattered<dim>(300, 3, seed), 1);
  expect_rows_are_the_adjacent_cells<dim>(scattered<dim>(200, 0.4, 1), 1);  // all in a handful of cells
  expect_rows_are_the_adjacent_cells<dim>(scattered<dim>(200, 1e5, 2), 1);  // nearly every point alone
  expect_rows_are_the_adjacent_cells<dim>({}, 1);
  expect_rows_are_the_adjacent_cells<dim>(scattered<dim>(1, 5, 3), 1);
}

TYPED_TEST(CellGridOf, AnotherGridsCellsMayLieOutside) {
  constexpr int dim = TypeParam::value;
  CellGrid<dim> grid;
  grid.sort(scattered<dim>(50, 2, 4), 1);
  Vec<dim, double> far{};
  far[dim - 1] = 1e9;
  for (const PointRange& range : grid.neighbourhood(grid.cell_of(far))) EXPECT_EQ(range.begin, range.end);
  far[dim - 1] = -1e9;
  for (const PointRange& range : grid.neighbourhood(grid.cell_of(far))) EXPECT_EQ(range.begin, range.end);
}

TYPED_TEST(CellGridOf, PointsOfOneCellKeepTheirOrder) {
  constexpr int dim = TypeParam::value;
  const auto points = scattered<dim>(500, 2, 5);
  CellGrid<dim> grid;
  const auto order = grid.sort(points, 1);
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (grid.cell_of(points[order[k]]) == grid.cell_of(points[order[k - 1]])) {
      EXPECT_LT(order[k - 1], order[k]);
    }
  }
}

TYPED_TEST(CellGridOf, RefusesPointsTooFarApartToCount) {
  constexpr int dim = TypeParam::value;
  auto points = scattered<dim>(2, 1, 6);
  for (int d = 0; d < dim; ++d) points[0][d] = 1e15;
  CellGrid<dim> grid;
  EXPECT_THROW(grid.sort(points, 1e-3), std::range_error);
}

}  // namespace
}  // namespace weir
