#include "core/thread_pool.h"

#include <sched.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string_view>

#include "core/trace.h"

namespace weir {

namespace {

// Waking a helper pays from this many tasks on.
constexpr std::size_t tasks_per_helper = 2;

// Polls before a thread sleeps: some 10 us, as long as waking takes. Steps of few particles are a chain of short loops.
constexpr int polls = 200;

void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

// Waits until `value` differs from `old`.
void await_change(const std::atomic<int>& value, int old) {
  for (int poll = 0; poll < polls; ++poll) {
    if (value.load(std::memory_order_acquire) != old) return;
    pause();
  }
  value.wait(old);
}

}  // namespace

int processors() {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) return std::max(1, CPU_COUNT(&allowed));
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

int thread_count(int requested) {
  if (requested > 0) return requested;
  if (const char* text = std::getenv("OMP_NUM_THREADS")) {
    const std::string_view view(text);
    int count = 0;
    // A list "4,2" gives levels of nesting; the first number is that of outer loops.
    const auto [end, error] = std::from_chars(view.data(), view.data() + view.size(), count);
    if (error == std::errc() && count > 0 && (end == view.data() + view.size() || *end == ',')) return count;
  }
  return processors();
}

ThreadPool::ThreadPool(int threads) : chunks_(static_cast<std::size_t>(std::max(threads, 1))) {
  for (std::size_t k = 1; k < chunks_.size(); ++k) helpers_.emplace_back([this, k] { help(k); });
}

ThreadPool::~ThreadPool() {
  ending_ = true;
  ++loops_;
  loops_.notify_all();
  for (std::thread& helper : helpers_) helper.join();
}

void ThreadPool::give_way_to(const std::atomic<int>& others) {
  others_ = &others;
  processors_ = processors();
}

void ThreadPool::run(std::size_t count, Call call, const void* object) {
  const Span span(loop_span);
  std::size_t wanted = std::min({helpers_.size(), most_helpers_, count / tasks_per_helper});
  if (others_ != nullptr) wanted = std::min(wanted, static_cast<std::size_t>(std::max(processors_ - *others_ - 1, 0)));
  if (wanted == 0) {
    for (std::size_t k = 0; k < count; ++k) call(object, k);
    return;
  }
  call_ = call;
  object_ = object;
  wanted_ = wanted;
  for (std::size_t k = 0; k < chunks_.size(); ++k) {
    chunks_[k].next = count * k / chunks_.size();
    chunks_[k].end = count * (k + 1) / chunks_.size();
  }
  open_ = true;
  ++loops_;
  if (wanted == helpers_.size()) {
    loops_.notify_all();
  } else {
    for (std::size_t k = 0; k < wanted; ++k) loops_.notify_one();
  }
  run_tasks(0);
  // A helper increments inside_ and then reads open_; here open_ is cleared and then inside_ is read. In this
  // sequentially consistent order either the helper sees the loop closed, or it is waited for here.
  open_ = false;
  for (int inside = inside_; inside != 0; inside = inside_) await_change(inside_, inside);
}

void ThreadPool::run_tasks(std::size_t first_chunk) {
  for (std::size_t n = 0; n < chunks_.size(); ++n) {
    Chunk& chunk = chunks_[(first_chunk + n) % chunks_.size()];
    for (std::size_t k = chunk.next++; k < chunk.end; k = chunk.next++) call_(object_, k);
  }
}

void ThreadPool::help(std::size_t chunk) {
  int seen = 0;
  while (true) {
    await_change(loops_, seen);
    seen = loops_;
    if (ending_) return;
    const int number = ++inside_;
    if (open_ && static_cast<std::size_t>(number) <= wanted_) run_tasks(chunk);
    --inside_;
    inside_.notify_one();
  }
}

}  // namespace weir
