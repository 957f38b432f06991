// Particle files hold every bit of a snapshot, and their collection is whole at any moment.
#include "output/particles.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "helpers.h"
#include "output/file.h"
#include "support/particle_file.h"

namespace weir::testing {
namespace {

using test::listed_in_collection;
using test::ParticleFile;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Snapshot sample() {
  Snapshot snapshot;
  snapshot.time = 0.1 + 0.2;
  snapshot.fluid.count = 2;
  snapshot.fluid.positions = {{0.1F, 0.2F, 0}, {1e-30F, -0.0F, 0}};
  snapshot.fluid.fields = {
      {.quantity = Quantity::velocity, .components = 2, .values = std::vector<float>{1.5F, -2, 1e30F, 1.0F / 3}},
      {.quantity = Quantity::density, .components = 1, .values = std::vector<float>{1000.5F, 999}},
      {.quantity = Quantity::id, .components = 1, .values = std::vector<std::int32_t>{7, 2147483647}}};
  return snapshot;
}

TEST(ParticleFile, HoldsPositionsAndFieldsBitForBit) {
  const ParticleFile file(particle_file(sample()));
  EXPECT_TRUE(file.is_closed());
  EXPECT_EQ(file.attribute("VTKFile", "header_type"), "UInt64");
  EXPECT_EQ(file.attribute("Piece", "NumberOfPoints"), "2");
  EXPECT_EQ(file.attribute_of_array("Points", "type"), "Float32");
  EXPECT_THAT(file.values<float>("Points"), ElementsAre(0.1F, 0.2F, 0, 1e-30F, 0, 0));
  EXPECT_THAT(file.values<float>("density"), ElementsAre(1000.5F, 999));
  EXPECT_EQ(file.attribute_of_array("id", "type"), "Int32");
  EXPECT_THAT(file.values<std::int32_t>("id"), ElementsAre(7, 2147483647));
  EXPECT_THAT(file.head(), HasSubstr(">0.30000000000000004</DataArray>"));
}

TEST(ParticleFile, HasVectorsOfThreeComponentsInTwoDimensions) {
  const ParticleFile file(particle_file(sample()));
  EXPECT_EQ(file.attribute_of_array("velocity", "NumberOfComponents"), "3");
  EXPECT_THAT(file.values<float>("velocity"), ElementsAre(1.5F, -2, 0, 1e30F, 1.0F / 3, 0));
}

TEST(ParticleFile, HasACellForEachParticle) {
  const ParticleFile file(particle_file(sample()));
  EXPECT_EQ(file.attribute("Piece", "NumberOfVerts"), "2");
  EXPECT_THAT(file.values<std::int32_t>("connectivity"), ElementsAre(0, 1));
  EXPECT_THAT(file.values<std::int32_t>("offsets"), ElementsAre(1, 2));
}

TEST(ParticleFile, FarFromTheOriginHasDoublesInTheScenesCoordinates) {
  Snapshot snapshot = sample();
  snapshot.origin = {500000, 5000000, 0};
  snapshot.fluid.positions.clear();
  snapshot.fluid.exact_positions = {{0.125, 0.001, 0}, {1, 2, 0}};
  const ParticleFile file(particle_file(snapshot));
  EXPECT_EQ(file.attribute_of_array("Points", "type"), "Float64");
  EXPECT_THAT(file.values<double>("Points"), ElementsAre(500000.125, 5000000.001, 0, 500001, 5000002, 0));
}

TEST(ParticleFile, MayHoldNoParticle) {
  const ParticleFile file(particle_file(Snapshot()));
  EXPECT_TRUE(file.is_closed());
  EXPECT_THAT(file.values<float>("Points"), IsEmpty());
}

class Particles : public FolderTest {
 protected:
  std::vector<std::string> listed(const std::string& attribute) const {
    return listed_in_collection(read_file(folder / "particles.pvd"), attribute);
  }
};

TEST_F(Particles, AreListedAfterEachFile) {
  ParticleWriter writer(folder);
  EXPECT_THAT(listed("file"), IsEmpty());
  Snapshot snapshot = sample();
  writer.write(snapshot);
  EXPECT_THAT(listed("file"), ElementsAre("particles_00000.vtp"));
  EXPECT_EQ(read_file(folder / "particles_00000.vtp"), particle_file(snapshot));
  snapshot.time = 0.5;
  writer.write(snapshot);
  EXPECT_THAT(listed("file"), ElementsAre("particles_00000.vtp", "particles_00001.vtp"));
  EXPECT_THAT(listed("timestep"), ElementsAre("0.30000000000000004", "0.5"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 3);
}

TEST_F(Particles, ListOnlyWholeFilesWhenTheDiskIsFull) {
  ParticleWriter writer(folder);
  writer.write(sample());
  std::string text;
  {
    const FileSizeLimit limit(500);
    text = error_text<OutputError>([&] { writer.write(sample()); });
  }
  EXPECT_THAT(text, HasSubstr("cannot write " + (folder / "particles_00001.vtp").string() + ": File too large"));
  EXPECT_THAT(listed("file"), ElementsAre("particles_00000.vtp"));
  EXPECT_FALSE(std::filesystem::exists(folder / "particles_00001.vtp"));
}

}  // namespace
}  // namespace weir::testing
