// Figures and tables of the papers and of the studies, made by running the shipped scenes.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "render/renderer.h"

namespace weir {

struct ReportOptions {
  std::filesystem::path folder;
  int threads = 0;                                  // as for thread_count()
  DeviceChoice device;                              // draws the stills
  std::function<void(const std::string&)> message;  // one line for the user
};

// Figures 4.1, 4.2, 7.2, 7.3, 7.4 and 8.1 of J. Hinsch, A Simple 2D SPH Fluid Solver, University of Freiburg, 2024, as
// figure_4_1.csv, .svg, .pdf and .png and so on in the folder. Throws OutputError, DeviceError, SimulationError.
void report_hinsch2024(const ReportOptions& options);

// Speed of the solver on this machine: by dimension, particle number and threads (speed.csv, .svg, .pdf, .png), in
// developed flow (developed_flow.csv), scenes of Hinsch 2024 against real time (real_time.csv), cost of methods and
// walls (methods.csv), savings of absent terms (savings.csv). Takes some minutes; other load falsifies it.
void report_speed(const ReportOptions& options);

}  // namespace weir
