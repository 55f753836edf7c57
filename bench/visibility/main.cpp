// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT

// Nanoseconds per fragment put in and per look-up of every visibility structure, on one thread. All methods see the
// same fragments and take turns in every round, so that what disturbs the machine disturbs all; the median round
// counts. Usage: pelage-bench-visibility OUT.json [ROUNDS]
#include <pelage/composite/optical_depth.hpp>
#include <pelage/core/fragment.hpp>
#include <pelage/visibility/deep_shadow_map.hpp>
#include <pelage/visibility/density_clusters.hpp>
#include <pelage/visibility/depth_range.hpp>
#include <pelage/visibility/occupancy_batch.hpp>
#include <pelage/visibility/occupancy_map.hpp>
#include <pelage/visibility/opacity_map.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "results.hpp"

namespace {

using namespace pelage;

constexpr std::size_t texels = 1024;

/// Fragments as texels of a light's map have them: some locks of hair at a few depths, in no order.
struct scene {
  explicit scene(std::size_t per_texel) : per_texel(per_texel) {
    std::mt19937 random(1u);
    std::normal_distribution<float> spread(0.0f, 0.08f);
    std::uniform_real_distribution<float> place(1.0f, 2.0f);
    for (std::size_t t = 0; t < texels; ++t) {
      std::vector<float> lock(6);
      for (float& depth : lock) {
        depth = place(random);
      }
      depth_range range = depth_range::empty();
      for (std::size_t i = 0; i < per_texel; ++i) {
        const float depth = lock[random() % lock.size()] + spread(random);
        all.push_back(fragment{depth, static_cast<std::uint32_t>(i)});
        range.extend(depth);
      }
      ranges.push_back(range);
      for (std::size_t i = 0; i < per_texel; ++i) {
        relative.push_back(range.relative(all[t * per_texel + i].depth));
      }
    }
    // Other threads' fragments come between: the order in which concurrent structures see them.
    for (std::size_t i = 0; i < all.size(); ++i) {
      arrival.push_back(static_cast<std::uint32_t>(i));
    }
    std::shuffle(arrival.begin(), arrival.end(), random);
    sorted = all;
    for (std::size_t t = 0; t < texels; ++t) {
      std::sort(begin(sorted, t), begin(sorted, t + 1), before);
    }
  }

  [[nodiscard]] std::vector<fragment>::iterator begin(std::vector<fragment>& from, std::size_t t) const {
    return from.begin() + static_cast<std::ptrdiff_t>(t * per_texel);
  }
  [[nodiscard]] std::span<const float> relative_of(std::size_t t) const {
    return std::span(relative).subspan(t * per_texel, per_texel);
  }

  std::size_t per_texel;
  std::vector<fragment> all;        ///< texel by texel
  std::vector<float> relative;      ///< depth of each in its texel's range
  std::vector<fragment> sorted;     ///< texel by texel, nearest first
  std::vector<depth_range> ranges;  ///< one a texel
  std::vector<std::uint32_t> arrival;
};

/// A call of its own, as from another file: inlined into a bench's loops, compilers leave out vectors.
[[gnu::noinline]] void look_up_batch(const occupancy_map<128u, 4u>& map, std::span<const float> positions,
                                     std::span<float> amounts) {
  amounts_before(map, positions, amounts);
}

/// Keeps results alive, so that no work is optimised away.
float kept = 0.0f;

struct task {
  std::string name;
  std::function<void()> work;  ///< once for every fragment of the scene
  std::vector<double> nanoseconds;
};

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

class race {
 public:
  race(std::size_t per_texel, int rounds) : scene_(per_texel), rounds_(rounds) {}

  void run(bench::results& measured) {
    const std::size_t sort = add("std::sort of each texel's list", [this] {
      scratch_ = scene_.all;
      for (std::size_t t = 0; t < texels; ++t) {
        std::sort(scene_.begin(scratch_, t), scene_.begin(scratch_, t + 1), before);
      }
      kept += scratch_.front().depth;
    });
    add_range();
    const std::size_t occupancy = add_map<occupancy_map<128u, 4u>>("occupancy 128/4", 128u);
    const std::size_t shared = add_shared_occupancy();
    const std::size_t batch = add_batch();
    const std::size_t deep4 = add_map<opacity_map<4u>>("deep opacity 4", 4u);
    const std::size_t deep4_batch = add_deep_opacity_batch();
    add_map<opacity_map<16u>>("deep opacity 16", 16u);
    add_map<opacity_map<32u>>("deep opacity 32", 32u);
    add_accumulated<16u>();
    add_accumulated<128u>();
    add_accumulated<256u>();
    add_map<density_clusters<4u>>("density clusters 4", 4u);
    add_deep_shadow(0.0f);
    add_deep_shadow(0.01f);

    for (int round = 0; round < rounds_; ++round) {
      for (task& each : tasks_) {
        const auto start = std::chrono::steady_clock::now();
        each.work();
        const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
        each.nanoseconds.push_back(taken.count() / static_cast<double>(scene_.all.size()));
      }
    }
    std::printf("\n%zu texels of %zu fragments, median of %d interleaved rounds\n\n", texels, scene_.per_texel,
                rounds_);
    std::printf("| method | ns |\n| --- | ---: |\n");
    for (const task& each : tasks_) {
      const double typical = median(each.nanoseconds);
      std::printf("| %s | %.2f |\n", each.name.c_str(), typical);
      measured.add(std::to_string(scene_.per_texel) + " fragments a texel", each.name, typical);
    }
    std::printf("\n| ratio | |\n| --- | ---: |\n");
    print_ratio("sorting over building an occupancy map, grouped by texel", sort, occupancy);
    print_ratio("sorting over building an occupancy map, atomics in order of arrival", sort, shared);
    print_ratio("batched occupancy query over deep opacity 4 query", batch, deep4 + 1);
    print_ratio("batched occupancy query over batched deep opacity 4 query", batch, deep4_batch);
    print_ratio("single occupancy query over deep opacity 4 query", occupancy + 1, deep4 + 1);
  }

