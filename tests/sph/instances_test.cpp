// Loops are built once per line of engine/instances.def, dimension and instruction set: their number is a decision, and
// does not grow by itself.
#include <gtest/gtest.h>

#include <set>
#include <typeindex>
#include <vector>

#include "sph/engine/built.h"
#include "sph/passes/continuity.h"
#include "sph/passes/density.h"
#include "sph/passes/momentum.h"
#include "sph/passes/motion.h"
#include "sph/passes/vorticity.h"
#include "sph/passes/wall_state.h"

namespace weir {
namespace {

// Per dimension. A loop over pairs takes some 0.35 s of a processor to build and 5 kB, all instruction sets together; every
// option times every other would be 500.
constexpr std::size_t most_loops_over_pairs = 85;
constexpr std::size_t most_updates = 12;

struct Loops {
  std::vector<std::type_index> over_pairs;
  std::vector<std::type_index> updates;
};

template <int Dim>
Loops loops() {
  Loops listed;
#define WEIR_WITHIN(...) listed.over_pairs.push_back(typeid(Within<__VA_ARGS__>));
#define WEIR_BETWEEN(...) listed.over_pairs.push_back(typeid(Between<__VA_ARGS__>));
#define WEIR_EACH(...) listed.updates.push_back(typeid(__VA_ARGS__));
#define WEIR_DIMENSION 2
#include "sph/engine/instances.def"
#undef WEIR_DIMENSION
#undef WEIR_WITHIN
#undef WEIR_BETWEEN
#undef WEIR_EACH
  return listed;
}

void expect_within_budget(const Loops& loops) {
  EXPECT_GT(loops.over_pairs.size(), 0U);
  EXPECT_LE(loops.over_pairs.size(), most_loops_over_pairs);
  EXPECT_GT(loops.updates.size(), 0U);
  EXPECT_LE(loops.updates.size(), most_updates);
}

void expect_each_once(const std::vector<std::type_index>& loops) {
  EXPECT_EQ(std::set(loops.begin(), loops.end()).size(), loops.size());
}

TEST(Instances, AreWithinTheirBudget) {
  expect_within_budget(loops<2>());
  expect_within_budget(loops<3>());
}

TEST(Instances, AreListedOnce) {
  for (const Loops& listed : {loops<2>(), loops<3>()}) {
    expect_each_once(listed.over_pairs);
    expect_each_once(listed.updates);
  }
}

}  // namespace
}  // namespace weir
