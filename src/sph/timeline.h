// Hinsch's sliders and buttons, headless: what is in force at an instant of run time.
#pragma once

#include <cstddef>

#include "scene/scene.h"

namespace weir {

// Follows the scene's events in their order. Settings start from the scene's own values.
class Timeline {
 public:
  explicit Timeline(const Scene& scene);

  // Brings everything up to run time `time` (s, never decreasing). Returns whether an event asked for a reset since the
  // last call.
  bool advance_to(double time);

  const Parameters& state() const { return state_; }
  bool paused() const { return paused_; }

 private:
  void start(const TimelineEvent& event);

  const Scene* scene_;
  std::size_t next_ = 0;
  Parameters state_;
  bool paused_ = false;

  // A change under way, one per setting: from its value at the start to the one asked for.
  template <class T>
  struct Ramp {
    double start = 0, length = 0;  // s
    T from{}, to{};
    bool active = false;
    void begin(const TimelineEvent& event, const T& now, const T& target);
    void apply(double time, T& value);
  };
  Ramp<Vec3> gravity_;
  Ramp<double> viscosity_, surface_tension_, stiffness_;
};

}  // namespace weir
