// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

namespace pelage::frame {

struct order_job;

// One function for each order_method: takes all fragments of the job to its visitor and fills its report. `k` must be
// one of compiled_k; they throw std::invalid_argument else.

// tile_method.cpp
void run_k_buffer(order_job& work, std::uint32_t k);

// list_methods.cpp
void run_a_buffer(order_job& work, std::uint32_t k);
void run_unrolled_list(order_job& work, std::uint32_t k);
void run_ordered_list(order_job& work, std::uint32_t k);
void run_partial_selection_sort(order_job& work, std::uint32_t k);
void run_selection_sort(order_job& work);
void run_full_sort(order_job& work);

// slot_methods.cpp
void run_atomic_k_buffer(order_job& work, std::uint32_t k);
void run_split_k_buffer(order_job& work, std::uint32_t k);

}  // namespace pelage::frame
