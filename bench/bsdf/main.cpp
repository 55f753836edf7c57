// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT

// Nanoseconds per evaluation, density, sample and construction of Chiang's model: the library's kernel, its form in
// four lanes and its batches, against the plain implementation of plain_chiang.hpp in the same run. Usage:
// pelage-bench-bsdf OUT.json [OPTION...], options of Google Benchmark; the runs are interleaved by default, and ratios
// to the plain form are printed at the end.
#include <pelage/bsdf/chiang_batch.hpp>
#include <pelage/bsdf/chiang_quad.hpp>
#include <pelage/bsdf/chiang_sampling.hpp>
#include <bsdf/configurations.hpp>
#include <bsdf/plain_chiang.hpp>
#include <results.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace pelage;
using bench::configurations;
using bench::plain_chiang;

const configurations made_once(4096);
const configurations& all() {
  return made_once;
}

/// Runs `work(k)` for every configuration and takes the time of one.
template <class Work>
void each(benchmark::State& state, Work work) {
  const std::size_t count = all().size();
  for (auto _ : state) {
    for (std::size_t k = 0; k < count; ++k) {
      work(k);
    }
    benchmark::ClobberMemory();
  }
  state.counters["each"] = benchmark::Counter(
      static_cast<double>(count), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

plain_chiang make_plain(std::size_t k) {
  const chiang_parameters<float>& p = all().parameters[k];
  return plain_chiang(all().h[k], p.eta, glm::vec3(p.sigma_a[0], p.sigma_a[1], p.sigma_a[2]), p.beta_m, p.beta_n,
                      p.tilt);
}

template <class Made, class Make>
std::vector<Made> make_all(Make make) {
  std::vector<Made> made;
  for (std::size_t k = 0; k < all().size(); ++k) {
    made.push_back(make(k));
  }
  return made;
}

chiang_fibre<float> make_fibre(std::size_t k) {
  return make_chiang_fibre(all().parameters[k]);
}
chiang_quad_fibre make_quad(std::size_t k) {
  return make_chiang_quad_fibre(make_fibre(k));
}

void construct_plain(benchmark::State& state) {
  each(state, [](std::size_t k) {
    plain_chiang made = make_plain(k);
    benchmark::DoNotOptimize(made);
  });
}

void construct_kernel(benchmark::State& state) {
  each(state, [](std::size_t k) {
    chiang_fibre<float> made = make_fibre(k);
    benchmark::DoNotOptimize(made);
  });
}

void construct_quad(benchmark::State& state) {
  each(state, [](std::size_t k) {
    chiang_quad_fibre made = make_quad(k);
    benchmark::DoNotOptimize(made);
  });
}

void evaluate_plain(benchmark::State& state) {
  const auto made = make_all<plain_chiang>(make_plain);
  each(state, [&](std::size_t k) { benchmark::DoNotOptimize(made[k].f(all().eye[k], all().light[k])); });
}

/// The kernel or its form in four lanes, whichever the fibre is.
template <class Fibre>
void evaluate_with(benchmark::State& state, const std::vector<Fibre>& made) {
  each(state, [&](std::size_t k) {
    const auto view = view_chiang(made[k], all().h[k], fibre_direction_of(all().eye[k]));
    glm::vec3 value = evaluate_chiang(made[k], view, fibre_direction_of(all().light[k])).value;
    benchmark::DoNotOptimize(value);
  });
}

template <class Fibre>
void density_with(benchmark::State& state, const std::vector<Fibre>& made) {
  each(state, [&](std::size_t k) {
    const auto view = view_chiang(made[k], all().h[k], fibre_direction_of(all().eye[k]));
    benchmark::DoNotOptimize(chiang_density(made[k], view, fibre_direction_of(all().light[k])));
  });
}

template <class Fibre>
void both_with(benchmark::State& state, const std::vector<Fibre>& made) {
  each(state, [&](std::size_t k) {
    const auto view = view_chiang(made[k], all().h[k], fibre_direction_of(all().eye[k]));
    benchmark::DoNotOptimize(evaluate_chiang(made[k], view, fibre_direction_of(all().light[k])));
  });
}

template <class Fibre>
void sample_with(benchmark::State& state, const std::vector<Fibre>& made) {
  each(state, [&](std::size_t k) {
    const auto view = view_chiang(made[k], all().h[k], fibre_direction_of(all().eye[k]));
    const glm::vec4& u = all().u[k];
    benchmark::DoNotOptimize(sample_chiang(made[k], view, std::array<float, 4>{u[0], u[1], u[2], u[3]}));
  });
}

void evaluate_kernel(benchmark::State& state) {
  evaluate_with(state, make_all<chiang_fibre<float>>(make_fibre));
}
/// The scalar fibre, viewed and evaluated in one call.
void evaluate_once(benchmark::State& state) {
  const auto made = make_all<chiang_fibre<float>>(make_fibre);
  each(state, [&](std::size_t k) {
    glm::vec3 value =
        evaluate_chiang(made[k], all().h[k], fibre_direction_of(all().eye[k]), fibre_direction_of(all().light[k]))
            .value;
    benchmark::DoNotOptimize(value);
  });
}
void evaluate_quad(benchmark::State& state) {
  evaluate_with(state, make_all<chiang_quad_fibre>(make_quad));
}

void density_plain(benchmark::State& state) {
  const auto made = make_all<plain_chiang>(make_plain);
  each(state, [&](std::size_t k) { benchmark::DoNotOptimize(made[k].pdf(all().eye[k], all().light[k])); });
}

void density_kernel(benchmark::State& state) {
  density_with(state, make_all<chiang_fibre<float>>(make_fibre));
}
void density_quad(benchmark::State& state) {
  density_with(state, make_all<chiang_quad_fibre>(make_quad));
}

void both_plain(benchmark::State& state) {
  const auto made = make_all<plain_chiang>(make_plain);
  each(state, [&](std::size_t k) {
    benchmark::DoNotOptimize(made[k].f(all().eye[k], all().light[k]));
    benchmark::DoNotOptimize(made[k].pdf(all().eye[k], all().light[k]));
  });
}

void both_kernel(benchmark::State& state) {
  both_with(state, make_all<chiang_fibre<float>>(make_fibre));
}
void both_quad(benchmark::State& state) {
  both_with(state, make_all<chiang_quad_fibre>(make_quad));
}

void sample_plain(benchmark::State& state) {
  const auto made = make_all<plain_chiang>(make_plain);
  each(state, [&](std::size_t k) {
    const glm::vec3 light = made[k].sample(all().eye[k], all().u[k]);
    benchmark::DoNotOptimize(made[k].f(all().eye[k], light));
    benchmark::DoNotOptimize(made[k].pdf(all().eye[k], light));
  });
}

void sample_kernel(benchmark::State& state) {
  sample_with(state, make_all<chiang_fibre<float>>(make_fibre));
}
void sample_quad(benchmark::State& state) {
  sample_with(state, make_all<chiang_quad_fibre>(make_quad));
}

/// The configurations as structure of arrays, with room for the results.
struct columns {
  columns() {
    for (std::size_t k = 0; k < all().size(); ++k) {
      const chiang_parameters<float>& p = all().parameters[k];
      for (std::size_t c = 0; c < 3; ++c) {
        sigma[c].push_back(p.sigma_a[c]);
        eye[c].push_back(all().eye[k][static_cast<int>(c)]);
        light[c].push_back(all().light[k][static_cast<int>(c)]);
        value[c].push_back(0.0f);
      }
      eta.push_back(p.eta);
      beta_m.push_back(p.beta_m);
      beta_n.push_back(p.beta_n);
      tilt.push_back(p.tilt);
      density.push_back(0.0f);
    }
  }

  chiang_batch batch() const { return {all().h, {eye[0], eye[1], eye[2]}, {light[0], light[1], light[2]}}; }
  chiang_batch_parameters parameters() const { return {eta, {sigma[0], sigma[1], sigma[2]}, beta_m, beta_n, tilt}; }
  chiang_batch_result result() { return {{value[0], value[1], value[2]}, density}; }

  std::array<std::vector<float>, 3> sigma, eye, light, value;
  std::vector<float> eta, beta_m, beta_n, tilt, density;
};

/// A whole batch per iteration; the time is of one element.
template <class Parameters>
void batch_with(benchmark::State& state, const Parameters& parameters, columns& data) {
  for (auto _ : state) {
    evaluate_chiang_batch(parameters, data.batch(), data.result());
    benchmark::ClobberMemory();
  }
  state.counters["each"] = benchmark::Counter(
      static_cast<double>(all().size()), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void both_batch(benchmark::State& state) {
  columns data;
  batch_with(state, make_fibre(0), data);
}

void construct_and_both_batch(benchmark::State& state) {
  columns data;
  batch_with(state, data.parameters(), data);
}

void construct_and_both_plain(benchmark::State& state) {
  each(state, [&](std::size_t k) {
    const plain_chiang made = make_plain(k);
    benchmark::DoNotOptimize(made.f(all().eye[k], all().light[k]));
    benchmark::DoNotOptimize(made.pdf(all().eye[k], all().light[k]));
  });
}

BENCHMARK(construct_plain);
BENCHMARK(construct_kernel);
BENCHMARK(construct_quad);
BENCHMARK(evaluate_plain);
BENCHMARK(evaluate_kernel);
BENCHMARK(evaluate_once);
BENCHMARK(evaluate_quad);
BENCHMARK(density_plain);
BENCHMARK(density_kernel);
BENCHMARK(density_quad);
BENCHMARK(both_plain);
BENCHMARK(both_kernel);
BENCHMARK(both_quad);
BENCHMARK(both_batch);
BENCHMARK(construct_and_both_plain);
BENCHMARK(construct_and_both_batch);
BENCHMARK(sample_plain);
BENCHMARK(sample_kernel);
BENCHMARK(sample_quad);

/// Gathers the repetitions and prints a table of medians at the end.
class ratio_reporter : public benchmark::BenchmarkReporter {
 public:
  [[nodiscard]] const bench::results& measured() const { return measured_; }

  bool ReportContext(const Context&) override { return true; }

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      const auto each_time = run.counters.find("each");
      if (run.run_type == Run::RT_Iteration && each_time != run.counters.end()) {
        times_[run.run_name.function_name].push_back(each_time->second.value * 1e9);
      }
    }
  }

  void Finalize() override {
    std::printf("%-28s %10s %10s %10s   %s\n", "per element, ns", "median", "least", "greatest", "plain / this");
    for (auto& [name, times] : times_) {
      std::sort(times.begin(), times.end());
      const std::string task = name.substr(0, name.rfind('_'));
      measured_.add(task, name.substr(name.rfind('_') + 1), times[times.size() / 2]);
      const auto plain = times_.find(task + "_plain");
      std::printf("%-28s %10.1f %10.1f %10.1f", name.c_str(), times[times.size() / 2], times.front(), times.back());
      if (plain != times_.end()) {
        std::printf("   %.2f", median(plain->second) / median(times));
      }
      std::printf("\n");
    }
    // A batch's evaluation also gives the density; against the evaluation alone it has to be as fast.
    if (times_.count("evaluate_plain") != 0 && times_.count("both_batch") != 0) {
      std::printf("a plain evaluation takes %.2f times as long as a batch's element\n",
                  median(times_["evaluate_plain"]) / median(times_["both_batch"]));
    }
  }

 private:
  static double median(std::vector<double> times) {
    std::sort(times.begin(), times.end());
    return times[times.size() / 2];
  }

  std::map<std::string, std::vector<double>> times_;
  bench::results measured_{"nanoseconds for each element"};
};

}  // namespace

int main(int count, char** words) {
  if (count < 2 || words[1][0] == '-') {
    std::fprintf(stderr, "usage: pelage-bench-bsdf OUT.json [OPTION...]\n");
    return 2;
  }
  // Defaults that the caller's options, coming later, override.
  std::vector<std::string> options = {words[0], "--benchmark_enable_random_interleaving=true",
                                      "--benchmark_repetitions=11", "--benchmark_min_time=0.02"};
  options.insert(options.end(), words + 2, words + count);
  std::vector<char*> pointers;
  for (std::string& option : options) {
    pointers.push_back(option.data());
  }
  int size = static_cast<int>(pointers.size());
  benchmark::Initialize(&size, pointers.data());
  if (benchmark::ReportUnrecognizedArguments(size, pointers.data())) {
    return 2;
  }
  ratio_reporter reporter;
  const bool any = benchmark::RunSpecifiedBenchmarks(&reporter) > 0;
  try {
    reporter.measured().write(words[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "pelage-bench-bsdf: %s\n", error.what());
    return 2;
  }
  return any ? 0 : 1;
}
