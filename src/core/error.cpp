#include "core/error.h"

#include <fmt/format.h>

namespace weir {

namespace {

std::string joined(const std::vector<SceneMistake>& mistakes) {
  std::string text;
  for (const SceneMistake& mistake : mistakes) {
    if (!text.empty()) text += '\n';
    text += fmt::format("{}: error: {}", mistake.where, mistake.message);
  }
  return text;
}

}  // namespace

SceneError::SceneError(std::vector<SceneMistake> all) : std::runtime_error(joined(all)), mistakes(std::move(all)) {}

}  // namespace weir
