// Threads that share the work of a loop.
//
// Not OpenMP, whose waiting threads spin long: beside the threads that draw and encode they would take the very cores that
// the loop needs (three times slower with the cores shared, measured on two). These soon wait in the kernel, and a loop that
// ends before a thread has woken does not wait for it.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace weir {

// That this process may run on.
int processors();

// `requested` if positive, else OMP_NUM_THREADS, else the processors this process may run on. Results never depend on it.
int thread_count(int requested);

class ThreadPool {
 public:
  // How loops are called in a trace: what of a step is in none of them, one thread does alone.
  static constexpr const char* loop_span = "loop of the thread pool";

  explicit ThreadPool(int threads);  // the caller counts as one
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  int size() const { return static_cast<int>(helpers_.size()) + 1; }
  // From the next loop on, at most so many threads work, the caller among them; the others sleep.
  void use_at_most(int threads) { most_helpers_ = static_cast<std::size_t>(std::max(threads - 1, 0)); }

  // From the next loop on, as many processors as `others` says at its start are left to them. It must outlive the loops.
  void give_way_to(const std::atomic<int>& others);

  // body(k) for each k of 0 .. count, once, in any order and on any thread; returns when all are done. The body must not
  // throw, and must not use this pool.
  template <class Body>
  void for_each(std::size_t count, const Body& body) {
    run(
        count, [](const void* object, std::size_t k) { (*static_cast<const Body*>(object))(k); }, &body);
  }

 private:
  using Call = void (*)(const void* object, std::size_t k);
  void run(std::size_t count, Call call, const void* object);
  void take_turns(std::size_t first_share);
  void help(std::size_t share);

  // The loop under way; written only while it is closed and nobody is inside.
  Call call_ = nullptr;
  const void* object_ = nullptr;
  std::size_t wanted_ = 0;  // helpers
  // Each thread has a share of the turns, the same in every loop of so many, and then takes what others have left: what it
  // worked on in the last loop is still in its cache.
  struct alignas(64) Share {
    std::atomic<std::size_t> next{0};
    std::size_t end = 0;
  };
  std::vector<Share> shares_;

  std::atomic<bool> open_{false};
  std::atomic<int> inside_{0};  // helpers that are, or may be, at work on it
  std::atomic<int> loops_{0};   // counts up to wake helpers; int is what the kernel can wait on itself
  std::atomic<bool> ending_{false};
  const std::atomic<int>* others_ = nullptr;
  int processors_ = 0;
  std::size_t most_helpers_ = static_cast<std::size_t>(-1);
  std::vector<std::thread> helpers_;
};

}  // namespace weir
