#include "output/manifest.h"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "output/file.h"

namespace weir {

namespace {

using Json = nlohmann::ordered_json;

// JSON knows neither NaN nor infinity: they become null, which reads back as NaN.
void read(const Json& json, const char* name, double& value) {
  const auto found = json.find(name);
  if (found == json.end()) return;
  value = found->is_null() ? std::numeric_limits<double>::quiet_NaN() : found->get<double>();
}

template <class T>
void read(const Json& json, const char* name, T& value) {
  if (const auto found = json.find(name); found != json.end()) found->get_to(value);
}

// Both directions from one list of names.
void visit_fields(auto& manifest, const auto& visit) {
  visit("version", manifest.version);
  visit("scene_sha256", manifest.scene_sha256);
  visit("state_hash", manifest.state_hash);
  visit("dimension", manifest.dimension);
  visit("particles", manifest.particles);
  visit("steps", manifest.steps);
  visit("simulated_time_s", manifest.simulated_time_s);
  visit("frames", manifest.frames);
  visit("threads", manifest.threads);
  visit("wall_time_s", manifest.wall_time_s);
  visit("particle_steps_per_second", manifest.particle_steps_per_second);
  visit("gl_renderer", manifest.gl_renderer);
  visit("encoder", manifest.encoder);
  visit("max_density_error", manifest.max_density_error);
  visit("instruction_set", manifest.instruction_set);
  visit("exit", manifest.exit);
}
void visit_particles(auto& particles, const auto& visit) {
  visit("fluid", particles.fluid);
  visit("wall", particles.wall);
}
void visit_wall_time(auto& time, const auto& visit) {
  visit("total", time.total);
  visit("setup", time.setup);
  visit("neighbours", time.neighbours);
  visit("solve", time.solve);
  visit("render", time.render);
  visit("encode", time.encode);
  visit("write", time.write);
}

struct ToJson {
  Json& json;

  template <class T>
  void operator()(const char* name, const T& value) const {
    json[name] = value;
  }
  void operator()(const char* name, const Manifest::Particles& particles) const {
    visit_particles(particles, ToJson{json[name]});
  }
  void operator()(const char* name, const Manifest::WallTime& time) const { visit_wall_time(time, ToJson{json[name]}); }
  void operator()(const char* name, const std::optional<ExitCode>& exit) const {
    json[name] = exit ? Json(static_cast<int>(*exit)) : Json(nullptr);
  }
};

struct FromJson {
  const Json& json;

  const Json& object(const char* name) const {
    const Json& value = json.at(name);
    if (!value.is_object()) throw OutputError(fmt::format("{} is not an object", name));
    return value;
  }

  template <class T>
  void operator()(const char* name, T& value) const {
    read(json, name, value);
  }
  void operator()(const char* name, Manifest::Particles& particles) const {
    if (json.contains(name)) visit_particles(particles, FromJson{object(name)});
  }
  void operator()(const char* name, Manifest::WallTime& time) const {
    if (json.contains(name)) visit_wall_time(time, FromJson{object(name)});
  }
  void operator()(const char* name, std::optional<ExitCode>& exit) const {
    const auto found = json.find(name);
    if (found != json.end() && !found->is_null()) exit = static_cast<ExitCode>(found->get<int>());
  }
};

}  // namespace

void write_manifest(const std::filesystem::path& file, const Manifest& manifest) {
  Json json;
  visit_fields(manifest, ToJson{json});
  write_file(file, json.dump(2) + '\n');
}

Manifest read_manifest(const std::filesystem::path& file) {
  const std::string text = read_file(file);
  try {
    const Json json = Json::parse(text);
    if (!json.is_object()) throw OutputError("not an object");
    Manifest manifest;
    visit_fields(manifest, FromJson{json});
    return manifest;
  } catch (const std::exception& error) {
    throw OutputError(fmt::format("cannot read {}: no manifest of a run: {}", file.string(), error.what()));
  }
}

}  // namespace weir
