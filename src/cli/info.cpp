#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/commands.h"
#include "core/thread_pool.h"
#include "output/sink.h"
#include "render/renderer.h"
#include "simd/instruction_set.h"

namespace weir {

namespace {

struct Facts {
  std::string processor;
  std::vector<std::string> features;               // of the processor, among those that matter to a solver
  std::string_view instruction_set;                // that the solver uses
  std::vector<std::string_view> instruction_sets;  // that it could
  int threads = 0;
  std::vector<DeviceTrial> devices;
  std::string device_error;
  std::vector<std::string> encoders;
  std::string encoder_error;
};

void read_processor(Facts& facts) {
  std::ifstream file("/proc/cpuinfo");
  std::string line;
  while (std::getline(file, line) && !line.empty()) {  // the first processor
    const std::size_t colon = line.find(": ");
    if (colon == std::string::npos) continue;
    if (line.starts_with("model name")) facts.processor = line.substr(colon + 2);
    if (!line.starts_with("flags") && !line.starts_with("Features")) continue;
    std::istringstream flags(line.substr(colon + 2));
    for (std::string flag; flags >> flag;) {
      for (const std::string_view known : {"sse2", "sse4_2", "avx", "avx2", "fma", "avx512f", "asimd", "sve"}) {
        if (flag == known) facts.features.push_back(flag);
      }
    }
  }
}

Facts gather() {
  Facts facts;
  read_processor(facts);
  facts.instruction_set = name_of(default_instruction_set());
  for (const InstructionSet set : usable_instruction_sets()) facts.instruction_sets.push_back(name_of(set));
  facts.threads = thread_count(0);
  try {
    facts.devices = list_devices();
  } catch (const std::exception& error) {
    facts.device_error = error.what();
  }
  try {
    facts.encoders = list_encoders();
  } catch (const std::exception& error) {
    facts.encoder_error = error.what();
  }
  return facts;
}

// The one that `auto` takes: the first that works.
int chosen_device(const Facts& facts) {
  for (std::size_t i = 0; i < facts.devices.size(); ++i) {
    if (facts.devices[i].usable) return static_cast<int>(i);
  }
  return -1;
}

void print_text(const Facts& facts) {
  fmt::print("weir        {}\n", WEIR_VERSION);
  fmt::print("processor   {}\n", facts.processor.empty() ? "unknown" : facts.processor);
  fmt::print("solver      {} instructions (of {})\n", facts.instruction_set, fmt::join(facts.instruction_sets, ", "));
  fmt::print("features    {}\n", fmt::join(facts.features, " "));
  fmt::print("threads     {}\n", facts.threads);
  const int chosen = chosen_device(facts);
  if (chosen < 0) fmt::print("OpenGL      none usable: no pictures can be drawn\n");
  if (!facts.device_error.empty()) fmt::print("            {}\n", facts.device_error);
  for (std::size_t i = 0; i < facts.devices.size(); ++i) {
    const DeviceTrial& trial = facts.devices[i];
    fmt::print("device {:<4} {}: {}: {}\n", fmt::format("{}{}", i, static_cast<int>(i) == chosen ? "*" : ""),
               trial.name, trial.usable ? "usable" : "not usable", trial.detail);
  }
  if (chosen >= 0) fmt::print("            * is chosen by --gl-device auto\n");
  if (facts.encoder_error.empty()) {
    fmt::print("encoders    {}\n", facts.encoders.empty() ? "none: no movie can be written"
                                                          : fmt::format("{}", fmt::join(facts.encoders, " ")));
  } else {
    fmt::print("encoders    none: {}\n", facts.encoder_error);
  }
}

void print_json(const Facts& facts) {
  using Json = nlohmann::ordered_json;
  const auto error_or_null = [](const std::string& text) { return text.empty() ? Json() : Json(text); };
  const int chosen = chosen_device(facts);
  Json json;
  json["version"] = WEIR_VERSION;
  json["processor"] = facts.processor;
  json["features"] = facts.features;
  json["instruction_set"] = facts.instruction_set;
  json["instruction_sets"] = facts.instruction_sets;
  json["threads"] = facts.threads;
  json["devices"] = Json::array();
  for (const DeviceTrial& trial : facts.devices) {
    json["devices"].push_back({{"name", trial.name}, {"usable", trial.usable}, {"detail", trial.detail}});
  }
  json["device_error"] = error_or_null(facts.device_error);
  json["chosen_device"] = chosen < 0 ? Json() : Json(chosen);
  json["gl_renderer"] = chosen < 0 ? Json() : Json(facts.devices[static_cast<std::size_t>(chosen)].detail);
  json["encoders"] = facts.encoders;
  json["encoder_error"] = error_or_null(facts.encoder_error);
  fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

void add_info(CLI::App& program, Action& action) {
  CLI::App* command = program.add_subcommand("info", "List threads, OpenGL devices and encoders of this machine");
  const auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "As a JSON object");
  command->callback([&action, json] {
    action = [json] {
      const Facts facts = gather();
      *json ? print_json(facts) : print_text(facts);
      return ExitCode::done;
    };
  });
}

}  // namespace weir
