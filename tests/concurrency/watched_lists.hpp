// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/order/unrolled_list.hpp>

#include <pelage/explore/watched.hpp>

#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace pelage::explore {

/// How threads come to their nodes.
enum class pool : std::uint8_t {
  shared,  ///< from the library's counter, watched like every other cell
  apart,   ///< each thread from its own share: node numbers are only names, so this keeps all that a list does while
           ///< it spares the orders in which threads could have asked the counter
};

inline std::string show_link(std::uint64_t link) {
  return link == no_node() ? "-" : '#' + std::to_string(link);
}

/// list_storage of watched cells: one list, as many nodes as threads may ask for.
class watched_lists {
 public:
  watched_lists(pool kind, std::uint32_t capacity, std::uint32_t threads)
      : pool_(kind), share_(capacity / threads), taken_("taken"), refused_("refused"), own_taken_(threads, 0u) {
    links_.reserve(capacity + 1);
    nodes_.reserve(capacity);
    links_.emplace_back("head", no_node(), &show_link);
    for (std::uint32_t n = 0; n < capacity; ++n) {
      const std::string number = std::to_string(n);
      links_.emplace_back("next of #" + number, no_node(), &show_link);
      nodes_.emplace_back("node #" + number, no_fragment());
    }
  }

  [[nodiscard]] std::uint32_t list_count() const { return 1u; }
  [[nodiscard]] std::uint32_t node_capacity() const { return static_cast<std::uint32_t>(nodes_.size()); }

  [[nodiscard]] std::uint32_t load_link(std::uint32_t link, std::memory_order order) const {
    return inside(link) ? links_[link].load(order) : no_node();
  }
  void store_link(std::uint32_t link, std::uint32_t node, std::memory_order order) {
    if (inside(link)) {
      links_[link].store(node, order);
    }
  }
  std::uint32_t exchange_link(std::uint32_t link, std::uint32_t node, std::memory_order order) {
    return inside(link) ? links_[link].exchange(node, order) : no_node();
  }
  std::uint32_t compare_exchange_link(std::uint32_t link, std::uint32_t expected, std::uint32_t desired,
                                      std::memory_order order) {
    if (inside(link)) {
      links_[link].compare_exchange_strong(expected, desired, order, std::memory_order_relaxed);
    }
    return expected;
  }

  [[nodiscard]] std::uint32_t load_taken(std::memory_order order) const {
    return pool_ == pool::shared ? taken_.load(order) : 0u;
  }
  std::uint32_t add_taken(std::memory_order order) {
    if (pool_ == pool::shared) {
      return taken_.fetch_add(1u, order);
    }
    const auto t = static_cast<std::uint32_t>(world::current().thread());
    return t * share_ + own_taken_[t]++;
  }
  std::uint32_t add_taken_nodes(std::uint32_t count, std::memory_order order) {
    if (pool_ == pool::shared) {
      return taken_.fetch_add(count, order);
    }
    const auto t = static_cast<std::uint32_t>(world::current().thread());
    return t * share_ + std::exchange(own_taken_[t], own_taken_[t] + count);
  }
  void add_refused(std::memory_order order) { refused_.fetch_add(1u, order); }

  void store_taken(std::uint32_t count) { taken_.store(count, std::memory_order_relaxed); }
  void store_refused(std::uint32_t count) { refused_.store(count, std::memory_order_relaxed); }
  [[nodiscard]] std::uint32_t load_refused() const { return refused_.load(std::memory_order_relaxed); }

  /// A thread has done all its inserts.
  void done() {}

  /// What stands between the last insert and a reader of the second phase.
  void wait_for_others() { join_others(); }

  /// The list as its latest stores have it, and the nodes that no link leads to yet, each with its own link.
  [[nodiscard]] std::string draw() const;

  [[nodiscard]] fragment read_node(std::uint32_t node) const {
    return inside(node + 1u) ? nodes_[node].read() : no_fragment();
  }
  void write_node(std::uint32_t node, fragment f) {
    if (inside(node + 1u)) {
      nodes_[node].write(f);
    }
  }

 private:
  /// A link that is none, as a list in disorder may ask for, is a fault rather than an access out of bounds.
  [[nodiscard]] bool inside(std::uint32_t link) const {
    expect(link < links_.size(), "a link leads out of the pool");
    return link < links_.size();
  }

  pool pool_;
  std::uint32_t share_;
  watched_atomic<std::uint32_t> taken_;
  watched_atomic<std::uint32_t> refused_;
  std::vector<watched_atomic<std::uint32_t>> links_;
  std::vector<watched_field<fragment>> nodes_;
  std::vector<std::uint32_t> own_taken_;
};

static_assert(unrolled_list::block_storage<watched_lists>);

inline std::string watched_lists::draw() const {
  std::ostringstream text;
  std::vector<bool> linked(nodes_.size(), false);
  const auto latest = [this](std::uint32_t link) {
    return static_cast<std::uint32_t>(world::current().memory().latest(links_[link].location()));
  };
  const auto show = [&](std::uint32_t n) {
    const fragment f = nodes_[n].peek();
    text << " -> #" << n << '(' << f.depth << ", " << f.id << ')';
  };
  text << "head";
  std::uint32_t node = latest(0u);
  for (; node < nodes_.size() && !linked[node]; node = latest(node + 1u)) {
    linked[node] = true;
    show(node);
  }
  text << (node == no_node() ? "" : " -> " + show_link(node) + " again");
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
    if (!linked[n] && is_fragment(nodes_[n].peek())) {
      text << " | not yet:";
      show(n);
      text << " -> " << show_link(latest(n + 1u));
    }
  }
  return text.str();
}

}  // namespace pelage::explore
