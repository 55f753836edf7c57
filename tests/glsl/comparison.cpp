// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "glsl/comparison.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace pelage::test {

namespace {

constexpr float smallest_normal = std::numeric_limits<float>::min();

/// The largest differences seen, printed at the end of the program where PELAGE_TABLE is set.
struct table {
  struct line {
    std::string function;
    bool whole_numbers;
    double ulps = 0.0;
    std::size_t rows = 0;
  };
  std::vector<line> lines;

  line& of(const column& c) {
    for (line& l : lines) {
      if (l.function == c.function) return l;
    }
    lines.push_back({c.function, c.cpu_ulps < 0.0});
    return lines.back();
  }

  ~table() {
    if (std::getenv("PELAGE_TABLE") == nullptr || lines.empty()) return;
    std::printf("| function | largest difference on %s |\n| --- | --- |\n", the_device()->name().c_str());
    for (const line& l : lines) {
      if (l.function.empty() || l.function.find(", wrong") != std::string::npos) continue;
      if (l.whole_numbers || l.ulps == 0.0) {
        std::printf("| `%s` | none |\n", l.function.c_str());
      } else {
        std::printf("| `%s` | %.3g ulp |\n", l.function.c_str(), l.ulps);
      }
    }
  }
};

table& the_table() {
  static table t;
  return t;
}

double ulp(float x) {
  const float a = std::max(std::abs(x), smallest_normal);
  return std::ldexp(1.0, std::ilogb(a) - 23);
}

/// How far a result is off, in ulps of `size`; infinite where one is NaN or infinite and the other is not.
double distance(float expected, float got, float size) {
  if (std::isnan(expected) || std::isnan(got)) {
    return std::isnan(expected) == std::isnan(got) ? 0.0 : std::numeric_limits<double>::infinity();
  }
  if (expected == got) return 0.0;
  if (std::isinf(expected) || std::isinf(got)) return std::numeric_limits<double>::infinity();
  if (std::abs(expected) <= smallest_normal && std::abs(got) <= smallest_normal) return 0.0;
  return std::abs(static_cast<double>(expected) - static_cast<double>(got)) / ulp(size);
}

/// The difference of one column in one row, and whether it is within its bound.
bool within(const column& c, const std::uint32_t* expected, const std::uint32_t* got, bool cpu, double& worst) {
  const double bound = cpu ? c.cpu_ulps : c.gpu_ulps;
  if (bound < 0.0) return std::equal(expected, expected + c.words, got);
  float size = c.scale;
  for (std::size_t i = 0; i < c.words; ++i) {
    const float part = std::abs(std::bit_cast<float>(expected[i]));
    if (std::isfinite(part)) size = std::max(size, part);
  }
  for (std::size_t i = 0; i < c.words; ++i) {
    worst = std::max(worst, distance(std::bit_cast<float>(expected[i]), std::bit_cast<float>(got[i]), size));
  }
  return worst <= bound;
}

}  // namespace

float row::f(std::size_t i) const {
  return std::bit_cast<float>(words[i]);
}

void results::put(float value) {
  words_.push_back(std::bit_cast<std::uint32_t>(value));
}
void results::put(const glm::vec3& v) {
  put(v.x);
  put(v.y);
  put(v.z);
}
void results::put(const glm::vec4& v) {
  put(glm::vec3(v));
  put(v.w);
}

run_rows run_over(const kernel& k, std::vector<std::uint32_t> given, std::size_t stride, std::size_t width) {
  run_rows run{given.size() / stride, stride, width, std::move(given), {}};
  run.got.resize(run.rows * width);
  std::vector<std::uint32_t>* const buffers[] = {&run.given, &run.got};
  the_device()->run(k, static_cast<std::uint32_t>(run.rows), buffers);
  return run;
}

