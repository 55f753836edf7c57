// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// Millions of inserts a second: every contender in turn, round after round, so that what else the machine does falls
// on all of them; medians over the rounds.
#include "contender.hpp"
#include "results.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <time.h>

#include <algorithm>
#include <barrier>
#include <cstdio>
#include <thread>
#include <vector>

namespace {

using namespace pelage::bench;

/// Seconds that this thread has run: on a busy machine the others' turns do not count.
double thread_time() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Inserts a workload with so many threads; returns the seconds of the one that ran longest.
double run(contender& tested, const workload& work, std::uint32_t threads) {
  tested.prepare(work);
  std::barrier together(static_cast<std::ptrdiff_t>(threads));
  std::vector<double> took(threads);
  {
    std::vector<std::jthread> running;
    for (std::uint32_t t = 0; t < threads; ++t) {
      running.emplace_back([&, t] {
        tested.enter_thread();
        together.arrive_and_wait();
        const double start = thread_time();
        const std::size_t count = work.offers.size();
        tested.insert(work, count * t / threads, count * (t + 1) / threads);
        took[t] = thread_time() - start;
        tested.leave_thread();
      });
    }
  }
  return *std::max_element(took.begin(), took.end());
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// One table row a contender, one column a number of threads. False if contenders that keep an order disagree.
bool race(const std::string& title, std::vector<std::unique_ptr<contender>> all, const workload& work, int rounds,
          const std::vector<std::uint32_t>& thread_counts, results& measured) {
  std::vector<std::vector<std::vector<double>>> times(all.size(), {thread_counts.size(), std::vector<double>()});
  std::uint64_t expected = 0;
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t column = 0; column < thread_counts.size(); ++column) {
      for (std::size_t row = 0; row < all.size(); ++row) {
        times[row][column].push_back(run(*all[row], work, thread_counts[column]));
        const std::uint64_t sum = all[row]->checksum();
        expected = expected == 0 ? sum : expected;
        if (sum != 0 && sum != expected) {
          fmt::print(stderr, "{}: {} holds something else than the others\n", title, all[row]->name());
          return false;
        }
      }
    }
  }
  fmt::print("\n{}\n\n| millions of inserts a second |", title);
  for (const std::uint32_t threads : thread_counts) {
    fmt::print(" {} thread{} | against the first |", threads, threads > 1 ? "s" : "");
  }
  fmt::print("\n| --- |");
  for (std::size_t column = 0; column < thread_counts.size(); ++column) {
    fmt::print(" ---: | ---: |");
  }
  for (std::size_t row = 0; row < all.size(); ++row) {
    fmt::print("\n| {} |", all[row]->name());
    for (std::size_t column = 0; column < thread_counts.size(); ++column) {
      const double took = median(times[row][column]);
      const double rate = static_cast<double>(work.offers.size()) * 1e-6 / took;
      fmt::print(" {:.2f} | {:.2f} |", rate, median(times[0][column]) / took);
      measured.add(title, fmt::format("{}, {} thread(s)", all[row]->name(), thread_counts[column]), rate);
    }
  }
  fmt::print("\n");
  std::fflush(stdout);
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Races the concurrent structures against libcds and locks.");
  int rounds = 9;
  std::uint32_t inserts = 1u << 18u;
  std::vector<std::uint32_t> threads = {1u, 2u};
  std::string json;
  app.add_option("--rounds", rounds, "rounds; medians over them")->check(CLI::Range(1, 1000))->capture_default_str();
  app.add_option("--inserts", inserts, "fragments a run")
      ->check(CLI::Range(1u << 10u, 1u << 24u))
      ->capture_default_str();
  app.add_option("--threads", threads, "numbers of threads")->check(CLI::Range(1u, 64u))->capture_default_str();
  app.add_option("--json", json, "a file for the numbers");
  CLI11_PARSE(app, argc, argv);

  bool right = true;
  results measured("millions of inserts a second");
  for (const std::uint32_t length : {8u, 32u, 128u}) {
    auto all = list_contenders();
    for (auto& one : libcds_contenders()) {
      all.push_back(std::move(one));
    }
    const workload work = make_workload(inserts / length, length);
    right = race(fmt::format("Lists of {}", length), std::move(all), work, rounds, threads, measured) && right;
  }
  for (const std::uint32_t k : {8u, 16u, 32u}) {
    for (const std::uint32_t times : {1u, 4u}) {
      const workload work = make_workload(inserts / (k * times), k * times);
      right = race(fmt::format("K = {}, {} fragments a pixel", k, k * times), slot_contenders(k), work, rounds, threads,
                   measured) &&
              right;
    }
  }
  try {
    if (!json.empty()) measured.write(json);
  } catch (const std::exception& error) {
    fmt::print(stderr, "pelage-concurrent: {}\n", error.what());
    return 2;
  }
  return right ? 0 : 1;
}
