// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include "frame/order/order_pass.hpp"

#include <array>
#include <span>

namespace pelage::test {

inline constexpr std::array all_methods{frame::order_method::k_buffer,
                                        frame::order_method::a_buffer,
                                        frame::order_method::unrolled_list,
                                        frame::order_method::ordered_list,
                                        frame::order_method::atomic_k_buffer,
                                        frame::order_method::split_k_buffer,
                                        frame::order_method::partial_selection_sort,
                                        frame::order_method::selection_sort,
                                        frame::order_method::full_sort};

/// Those that shaders have: all but full_sort.
inline constexpr std::span device_methods = std::span(all_methods).first<all_methods.size() - 1>();

}  // namespace pelage::test
