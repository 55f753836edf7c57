// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <boost/context/detail/fcontext.hpp>

#include <cstddef>
#include <memory>

#if defined(__SANITIZE_ADDRESS__)
#define PELAGE_EXPLORE_ASAN 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define PELAGE_EXPLORE_ASAN 1
#endif
#endif
#ifdef PELAGE_EXPLORE_ASAN
#include <sanitizer/asan_interface.h>
#include <sanitizer/common_interface_defs.h>
#endif

namespace pelage::explore {

/// A logical thread: a stack of its own inside the one thread of the system.
///
/// A fiber that is never resumed again is simply dropped: nothing on its stack is destroyed, since the code under
/// test may be noexcept and cannot be unwound. So what runs on it owns nothing.
class fiber {
 public:
  using body = void (*)(void* argument);

  /// Lets the next resume() enter `run`. Whatever ran before on this stack is dropped.
  void start(body run, void* argument) {
    if (!stack_) {
      stack_ = std::make_unique<std::byte[]>(stack_size);
    }
#ifdef PELAGE_EXPLORE_ASAN
    ASAN_UNPOISON_MEMORY_REGION(stack_.get(), stack_size);
#endif
    run_ = run;
    argument_ = argument;
    finished_ = false;
    inside_ = boost::context::detail::make_fcontext(stack_.get() + stack_size, stack_size, &fiber::enter);
  }

  /// Runs it until it pauses or ends. Called from outside.
  void resume() {
    start_switch(&fake_stack_outside_, stack_.get(), stack_size);
    inside_ = boost::context::detail::jump_fcontext(inside_, this).fctx;
    finish_switch(fake_stack_outside_, nullptr, nullptr);
  }

  /// Goes back to whoever resumed it. Called from inside.
  void pause() {
    start_switch(finished_ ? nullptr : &fake_stack_inside_, outside_stack_, outside_stack_size_);
    outside_ = boost::context::detail::jump_fcontext(outside_, nullptr).fctx;
    finish_switch(fake_stack_inside_, &outside_stack_, &outside_stack_size_);
  }

  [[nodiscard]] bool finished() const {
    return finished_;
  }

 private:
  static constexpr std::size_t stack_size = 64 * 1024;

  static void enter(boost::context::detail::transfer_t from) {
    fiber& self = *static_cast<fiber*>(from.data);
    self.outside_ = from.fctx;
    finish_switch(nullptr, &self.outside_stack_, &self.outside_stack_size_);
    self.run_(self.argument_);
    self.finished_ = true;
    self.pause();
  }

#ifdef PELAGE_EXPLORE_ASAN
  static void start_switch(void** save, const void* bottom, std::size_t size) {
    __sanitizer_start_switch_fiber(save, bottom, size);
  }
  static void finish_switch(void* saved, const void** bottom, std::size_t* size) {
    __sanitizer_finish_switch_fiber(saved, bottom, size);
  }
#else
  static void start_switch(void**, const void*, std::size_t) {
  }
  static void finish_switch(void*, const void**, std::size_t*) {
  }
#endif

  std::unique_ptr<std::byte[]> stack_;
  boost::context::detail::fcontext_t inside_ = nullptr;
  boost::context::detail::fcontext_t outside_ = nullptr;
  body run_ = nullptr;
  void* argument_ = nullptr;
  bool finished_ = true;
  void* fake_stack_outside_ = nullptr;
  void* fake_stack_inside_ = nullptr;
  const void* outside_stack_ = nullptr;
  std::size_t outside_stack_size_ = 0;
};

}  // namespace pelage::explore
