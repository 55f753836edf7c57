// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "quality/visibility.hpp"

#include <pelage/composite/optical_depth.hpp>
#include <pelage/visibility/deep_shadow_map.hpp>
#include <time.h>

#include <algorithm>

#include "quality/difference.hpp"
#include "quality/visibility_methods.hpp"

namespace pelage::frame {
namespace {

/// The truth: what passes all of a sorted list that lie strictly before each of some rising depths.
std::vector<float> truth_at(const texel& t, std::span<const float> depths) {
  std::vector<float> passed;
  float before = 1.0F;
  std::size_t next = 0;
  for (const float depth : depths) {
    for (; next < t.list.size() && t.list[next].depth < depth; ++next)
      before *= transmittance_of(t.optical[next]);
    passed.push_back(before);
  }
  return passed;
}

std::vector<float> depths_of(const texel& t) {
  std::vector<float> depths;
  for (const sample& s : t.list)
    depths.push_back(s.depth);
  return depths;
}

/// The texels of a light's view that hold fragments.
class light_texels {
 public:
  light_texels(const lists& light, float alpha) : light_(light), alpha_(alpha) {
    std::vector<float> extents;
    for (std::size_t p = 0; p < light.pixels(); ++p) {
      const std::span<const sample> list = light.of(p);
      if (list.empty()) continue;
      filled_.push_back(p);
      whole_.extend(list.front().depth);
      whole_.extend(list.back().depth);
      extents.push_back(list.back().depth - list.front().depth);
      if (list.size() > light.of(longest_).size()) longest_ = p;
    }
    if (extents.empty()) return;
    const auto most = extents.begin() + static_cast<std::ptrdiff_t>(extents.size() * 9 / 10);
    std::nth_element(extents.begin(), most, extents.end());
    extent_ = *most;
  }

  [[nodiscard]] std::span<const std::size_t> filled() const { return filled_; }
  [[nodiscard]] texel longest() const { return at(longest_); }
  [[nodiscard]] float extent() const { return extent_; }

  /// Of those that hold half as many fragments as the longest or more, the one whose first is farthest before the
  /// others: a stray strand before the mass.
  [[nodiscard]] texel stray() const {
    const auto gap = [&](std::size_t p) {
      const std::span<const sample> list = light_.of(p);
      const bool dense = list.size() > 1 && 2 * list.size() >= light_.of(longest_).size();
      return dense ? list[1].depth - list[0].depth : 0.0F;
    };
    return at(*std::max_element(filled_.begin(), filled_.end(),
                                [&](std::size_t a, std::size_t b) { return gap(a) < gap(b); }));
  }

  [[nodiscard]] texel at(std::size_t pixel) const {
    texel t{light_.of(pixel), {}, depth_range::empty(), whole_, extent_};
    for (const sample& s : t.list)
      t.optical.push_back(optical_depth(alpha_ * s.coverage));
    t.range.extend(t.list.front().depth);
    t.range.extend(t.list.back().depth);
    return t;
  }

 private:
  const lists& light_;
  float alpha_;
  std::vector<std::size_t> filled_;
  std::size_t longest_ = 0;
  depth_range whole_ = depth_range::empty();
  float extent_ = 0.0F;  ///< of deep opacity layers: nine in ten texels end within it
};

/// What one method comes to.
struct account {
  difference error;
  std::uint64_t vertices = 0;
  std::vector<double> nanoseconds;  ///< a fragment, batch by batch
};

/// One texel with what does not depend on the method.
struct prepared {
  texel t;
  std::vector<float> depths;
  std::vector<float> truth;
  std::vector<float> passed;
};

/// What this thread has worked so far.
double thread_nanoseconds() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Methods take turns, some hundred texels each, so that what disturbs the machine disturbs all.
std::vector<account> run_all(const light_texels& texels) {
  constexpr std::size_t batch = 256;
  const std::span<const visibility_method> methods = visibility_methods();
  std::vector<account> accounts(methods.size());
  std::vector<prepared> some;
  for (std::size_t first = 0; first < texels.filled().size(); first += batch) {
    some.clear();
    std::size_t fragments = 0;
    for (const std::size_t p : texels.filled().subspan(first, std::min(batch, texels.filled().size() - first))) {
      texel t = texels.at(p);
      std::vector<float> depths = depths_of(t);
      std::vector<float> truth = truth_at(t, depths);
      std::vector<float> passed(depths.size());
      fragments += depths.size();
      some.push_back({std::move(t), std::move(depths), std::move(truth), std::move(passed)});
    }
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const double start = thread_nanoseconds();
      for (prepared& p : some)
        methods[m].estimate(p.t, p.depths, p.passed, accounts[m].vertices);
      accounts[m].nanoseconds.push_back((thread_nanoseconds() - start) / static_cast<double>(fragments));
      for (const prepared& p : some) {
        for (std::size_t i = 0; i < p.truth.size(); ++i)
          accounts[m].error.see(double{p.passed[i]} - double{p.truth[i]});
      }
    }
  }
  return accounts;
}

/// What each method says at 400 depths of a texel.
nlohmann::json along_ray(const texel& t) {
  std::vector<float> depths(400);
  const float first = t.list.front().depth;
  const float step = 1.02F * (t.list.back().depth - first) / 399.0F;
  for (std::size_t i = 0; i < depths.size(); ++i)
    depths[i] = first + step * static_cast<float>(i);
  nlohmann::json ray{{"fragments", t.list.size()}, {"depth", depths}, {"truth", truth_at(t, depths)}};
  std::vector<float> passed(depths.size());
  std::uint64_t unused = 0;
  for (const visibility_method& each : visibility_methods()) {
    each.estimate(t, depths, passed, unused);
    ray["methods"][each.name] = passed;
  }
  return ray;
}

}  // namespace

nlohmann::json measure_visibility(const lists& light, float alpha) {
  const light_texels texels(light, alpha);
  if (texels.filled().empty()) return {};
  const std::vector<account> accounts = run_all(texels);
  nlohmann::json result{{"alpha", alpha}, {"extent", texels.extent()}, {"fragments", light.fragments()}};
  for (std::size_t m = 0; m < accounts.size(); ++m) {
    const visibility_method& method = visibility_methods()[m];
    const auto vertex_bytes = static_cast<double>(accounts[m].vertices * sizeof(deep_shadow_vertex));
    const double bytes =
        method.bytes > 0 ? static_cast<double>(method.bytes) : vertex_bytes / static_cast<double>(light.pixels());
    result["methods"].push_back({{"name", method.name},
                                 {"rms", accounts[m].error.rms()},
                                 {"maximum", accounts[m].error.largest},
                                 {"bytes_per_texel", bytes},
                                 {"nanoseconds", median(accounts[m].nanoseconds)}});
  }
  result["ray"] = along_ray(texels.longest());
  result["stray_ray"] = along_ray(texels.stray());
  return result;
}

}  // namespace pelage::frame
