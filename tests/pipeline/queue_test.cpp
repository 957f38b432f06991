#include "run/queue.h"

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

namespace weir {

namespace {

TEST(Queue, KeepsTheOrder) {
  Queue<int> queue;
  for (int i = 0; i < 3; ++i) queue.push(i);
  queue.close();
  for (int i = 0; i < 3; ++i) EXPECT_EQ(queue.pop(), i);
  EXPECT_EQ(queue.pop(), std::nullopt);
}

TEST(Queue, ReturnsAnItemThatWasPutBackFirst) {
  Queue<int> queue;
  queue.push(1);
  queue.push(2);
  EXPECT_EQ(queue.pop(), 1);
  queue.put_back(1);
  EXPECT_EQ(queue.pop(), 1);
  EXPECT_EQ(queue.pop(), 2);
}

TEST(Queue, WaitsForAnItem) {
  Queue<std::unique_ptr<int>> queue;
  std::thread producer([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    queue.push(std::make_unique<int>(7));
  });
  EXPECT_EQ(**queue.pop(), 7);
  producer.join();
}

TEST(Queue, HandsEveryItemToOneOfManyThreads) {
  constexpr int count = 10000;
  Queue<int> queue;
  std::atomic<long> sum = 0;
  std::vector<std::thread> consumers;
  for (int i = 0; i < 4; ++i) {
    consumers.emplace_back([&] {
      while (const std::optional<int> item = queue.pop()) sum += *item;
    });
  }
  for (int i = 1; i <= count; ++i) queue.push(i);
  queue.close();
  for (std::thread& consumer : consumers) consumer.join();
  EXPECT_EQ(sum, static_cast<long>(count) * (count + 1) / 2);
}

TEST(Queue, WakesAllWaitingThreadsWhenItIsClosed) {
  Queue<int> queue;
  std::vector<std::thread> consumers;
  for (int i = 0; i < 3; ++i) {
    consumers.emplace_back([&] { EXPECT_EQ(queue.pop(), std::nullopt); });
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  queue.close();
  for (std::thread& consumer : consumers) consumer.join();
}

}  // namespace

}  // namespace weir
