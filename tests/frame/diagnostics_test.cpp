#include "frame/diagnostics.h"

#include <gtest/gtest.h>

#include <set>

namespace weir {
namespace {

TEST(StepLimits, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (int limit = 0; limit <= static_cast<int>(StepLimit::maximum); ++limit) {
    const std::string_view name = name_of(static_cast<StepLimit>(limit));
    EXPECT_NE(name, "?") << limit;
    EXPECT_TRUE(names.insert(name).second) << name;
  }
}

TEST(DiagnosticColumns, HaveUnitsIfTheyAreMeasured) {
  std::set<std::string_view> names;
  for (const DiagnosticColumn& column : diagnostic_columns()) {
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
    const bool measured = std::holds_alternative<double Diagnostics::*>(column.value) ||
                          std::holds_alternative<std::array<double, 3> Diagnostics::*>(column.value);
    EXPECT_EQ(measured, !column.unit.empty()) << column.name;
  }
}

}  // namespace
}  // namespace weir
