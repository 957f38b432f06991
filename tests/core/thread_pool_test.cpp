#include "core/thread_pool.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <mutex>
#include <numeric>
#include <set>
#include <thread>
#include <vector>

#include "core/parallel.h"

namespace weir {
namespace {

TEST(ThreadPool, RunsEveryTaskOnce) {
  for (const int threads : {1, 2, 3, 8}) {
    ThreadPool pool(threads);
    for (const std::size_t count : {0, 1, 2, 3, 17, 1000}) {
      std::vector<int> runs(count, 0);
      pool.for_each(count, [&](std::size_t k) { ++runs[k]; });
      EXPECT_EQ(runs, std::vector<int>(count, 1)) << threads << " threads, " << count << " tasks";
    }
  }
}

// A helper of one loop must not reach into the next: each loop's data goes out of scope at once.
TEST(ThreadPool, RunsManyShortLoopsAfterEachOther) {
  ThreadPool pool(4);
  std::size_t total = 0;
  for (std::size_t loop = 0; loop < 20000; ++loop) {
    std::vector<std::size_t> runs(8 + loop % 5, 0);
    pool.for_each(runs.size(), [&](std::size_t k) { runs[k] = k + 1; });
    total += std::accumulate(runs.begin(), runs.end(), std::size_t{0});
  }
  EXPECT_EQ(total, 4000 * (36 + 45 + 55 + 66 + 78));
}

TEST(ThreadPool, UsesAtMostTheThreadsAllowed) {
  ThreadPool pool(4);
  pool.use_at_most(2);
  std::atomic<int> at_once{0};
  std::atomic<int> most{0};
  std::vector<int> runs(200, 0);
  for (int loop = 0; loop < 20; ++loop) {
    pool.for_each(runs.size(), [&](std::size_t k) {
      const int now = ++at_once;
      for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) {
      }
      std::this_thread::sleep_for(std::chrono::microseconds(20));
      ++runs[k];
      --at_once;
    });
  }
  EXPECT_EQ(most, 2);
  EXPECT_THAT(runs, testing::Each(20));
  pool.use_at_most(1);
  const std::thread::id caller = std::this_thread::get_id();
  pool.for_each(runs.size(), [&](std::size_t k) { runs[k] = std::this_thread::get_id() == caller ? 1 : 0; });
  EXPECT_THAT(runs, testing::Each(1));
}

TEST(ThreadPool, LeavesProcessorsToOthersWhileTheyAreAtWork) {
  ThreadPool pool(processors());
  std::atomic<int> others{0};
  pool.give_way_to(others);
  const auto threads_at_work = [&] {
    std::mutex mutex;
    std::set<std::thread::id> seen;
    pool.for_each(200, [&](std::size_t) {
      std::this_thread::sleep_for(std::chrono::microseconds(100));
      const std::lock_guard lock(mutex);
      seen.insert(std::this_thread::get_id());
    });
    return static_cast<int>(seen.size());
  };
  EXPECT_EQ(threads_at_work(), processors());
  for (const int busy : {1, processors(), processors() + 3}) {
    others = busy;
    EXPECT_EQ(threads_at_work(), std::max(processors() - busy, 1)) << busy;
  }
  others = 0;
  EXPECT_EQ(threads_at_work(), processors());
}

TEST(ThreadPool, AReductionHasTheSameBitsForAnySize) {
  std::vector<double> values(100'000);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = 1.0 / static_cast<double>(i + 1);
  const auto sum = [&](int threads) {
    ThreadPool pool(threads);
    return parallel_reduce(
        values.size(), pool, 0.0,
        [&](std::size_t begin, std::size_t end) {
          return std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(begin),
                                 values.begin() + static_cast<std::ptrdiff_t>(end), 0.0);
        },
        [](double a, double b) { return a + b; });
  };
  const double one = sum(1);
  EXPECT_NEAR(one, 12.090146129863428, 1e-9);  // the harmonic number H_100000
  for (const int threads : {2, 3, 8}) EXPECT_EQ(sum(threads), one);
}

TEST(ThreadCount, PrefersTheRequestThenTheEnvironment) {
  setenv("OMP_NUM_THREADS", "5", 1);
  EXPECT_EQ(thread_count(3), 3);
  EXPECT_EQ(thread_count(0), 5);
  setenv("OMP_NUM_THREADS", "4,2", 1);
  EXPECT_EQ(thread_count(0), 4);
  for (const char* nonsense : {"many", "-1", "0", ""}) {
    setenv("OMP_NUM_THREADS", nonsense, 1);
    EXPECT_GE(thread_count(0), 1) << nonsense;
  }
  unsetenv("OMP_NUM_THREADS");
  EXPECT_GE(thread_count(0), 1);
}

}  // namespace
}  // namespace weir
