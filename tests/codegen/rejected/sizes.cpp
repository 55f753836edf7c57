// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// A size is a macro in GLSL: whatever keeps only its number in one instantiation has lost it.
#include <array>
#include <cstdint>

namespace rejected {

template <std::uint32_t K>
struct list {
  std::array<int, K> slot;
};

template <typename Array>
int first_of(const Array& array) noexcept {  // error: two instantiations of rejected_first_of differ, so a size or a type is lost: `int rejected_first_of(int array[8]){` and `int rejected_first_of(int array[5]){`
  return array[0];
}

template <std::uint32_t K>
int through_a_type(list<K> l) noexcept {
  return first_of(l.slot);
}

template <std::uint32_t K>
int chosen_at_compile_time(list<K> l) noexcept {
  if constexpr (K > 4u) {  // error: `if constexpr` over a size: the size is lost, use a plain `if`
    return l.slot[4];
  }
  return l.slot[0];
}

template <std::uint32_t K>
list<K> zeroed() noexcept {
  return list<K>{};  // error: an array of many zeros: declare it without a value and fill it in a loop
}

template <std::uint32_t K>
int once(list<K> l) noexcept {  // error: rejected::once is instantiated at one size only: instantiate it at another one, too, to show that none is lost
  return l.slot[K - 1u];
}

template <std::uint32_t K>
list<2u * K> doubled(list<K> l) noexcept {  // error: a second size of one template, REJECTED_LIST_K = (2u * REJECTED_LIST_K): a file holds one
  list<2u * K> result;
  for (std::uint32_t i = 0u; i < K; ++i) {
    result.slot[i] = l.slot[i];
    result.slot[i + K] = l.slot[i];
  }
  return result;
}

template <bool Flag>
int switched(int x) noexcept {
  return Flag ? x : -x;  // error: template parameter `Flag` is not an integer
}

template <typename T>
T twice(T x) noexcept {  // error: two instantiations of rejected_twice differ, so a size or a type is lost: `int rejected_twice(int x){` and `precise float rejected_twice(float x){`
  return x + x;
}

template int through_a_type<8u>(list<8u>) noexcept;
template int through_a_type<5u>(list<5u>) noexcept;
template int chosen_at_compile_time<8u>(list<8u>) noexcept;
template int chosen_at_compile_time<5u>(list<5u>) noexcept;
template list<8u> zeroed<8u>() noexcept;
template list<5u> zeroed<5u>() noexcept;
template int once<8u>(list<8u>) noexcept;
template list<16u> doubled<8u>(list<8u>) noexcept;
template list<10u> doubled<5u>(list<5u>) noexcept;
template int switched<true>(int) noexcept;
template int twice(int) noexcept;
template float twice(float) noexcept;

}  // namespace rejected
