// Trace of a run: named spans of time on each thread, for viewers of the Trace Event Format (chrome://tracing,
// ui.perfetto.dev). While tracing is off a span costs one atomic load.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>

namespace weir {

class Trace {
 public:
  static void start();
  static bool on() { return on_.load(std::memory_order_relaxed); }
  // Ends the recording; returns all spans as a JSON object in the Trace Event Format.
  static std::string finish();
  // Sum of the spans of this name so far, s.
  static double total(std::string_view name);
  // Ends the recording and discards all spans.
  static void drop();
  // Sets the name of this thread in the viewer, while recording. `name` must have static lifetime.
  static void name_thread(const char* name);

 private:
  friend class Span;
  static std::int64_t now();  // ns
  static void add(const char* name, std::int64_t begin, std::int64_t end);
  static std::atomic<bool> on_;
};

// Records for the length of a block. However the block ends, the next recording starts empty.
class Recording {
 public:
  Recording() { Trace::start(); }
  ~Recording() { Trace::drop(); }
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
};

// A span from construction to the end of the block. `name` must have static lifetime.
class Span {
 public:
  explicit Span(const char* name) : name_(Trace::on() ? name : nullptr), begin_(name_ != nullptr ? Trace::now() : 0) {}
  ~Span() {
    if (name_ != nullptr) Trace::add(name_, begin_, Trace::now());
  }
  Span(const Span&) = delete;
  Span& operator=(const Span&) = delete;

 private:
  const char* name_;
  std::int64_t begin_;
};

}  // namespace weir
