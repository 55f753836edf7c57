// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT

// Compares the scattering models with a table of reference values:
//
//     check_reference --model chiang|marschner --csv FILE --tolerance REL [--precision double|float|both]
//
// Prints, for each precision, the largest and the 99th-percentile relative error and the row of the largest. Exits
// with 1 if double is above the tolerance anywhere, or float above the greater of it and 2e-5 on a value above 1e-6;
// with 2 if the arguments or the file are wrong.
#include <pelage/bsdf/chiang_sampling.hpp>
#include <pelage/bsdf/marschner.hpp>
#include <bsdf/csv_file.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <numbers>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace {

using namespace pelage;
using test::csv_file;

/// One number against its reference.
struct comparison {
  std::size_t row;  // from 1, the header not counted
  std::string column;
  double expected;
  double found;
  double error;
};

/// Relative error; below the floor, and where the reference is 0, what matters is that the value is small as well.
double error_of(double expected, double found, double floor) {
  if (!std::isfinite(found)) {
    return HUGE_VAL;
  }
  if (std::abs(expected) <= floor) {
    return std::abs(found) <= 1.001 * floor ? 0.0 : std::abs(found - expected) / floor;
  }
  return std::abs(found - expected) / std::abs(expected);
}

template <class Real>
constexpr double floor_of() {
  return std::is_same_v<Real, float> ? 1e-6 : 1e-280;
}

template <class Real>
Real cell(const csv_file& file, std::size_t row, const char* column) {
  return static_cast<Real>(file.at(row, column));
}

void compare(std::vector<comparison>& all, const csv_file& file, std::size_t row, const char* column, double found,
             double floor) {
  const double expected = file.at(row, column);
  all.push_back({row + 1, column, expected, found, error_of(expected, found, floor)});
}

template <class Real>
std::vector<comparison> compare_chiang(const csv_file& file) {
  std::vector<comparison> all;
  for (std::size_t row = 0; row < file.size(); ++row) {
    // Inputs are float values printed with nine digits.
    const auto input = [&](const char* column) { return static_cast<Real>(cell<float>(file, row, column)); };
    const chiang_parameters<Real> parameters = {input("eta"),
                                                {input("sigma_a0"), input("sigma_a1"), input("sigma_a2")},
                                                input("beta_m"),
                                                input("beta_n"),
                                                input("alpha_deg") * std::numbers::pi_v<Real> / 180};
    const glm::vec<3, Real> eye(input("wo_x"), input("wo_y"), input("wo_z"));
    const glm::vec<3, Real> light(input("wi_x"), input("wi_y"), input("wi_z"));
    const auto bsdf = evaluate_chiang_bsdf(make_chiang_fibre(parameters), input("h"), eye, light);
    compare(all, file, row, "f0", static_cast<double>(bsdf.f.x), floor_of<Real>());
    compare(all, file, row, "f1", static_cast<double>(bsdf.f.y), floor_of<Real>());
    compare(all, file, row, "f2", static_cast<double>(bsdf.f.z), floor_of<Real>());
    compare(all, file, row, "pdf", static_cast<double>(bsdf.density), floor_of<Real>());
  }
  return all;
}

/// The columns of a row of Marschner's model, computed in Real from inputs that `Input` can hold.
template <class Real, class Input>
std::array<Real, 7> marschner_columns(const csv_file& file, std::size_t row) {
  const auto input = [&](const char* column) { return static_cast<Real>(cell<Input>(file, row, column)); };
  marschner_parameters<Real> parameters = {};
  parameters.eta = input("eta");
  parameters.sigma_a.fill(input("sigma_a"));
  parameters.alpha = input("alpha_R");
  parameters.beta = input("beta_R");
  parameters.eccentricity = 1;
  parameters.caustic.smoothed = false;
  const auto result = evaluate_marschner(parameters, input("theta_i"), input("theta_r"), input("phi"), Real(0));
  return {result.longitudinal[0], result.longitudinal[1], result.longitudinal[2], result.azimuthal[0][0],
          result.azimuthal[1][0], result.azimuthal[2][0], result.scattering[0]};
}

