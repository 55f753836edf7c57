// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Stands in for <tbb/...> under ThreadSanitizer alone. Debian's libtbb is not built for it, so it takes every task that
// libtbb hands to a thread for a race; with std::thread in libtbb's place, what it reports is ours.
#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <deque>
#include <map>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace tbb {

/// As many threads as the innermost one that lives says, else 4.
class global_control {
 public:
  enum parameter { max_allowed_parallelism };

  global_control(parameter, std::size_t value) : before_(limit.exchange(value)) {}
  ~global_control() { limit = before_; }
  global_control(const global_control&) = delete;
  global_control& operator=(const global_control&) = delete;

  static inline std::atomic<std::size_t> limit{4};

 private:
  std::size_t before_;
};

class task_arena {
 public:
  explicit task_arena(int threads) : threads_(static_cast<std::size_t>(threads)) {}

  template <class Work>
  auto execute(const Work& work) {
    const global_control limit(global_control::max_allowed_parallelism, threads_);
    return work();
  }

 private:
  std::size_t threads_;
};

template <class Index>
class blocked_range {
 public:
  blocked_range(Index begin, Index end, std::size_t grain = 1) : begin_(begin), end_(end), grain_(grain) {}
  [[nodiscard]] Index begin() const { return begin_; }
  [[nodiscard]] Index end() const { return end_; }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }
  [[nodiscard]] std::size_t grainsize() const { return grain_; }

 private:
  Index begin_, end_;
  std::size_t grain_;
};

/// Threads take blocks of an eighth of their share or of the grain, whichever is less, as they come.
template <class Index, class Body>
void parallel_for(const blocked_range<Index>& all, const Body& body) {
  const std::size_t count = all.size();
  const std::size_t threads = global_control::limit;
  const std::size_t block = std::max<std::size_t>(1, std::min(all.grainsize(), count / (8 * threads)));
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next.fetch_add(block); i < count; i = next.fetch_add(block)) {
      const std::size_t end = std::min(count, i + block);
      body(blocked_range<Index>(all.begin() + static_cast<Index>(i), all.begin() + static_cast<Index>(end)));
    }
  };
  std::vector<std::jthread> others;
  for (std::size_t t = 1; t < std::min(threads, count); ++t)
    others.emplace_back(work);
  work();
}

template <class Index, class Body>
void parallel_for(Index begin, Index end, const Body& body) {
  parallel_for(blocked_range<Index>(begin, std::max(begin, end), 64), [&](const blocked_range<Index>& some) {
    for (Index i = some.begin(); i < some.end(); ++i)
      body(i);
  });
}

template <class Value>
class enumerable_thread_specific {
 public:
  enumerable_thread_specific() = default;
  enumerable_thread_specific(enumerable_thread_specific&& other) noexcept
      : mine_(std::move(other.mine_)), values_(std::move(other.values_)) {}  // which moves no value

  [[nodiscard]] Value& local() {
    const std::lock_guard lock(mutex_);
    Value*& mine = mine_[std::this_thread::get_id()];
    if (mine == nullptr) mine = &values_.emplace_back();
    return *mine;
  }
  [[nodiscard]] std::size_t size() const { return values_.size(); }
  [[nodiscard]] auto begin() { return values_.begin(); }
  [[nodiscard]] auto end() { return values_.end(); }
  [[nodiscard]] auto begin() const { return values_.begin(); }
  [[nodiscard]] auto end() const { return values_.end(); }

 private:
  std::mutex mutex_;
  std::map<std::thread::id, Value*> mine_;
  std::deque<Value> values_;
};

}  // namespace tbb
