// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
// What many of the renderer's files include and none of it its own: reading it takes most of a small file's time.
#include <fmt/format.h>
#include <glm/glm.hpp>
#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>
