#include "run/run.h"

#include <fmt/format.h>

#include <optional>
#include <utility>
#include <vector>

#include "core/sha256.h"
#include "core/trace.h"
#include "run/run_folder.h"
#include "run/session.h"
#include "scene/check.h"

namespace weir {

namespace {

void refuse_wrong_scene(const Scene& scene) {
  std::vector<SceneMistake> mistakes;
  for (Violation& violation : check(scene)) mistakes.push_back({violation.path, std::move(violation.message)});
  if (!mistakes.empty()) throw SceneError(std::move(mistakes));
}

}  // namespace

RunResult run(const Scene& scene, const RunOptions& options) {
  if (!options.checked) refuse_wrong_scene(scene);
  RunFolder folder(options.folder.empty() ? std::filesystem::path("out") / scene.name : options.folder, scene);
  std::string text = effective_scene_text(scene);
  const Provenance provenance{sha256(text), WEIR_VERSION};
  if (!options.force && folder.holds_finished(provenance)) {
    RunResult result;
    result.folder = folder.path();
    result.was_there = true;
    result.message = fmt::format("{} holds the identical finished run already", folder.path().string());
    return result;
  }
  folder.refuse_other_run(options.force);
  std::optional<Recording> recording;
  if (options.trace) {
    recording.emplace();
    Trace::name_thread("solver");
  }
  Session session(scene, options, folder, std::move(text), provenance);
  session.open();
  return session.play();
}

}  // namespace weir
