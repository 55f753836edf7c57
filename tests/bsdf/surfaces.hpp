// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>

#include "sweep.hpp"

namespace pelage::test {

/// What a smooth dielectric surface reflects and lets through.
struct shares_by_angles {
  double reflected, transmitted;
};

/// Fresnel's equations by angles: Snell's law, then sin² (i - t) / sin² (i + t) and tan² (i - t) / tan² (i + t), and
/// sin 2i sin 2t over sin² (i + t) and over that times cos² (i - t).
inline shares_by_angles fresnel_by_angles(double cosine, double eta) {
  const long double c = cosine;
  const long double sine = std::sqrt((1.0L - c) * (1.0L + c));
  if (sine >= eta || cosine == 0.0) return {1.0, 0.0};
  if (sine == 0.0L) return {std::pow((eta - 1.0) / (eta + 1.0), 2.0), 4.0 * eta / ((eta + 1.0) * (eta + 1.0))};
  const long double i = std::atan2(sine, c);
  const long double t = std::asin(sine / eta);
  const long double perpendicular = std::sin(i - t) / std::sin(i + t);
  const long double parallel = std::tan(i - t) / std::tan(i + t);
  const long double through = std::sin(2.0L * i) * std::sin(2.0L * t) / (std::sin(i + t) * std::sin(i + t));
  const long double both = through + through / (std::cos(i - t) * std::cos(i - t));
  return {static_cast<double>(0.5L * (perpendicular * perpendicular + parallel * parallel)),
          static_cast<double>(0.5L * both)};
}

/// The same by the cosines of both sides, for grazing light, whose angle has lost its cosine.
inline shares_by_angles fresnel_by_cosines(long double cosine, long double eta) {
  const long double inside = std::sqrt(std::max(0.0L, (eta - 1) * (eta + 1) + cosine * cosine)) / eta;
  const long double a = cosine + eta * inside;
  const long double b = eta * cosine + inside;
  const long double perpendicular = (cosine - eta * inside) / a;
  const long double parallel = (eta * cosine - inside) / b;
  return {static_cast<double>(0.5L * (perpendicular * perpendicular + parallel * parallel)),
          static_cast<double>(2 * cosine * eta * inside * (1 / (a * a) + 1 / (b * b)))};
}

/// Calls see(cos_theta, eta): cosines even over [0, 1], then crowded at 0 and at 1; indices crowded at 1.
template <class See>
void for_each_surface(double least_eta, double most_eta, See see) {
  for (int i = 0; i < 100'000; ++i) {
    const auto [u, v] = even_point<2>(i);
    const double crowded = on_log_scale(u, 1e-9, 1.0);
    for (const double cosine : {u, crowded, 1.0 - crowded}) {
      const double towards_one = std::pow(i % 2 == 0 ? least_eta : most_eta, on_log_scale(v, 1e-6, 1.0));
      see(static_cast<float>(cosine), static_cast<float>(towards_one));
    }
  }
}

}  // namespace pelage::test
