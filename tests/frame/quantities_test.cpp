#include "frame/quantities.h"

#include <gtest/gtest.h>

#include <set>

namespace weir {
namespace {

TEST(Quantities, HaveCompleteLines) {
  std::set<std::string_view> names;
  for (const QuantityFacts& facts : quantities) {
    EXPECT_FALSE(facts.name.empty());
    EXPECT_FALSE(facts.label.empty()) << facts.name;
    EXPECT_TRUE(names.insert(facts.name).second) << facts.name << " is there twice";
    EXPECT_EQ(facts.unit.empty(), facts.kind == NumberKind::integer) << facts.name;
  }
}

TEST(Quantities, ColourIfTheyAreOneNumber) {
  for (const QuantityFacts& facts : quantities) {
    EXPECT_EQ(facts.colours(), facts.components == Components::one) << facts.name;
  }
}

TEST(Quantities, OfVectorsHaveOneComponentPerAxis) {
  EXPECT_EQ(components_of(Quantity::velocity, 2), 2U);
  EXPECT_EQ(components_of(Quantity::velocity, 3), 3U);
  EXPECT_EQ(components_of(Quantity::pressure, 3), 1U);
}

TEST(Quantities, AreNamedWithTheirUnits) {
  EXPECT_EQ(name_with_unit(Quantity::density), "density [kg/m^3]");
  EXPECT_EQ(name_with_unit(Quantity::id), "id");
}

TEST(Units, AreTypesetWithRaisedPowers) {
  EXPECT_EQ(typeset("kg/m^3"), "kg/m³");
  EXPECT_EQ(typeset("m^2/s^2"), "m²/s²");
  EXPECT_EQ(typeset("Pa"), "Pa");
  EXPECT_EQ(typeset(""), "");
}

}  // namespace
}  // namespace weir
