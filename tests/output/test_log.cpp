#include "output/log.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "core/error.h"
#include "helpers.h"

namespace weir::testing {
namespace {

using ::testing::HasSubstr;

class Log : public FolderTest {
 protected:
  std::filesystem::path file() const { return folder / "log.csv"; }
};

Diagnostics sample() {
  Diagnostics row;
  row.time = 0.1 + 0.2;
  row.simulated_time = 0.25;
  row.step = 1234567890123;
  row.dt = 1.0 / 3;
  row.limit = StepLimit::acoustic;
  row.cfl = 0.4;
  row.max_speed = 2;
  row.mean_density_error = -1e-7;
  row.mean_compression = 5e-324;
  row.max_density_error = 0.01;
  row.kinetic_energy = 1e22;
  row.potential_energy = -0.0;
  row.momentum = {1.5, -2.5, 3.5};
  row.center_of_mass = {0.5, 0.25, 0.125};
  return row;
}

TEST(LogHeader, NamesColumnsAndUnits) {
  EXPECT_EQ(log_header(2),
            "time[s],step,dt[s],cfl[1],max_speed[m/s],mean_density_error[1],mean_compression[1],max_density_error[1],"
            "kinetic_energy[J],potential_energy[J],momentum_x[kg*m/s],momentum_y[kg*m/s],simulated_time[s],limit,"
            "center_of_mass_x[m],center_of_mass_y[m]");
  EXPECT_EQ(log_header(3),
            "time[s],step,dt[s],cfl[1],max_speed[m/s],mean_density_error[1],mean_compression[1],max_density_error[1],"
            "kinetic_energy[J],potential_energy[J],momentum_x[kg*m/s],momentum_y[kg*m/s],momentum_z[kg*m/s],"
            "simulated_time[s],limit,center_of_mass_x[m],center_of_mass_y[m],center_of_mass_z[m]");
}

TEST(LogRow, HasTheShortestNumbersThatReadBackTheSame) {
  EXPECT_EQ(log_row(sample(), 2),
            "0.30000000000000004,1234567890123,0.3333333333333333,0.4,2,-1e-07,5e-324,0.01,1e+22,-0,1.5,-2.5,0.25,"
            "acoustic,0.5,0.25");
  EXPECT_EQ(log_row(sample(), 3),
            "0.30000000000000004,1234567890123,0.3333333333333333,0.4,2,-1e-07,5e-324,0.01,1e+22,-0,1.5,-2.5,3.5,0.25,"
            "acoustic,0.5,0.25,0.125");
  EXPECT_EQ(std::strtod("0.3333333333333333", nullptr), 1.0 / 3);
}

TEST(LogRow, WritesNanAndInfinity) {
  Diagnostics row = sample();
  row.max_speed = std::numeric_limits<double>::quiet_NaN();
  row.cfl = std::numeric_limits<double>::infinity();
  EXPECT_THAT(log_row(row, 2), HasSubstr(",inf,nan,"));
}

TEST_F(Log, HasCompleteRowsAtAnyMoment) {
  LogWriter log(file(), 2);
  std::string expected = log_header(2) + '\n';
  EXPECT_EQ(content_of(file()), expected);
  for (int i = 0; i < 3; ++i) {
    log.write(sample());
    expected += log_row(sample(), 2) + '\n';
    EXPECT_EQ(content_of(file()), expected);  // while open
  }
  log.close();
  EXPECT_EQ(content_of(file()), expected);
}

TEST_F(Log, EndsWithACompleteRowOnAFullDisk) {
  LogWriter log(file(), 2);
  const std::size_t header = log_header(2).size() + 1;
  const std::size_t row = log_row(sample(), 2).size() + 1;
  std::string text;
  {
    const FileSizeLimit limit(header + 2 * row + row / 2);
    log.write(sample());
    log.write(sample());
    text = error_text<OutputError>([&] { log.write(sample()); });
  }
  EXPECT_THAT(text, HasSubstr("log.csv: File too large"));
  EXPECT_EQ(content_of(file()).size(), header + 2 * row);
  log.write(sample());  // there is room again
  EXPECT_EQ(content_of(file()).size(), header + 3 * row);
}

}  // namespace
}  // namespace weir::testing
