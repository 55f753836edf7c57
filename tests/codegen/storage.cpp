// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "storage.hpp"

namespace features {

template void tally::add<6u>(cells&, std::uint32_t) noexcept;
template void tally::add<9u>(cells&, std::uint32_t) noexcept;
template bool tally::is_first<6u>(const cells&, std::uint32_t) noexcept;
template bool tally::is_first<9u>(const cells&, std::uint32_t) noexcept;
template struct histogram<6u>;
template struct histogram<9u>;
template void histogram<6u>::store(cells&, std::uint32_t) const noexcept;
template void histogram<9u>::store(cells&, std::uint32_t) const noexcept;
template std::uint32_t place_in<6u>(const cells&, std::uint32_t) noexcept;
template std::uint32_t place_in<9u>(const cells&, std::uint32_t) noexcept;
template histogram<6u> load_histogram(const cells&, std::uint32_t) noexcept;
template histogram<9u> load_histogram(const cells&, std::uint32_t) noexcept;
template std::uint32_t use_lanes(pelage::subgroup&, std::uint32_t) noexcept;

}  // namespace features
