#include "run/manifest.h"

#include <nlohmann/json.hpp>

#include "run/text_file.h"

namespace weir {

namespace {

using Json = nlohmann::ordered_json;

Json text_or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

}  // namespace

std::string to_json(const Manifest& manifest) {
  const WallTimes& wall = manifest.wall_time;
  const double solving = wall.neighbours + wall.solve;
  Json json;
  json["version"] = manifest.version;
  json["scene"] = manifest.scene;
  json["scene_sha256"] = manifest.scene_sha256;
  json["state_hash"] = manifest.state_hash;
  json["dimension"] = manifest.dimension;
  json["particles"] = {{"fluid", manifest.fluid_particles}, {"wall", manifest.wall_particles}};
  json["steps"] = manifest.steps;
  json["time_s"] = manifest.time;
  json["simulated_time_s"] = manifest.simulated_time;
  json["frames"] = manifest.frames;
  json["threads"] = manifest.threads;
  json["wall_time_s"] = {{"total", wall.total}, {"setup", wall.setup},   {"neighbours", wall.neighbours},
                         {"solve", wall.solve}, {"render", wall.render}, {"encode", wall.encode},
                         {"write", wall.write}};
  json["particle_steps_per_second"] =
      solving > 0 ? static_cast<double>(manifest.fluid_particles) * static_cast<double>(manifest.steps) / solving : 0;
  json["gl_renderer"] = text_or_null(manifest.gl_renderer);
  json["encoder"] = text_or_null(manifest.encoder);
  json["movie"] = text_or_null(manifest.movie);
  json["max_density_error"] = manifest.max_density_error;
  json["instruction_set"] = manifest.instruction_set;
  json["exit"] = static_cast<int>(manifest.exit);
  json["message"] = manifest.message;
  // Texts of the system (file names, drivers) need not be UTF-8; the manifest must be.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<PastRun> read_past_run(const std::filesystem::path& manifest_file) {
  const Json json = Json::parse(read_text_file(manifest_file), nullptr, false);
  try {
    PastRun past;
    past.version = json.at("version");
    past.scene_sha256 = json.at("scene_sha256");
    if (json.at("movie").is_string()) past.movie = json.at("movie");
    past.exit = json.at("exit");
    past.steps = json.at("steps");
    past.wall_time = json.at("wall_time_s").at("total");
    return past;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace weir
