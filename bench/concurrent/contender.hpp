// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include "workload.hpp"

#include <memory>
#include <string>
#include <vector>

namespace pelage::bench {

/// A structure in the race, for one workload. What it needs before the first insert is not timed: prepare() empties
/// it, and takes and touches the memory that the structure lets its user provide.
class contender {
 public:
  virtual ~contender() = default;
  [[nodiscard]] virtual std::string name() const = 0;

  virtual void prepare(const workload& work) = 0;

  /// Inserts [first, last) of the workload from the thread that calls.
  virtual void insert(const workload& work, std::size_t first, std::size_t last) = 0;

  /// Called by each thread before and after its inserts, not timed.
  virtual void enter_thread() {}
  virtual void leave_thread() {}

  /// A number that tells right contents from wrong: the sum over lists of each fragment's id times its place, modulo
  /// 2^64; equal for all contenders that keep the same order. 0 for those that keep none.
  [[nodiscard]] virtual std::uint64_t checksum() const = 0;
};

/// Adds up what contender::checksum() asks for.
class place_sum {
 public:
  void begin_list() { place_ = 0; }
  void add(std::uint32_t id) { sum_ += ++place_ * (id + 1u); }
  [[nodiscard]] std::uint64_t value() const { return sum_; }

 private:
  std::uint64_t place_ = 0;
  std::uint64_t sum_ = 0;
};

/// Contenders that keep every fragment: pelage's a_buffer and ordered_list, and a mutex-guarded sorted vector.
std::vector<std::unique_ptr<contender>> list_contenders();

/// libcds's Michael and lazy lists, with hazard pointers and without reclamation.
std::vector<std::unique_ptr<contender>> libcds_contenders();

/// Contenders that keep K fragments, K in {8, 16, 32}: pelage's atomic_k_buffer, and a
/// spinlock-guarded k_buffer.
std::vector<std::unique_ptr<contender>> slot_contenders(std::uint32_t k);

}  // namespace pelage::bench
