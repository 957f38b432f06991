#include "render/unroll.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace weir {
namespace {

TEST(Unroll, WritesOutStatementsAndBlocksFromTheInside) {
  EXPECT_EQ(unrolled("for (int k = 0; k < 2; ++k) a[k] = kk;", {}), "{a[0] = kk;}\n{a[1] = kk;}\n");
  EXPECT_EQ(unrolled("for (int r = 0; r < n; ++r) {\n  for (int c = 0; c < 2; ++c) a[n * r + c] = 0;\n}", {{"n", 1}}),
            "{{\n  {a[n * 0 + 0] = 0;}\n{a[n * 0 + 1] = 0;}\n\n}}\n");
}

TEST(Unroll, LeavesOtherLoopsAlone) {
  const std::string source = "for (uint n = first; n < past; ++n) { sum += f(n); }";
  EXPECT_EQ(unrolled(source, {}), source);
}

TEST(Unroll, RefusesWhatItCannotCount) {
  EXPECT_THROW(unrolled("for (int k = 0; k < many; ++k) f(k);", {}), std::invalid_argument);
  EXPECT_THROW(unrolled("for (int k = 0; k < 2; ++k) { f(k);", {}), std::invalid_argument);
  EXPECT_THROW(unrolled("for (int k = 0; k < 2; ++k) f(k)", {}), std::invalid_argument);
}

}  // namespace
}  // namespace weir
