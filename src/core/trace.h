// Where a run's time went, for a viewer of traces (chrome://tracing, ui.perfetto.dev): spans of named work on each thread.
//
// Off until started; a span then costs one look at a flag.
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
  // All spans so far, as a JSON object in the Trace Event Format, and an end to recording.
  static std::string finish();
  // Of all spans of this name so far, s.
  static double total(std::string_view name);
  // An end to recording, and nothing is kept.
  static void drop();
  // How this thread is called in the viewer, if it is on. `name` must live for ever.
  static void name_thread(const char* name);

 private:
  friend class Span;
  static std::int64_t now();  // ns
  static void add(const char* name, std::int64_t begin, std::int64_t end);
  static std::atomic<bool> on_;
};

// Recording for the length of a block: whatever ends it, the next one starts with nothing.
class Recording {
 public:
  Recording() { Trace::start(); }
  ~Recording() { Trace::drop(); }
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;
};

// The time from here to the end of the block. `name` must live for ever.
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
