#include "core/thread_pool.h"

#include <sched.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string_view>

#include "core/trace.h"

namespace weir {

namespace {

// A helper is worth waking for at least this many turns.
constexpr std::size_t turns_per_helper = 2;

// How often a thread looks again before it sleeps: some 10 us, as long as waking takes. Steps of few particles are a chain
// of short loops.
constexpr int looks = 200;

void pause() {
#if defined(__x86_64__)
  __builtin_ia32_pause();
#endif
}

// Waits until `value` is no longer `old`.
void await_change(const std::atomic<int>& value, int old) {
  for (int look = 0; look < looks; ++look) {
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
    // A list "4,2" means nested loops: the first number is ours.
    const auto [end, error] = std::from_chars(view.data(), view.data() + view.size(), count);
    if (error == std::errc() && count > 0 && (end == view.data() + view.size() || *end == ',')) return count;
  }
  return processors();
}

ThreadPool::ThreadPool(int threads) : shares_(static_cast<std::size_t>(std::max(threads, 1))) {
  for (std::size_t k = 1; k < shares_.size(); ++k) helpers_.emplace_back([this, k] { help(k); });
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
  std::size_t wanted = std::min({helpers_.size(), most_helpers_, count / turns_per_helper});
  if (others_ != nullptr) wanted = std::min(wanted, static_cast<std::size_t>(std::max(processors_ - *others_ - 1, 0)));
  if (wanted == 0) {
    for (std::size_t k = 0; k < count; ++k) call(object, k);
    return;
  }
  call_ = call;
  object_ = object;
  wanted_ = wanted;
  for (std::size_t k = 0; k < shares_.size(); ++k) {
    shares_[k].next = count * k / shares_.size();
    shares_[k].end = count * (k + 1) / shares_.size();
  }
  open_ = true;
  ++loops_;
  if (wanted == helpers_.size()) {
    loops_.notify_all();
  } else {
    for (std::size_t k = 0; k < wanted; ++k) loops_.notify_one();
  }
  take_turns(0);
  // A helper first counts itself inside and then looks whether the loop is open; this closes it and then looks for helpers
  // inside. In that order (sequentially consistent), either it sees the loop closed or it is waited for here.
  open_ = false;
  for (int inside = inside_; inside != 0; inside = inside_) await_change(inside_, inside);
}

void ThreadPool::take_turns(std::size_t first_share) {
  for (std::size_t n = 0; n < shares_.size(); ++n) {
    Share& share = shares_[(first_share + n) % shares_.size()];
    for (std::size_t k = share.next++; k < share.end; k = share.next++) call_(object_, k);
  }
}

void ThreadPool::help(std::size_t share) {
  int seen = 0;
  while (true) {
    await_change(loops_, seen);
    seen = loops_;
    if (ending_) return;
    const int place = ++inside_;
    if (open_ && static_cast<std::size_t>(place) <= wanted_) take_turns(share);
    --inside_;
    inside_.notify_one();
  }
}

}  // namespace weir
