// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/explore/watched.hpp>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace pelage::explore {

/// A program made of a state and one function a thread, for the small ones of which a test wants many.
///
/// State is default constructible and holds the watched cells; finish may check it.
template <class State>
class bodies : public program {
 public:
  using body = void (*)(State&);

  bodies(std::vector<body> threads, body finish) : threads_(std::move(threads)), finish_(finish) {}

  [[nodiscard]] int threads() const override { return static_cast<int>(threads_.size()); }
  void thread(int t) override { threads_[static_cast<std::size_t>(t)](state_); }
  void finish() override {
    if (finish_ != nullptr) {
      finish_(state_);
    }
  }

 private:
  State state_;
  std::vector<body> threads_;
  body finish_;
};

template <class State>
program_factory of_bodies(std::vector<void (*)(State&)> threads, void (*finish)(State&) = nullptr) {
  return [=] { return std::make_unique<bodies<State>>(threads, finish); };
}

}  // namespace pelage::explore
