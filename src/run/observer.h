// An output of a run: it looks at the simulation when it is due, writes its files and adds its facts to the manifest.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "output/manifest.h"
#include "sph/simulation.h"

namespace weir {

// All functions are called on the solver's thread, in the order of their declaration. An observer fills its own snapshots,
// since it may hand them to threads of its own.
class Observer {
 public:
  virtual ~Observer() = default;
  Observer() = default;
  Observer(const Observer&) = delete;
  Observer& operator=(const Observer&) = delete;

  // Whether something still starts in the background. The solver steps ahead meanwhile, and look() is called, until an
  // observer has no room.
  virtual bool starting() const { return false; }
  virtual bool has_room() const { return true; }
  // Throws an error of the start.
  virtual void await_start() {}
  // The run's folder is there. Throws OutputError.
  virtual void open(const std::filesystem::path& /*folder*/) {}
  // Facts that are known once it is open.
  virtual void describe(Manifest& /*facts*/) const {}

  // Asked before the first step and after each; look() follows if it is due.
  virtual bool due(const Simulation& simulation) const = 0;
  virtual void look(Simulation& simulation) = 0;
  // An error makes further steps useless; finish() throws it.
  virtual bool failed() const { return false; }
  // Pictures drawn so far, for the progress shown.
  virtual std::int64_t pictures() const { return 0; }

  // Completes the files. `valid` is false after a divergence: the state is of no use then. Throws.
  virtual void finish(Simulation& /*simulation*/, bool /*valid*/) {}
  // Facts that are known at the end.
  virtual void account(Manifest& /*facts*/) const {}
};

using Observers = std::vector<std::unique_ptr<Observer>>;

// The observers that are due look.
inline void look(const Observers& observers, Simulation& simulation) {
  for (const auto& observer : observers) {
    if (observer->due(simulation)) observer->look(simulation);
  }
}

}  // namespace weir