 private:
  std::size_t add(const std::string& name, std::function<void()> work) {
    tasks_.push_back(task{name, std::move(work), {}});
    return tasks_.size() - 1;
  }

  void print_ratio(const char* name, std::size_t a, std::size_t b) const {
    std::vector<double> ratio;
    for (std::size_t i = 0; i < tasks_[a].nanoseconds.size(); ++i) {
      ratio.push_back(tasks_[a].nanoseconds[i] / tasks_[b].nanoseconds[i]);
    }
    std::printf("| %s | %.2f |\n", name, median(ratio));
  }

  static void put(auto& map, float position) {
    if constexpr (requires { map.add(position); }) {
      map.add(position);
    } else {
      map.add(position, 1u);
    }
  }
  static float look_up(const auto& map, float position) {
    if constexpr (requires { map.count_before(position); }) {
      return map.count_before(position);
    } else {
      return map.amount_before(position);
    }
  }

  /// Building, then single look-ups of a map of slices.
  template <class Map>
  std::size_t add_map(const std::string& name, std::uint32_t layers) {
    auto maps = std::make_shared<std::vector<Map>>(texels, Map::empty());
    const std::size_t first = add(name + ", put in", [this, maps, layers] {
      for (std::size_t t = 0; t < texels; ++t) {
        Map map = Map::empty();
        for (const float relative : scene_.relative_of(t)) {
          put(map, slice_position(relative, layers));
        }
        (*maps)[t] = map;
      }
    });
    add(name + ", look up", [this, maps, layers] {
      float sum = 0.0f;
      for (std::size_t t = 0; t < texels; ++t) {
        for (const float relative : scene_.relative_of(t)) {
          sum += look_up((*maps)[t], slice_position(relative, layers));
        }
      }
      kept += sum;
    });
    return first;
  }

  void add_range() {
    auto cells = std::make_shared<std::vector<std::uint32_t>>(2u * texels);
    add("depth range, atomics in order of arrival", [this, cells] {
      std::fill(cells->begin(), cells->end(), 0u);
      atomic_cells<std::uint32_t> storage{*cells};
      for (const std::uint32_t i : scene_.arrival) {
        atomic_depth_range::extend(storage, static_cast<std::uint32_t>(i / scene_.per_texel), scene_.all[i].depth);
      }
    });
  }

  std::size_t add_shared_occupancy() {
    using map = occupancy_map<128u, 4u>;
    auto cells = std::make_shared<std::vector<std::uint32_t>>(map::cells * texels);
    return add("occupancy 128/4, put in by atomics in order of arrival", [this, cells] {
      std::fill(cells->begin(), cells->end(), 0u);
      atomic_cells<std::uint32_t> storage{*cells};
      for (const std::uint32_t i : scene_.arrival) {
        atomic_occupancy_map::add<map>(storage, static_cast<std::uint32_t>(i / scene_.per_texel),
                                       slice_position(scene_.relative[i], 128u), 1u);
      }
    });
  }

  std::size_t add_batch() {
    auto maps = std::make_shared<std::vector<occupancy_map<128u, 4u>>>(texels, occupancy_map<128u, 4u>::empty());
    for (std::size_t t = 0; t < texels; ++t) {
      for (const float relative : scene_.relative_of(t)) {
        (*maps)[t].add(slice_position(relative, 128u), 1u);
      }
    }
    return add("occupancy 128/4, look up in batches", [this, maps] {
      look_up_batches([&](std::size_t t, std::span<const float> positions,
                          std::span<float> amounts) { look_up_batch((*maps)[t], positions, amounts); },
                      128u);
    });
  }

