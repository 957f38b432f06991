// A thread pool for parallel loops.
//
// Not OpenMP: its idle threads spin for long and would occupy cores that drawing and encoding need (a loop that shared
// two cores took three times as long). Idle threads of this pool sleep in the kernel after a short spin, and a loop
// that ends before a thread has woken does not wait for it.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace weir {

// Number of processors in the affinity mask of the process.
int processors();

// `requested` if positive, else OMP_NUM_THREADS, else processors(). Results never depend on it.
int thread_count(int requested);

class ThreadPool {
 public:
  // Name of loops in a trace. The part of a step outside them runs on one thread.
  static constexpr const char* loop_span = "loop of the thread pool";

  explicit ThreadPool(int threads);  // the caller counts as one
  ~ThreadPool();
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;

  int size() const { return static_cast<int>(helpers_.size()) + 1; }
  // Limits the threads of the following loops, the caller included; the others sleep.
  void use_at_most(int threads) { most_helpers_ = static_cast<std::size_t>(std::max(threads - 1, 0)); }

  // The following loops leave `others` processors, read at the start of each loop, to other threads of the process.
  // `others` must outlive the loops.
  void give_way_to(const std::atomic<int>& others);

  // Runs the tasks body(k), 0 <= k < count, each once, in any order and on any thread; returns when all are done. The
  // body must not throw and must not use this pool.
  template <class Body>
  void for_each(std::size_t count, const Body& body) {
    run(
        count, [](const void* object, std::size_t k) { (*static_cast<const Body*>(object))(k); }, &body);
  }

 private:
  using Call = void (*)(const void* object, std::size_t k);
  void run(std::size_t count, Call call, const void* object);
  void run_tasks(std::size_t first_chunk);
  void help(std::size_t chunk);

  // The current loop; written only while open_ is false and inside_ is zero.
  Call call_ = nullptr;
  const void* object_ = nullptr;
  std::size_t wanted_ = 0;  // helpers
  // Each thread starts with a chunk of tasks of its own, the same in every loop of this count, whose data are then
  // still in its cache; afterwards it takes tasks that are left in other chunks.
  struct alignas(64) Chunk {
    std::atomic<std::size_t> next{0};
    std::size_t end = 0;
  };
  std::vector<Chunk> chunks_;

  std::atomic<bool> open_{false};
  std::atomic<int> inside_{0};  // helpers that run, or may run, tasks of it
  std::atomic<int> loops_{0};   // incremented to wake helpers; an int, as the futex system call takes
  std::atomic<bool> ending_{false};
  const std::atomic<int>* others_ = nullptr;
  int processors_ = 0;
  std::size_t most_helpers_ = static_cast<std::size_t>(-1);
  std::vector<std::thread> helpers_;
};

}  // namespace weir
