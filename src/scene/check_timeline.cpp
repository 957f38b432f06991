#include <algorithm>
#include <array>

#include "scene/checker.h"
#include "scene/settings.h"

namespace weir {

namespace {

std::string event_path(std::size_t i) { return fmt::format("timeline.{}", i); }

std::array<bool, parameter_count> parameters_in(const Settings& set) {
  std::array<bool, parameter_count> result{};
  for_each_setting([&](const auto& row) {
    if (set.*row.value) result[static_cast<std::size_t>(row.parameter)] = true;
  });
  return result;
}

bool sets_any(const Settings& set) {
  const auto sets = parameters_in(set);
  return std::find(sets.begin(), sets.end(), true) != sets.end();
}

// An event that does something, at a time that comes, to terms that the scene has.
void check_event(Checker& checker, const TimelineEvent& event, const std::string& path) {
  const Scene& scene = checker.scene;
  if (checker.usable(path + ".at", "duration") && event.at > scene.duration) {
    checker.add(path + ".at", fmt::format("lies beyond the duration of {} s, got {}", number_text(scene.duration),
                                          number_text(event.at)));
  }
  if (!checker.usable(path + ".set")) return;
  if (!sets_any(event.set) && !event.reset && !event.pause && checker.usable(path)) {
    checker.add(path, "does nothing; give it set, reset or pause");
  }
  if (!sets_any(event.set) && event.over > 0) checker.add(path + ".over", "needs settings to change, in `set`");
  if (event.set.viscosity && checker.usable("fluid.viscosity.model") &&
      scene.fluid.viscosity.model == ViscosityModel::none) {
    checker.add(path + ".set.fluid.viscosity.kinematic", "has no effect: fluid.viscosity.model is none");
  }
  if (event.set.surface_tension && checker.usable("fluid.surface_tension.model") &&
      scene.fluid.surface_tension.model == SurfaceTensionModel::none) {
    checker.add(path + ".set.fluid.surface_tension.coefficient", "has no effect: fluid.surface_tension.model is none");
  }
  if (event.set.stiffness && event.set.sound_speed) {
    checker.add(path + ".set.solver.sound_speed", "stands beside solver.stiffness; give one of them");
  }
}

// Until when a setting is taken.
struct Taken {
  std::string path;  // empty: never set
  double from = 0;
  double until = 0;
};

}  // namespace

void check_timeline(Checker& checker) {
  const std::vector<TimelineEvent>& events = checker.scene.timeline;
  std::array<Taken, parameter_count> taken;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const TimelineEvent& event = events[i];
    const std::string path = event_path(i);
    check_event(checker, event, path);
    if (!checker.usable(path)) continue;
    if (i > 0 && checker.usable(event_path(i - 1)) && event.at < events[i - 1].at) {
      checker.add(path + ".at", fmt::format("lies before {}.at; events stand in the order of time", event_path(i - 1)));
      continue;
    }
    const auto sets = parameters_in(event.set);
    for (std::size_t k = 0; k < sets.size(); ++k) {
      if (!sets[k]) continue;
      Taken& last = taken[k];
      if (!last.path.empty() && (event.at < last.until || event.at == last.from)) {
        checker.add(path + ".at", fmt::format("is {} s, when {} still changes the same setting (until {} s)",
                                              number_text(event.at), last.path, number_text(last.until)));
        break;
      }
      last = {path, event.at, event.at + event.over};
    }
  }
}

}  // namespace weir