  std::size_t add_deep_opacity_batch() {
    auto maps = std::make_shared<std::vector<opacity_map<4u>>>(texels, opacity_map<4u>::empty());
    for (std::size_t t = 0; t < texels; ++t) {
      for (const float relative : scene_.relative_of(t)) {
        (*maps)[t].add(slice_position(relative, 4u), 1u);
      }
    }
    return add("deep opacity 4, look up in batches", [this, maps] {
      look_up_batches(
          [&](std::size_t t, std::span<const float> positions, std::span<float> amounts) {
            const opacity_map<4u> map = (*maps)[t];
            for (std::size_t i = 0; i < positions.size(); ++i) {
              amounts[i] = map.amount_before(positions[i]);
            }
          },
          4u);
    });
  }

  /// A texel's own fragments as one span, positions computed as for the single look-ups.
  template <class Batch>
  void look_up_batches(Batch&& batch, std::uint32_t layers) {
    positions_.resize(scene_.per_texel);
    amounts_.resize(scene_.per_texel);
    for (std::size_t t = 0; t < texels; ++t) {
      const std::span<const float> relative = scene_.relative_of(t);
      for (std::size_t i = 0; i < relative.size(); ++i) {
        positions_[i] = slice_position(relative[i], layers);
      }
      batch(t, std::span<const float>(positions_), std::span<float>(amounts_));
      kept += amounts_.back();
    }
  }

  template <std::uint32_t Layers>
  void add_accumulated() {
    auto maps = std::make_shared<std::vector<opacity_map<Layers>>>(texels, opacity_map<Layers>::empty());
    const std::string name = "opacity " + std::to_string(Layers);
    add(name + ", put in and accumulate", [this, maps] {
      for (std::size_t t = 0; t < texels; ++t) {
        opacity_map<Layers>& map = (*maps)[t];
        map = opacity_map<Layers>::empty();
        for (const float relative : scene_.relative_of(t)) {
          map.add(slice_position(relative, Layers), 1u);
        }
        map.accumulate();
      }
    });
    add(name + ", look up accumulated", [this, maps] {
      float sum = 0.0f;
      for (std::size_t t = 0; t < texels; ++t) {
        for (const float relative : scene_.relative_of(t)) {
          sum += (*maps)[t].accumulated_before(slice_position(relative, Layers));
        }
      }
      kept += sum;
    });
  }

  void add_deep_shadow(float error) {
    struct maps {
      std::vector<deep_shadow_vertex> vertices;
      std::vector<std::uint32_t> count = std::vector<std::uint32_t>(texels);
    };
    auto made = std::make_shared<maps>();
    made->vertices.resize(2u * scene_.all.size());
    const auto first = [this](std::size_t t) { return static_cast<std::uint32_t>(2u * t * scene_.per_texel); };
    char name[64];
    std::snprintf(name, sizeof name, "deep shadow map, error %g", static_cast<double>(error));
    add(std::string(name) + ", build from sorted", [this, made, error, first] {
      span_vertex_storage storage{made->vertices};
      for (std::size_t t = 0; t < texels; ++t) {
        deep_shadow_builder builder = deep_shadow_builder::begin(first(t), error);
        for (std::size_t i = t * scene_.per_texel; i < (t + 1u) * scene_.per_texel; ++i) {
          builder.add(storage, scene_.sorted[i].depth, 0.1f);
        }
        builder.finish(storage);
        made->count[t] = builder.count;
      }
    });
    add(std::string(name) + ", look up", [this, made, first] {
      const span_vertex_storage storage{made->vertices};
      float sum = 0.0f;
      for (std::size_t t = 0; t < texels; ++t) {
        for (std::size_t i = t * scene_.per_texel; i < (t + 1u) * scene_.per_texel; ++i) {
          sum += deep_shadow_at(storage, first(t), made->count[t], scene_.all[i].depth);
        }
      }
      kept += sum;
    });
  }

  scene scene_;
  int rounds_;
  std::vector<task> tasks_;
  std::vector<fragment> scratch_;
  std::vector<float> positions_, amounts_;
};

/// A whole number in [1, 100000], or 0.
int number(const char* text) {
  char* end = nullptr;
  const long value = std::strtol(text, &end, 10);
  return *end == '\0' && value >= 1 && value <= 100000 ? static_cast<int>(value) : 0;
}

}  // namespace

int main(int argc, char** argv) {
  const int rounds = argc > 2 ? number(argv[2]) : 101;
  if (argc < 2 || argc > 3 || rounds == 0) {
    std::fprintf(stderr, "usage: pelage-bench-visibility OUT.json [ROUNDS]\n");
    return 2;
  }
  bench::results measured("nanoseconds a fragment, one thread");
  for (const std::size_t per_texel : {16u, 64u}) {
    race(per_texel, rounds).run(measured);
  }
  try {
    measured.write(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "pelage-bench-visibility: %s\n", error.what());
    return 2;
  }
  return kept == kept ? 0 : 1;
}
