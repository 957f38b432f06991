// How the stages of a run hand work to each other.
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace weir {

// First in, first out, between threads. It has no limit of its own: its items are buffers from a pool of fixed size, which
// is another queue, so a stage that falls behind stops its predecessor at the pool.
template <class T>
class Queue {
 public:
  void push(T item) {
    {
      const std::lock_guard lock(mutex_);
      items_.push_back(std::move(item));
    }
    changed_.notify_one();
  }

  // The next to be taken: of a pool the buffer that is most likely still in a cache.
  void put_back(T item) {
    {
      const std::lock_guard lock(mutex_);
      items_.push_front(std::move(item));
    }
    changed_.notify_one();
  }

  // Waits for an item; none once the queue is closed and empty.
  std::optional<T> pop() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return closed_ || !items_.empty(); });
    if (items_.empty()) return std::nullopt;
    std::optional<T> item(std::move(items_.front()));
    items_.pop_front();
    return item;
  }

  // Whether nothing waits at this moment.
  bool empty() const {
    const std::lock_guard lock(mutex_);
    return items_.empty();
  }

  // No item will follow.
  void close() {
    {
      const std::lock_guard lock(mutex_);
      closed_ = true;
    }
    changed_.notify_all();
  }

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<T> items_;
  bool closed_ = false;
};

}  // namespace weir