/// Rows whose flag says that they lie by the caustic hold no values. Inputs are doubles; what rounding them to float
/// changes, by the double model, is not held against the float one: near the fibre's edge that alone reaches 2e-5.
template <class Real>
std::vector<comparison> compare_marschner(const csv_file& file) {
  const std::array<const char*, 7> names = {"M_R", "M_TT", "M_TRT", "N_R", "N_TT", "N_TRT", "S"};
  std::vector<comparison> all;
  for (std::size_t row = 0; row < file.size(); ++row) {
    if (file.at(row, "caustic_flag") != 0.0) {
      continue;
    }
    const std::array<Real, 7> found = marschner_columns<Real, Real>(file, row);
    const std::array<double, 7> rounded = marschner_columns<double, Real>(file, row);
    const std::array<double, 7> exact = marschner_columns<double, double>(file, row);
    for (std::size_t k = 0; k < names.size(); ++k) {
      compare(all, file, row, names[k], static_cast<double>(found[k]) - (rounded[k] - exact[k]), floor_of<Real>());
    }
  }
  return all;
}

/// Prints what was found and tells whether it is within the tolerance.
bool report(const char* precision, std::vector<comparison> all, double tolerance) {
  if (all.empty()) {
    std::printf("%s: no rows to compare\n", precision);
    return false;
  }
  const auto by_error = [](const comparison& a, const comparison& b) { return a.error < b.error; };
  std::sort(all.begin(), all.end(), by_error);
  const comparison& worst = all.back();
  const std::size_t rank = (all.size() * 99 + 99) / 100 - 1;  // the least value that 99 % do not exceed
  const bool good = worst.error <= tolerance;
  std::printf("%s: %zu values, largest error %.3g, 99th percentile %.3g, tolerance %.3g: %s\n", precision, all.size(),
              worst.error, all[rank].error, tolerance, good ? "ok" : "FAILED");
  std::printf("  largest in row %zu, %s: expected %.17g, found %.17g\n", worst.row, worst.column.c_str(),
              worst.expected, worst.found);
  return good;
}

struct arguments {
  std::string model, csv, precision = "both";
  double tolerance = -1.0;
};

std::optional<arguments> parse(int count, char** words) {
  arguments found;
  for (int k = 1; k < count; ++k) {
    std::string name = words[k];
    std::string value;
    const std::size_t equals = name.find('=');
    if (equals != std::string::npos) {
      value = name.substr(equals + 1);
      name.resize(equals);
    } else if (k + 1 < count) {
      value = words[++k];
    }
    if (name == "--model") {
      found.model = value;
    } else if (name == "--csv") {
      found.csv = value;
    } else if (name == "--precision") {
      found.precision = value;
    } else if (name == "--tolerance") {
      char* end = nullptr;
      found.tolerance = std::strtod(value.c_str(), &end);
      if (value.empty() || *end != '\0') {
        return std::nullopt;
      }
    } else {
      return std::nullopt;
    }
  }
  const bool model = found.model == "chiang" || found.model == "marschner";
  const bool precision = found.precision == "double" || found.precision == "float" || found.precision == "both";
  if (!model || !precision || found.csv.empty() || !(found.tolerance >= 0.0)) {
    return std::nullopt;
  }
  return found;
}

}  // namespace

int main(int count, char** words) {
  const std::optional<arguments> asked = parse(count, words);
  if (!asked) {
    std::fputs(
        "usage: check_reference --model chiang|marschner --csv FILE --tolerance REL"
        " [--precision double|float|both]\n",
        stderr);
    return 2;
  }
  try {
    const csv_file file(asked->csv);
    const bool chiang = asked->model == "chiang";
    bool good = true;
    if (asked->precision != "float") {
      good =
          report("double", chiang ? compare_chiang<double>(file) : compare_marschner<double>(file), asked->tolerance) &&
          good;
    }
    if (asked->precision != "double") {
      const double tolerance = asked->precision == "both" ? std::max(asked->tolerance, 2e-5) : asked->tolerance;
      good = report("float", chiang ? compare_chiang<float>(file) : compare_marschner<float>(file), tolerance) && good;
    }
    return good ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "check_reference: %s\n", error.what());
    return 2;
  }
}
