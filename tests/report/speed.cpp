#include "report/speed.h"

#include <gmock/gmock.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace weir {
namespace {

using testing::ElementsAre;

// Times depend on the machine; the table's rows and columns do not.
SpeedOptions smallest() {
  return {.particles = {100, 400}, .developed_particles = 100, .seconds = 1e-3, .real_time_duration = 2e-3};
}

ReportOptions two_threads() {
  ReportOptions options;
  options.threads = 2;
  options.message = [](const std::string&) {};
  return options;
}

// Commas within quotes do not separate.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') quoted = !quoted;
    if (c == ',' && !quoted) {
      cells.emplace_back();
    } else if (c != '"') {
      cells.back() += c;
    }
  }
  return cells;
}

struct Table {
  std::string header;
  std::vector<std::vector<std::string>> rows;

  explicit Table(const std::string& csv) {
    std::istringstream lines(csv);
    std::getline(lines, header);
    for (std::string line; std::getline(lines, line);) rows.push_back(cells_of(line));
  }
  // The first `columns` cells of each row, joined by commas.
  std::vector<std::string> beginnings(std::size_t columns) const {
    std::vector<std::string> result;
    for (const auto& row : rows) {
      std::string text;
      for (std::size_t k = 0; k < columns; ++k) text += (k == 0 ? "" : ",") + row.at(k);
      result.push_back(text);
    }
    return result;
  }
};

void expect_positive(const std::string& cell) {
  const double number = std::stod(cell);
  EXPECT_TRUE(std::isfinite(number) && number > 0) << cell;
}
void expect_share(const std::string& cell) {
  const double number = std::stod(cell);
  EXPECT_TRUE(number >= 0 && number <= 1) << cell;
}

// 10 x 10 and 20 x 20 particles in 2D; in 3D of a box 2 : 1 : 2, 6 x 3 x 6 and 10 x 5 x 10.
TEST(Speed, FigureHasACurvePerDimensionAndThreads) {
  const Table table(csv_of(speed_figure(smallest(), two_threads())));
  EXPECT_EQ(table.header, "case,particles,speed[Mps/s]");
  EXPECT_THAT(table.beginnings(2),
              ElementsAre("WCSPH 2D, 1,100", "WCSPH 2D, 1,400", "WCSPH 2D, 2,100", "WCSPH 2D, 2,400", "WCSPH 3D, 1,108",
                          "WCSPH 3D, 1,500", "WCSPH 3D, 2,108", "WCSPH 3D, 2,500"));
  for (const auto& row : table.rows) expect_positive(row.at(2));
}

TEST(Speed, DevelopedFlowHasARowPerDimensionAndThreads) {
  const Table table(developed_flow_csv(smallest(), two_threads()));
  EXPECT_EQ(table.header,
            "method,dimension,particles,threads,time[s],speed[Mps/s],neighbours_share[1],serial_share[1]");
  EXPECT_THAT(table.beginnings(5),
              ElementsAre("WCSPH,2,100,1,0.6", "WCSPH,2,100,2,0.6", "WCSPH,3,108,1,0.6", "WCSPH,3,108,2,0.6"));
  for (const auto& row : table.rows) {
    ASSERT_EQ(row.size(), 8U);
    expect_positive(row[5]);
    expect_share(row[6]);
    expect_share(row[7]);
  }
}

TEST(Speed, SavingsHaveARowPerOptionalTerm) {
  const Table table(savings_csv(smallest(), two_threads()));
  EXPECT_EQ(table.header, "case,with[steps/s],without[steps/s],saving[1]");
  EXPECT_THAT(table.beginnings(1),
              ElementsAre("2D, viscosity", "2D, surface tension", "2D, walls out of reach", "2D, walls as fluid",
                          "2D, log row in every step", "3D, viscosity", "3D, surface tension", "3D, walls out of reach",
                          "3D, walls as fluid", "3D, log row in every step"));
  for (const auto& row : table.rows) {
    ASSERT_EQ(row.size(), 4U);
    expect_positive(row[1]);
    expect_positive(row[2]);
    EXPECT_LT(std::stod(row[3]), 1) << "1 - with / without";
    EXPECT_TRUE(std::isfinite(std::stod(row[3]))) << row[3];
  }
}

TEST(Speed, MethodsHaveARowPerDimensionMethodAndWall) {
  const Table table(methods_csv(smallest(), two_threads()));
  EXPECT_EQ(table.header, "dimension,method,wall_pressure,wall_slip,particles,step[ms],cost[1]");
  std::vector<std::string> expected;
  for (const char* dimension : {"2", "3"}) {
    for (const char* method : {"wcsph", "delta_sph"}) {
      for (const char* walls :
           {"mirrored,no_slip", "mirrored,free_slip", "extrapolated,no_slip", "extrapolated,free_slip"}) {
        expected.push_back(std::string(dimension) + "," + method + "," + walls);
      }
    }
  }
  EXPECT_EQ(table.beginnings(4), expected);
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const auto& row = table.rows[k];
    ASSERT_EQ(row.size(), 7U);
    EXPECT_EQ(row[4], k < 8 ? "100" : "108");
    expect_positive(row[5]);
    expect_positive(row[6]);
    if (k % 8 == 0) {
      EXPECT_EQ(row[6], "1.000") << "the one that others are compared with";
    }
  }
}

TEST(Speed, RealTimeHasARowPerSceneAndStiffness) {
  const SpeedOptions options = smallest();
  const Table table(real_time_csv(options, two_threads()));
  EXPECT_EQ(table.header, "scene,particles,stiffness[Pa],simulated_time[s],wall_time[s],simulated_per_wall[1]");
  ASSERT_EQ(table.rows.size(), 6U);
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const auto& row = table.rows[k];
    ASSERT_EQ(row.size(), 6U);
    EXPECT_EQ(row[0], k < 3 ? "tower" : "dam_break");
    expect_positive(row[1]);
    EXPECT_DOUBLE_EQ(std::stod(row[2]), std::pow(10, 4 + static_cast<double>(k % 3)));
    EXPECT_DOUBLE_EQ(std::stod(row[3]), options.real_time_duration);
    expect_positive(row[4]);
    expect_positive(row[5]);
  }
}

}  // namespace
}  // namespace weir
