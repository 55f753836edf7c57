// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// pelage-bench-k_select OUT.json: nanoseconds a pixel for the K nearest of n fragments, by each method. In each round
// each method takes its turn on the same 65536 fragments (512 KiB, as many pixels as they make); medians of rounds,
// thread time.
#include "method.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <time.h>

#include <algorithm>
#include <fstream>
#include <random>

namespace {

using bench::k_values;
using pelage::fragment;

constexpr std::uint32_t fragment_count = 65536u;
constexpr int rounds = 15;

const char* const cases[] = {"uniform", "clustered", "ascending", "descending", "adversarial"};

/// Nanoseconds that this thread has run: on a busy machine the others' turns do not count.
double thread_time() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

/// The depths of one pixel. Adversarial: the near half stands where k_select's bound does not see it, in fewer than
/// K of its 2 K columns.
void fill(std::span<fragment> list, const std::string& name, std::uint32_t k, std::mt19937& random) {
  std::uniform_real_distribution<float> depth(1.0f, 100.0f);
  std::normal_distribution<float> jitter(0.0f, 0.05f);
  const std::uint32_t columns = 2u * std::max(8u, k);
  float centre[4];
  std::generate_n(centre, 4, [&] { return depth(random); });
  for (std::uint32_t i = 0u; i < list.size(); ++i) {
    list[i].depth = name == "clustered" ? std::max(0.5f, centre[random() % 4u] + jitter(random)) : depth(random);
    if (name == "adversarial") {
      list[i].depth += i % columns < columns / 2u - 1u ? 0.0f : 200.0f;
    }
    list[i].id = static_cast<std::uint32_t>(random() >> 1);
  }
  if (name == "ascending") {
    std::sort(list.begin(), list.end(), pelage::before);
  } else if (name == "descending") {
    std::sort(list.begin(), list.end(), [](fragment a, fragment b) { return pelage::before(b, a); });
  }
}

std::vector<bench::method> all_methods() {
  std::vector<bench::method> methods;
#if defined(__x86_64__)
  methods.push_back(bench::k_select_sse2);
  if (__builtin_cpu_supports("avx2")) {
    methods.push_back(bench::k_select_avx2);
  }
  if (__builtin_cpu_supports("avx512f")) {
    methods.push_back(bench::k_select_avx512);
  }
#endif
  for (const bench::method& m : bench::other_methods()) {
    methods.push_back(m);
  }
  return methods;
}

/// Median nanoseconds a pixel of each method. Throws if one selects other fragments than the first.
std::vector<double> measure(const std::vector<bench::method>& methods, const std::string& name, std::uint32_t n,
                            std::size_t k_index) {
  const std::uint32_t k = k_values[k_index];
  const std::uint32_t pixels = fragment_count / n;
  std::mt19937 random(n * 100u + k);
  std::vector<fragment> fragments(fragment_count);
  std::vector<std::uint32_t> first(pixels + 1u);
  for (std::uint32_t p = 0u; p < pixels; ++p) {
    first[p + 1u] = (p + 1u) * n;
    fill(std::span(fragments).subspan(first[p], n), name, k, random);
  }
  std::vector<fragment> expected;
  std::vector<std::vector<double>> times(methods.size());
  for (int round = -1; round < rounds; ++round) {  // the first warms up, and is checked
    for (std::size_t m = 0u; m < methods.size(); ++m) {
      std::vector<fragment> nearest(std::size_t{pixels} * k, pelage::no_fragment());
      const bench::workload work{fragments, first, nearest};
      const double start = thread_time();
      methods[m].run[k_index](work);
      const double taken = thread_time() - start;
      if (round >= 0) {
        times[m].push_back(taken / pixels);
      } else if (m == 0u) {
        expected = nearest;
      } else if (!std::equal(nearest.begin(), nearest.end(), expected.begin(), pelage::same)) {
        throw std::runtime_error(
            fmt::format("{} and {} differ at n = {}, K = {}, {}", methods[m].name, methods[0].name, n, k, name));
      }
    }
  }
  std::vector<double> medians;
  for (auto& t : times) {
    std::nth_element(t.begin(), t.begin() + rounds / 2, t.end());
    medians.push_back(t[rounds / 2]);
  }
  return medians;
}

void run(const std::string& path) {
  const std::vector<bench::method> methods = all_methods();
  nlohmann::json cells = nlohmann::json::array();
  fmt::print("{:<12}{:>5}{:>4}", "ns a pixel", "n", "K");
  for (const auto& m : methods) {
    fmt::print("  {:>{}}", m.name, std::max<std::size_t>(m.name.size(), 8u));
  }
  fmt::print("  {:>10}  {:>10}\n", "best std/us", "best/us");
  int cells_lost = 0;
  for (const char* name : cases) {
    for (const std::uint32_t n : {32u, 64u, 128u, 256u, 512u, 1024u}) {
      for (std::size_t k = 0u; k < bench::k_count; ++k) {
        const std::vector<double> ns = measure(methods, name, n, k);
        double ours = 0.0, others = 1e30, library = 1e30;
        nlohmann::json times;
        fmt::print("{:<12}{:>5}{:>4}", name, n, k_values[k]);
        for (std::size_t m = 0u; m < methods.size(); ++m) {
          fmt::print("  {:>{}.1f}", ns[m], std::max<std::size_t>(methods[m].name.size(), 8u));
          times[methods[m].name] = ns[m];
          if (methods[m].ours) {
            ours = ns[m];  // the widest is the last of ours
          } else {
            others = std::min(others, ns[m]);
            library = methods[m].name.starts_with("std::") ? std::min(library, ns[m]) : library;
          }
        }
        fmt::print("  {:>10.2f}x  {:>9.2f}x\n", library / ours, others / ours);
        cells_lost += others < ours ? 1 : 0;
        cells.push_back({{"case", name}, {"n", n}, {"k", k_values[k]}, {"ns", times}});
      }
    }
  }
  fmt::print("cells in which another method is faster than the widest k_select: {}\n", cells_lost);
  std::ofstream out(path);
  out << nlohmann::json{{"unit", "ns a pixel, median"}, {"rounds", rounds}, {"cells", cells}}.dump(1) << '\n';
  if (!out.flush()) {
    throw std::runtime_error("cannot write " + path);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: pelage-bench-k_select OUT.json\n");
    return 2;
  }
  try {
    run(argv[1]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "pelage-bench-k_select: {}\n", error.what());
    return 1;
  }
}
