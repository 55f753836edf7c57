// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/order/a_buffer.hpp>
#include <pelage/order/ordered_list.hpp>
#include <pelage/order/unrolled_list.hpp>

#include "concurrency/inserts.hpp"
#include "concurrency/watched_lists.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace pelage::explore {

/// What the threads of a list's test do.
struct list_work {
  explore::inserts inserts;    ///< of each inserting thread, in its order
  std::uint32_t readers = 0;   ///< threads that walk the list meanwhile, twice each
  bool walks = false;          ///< each inserting thread walks the list at its end
  bool joined_reader = false;  ///< one more thread, that walks it when the others are done
  pool nodes = pool::shared;
  std::uint32_t capacity = 0xffffffffu;  ///< of the pool; by default as many as there are inserts
  std::uint32_t limit = ordered_list::unlimited();
  std::uint32_t block = 1;  ///< inserts at once, of the structure that takes several
};

inline std::vector<fragment> all_of(const list_work& work) {
  std::vector<fragment> all;
  for (const auto& some : work.inserts) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

inline void sort_fragments(std::vector<fragment>& some) {
  std::sort(some.begin(), some.end(), [](fragment a, fragment b) { return before(a, b); });
}

/// The library's ordered_list as a list's test calls it.
struct ordered_inserts {
  static constexpr bool sorted = true;
  template <class Storage>
  static fragment insert(Storage& storage, fragment f, std::uint32_t limit) {
    return ordered_list::insert(storage, 0u, f, limit);
  }
  template <class Storage>
  static std::uint32_t next(const Storage& storage, std::uint32_t node) {
    return ordered_list::next(storage, node);
  }
};

/// The same for the library's a_buffer.
struct unordered_inserts {
  static constexpr bool sorted = false;
  template <class Storage>
  static fragment insert(Storage& storage, fragment f, std::uint32_t) {
    return a_buffer::push(storage, 0u, f);
  }
  template <class Storage>
  static std::uint32_t next(const Storage& storage, std::uint32_t node) {
    return a_buffer::next(storage, node);
  }
};

/// The library's unrolled_list, to which a thread pushes several fragments at once.
struct block_inserts {
  static constexpr bool sorted = false;
  /// How many of the fragments, the first ones, are in the list; the others are counted.
  template <class Storage>
  static std::uint32_t insert_block(Storage& storage, std::span<const fragment> some) {
    const auto wanted = static_cast<std::uint32_t>(some.size());
    const unrolled_list::node_block block = unrolled_list::take(storage, wanted);
    for (std::uint32_t i = 0; i < wanted; ++i) {
      if (i < block.size) {
        storage.write_node(block.first + i, some[i]);
      } else {
        storage.add_refused(std::memory_order_relaxed);
      }
    }
    unrolled_list::push(storage, 0u, block);
    return block.size;
  }
  template <class Storage>
  static std::uint32_t next(const Storage& storage, std::uint32_t node) {
    return unrolled_list::next(storage, node);
  }
};

/// An algorithm whose inserts come in blocks.
template <class Algorithm>
concept takes_blocks = requires(watched_lists& storage, std::span<const fragment> some) {
  Algorithm::insert_block(storage, some);
};

/// Inserts and readers on one list, and everything that the library promises of it.
///
/// Storage: watched_lists, or one that derives from it and plants a fault.
template <class Algorithm, class Storage = watched_lists>
class list_program : public program {
 public:
  explicit list_program(const list_work& work)
      : work_(work),
        inserters_(static_cast<int>(work.inserts.size())),
        storage_(work.nodes, capacity_of(work), static_cast<std::uint32_t>(work.inserts.size())),
        own_(work.inserts.size()),
        returned_(work.inserts.size()) {}

  [[nodiscard]] int threads() const override {
    return inserters_ + static_cast<int>(work_.readers) + (work_.joined_reader ? 1 : 0);
  }

  void thread(int t) override {
    if (t < inserters_) {
      insert_all(static_cast<std::size_t>(t));
    } else if (t < inserters_ + static_cast<int>(work_.readers)) {
      read_twice();
    } else {
      storage_.wait_for_others();
      walk walked;
      read(walked);
      check_content(walked);
    }
  }

  void finish() override {
    walk walked;
    read(walked);
    check_content(walked);
  }

  [[nodiscard]] std::string draw() const override;

 private:
  /// A walk along the list; no vector, since a reader's stack is dropped when a schedule is given up.
  struct walk {
    std::array<fragment, 16> seen{};
    std::size_t length = 0;
    [[nodiscard]] bool has(fragment f) const {
      return std::any_of(seen.begin(), seen.begin() + static_cast<std::ptrdiff_t>(length),
                         [f](fragment g) { return same(f, g); });
    }
  };

  static std::uint32_t capacity_of(const list_work& work) {
    std::size_t most = 0;
    for (const auto& some : work.inserts) {
      most = std::max(most, some.size());
    }
    const std::size_t inserts = work.nodes == pool::apart ? most * work.inserts.size() : all_of(work).size();
    return std::min(work.capacity, static_cast<std::uint32_t>(inserts));
  }

  void insert_all(std::size_t t);
  void insert_blocks(std::size_t t);
  void read(walk& walked);
  void read_twice();
  void check_order(const walk& walked);
  void check_content(const walk& walked);
  [[nodiscard]] bool offered(fragment f) const {
    const std::vector<fragment> all = all_of(work_);
    return std::any_of(all.begin(), all.end(), [f](fragment g) { return same(f, g); });
  }

  list_work work_;
  int inserters_;
  Storage storage_;
  std::vector<std::uint32_t> own_;       ///< inserts that each thread has completed
  std::vector<std::uint32_t> returned_;  ///< of those, how many came back
};

template <class Algorithm, class Storage = watched_lists>
program_factory list_test(const list_work& work) {
  return [work] { return std::make_unique<list_program<Algorithm, Storage>>(work); };
}

// ---------------------------------------------------------------------------------------------------------

template <class Algorithm, class Storage>
void list_program<Algorithm, Storage>::insert_all(std::size_t t) {
  if constexpr (takes_blocks<Algorithm>) {
    insert_blocks(t);
  } else {
    for (const fragment f : work_.inserts[t]) {
      const fragment back = Algorithm::insert(storage_, f, work_.limit);
      const bool entered = !is_fragment(back) && back.depth == no_fragment().depth;
      expect(entered || same(back, f), "an insert returns neither none nor what was offered");
      ++own_[t];
      returned_[t] += entered ? 0u : 1u;
      completed();
    }
  }
  storage_.done();
  if (work_.walks) {
    walk own;
    read(own);
    for (const fragment f : work_.inserts[t]) {
      expect(own.has(f), "a thread does not see what it inserted itself");
    }
    check_order(own);
    completed();
  }
}

template <class Algorithm, class Storage>
void list_program<Algorithm, Storage>::insert_blocks(std::size_t t) {
  std::span<const fragment> left = work_.inserts[t];
  while (!left.empty()) {
    const std::size_t size = std::min<std::size_t>(work_.block, left.size());
    const std::uint32_t entered = Algorithm::insert_block(storage_, left.first(size));
    own_[t] += static_cast<std::uint32_t>(size);
    returned_[t] += static_cast<std::uint32_t>(size) - entered;
    left = left.subspan(size);
    completed();
  }
}

template <class Algorithm, class Storage>
void list_program<Algorithm, Storage>::read(walk& walked) {
  std::uint32_t node = ordered_list::first(storage_, 0u);
  while (node != no_node()) {
    if (walked.length == walked.seen.size()) {
      expect(false, "a list runs in a circle");
      return;
    }
    walked.seen[walked.length++] = storage_.read_node(node);
    node = Algorithm::next(storage_, node);
  }
}

template <class Algorithm, class Storage>
void list_program<Algorithm, Storage>::read_twice() {
  walk once;
  walk twice;
  read(once);
  completed();
  read(twice);
  completed();
  for (std::size_t i = 0; i < once.length; ++i) {
    expect(twice.has(once.seen[i]), "a reader loses a node that it has seen");
  }
  check_order(once);
  check_order(twice);
}

template <class Algorithm, class Storage>
void list_program<Algorithm, Storage>::check_order(const walk& walked) {
  for (std::size_t i = 0; i < walked.length; ++i) {
    expect(offered(walked.seen[i]), "a reader sees a fragment that nobody inserts");
    expect(i == 0 || before(walked.seen[i - 1], walked.seen[i]), "a reader sees a list out of order");
  }
}

template <class Algorithm, class Storage>
void list_program<Algorithm, Storage>::check_content(const walk& walked) {
  std::vector<fragment> all = all_of(work_);
  std::vector<fragment> held(walked.seen.begin(), walked.seen.begin() + static_cast<std::ptrdiff_t>(walked.length));
  sort_fragments(all);
  if (Algorithm::sorted) {
    for (std::size_t i = 1; i < held.size(); ++i) {
      expect(before(held[i - 1], held[i]), "the list is out of order");
    }
  }
  sort_fragments(held);
  std::uint32_t back = 0;
  for (const std::uint32_t n : returned_) {
    back += n;
  }
  expect(held.size() + back == all.size(), "a fragment is lost, or there twice");
  expect(std::includes(all.begin(), all.end(), held.begin(), held.end(),
                       [](fragment a, fragment b) { return before(a, b); }),
         "the list holds a fragment that nobody inserted, or one twice");
  const std::uint32_t capacity = storage_.node_capacity();
  if (work_.limit == ordered_list::unlimited()) {
    expect(held.size() == std::min<std::size_t>(all.size(), capacity),
           "a node of the pool is left while one comes back");
    expect(storage_.load_refused() == back, "the count of refused fragments is wrong");
  } else {
    for (std::size_t i = 0; i < std::min<std::size_t>(work_.limit, all.size()); ++i) {
      expect(i < held.size() && same(held[i], all[i]), "one of the `limit` nearest is missing");
    }
  }
  if (work_.nodes == pool::shared) {
    expect(storage_.load_taken(std::memory_order_relaxed) <= capacity + work_.block * work_.inserts.size(),
           "the pool's counter goes more than one insert a thread beyond the pool");
  }
}

template <class Algorithm, class Storage>
std::string list_program<Algorithm, Storage>::draw() const {
  return storage_.draw();
}

}  // namespace pelage::explore
