#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "cli/commands.h"
#include "cli/scene_options.h"
#include "cli/terminal.h"
#include "render/renderer.h"
#include "report/report.h"

namespace weir {

namespace {

const std::map<std::string, void (*)(const ReportOptions&)>& reports() {
  static const std::map<std::string, void (*)(const ReportOptions&)> table{{"hinsch2024", report_hinsch2024},
                                                                           {"speed", report_speed}};
  return table;
}

struct ReportCommand {
  std::string name;
  std::string folder;
  int threads = 0;
  std::string device;
};

ExitCode write_report(const ReportCommand& options) {
  ReportOptions report;
  report.folder = options.folder.empty() ? std::filesystem::path("out/report") / options.name
                                         : std::filesystem::path(options.folder);
  report.threads = options.threads;
  report.device = device_choice(options.device);
  report.message = say;
  reports().at(options.name)(report);
  fmt::print("{}\n", report.folder.string());
  return ExitCode::done;
}

}  // namespace

void add_report(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand("report", "Figures and tables of the studies, as CSV, SVG and PNG");
  const auto options = std::make_shared<ReportCommand>();
  command->add_option("name", options->name, "Which: hinsch2024 or speed")
      ->type_name("NAME")
      ->required()
      ->check(CLI::IsMember(&reports()).description(""));
  command->add_option("-o,--output", options->folder, "Folder to write; default: out/report/<name>")->type_name("DIR");
  add_threads(*command, options->threads);
  add_gl_device(*command, options->device);
  command->callback([&action, options] { action = [options] { return write_report(*options); }; });
}

}  // namespace weir
