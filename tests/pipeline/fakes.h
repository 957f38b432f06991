// Solver, renderer and encoder that count their calls, and fail on request: they test how the stages of a run work
// together, without OpenGL.
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace weir {

struct FakeBehaviour {
  std::int64_t particles = 1;
  std::int64_t diverge_in_step = -1;
  bool no_device = false;
  std::chrono::milliseconds device_time{0};  // until there is one, or none
  bool no_encoder = false;
  std::int64_t draw_fails_at = -1;    // frame
  std::int64_t encode_fails_at = -1;  // frame
  std::int64_t png_fails_at = -1;     // frame
  bool finish_fails = false;
  std::chrono::milliseconds step_time{0};
  std::chrono::milliseconds draw_time{0};
  std::chrono::milliseconds encode_time{0};
};

struct FakeRecord {
  std::vector<std::int64_t> drawn;    // frames, in the order of drawing
  std::vector<std::int64_t> encoded;  // likewise, as read from the pixels
  std::multiset<std::string> pngs;    // file names
  std::int64_t filled = 0;            // frames that the solver has handed over
  std::int64_t steps = 0;
  std::int64_t steps_ahead = 0;  // of the solver when the device had started
  std::int64_t most_ahead = 0;   // of the solver before the encoder, in frames
  int most_at_once = 0;          // stages at work at one moment
  std::set<int> others_at_work;  // threads to give way to, read at the start of each step
  std::thread::id renderer_thread;
  bool drawn_elsewhere = false;  // on another thread than the renderer was made on
  bool movie_made = false;
  bool movie_finished = false;
};

// Sets the behaviour of the next run; resets the record.
void behave(const FakeBehaviour& behaviour);
// After the run.
const FakeRecord& record();

}  // namespace weir