run_rows run_over(const kernel& k, const std::vector<rc::Gen<std::uint32_t>>& inputs, std::size_t width) {
  const std::size_t stride = inputs.size();
  const auto rows = static_cast<std::size_t>(*rc::gen::inRange(1, 513));
  std::vector<std::uint32_t> given(rows * stride);
  for (std::size_t i = 0; i < stride; ++i) {
    const auto values = *rc::gen::container<std::vector<std::uint32_t>>(rows, inputs[i]);
    for (std::size_t r = 0; r < rows; ++r)
      given[r * stride + i] = values[r];
  }
  return run_over(k, std::move(given), stride, width);
}

std::string as_text(row inputs) {
  std::string text;
  for (std::size_t i = 0; i < inputs.words.size(); ++i) {
    char number[48];
    std::snprintf(number, sizeof number, " %.9g", static_cast<double>(inputs.f(i)));
    text += number;
  }
  return text;
}

void compare(const kernel& k, const std::vector<rc::Gen<std::uint32_t>>& inputs,
             const std::function<void(row, results&)>& reference, const std::vector<column>& columns) {
  const device& gpu = *the_device();
  std::size_t width = 0;
  for (const column& c : columns)
    width += c.words;
  const run_rows run = run_over(k, inputs, width);
  for (std::size_t r = 0; r < run.rows; ++r) {
    results expected;
    reference(run.inputs(r), expected);
    RC_ASSERT(expected.words().size() == width);
    std::size_t at = 0;
    for (const column& c : columns) {
      double worst = 0.0;
      const std::uint32_t* got = run.results(r).words.data() + at;
      const bool close = within(c, expected.words().data() + at, got, gpu.is_cpu(), worst);
      table::line& line = the_table().of(c);
      line.ulps = std::max(line.ulps, worst);
      ++line.rows;
      if (!close) {
        std::string message = std::string(k.name) + ", " + c.function + " on " + gpu.name() + ", off by " +
                              std::to_string(worst) + " ulp: expected";
        for (std::size_t i = 0; i < c.words; ++i) {
          char text[96];
          const std::uint32_t e = expected.words()[at + i];
          const std::uint32_t g = got[i];
          std::snprintf(text, sizeof text, " %08x (%.9g) got %08x (%.9g)", e,
                        static_cast<double>(std::bit_cast<float>(e)), g, static_cast<double>(std::bit_cast<float>(g)));
          message += text;
        }
        RC_FAIL(message + ", given" + as_text(run.inputs(r)));
      }
      at += c.words;
    }
  }
}

namespace {

std::uint32_t word(float x) {
  return std::bit_cast<std::uint32_t>(x);
}

}  // namespace

rc::Gen<std::uint32_t> any_word() {
  return rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint32_t>());
}

rc::Gen<std::uint32_t> few_words() {
  return rc::gen::inRange<std::uint32_t>(0U, 8U);
}

rc::Gen<std::uint32_t> between(float low, float high) {
  return rc::gen::map(any_word(), [low, high](std::uint32_t w) {
    const double t = static_cast<double>(w) / 4294967295.0;
    return word(
        static_cast<float>(static_cast<double>(low) + t * (static_cast<double>(high) - static_cast<double>(low))));
  });
}

rc::Gen<std::uint32_t> magnitude(int low, int high) {
  return rc::gen::map(any_word(), [low, high](std::uint32_t w) {
    const double t = static_cast<double>(w) / 4294967295.0;
    return word(static_cast<float>(std::exp2(low + t * (high - low))));
  });
}

rc::Gen<std::uint32_t> any_float() {
  constexpr float inf = std::numeric_limits<float>::infinity();
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  return rc::gen::weightedOneOf<std::uint32_t>(
      {{2, rc::gen::element(word(0.0F), word(-0.0F), word(1.0F), word(-1.0F), word(inf), word(-inf), word(nan),
                            word(smallest_normal), word(std::numeric_limits<float>::max()))},
       {2, any_word()},
       {2, between(-2.0F, 2.0F)},
       {2, magnitude(-20, 20)}});
}

rc::Gen<std::uint32_t> any_normal_float() {
  return rc::gen::map(any_float(), [](std::uint32_t w) { return (w & 0x7f800000U) == 0U ? w & 0x80000000U : w; });
}

}  // namespace pelage::test
