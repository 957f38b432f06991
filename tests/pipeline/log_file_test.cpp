#include "run/log_file.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "pipeline/temporary_folder.h"

namespace weir {

namespace {

std::vector<double> times_logged(double every, const std::vector<double>& times) {
  const TemporaryFolder folder;
  LogFile log(folder / "log.csv", every);
  for (const double time : times) {
    if (!log.due(time)) continue;
    Diagnostics row;
    row.time = time;
    log.write(row);
  }
  std::istringstream lines(read_text_file(folder / "log.csv"));
  std::vector<double> logged;
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) logged.push_back(std::stod(line));
  return logged;
}

TEST(LogFile, HasARowAtTheStart) { EXPECT_EQ(times_logged(0.1, {0.0, 0.05}), std::vector<double>{0.0}); }

TEST(LogFile, HasARowOnceAMultipleIsPassed) {
  EXPECT_EQ(times_logged(0.1, {0.0, 0.09, 0.13, 0.17, 0.199, 0.21, 0.55, 0.59, 0.6}),
            (std::vector<double>{0.0, 0.13, 0.21, 0.55, 0.6}));
}

TEST(LogFile, KnowsAMultipleInItsLastBits) {
  // 3 * 0.1 is 0.30000000000000004; a landing at 0.3 is the same instant.
  EXPECT_EQ(times_logged(0.1, {0.0, 0.1, 0.2, 0.3, 0.35}), (std::vector<double>{0.0, 0.1, 0.2, 0.3}));
}

TEST(LogFile, HasARowAtEveryMultipleOfAFrameTime) {
  std::vector<double> landings;
  for (int frame = 0; frame <= 600; ++frame) landings.push_back(frame / 60.0);
  EXPECT_EQ(times_logged(1.0 / 60.0, landings), landings);
}

TEST(LogFile, NamesAndUnitsStandInTheHeader) {
  const TemporaryFolder folder;
  LogFile log(folder / "log.csv", 1);
  const std::string header = read_text_file(folder / "log.csv");
  EXPECT_TRUE(
      header.starts_with("time[s],step,dt[s],cfl[1],max_speed[m/s],mean_density_error[1],mean_compression[1],"
                         "max_density_error[1],kinetic_energy[J],potential_energy[J],momentum_x[kg m/s]"))
      << header;
  Diagnostics row;
  log.write(row);
  const std::string text = read_text_file(folder / "log.csv");
  const std::string written = text.substr(header.size());
  EXPECT_EQ(std::count(header.begin(), header.end(), ','), std::count(written.begin(), written.end(), ','));
}

TEST(LogFile, KeepsTheLargestDensityErrorOfAllRows) {
  const TemporaryFolder folder;
  LogFile log(folder / "log.csv", 1);
  for (const double error : {0.01, 0.03, 0.02}) {
    Diagnostics row;
    row.max_density_error = error;
    log.write(row);
  }
  EXPECT_EQ(log.max_density_error(), 0.03);
}

}  // namespace

}  // namespace weir
