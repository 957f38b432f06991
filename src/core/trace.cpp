#include "core/trace.h"

#include <fmt/format.h>

#include <chrono>
#include <map>
#include <mutex>
#include <vector>

namespace weir {

namespace {

struct Event {
  const char* name;
  std::int64_t begin;  // ns
  std::int64_t end;
  int thread;
};

// Spans are at least tens of microseconds apart: one lock for all threads has negligible cost.
std::mutex mutex;
std::vector<Event> events;
std::map<int, const char*> thread_names;
std::int64_t started;

int this_thread() {
  static std::atomic<int> threads{0};
  thread_local const int number = ++threads;
  return number;
}

}  // namespace

std::atomic<bool> Trace::on_{false};

std::int64_t Trace::now() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

void Trace::start() {
  const std::lock_guard lock(mutex);
  events.clear();
  started = now();
  on_ = true;
}

void Trace::add(const char* name, std::int64_t begin, std::int64_t end) {
  const std::lock_guard lock(mutex);
  events.push_back({name, begin, end, this_thread()});
}

double Trace::total(std::string_view name) {
  const std::lock_guard lock(mutex);
  std::int64_t sum = 0;
  for (const Event& event : events) sum += event.name == name ? event.end - event.begin : 0;
  return 1e-9 * static_cast<double>(sum);
}

void Trace::drop() {
  on_ = false;
  const std::lock_guard lock(mutex);
  events.clear();
  thread_names.clear();
}

void Trace::name_thread(const char* name) {
  if (!on()) return;
  const std::lock_guard lock(mutex);
  thread_names[this_thread()] = name;
}

std::string Trace::finish() {
  on_ = false;
  const std::lock_guard lock(mutex);
  std::string json = "{\"displayTimeUnit\": \"ms\", \"traceEvents\": [\n";
  const char* separator = "";
  for (const auto& [thread, name] : thread_names) {
    json += fmt::format(R"({}{{"name": "thread_name", "ph": "M", "pid": 1, "tid": {}, "args": {{"name": "{}"}}}})",
                        separator, thread, name);
    separator = ",\n";
  }
  for (const Event& event : events) {
    json += fmt::format(R"({}{{"name": "{}", "ph": "X", "pid": 1, "tid": {}, "ts": {:.3f}, "dur": {:.3f}}})", separator,
                        event.name, event.thread, 1e-3 * static_cast<double>(event.begin - started),
                        1e-3 * static_cast<double>(event.end - event.begin));
    separator = ",\n";
  }
  events.clear();
  thread_names.clear();
  return json + "\n]}\n";
}

}  // namespace weir
